/* Results of theory as text: for readers, and for programs. */
#include <math.h>
#include <string.h>

#include "theory/theory.h"

enum { WIDTH = 16 };

static void params_print_common(const struct theory_result *r, FILE *out) {
  const char *before = "  ";
  for (size_t p = 0; p < r->topic->n_params; p++) {
    char text[64];
    if (!theory_param_is_common(r, p)) continue;
    theory_param_text(&r->curve[0], p, text, sizeof text);
    fprintf(out, "%s%s = %s", before, r->topic->params[p].key, text);
    before = ", ";
  }
  fputs("\n", out);
}

static void values_print(const struct theory_curve *c, FILE *out) {
  const struct theory_topic *t = c->topic;
  int width = 0;
  for (size_t k = 0; k < t->n_values; k++)
    if ((int)strlen(t->values[k].key) > width) width = (int)strlen(t->values[k].key);
  for (size_t k = 0; k < t->n_values; k++) {
    const struct theory_value *v = &t->values[k];
    if (isnan(c->value[k])) continue;
    fprintf(out, "  %-*s  %-18.12g  ", width, v->key, c->value[k]);
    fprintf(out, "%s%s%s\n", v->help, strcmp(v->unit, "1") ? ", " : "",
            strcmp(v->unit, "1") ? v->unit : "");
  }
}

static void head_print(const struct theory_topic *t, FILE *out) {
  for (size_t k = 0; k < t->n_columns; k++) fprintf(out, "  %*s", WIDTH, t->columns[k].key);
  fputc('\n', out);
  for (size_t k = 0; k < t->n_columns; k++) fprintf(out, "  %*s", WIDTH, t->columns[k].unit);
  fputc('\n', out);
}

static void rows_print(const struct theory_curve *c, FILE *out) {
  size_t columns = c->topic->n_columns;
  for (size_t i = 0; i < c->n; i++) {
    for (size_t k = 0; k < columns; k++) {
      double value = c->row[i * columns + k];
      if (isnan(value))
        fprintf(out, "  %*s", WIDTH, "-");
      else
        fprintf(out, "  %*.10g", WIDTH, value);
    }
    fputc('\n', out);
  }
}

void theory_write_table(const struct theory_result *r, FILE *out) {
  fprintf(out, "%s: %s\n", r->topic->name, r->topic->help);
  params_print_common(r, out);
  for (size_t i = 0; i < r->n; i++) {
    fputc('\n', out);
    if (*r->curve[i].name) fprintf(out, "%s\n", r->curve[i].name);
    values_print(&r->curve[i], out);
    if (!r->curve[i].n) continue;
    head_print(r->topic, out);
    rows_print(&r->curve[i], out);
  }
}

/* Names hold letters, digits and ", = .": nothing to escape within quotes. */
void theory_write_csv(const struct theory_result *r, FILE *out) {
  size_t columns = r->topic->n_columns;
  fputs("curve,name", out);
  for (size_t k = 0; k < columns; k++)
    fprintf(out, ",%s [%s]", r->topic->columns[k].key, r->topic->columns[k].unit);
  fputc('\n', out);
  for (size_t i = 0; i < r->n; i++)
    for (size_t j = 0; j < r->curve[i].n; j++) {
      fprintf(out, "%zu,\"%s\"", i, r->curve[i].name);
      for (size_t k = 0; k < columns; k++) {
        double value = r->curve[i].row[j * columns + k];
        if (isnan(value))
          fputs(",NaN", out);
        else
          fprintf(out, ",%.15g", value);
      }
      fputc('\n', out);
    }
}

/* Rows of text and numbers. */
#include "gallery/figures/table.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/json_maker.h"
#include "compare/text.h"
#include "gallery/desk.h"
#include "gallery/drawer.h"
#include "gallery/figures/keys.h"

/* "%+.3f H": what stands before and behind the number, which has a sign, digits, and e, f or g. */
struct format {
  char before[64], after[64];
  bool sign;
  int digits;
  char type;
};

struct cell {
  char *text;    /* as it is written; NULL: nothing */
  char *formula; /* NULL: the text is shown */
  struct format format;
};

struct row {
  size_t n;
  struct cell *cell;
};

struct table_spec {
  int head, rows; /* nodes */
  size_t n_head, n;
  char **heading;
  struct row *row;
};

/* ---- reading ---- */

enum { LONG = 4000 };

static const struct param rows[] = {
    NODE(struct table_spec, head, NULL, "a list of headings"),
    NODE(struct table_spec, rows, NULL, "a list of rows, each a list of cells"),
};
static const struct param cell_row = {
    .key = "cell", .type = PARAM_TEXT, .max = LONG, .help = "text, or = and a formula"};

static bool format_read(const char *text, struct format *f) {
  const char *at = strchr(text, '%'), *end;
  if (!at || (size_t)(at - text) >= sizeof f->before) return false;
  snprintf(f->before, sizeof f->before, "%.*s", (int)(at - text), text);
  f->sign = *++at == '+';
  at += f->sign;
  f->digits = 6;
  if (*at == '.') {
    const long digits = strtol(at + 1, (char **)&end, 10);
    if (end == at + 1 || !isdigit((unsigned char)at[1]) || digits > 17) return false;
    f->digits = (int)digits;
    at = end;
  }
  if (!*at || !strchr("efg", *at)) return false;
  f->type = *at++;
  if (strchr(at, '%') || strlen(at) >= sizeof f->after) return false;
  snprintf(f->after, sizeof f->after, "%s", at);
  return true;
}

static char *trimmed(const char *text, size_t n) {
  while (n && isspace((unsigned char)*text)) text++, n--;
  while (n && isspace((unsigned char)text[n - 1])) n--;
  return strndup(text, n);
}

/* "=FORMULA | FORMAT", in which a formula may have || as well. */
static enum status formula_read(struct gallery_reader *r, int node, const char *path,
                                struct cell *c) {
  const char *text = c->text + 1, *bar = strrchr(text, '|');
  if (bar && !strchr(bar, '%')) bar = NULL;
  c->format = (struct format){.digits = 6, .type = 'g'};
  if (bar) {
    char *format = trimmed(bar + 1, strlen(bar + 1));
    CHECK(format, ERR_MEMORY, "no memory for a table");
    if (!format_read(format, &c->format))
      gallery_complain(r, node, path, bar, "a format as in '%.4f', '%+.2e' or '%.3g H'", "");
    free(format);
  }
  c->formula = trimmed(text, bar ? (size_t)(bar - text) : strlen(text));
  CHECK(c->formula, ERR_MEMORY, "no memory for a table");
  gallery_check_formula(r, node, path, c->formula, false);
  return OK;
}

static enum status row_read(struct gallery_reader *r, int node, const char *path, size_t width,
                            struct row *row) {
  if (!case_doc_expect_list(&r->doc, node, path, width, width, "cells")) return OK;
  TRY(array_create(&row->cell, width, "a table"));
  row->n = width;
  for (size_t k = 0; k < width; k++) {
    char full[CASE_PATH + 32];
    struct cell *c = &row->cell[k];
    const int item = case_doc_item(&r->doc, node, k);
    const char *text = case_doc_text(&r->doc, item);
    snprintf(full, sizeof full, "%s[%zu]", path, k);
    if (text && !*text) continue; /* an empty cell */
    if (case_doc_value(&r->doc, item, full, &cell_row, &c->text) && c->text[0] == '=')
      TRY(formula_read(r, item, full, c));
  }
  return OK;
}

static enum status lists_read(struct gallery_reader *r, const char *path, struct table_spec *s) {
  char full[CASE_PATH + 8];
  snprintf(full, sizeof full, "%s.head", path);
  TRY(gallery_read_texts(r, s->head, full, "headings", &s->n_head, &s->heading));
  if (!s->n_head) gallery_complain(r, s->head, full, "no heading", "a list of headings", "");
  const struct gallery_list list = gallery_list_of(r, s->rows, path, "rows", 1);
  TRY(array_create(&s->row, list.n, "a table"));
  s->n = list.n;
  for (size_t i = 0; i < list.n; i++) {
    char item_path[CASE_PATH];
    const int item = gallery_list_item(r, &list, i, item_path);
    TRY(row_read(r, item, item_path, s->n_head, &s->row[i]));
  }
  return OK;
}

static void destroy(void *spec) {
  struct table_spec *s = spec;
  if (!s) return;
  for (size_t i = 0; i < s->n; i++) {
    for (size_t k = 0; k < s->row[i].n; k++) {
      free(s->row[i].cell[k].text);
      free(s->row[i].cell[k].formula);
    }
    free(s->row[i].cell);
  }
  gallery_texts_free(s->n_head, s->heading);
  free(s->row);
  free(s);
}

static enum status read(struct gallery_reader *r, int node, const char *path, void **spec) {
  struct table_spec *s = calloc(1, sizeof *s);
  const size_t faults = r->doc.faults;
  enum status status = OK;
  *spec = NULL;
  CHECK(s, ERR_MEMORY, "no memory for a table");
  if (gallery_figure_read(r, node, path, rows, ROWS(rows), s)) status = lists_read(r, path, s);
  if (status == OK && r->doc.faults == faults)
    *spec = s;
  else
    destroy(s);
  return status;
}

/* ---- writing ---- */

static void number_write(const struct format *f, double value, char *out, size_t room) {
  char number[64];
  if (!isfinite(value)) {
    snprintf(out, room, isnan(value) ? "–" : value > 0 ? "∞" : "−∞");
    return;
  }
  const char *sign = f->sign && !signbit(value) ? "+" : "";
  if (f->type == 'e')
    snprintf(number, sizeof number, "%.*e", f->digits, value);
  else if (f->type == 'f' && fabs(value) < 1e15)
    snprintf(number, sizeof number, "%.*f", f->digits, value);
  else
    snprintf(number, sizeof number, "%.*g", f->digits, value);
  snprintf(out, room, "%s%s%s%s", f->before, sign, number, f->after);
}

static enum status cell_make(struct gallery_desk *desk, const struct cell *c, json_t **out) {
  char text[256];
  double value;
  if (c->formula) {
    TRY(gallery_desk_formula(desk, c->formula, &value));
    number_write(&c->format, value, text, sizeof text);
  }
  *out = cmp_json_text(c->formula ? text : c->text ? c->text : "");
  return OK;
}

static enum status table_fill(struct gallery_desk *desk, const struct table_spec *s,
                              struct cmp_json_maker *m, json_t *table) {
  json_t *head = json_array(), *body = json_array();
  cmp_json_set(m, table, "head", head);
  cmp_json_set(m, table, "rows", body);
  for (size_t k = 0; k < s->n_head; k++) cmp_json_add(m, head, cmp_json_text(s->heading[k]));
  for (size_t i = 0; i < s->n; i++) {
    json_t *row = json_array(), *cell;
    cmp_json_add(m, body, row);
    for (size_t k = 0; k < s->row[i].n; k++) {
      TRY(cell_make(desk, &s->row[i].cell[k], &cell));
      cmp_json_add(m, row, cell);
    }
  }
  return OK;
}

enum status gallery_table_json(struct gallery_desk *desk, const void *spec, json_t **table) {
  struct cmp_json_maker m = {true};
  *table = json_object();
  enum status status = table_fill(desk, spec, &m, *table);
  if (status == OK && !m.ok) status = status_raise(ERR_MEMORY, "no memory for a table");
  if (status == OK) return OK;
  json_decref(*table);
  *table = NULL;
  return status;
}

static bool is_number(const char *text) {
  char *end;
  (void)strtod(text, &end);
  return end != text && !*end;
}

static void line_write(const json_t *cells, FILE *out) {
  for (size_t k = 0; k < json_array_size(cells); k++) {
    const char *text = json_string_value(json_array_get(cells, k));
    if (k) fputc(',', out);
    if (is_number(text))
      fputs(text, out);
    else
      cmp_csv_string(out, text);
  }
  fputc('\n', out);
}

void gallery_table_csv(const json_t *table, FILE *out) {
  const json_t *body = json_object_get(table, "rows");
  line_write(json_object_get(table, "head"), out);
  for (size_t i = 0; i < json_array_size(body); i++) line_write(json_array_get(body, i), out);
}

const struct gallery_drawer gallery_drawer_table = {
    .name = "table",
    .help = "rows of text and numbers",
    .read = read,
    .destroy = destroy,
};

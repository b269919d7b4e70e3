/* A column of a topic of plunge theory. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gallery/desk.h"
#include "gallery/sources/settings.h"

struct theory_source {
  char *topic, *set, *x, *y;
};

static const struct param params[] = {
    SOURCE_TEXT(theory_source, topic, NULL, "a topic of plunge theory"),
    SOURCE_TEXT(theory_source, set, "", "its parameters, as in delta=1 points=401; one value each"),
    SOURCE_TEXT(theory_source, x, "", "a column, the first by default"),
    SOURCE_TEXT(theory_source, y, NULL, "a column, or a single value, which makes one point at 0"),
};

/* n_columns: there is none. */
static size_t find_column(const struct theory_topic *t, const char *key) {
  size_t k = 0;
  while (k < t->n_columns && strcmp(t->columns[k].key, key) != 0) k++;
  return k;
}

static size_t find_value(const struct theory_topic *t, const char *key) {
  size_t i = 0;
  while (i < t->n_values && strcmp(t->values[i].key, key)) i++;
  return i;
}

static void check(struct gallery_reader *r, int node, const char *path, const void *params_of) {
  const struct theory_source *s = params_of;
  size_t curves = 0, n = 0;
  const struct theory_topic *t = gallery_theory_check(r, node, path, s->topic, s->set, &curves);
  if (!t) return;
  const char *names[t->n_columns + t->n_values + 1];
  if (curves != 1) {
    char full[CASE_PATH + 8], found[64];
    snprintf(full, sizeof full, "%s.set", path);
    snprintf(found, sizeof found, "settings for %zu curves", curves);
    gallery_complain(r, case_doc_member(&r->doc, node, "set"), full, found,
                     "one value of each parameter", "");
  }
  for (size_t k = 0; k < t->n_columns; k++) names[n++] = t->columns[k].key;
  if (s->x && find_column(t, s->x) == t->n_columns)
    gallery_complain_of_word(r, node, path, "x", n, names);
  for (size_t k = 0; k < t->n_values; k++) names[n++] = t->values[k].key;
  if (s->y && find_column(t, s->y) == t->n_columns && find_value(t, s->y) == t->n_values)
    gallery_complain_of_word(r, node, path, "y", n, names);
}

static enum status take(const struct theory_source *s, const struct theory_result *r,
                        struct gallery_curve *curve) {
  const struct theory_topic *t = r->topic;
  const struct theory_curve *c = &r->curve[0];
  const size_t x = s->x ? find_column(t, s->x) : 0, y = find_column(t, s->y);
  const size_t v = find_value(t, s->y);
  if (v < t->n_values) return gallery_curve_add(curve, 0, c->value[v]);
  for (size_t i = 0; i < c->n; i++)
    TRY(gallery_curve_add(curve, c->row[i * t->n_columns + x], c->row[i * t->n_columns + y]));
  return OK;
}

static enum status evaluate(struct gallery_desk *desk, const void *with,
                            struct gallery_curve *curve) {
  const struct theory_source *s = with;
  const struct theory_result *result;
  TRY(gallery_desk_theory(desk, s->topic, s->set, &result));
  return take(s, result, curve);
}

const struct gallery_source gallery_source_theory = {
    .name = "theory",
    .help = "a column of a topic of plunge theory over another, in the units that it says",
    SOURCE_TABLE,
    .params_size = sizeof(struct theory_source),
    .check = check,
    .evaluate = evaluate,
};

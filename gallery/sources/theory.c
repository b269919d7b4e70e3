/* A column of a topic of plunge theory. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gallery/sources/settings.h"
#include "gallery/source.h"

struct theory_source {
  char *topic, *set, *x, *y;
};

static const struct param params[] = {
    SOURCE_TEXT(theory_source, topic, NULL, "a topic of plunge theory"),
    SOURCE_TEXT(theory_source, set, "", "its parameters, as in delta=1 points=401; one value each"),
    SOURCE_TEXT(theory_source, x, "", "a column, the first by default"),
    SOURCE_TEXT(theory_source, y, NULL, "a column, or a single value, which makes one point at 0"),
};

static enum status find_column(const struct theory_topic *t, const char *key, size_t *k) {
  const char *names[64];
  size_t n = 0;
  for (*k = 0; *k < t->n_columns; (*k)++) {
    if (!strcmp(t->columns[*k].key, key)) return OK;
    if (n < 64) names[n++] = t->columns[*k].key;
  }
  for (size_t i = 0; i < t->n_values && n < 64; i++) names[n++] = t->values[i].key;
  const char *near = param_nearest(key, n, names);
  return status_raise(ERR_INPUT, "topic %s has no column '%s'%s%s%s", t->name, key,
                      near ? "; did you mean '" : "", near ? near : "", near ? "'?" : "");
}

static size_t find_value(const struct theory_topic *t, const char *key) {
  size_t i = 0;
  while (i < t->n_values && strcmp(t->values[i].key, key)) i++;
  return i;
}

static enum status take(const struct theory_source *s, const struct theory_result *r,
                        struct gallery_curve *curve) {
  const struct theory_topic *t = r->topic;
  const struct theory_curve *c = &r->curve[0];
  size_t x = 0, y;
  CHECK(r->n == 1, ERR_INPUT, "%zu curves of topic %s; allowed: one value of each parameter", r->n,
        t->name);
  const size_t v = find_value(t, s->y);
  if (v < t->n_values) return gallery_curve_add(curve, 0, c->value[v]);
  TRY(find_column(t, s->y, &y));
  if (s->x) TRY(find_column(t, s->x, &x));
  for (size_t i = 0; i < c->n; i++)
    TRY(gallery_curve_add(curve, c->row[i * t->n_columns + x], c->row[i * t->n_columns + y]));
  return OK;
}

static enum status evaluate(struct gallery_desk *desk, const void *with,
                            struct gallery_curve *curve) {
  (void)desk;
  const struct theory_source *s = with;
  struct theory_result result = {0};
  TRY(gallery_theory(s->topic, s->set, &result));
  const enum status status = take(s, &result, curve);
  theory_result_destroy(&result);
  return status;
}

const struct gallery_source gallery_source_theory = {
    .name = "theory",
    .help = "a column of a topic of plunge theory over another, in the units that it says",
    SOURCE_TABLE,
    .params_size = sizeof(struct theory_source),
    .evaluate = evaluate,
};

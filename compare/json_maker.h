/* How report.json is put together. */
#pragma once
#include <jansson.h>
#include <stdlib.h>

#include "compare/text.h"
#include "compare/value.h"

/* jansson takes a NULL value as a failure and frees what it was given; one check at the end (a
 * failed member makes json_object_set_new fail, which `ok` remembers) is enough. */
struct maker {
  bool ok;
};

static inline void set(struct maker *m, json_t *object, const char *key, json_t *value) {
  if (json_object_set_new(object, key, value) != 0) m->ok = false;
}

static inline void add(struct maker *m, json_t *array, json_t *value) {
  if (json_array_append_new(array, value) != 0) m->ok = false;
}

static inline json_t *number(double value) {
  return isfinite(value) ? json_real(value) : json_null();
}

static inline json_t *text(const char *string) {
  char *copy = cmp_text_copy(string);
  json_t *value = copy ? json_string(copy) : NULL;
  free(copy);
  return value;
}

/* KEY: the number or null, and then KEY_unavailable: why. */
static inline void set_value(struct maker *m, json_t *object, const char *key,
                             const struct cmp_value *v) {
  char why[64];
  set(m, object, key, number(v->value));
  if (cmp_known(v)) return;
  snprintf(why, sizeof why, "%s_unavailable", key);
  set(m, object, why, text(v->why));
}

static inline json_t *point(struct maker *m, const double *p) {
  json_t *pair = json_array();
  add(m, pair, number(p[0]));
  add(m, pair, number(p[1]));
  return pair;
}

static inline json_t *numbers(struct maker *m, const double *v, size_t n) {
  json_t *array = json_array();
  for (size_t i = 0; i < n; i++) add(m, array, number(v[i]));
  return array;
}

/* A number under a name that the file gives. */
static inline void set_named(struct maker *m, json_t *object, const char *name, double value) {
  char *key = cmp_text_copy(name);
  if (key)
    set(m, object, key, number(value));
  else
    m->ok = false;
  free(key);
}

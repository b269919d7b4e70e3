#include "compare/json_maker.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "compare/text.h"

void cmp_json_set(struct cmp_json_maker *m, json_t *object, const char *key, json_t *value) {
  if (json_object_set_new(object, key, value) != 0) m->ok = false;
}

void cmp_json_add(struct cmp_json_maker *m, json_t *array, json_t *value) {
  if (json_array_append_new(array, value) != 0) m->ok = false;
}

json_t *cmp_json_number(double value) {
  return isfinite(value) ? json_real(value) : json_null();
}

json_t *cmp_json_text(const char *string) {
  char *copy = cmp_text_copy(string);
  json_t *value = copy ? json_string(copy) : NULL;
  free(copy);
  return value;
}

json_t *cmp_json_point(struct cmp_json_maker *m, const double *p) {
  return cmp_json_numbers(m, p, 2);
}

json_t *cmp_json_numbers(struct cmp_json_maker *m, const double *v, size_t n) {
  json_t *array = json_array();
  for (size_t i = 0; i < n; i++) cmp_json_add(m, array, cmp_json_number(v[i]));
  return array;
}

void cmp_json_set_value(struct cmp_json_maker *m, json_t *object, const char *key,
                        const struct cmp_value *v) {
  char why[64];
  cmp_json_set(m, object, key, cmp_json_number(v->value));
  if (cmp_known(v)) return;
  snprintf(why, sizeof why, "%s_unavailable", key);
  cmp_json_set(m, object, why, cmp_json_text(v->why));
}

void cmp_json_set_named(struct cmp_json_maker *m, json_t *object, const char *name, double value) {
  char *key = cmp_text_copy(name);
  if (key)
    cmp_json_set(m, object, key, cmp_json_number(value));
  else
    m->ok = false;
  free(key);
}

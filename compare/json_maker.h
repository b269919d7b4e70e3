/* How report.json is put together. */
#pragma once
#include <jansson.h>

#include "compare/value.h"

/* jansson takes a NULL value as a failure and frees what it was given; one check at the end (a
 * failed member makes json_object_set_new fail, which `ok` remembers) is enough. */
struct cmp_json_maker {
  bool ok;
};

/* All take `value` over. */
void cmp_json_set(struct cmp_json_maker *m, json_t *object, const char *key, json_t *value);
void cmp_json_add(struct cmp_json_maker *m, json_t *array, json_t *value);

/* New values, NULL where there is no memory: a number, null unless it is finite; text as it is
 * shown (compare/text.h); [x, y]; n numbers. */
json_t *cmp_json_number(double value);
json_t *cmp_json_text(const char *string);
json_t *cmp_json_point(struct cmp_json_maker *m, const double *p);
json_t *cmp_json_numbers(struct cmp_json_maker *m, const double *v, size_t n);

/* KEY: the number or null, and then KEY_unavailable: why. */
void cmp_json_set_value(struct cmp_json_maker *m, json_t *object, const char *key,
                        const struct cmp_value *v);
/* A number under a name that the file gives. */
void cmp_json_set_named(struct cmp_json_maker *m, json_t *object, const char *name, double value);

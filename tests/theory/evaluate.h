/* Results of theory in tests. */
#pragma once
#include <stdlib.h>

#include "tests/test.h"
#include "theory/theory.h"

/* Settings in turn, key and text, NULL at the end; what it returns is freed with
 * theory_result_destroy. */
__attribute__((unused)) static struct theory_result theory_of(const char *topic,
                                                              const char *const *setting) {
  struct theory_setting settings[16];
  struct theory_result r = {0};
  size_t n = 0;
  for (; setting[2 * n]; n++)
    settings[n] = (struct theory_setting){setting[2 * n], setting[2 * n + 1]};
  EXPECT_OK(theory_evaluate(theory_topic_find(topic), n, settings, &r));
  if (!r.n) exit(1); /* the message stands above */
  return r;
}
#define THEORY(topic, ...) theory_of(topic, (const char *const[]){__VA_ARGS__, NULL})

__attribute__((unused)) static double value_of(const struct theory_result *r, size_t curve,
                                               const char *key) {
  for (size_t k = 0; k < r->topic->n_values; k++)
    if (!strcmp(r->topic->values[k].key, key)) return r->curve[curve].value[k];
  TEST_FAIL("%s has no value %s", r->topic->name, key);
  return NAN;
}

__attribute__((unused)) static double cell_of(const struct theory_result *r, size_t curve,
                                              size_t row, const char *key) {
  size_t columns = r->topic->n_columns;
  for (size_t k = 0; k < columns; k++)
    if (!strcmp(r->topic->columns[k].key, key)) return r->curve[curve].row[row * columns + k];
  TEST_FAIL("%s has no column %s", r->topic->name, key);
  return NAN;
}

/* The points of one output of a result, kept, for tests. */
#pragma once
#include "common/result/result.h"

static enum status water_keep(void *data, size_t k, struct result_water *w) {
  (void)k;
  *(struct result_water *)data = *w;
  *w = (struct result_water){0};
  return OK;
}

/* With one scalar, or vector, in value[0]. `w` is the caller's to free; empty after a failure. */
static inline enum status water_read(const char *path, const char *field, bool vector,
                                     size_t output, struct result_water *w) {
  const struct result_wanted wanted = {field, vector, false};
  *w = (struct result_water){0};
  return result_stream(path, 1, &wanted, 1, &output, water_keep, w);
}

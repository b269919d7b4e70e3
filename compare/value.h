/* A number that may be unavailable, and then says why: never silently zero. */
#pragma once
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

struct cmp_value {
  double value;  /* NaN: not available */
  char why[112]; /* the reason then, else "" */
};

static inline bool cmp_known(const struct cmp_value *v) {
  return isfinite(v->value);
}

static inline struct cmp_value cmp_number(double value) {
  struct cmp_value v = {value, ""};
  if (!isfinite(value)) {
    v.value = NAN;
    snprintf(v.why, sizeof v.why, "it came out as %s", isnan(value) ? "not a number" : "infinite");
  }
  return v;
}

/* printf style: the reason, as the rest of "not available: ..." */
#define cmp_unknown(...)                                                                           \
  ({                                                                                               \
    struct cmp_value unknown_ = {NAN, ""};                                                         \
    snprintf(unknown_.why, sizeof unknown_.why, __VA_ARGS__);                                      \
    unknown_;                                                                                      \
  })

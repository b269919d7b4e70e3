/* How much two results may differ: one rule a line,
 *     PATTERN  RELATIVE  ABSOLUTE  [WHEN]        or        PATTERN  ignore  [WHEN]
 * where PATTERN is the name of a dataset ("series/energy/total") or of an attribute of the file
 * ("@revision"), with * and ? as in a shell; the last line that matches counts. `#` begins a
 * comment. RELATIVE is relative to the largest magnitude in the dataset, not to each value: a
 * pressure that passes through zero needs no absolute part. WHEN is one time or two, such as
 * `t>0.5 t<=2` (s) or `t*>4` (sqrt(H/g)): the rule is then for rows of such times only, and for
 * nothing that has no time. */
#pragma once
#include <stdbool.h>
#include <stddef.h>

#include "common/base/status.h"

struct tolerance_bound { /* t > at, or whatever else is said */
  double at;
  bool stars; /* at is in sqrt(H/g), else in s */
  bool below, equal;
};

struct tolerance {
  char *pattern;
  bool ignore;
  double relative, absolute;
  int n_bounds; /* 0: at all times, and what has none */
  struct tolerance_bound bound[2];
  int line; /* of the file; 0: none */
};

struct result_tolerances {
  size_t n, room;
  struct tolerance *rule;
};

/* Rules that hold before a file is read: everything within `relative` and `absolute`, and what
 * cannot repeat (clocks, dates, the program's revision) ignored. ERR_MEMORY. */
enum status result_tolerances_default(struct result_tolerances *t, double relative,
                                      double absolute);

/* Adds the rules of a file. ERR_INPUT with file and line. */
enum status result_tolerances_read(struct result_tolerances *t, const char *path);
void result_tolerances_destroy(struct result_tolerances *t);

/* The rules for this name, the one that counts before others first, into `rule`, room for all of
 * them; returns how many. The last of them is for all times. */
size_t result_tolerances_match(const struct result_tolerances *t, const char *name,
                               const struct tolerance **rule);

/* Which of n such rules is for a time (s; NaN: none); `scale` is sqrt(H/g), s. NULL: none is. */
const struct tolerance *result_tolerance_at(size_t n, const struct tolerance *const *rule,
                                            double time, double scale);

/* The times of a rule as they are written, " t>0.5 t<=2"; "" of one for all. */
void result_tolerance_when(const struct tolerance *rule, char *out, size_t room);

/* How much two results may differ: one rule a line,
 *     PATTERN  RELATIVE  ABSOLUTE        or        PATTERN  ignore
 * where PATTERN is the name of a dataset ("series/energy/total") or of an attribute of the file
 * ("@revision"), with * and ? as in a shell; the last line that matches counts. `#` begins a
 * comment. RELATIVE is relative to the largest magnitude in the dataset, not to each value: a
 * pressure that passes through zero needs no absolute part. */
#pragma once
#include <stdbool.h>
#include <stddef.h>

#include "common/base/status.h"

struct tolerance {
  char *pattern;
  bool ignore;
  double relative, absolute;
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

const struct tolerance *result_tolerances_find(const struct result_tolerances *t, const char *name);

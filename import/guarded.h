/* Libraries read foreign files in a child process only, as HDF5 does
 * (common/result/result_guard.h). */
#pragma once
#include "common/result/carry.h"
#include "import/formats.h"

struct import_guarded {
  const struct import_ask *ask;
  /* One of the two, in the child; messages begin with the path. */
  enum status (*steps)(const struct import_ask *ask, size_t *n, double **times);
  enum status (*read)(const struct import_ask *ask, struct import_table *t);
  size_t extra; /* bytes that the file counts for more, by which memory and time are allowed */
  size_t n;
  double *times;              /* what `steps` has found, the caller's; [n] */
  struct import_table *table; /* what `read` has found */
};

/* ERR_INPUT, and nothing is found, also when the child came to harm. */
enum status import_guard(struct import_guarded *g);

/* For requests of another kind: what was asked for, in both processes. */
enum status import_carry_table(struct carrier *c, const struct import_ask *ask,
                               struct import_table *t);

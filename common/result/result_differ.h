/* What the parts of the comparison of two files share (in the process that reads them). */
#pragma once
#include <hdf5.h>

#include "common/result/carry.h"
#include "common/result/result_diff.h"

struct differ {
  struct result_diff *d;
  const struct result_tolerances *tolerances;
  size_t shown; /* see result_diff_create */
  hid_t file[2];
  int turn; /* which of them is being read */
  size_t room;
  const struct tolerance **rule; /* for the quantity at hand, [n_rules] of tolerances->n, owned */
  size_t n_rules;
};

/* The file to be read from now on, which is to blame for what goes wrong. */
hid_t result_diff_turn(struct differ *d, int k);

/* The rule for the quantity at hand at a time (s; NaN: what has none). */
const struct tolerance *result_diff_rule(const struct differ *d, double time);

/* Notes what differs and is no number. ERR_MEMORY. */
enum status result_diff_say(struct result_quantity *q, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Holds one number of each file against its rule. */
void result_diff_numbers(struct differ *d, struct result_quantity *q, const double value[2],
                         double time);

/* The same of a dataset that is one number, and of one with n rows of `width` numbers (0: a
 * vector).
 */
enum status result_diff_scalars(struct differ *d, struct result_quantity *q);
enum status result_diff_tables(struct differ *d, struct result_quantity *q, const hsize_t n[2],
                               size_t width);

/* Both curves of the first series that differ, as many as are shown. */
enum status result_diff_curves(struct differ *d);

/* All of it, from one process to another (carry.h); `data` is a struct differ. */
enum status result_diff_carry(struct carrier *c, void *data);

/* Measures of signals in time: one alone, and one against another over the time they share. Rows
 * whose value is NaN (a dry gauge) are gaps. Times in s, values in the signal's own units. */
#pragma once
#include <stddef.h>

#include "common/base/status.h"
#include "compare/value.h"

struct cmp_signal {
  size_t n;
  const double *t, *value; /* [n], t ascending; borrowed */
};

struct cmp_signal_alone {
  struct cmp_value peak, peak_time, impulse; /* value, s, value s */
  struct cmp_value onset;                    /* s: first time the value reaches the threshold */
};

struct cmp_signal_pair { /* of `a` against `b`, over the common range of time */
  double from, to;       /* s, that range */
  struct cmp_signal_alone a, b;
  struct cmp_value rms;       /* of a - b */
  struct cmp_value shift;     /* s: a comes this much later than b, by the smallest rms */
  struct cmp_value rms_after; /* the rms if that shift were applied (it never is) */
};

/* Linear between rows; NaN outside the rows and next to gaps. */
double cmp_signal_at(const struct cmp_signal *s, double t);

/* The running mean over [t - over/2, t + over/2], clipped to the ends of the signal, at each of its
 * rows: exact for the signal as it is between rows, so that it is the same however often that is
 * sampled. The mean over a gap is a gap; over = 0 gives the values themselves. mean [n]. */
enum status cmp_signal_average(const struct cmp_signal *s, double over, double *mean);

/* Of the rows from `from` on; unknown where there is none. */
struct cmp_value cmp_signal_median(const struct cmp_signal *s, double from);

void cmp_signal_measure(const struct cmp_signal *s, double from, double to, double threshold,
                        struct cmp_signal_alone *m);

/* `reach` is the largest shift tried (s). */
void cmp_signal_compare(const struct cmp_signal *a, const struct cmp_signal *b, double threshold,
                        double reach, struct cmp_signal_pair *pair);

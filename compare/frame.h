/* The range of a chart's axis: what is inside, and what leaves it and where. */
#pragma once
#include "compare/data.h"

struct cmp_frame {
  double low, high;
};

/* Around `n` series (NULL: not there) until `end`. All of them are inside, but for those that stray
 * from the middle of all by more than `most` times their usual size (one that has blown up would
 * leave the others flat), and for peaks more than as high as everything else. */
struct cmp_frame cmp_frame_choose(size_t n, const struct cmp_series *const *series, double end,
                                  double most);

struct cmp_beyond {  /* what of a series lies outside */
  size_t n, outside; /* rows until `end`; those beyond the frame */
  struct cmp_extreme {
    bool found;
    double t, value;
  } above, below; /* the furthest on either side */
};
struct cmp_beyond cmp_frame_beyond(const struct cmp_frame *frame, const struct cmp_series *series,
                                   double end);

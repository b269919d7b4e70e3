/* gnuplot at work on a set of figures. It is started directly (no shell), in a process group of its
 * own, sees only files of the figures' temporary folder, and has a limit in time. */
#pragma once
#include "compare/figure.h"

struct cmp_drawing_limits {
  double each; /* s of the clock, for one figure */
  double all;  /* s of processor time, for all; one that was stopped counts as `each` */
};

/* A figure takes a second or two; on a busy machine many times that, which `all` does not count. */
#define CMP_DRAWING_LIMITS ((struct cmp_drawing_limits){120, 120})

/* Draws everything (as many at a time as there are processors, eight at most) and puts it in place.
 * A figure that cannot be drawn says why in `missing` and does not take the others with it: ERR_IO
 * with the first such reason. One that there was no time left for says so, and is no error.
 * INTERRUPTED, with gnuplot ended, when the user asks to stop. */
enum status cmp_figures_draw(struct cmp_figures *f, struct cmp_drawing_limits limits);

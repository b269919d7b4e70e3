/* Whether what a case says makes sense together. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/case_draft.h"
#include "common/geometry_check.h"

/* Lengths closer than this part of the tank's size are the same: decimal input and its rounding in
 * "5.366 H" stay far below, and no particle or node resolves it. */
static const double SAME = 1e-9;

static double tank_size(const struct case_file *c) {
  return fmax(c->tank.max[0] - c->tank.min[0], c->tank.max[1] - c->tank.min[1]);
}

/* Left wall down, flat bed, right wall up; further points along them are no matter. */
static bool is_rectangular(const struct case_file *c) {
  const struct geo_lines *w = &c->walls;
  const struct geo_box *box = &c->tank;
  double near = SAME * tank_size(c);
  if (w->pieces != 1 || w->closed[0] || w->points < 4) return false;
  for (size_t i = 0, part = 0; i + 1 < w->points; i++) {
    const double *p = w->p[i], *q = w->p[i + 1];
    /* part 0 goes down along the left, 1 to the right along the bed, 2 up along the right */
    if (part == 0 && fabs(p[1] - box->min[1]) <= near) part = 1;
    if (part == 1 && fabs(p[0] - box->max[0]) <= near) part = 2;
    bool good = part == 0 ? fabs(p[0] - box->min[0]) <= near && fabs(q[0] - box->min[0]) <= near &&
                                q[1] < p[1]
                : part == 1 ? fabs(q[1] - box->min[1]) <= near && q[0] > p[0]
                            : fabs(q[0] - box->max[0]) <= near && q[1] > p[1];
    if (!good) return false;
    if (i + 2 == w->points && part != 2) return false;
  }
  return true;
}

void case_check(struct case_draft *d) {
  struct case_file *c = d->c;
  if (d->good.tank) c->rectangular = is_rectangular(c);
  for (size_t k = 0; k < c->water.pieces; k++)
    if (geo_piece_area(&c->water, k) < 0) geo_piece_reverse(&c->water, k);
}

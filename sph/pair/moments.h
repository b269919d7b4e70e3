/* Symmetric 2 x 2 systems, kept solvable: used where gradients are fitted to neighbours. */
#pragma once
#include <math.h>

#include "sph/family.h"

/* Solves [xx xy; xy yy] (gx, gy) = (bx, by) after adding to the diagonal whatever lifts the smaller
 * eigenvalue to `floor` (nothing when it is there already). */
SPECIALISE void moments_solve(double xx, double xy, double yy, double floor, double bx, double by,
                              double *gx, double *gy) {
  double half = 0.5 * (xx + yy), d = 0.5 * (xx - yy);
  double least = half - sqrt(d * d + xy * xy);
  double lift = larger(floor - least, 0);
  xx += lift;
  yy += lift;
  double per_det = 1 / (xx * yy - xy * xy);
  *gx = (yy * bx - xy * by) * per_det;
  *gy = (xx * by - xy * bx) * per_det;
}

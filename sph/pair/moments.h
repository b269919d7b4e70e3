/* Symmetric 2 x 2 systems in lanes, kept solvable: used where gradients are fitted to neighbours.
 */
#pragma once
#include "sph/pair/vec.h"

/* Solves [xx xy; xy yy] (gx, gy) = (bx, by) after adding to the diagonal whatever lifts the smaller
 * eigenvalue to `floor` (nothing when it is there already). */
SPECIALISE void moments_solve(vec xx, vec xy, vec yy, double floor, vec bx, vec by, vec *gx,
                              vec *gy) {
  vec half = 0.5 * (xx + yy), d = 0.5 * (xx - yy);
  vec smaller = half - vec_sqrt(d * d + xy * xy);
  vec lift = vec_max(floor - smaller, (vec){0});
  xx += lift;
  yy += lift;
  vec det = xx * yy - xy * xy;
  *gx = (yy * bx - xy * by) / det;
  *gy = (xx * by - xy * bx) / det;
}

/* The Schwarz-Christoffel map of a tank of any straight walls: from the upper half plane to the
 * region above them, whose first and last sides go on for ever,
 *     dz / dzeta = C prod (zeta - xi_k)^(alpha_k - 1),
 * xi_k the image of the k-th bend of the walls and alpha_k pi the angle of the water there; zeta =
 * infinity is the open top. All walls are on the real axis, so beta continues across it by
 * reflection, and bends, re-entrant ones too, are exact without a node on any wall. (Driscoll &
 * Trefethen, Schwarz-Christoffel Mapping, Cambridge 2002, with series in place of their quadrature:
 * the integrand's logarithmic derivative is a sum of simple poles, so its power series at any point
 * follows from a recurrence.) */
#pragma once
#include <complex.h>
#include <stdbool.h>
#include <stddef.h>

#include "common/base/status.h"

enum {
  BEM_MOST_BENDS = 64, /* of the walls */
  BEM_CHART = 16       /* terms of a chart's series: 1e-16 of it is left out within its reach */
};

struct bem_conformal {
  size_t n;              /* bends; sides are numbered from 0, down the left, to n, up the right */
  double complex *point; /* the walls, straight on where they do not bend, H, [n + 2], owned */
  double *xi;            /* images of the bends, the points 1 to n, [n], owned */
  double *power;         /* alpha_k - 1, [n], owned */
  double complex factor; /* C */
  size_t changes;        /* how often the walls have moved */
};

/* The map near a point that is known to full precision: z = z0 + sum a_j t^(j + 1), zeta = zeta0 +
 * radius t. Steps from chart to chart add the rounding of z, which the map does not amplify. */
struct bem_chart {
  double complex z, zeta;
  double radius; /* to the nearest xi; 0: the chart is none */
  double complex a[BEM_CHART];
  double complex t; /* where it was last looked up */
};

/* Through n points (H), which bend somewhere, all but those that go straight on; keep: those that
 * may bend later, [n], or NULL. ERR_MEMORY; ERR_SOLVER when no prevertices are found. */
enum status bem_conformal_create(size_t n, const double (*point)[2], const bool *keep,
                                 struct bem_conformal **m);
enum status bem_conformal_copy(const struct bem_conformal *m, struct bem_conformal **copy);

/* Moves the points of the walls, [m->n + 2], by not so much that its parameters are no good first
 * guess. ERR_SOLVER. */
enum status bem_conformal_move(struct bem_conformal *m, const double complex *point);
void bem_conformal_destroy(struct bem_conformal *m);

/* Distance of a point of the plane of the map from the nearest image of a bend. */
double bem_conformal_gap(const struct bem_conformal *m, double complex zeta);

/* Unit vector along a side. */
double complex bem_conformal_along(const struct bem_conformal *m, size_t side);

/* The side that a point of the walls is on: the nearest. */
size_t bem_conformal_side(const struct bem_conformal *m, double complex z);

/* Height of a point above the wall below it; INFINITY where there is none. */
double bem_conformal_depth(const struct bem_conformal *m, double complex z);

/* Whether a point is on a wall, but for rounding. */
int bem_conformal_is_near(const struct bem_conformal *m, double complex z);

/* The chart at z on this side, beyond its ends too if it is the first or the last. ERR_SOLVER. */
enum status bem_conformal_start(const struct bem_conformal *m, size_t side, double complex z,
                                struct bem_chart *c);

/* Image of a point of the walls, which the nearest side is moved to, and dzeta/dz there: 0 at a
 * bend of less than a half turn, where water stagnates, and next to the others. ERR_SOLVER. */
enum status bem_conformal_on_wall(const struct bem_conformal *m, double complex z,
                                  double complex *zeta, double complex *slope);

/* zeta and dzeta/dz at z; 0 when z is beyond the chart's reach. */
int bem_chart_find(struct bem_chart *c, double complex z, double complex *zeta,
                   double complex *slope);

/* Moves the chart to z by steps along a straight line inside the region. ERR_SOLVER when that runs
 * into a bend. */
enum status bem_chart_walk(const struct bem_conformal *m, struct bem_chart *c, double complex z);

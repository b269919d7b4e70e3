/* A piece of the surface without a kink as a smooth curve: not-a-knot cubic splines of x, y and phi
 * in arc length, periodic ones of a closed chain. */
#pragma once
#include "bem/shape/surface.h"

enum { BEM_FIELDS = 3 }; /* x, y, phi */

struct bem_curve {
  size_t n, room;                  /* nodes of the piece, and of the longest there is room for */
  double *memory;                  /* [7 room], owned: of the arrays below */
  double *arc;                     /* from the start of the surface to every node, H, [n] */
  double *second;                  /* second derivatives at the nodes, [BEM_FIELDS][n] */
  double *scratch;                 /* [3n] */
  const double *value[BEM_FIELDS]; /* at the nodes, [n], the surface's own */
  size_t from;                     /* where the last search for an interval ended */
};

/* Through nodes a to b of s; start: length of the surface before node a. The surface must last as
 * long as the curve is used. ERR_MEMORY, ERR_SOLVER. */
enum status bem_curve_fit(struct bem_curve *c, const struct bem_surface *s, size_t a, size_t b,
                          double start);
void bem_curve_destroy(struct bem_curve *c);

/* One of x, y, phi at this length of the surface. */
double bem_curve_value(struct bem_curve *c, size_t field, double arc);

/* Water without sides: a piece of it of one period, of which the surface is a closed chain. The map
 *     zeta = exp(-i k (z - i level)),   k = 2 pi / length,
 * makes the surface a closed curve around zeta = 0, walked clockwise, and the bed y = 0 a circle
 * inside it, on which psi = 0; reflection in that circle, zeta -> bed/conj zeta, gives the mirror
 * image. In deep water the circle is so small that it is a point, and the same formulas hold.
 *
 * The node after the last panel is the first one, a period farther. Potential is periodic but for
 * the current's part, current (x + i y), which beta is counted without. */
#pragma once
#include <complex.h>
#include <stddef.h>

#include "common/base/geometry.h"
#include "common/base/status.h"

struct bem_surface;

struct bem_period {
  double length; /* H; 0: there are walls at both ends */
  double level;  /* H: heights near the surface, which |zeta| = 1 belongs to */
  double bed;    /* square of the radius of the bed's circle */
};

struct bem_period bem_period_create(double length, double level);

double complex bem_period_map(const struct bem_period *p, double complex z);
double complex bem_period_slope(const struct bem_period *p, double complex z); /* d zeta / d z */

/* The node of a closed chain of n that is this one. */
static inline size_t bem_period_node(size_t n, ptrdiff_t k) {
  const ptrdiff_t round = (ptrdiff_t)n - 1;
  return (size_t)(k < 0 ? k + round : k > round ? k - round : k);
}

/* Value of f[n], given at the nodes of a closed chain (the last is the first again), at a node
 * before or behind them; what f gains over the chain it gains again. */
static inline double bem_period_value(const double *f, size_t n, ptrdiff_t k) {
  const ptrdiff_t round = (ptrdiff_t)n - 1;
  if (k < 0) return f[k + round] - (f[round] - f[0]);
  if (k > round) return f[k - round] + (f[round] - f[0]);
  return f[k];
}

/* Adds the surface of this state (H) in the tank 0 <= x <= length: pieces that begin and end at its
 * sides. ERR_MEMORY. */
enum status bem_period_cut(const struct bem_surface *s, const double *state, struct geo_lines *out);

/* Mean horizontal velocity along the bed of this state: what phi gains over the chain. */
double bem_period_current(const struct bem_surface *s, const double *state);

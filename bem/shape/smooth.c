#include "bem/shape/smooth.h"

#include <math.h>

/* (-1)^(j+1) (p!)^2 / (j (p - j)! (p + j)!), p = BEM_SMOOTH; 2/j of it is that of d2/di2. */
const double bem_smooth_weight[BEM_SMOOTH + 1] = {0,        6. / 7,   -15. / 56, 5. / 63,
                                                  -1. / 56, 1. / 385, -1. / 5544};

/* Of a difference of the fifth order what one of the order 2 BEM_SMOOTH - 1 must not exceed, each
 * with its factor in the series of d/di: else the series gets nowhere. A kink has 0.3 of it, a wave
 * of four nodes 0.1. */
static const double CONVERGES = 0.1;
/* Of the range of heights and potential, and of places: last terms that are no roughness. */
static const double NOISE = 1e-6, ROUNDING = 1e-15;

double bem_smooth_node(const struct bem_surface *s, const double *f, enum bem_parity parity,
                       ptrdiff_t k) {
  const ptrdiff_t last = (ptrdiff_t)s->n - 1;
  if (bem_surface_is_closed(s)) return bem_period_value(f, s->n, k);
  if (k >= 0 && k <= last) return f[k];
  const ptrdiff_t wall = k < 0 ? 0 : last, image = 2 * wall - k;
  return parity == BEM_EVEN ? f[image] : 2 * f[wall] - f[image];
}

/* The nodes around one, from BEM_SMOOTH before it on. */
static void gather(const struct bem_surface *s, const double *f, enum bem_parity parity, size_t k,
                   double around[2 * BEM_SMOOTH + 1]) {
  for (int j = -BEM_SMOOTH; j <= BEM_SMOOTH; j++)
    around[j + BEM_SMOOTH] = bem_smooth_node(s, f, parity, (ptrdiff_t)k + j);
}

static double slope(const double *at) {
  double sum = 0;
  for (int j = BEM_SMOOTH; j > 0; j--) sum += bem_smooth_weight[j] * (at[j] - at[-j]);
  return sum;
}

static double bend(const double *at) {
  double sum = 0;
  for (int j = BEM_SMOOTH; j > 0; j--)
    sum += 2 * bem_smooth_weight[j] / j * ((at[j] - at[0]) + (at[-j] - at[0]));
  return sum;
}

double bem_smooth_slope(const struct bem_surface *s, const double *f, enum bem_parity parity,
                        size_t k) {
  double around[2 * BEM_SMOOTH + 1];
  gather(s, f, parity, k, around);
  return slope(around + BEM_SMOOTH);
}

void bem_smooth_differences(const struct bem_surface *s, const double *f, enum bem_parity parity,
                            double *first, double *second) {
  double around[2 * BEM_SMOOTH + 1];
  for (size_t k = 0; k < s->n; k++) {
    gather(s, f, parity, k, around);
    first[k] = slope(around + BEM_SMOOTH);
    if (second) second[k] = bend(around + BEM_SMOOTH);
  }
}

/* Lagrange's polynomial through the 2 BEM_SMOOTH nodes around a place, by barycentric weights
 * (-1)^m binomial(2 BEM_SMOOTH - 1, m). */
double bem_smooth_value(const struct bem_surface *s, const double *f, enum bem_parity parity,
                        double at) {
  enum { MOST = 2 * BEM_SMOOTH - 1 };
  const ptrdiff_t first = (ptrdiff_t)floor(at) - BEM_SMOOTH + 1;
  double above = 0, below = 0, weight = 1;
  for (int m = 0; m <= MOST; m++) {
    const double value = bem_smooth_node(s, f, parity, first + m);
    const double distance = at - (double)(first + m);
    if (distance == 0) return value;
    above += weight / distance * value;
    below += weight / distance;
    weight *= -(double)(MOST - m) / (m + 1);
  }
  return above / below;
}

/* Nearly straight between nodes: each repetition of the chord leaves a small part of the error. */
double bem_smooth_find(const struct bem_surface *s, const double *f, size_t k, double value) {
  enum { REPEATS = 30 };
  const double rise = f[k + 1] - f[k];
  double at = (double)k, off = value - f[k];
  for (int i = 0; i < REPEATS && fabs(off) > ROUNDING * fabs(rise); i++) {
    at += off / rise;
    off = value - bem_smooth_value(s, f, BEM_ODD, at);
  }
  return at;
}

/* Largest terms of the series of d/di, in which the first difference and all odd ones to that of
 * the order 2 BEM_SMOOTH - 1 have a part: those that fourth order leaves out, and the last ones. */
struct series {
  double fourth, last, noise;
};

static void add_series(const struct bem_surface *s, const double *f, enum bem_parity parity,
                       struct series *sum) {
  for (size_t k = 0; k < s->n; k++) {
    double d[2 * BEM_SMOOTH + 1];
    gather(s, f, parity, k, d);
    for (int order = 1; order < 2 * BEM_SMOOTH; order++) {
      const int count = 2 * BEM_SMOOTH + 1 - order;
      for (int m = 0; m < count; m++) d[m] = d[m + 1] - d[m];
      if (order == 5) sum->fourth = fmax(sum->fourth, fabs(d[count / 2]) / 30);
    }
    sum->last = fmax(sum->last, fmax(fabs(d[0]), fabs(d[1])) / 2772);
  }
}

static double range(const double *f, size_t n) {
  double low = f[0], high = f[0];
  for (size_t k = 1; k < n; k++) low = fmin(low, f[k]), high = fmax(high, f[k]);
  return high - low;
}

static bool converges(const struct series *s) {
  return s->last <= CONVERGES * s->fourth + s->noise;
}

static bool goes_on(const struct bem_surface *s) {
  if (bem_surface_is_closed(s)) return true;
  return !s->walls && s->right == BEM_END_WALL && s->corner == 0 && s->tip == 0;
}

/* The rule knows the mirror image in the bed, twice the depth away, to exp(-2 pi 2 depth/spacing).
 */
static bool stands_upright(const double *x, const double *y, size_t n) {
  for (size_t k = 0; k + 1 < n; k++)
    if (!(x[k] < x[k + 1] && x[k + 1] - x[k] < y[k])) return false;
  return true;
}

bool bem_smooth_is(const struct bem_surface *s) {
  const double *x = s->state, *y = x + s->n, *phi = y + s->n;
  if (!goes_on(s) || s->n < 2 * BEM_SMOOTH + 2 || !stands_upright(x, y, s->n)) return false;
  struct series place = {.noise = ROUNDING * range(x, s->n) + NOISE * range(y, s->n)},
                flow = {.noise = NOISE * range(phi, s->n)};
  add_series(s, x, BEM_ODD, &place);
  add_series(s, y, BEM_EVEN, &place);
  add_series(s, phi, BEM_EVEN, &flow);
  return converges(&place) && converges(&flow);
}

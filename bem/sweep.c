#include "bem/sweep.h"

#include <math.h>

/* d/dt of log f' at a point that goes with bend `with`, or at a fixed one if there is none. */
static double complex pace(const struct bem_conformal *map, const struct bem_map_rate *rate,
                           double complex zeta, size_t with) {
  const double x = creal(zeta), y = cimag(zeta) > 0 ? cimag(zeta) : 0.0;
  const double own = with < map->n ? rate->xi[with] : 0;
  double complex sum = rate->factor;
  for (size_t k = 0; k < map->n; k++) {
    const double complex from = CMPLX(x - map->xi[k], y);
    if (rate->power[k] != 0 && from != 0) sum += rate->power[k] * clog(from); /* 0: by rounding */
    if (k != with) sum -= map->power[k] * (rate->xi[k] - own) / from;
  }
  return sum;
}

/* f''/f'. */
static double complex bend(const struct bem_conformal *map, double xi) {
  double sum = 0;
  for (size_t k = 0; k < map->n; k++) sum += map->power[k] / (xi - map->xi[k]);
  return sum;
}

/* Over the panels, which go on from bends; *end: what it has come to, without the bend's own way.
 */
static void sweep_panels(const struct bem_moving *m, const struct bem_map_rate *rate,
                         const struct bem_rule *r, double complex *sweep, double complex *slope,
                         double complex *end) {
  const struct bem_gauss *g = &r->gauss;
  double complex sum = 0;
  for (size_t p = 0; p < r->panels; p++) {
    const struct bem_rule_panel *panel = r->panel + p;
    const size_t at = BEM_RULE * p, with = panel->bend;
    const double own = rate->xi[with];
    double complex h[BEM_RULE];
    if (panel->power > 1) sum = m->velocity[with + 1];
    for (int k = 0; k < BEM_RULE; k++) {
      const double way = panel->half < 0 ? -1 : 1;
      const double complex of_slope = pace(m->map, rate, r->xi[at + k], with) * r->slope[at + k];
      h[k] = way * r->weight[at + k] / g->weight[k] * of_slope;
      if (slope) slope[at + k] = of_slope;
      if (slope && own != 0) slope[at + k] -= own * bend(m->map, r->xi[at + k]) * r->slope[at + k];
    }
    for (int j = 0; sweep && j < BEM_RULE; j++) {
      sweep[at + j] = sum - own * r->slope[at + j];
      for (int k = 0; k < BEM_RULE; k++) sweep[at + j] += g->integral[j][k] * h[k];
    }
    for (int k = 0; k < BEM_RULE; k++) sum += g->weight[k] * h[k];
  }
  if (end) *end = sum;
}

void bem_sweep_rule(const struct bem_moving *m, const struct bem_map_rate *rate,
                    const struct bem_rule *r, double complex *sweep, double complex *slope) {
  sweep_panels(m, rate, r, sweep, slope, NULL);
}

enum { LEVELS = 6 };

enum status bem_sweep_wall(const struct bem_moving *m, const struct bem_map_rate *rate,
                           struct bem_rule *r, size_t side, double xi, double complex slope,
                           double complex *sweep) {
  const struct bem_conformal *map = m->map;
  const bool from_right =
      side == 0 || (side < map->n && map->xi[side] - xi < xi - map->xi[side - 1]);
  const size_t with = from_right ? side : side - 1;
  const double end[2] = {from_right ? xi : map->xi[with], from_right ? map->xi[with] : xi};
  bem_rule_clear(r);
  TRY(bem_rule_add(r, map, side, end, LEVELS, INFINITY));
  sweep_panels(m, rate, r, NULL, NULL, sweep);
  *sweep -= rate->xi[with] * slope;
  return OK;
}

/* f' */
static double complex slope_at(const struct bem_conformal *map, double complex zeta) {
  const double x = creal(zeta), y = cimag(zeta) > 0 ? cimag(zeta) : 0.0;
  double complex sum = 0;
  for (size_t k = 0; k < map->n; k++) sum += map->power[k] * clog(CMPLX(x - map->xi[k], y));
  return map->factor * cexp(sum);
}

void bem_sweep_along(const struct bem_moving *m, const struct bem_map_rate *rate,
                     const struct bem_gauss *g, size_t n, const double complex *zeta,
                     double complex *sweep) {
  for (size_t k = 1; k < n; k++) {
    const double complex half = 0.5 * (zeta[k] - zeta[k - 1]), middle = zeta[k - 1] + half;
    sweep[k] = sweep[k - 1];
    for (int j = 0; j < BEM_RULE; j++) {
      const double complex at = middle + g->point[j] * half;
      sweep[k] += g->weight[j] * half * slope_at(m->map, at) * pace(m->map, rate, at, m->map->n);
    }
  }
}

#include "bem/motion/sweep.h"

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

/* Of the way to the nearest bend: a step that Gauss's formula is exact to 1e-13 on. */
static const double STRIDE = 0.8;
enum { MOST_STEPS = 1000 };

/* ---- drift ---- */

/* Newton's form of V, from one of the bends on. */
struct drift {
  size_t n;
  double at[BEM_MOST_BENDS], c[BEM_MOST_BENDS];
};

static void drift_create(const struct bem_moving *m, const struct bem_map_rate *rate, size_t from,
                         struct drift *d) {
  d->n = rate->drifts ? m->map->n : 0;
  for (size_t i = 0; i < d->n; i++) {
    const size_t k = (from + i) % d->n;
    d->at[i] = m->map->xi[k];
    d->c[i] = rate->xi[k];
  }
  for (size_t order = 1; order < d->n; order++)
    for (size_t i = d->n; i-- > order;)
      d->c[i] = (d->c[i] - d->c[i - 1]) / (d->at[i] - d->at[i - order]);
}

/* (V - V(first))/(zeta - first), and its derivative. */
static double complex drift_beside(const struct drift *d, double complex zeta,
                                   double complex *slope) {
  double complex value = 0;
  *slope = 0;
  for (size_t i = d->n; i-- > 1;) {
    *slope = *slope * (zeta - d->at[i]) + value;
    value = value * (zeta - d->at[i]) + d->c[i];
  }
  return value;
}

double complex bem_sweep_drift(const struct bem_moving *m, const struct bem_map_rate *rate,
                               double complex zeta, double complex *slope) {
  struct drift d;
  double complex beside, rise;
  *slope = 0;
  if (!rate->drifts) return 0;
  drift_create(m, rate, 0, &d);
  beside = drift_beside(&d, zeta, &rise);
  *slope = beside + (zeta - d.at[0]) * rise;
  return d.c[0] + (zeta - d.at[0]) * beside;
}

/* ---- sweep ---- */

/* f''/f', times the way from the bend. */
static double bend(const struct bem_conformal *map, size_t with, double way, double xi) {
  double sum = 0;
  for (size_t k = 0; k < map->n; k++)
    if (k != with) sum += map->power[k] / (xi - map->xi[k]);
  return map->power[with] + way * sum;
}

/* From the bend that a panel goes on from to its point j, which rounding may bring to the bend. */
static double way_to(const struct bem_conformal *map, const struct bem_rule *r, size_t p, int j) {
  const struct bem_rule_panel *panel = r->panel + p;
  if (panel->power > 1) return 2 * panel->half * pow(0.5 * (1 + r->gauss.point[j]), panel->power);
  return r->xi[BEM_RULE * p + (size_t)j] - map->xi[panel->bend];
}

/* What the drift adds to the sweep's derivative at point j of a panel, over f'. Without a drift
 * none is asked for but beside bends whose images stay. */
static double slope_gain(const struct bem_conformal *map, const struct bem_rule *r, size_t p, int j,
                         const struct drift *d) {
  if (!d->n) return 0;
  const double xi = r->xi[BEM_RULE * p + (size_t)j], way = way_to(map, r, p, j);
  double complex rise;
  const double complex beside = drift_beside(d, xi, &rise);
  return creal((1 + bend(map, r->panel[p].bend, way, xi)) * beside + way * rise);
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
    const double own = rate->drifts ? 0 : rate->xi[with];
    struct drift drift;
    double complex h[BEM_RULE];
    drift_create(m, rate, with, &drift);
    if (panel->power > 1) sum = m->velocity[with + 1];
    for (int k = 0; k < BEM_RULE; k++) {
      const double way = panel->half < 0 ? -1 : 1;
      const double complex of_slope = pace(m->map, rate, r->xi[at + k], with) * r->slope[at + k];
      h[k] = way * r->weight[at + k] / g->weight[k] * of_slope;
      if (slope) slope[at + k] = of_slope;
      if (slope) slope[at + k] += slope_gain(m->map, r, p, k, &drift) * r->slope[at + k];
    }
    for (int j = 0; sweep && j < BEM_RULE; j++) {
      double complex rise;
      const double complex beside = drift_beside(&drift, r->xi[at + j], &rise);
      sweep[at + j] = sum + (way_to(m->map, r, p, j) * beside - own) * r->slope[at + j];
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
  struct drift drift;
  double complex rise;
  drift_create(m, rate, with, &drift);
  const double complex beside = drift_beside(&drift, xi, &rise);
  *sweep += ((xi - map->xi[with]) * beside - (rate->drifts ? 0 : rate->xi[with])) * slope;
  return OK;
}

/* f' */
static double complex slope_at(const struct bem_conformal *map, double complex zeta) {
  const double x = creal(zeta), y = cimag(zeta) > 0 ? cimag(zeta) : 0.0;
  double complex sum = 0;
  for (size_t k = 0; k < map->n; k++) sum += map->power[k] * clog(CMPLX(x - map->xi[k], y));
  return map->factor * cexp(sum);
}

/* What the drift adds to f_t. */
static double complex carried(const struct bem_moving *m, const struct bem_map_rate *rate,
                              double complex zeta) {
  double complex slope;
  return rate->drifts ? bem_sweep_drift(m, rate, zeta, &slope) * slope_at(m->map, zeta) : 0;
}

/* What f_t gains on a straight way, short beside that to any bend. */
static double complex gain(const struct bem_moving *m, const struct bem_map_rate *rate,
                           const struct bem_gauss *g, double complex from, double complex to) {
  const double complex half = 0.5 * (to - from), middle = from + half;
  double complex sum = 0;
  for (int j = 0; j < BEM_RULE; j++) {
    const double complex at = middle + g->point[j] * half;
    sum += g->weight[j] * half * slope_at(m->map, at) * pace(m->map, rate, at, m->map->n);
  }
  return sum;
}

double complex bem_sweep_on(const struct bem_moving *m, const struct bem_map_rate *rate,
                            const struct bem_gauss *g, double complex from, double complex to,
                            double complex sweep) {
  sweep -= carried(m, rate, from);
  for (int i = 0; i < MOST_STEPS && from != to; i++) {
    const double reach = STRIDE * bem_conformal_gap(m->map, from), way = cabs(to - from);
    const double complex next = way > reach ? from + reach / way * (to - from) : to;
    sweep += gain(m, rate, g, from, next);
    from = next;
  }
  return sweep + carried(m, rate, to);
}

void bem_sweep_along(const struct bem_moving *m, const struct bem_map_rate *rate,
                     const struct bem_gauss *g, size_t n, const double complex *zeta,
                     double complex *sweep) {
  double complex sum = sweep[0] - carried(m, rate, zeta[0]);
  for (size_t k = 1; k < n; k++) {
    sum += gain(m, rate, g, zeta[k - 1], zeta[k]);
    sweep[k] = sum + carried(m, rate, zeta[k]);
  }
}

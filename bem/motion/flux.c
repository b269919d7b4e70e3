#include "bem/motion/flux.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "common/base/array.h"

static const double NEAR =
    2.2; /* half panels from the middle: beyond it Gauss's formula is exact */
static const double APART = 1e-7;  /* half panels: nearer to a point of it digits are lost */
static const double BESIDE = 1e-3; /* half panels: nearer, differences are taken exactly */
enum { LEVELS = 8 };

void bem_flux_destroy(struct bem_flux *f) {
  bem_rule_destroy(&f->rule);
  free(f->q);
  f->q = NULL;
  f->room = 0;
}

/* Where the first or the last side is taken to end. */
static enum status find_top(const struct bem_conformal *m, size_t side, double top,
                            double complex *z, double *xi) {
  const double complex along = (side ? 1 : -1) * bem_conformal_along(m, side);
  const double complex bend = m->point[side ? side : 1];
  double complex zeta, slope;
  CHECK(cimag(along) > 0 && top > cimag(bend), ERR_SOLVER, "a side of the tank does not go up");
  *z = bend + (top - cimag(bend)) / cimag(along) * along;
  TRY(bem_conformal_on_wall(m, *z, &zeta, &slope));
  *xi = creal(zeta);
  return OK;
}

static enum status reserve(struct bem_flux *f) {
  const size_t points = BEM_RULE * f->rule.panels;
  if (points <= f->room) return OK;
  TRY(array_resize(&f->q, 4 * points, "fluxes through walls"));
  f->room = points;
  return OK;
}

enum status bem_flux_lay(struct bem_flux *f, const struct bem_conformal *m, const bool *driven,
                         double top) {
  f->ends = 0;
  bem_rule_clear(&f->rule);
  for (size_t i = 0; i <= m->n; i++) {
    double end[2] = {i ? m->xi[i - 1] : 0, i < m->n ? m->xi[i] : 0};
    double complex top_of_last;
    if (!driven[i]) continue;
    if (i == 0) TRY(find_top(m, i, top, &f->top, &end[0]));
    if (i == m->n) TRY(find_top(m, i, top, &top_of_last, &end[1]));
    TRY(bem_rule_add(&f->rule, m, i, end, LEVELS, INFINITY));
    f->side[f->ends] = i;
    f->end[f->ends++] = end[1];
  }
  TRY(reserve(f));
  f->g = f->q + f->room, f->q_weight = f->g + f->room, f->g_weight = f->q_weight + f->room;
  return OK;
}

void bem_flux_fill(struct bem_flux *f, const double *before) {
  const struct bem_rule *r = &f->rule;
  double jump[BEM_MOST_BENDS + 1] = {0};
  for (size_t j = 0; j < BEM_RULE * r->panels; j++) {
    const size_t side = r->panel[j / BEM_RULE].side;
    f->g[j] -= before[side];
    f->q_weight[j] = r->weight[j] * f->q[j];
    f->g_weight[j] = r->weight[j] * f->g[j];
    jump[side] += f->q_weight[j];
  }
  for (size_t i = 0; i < f->ends; i++) f->jump[i] = jump[f->side[i]];
}

enum status bem_flux_set(struct bem_flux *f, const struct bem_conformal *m,
                         const struct bem_rigid *body, double top) {
  bool driven[BEM_MOST_BENDS + 1];
  double before[BEM_MOST_BENDS + 1];
  for (size_t i = 0; i <= m->n; i++) driven[i] = bem_rigid_moves(body[i]);
  TRY(bem_flux_lay(f, m, driven, top));
  const struct bem_rule *r = &f->rule;
  for (size_t j = 0; j < BEM_RULE * r->panels; j++) {
    const struct bem_rigid b = body[r->panel[j / BEM_RULE].side];
    f->q[j] = cimag(conj(bem_rigid_at(b, r->z[j])) * r->slope[j]);
    f->g[j] = bem_rigid_stream(b, r->z[j]);
  }
  for (size_t i = 0; i <= m->n; i++)
    before[i] = bem_rigid_stream(body[i], i == 0 ? f->top : m->point[i]);
  bem_flux_fill(f, before);
  return OK;
}

/* Integral of 1/(s - sigma) ds from -1 to 1, sigma on the real axis being above or below it by the
 * sign of its zero. */
static double complex log_ratio(double complex sigma) {
  const double x = creal(sigma), y = cimag(sigma);
  return CMPLX(0.5 * log(((x - 1) * (x - 1) + y * y) / ((x + 1) * (x + 1) + y * y)),
               atan2(2 * y, x * x + y * y - 1));
}

/* Gauss's formula. */
static void add_far(const struct bem_flux *f, size_t p, double complex zeta, double complex *value,
                    double complex *slope) {
  const size_t at = BEM_RULE * p;
  const double x = creal(zeta), y = cimag(zeta);
  const double *xi = f->rule.xi + at, *q = f->q_weight + at, *g = f->g_weight + at;
  double q_re = 0, q_im = 0, g_re = 0, g_im = 0;
#pragma omp simd reduction(+ : q_re, q_im, g_re, g_im)
  for (size_t j = 0; j < BEM_RULE; j++) {
    const double dx = xi[j] - x, square = dx * dx + y * y;
    const double inverse = square > 0 ? 1 / square : 0; /* at a bend, by rounding */
    q_re += q[j] * dx * inverse;
    q_im += q[j] * y * inverse;
    g_re += g[j] * dx * inverse;
    g_im += g[j] * y * inverse;
  }
  *slope += CMPLX(q_re, q_im);
  *value += CMPLX(g_re, g_im);
}

/* The polynomial P through values at the points. */
static double complex polynomial(const struct bem_gauss *g, const double *value,
                                 double complex at) {
  double complex above = 0, below = 0;
  for (int j = 0; j < BEM_RULE; j++) {
    const double complex t = g->between[j] / (g->point[j] - at);
    above += t * value[j];
    below += t;
  }
  return above / below;
}

/* P' at a point. */
static double derivative(const struct bem_gauss *g, const double *value, int at) {
  double sum = 0;
  for (int j = 0; j < BEM_RULE; j++)
    if (j != at)
      sum += g->between[j] / g->between[at] * (value[j] - value[at]) / (g->point[at] - g->point[j]);
  return sum;
}

/* From the interval -1 to 1, by its ellipse: beyond it Gauss's formula is exact. */
static bool is_far(double complex sigma) {
  const double FAR = 3;
  const double complex root = csqrt(sigma * sigma - 1);
  return fmax(cabs(sigma + root), cabs(sigma - root)) > FAR;
}

/* Integral of P(s)/(s - sigma) from -1 to 1: Gauss's formula is exact for (P(s) - P(sigma))/(s -
 * sigma), which is P' where sigma is on a point, but for rounding. */
static double complex integrate(const struct bem_gauss *g, const double *value,
                                double complex sigma) {
  const bool far = is_far(sigma);
  double complex sum = 0, here = 0;
  int on = BEM_RULE;
  for (int j = 0; j < BEM_RULE; j++)
    if (cabs(g->point[j] - sigma) < APART) on = j;
  if (on < BEM_RULE) {
    const double slope = derivative(g, value, on);
    here = value[on] + slope * (sigma - g->point[on]);
    sum = g->weight[on] * slope;
  } else if (!far) {
    here = polynomial(g, value, sigma);
  }
  for (int j = 0; j < BEM_RULE; j++)
    if (j != on) sum += g->weight[j] * (value[j] - here) / (g->point[j] - sigma);
  return far ? sum : sum + here * log_ratio(sigma);
}

static double complex root_of(double complex sigma, int k, int power) {
  return k ? (1 + sigma) * cexp(2 * M_PI * I * k / power) - 1 : sigma;
}

/* Rise of zeta by the variable, over `half`. */
static double complex rise_of(int power, double complex sigma) {
  return power > 1 ? power * cpow(0.5 * (1 + sigma), power - 1) : 1;
}

/* Adds what Gauss's formula leaves out of the pole at sigma, which is on no point. */
static void add_pole(const struct bem_flux *f, size_t p, double complex sigma,
                     double complex *value, double complex *slope) {
  const struct bem_gauss *gauss = &f->rule.gauss;
  const struct bem_rule_panel *panel = f->rule.panel + p;
  const double *q = f->q_weight + BEM_RULE * p, *g = f->g + BEM_RULE * p;
  double complex below = 0, q_at = 0, g_at = 0, weights = 0;
  for (int j = 0; j < BEM_RULE; j++) {
    const double complex t = 1 / (gauss->point[j] - sigma);
    below += gauss->between[j] * t;
    q_at += gauss->between[j] * t * (q[j] / gauss->weight[j]);
    g_at += gauss->between[j] * t * g[j];
    weights += gauss->weight[j] * t;
  }
  const double complex rest = (log_ratio(sigma) - weights) / below;
  *slope += q_at * rest / (rise_of((int)panel->power, sigma) * panel->half);
  *value += (panel->half > 0 ? 1 : -1) * g_at * rest;
}

/* The whole panel where the pole is so near a point that differences of the two in zeta and in the
 * variable would differ by rounding: all in the latter. */
static void add_at_point(const struct bem_flux *f, size_t p, double complex sigma,
                         double complex *value, double complex *slope) {
  const struct bem_gauss *gauss = &f->rule.gauss;
  const struct bem_rule_panel *panel = f->rule.panel + p;
  const int power = (int)panel->power;
  double rising[BEM_RULE];
  for (int j = 0; j < BEM_RULE; j++)
    rising[j] = f->q_weight[BEM_RULE * p + (size_t)j] / gauss->weight[j];
  for (int k = 0; k < power; k++) {
    const double complex at = root_of(sigma, k, power);
    *slope += integrate(gauss, rising, at) / (rise_of(power, at) * panel->half);
    *value += (panel->half > 0 ? 1 : -1) * integrate(gauss, f->g + BEM_RULE * p, at);
  }
}

/* In the variable of the panel, a power of which is zeta's at a bend: there the integrand has a
 * pole at each of the roots. P is q times the rise of zeta, or g. */
static void add_near(const struct bem_flux *f, size_t p, double complex zeta, double complex sigma,
                     double complex *value, double complex *slope) {
  const int power = (int)f->rule.panel[p].power;
  for (int j = 0; j < BEM_RULE; j++)
    if (cabs(f->rule.gauss.point[j] - sigma) < BESIDE) {
      add_at_point(f, p, sigma, value, slope);
      return;
    }
  add_far(f, p, zeta, value, slope);
  for (int k = 0; k < power; k++) {
    const double complex at = root_of(sigma, k, power);
    if (k == 0 || !is_far(at)) add_pole(f, p, at, value, slope);
  }
}

/* Where zeta is in the variable of a panel. */
static double complex find_pole(const struct bem_rule_panel *p, double complex zeta) {
  const double complex part =
      CMPLX((creal(zeta) - p->start) / (2 * p->half), cimag(zeta) / (2 * p->half));
  const double complex u = p->power > 1 ? cpow(part, 1 / p->power) : part;
  return CMPLX(2 * creal(u) - 1, 2 * cimag(u));
}

static double jump_of(const struct bem_flux *f, size_t side) {
  size_t i = 0;
  while (f->side[i] != side) i++;
  return f->jump[i];
}

/* Adds to the value what it has where a side ends, at the bend that the panel goes on from: psi is
 * the side's jump there, whose integral over the panel is a logarithm at either end; that at the
 * bend and the side's own, which is left out as well, cancel each other. */
static void add_end(const struct bem_flux *f, size_t p, double complex zeta,
                    double complex *value) {
  const struct bem_rule_panel *panel = f->rule.panel + p;
  const double jump = jump_of(f, panel->side);
  const double *xi = f->rule.xi + BEM_RULE * p, *weight = f->rule.weight + BEM_RULE * p;
  const double begin = panel->start + 2 * panel->half - creal(zeta);
  double sum = 0;
  for (int j = 0; j < BEM_RULE; j++)
    if (xi[j] != creal(zeta)) sum += weight[j] / (xi[j] - creal(zeta)); /* as it is added */
  *value -= jump * (sum + clog(CMPLX(begin, -cimag(zeta))));
}

static void add_panel(const struct bem_flux *f, size_t p, double complex zeta,
                      double complex *value, double complex *slope) {
  const struct bem_rule_panel *panel = f->rule.panel + p;
  const double x = creal(zeta) - (panel->start + panel->half), y = cimag(zeta);
  const bool at_bend = panel->power > 1 && zeta == panel->start; /* by rounding */
  const bool near = !at_bend && x * x + y * y < NEAR * NEAR * panel->half * panel->half;
  if (near)
    add_near(f, p, zeta, find_pole(panel, zeta), value, slope);
  else
    add_far(f, p, zeta, value, slope);
  if (at_bend && panel->half < 0) add_end(f, p, zeta, value);
}

void bem_flux_at(const struct bem_flux *f, double complex zeta, double complex *value,
                 double complex *slope) {
  const double x = creal(zeta), y = cimag(zeta) > 0 ? cimag(zeta) : 0.0;
  *value = *slope = 0;
  for (size_t p = 0; p < f->rule.panels; p++) add_panel(f, p, CMPLX(x, y), value, slope);
  for (size_t i = 0; i < f->ends; i++)
    if (f->end[i] != x || y != 0) *value -= f->jump[i] * clog(CMPLX(f->end[i] - x, -y));
  *value /= M_PI;
  *slope /= M_PI;
}

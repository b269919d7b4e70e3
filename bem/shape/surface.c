#include "bem/shape/surface.h"

#include <math.h>
#include <stdlib.h>

#include "bem/shape/smooth.h"
#include "common/base/array.h"

enum { FIVE = 5, FOUR = 4 };

enum status bem_surface_reserve(struct bem_surface *s, size_t n) {
  if (n > s->room) {
    TRY(array_resize(&s->state, 3 * n, "numbers of a surface"));
    s->room = n;
  }
  s->n = n;
  return OK;
}

void bem_surface_destroy(struct bem_surface *s) {
  free(s->state);
  *s = (struct bem_surface){0};
}

enum status bem_surface_follow(struct bem_surface *s, const struct bem_surface *like, size_t n) {
  TRY(bem_surface_reserve(s, n));
  struct bem_surface own = *s;
  *s = *like;
  s->n = n;
  s->room = own.room;
  s->state = own.state;
  return OK;
}

void bem_surface_replace(struct bem_surface *s, const struct bem_surface *fresh) {
  free(s->state);
  *s = *fresh;
}

static void hold_along(double complex along, double *x, double *y) {
  const double speed = *x * creal(along) + *y * cimag(along);
  *x = speed * creal(along);
  *y = speed * cimag(along);
}

void bem_surface_hold_ends(const struct bem_surface *s, double *x, double *y) {
  const size_t last = s->n - 1;
  if (bem_surface_is_closed(s)) {
    x[last] = x[0];
    y[last] = y[0];
    return;
  }
  if (s->walls) {
    hold_along(bem_conformal_along(s->walls, s->side[0]), x, y);
    hold_along(bem_conformal_along(s->walls, s->side[1]), x + last, y + last);
    return;
  }
  x[0] = 0;
  double *off = s->right == BEM_END_BED ? y : x;
  off[last] = 0;
}

/* First node of a stencil of `count` that starts `left` before `at` and stays within one piece; it
 * goes on round a closed chain, where it may lie before the first node. */
static ptrdiff_t window(const struct bem_surface *s, size_t at, size_t left, size_t count,
                        bool after) {
  const size_t n = s->n, corner = s->corner;
  if (bem_surface_is_closed(s)) return (ptrdiff_t)at - (ptrdiff_t)left;
  size_t begin = corner && (at > corner || (at == corner && after)) ? corner : 0;
  size_t end = corner && begin == 0 ? corner + 1 : n;
  size_t first = at >= begin + left ? at - left : begin;
  return (ptrdiff_t)(first + count > end ? end - count : first);
}

void bem_surface_differences(const struct bem_surface *s, const double *f, double *first,
                             double *second) {
  /* rows: position of the node in its stencil; exact for quartics */
  static const double d1[FIVE][FIVE] = {{-25, 48, -36, 16, -3},
                                        {-3, -10, 18, -6, 1},
                                        {1, -8, 0, 8, -1},
                                        {-1, 6, -18, 10, 3},
                                        {3, -16, 36, -48, 25}};
  static const double d2[FIVE][FIVE] = {{35, -104, 114, -56, 11},
                                        {11, -20, 6, 4, -1},
                                        {-1, 16, -30, 16, -1},
                                        {-1, 4, 6, -20, 11},
                                        {11, -56, 114, -104, 35}};
  for (size_t k = 0; k < s->n; k++) {
    const ptrdiff_t w = window(s, k, 2, FIVE, true), at = (ptrdiff_t)k - w;
    double a = 0, b = 0;
    for (int m = 0; m < FIVE; m++) {
      const double value = bem_period_value(f, s->n, w + m);
      a += d1[at][m] * value;
      b += d2[at][m] * value;
    }
    first[k] = a / 12;
    if (second) second[k] = b / 12;
  }
}

double bem_surface_importance(const struct bem_surface *s, double x, double y) {
  if (s->tip == 0 || s->walls || s->right == BEM_END_BED || !(s->depth > 0)) return 1;
  const double half = BEM_FILM_THIN * s->depth, top = BEM_FILM_HIGH * s->depth;
  double near = 0.5 - 0.5 * tanh((s->tank - x - half) / (0.3 * half));
  double high = 0.5 + 0.5 * tanh((y - top) / (0.1 * top));
  return 1 - near * high;
}

/* Values and slopes at Gauss points of the panel that begins at position `at` of its stencil. */
static void panel_basis(size_t at, double s, double value[FOUR], double slope[FOUR]) {
  for (int m = 0; m < FOUR; m++) {
    double x = (double)at + s, below = 1;
    value[m] = 1;
    slope[m] = 0;
    for (int q = 0; q < FOUR; q++) {
      if (q == m) continue;
      slope[m] = slope[m] * (x - q) + value[m];
      value[m] *= x - q;
      below *= m - q;
    }
    value[m] /= below;
    slope[m] /= below;
  }
}

static const double gauss_point[FOUR] = {0.06943184420297371, 0.33000947820757187,
                                         0.66999052179242813, 0.93056815579702629};
static const double gauss_weight[FOUR] = {0.17392742256872693, 0.32607257743127307,
                                          0.32607257743127307, 0.17392742256872693};

/* What the walls between the contact points add to the integrals around the water; the bed of a
 * rectangular tank is y = 0 and adds nothing. */
static void add_walls(const struct bem_surface *s, struct bem_totals *t) {
  const double *x = s->state, *y = x + s->n;
  const size_t last = s->n - 1, from = s->side[0], to = s->side[1];
  double complex a = CMPLX(x[0], y[0]);
  for (size_t i = from; i <= to; i++) {
    const double complex b = i < to ? s->walls->point[i + 1] : CMPLX(x[last], y[last]);
    const double dx = creal(b - a), low = cimag(a), high = cimag(b);
    t->volume -= dx * (low + high) / 2;
    t->potential -= dx * (low * low + low * high + high * high) / 6;
    a = b;
  }
}

/* Kinetic energy by parts: psi and d phi go round a closed chain as they were. */
static struct bem_totals smooth_totals(const struct bem_surface *s, const double *psi) {
  const double *x = s->state, *y = x + s->n, *phi = y + s->n;
  struct bem_totals t = {0};
  for (size_t k = 0; k < s->n; k++) {
    const double share = bem_smooth_share(s, k), dx = share * bem_smooth_slope(s, x, BEM_ODD, k);
    t.volume += y[k] * dx;
    t.potential += 0.5 * y[k] * y[k] * dx;
    t.kinetic += 0.5 * share * psi[k] * bem_smooth_slope(s, phi, BEM_EVEN, k);
  }
  return t;
}

struct bem_totals bem_surface_totals(const struct bem_surface *s, const double *psi) {
  if (s->smooth) return smooth_totals(s, psi);
  const double *x = s->state, *y = x + s->n, *phi = y + s->n;
  double value[3][FOUR][FOUR], slope[3][FOUR][FOUR];
  for (size_t at = 0; at < 3; at++)
    for (int g = 0; g < FOUR; g++) panel_basis(at, gauss_point[g], value[at][g], slope[at][g]);
  struct bem_totals t = {0};
  for (size_t j = 0; j + 1 < s->n; j++) {
    const ptrdiff_t w = window(s, j, 1, FOUR, true), at = (ptrdiff_t)j - w;
    for (int g = 0; g < FOUR; g++) {
      double yg = 0, phig = 0, dx = 0, dpsi = 0;
      for (int m = 0; m < FOUR; m++) {
        yg += value[at][g][m] * bem_period_value(y, s->n, w + m);
        phig += value[at][g][m] * bem_period_value(phi, s->n, w + m);
        dx += slope[at][g][m] * bem_period_value(x, s->n, w + m);
        dpsi += slope[at][g][m] * bem_period_value(psi, s->n, w + m);
      }
      t.volume += gauss_weight[g] * yg * dx;
      t.potential += gauss_weight[g] * 0.5 * yg * yg * dx;
      t.kinetic -= gauss_weight[g] * 0.5 * phig * dpsi;
    }
  }
  if (s->walls) add_walls(s, &t);
  /* through the ends of a period: what phi gains from one to the other, times the flow */
  t.kinetic += 0.5 * bem_period_current(s, s->state) * s->period.length * psi[0];
  return t;
}

double bem_surface_integral(const struct bem_surface *s, const double *f, const double *g) {
  double value[3][FOUR][FOUR], slope[3][FOUR][FOUR], sum = 0;
  for (size_t at = 0; at < 3; at++)
    for (int q = 0; q < FOUR; q++) panel_basis(at, gauss_point[q], value[at][q], slope[at][q]);
  for (size_t j = 0; j + 1 < s->n; j++) {
    const ptrdiff_t w = window(s, j, 1, FOUR, true), at = (ptrdiff_t)j - w;
    for (int q = 0; q < FOUR; q++) {
      double fq = 0, dg = 0;
      for (int m = 0; m < FOUR; m++) {
        fq += value[at][q][m] * bem_period_value(f, s->n, w + m);
        dg += slope[at][q][m] * bem_period_value(g, s->n, w + m);
      }
      sum += gauss_weight[q] * fq * dg;
    }
  }
  return sum;
}

static double smooth_power(const struct bem_surface *s, double level, const double *psi,
                           const double *u, const double *v, const double *rate) {
  const size_t n = s->n;
  const double *x = s->state, *y = x + n, *rx = rate, *ry = rate + n, *rphi = rate + 2 * n;
  double power = 0;
  for (size_t k = 0; k < n; k++) {
    const double own = rphi[k] - u[k] * rx[k] - v[k] * ry[k];
    const double head = 0.5 * (u[k] * u[k] + v[k] * v[k]) + y[k] - level;
    const double across =
        ry[k] * bem_smooth_slope(s, x, BEM_ODD, k) - rx[k] * bem_smooth_slope(s, y, BEM_EVEN, k);
    power += bem_smooth_share(s, k) * (head * across - own * bem_smooth_slope(s, psi, BEM_ODD, k));
  }
  return power;
}

/* At the surface phi_n (dphi - u dx - v dy) + (q^2/2 + y - level) times the normal displacement,
 * with phi_n ds = -dpsi and the outward normal times ds = (-dy, dx); phi_n, psi and q of the motion
 * in the frame. */
double bem_surface_power(const struct bem_surface *s, double level, const double *psi,
                         const double *u, const double *v, struct bem_spinning frame,
                         const double *rate) {
  if (s->smooth) return smooth_power(s, level, psi, u, v, rate);
  const size_t n = s->n;
  const double *x = s->state, *y = x + n, *rx = rate, *ry = rate + n, *rphi = rate + 2 * n;
  double value[3][FOUR][FOUR], slope[3][FOUR][FOUR], power = 0;
  for (size_t at = 0; at < 3; at++)
    for (int g = 0; g < FOUR; g++) panel_basis(at, gauss_point[g], value[at][g], slope[at][g]);
  for (size_t j = 0; j + 1 < n; j++) {
    const ptrdiff_t w = window(s, j, 1, FOUR, true), at = (ptrdiff_t)j - w;
    for (int g = 0; g < FOUR; g++) {
      double own = 0, head = 0, mx = 0, my = 0, dx = 0, dy = 0, dpsi = 0;
      for (int m = 0; m < FOUR; m++) {
        const size_t k = bem_period_node(n, w + m);
        double a = value[at][g][m], b = slope[at][g][m];
        own += a * (rphi[k] - u[k] * rx[k] - v[k] * ry[k]);
        const double complex arm = CMPLX(x[k], y[k]) + frame.origin;
        const double ur = u[k] + frame.turn * cimag(arm), vr = v[k] - frame.turn * creal(arm);
        head += a * (0.5 * (ur * ur + vr * vr) + y[k] - level);
        mx += a * rx[k];
        my += a * ry[k];
        dx += b * bem_period_value(x, n, w + m);
        dy += b * y[k];
        dpsi += b * (psi[k] + 0.5 * frame.turn * creal(arm * conj(arm)));
      }
      power += gauss_weight[g] * (head * (my * dx - mx * dy) - own * dpsi);
    }
  }
  return power;
}

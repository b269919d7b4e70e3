#include "bem/water/damping.h"

#include <math.h>
#include <string.h>

#include "bem/shape/smooth.h"

static const double REACH = 0.05; /* H: the smoothing reaches this far from the thin tip */
static const double SHARP = 0.4;  /* rad from one panel to the next: where it is felt elsewhere */
static const double STRAIN = 2; /* both filters also work at so many times the local strain rate */

/* |dw/dz| between two nodes, sqrt(g/H): the pace at which noise can grow there. */
static double strain(const struct bem_flow *f, const double *state, size_t a, size_t b) {
  const double *y = state + f->surface.n;
  double dx = state[b] - state[a], dy = y[b] - y[a];
  double du = f->u[b] - f->u[a], dv = f->v[b] - f->v[a];
  return sqrt((du * du + dv * dv) / (dx * dx + dy * dy));
}

/* Longuet-Higgins & Cokelet's (1976) five-point formula removes 1/16 of the fourth difference; here
 * at a rate instead of every few steps, as -D^T W D with D the second difference, so that nothing
 * interrupts the time integrator. W is one at the thin tip and in the unimportant part of the film;
 * elsewhere it is felt only where the surface turns by about SHARP from one panel to the next, in
 * the cusp that forms where the film, falling back along the wall, meets the water behind the
 * breaker. */
static void smooth(const struct bem_flow *f, const double *state, double *rate) {
  const size_t n = f->surface.n;
  const double *x = state, *y = state + n;
  double distance = 0;
  for (size_t k = n - 2; k >= 1; k--) {
    double ax = x[k] - x[k - 1], ay = y[k] - y[k - 1];
    double bx = x[k + 1] - x[k], by = y[k + 1] - y[k];
    double turn = fabs(atan2(ax * by - ay * bx, ax * bx + ay * by)) / SHARP;
    double bend = k == f->surface.corner ? 0 : turn * turn * turn * turn;
    distance += hypot(bx, by);
    double fade = fmax(0, 1 - distance / REACH);
    double pace = f->smoothing + STRAIN * strain(f, state, k - 1, k + 1);
    double strength =
        pace / 16 *
        (fade * fade + bend / (1 + bend) + 1 - bem_surface_importance(&f->surface, x[k], y[k]));
    for (size_t field = 0; field < 3; field++) {
      const double *g = state + field * n + k;
      double *r = rate + field * n + k, d = strength * (g[-1] - 2 * g[0] + g[1]);
      r[-1] -= d;
      r[0] += 2 * d;
      r[1] -= d;
    }
  }
}

/* The filter below on a closed chain. */
static void filter_round(const struct bem_flow *f, const double *state, double *rate) {
  static const double third[] = {-1, 3, -3, 1};
  const size_t n = f->surface.n;
  for (size_t k = 0; k + 1 < n; k++) {
    const ptrdiff_t first = (ptrdiff_t)k - 1;
    const double pace = f->filter + STRAIN * strain(f, state, k, k + 1);
    for (size_t field = 0; field < 3; field++) {
      double *r = rate + field * n, d = 0;
      for (int m = 0; m < 4; m++) d += third[m] * bem_period_value(state + field * n, n, first + m);
      for (int m = 0; m < 4; m++)
        r[bem_period_node(n, first + m) % (n - 1)] -= third[m] * pace / 64 * d;
    }
  }
  for (size_t field = 0; field < 3; field++) rate[field * n + n - 1] = rate[field * n];
}

/* A sixth difference, likewise as -D^T D / 64 with D the third difference of nodes of one piece: it
 * takes away the sawtooth of two spacings, which nothing else damps, and of a wave of 20 nodes
 * 1.5e-5 of the rate: a term of sixth order in the spacing. */
static void filter(const struct bem_flow *f, const double *state, double *rate) {
  const size_t n = f->surface.n, corner = f->surface.corner;
  if (bem_surface_is_closed(&f->surface)) {
    filter_round(f, state, rate);
    return;
  }
  for (size_t k = 0; k + 3 < n; k++) {
    if (k < corner && k + 3 > corner) continue;
    double strength = (f->filter + STRAIN * strain(f, state, k, k + 3)) / 64;
    for (size_t field = 0; field < 3; field++) {
      const double *g = state + field * n + k;
      double *r = rate + field * n + k, d = strength * (g[3] - g[0] + 3 * (g[1] - g[2]));
      r[0] += d;
      r[1] -= 3 * d;
      r[2] += 3 * d;
      r[3] -= d;
    }
  }
}

/* Of the order SMOOTHEST, at the nodes: even, so that it has the symmetry of what it is of. */
enum { SMOOTHEST = 8 };
static void difference(const struct bem_surface *s, const double *f, enum bem_parity parity,
                       double *out) {
  static const double binomial[SMOOTHEST / 2 + 1] = {70, -56, 28, -8, 1};
  for (size_t k = 0; k < s->n; k++) {
    const ptrdiff_t at = (ptrdiff_t)k;
    double sum = binomial[0] * f[k];
    for (ptrdiff_t j = 1; j <= SMOOTHEST / 2; j++)
      sum += binomial[j] *
             (bem_smooth_node(s, f, parity, at - j) + bem_smooth_node(s, f, parity, at + j));
    out[k] = sum / (1 << SMOOTHEST);
  }
}

/* On a smooth surface -D^T D with D the eighth difference over 2^8, mirrored at walls: of a wave of
 * 20 nodes it takes 1e-13 of the rate, of one of five 2e-4. */
static void filter_smooth(const struct bem_flow *f, const double *state, double *rate) {
  const struct bem_surface *s = &f->surface;
  const size_t n = s->n;
  double *once = f->phi_own, *twice = f->psi_own;
  for (size_t field = 0; field < 3; field++) {
    const enum bem_parity parity = field == 0 ? BEM_ODD : BEM_EVEN;
    difference(s, state + field * n, parity, once);
    for (size_t k = 0; k < n; k++)
      once[k] *= f->filter + STRAIN * strain(f, state, k > 0 ? k - 1 : k, k + 1 < n ? k + 1 : k);
    if (bem_surface_is_closed(s)) once[n - 1] = once[0];
    difference(s, once, parity, twice);
    for (size_t k = 0; k < n; k++) rate[field * n + k] -= twice[k];
  }
}

/* An edge on a side that need not be upright is moved by what would move the surface off itself
 * alone: what would move it along the surface, as where spacings differ, is no roughness, and its
 * potential does not follow. */
static void hold_edge(const struct bem_flow *f, double *damping, bool right) {
  const struct bem_surface *s = &f->surface;
  const size_t k = right ? s->n - 1 : 0;
  const double complex along = bem_conformal_along(s->walls, s->side[right]);
  const double complex tangent = CMPLX(f->tx[k], f->ty[k]);
  double *x = damping + k, *y = x + s->n, *phi = y + s->n;
  const double complex d = CMPLX(*x, *y) * conj(tangent);
  const double complex off = cimag(d) * cimag(along * conj(tangent)) * along;
  *x = creal(off);
  *y = cimag(off);
  *phi -= creal(d) * (f->u[k] * f->tx[k] + f->v[k] * f->ty[k]);
}

/* Rate at which nodes that move so change the volume, H^2 sqrt(g/H): the exact derivative of its
 * quadrature, since edges stay on their walls. */
static double volume_rate(const struct bem_surface *s, const double *state, const double *x,
                          const double *y) {
  return bem_surface_integral(s, y, state) - bem_surface_integral(s, x, state + s->n);
}

/* Gives back the volume that the damping takes, where it works: along the normal, by so much of
 * what it moves nodes by there. Water that is moved off keeps its flow. */
static void keep_volume(struct bem_flow *f, const double *state) {
  const struct bem_surface *s = &f->surface;
  const size_t n = s->n, ends = bem_surface_is_closed(s) ? 0 : 1;
  double *x = f->damping, *y = x + n, *phi = y + n, *back = f->back;
  memset(back, 0, 2 * n * sizeof *back);
  for (size_t k = ends; k + ends < n; k++) {
    const double d = f->tx[k] * y[k] - f->ty[k] * x[k], off = d * d;
    back[k] = -off * f->ty[k];
    back[n + k] = off * f->tx[k];
  }
  const double room = volume_rate(s, state, back, back + n);
  if (!(room > 0)) return;
  const double part = volume_rate(s, state, x, y) / room;
  for (size_t k = 0; k < n; k++) {
    x[k] -= part * back[k];
    y[k] -= part * back[n + k];
    phi[k] -= part * (f->u[k] * back[k] + f->v[k] * back[n + k]);
  }
}

void bem_damping_add(struct bem_flow *f, const double *state, double *rate) {
  const struct bem_surface *s = &f->surface;
  const size_t n = s->n;
  double *damping = f->damping;
  memset(damping, 0, 3 * n * sizeof *damping);
  if (s->smooth)
    filter_smooth(f, state, damping);
  else
    filter(f, state, damping);
  if (s->tip > 0) smooth(f, state, damping);
  for (int right = 0; s->walls && right < 2; right++) hold_edge(f, damping, right);
  bem_surface_hold_ends(s, damping, damping + n);
  if (!s->smooth) keep_volume(f, state); /* what the filter of those takes has none */
  for (size_t k = 0; k < 3 * n; k++) rate[k] += damping[k];
}

#include "bem/flow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double REACH = 0.05; /* H: the smoothing reaches this far from the thin tip */
static const double SHARP = 0.4;  /* rad from one panel to the next: where it is felt elsewhere */
static const double STRAIN = 2; /* both filters also work at so many times the local strain rate */

enum status bem_flow_reserve(struct bem_flow *f, size_t n) {
  TRY(bem_panels_reserve(&f->panels, n));
  TRY(bem_mesh_reserve(&f->mesh, n));
  if (n > f->room) {
    double *real = calloc(6 * n, sizeof *real);
    double complex *w = calloc(n, sizeof *w);
    free(f->psi);
    free(f->w);
    f->psi = real;
    f->w = w;
    CHECK(real && w, ERR_MEMORY, "no memory for the velocities of %zu nodes", n);
    f->u = real + n, f->v = f->u + n, f->tx = f->v + n, f->ty = f->tx + n, f->q = f->ty + n;
    f->room = n;
  }
  memset(f->psi, 0, n * sizeof *f->psi); /* the guess of another mesh is worth nothing */
  return OK;
}

void bem_flow_destroy(struct bem_flow *f) {
  bem_panels_destroy(&f->panels);
  bem_solve_destroy(f->solve);
  bem_mesh_destroy(&f->mesh);
  bem_surface_destroy(&f->surface);
  free(f->psi);
  free(f->w);
  *f = (struct bem_flow){0};
}

enum status bem_flow_follow(struct bem_flow *view, const struct bem_flow *f) {
  const size_t n = f->surface.n;
  TRY(bem_surface_reserve(&view->surface, n));
  struct bem_surface own = view->surface;
  view->surface = f->surface;
  view->surface.state = own.state;
  view->surface.room = own.room;
  view->level = f->level;
  TRY(bem_flow_reserve(view, n));
  memcpy(view->psi, f->psi, n * sizeof *f->psi);
  return OK;
}

enum status bem_flow_solve(struct bem_flow *f, const double *state, int keep) {
  const struct bem_surface *s = &f->surface;
  const size_t n = s->n;
  bem_panels_set(&f->panels, n, state, state + n, s->length);
  TRY(bem_solve_first(f->solve, &f->panels, state + 2 * n, f->psi, keep));
  bem_panels_velocity(&f->panels, state + 2 * n, f->psi, f->w);
  for (size_t k = 0; k < n; k++) {
    f->u[k] = creal(f->w[k]);
    f->v[k] = -cimag(f->w[k]);
  }
  f->u[0] = 0;
  *(s->right == BEM_END_BED ? &f->v[n - 1] : &f->u[n - 1]) = 0;
  f->w[0] = CMPLX(f->u[0], -f->v[0]);
  f->w[n - 1] = CMPLX(f->u[n - 1], -f->v[n - 1]);
  return OK;
}

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

/* A sixth difference, likewise as -D^T D / 64 with D the third difference of nodes of one piece: it
 * takes away the sawtooth of two spacings, which nothing else damps, and of a wave of 20 nodes
 * 1.5e-5 of the rate: a term of sixth order in the spacing. */
static void filter(const struct bem_flow *f, const double *state, double *rate) {
  const size_t n = f->surface.n, corner = f->surface.corner;
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

enum status bem_flow_rates(struct bem_flow *f, const double *state, double *rate) {
  const struct bem_surface *s = &f->surface;
  const size_t n = s->n;
  double *dx = rate, *dy = rate + n, *dphi = rate + 2 * n;
  TRY(bem_flow_solve(f, state, 0));
  bem_mesh_velocity(&f->mesh, s, state, f->u, f->v, f->tx, f->ty, f->q);
  for (size_t k = 0; k < n; k++) {
    double u = f->u[k], v = f->v[k];
    dx[k] = u + f->q[k] * f->tx[k];
    dy[k] = v + f->q[k] * f->ty[k];
    dphi[k] =
        0.5 * (u * u + v * v) - (state[n + k] - f->level) + f->q[k] * (f->tx[k] * u + f->ty[k] * v);
  }
  if (s->tip > 0) {
    filter(f, state, rate);
    smooth(f, state, rate);
  }
  dx[0] = 0; /* contact points stay on their walls */
  *(s->right == BEM_END_BED ? &dy[n - 1] : &dx[n - 1]) = 0;
  double sum = 0; /* one test for the whole rate: a value that is not finite spoils the sum */
  for (size_t k = 0; k < 3 * n; k++) sum += rate[k];
  CHECK(isfinite(sum), ERR_DIVERGED, "the rate of change of the surface is not finite");
  return OK;
}

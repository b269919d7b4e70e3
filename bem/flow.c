#include "bem/flow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bem/damping.h"
#include "common/base/array.h"

enum status bem_flow_reserve(struct bem_flow *f, size_t n) {
  TRY(bem_panels_reserve(&f->panels, n));
  TRY(bem_mesh_reserve(&f->mesh, n));
  TRY(bem_guess_begin(&f->guess, n));
  if (n > f->room) {
    free(f->psi);
    free(f->w);
    f->w = NULL;
    f->room = 0;
    TRY(array_create(&f->psi, 11 * n, "numbers of a flow"));
    TRY(array_create(&f->w, n, "velocities of a flow"));
    f->u = f->psi + n, f->v = f->u + n, f->tx = f->v + n, f->ty = f->tx + n, f->q = f->ty + n;
    f->damping = f->q + n;
    f->phi_round = f->damping + 3 * n;
    f->psi_round = f->phi_round + n;
    f->room = n;
  }
  memset(f->psi, 0, n * sizeof *f->psi); /* the guess of another mesh is worth nothing */
  return OK;
}

void bem_flow_destroy(struct bem_flow *f) {
  bem_panels_destroy(&f->panels);
  bem_guess_destroy(&f->guess);
  bem_solve_destroy(f->solve);
  bem_mesh_destroy(&f->mesh);
  bem_surface_destroy(&f->surface);
  free(f->psi);
  free(f->w);
  *f = (struct bem_flow){0};
}

enum status bem_flow_follow(struct bem_flow *view, const struct bem_flow *f) {
  const size_t n = f->surface.n;
  TRY(bem_surface_follow(&view->surface, &f->surface, n));
  view->level = f->level;
  TRY(bem_flow_reserve(view, n));
  memcpy(view->psi, f->psi, n * sizeof *f->psi);
  return OK;
}

/* One period of a closed chain: a current along the bed is no part of what Cauchy's integral holds
 * for, and is taken away before and added again. */
static enum status solve_round(struct bem_flow *f, const double *state, int keep) {
  const struct bem_surface *s = &f->surface;
  const size_t last = s->n - 1;
  const double *x = state, *y = x + s->n, *phi = y + s->n;
  const double current = bem_period_current(s, state);
  for (size_t k = 0; k < last; k++) {
    f->phi_round[k] = phi[k] - current * x[k];
    f->psi_round[k] = f->psi[k] - current * y[k];
  }
  bem_panels_set_round(&f->panels, last, x, y, &s->period);
  TRY(bem_solve_first(f->solve, &f->panels, f->phi_round, f->psi_round, keep));
  bem_panels_velocity(&f->panels, f->phi_round, f->psi_round, f->w);
  for (size_t k = 0; k < last; k++) {
    f->psi[k] = f->psi_round[k] + current * y[k];
    f->w[k] += current;
  }
  f->psi[last] = f->psi[0];
  f->w[last] = f->w[0];
  return OK;
}

static enum status solve_between_walls(struct bem_flow *f, const double *state, int keep) {
  const struct bem_surface *s = &f->surface;
  const size_t n = s->n;
  if (s->walls)
    TRY(bem_panels_set_walls(&f->panels, n, state, state + n, s->walls, s->side));
  else
    bem_panels_set(&f->panels, n, state, state + n, s->length);
  TRY(bem_solve_first(f->solve, &f->panels, state + 2 * n, f->psi, keep));
  bem_panels_velocity(&f->panels, state + 2 * n, f->psi, f->w);
  return OK;
}

enum status bem_flow_solve(struct bem_flow *f, const double *state, int keep) {
  const struct bem_surface *s = &f->surface;
  const size_t n = s->n;
  TRY((bem_surface_is_closed(s) ? solve_round : solve_between_walls)(f, state, keep));
  for (size_t k = 0; k < n; k++) {
    f->u[k] = creal(f->w[k]);
    f->v[k] = -cimag(f->w[k]);
  }
  bem_surface_hold_ends(s, f->u, f->v);
  f->w[0] = CMPLX(f->u[0], -f->v[0]);
  f->w[n - 1] = CMPLX(f->u[n - 1], -f->v[n - 1]);
  return OK;
}

enum status bem_flow_rates(struct bem_flow *f, double time, const double *state, double *rate) {
  const struct bem_surface *s = &f->surface;
  const size_t n = s->n;
  double *dx = rate, *dy = rate + n, *dphi = rate + 2 * n;
  bem_guess_make(&f->guess, time, f->psi);
  TRY(bem_flow_solve(f, state, 0));
  bem_guess_keep(&f->guess, time, f->psi);
  bem_mesh_velocity(&f->mesh, s, state, f->u, f->v, f->tx, f->ty, f->q);
  for (size_t k = 0; k < n; k++) {
    double u = f->u[k], v = f->v[k];
    dx[k] = u + f->q[k] * f->tx[k];
    dy[k] = v + f->q[k] * f->ty[k];
    dphi[k] =
        0.5 * (u * u + v * v) - (state[n + k] - f->level) + f->q[k] * (f->tx[k] * u + f->ty[k] * v);
  }
  bem_damping_add(f, state, rate);
  bem_surface_hold_ends(s, dx, dy);
  if (bem_surface_is_closed(s)) dphi[n - 1] = dphi[0];
  double sum = 0; /* one test for the whole rate: a value that is not finite spoils the sum */
  for (size_t k = 0; k < 3 * n; k++) sum += rate[k];
  CHECK(isfinite(sum), ERR_DIVERGED, "the rate of change of the surface is not finite");
  return OK;
}

#include "bem/water/flow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bem/water/damping.h"
#include "common/base/array.h"
#include "common/tank/tank.h"

enum status bem_flow_reserve(struct bem_flow *f, size_t n) {
  TRY(bem_panels_reserve(&f->panels, n));
  TRY(bem_mesh_reserve(&f->mesh, n));
  TRY(bem_guess_begin(&f->guess, n));
  if (n > f->room) {
    free(f->psi);
    free(f->w);
    free(f->known);
    f->w = NULL;
    f->known = NULL;
    f->room = 0;
    TRY(array_create(&f->psi, 13 * n, "numbers of a flow"));
    TRY(array_create(&f->w, n, "velocities of a flow"));
    TRY(array_create(&f->known, n, "velocities of a flow"));
    f->u = f->psi + n, f->v = f->u + n, f->tx = f->v + n, f->ty = f->tx + n, f->q = f->ty + n;
    f->damping = f->q + n;
    f->phi_own = f->damping + 3 * n;
    f->psi_own = f->phi_own + n;
    f->back = f->psi_own + n;
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
  bem_flux_destroy(&f->through);
  bem_moving_destroy(&f->moving);
  free(f->psi);
  free(f->w);
  free(f->known);
  *f = (struct bem_flow){0};
}

enum status bem_flow_follow(struct bem_flow *view, const struct bem_flow *f) {
  const size_t n = f->surface.n;
  TRY(bem_surface_follow(&view->surface, &f->surface, n));
  view->level = f->level;
  view->motion = f->motion;
  view->time = f->time;
  if (f->moving.map && f->surface.walls == f->moving.map) {
    TRY(bem_moving_follow(&view->moving, &f->moving));
    view->surface.walls = view->moving.map;
  }
  TRY(bem_flow_reserve(view, n));
  memcpy(view->psi, f->psi, n * sizeof *f->psi);
  return OK;
}

/* The rate of change, at a fixed place, is that of a tank that turns. */
static struct bem_part part_of_flux(const struct bem_flow *f, double complex zeta,
                                    double complex slope) {
  const double turn = f->motion.turn;
  double complex value, rise;
  bem_flux_at(&f->through, zeta, &value, &rise);
  if (f->motion.sides) return (struct bem_part){.beta = value, .w = rise * slope};
  return (struct bem_part){turn * value, turn * rise * slope, f->motion.turning * value, value};
}

struct bem_part bem_flow_part(const struct bem_flow *f, const double *state, double complex z,
                              double complex zeta, double complex slope) {
  if (bem_surface_is_closed(&f->surface)) {
    const double current = bem_period_current(&f->surface, state);
    return (struct bem_part){.beta = current * z, .w = current};
  }
  if (f->surface.walls && bem_flow_is_driven(f)) return part_of_flux(f, zeta, slope);
  return f->motion.sides ? bem_motion_part(&f->motion, z) : (struct bem_part){0};
}

static enum status set_flux(struct bem_flow *f) {
  const struct bem_conformal *walls = f->surface.walls;
  struct bem_rigid body[BEM_MOST_BENDS + 1];
  for (size_t i = 0; i <= walls->n; i++)
    body[i] = f->motion.sides ? bem_flow_body(f, i) : bem_motion_turn(&f->motion, 1);
  return bem_flux_set(&f->through, walls, body, f->motion.top);
}

enum status bem_flow_move(struct bem_flow *f, double time) {
  struct bem_surface *s = &f->surface;
  f->time = time;
  bem_motion_at(&f->motion, time);
  if (!f->motion.sides) return OK;
  if (s->walls) {
    if (s->walls != f->moving.map) TRY(bem_moving_start(&f->moving, f->motion.c, s->walls));
    s->walls = f->moving.map;
    return bem_moving_set(&f->moving, time);
  }
  s->left = f->motion.side[TANK_LEFT][0];
  s->tank = f->motion.side[TANK_RIGHT][0];
  if (s->right == BEM_END_BED) bem_motion_stop_short(&f->motion);
  s->length = f->motion.side[TANK_RIGHT][0] - s->left;
  return OK;
}

/* Takes over the nodes; *n: how many differ. */
static enum status set_panels(struct bem_flow *f, const double *state, size_t *n) {
  const struct bem_surface *s = &f->surface;
  const double *x = state, *y = x + s->n;
  *n = s->n;
  f->panels.smooth = s->smooth;
  if (s->walls) {
    for (int end = 0; end < 2; end++)
      f->panels.kinked[end] = f->motion.frame || f->motion.sides || s->blunt[end];
    return bem_panels_set_walls(&f->panels, *n, x, y, s->walls, s->side);
  }
  if (bem_surface_is_closed(s))
    bem_panels_set_round(&f->panels, --*n, x, y, &s->period);
  else {
    f->panels.held[0] = f->motion.sides;
    f->panels.held[1] = f->motion.sides && s->right == BEM_END_WALL;
    bem_panels_set(&f->panels, *n, x, y, s->left, s->length);
  }
  return OK;
}

/* What is known of beta is taken away before and added again. */
static enum status solve_rest(struct bem_flow *f, const double *state, size_t n, int keep) {
  const double *x = state, *y = x + f->surface.n, *phi = y + f->surface.n;
  const struct bem_panels *p = &f->panels;
  if (f->surface.walls && bem_flow_is_driven(f)) TRY(set_flux(f));
  for (size_t k = 0; k < n; k++) {
    const struct bem_part part = f->known[k] =
        bem_flow_part(f, state, CMPLX(x[k], y[k]), p->zeta[k], p->dzeta[k]);
    f->phi_own[k] = phi[k] - creal(part.beta);
    f->psi_own[k] = f->psi[k] - cimag(part.beta);
  }
  TRY(bem_solve_first(f->solve, &f->panels, f->phi_own, f->psi_own, keep));
  bem_panels_velocity(&f->panels, f->phi_own, f->psi_own, f->w);
  for (size_t k = 0; k < n; k++) {
    f->psi[k] = f->psi_own[k] + cimag(f->known[k].beta);
    f->w[k] += f->known[k].w;
  }
  return OK;
}

static enum status solve(struct bem_flow *f, const double *state, int keep) {
  const struct bem_surface *s = &f->surface;
  size_t n;
  TRY(set_panels(f, state, &n));
  if (bem_flow_has_part(f)) {
    TRY(solve_rest(f, state, n, keep));
  } else {
    TRY(bem_solve_first(f->solve, &f->panels, state + 2 * n, f->psi, keep));
    bem_panels_velocity(&f->panels, state + 2 * n, f->psi, f->w);
  }
  if (n < s->n) { /* the first node is the last one, too */
    f->psi[n] = f->psi[0];
    f->w[n] = f->w[0];
    f->known[n] = f->known[0];
  }
  return OK;
}

/* Velocity of the wall at an edge of the water, in the frame of the tank. */
static double complex wall_velocity(const struct bem_flow *f, bool right, double complex z) {
  const struct bem_surface *s = &f->surface;
  if (f->motion.sides && s->walls) return bem_rigid_at(f->moving.body[s->side[right]], z);
  return f->motion.sides ? f->motion.side[right ? TANK_RIGHT : TANK_LEFT][1] : 0;
}

/* Keeps the edges of the water on the walls, which may move, x and y being velocities in the frame
 * of the tank, or those that the potential has. */
static void hold_ends(const struct bem_flow *f, const double *state, bool of_potential, double *x,
                      double *y) {
  const size_t n = f->surface.n;
  double complex wall[2];
  for (int right = 0; right < 2; right++) {
    const size_t k = right ? n - 1 : 0;
    const double complex z = CMPLX(state[k], state[n + k]);
    wall[right] = wall_velocity(f, right, z);
    if (of_potential) wall[right] += bem_motion_carries(&f->motion, z);
    x[k] -= creal(wall[right]);
    y[k] -= cimag(wall[right]);
  }
  bem_surface_hold_ends(&f->surface, x, y);
  for (int right = 0; right < 2; right++) {
    x[right ? n - 1 : 0] += creal(wall[right]);
    y[right ? n - 1 : 0] += cimag(wall[right]);
  }
}

double bem_flow_head(const struct bem_flow *f, double x, double y) {
  return y - f->level - f->motion.push[0] * x - f->motion.push[1] * y;
}

enum status bem_flow_solve(struct bem_flow *f, const double *state, int keep) {
  const struct bem_surface *s = &f->surface;
  const size_t n = s->n;
  TRY(bem_flow_move(f, f->time));
  TRY(solve(f, state, keep));
  for (size_t k = 0; k < n; k++) {
    f->u[k] = creal(f->w[k]);
    f->v[k] = -cimag(f->w[k]);
  }
  hold_ends(f, state, true, f->u, f->v);
  f->w[0] = CMPLX(f->u[0], -f->v[0]);
  f->w[n - 1] = CMPLX(f->u[n - 1], -f->v[n - 1]);
  return OK;
}

enum status bem_flow_rates(struct bem_flow *f, double time, const double *state, double *rate) {
  const struct bem_surface *s = &f->surface;
  const size_t n = s->n;
  double *dx = rate, *dy = rate + n, *dphi = rate + 2 * n;
  f->time = time;
  bem_guess_make(&f->guess, time, f->psi);
  TRY(bem_flow_solve(f, state, 0));
  bem_guess_keep(&f->guess, time, f->psi);
  bem_mesh_velocity(&f->mesh, s, state, f->u, f->v, f->tx, f->ty, f->q);
  for (size_t k = 0; k < n; k++) {
    double u = f->u[k], v = f->v[k];
    dx[k] = u + f->q[k] * f->tx[k];
    dy[k] = v + f->q[k] * f->ty[k];
    if (f->motion.rolls) {
      const double complex carried = bem_motion_carries(&f->motion, CMPLX(state[k], state[n + k]));
      dx[k] -= creal(carried);
      dy[k] -= cimag(carried);
    }
    dphi[k] = 0.5 * (u * u + v * v) - bem_flow_head(f, state[k], state[n + k]) +
              f->q[k] * (f->tx[k] * u + f->ty[k] * v);
  }
  bem_damping_add(f, state, rate);
  hold_ends(f, state, false, dx, dy);
  if (bem_surface_is_closed(s)) dphi[n - 1] = dphi[0];
  double sum = 0; /* one test for the whole rate: a value that is not finite spoils the sum */
  for (size_t k = 0; k < 3 * n; k++) sum += rate[k];
  CHECK(isfinite(sum), ERR_DIVERGED, "the rate of change of the surface is not finite");
  return OK;
}

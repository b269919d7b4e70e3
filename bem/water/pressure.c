#include "bem/water/pressure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bem/kernel/integrals.h"
#include "common/base/array.h"

static const double NEAR = 1e-9; /* H: lengths that are the same */
enum { LEVELS = 4 };             /* of the panels on wet walls */

void bem_pressure_destroy(struct bem_pressure *p) {
  free(p->phi_t);
  bem_rule_destroy(&p->wet);
  bem_flux_destroy(&p->unit);
  bem_flux_destroy(&p->sweep.flux);
  bem_rule_destroy(&p->sweep.rule);
  free(p->sweep.nodes);
  free(p->sweep.wet);
  *p = (struct bem_pressure){0};
}

/* Where sides move, what is harmonic and has no flux through them is the rate of change of the own
 * part of beta at a fixed place of the mapped plane, which goes to and fro with the velocity w_p of
 * the known part, d zeta/dt = -w_p d zeta/dz: with that part's rate, beta_t = own rate - (w - w_p)
 * w_p + rate. What it has besides its own, of the potential: */
double bem_pressure_swept(const struct bem_flow *f, const struct bem_part *part, double complex z,
                          double complex w) {
  double rest = creal(part->rate);
  if (f->motion.sides && !f->surface.walls) rest -= creal((w - part->w) * part->w);
  if (f->motion.rolls) rest -= creal(w * bem_motion_carries(&f->motion, z));
  return rest;
}

/* Walls of any shape whose sides move: what is harmonic, with a known flux through walls that stay
 * where they are, is beta's rate of change at a fixed zeta, beta_t + w f_t, z = f(zeta, t). On a
 * side psi is that of a rigid body, and so its rate there. */
static enum status set_rate(struct bem_pressure *p, const struct bem_flow *f) {
  const struct bem_moving *m = &f->moving;
  struct bem_flux *flux = &p->sweep.flux;
  double complex *sweep = NULL;
  double before[BEM_MOST_BENDS + 1] = {0};
  bool driven[BEM_MOST_BENDS + 1];
  for (size_t i = 0; i <= m->map->n; i++)
    driven[i] = bem_rigid_moves(bem_flow_body(f, i)) || bem_rigid_moves(bem_flow_body_rate(f, i));
  TRY(bem_flux_lay(flux, m->map, driven, f->motion.top));
  const struct bem_rule *r = &flux->rule;
  const size_t n = BEM_RULE * r->panels;
  TRY(array_create(&sweep, 2 * n + 1, "rates of change of a map"));
  bem_sweep_rule(m, &p->sweep.rate, r, sweep, sweep + n);
  for (size_t j = 0; j < n; j++) {
    const size_t side = r->panel[j / BEM_RULE].side;
    const struct bem_rigid body = bem_flow_body(f, side), rate = bem_flow_body_rate(f, side);
    const double complex v = conj(bem_rigid_at(body, r->z[j]));
    flux->g[j] = bem_rigid_stream(rate, r->z[j]) + cimag(v * sweep[j]);
    flux->q[j] = cimag(conj(bem_rigid_at(rate, r->z[j])) * r->slope[j] + v * sweep[n + j] -
                       I * body.turn * conj(r->slope[j]) * sweep[j]);
  }
  free(sweep);
  for (size_t i = 0; i <= m->map->n; i++) { /* from the bends, where the sweep is their velocity */
    const size_t bend = i ? i : 1;
    if (!driven[i]) continue;
    double gain = 0;
    for (size_t j = 0; i == 0 && j < n; j++)
      if (r->panel[j / BEM_RULE].side == i) gain += r->weight[j] * flux->q[j];
    const double complex at = m->map->point[bend];
    before[i] = bem_rigid_stream(bem_flow_body_rate(f, i), at) +
                cimag(conj(bem_rigid_at(bem_flow_body(f, i), at)) * m->velocity[bend]) - gain;
  }
  bem_flux_fill(flux, before);
  return OK;
}

/* Adds to phi_t what makes it that of the harmonic part. */
static enum status sweep_nodes(struct bem_pressure *p, const struct bem_flow *f) {
  const struct bem_surface *s = &f->surface;
  const double complex *zeta = f->panels.zeta;
  double complex *sweep = p->sweep.nodes;
  TRY(bem_moving_rate(&f->moving, f->motion.rolls, &p->sweep.rate));
  TRY(set_rate(p, f));
  TRY(bem_sweep_wall(&f->moving, &p->sweep.rate, &p->sweep.rule, s->side[0], creal(zeta[0]),
                     1 / f->panels.dzeta[0], sweep));
  bem_sweep_along(&f->moving, &p->sweep.rate, &p->sweep.rule.gauss, s->n, zeta, sweep);
  for (size_t k = 0; k < s->n; k++) {
    double complex value, slope;
    bem_flux_at(&p->sweep.flux, zeta[k], &value, &slope);
    p->phi_t[k] += creal(f->w[k] * sweep[k] - value);
  }
  return OK;
}

enum status bem_pressure_solve(struct bem_pressure *p, struct bem_flow *f, const double *state) {
  const size_t n = f->surface.n;
  if (n > p->room) {
    TRY(array_resize(&p->phi_t, 2 * n, "numbers of a pressure"));
    p->psi_t = p->phi_t + n;
    TRY(array_resize(&p->sweep.nodes, n, "numbers of a pressure"));
    p->room = n;
  }
  for (size_t k = 0; k < n; k++) {
    const double u = f->u[k], v = f->v[k];
    p->phi_t[k] = -0.5 * (u * u + v * v) - bem_flow_head(f, state[k], state[n + k]);
    if (bem_flow_is_driven(f))
      p->phi_t[k] -= bem_pressure_swept(f, &f->known[k], CMPLX(state[k], state[n + k]), f->w[k]);
  }
  if (bem_pressure_is_swept(f)) TRY(sweep_nodes(p, f));
  memset(p->psi_t, 0,
         n * sizeof *p->psi_t); /* a row must not depend on which were asked for before */
  return bem_solve_again(f->solve, p->phi_t, p->psi_t);
}

/* Whether a point of the boundary of the tank is under water. */
static bool wet(const struct bem_surface *s, const double *state, double x, double y) {
  const size_t n = s->n;
  if (x < s->left - NEAR || x > s->tank + NEAR) return false; /* of the bed behind a piston */
  if (x < s->left + NEAR) return y < state[n];
  if (x > s->tank - NEAR) return s->right == BEM_END_WALL && y < state[2 * n - 1];
  return y < NEAR && (s->right == BEM_END_WALL || x < state[n - 1]);
}

/* A point of a side goes with it. */
static double complex moved(const struct bem_flow *f, double complex z) {
  const double right = f->motion.rest, x = creal(z);
  if (bem_pressure_is_swept(f)) return bem_moving_place(&f->moving, z);
  if (!f->motion.sides) return z;
  return CMPLX(x < NEAR ? f->surface.left : x > right - NEAR ? f->surface.tank : x, cimag(z));
}

/* Image of a point of the walls and d zeta / d z there. *under: whether
 * it is under water. */
static enum status map(const struct bem_flow *f, const double *state, double complex z, bool *under,
                       double complex *tau, double complex *dzeta) {
  const struct bem_surface *s = &f->surface;
  const struct bem_panels *p = &f->panels;
  double complex zeta;
  if (bem_surface_is_closed(s)) { /* the bed, the only wall */
    *under = true;
    *tau = bem_period_map(&s->period, z);
    *dzeta = bem_period_slope(&s->period, z);
    return OK;
  }
  if (!s->walls) {
    *under = wet(s, state, creal(z), cimag(z));
    *tau = creal(bem_map(s->length, z - s->left));
    *dzeta = bem_map_slope(s->length, z - s->left);
    return OK;
  }
  *under = bem_conformal_is_near(s->walls, z);
  if (!*under) return OK;
  TRY(bem_conformal_on_wall(s->walls, z, &zeta, dzeta));
  *tau = creal(zeta);
  *under = creal(zeta) > p->re[0] && creal(zeta) < p->re[s->n - 1];
  return OK;
}

enum status bem_pressure_at(struct bem_pressure *p, const struct bem_flow *f, const double *state,
                            double x, double y, double *pressure) {
  return bem_pressure_on(p, f, state, moved(f, CMPLX(x, y)), pressure);
}

/* u - i v of a bend of the walls, as the potential has it. */
static double complex bend_velocity(const struct bem_flow *f, const struct bem_seen *at) {
  const double complex carried = bem_motion_carries(&f->motion, at->z);
  return conj(bem_pressure_is_swept(f) ? at->sweep + carried : carried);
}

/* What the known part's and the own part's d beta/d zeta, the latter `own`, give phi where the
 * image of a bend moves: both of its sides stay then, and these are finite. */
static double shifted(const struct bem_pressure *p, const struct bem_flow *f,
                      const struct bem_seen *at, double complex own) {
  const struct bem_map_rate *rate = &p->sweep.rate;
  const double way = at->bend && !rate->drifts ? rate->xi[at->bend - 1] : 0;
  double complex value, slope;
  if (way == 0) return 0;
  bem_flux_at(&f->through, at->zeta, &value, &slope);
  return way * creal(own + slope);
}

double bem_pressure_seen(const struct bem_pressure *p, const struct bem_flow *f,
                         const double *state, const struct bem_seen *at) {
  const bool has_part = bem_flow_has_part(f);
  double complex value, slope, own;
  bem_integrals_inside(&f->panels, has_part ? f->phi_own : state + 2 * f->surface.n,
                       has_part ? f->psi_own : f->psi, at->zeta, &value, &own);
  const struct bem_part part = bem_flow_part(f, state, at->z, at->zeta, at->slope);
  const double complex w = at->bend ? bend_velocity(f, at) : own * at->slope + part.w;
  bem_integrals_inside(&f->panels, p->phi_t, p->psi_t, at->zeta, &value, &slope);
  double phi_t = creal(value);
  if (bem_flow_is_driven(f)) phi_t += bem_pressure_swept(f, &part, at->z, w);
  if (bem_pressure_is_swept(f)) {
    bem_flux_at(&p->sweep.flux, at->zeta, &value, &slope);
    phi_t += creal(value - w * at->sweep) + shifted(p, f, at, own);
  }
  return -phi_t - 0.5 * creal(w * conj(w)) - bem_flow_head(f, creal(at->z), cimag(at->z));
}

/* The map's point that bem_conformal_on_wall has taken a point of the walls for, 0 if none. */
static size_t find_bend(const struct bem_conformal *m, double xi, double complex slope) {
  size_t k = slope == 0 ? m->n : 0;
  while (k > 0 && m->xi[k - 1] != xi) k--;
  return k;
}

static enum status sweep_wall(struct bem_pressure *p, const struct bem_flow *f,
                              struct bem_seen *at) {
  const struct bem_moving *m = &f->moving;
  if (at->bend) {
    at->sweep = m->velocity[at->bend];
    return OK;
  }
  return bem_sweep_wall(m, &p->sweep.rate, &p->sweep.rule, bem_conformal_side(m->map, at->z),
                        creal(at->zeta), 1 / at->slope, &at->sweep);
}

enum status bem_pressure_on(struct bem_pressure *p, const struct bem_flow *f, const double *state,
                            double complex z, double *pressure) {
  struct bem_seen at = {.z = z};
  bool under;
  TRY(map(f, state, z, &under, &at.zeta, &at.slope));
  if (under && f->surface.walls) at.bend = find_bend(f->surface.walls, creal(at.zeta), at.slope);
  if (under && bem_pressure_is_swept(f)) TRY(sweep_wall(p, f, &at));
  *pressure = under ? bem_pressure_seen(p, f, state, &at) : 0;
  return OK;
}

enum status bem_pressure_wet(struct bem_pressure *p, const struct bem_flow *f) {
  const struct bem_surface *s = &f->surface;
  const struct bem_conformal *m = s->walls;
  struct bem_rule *wet = &p->wet;
  bem_rule_clear(wet);
  for (size_t i = s->side[0]; i <= s->side[1]; i++) {
    const double end[2] = {i == s->side[0] ? f->panels.re[0] : m->xi[i - 1],
                           i == s->side[1] ? f->panels.re[s->n - 1] : m->xi[i]};
    TRY(bem_rule_add(wet, m, i, end, LEVELS, f->level));
  }
  return OK;
}

enum status bem_pressure_wet_sweep(struct bem_pressure *p, const struct bem_flow *f) {
  const size_t n = BEM_RULE * p->wet.panels;
  if (!bem_pressure_is_swept(f)) return OK;
  if (n > p->sweep.wet_room) {
    TRY(array_resize(&p->sweep.wet, n, "rates of change of a map"));
    p->sweep.wet_room = n;
  }
  bem_sweep_rule(&f->moving, &p->sweep.rate, &p->wet, p->sweep.wet, NULL);
  return OK;
}

struct bem_seen bem_pressure_wet_point(const struct bem_pressure *p, const struct bem_flow *f,
                                       size_t j) {
  const struct bem_rule *wet = &p->wet;
  return (struct bem_seen){wet->z[j], wet->xi[j], 1 / wet->slope[j],
                           bem_pressure_is_swept(f) ? p->sweep.wet[j] : 0, 0};
}

#include "bem/pressure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bem/integrals.h"
#include "common/base/array.h"

static const double NEAR = 1e-9; /* H: lengths that are the same */
enum { LEVELS = 4 };             /* of the panels on wet walls */

void bem_pressure_destroy(struct bem_pressure *p) {
  free(p->phi_t);
  bem_rule_destroy(&p->wet);
  *p = (struct bem_pressure){0};
}

/* Where sides move, what is harmonic and has no flux through them is the rate of change of the own
 * part of beta at a fixed place of the mapped plane, which goes to and fro with the velocity w_p of
 * the known part, d zeta/dt = -w_p d zeta/dz: with that part's rate, beta_t = own rate - (w - w_p)
 * w_p + rate. What it has besides its own, of the potential: */
double bem_pressure_swept(const struct bem_flow *f, const struct bem_part *part, double complex z,
                          double complex w) {
  double rest = creal(part->rate);
  if (f->motion.sides) rest -= creal((w - part->w) * part->w);
  if (f->motion.rolls) rest -= creal(w * bem_motion_carries(&f->motion, z));
  return rest;
}

enum status bem_pressure_solve(struct bem_pressure *p, struct bem_flow *f, const double *state) {
  const size_t n = f->surface.n;
  if (n > p->room) {
    TRY(array_resize(&p->phi_t, 2 * n, "numbers of a pressure"));
    p->psi_t = p->phi_t + n;
    p->room = n;
  }
  for (size_t k = 0; k < n; k++) {
    const double u = f->u[k], v = f->v[k];
    p->phi_t[k] = -0.5 * (u * u + v * v) - bem_flow_head(f, state[k], state[n + k]);
    if (bem_flow_is_driven(f))
      p->phi_t[k] -= bem_pressure_swept(f, &f->known[k], CMPLX(state[k], state[n + k]), f->w[k]);
  }
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
static double moved(const struct bem_flow *f, double x) {
  const double right = f->motion.rest;
  if (!f->motion.sides) return x;
  return x < NEAR ? f->surface.left : x > right - NEAR ? f->surface.tank : x;
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

enum status bem_pressure_at(const struct bem_pressure *p, const struct bem_flow *f,
                            const double *state, double x, double y, double *pressure) {
  return bem_pressure_on(p, f, state, CMPLX(moved(f, x), y), pressure);
}

void bem_pressure_seen(const struct bem_pressure *p, const struct bem_flow *f, const double *state,
                       double complex z, double complex zeta, double complex dzeta,
                       double *pressure) {
  const bool has_part = bem_flow_has_part(f);
  double complex value, slope;
  bem_integrals_inside(&f->panels, has_part ? f->phi_own : state + 2 * f->surface.n,
                       has_part ? f->psi_own : f->psi, zeta, &value, &slope);
  const struct bem_part part = bem_flow_part(f, state, z, zeta, dzeta);
  const double complex w = slope * dzeta + part.w;
  bem_integrals_inside(&f->panels, p->phi_t, p->psi_t, zeta, &value, &slope);
  double phi_t = creal(value);
  if (bem_flow_is_driven(f)) phi_t += bem_pressure_swept(f, &part, z, w);
  *pressure = -phi_t - 0.5 * creal(w * conj(w)) - bem_flow_head(f, creal(z), cimag(z));
}

enum status bem_pressure_on(const struct bem_pressure *p, const struct bem_flow *f,
                            const double *state, double complex z, double *pressure) {
  double complex zeta, dzeta;
  bool under;
  *pressure = 0;
  TRY(map(f, state, z, &under, &zeta, &dzeta));
  if (under) bem_pressure_seen(p, f, state, z, zeta, dzeta, pressure);
  return OK;
}

enum status bem_pressure_wet(struct bem_pressure *p, const struct bem_flow *f) {
  const struct bem_surface *s = &f->surface;
  const struct bem_conformal *m = s->walls;
  bem_rule_clear(&p->wet);
  for (size_t i = s->side[0]; i <= s->side[1]; i++) {
    const double end[2] = {i == s->side[0] ? f->panels.re[0] : m->xi[i - 1],
                           i == s->side[1] ? f->panels.re[s->n - 1] : m->xi[i]};
    TRY(bem_rule_add(&p->wet, m, i, end, LEVELS, f->level));
  }
  return OK;
}

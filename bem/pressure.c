#include "bem/pressure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bem/integrals.h"
#include "common/base/array.h"

void bem_pressure_destroy(struct bem_pressure *p) {
  free(p->phi_t);
  *p = (struct bem_pressure){0};
}

enum status bem_pressure_solve(struct bem_pressure *p, struct bem_flow *f, const double *state) {
  const size_t n = f->surface.n;
  if (n > p->room) {
    bem_pressure_destroy(p);
    TRY(array_create(&p->phi_t, 2 * n, "numbers of a pressure")); /* zeros: GMRES's first guess */
    p->psi_t = p->phi_t + n;
    p->room = n;
  }
  for (size_t k = 0; k < n; k++) {
    double u = f->u[k], v = f->v[k];
    p->phi_t[k] = -0.5 * (u * u + v * v) - (state[n + k] - f->level);
  }
  return bem_solve_again(f->solve, p->phi_t, p->psi_t);
}

/* Whether a point of the boundary of the tank is under water. */
static bool wet(const struct bem_surface *s, const double *state, double x, double y) {
  const size_t n = s->n;
  const double near = 1e-9;
  if (x < near) return y < state[n];
  if (x > s->tank - near) return s->right == BEM_END_WALL && y < state[2 * n - 1];
  return y < near && (s->right == BEM_END_WALL || x < state[n - 1]);
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
    *tau = creal(bem_map(s->length, z));
    *dzeta = bem_map_slope(s->length, z);
    return OK;
  }
  TRY(bem_conformal_on_wall(s->walls, z, &zeta, dzeta));
  *tau = creal(zeta);
  *under = creal(zeta) > p->re[0] && creal(zeta) < p->re[s->n - 1];
  return OK;
}

enum status bem_pressure_at(const struct bem_pressure *p, const struct bem_flow *f,
                            const double *state, double x, double y, double *pressure) {
  const struct bem_surface *s = &f->surface;
  double complex tau, dzeta, value, slope;
  bool under;
  *pressure = 0;
  const bool closed = bem_surface_is_closed(s);
  TRY(map(f, state, CMPLX(x, y), &under, &tau, &dzeta));
  if (!under) return OK;
  bem_integrals_inside(&f->panels, closed ? f->phi_round : state + 2 * s->n,
                       closed ? f->psi_round : f->psi, tau, &value, &slope);
  double complex w = slope * dzeta + bem_period_current(s, state);
  bem_integrals_inside(&f->panels, p->phi_t, p->psi_t, tau, &value, &slope);
  *pressure = -creal(value) - 0.5 * creal(w * conj(w)) - (y - f->level);
  return OK;
}

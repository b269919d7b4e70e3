#include "bem/run/view.h"

#include <string.h>

#include "bem/water/forces.h"
#include "bem/water/spin.h"

enum status bem_view_create(struct bem_view *w, const struct bem_solve_options *options) {
  return bem_solve_create(options, &w->flow.solve);
}

void bem_view_destroy(struct bem_view *w) {
  bem_flow_destroy(&w->flow);
  bem_pressure_destroy(&w->pressure);
}

enum status bem_view_look(struct bem_view *w, const struct bem_flow *f, struct bem_stepper *stepper,
                          double time, int keep) {
  TRY(bem_flow_follow(&w->flow, f));
  w->flow.time = time;
  double *state = w->flow.surface.state;
  if (stepper)
    TRY(bem_stepper_interpolate(stepper, time, state));
  else
    memcpy(state, f->surface.state, 3 * f->surface.n * sizeof *state);
  return bem_flow_solve(&w->flow, state, keep);
}

static enum status add_known(struct bem_view *w, struct bem_totals *t, double momentum[2]) {
  double kinetic, known[2];
  TRY(bem_pressure_wet(&w->pressure, &w->flow));
  bem_forces_of_known(&w->flow, &w->pressure.wet, &kinetic, known);
  t->kinetic += kinetic;
  for (int axis = 0; axis < 2; axis++) momentum[axis] += known[axis];
  return OK;
}

/* Momentum and, where the tank turns, kinetic energy in its frame. */
static enum status find_motion(struct bem_view *w, struct bem_totals *t, double momentum[2]) {
  struct bem_flow *f = &w->flow;
  struct bem_spin spin;
  bem_forces_momentum(f, f->surface.state, momentum);
  if (bem_pressure_is_swept(f)) TRY(add_known(w, t, momentum));
  if (!f->motion.rolls) return OK;
  TRY(bem_spin_find(&w->pressure, f, f->surface.state, t->kinetic, &spin));
  memcpy(momentum, spin.momentum, sizeof spin.momentum);
  t->kinetic = spin.kinetic;
  return OK;
}

/* Of the kinetic energy the surface's integral leaves out, where sides move, what is theirs. With
 * phi = own + known, and own psi = 0 on the walls, Green's formula gives it by the surface, too. */
static struct bem_totals totals_of(struct bem_flow *f) {
  const struct bem_surface *s = &f->surface;
  const double *x = s->state, *y = x + s->n, *phi = y + s->n;
  struct bem_totals t = bem_surface_totals(s, f->psi);
  if (!f->motion.sides) return t;
  for (size_t k = 0; k < s->n; k++) { /* q and tx are scratch here */
    f->q[k] = phi[k] - f->phi_own[k];
    f->tx[k] = f->psi[k] - f->psi_own[k];
  }
  t.kinetic += 0.5 * (bem_surface_integral(s, f->phi_own, f->tx) -
                      bem_surface_integral(s, f->q, f->psi_own));
  if (!s->walls) t.kinetic += bem_motion_kinetic(&f->motion, (const double[2]){y[0], y[s->n - 1]});
  return t;
}

enum status bem_view_totals(struct bem_view *w, struct bem_totals *t, double momentum[2]) {
  *t = totals_of(&w->flow);
  return find_motion(w, t, momentum);
}

static enum status find_frame_power(struct bem_view *w, double *power) {
  struct bem_flow *f = &w->flow;
  struct bem_totals t = {0};
  struct bem_spin spin;
  double momentum[2];
  if (f->motion.rolls) {
    TRY(bem_spin_find(&w->pressure, f, f->surface.state, 0, &spin));
    *power = -bem_spin_power(f, &spin);
    return OK;
  }
  TRY(find_motion(w, &t, momentum));
  *power = -(f->motion.push[0] * momentum[0] + f->motion.push[1] * momentum[1]);
  return OK;
}

enum status bem_view_powers(struct bem_view *w, double power[2]) {
  struct bem_flow *f = &w->flow;
  const double *state = f->surface.state;
  double force[2];
  TRY(find_frame_power(w, &power[0]));
  power[1] = 0;
  if (!f->motion.sides) return OK;
  TRY(bem_pressure_solve(&w->pressure, f, state));
  if (bem_pressure_is_swept(f)) return bem_forces_power(&w->pressure, f, state, &power[1]);
  TRY(bem_forces_on_sides(&w->pressure, f, state, force));
  for (int side = 0; side < 2; side++) power[1] += force[side] * f->motion.side[side][1];
  return OK;
}

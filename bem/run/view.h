/* A state within the last step, which the run never sees: what is written, and what the water has
 * given away, is found of it. */
#pragma once
#include "bem/run/stepper.h"
#include "bem/water/flow.h"
#include "bem/water/pressure.h"

struct bem_view {
  struct bem_flow flow; /* the state and its velocities */
  struct bem_pressure pressure;
};

enum status bem_view_create(struct bem_view *w, const struct bem_solve_options *options);
void bem_view_destroy(struct bem_view *w);

/* Looks at the state of *f at a time of its last step, sqrt(H/g), by CVODE's interpolation, and
 * solves for its psi and velocities. stepper NULL: as it is. keep: the matrix, for the pressure. */
enum status bem_view_look(struct bem_view *w, const struct bem_flow *f, struct bem_stepper *stepper,
                          double time, int keep);

/* Of what is looked at, whose scratch it takes: volume, energies and momentum; where the tank turns
 * both of the motion in its frame. */
enum status bem_view_totals(struct bem_view *w, struct bem_totals *t, double momentum[2]);

/* Powers that the water gives to a tank, by the force on it in the frame of that, and to sides that
 * move, rho g H^3 sqrt(g/H). */
enum status bem_view_powers(struct bem_view *w, double power[2]);

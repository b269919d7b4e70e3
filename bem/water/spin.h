/* Water in a tank that turns: its motion in the frame of the tank is no gradient, and what of it is
 * asked for needs the potential on the walls as well. Green's formula gives that by the potential
 * of a tank that turns at the rate of one, which is known. */
#pragma once
#include "bem/water/pressure.h"

/* In the frame of the tank, about the point that it turns about: integrals over the water of q^2/2,
 * the velocity, r x u, r . u, and r^2. H, g and rho = 1. */
struct bem_spin {
  double kinetic, momentum[2], spin, swing, inertia;
};

/* After bem_flow_solve. kinetic: energy that does not go with the frame, where sides move. q, tx
 * and ty of f are used as scratch. ERR_MEMORY, ERR_SOLVER. */
enum status bem_spin_find(struct bem_pressure *p, struct bem_flow *f, const double *state,
                          double kinetic, struct bem_spin *out);

/* Power of the forces that the water feels in a tank that moves and turns, but for its weight down
 * the tank, rho g H^2 sqrt(gH). */
double bem_spin_power(const struct bem_flow *f, const struct bem_spin *s);

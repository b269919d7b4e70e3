/* Particles on a line without end at rest, dx = h, cubic B-spline, h = c = rho_f = 1: the equations
 * of T's section 3.4 with treatments, particle by particle as a program has them,
 *     rho_a  = sum m W  (2.16), or  rho_a' = sum m (u_a - u_b) W'  (3.20)
 *     u_a'   = -sum m (P_a/rho_a^2 + P_b/rho_b^2) W' (1 - tensile (W/W(h))^4)  (2.15), (3.57)
 *     x_a'   = u_a + xsph sum (u_b - u_a) 2 m/(rho_a + rho_b) W
 * with P = rho - 1, the factor of (3.57) where both pressures are negative. */
#pragma once
#include <stdbool.h>

#include "theory/linear.h"

struct theory_chain {
  bool advanced; /* the density's rate is integrated */
  double xsph, tensile;
  double tension; /* 1 - rho of rest */
};

/* What they make of (x, u), or (x, u, rho), for perturbations e^(wave a) of particle a: derivatives
 * by complex steps, exact to rounding. */
struct theory_matrix theory_chain_rates(const struct theory_chain *c, double complex wave);

/* Harmonic functions in water of any shape in a tank of one wall, without a flux through it, from
 * what they are on the surface. With psi, which is zero along the wall, f = phi + i psi is
 * analytic, and at a point z_j of the rim
 *     oint (f(z) - f_j)/(z - z_j) dz = 0,
 * of which the real part is a Fredholm equation of the second kind where psi is sought and the
 * imaginary one where phi is (Vinje & Brevig, Adv. Water Resour. 4, 1981). f is linear on straight
 * panels, so that it is found to the second order of their length; inside it and its derivative
 * are Cauchy's integrals of those, exact for them however near the rim. Between periodic sides
 * all of that is in the plane of exp(-2 pi i z/length), where surface and bed are closed. */
#pragma once
#include "common/flow/flow.h"
#include "common/flow/line.h"

struct flow_cauchy;

/* With panels of about `spacing`, m. Finds the potential of the line, and lift: of p/(rho g) + y +
 * |u|^2/2g, m, by Bernoulli's equation minus the rate of that potential over g. ERR_MEMORY,
 * ERR_SOLVER; *out is NULL then. */
enum status flow_cauchy_create(const struct case_file *c, const struct flow_line *line,
                               double spacing, struct flow_cauchy **out);
void flow_cauchy_destroy(struct flow_cauchy *a); /* NULL is fine */

struct flow_inside {
  bool is;                       /* in the water: else all is zero */
  double phi, lift, velocity[2]; /* m^2/s, m, m/s */
};
struct flow_inside flow_cauchy_at(const struct flow_cauchy *a, double x, double y);

/* Cauchy's integral over the surface and its mirror image, one collocation node at a time. With
 * beta at the node subtracted, sum over the contour of integral (beta(t) - beta_k) / (t - zeta_k)
 * dt = 0; its real part is an equation of the second kind for psi. */
#pragma once
#include "bem/kernel/panels.h"

/* The equation of node k: sum_m a[m] psi[m] = sum_m b[m] phi[m]; a, b: [p->n].
 * Panels nearer than a few of their lengths are integrated exactly (recursion from one complex
 * logarithm), the others by the fourth-order quadrature that their nodes carry: beta(t) - beta_k
 * over t - zeta_k is smooth there, and neither costs a logarithm. */
void bem_integrals_row(const struct bem_panels *p, size_t k, double *a, double *b);

/* Value and derivative d/dzeta at any point tau inside or on a wall of the analytic function whose
 * nodal values are f + i h. */
void bem_integrals_inside(const struct bem_panels *p, const double *f, const double *h,
                          double complex tau, double complex *value, double complex *slope);

enum { BEM_VALUES = 3 };

/* Values alone, of up to BEM_VALUES such functions f[i] + i h[i] at once: panels that are not near
 * go without logarithms, as in the equations. As exact near the surface as far from it, since all
 * that is interpolated along a panel is continuous from one to the next. */
void bem_integrals_values(const struct bem_panels *p, size_t count, const double *const *f,
                          const double *const *h, double complex tau, double complex *value);

/* Harmonic functions in water over the flat bed of a rectangular tank, without a flux through its
 * walls, from what they are on the surface: sum (a_n cos k_n X + b_n sin k_n X) cosh k_n Y/cosh k_n
 * D, X from the left side, Y from the bed, D the highest of the surface; k_n = n pi over the width,
 * or between periodic sides 2 n pi, and sines only there. Coefficients by least squares at four
 * times as many points as there are (LAPACK's dgelsy, since the highest terms are hardly seen in
 * the troughs). */
#pragma once
#include <stddef.h>

#include "common/flow/flow.h"

struct flow_harmonic;

struct flow_harmonic_value {
  double x, y, value; /* m, and of the function */
};

/* ERR_MEMORY, ERR_SOLVER; *out is NULL then. */
enum status flow_harmonic_create(const struct case_file *c, size_t terms, size_t n,
                                 const struct flow_harmonic_value *at, struct flow_harmonic **out);
void flow_harmonic_destroy(struct flow_harmonic *h); /* NULL is fine */

/* The function that is y on the surface at t = 0: p/(rho g) + y of water at rest that is let go. */
enum status flow_harmonic_of_surface(const struct flow_water *w, size_t terms,
                                     struct flow_harmonic **out);

/* The function, and its gradient if that is not NULL. */
double flow_harmonic_at(const struct flow_harmonic *h, double x, double y, double *gradient);

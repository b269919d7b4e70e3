/* Not-a-knot cubic splines. */
#pragma once
#include <stddef.h>

/* Second derivatives of the spline through f at the increasing abscissae s; f, s, second: [n], n >=
 * 4; scratch: [n]. */
void bem_spline_fit(size_t n, const double *s, const double *f, double *second, double *scratch);

/* Its value at `at`; *from is where the search starts and is left at the interval found. */
double bem_spline_value(size_t n, const double *s, const double *f, const double *second, double at,
                        size_t *from);

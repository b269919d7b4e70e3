/* Not-a-knot and periodic cubic splines. */
#pragma once
#include <stddef.h>

#include "common/base/status.h"

/* Second derivatives of the splines through n_f functions f[i] at the increasing abscissae s; s,
 * f[i]: [n], n >= 4; second: [n_f][n]; scratch: [3n]. ERR_SOLVER when its equations are singular.
 */
enum status bem_spline_fit(size_t n, const double *s, size_t n_f, const double *const *f,
                           double *second, double *scratch);

/* The same of functions whose slopes are periodic: what f[i] gains from the first abscissa to the
 * last it gains again. */
enum status bem_spline_fit_round(size_t n, const double *s, size_t n_f, const double *const *f,
                                 double *second, double *scratch);

/* Value of one of them at `at`; *from is where the search starts and is left at the interval found.
 */
double bem_spline_value(size_t n, const double *s, const double *f, const double *second, double at,
                        size_t *from);

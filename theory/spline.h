/* The cubic B-spline on a line (T, eq. 2.111), support 2h, and sums over particles spaced dx. */
#pragma once
#include <complex.h>

double theory_spline(double q);       /* h W, q = |x|/h */
double theory_spline_slope(double q); /* h^2 dW/dx at x = q h, q of either sign */
/* The same of complex q, for derivatives by complex steps: the piece is that of its real part. */
double complex theory_spline_at(double complex q);
double complex theory_spline_slope_at(double complex q);

/* sum_b dx W(x_b) e^(kappa x_b) and h sum_b dx W'(0 - x_b) e^(kappa x_b) about a particle at 0,
 * with kappa h = `wave` and h/dx = `ratio`: what interpolation and its derivative make of e^(kappa
 * x). */
double complex theory_spline_symbol(double complex wave, double ratio);
double complex theory_spline_slope_symbol(double complex wave, double ratio);

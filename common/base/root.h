/* Roots of functions of one variable. */
#pragma once

/* Where f(x, with) changes its sign between low and high, to the last bit, by bisection: sixty
 * evaluations, and nothing that could go wrong. NaN when it has the same sign at both. */
double root_between(double (*f)(double x, const void *with), const void *with, double low,
                    double high);

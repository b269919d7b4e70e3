/* Numbers of a curve, which formulas name as functions. */
#pragma once
#include "gallery/source.h"

/* X(name, number of arguments behind the curve, help) */
#define GALLERY_REDUCTIONS(X)                                                                      \
  X(at, 1, "y at x, linear between points; NaN outside")                                           \
  X(first, 0, "y of the first point")                                                              \
  X(last, 0, "y of the last point")                                                                \
  X(start, 0, "x of the first point")                                                              \
  X(end, 0, "x of the last point")                                                                 \
  X(count, 0, "how many points")                                                                   \
  X(least, 2, "least y for x0 <= x <= x1")                                                         \
  X(most, 2, "greatest y")                                                                         \
  X(where_least, 2, "x of the least y")                                                            \
  X(where_most, 2, "x of the greatest y")                                                          \
  X(mean, 2, "mean of y, by points")                                                               \
  X(median, 2, "median of y")                                                                      \
  X(rms, 2, "root mean square of y, by points")                                                    \
  X(std, 2, "standard deviation of y, by points")                                                  \
  X(integral, 2, "integral of y over x, by trapezia")                                              \
  X(crosses, 1, "first x where y passes the level, linear; NaN: never")                            \
  X(slope, 2, "slope of the straight line fitted")                                                 \
  X(growth, 2, "slope of ln |y| from where it is above `low` for good to where it is above `high`")\
  X(frequency, 3, "angular frequency, within 25 % of a guess, of the a cos + b sin + c that fits") \
  X(cosh_rate, 3, "w, within 25 % of a guess, of the a cosh(w x) that fits best")                  \
  X(amplitude, 3, "of the a cos(w x) + b sin(w x) + c that fits best: sqrt(a^2 + b^2)")            \
  X(phase, 3, "of the same: of A cos(w x - phase), -pi to pi")                                     \
  X(residual, 3, "of the same: rms of what is left")                                               \
  X(rises, 2, "1 if y rises from point to point, else 0")                                          \
  X(falls, 2, "1 if y falls from point to point, else 0")                                          \
  X(signs, 0, "changes of the sign of y")                                                          \
  X(beyond, 1, "share of the sum of y^2 at abscissas above x")

/* Curves have their points by rising x (others: docs of a source). Points whose y is NaN count for
 * nothing. NaN where there is no such number. */
#define X(name, n, help) double gallery_reduce_##name(const struct gallery_curve *c, const double *a);
GALLERY_REDUCTIONS(X)
#undef X

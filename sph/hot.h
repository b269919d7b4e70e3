/* For the hot loops. */
#pragma once

/* Choices that a caller knows fold away. */
#define SPECIALISE static inline __attribute__((always_inline))

/* fmax and fmin, which are calls unless NaN is ruled out; these vectorise. When a is not a number,
 * they return b: written larger(new, so_far) they skip it. */
SPECIALISE double larger(double a, double b) {
  return a > b ? a : b;
}

SPECIALISE double smaller(double a, double b) {
  return a < b ? a : b;
}

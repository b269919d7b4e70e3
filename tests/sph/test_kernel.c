#include "tests/test.h"

#include <fenv.h>

#include "sph/pair/kernel.h"

/* Lengths in h. A number of either precision carries half of this. */
static const double eps = sizeof(real) == sizeof(double) ? 2.2e-16 : 1.2e-7;

static double value(enum sph_kernel k, double q) {
  return kernel_value_scale(k) * kernel_value(k, vec_of((real)(q * q)))[0];
}

static double slope(enum sph_kernel k, double q) {
  return kernel_slope_scale(k) * kernel_slope(k, vec_of((real)(q * q)))[SPH_REALS - 1];
}

/* Simpson's rule: the integrand is smooth, 2000 intervals leave an error below 1e-12; the rounding
 * of values that are positive cannot add up to more than their own, a few units. */
static void test_kernel_integrates_to_one_over_the_plane(void) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++) {
    const int n = 2000;
    double dq = kernel_support((enum sph_kernel)k) / n, sum = 0;
    for (int i = 0; i <= n; i++) {
      double q = i * dq, weight = i == 0 || i == n ? 1 : i % 2 ? 4 : 2;
      sum += weight * 2 * M_PI * q * value((enum sph_kernel)k, q);
    }
    EXPECT_NEAR(sum * dq / 3, 1, 1e-12 + 4 * eps);
  }
}

/* grad_i W = slope r_ji, hence slope = -W'(q)/q. Central difference of fourth order: error
 * dq^4/30 of the fifth derivative, which is 10.4 at most for the Gaussian, and the rounding of
 * values of 0.3 at most over dq; the steps balance the two. */
static void test_kernel_slope_is_the_derivative_of_its_value(void) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++)
    for (double q = 0.05; q < 0.98 * kernel_support((enum sph_kernel)k); q += 0.0731) {
      const double dq = sizeof(real) == sizeof(double) ? 2e-3 : 0.04;
      const double near = value((enum sph_kernel)k, q + dq) - value((enum sph_kernel)k, q - dq);
      const double far =
          value((enum sph_kernel)k, q + 2 * dq) - value((enum sph_kernel)k, q - 2 * dq);
      const double dW = (8 * near - far) / (12 * dq);
      EXPECT_NEAR(slope((enum sph_kernel)k, q) * q, -dW, dq * dq * dq * dq / 2 + eps / dq);
      EXPECT(slope((enum sph_kernel)k, q) > 0);
    }
}

static void test_kernel_vanishes_at_the_edge_of_its_support(void) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++)
    EXPECT_NEAR(value((enum sph_kernel)k, kernel_support((enum sph_kernel)k)), 0, eps);
}

/* What vec.h states: the polynomial's error, s times the rounding of s/ln 2, and the last
 * operations. */
static void test_exponential_is_as_accurate_as_its_numbers(void) {
  double worst = 0, polynomial = sizeof(real) == sizeof(double) ? 3e-16 : 1.02e-7;
  for (double s = 0; s <= 9; s += 1e-4) {
    real of = (real)s;
    double e = vec_exp_minus(vec_of(of))[0] / exp(-(double)of) - 1;
    worst = fmax(worst, fabs(e) - polynomial - (1 + s) * eps);
  }
  EXPECT(worst <= 0);
}

#ifdef PLUNGE_TRAP_FLOATS
static void test_kernel_does_not_overflow_far_away(void) {
  feclearexcept(FE_ALL_EXCEPT);
  for (int k = 0; k < SPH_KERNEL_COUNT; k++)
    for (double q = 1; q < 1e4; q *= 2)
      EXPECT(isfinite(slope((enum sph_kernel)k, q)) && isfinite(value((enum sph_kernel)k, q)));
  EXPECT(!fetestexcept(FE_OVERFLOW | FE_INVALID));
}
#endif

int main(void) {
#ifdef PLUNGE_TRAP_FLOATS
  RUN(test_kernel_does_not_overflow_far_away);
#endif
  RUN(test_kernel_integrates_to_one_over_the_plane);
  RUN(test_kernel_slope_is_the_derivative_of_its_value);
  RUN(test_kernel_vanishes_at_the_edge_of_its_support);
  RUN(test_exponential_is_as_accurate_as_its_numbers);
  return TEST_RESULT;
}

#include "tests/test.h"

#include <fenv.h>

#include "sph/pair/kernel.h"

static const double h = 0.2385;

static double value(enum sph_kernel k, double r) {
  vec q2 = (vec){0} + r * r / (h * h);
  return kernel_value_scale(k, h) * kernel_value(k, q2)[3];
}

static double slope(enum sph_kernel k, double r) {
  vec q2 = (vec){0} + r * r / (h * h);
  return kernel_slope_scale(k, h) * kernel_slope(k, q2)[5];
}

/* Simpson's rule in r: the integrand is smooth, 2000 intervals leave an error below 1e-12. */
static void test_kernel_integrates_to_one_over_the_plane(void) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++) {
    const int n = 2000;
    double R = kernel_support((enum sph_kernel)k) * h, dr = R / n, sum = 0;
    for (int i = 0; i <= n; i++) {
      double r = i * dr, weight = i == 0 || i == n ? 1 : i % 2 ? 4 : 2;
      sum += weight * 2 * M_PI * r * value((enum sph_kernel)k, r);
    }
    EXPECT_NEAR(sum * dr / 3, 1, 1e-12);
  }
}

/* grad_i W = slope r_ji, hence slope = -W'(r)/r. Central difference, error (dr/h)^2 W'''/6 h. */
static void test_kernel_slope_is_the_derivative_of_its_value(void) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++)
    for (double r = 0.05 * h; r < 0.98 * kernel_support((enum sph_kernel)k) * h; r += 0.0731 * h) {
      double dr = 1e-4 * h;
      double dW =
          (value((enum sph_kernel)k, r + dr) - value((enum sph_kernel)k, r - dr)) / (2 * dr);
      EXPECT_NEAR(slope((enum sph_kernel)k, r) * h * h * h * h, -dW / r * h * h * h * h, 2e-8);
      EXPECT(slope((enum sph_kernel)k, r) > 0);
    }
}

static void test_kernel_vanishes_at_the_edge_of_its_support(void) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++)
    EXPECT_NEAR(value((enum sph_kernel)k, kernel_support((enum sph_kernel)k) * h) * h * h, 0,
                1e-15);
}

/* The bound that vec.h states. */
static void test_exponential_is_accurate_to_4e_14(void) {
  double worst = 0;
  for (double s = 0; s <= 9; s += 1e-4) {
    double e = vec_exp_minus((vec){0} + s)[0] / exp(-s) - 1;
    worst = fmax(worst, fabs(e));
  }
  EXPECT_NEAR(worst, 0, 4e-14);
}

#ifdef PLUNGE_TRAP_FLOATS
static void test_kernel_does_not_overflow_far_away(void) {
  feclearexcept(FE_ALL_EXCEPT);
  for (int k = 0; k < SPH_KERNEL_COUNT; k++)
    for (double r = h; r < 1e4 * h; r *= 2)
      EXPECT(isfinite(slope((enum sph_kernel)k, r)) && isfinite(value((enum sph_kernel)k, r)));
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
  RUN(test_exponential_is_accurate_to_4e_14);
  return TEST_RESULT;
}

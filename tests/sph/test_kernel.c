#include "tests/test.h"

#include <fenv.h>
#include <string.h>

#include "sph/pair/kernel.h"

/* Lengths in h. A number of either precision carries half of this. */
static const double eps = sizeof(real) == sizeof(double) ? 2.2e-16 : 1.2e-7;

/* At (x, y), in units of h. */
static double value_at(enum sph_kernel k, double x, double y) {
  const vec X = vec_of((real)x), Y = vec_of((real)y);
  return kernel_value_scale(k) * kernel_value(k, X, Y, X * X + Y * Y)[0];
}

static double slope_at(enum sph_kernel k, double x, double y) {
  const vec X = vec_of((real)x), Y = vec_of((real)y);
  return kernel_slope_scale(k) * kernel_slope(k, X, Y, X * X + Y * Y)[SPH_REALS - 1];
}

/* Along x. */
static double fall_at(enum sph_kernel k, double x, double y) {
  vec gx, gy;
  if (kernel_is_radial(k)) return slope_at(k, x, y) * x;
  kernel_gradient(k, vec_of((real)x), vec_of((real)y), &gx, &gy);
  return kernel_slope_scale(k) * gx[0];
}

static bool is_in_reach(enum sph_kernel k, double x, double y) {
  const vec X = vec_of((real)x), Y = vec_of((real)y);
  return kernel_reach2(k, X, Y, X * X + Y * Y)[0] < kernel_cutoff2(k);
}

/* How far from the axis the support reaches along it. */
static double half_width(enum sph_kernel k) {
  return kernel_is_radial(k) ? kernel_support(k) : kernel_support(k) / M_SQRT2;
}

static double simpson(int i, int n) {
  return i == 0 || i == n ? 1. / 3 : i % 2 ? 4. / 3 : 2. / 3;
}

/* Simpson's rule. Kernels are polynomials or smooth between the circles or lines q = 0, 1, 2, 3, on
 * which intervals end, and their second derivative is continuous: along a line that crosses such a
 * circle within an interval the error is d^3 = 2e-5 of a jump, and their signs vary from line to
 * line. The rounding of values that are positive cannot add up to more than their own, a few units.
 */
static void test_kernel_integrates_to_one_over_the_plane(void) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++) {
    const enum sph_kernel kernel = (enum sph_kernel)k;
    const int n = 1200;
    const double d = 3. / n;
    double along = 0, round = 0;
    for (int i = 0; i <= n; i++) {
      for (int j = 0; j <= n && !kernel_is_radial(kernel); j++)
        if (is_in_reach(kernel, i * d, j * d))
          round += 4 * simpson(i, n) * simpson(j, n) * value_at(kernel, i * d, j * d) * d * d;
      if (kernel_is_radial(kernel) && is_in_reach(kernel, i * d, 0))
        along += simpson(i, n) * 2 * M_PI * i * d * value_at(kernel, i * d, 0) * d;
    }
    EXPECT_NEAR(along + round, 1, 1e-10 + 4 * eps);
  }
}

/* What W falls by from a point to another is the integral of its gradient between them, here by
 * Simpson's rule on steps of 0.0731/64: where the integrand has a kink, the error is 1e-10 of it.
 */
static void test_kernel_falls_as_its_gradient_says(void) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++)
    for (double y = 0; y < 1.5; y += 0.37)
      for (double x = -1.2; x < 1.2; x += 0.0731) {
        const enum sph_kernel kernel = (enum sph_kernel)k;
        const int n = 64;
        const double d = 0.0731 / n;
        double fall = 0;
        for (int i = 0; i <= n; i++) fall += simpson(i, n) * d * fall_at(kernel, x + i * d, y);
        EXPECT_NEAR(value_at(kernel, x, y) - value_at(kernel, x + n * d, y), fall, 1e-9 + 8 * eps);
      }
}

/* slope = (x, y) . grad_i W / q^2 > 0, also where the two meet: there it is -W'' of the smooth
 * kernel, by a difference whose error is 1e-3 of the third derivative, below 30 here. */
static void test_kernel_slope_is_along_the_pair(void) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++) {
    const enum sph_kernel kernel = (enum sph_kernel)k;
    for (double x = -1.3; x < 1.31; x += 0.1)
      for (double y = -1.35; y < 1.36; y += 0.1) {
        double along = fall_at(kernel, x, y) * x + fall_at(kernel, y, x) * y;
        EXPECT_NEAR(slope_at(kernel, x, y) * (x * x + y * y), along, 16 * eps);
        EXPECT(slope_at(kernel, x, y) > 0);
      }
    EXPECT_NEAR(slope_at(kernel, 0, 0), fall_at(kernel, 1e-3, 0) / 1e-3, 0.03);
  }
}

static void test_kernel_vanishes_at_the_edge_of_its_support(void) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++) {
    const enum sph_kernel kernel = (enum sph_kernel)k;
    const double edge = half_width(kernel);
    EXPECT_NEAR(value_at(kernel, edge, 0), 0, 8 * eps);
    EXPECT(is_in_reach(kernel, 0.999 * edge, 0) && !is_in_reach(kernel, 1.001 * edge, 0));
    EXPECT(is_in_reach(kernel, edge * 0.7, edge * 0.7));
    EXPECT(!is_in_reach(kernel, 0, 1.0001 * kernel_support(kernel)));
  }
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
      EXPECT(isfinite(slope_at((enum sph_kernel)k, q, q)) &&
             isfinite(value_at((enum sph_kernel)k, q, q)));
  EXPECT(!fetestexcept(FE_OVERFLOW | FE_INVALID));
}
#endif

/* w and dw/dx of the tensor's spline, x = (x_a - x_b)/h. */
static double spline_at(double x) {
  return fabs(x) < 2 ? kernel_spline(vec_of((real)fabs(x)))[0] / 6 : 0;
}

static double spline_slope_at(double x) {
  return fabs(x) < 2 ? -copysign(kernel_spline_fall(vec_of((real)fabs(x)))[0] / 2, x) : 0;
}

/* Interpolation of f = sin(x + 0.3) and its slope at x on a line of particles that u = cos(1.7 x)
 * has carried for the time t, with their first volumes and with m over the summed density. */
static void interpolate(double x, double h, double t, double sum[4]) {
  double at[9], X = x;
  for (int i = 0; i < 8; i++) X = x - cos(1.7 * X) * t;
  for (int j = 0; j < 9; j++) at[j] = X + (j - 4) * h + cos(1.7 * (X + (j - 4) * h)) * t;
  memset(sum, 0, 4 * sizeof *sum);
  for (int j = 2; j < 7; j++) {
    double density = 0, r = (x - at[j]) / h, f = sin(at[j] + 0.3);
    for (int k = 0; k < 9; k++) density += spline_at((at[j] - at[k]) / h);
    sum[0] += f * spline_at(r);
    sum[1] += f * spline_at(r) / density;
    sum[2] += f * spline_slope_at(r) / h;
    sum[3] += f * spline_slope_at(r) / h / density;
  }
}

/* Corrected equations (2.151) to (2.154) of the thesis: their terms in h^2 t. */
static void test_sums_over_a_line_that_flow_has_carried(void) {
  const double x = 0.4, h = 0.05, t = 2e-8, s = sin(x + 0.3), c = cos(x + 0.3);
  const double f[] = {s, c, -s, -c, s}, C = cos(1.7 * x), S = sin(1.7 * x);
  const double u[] = {C, -1.7 * S, -pow(1.7, 2) * C, pow(1.7, 3) * S, pow(1.7, 4) * C};
  const double first[] = {-f[0] * u[1], 0, -f[0] * u[2] - f[1] * u[1], 0};
  const double term[] = {-(f[1] * u[2] / 3 + f[2] * u[1] / 6 + f[0] * u[3] / 6), f[0] * u[3] / 6,
                         -(f[0] * u[4] / 12 + f[1] * u[3] / 6 - f[3] * u[1] / 6),
                         f[0] * u[4] / 4 + f[1] * u[3] / 2 + f[2] * u[2] / 2 + f[3] * u[1] / 3};
  double before[4], after[4];
  if (sizeof(real) != sizeof(double)) return; /* a difference of 1e-8 */
  interpolate(x, h, 0, before);
  interpolate(x, h, t, after);
  for (int i = 0; i < 4; i++)
    EXPECT_NEAR(((after[i] - before[i]) / t - first[i]) / (h * h) / term[i], 1, 0.005);
}

int main(void) {
#ifdef PLUNGE_TRAP_FLOATS
  RUN(test_kernel_does_not_overflow_far_away);
#endif
  RUN(test_kernel_integrates_to_one_over_the_plane);
  RUN(test_kernel_falls_as_its_gradient_says);
  RUN(test_kernel_slope_is_along_the_pair);
  RUN(test_kernel_vanishes_at_the_edge_of_its_support);
  RUN(test_exponential_is_as_accurate_as_its_numbers);
  RUN(test_sums_over_a_line_that_flow_has_carried);
  return TEST_RESULT;
}

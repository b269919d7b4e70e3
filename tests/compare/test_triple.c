/* Orders, Richardson's values and error bars of three resolutions: made-up values of known order,
 * the published example, and values that have no order. */
#include "compare/convergence/triple.h"

#include "tests/test.h"

static const double exactly[3] = {0, 0, 0};

/* limit + c h^p has that order and that limit, whatever the ratios, signs and sizes. */
static void test_known_orders_are_found_exactly(void) {
  static const double spacings[][3] = {
      {4, 2, 1}, {0.04, 0.02, 0.01}, {3, 2, 1.5}, {1.9, 1.2, 1.1}, {5, 4.7, 2}};
  static const double orders[] = {0.5, 1, 1.53, 2, 4, 6.5};
  for (size_t i = 0; i < sizeof spacings / sizeof *spacings; i++)
    for (size_t k = 0; k < sizeof orders / sizeof *orders; k++)
      for (int sign = -1; sign <= 1; sign += 2) {
        const double *h = spacings[i], p = orders[k], limit = 2.385;
        double f[3];
        for (int j = 0; j < 3; j++) f[j] = limit + sign * 0.7 * pow(h[j], p);
        const struct cmp_triple t = cmp_triple_of(h, f, exactly);
        EXPECT(t.trend == CMP_TREND_monotone);
        /* f is known to 1e-16 of its size: its smallest difference has the fewest digits */
        const double digits = 1e-14 * fmax(fabs(f[0]), limit) / fabs(f[1] - f[2]);
        EXPECT_NEAR(t.order, p, 100 * digits / log(h[1] / h[2]));
        EXPECT_NEAR(t.limit, limit, 1e-9 * fmax(fabs(f[0]), limit) / log(h[1] / h[2]));
        const double rest = fabs(f[1] - f[2]) / (pow(h[1] / h[2], fmin(p, 2)) - 1);
        EXPECT_NEAR(t.bar, 1.25 * rest, 1e-6 * t.bar + 1e-15 * limit);
        EXPECT_NEAR(t.gci, 1.25 * fabs(f[2] - limit) / fabs(f[2]), 1e-6 * t.gci + 1e-15);
      }
}

/* The columns of the paper's table with one sign, to its digits; their cells fill a plane. */
static void test_published_example(void) {
  const double h[3] = {1 / sqrt(4500), 1 / sqrt(8000), 1 / sqrt(18000)};
  const struct cmp_triple length = cmp_triple_of(h, (const double[]){5.863, 5.972, 6.063}, exactly);
  EXPECT_NEAR(length.order, 1.53, 0.005);
  EXPECT_NEAR(length.limit, 6.1685, 5e-5);
  EXPECT_NEAR(length.gci, 0.022, 5e-4);
  const double wider[3] = {1 / sqrt(980), 1 / sqrt(4500), 1 / sqrt(18000)};
  const struct cmp_triple speed =
      cmp_triple_of(wider, (const double[]){10.6050, 10.7250, 10.7880}, exactly);
  EXPECT_NEAR(speed.order, 0.75, 0.005);
  EXPECT_NEAR(speed.limit, 10.8801, 5e-4);
  EXPECT_NEAR(speed.gci, 0.011, 5e-4);
}

/* Noise of n in each value moves the order by at most its share of the finer difference, 2 n/d, and
 * of the coarser one, over ln 2. */
static void test_noise_moves_the_order_as_far_as_it_can(void) {
  const double h[3] = {4, 2, 1}, n = 1e-3;
  for (int k = 0; k < 8; k++) {
    double f[3];
    for (int j = 0; j < 3; j++) f[j] = 1 + 0.3 * h[j] * h[j] + (k >> j & 1 ? n : -n);
    const struct cmp_triple t = cmp_triple_of(h, f, exactly);
    EXPECT(t.trend == CMP_TREND_monotone);
    EXPECT_NEAR(t.order, 2, 1.01 * (2 * n / 0.9 + 2 * n / 3.6) / log(2));
    EXPECT_NEAR(t.limit, 1, 1.5 * t.bar);
  }
}

static void expect_no_order(const struct cmp_triple *t, enum cmp_trend trend) {
  if (t->trend != trend)
    TEST_FAIL("%s, expected %s", cmp_trend_names[t->trend], cmp_trend_names[trend]);
  EXPECT(isnan(t->order));
  EXPECT(isnan(t->limit));
}

/* No order is claimed where there is none. */
static void test_no_order_where_there_is_none(void) {
  const double h[3] = {4, 2, 1};
  struct cmp_triple t = cmp_triple_of(h, (const double[]){1.4, 0.9, 1.1}, exactly);
  expect_no_order(&t, CMP_TREND_oscillating);
  EXPECT_NEAR(t.bar, 0.25, 1e-15);
  t = cmp_triple_of(h, (const double[]){1, 1.1, 0.8}, exactly);
  expect_no_order(&t, CMP_TREND_diverging);
  EXPECT(isnan(t.bar));
  t = cmp_triple_of(h, (const double[]){1, 1.1, 1.3}, exactly);
  expect_no_order(&t, CMP_TREND_diverging);
  EXPECT(isnan(t.bar));
  t = cmp_triple_of(h, (const double[]){1, 2, 3}, exactly); /* as of order 0 */
  expect_no_order(&t, CMP_TREND_diverging);
  t = cmp_triple_of(h, (const double[]){0.3, 0.1 + 0.2, 0.3}, exactly); /* their last bit differs */
  expect_no_order(&t, CMP_TREND_constant);
  EXPECT(t.bar == 0);
  t = cmp_triple_of(h, (const double[]){0, 0, 0}, exactly);
  expect_no_order(&t, CMP_TREND_constant);
  EXPECT(isnan(t.gci));
  t = cmp_triple_of(h, (const double[]){1.5, 1, 1}, exactly);
  expect_no_order(&t, CMP_TREND_stalled);
  EXPECT(isnan(t.bar));
  t = cmp_triple_of(h, (const double[]){1, 1, 1.5}, exactly);
  expect_no_order(&t, CMP_TREND_diverging);
}

/* With ratios that differ, a difference may be smaller although the values run away. */
static void test_unequal_ratios_are_minded(void) {
  const double h[3] = {2.2, 1.1,
                       1}; /* the coarser step is 7.3 times as long on the logarithm's scale */
  const struct cmp_triple t = cmp_triple_of(h, (const double[]){0, 5, 6}, exactly);
  expect_no_order(&t, CMP_TREND_diverging);
}

/* The finest of distances from itself is 0: then there is a limit, and no index relative to it. */
static void test_finest_value_may_be_zero(void) {
  const double h[3] = {4, 2, 1};
  const struct cmp_triple t = cmp_triple_of(h, (const double[]){15, 3, 0}, exactly); /* h^2 - 1 */
  EXPECT_NEAR(t.order, 2, 1e-12);
  EXPECT_NEAR(t.limit, -1, 1e-12);
  EXPECT_NEAR(t.bar, 1.25, 1e-12);
  EXPECT(isnan(t.gci));
}

/* An instant that is known to half an interval has no order by differences of a fifth of it. */
static void test_what_is_known_too_coarsely_has_no_order(void) {
  const double h[3] = {4, 2, 1}, f[3] = {1.16, 1.04, 1.01};
  struct cmp_triple t = cmp_triple_of(h, f, (const double[]){0, 0.01, 0.01});
  EXPECT(t.trend == CMP_TREND_monotone); /* the smaller difference is 0.03 */
  t = cmp_triple_of(h, f, (const double[]){0, 0.02, 0.02});
  expect_no_order(&t, CMP_TREND_unresolved);
  EXPECT_NEAR(t.bar, 0.075, 1e-15);
  t = cmp_triple_of(h, f, (const double[]){0.13, 0, 0.2});
  expect_no_order(&t, CMP_TREND_unresolved);
  EXPECT_NEAR(t.bar, 0.2, 1e-15);
}

static void test_order_of_two_errors(void) {
  EXPECT_NEAR(cmp_error_order((const double[]){0.3, 0.2}, (const double[]){0.09, -0.04}), 2, 1e-12);
  EXPECT(isnan(cmp_error_order((const double[]){2, 1}, (const double[]){1, 0})));
  EXPECT(isnan(cmp_error_order((const double[]){2, 1}, (const double[]){0, 1})));
  EXPECT(isnan(cmp_error_order((const double[]){2, 1}, (const double[]){NAN, 1})));
  EXPECT_NEAR(cmp_error_order((const double[]){2, 1}, (const double[]){1, 2}), -1, 1e-12);
}

int main(void) {
  RUN(test_known_orders_are_found_exactly);
  RUN(test_published_example);
  RUN(test_noise_moves_the_order_as_far_as_it_can);
  RUN(test_no_order_where_there_is_none);
  RUN(test_unequal_ratios_are_minded);
  RUN(test_finest_value_may_be_zero);
  RUN(test_what_is_known_too_coarsely_has_no_order);
  RUN(test_order_of_two_errors);
  return TEST_RESULT;
}

/* Numbers of curves whose values are known, and formulas over them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/text.h"
#include "gallery/desk.h"
#include "gallery/formula.h"
#include "gallery/reduce.h"
#include "gallery/verdict.h"
#include "tests/test.h"

static struct gallery_curve sampled(double (*f)(double), double from, double to, size_t n) {
  struct gallery_curve c = {0};
  for (size_t i = 0; i < n; i++) {
    const double x = from + (to - from) * (double)i / (double)(n - 1);
    if (gallery_curve_add(&c, x, f(x)) != OK) abort();
  }
  return c;
}

static double line(double x) {
  return 3 * x - 1;
}
static double wave(double x) {
  return 2 * cos(7 * x - 0.3) + 0.5;
}
static double burst(double x) { /* grows from 1e-6 at the rate 4 */
  return 1e-6 * exp(4 * x) * (x > 3 ? -1 : 1);
}
static double catenary(double x) { /* grows from rest at the rate 5 */
  return -0.01 * cosh(5 * x);
}
static double hump(double x) {
  return 1 - (x - 1) * (x - 1);
}

#define REDUCE(name, curve, ...) gallery_reduce_##name(&(curve), (double[]){__VA_ARGS__})

static void test_points_and_means(void) {
  struct gallery_curve c = sampled(line, 0, 2, 21);
  EXPECT_NEAR(REDUCE(at, c, 0.7), 1.1, 1e-15);
  EXPECT_NEAR(REDUCE(at, c, 0.73), 1.19, 1e-14); /* linear between points */
  EXPECT(isnan(REDUCE(at, c, 2.1)));
  EXPECT_NEAR(REDUCE(first, c, 0), -1, 0);
  EXPECT_NEAR(REDUCE(last, c, 0), 5, 1e-15);
  EXPECT_NEAR(REDUCE(count, c, 0), 21, 0);
  EXPECT_NEAR(REDUCE(mean, c, 0, 2), 2, 1e-14);
  EXPECT_NEAR(REDUCE(median, c, 0, 2), 2, 1e-14);
  EXPECT_NEAR(REDUCE(median, c, 0, 1.9), 1.85, 1e-14); /* of an even number */
  EXPECT_NEAR(REDUCE(integral, c, 0, 2), 4, 1e-14);
  EXPECT_NEAR(REDUCE(crosses, c, 0), 1. / 3, 1e-14);
  EXPECT(isnan(REDUCE(crosses, c, 9)));
  EXPECT_NEAR(REDUCE(slope, c, 0.5, 1.5), 3, 1e-13);
  EXPECT_NEAR(REDUCE(rises, c, 0, 2), 1, 0);
  EXPECT_NEAR(REDUCE(falls, c, 0, 2), 0, 0);
  EXPECT_NEAR(REDUCE(signs, c, 0), 1, 0);
  EXPECT(isnan(REDUCE(mean, c, 5, 6)));
  for (double far = 1; far < 1e12; far *= 10) /* an end is as sharp wherever the other one is */
    EXPECT_NEAR(REDUCE(least, c, 1, far + 1), 2, 1e-14);
  EXPECT_NEAR(REDUCE(least, c, 1, INFINITY), 2, 1e-14);
  EXPECT_NEAR(REDUCE(least, c, 1 + 1e-10, 2), 2, 1e-14); /* the same time, summed otherwise */
  for (size_t i = 0; i < c.n; i++) c.y[i] = NAN;
  EXPECT(isnan(REDUCE(signs, c, 0)));
  gallery_curve_free(&c);
}

static void test_extremes(void) {
  struct gallery_curve c = sampled(hump, 0, 3, 31);
  EXPECT_NEAR(REDUCE(most, c, 0, 3), 1, 1e-15);
  EXPECT_NEAR(REDUCE(where_most, c, 0, 3), 1, 1e-15);
  EXPECT_NEAR(REDUCE(least, c, 0, 2.5), -1.25, 1e-14);
  EXPECT_NEAR(REDUCE(where_least, c, 0, 3), 3, 1e-15);
  c.y[30] = NAN; /* is no point */
  EXPECT_NEAR(REDUCE(where_least, c, 0, 3), 2.9, 1e-14);
  EXPECT_NEAR(REDUCE(falls, c, 1, 3), 1, 0);
  EXPECT_NEAR(REDUCE(rises, c, 0, 3), 0, 0);
  gallery_curve_free(&c);
}

/* A wave that is one: the fit is exact but for rounding, about 1e-16 times the condition of its
 * three columns, which over three periods are nearly orthogonal. */
static void test_waves(void) {
  struct gallery_curve c = sampled(wave, 0.2, 3, 400);
  EXPECT_NEAR(REDUCE(frequency, c, 6.5, 0, 3), 7, 1e-7);
  EXPECT_NEAR(REDUCE(amplitude, c, 7, 0, 3), 2, 1e-12);
  EXPECT_NEAR(REDUCE(phase, c, 7, 0, 3), 0.3, 1e-12);
  EXPECT_NEAR(REDUCE(residual, c, 7, 0, 3), 0, 1e-12);
  EXPECT(REDUCE(residual, c, 3, 0, 3) > 0.5);
  EXPECT(isnan(REDUCE(frequency, c, 5.5, 0, 3))); /* 7 lies beyond 4.1 to 6.9 */
  EXPECT(isnan(REDUCE(frequency, c, 9.5, 0, 3)));
  gallery_curve_free(&c);
}

static void test_growth(void) {
  struct gallery_curve c = sampled(burst, 0, 4, 401);
  EXPECT_NEAR(REDUCE(growth, c, 1e-5, 1), 4, 1e-10);
  c.y[50] = 1e-3; /* above the lower bound, but not for good: the points after it are below */
  EXPECT_NEAR(REDUCE(growth, c, 1e-4, 1), 4, 1e-10);
  EXPECT(isnan(REDUCE(growth, c, 1e-4, 10))); /* it ends below */
  gallery_curve_free(&c);
}

/* The fit is exact; the residual is flat to the root of rounding where it is least. */
static void test_growth_from_rest(void) {
  struct gallery_curve c = sampled(catenary, 0, 2, 101);
  EXPECT_NEAR(REDUCE(cosh_rate, c, 4.5, 0.3, 1.4), 5, 1e-6);
  EXPECT_NEAR(REDUCE(cosh_rate, c, 6, 0, 2), 5, 1e-6);
  EXPECT(isnan(REDUCE(cosh_rate, c, 5, 0.3, 0.31))); /* a point is not enough */
  gallery_curve_free(&c);
}

static void test_share_beyond(void) {
  struct gallery_curve c = {0};
  for (int i = 0; i < 4; i++) EXPECT_OK(gallery_curve_add(&c, i, i));
  EXPECT_NEAR(REDUCE(beyond, c, 2), 9. / 14, 1e-15);
  gallery_curve_free(&c);
}

/* ---- formulas ---- */

static struct gallery_curve known;
static bool number(void *with, const char *name, double *value) {
  (void)with;
  if (strcmp(name, "three") != 0) {
    (void)status_raise(ERR_INPUT, "there is no number '%s'", name);
    return false;
  }
  *value = 3;
  return true;
}
static bool curve(void *with, const char *name, const struct gallery_curve **c) {
  (void)with;
  *c = &known;
  if (!strcmp(name, "line")) return true;
  (void)status_raise(ERR_INPUT, "there is no curve '%s'", name);
  return false;
}
static const struct gallery_scope scope = {NULL, number, curve};

static void expect_value(const char *formula, double value) {
  double found = NAN;
  EXPECT_OK(gallery_formula(&scope, formula, &found));
  if (!(fabs(found - value) <= 1e-12))
    TEST_FAIL("%s = %.15g, expected %.15g", formula, found, value);
}

static void test_formulas(void) {
  known = sampled(line, 0, 2, 21);
  expect_value("16/(4*pi/3)^3", 16 / pow(4 * acos(-1.0) / 3, 3));
  expect_value("three^2 - sqrt(three*three)", 6);
  expect_value("at(\"line\", 0.5) + three", 3.5);
  expect_value("most(\"line\", 0, 1) < 2.5 && first(\"line\") == -1", 1);
  expect_value("count(\"line\")", 21);
  expect_value("abs(-2) > 1 ? 5 : 6", 5);
  gallery_curve_free(&known);
}

static void expect_none(const char *formula) {
  double found = 0;
  EXPECT_OK(gallery_formula(&scope, formula, &found));
  if (!isnan(found)) TEST_FAIL("%s = %.15g, expected no number", formula, found);
}

/* What does not exist is no part of a sum that does, in whatever place it stands. */
static void test_formulas_of_no_number(void) {
  known = sampled(line, 0, 2, 21);
  expect_none("max(1, at(\"line\", 99), 2)");
  expect_none("max(at(\"line\", 99), 1, 2)");
  expect_none("min(1, 2, at(\"line\", 99))");
  expect_none("min(at(\"line\", 99), 1)");
  expect_none("max(1, min(2, at(\"line\", 99)))");
  expect_none("sum(1, at(\"line\", 99))");
  expect_none("avg(1, at(\"line\", 99))");
  expect_none("abs(at(\"line\", 99)) + three");
  expect_value("max(1, 3, 2) - min(5, -4, three)", 7);
  expect_value("max(-three)", -3);
  expect_value("at(\"line\", 99) < 1", 0);
  expect_value("at(\"line\", 99) > 1", 0);
  expect_value("at(\"line\", 99) == at(\"line\", 99)", 0);
  expect_value("at(\"line\", 99) != 1", 1);
  expect_value("at(\"line\", 99) && 1", 1);
  expect_value("at(\"line\", 99) ? 5 : 6", 5);
  expect_value("rint(2.6) + sign(-3)", 2);
  gallery_curve_free(&known);
}

static void expect_refusal(const char *formula, const char *words) {
  double value = 7;
  const enum status status = gallery_formula(&scope, formula, &value);
  if (status != ERR_INPUT || !strstr(status_message(), words))
    TEST_FAIL("%s: %d %s, expected '%s'", formula, (int)status, status_message(), words);
}

static void test_formulas_that_are_wrong(void) {
  known = sampled(line, 0, 2, 21);
  expect_refusal("", ", in the formula ");
  expect_refusal("1 +", ", in the formula 1 +");
  expect_refusal("at(\"line\", 1) +* 2", "in the formula");
  expect_refusal("four", "there is no number 'four'");
  expect_refusal("at(\"circle\", 1)", "there is no curve 'circle'");
  expect_refusal("at(\"line\")", "the formula");
  expect_refusal("at(\"line\", 1, 2)", "the formula");
  expect_refusal("at(line, 1)", "the formula");
  expect_refusal("nothing(3)", "the formula");
  expect_refusal("(1", "the formula");
  expect_refusal("max()", "the formula");
  expect_refusal("(a = 5)", "found '='; allowed: ==");
  expect_refusal("three = 5", "found '='");
  expect_refusal("1, 2", "found several values");
  expect_refusal("max(1, 2), 3", "found several values");
  expect_value("three == 3 && three >= 3 && three <= 3 && three != 4", 1);
  gallery_curve_free(&known);
}

/* The reason comes first, and the formula is cut between characters. */
static void test_long_formulas(void) {
  char formula[1300] = "";
  double value = 7;
  for (size_t i = 0; i < 600; i++) memcpy(formula + 2 * i, "\xc3\xa9", 2);
  EXPECT(gallery_formula(&scope, formula, &value) == ERR_INPUT);
  const char *at = strstr(status_message(), ", in the formula ");
  EXPECT(at && at > status_message() && strlen(at) < 200 && !text_bad_utf8(at, strlen(at)));
  EXPECT(isnan(value));
}

static void test_rows(void) {
  const double x[3] = {1, 2, 3}, y[3] = {4, 5, 6}, *column[] = {x, y};
  const char *names[] = {"x", "y"};
  double value[3];
  EXPECT_OK(gallery_formula_rows(&scope, "x*y + three", 2, names, column, 3, value));
  for (int i = 0; i < 3; i++) EXPECT_NEAR(value[i], x[i] * y[i] + 3, 0);
}

int main(void) {
  RUN(test_points_and_means);
  RUN(test_extremes);
  RUN(test_waves);
  RUN(test_growth);
  RUN(test_growth_from_rest);
  RUN(test_share_beyond);
  RUN(test_formulas);
  RUN(test_formulas_of_no_number);
  RUN(test_formulas_that_are_wrong);
  RUN(test_long_formulas);
  RUN(test_rows);
  return TEST_RESULT;
}

/* Signals whose peak, impulse, shift and rms are known in closed form. */
#include "compare/series.h"

#include <string.h>

#include "tests/test.h"

enum { N = 2001 };
static double t[N], a[N], b[N];

static struct cmp_signal signal(const double *value) {
  return (struct cmp_signal){N, t, value};
}

/* A Gaussian pulse of height 0.8 and width s at t0: peak 0.8 at t0, impulse 0.8 s sqrt(2 pi). */
static double pulse(double time, double t0) {
  return 0.8 * exp(-(time - t0) * (time - t0) / (2 * 0.15 * 0.15));
}

static void fill(double shift) {
  for (int i = 0; i < N; i++) {
    t[i] = 5.0 * i / (N - 1);
    a[i] = pulse(t[i], 2.5 + shift);
    b[i] = pulse(t[i], 2.5);
  }
}

static void test_pulse_has_its_peak_impulse_and_onset(void) {
  fill(0);
  struct cmp_signal s = signal(b);
  struct cmp_signal_alone m;
  cmp_signal_measure(&s, 0, 5, 0.1, &m);
  EXPECT_NEAR(m.peak.value, 0.8, 1e-12);
  EXPECT_NEAR(m.peak_time.value, 2.5, 1e-12);
  EXPECT_NEAR(m.impulse.value, 0.8 * 0.15 * sqrt(2 * M_PI), 1e-9); /* spectral for a Gaussian */
  /* linear interpolation between rows 0.0025 apart: h^2 f'' / 8 over f' */
  EXPECT_NEAR(m.onset.value, 2.5 - 0.15 * sqrt(2 * log(8)), 1e-5);
}

/* A late copy: its shift is found, and nothing remains when it is applied. */
static void test_shift_is_found_and_not_applied(void) {
  const double late = 0.0837;
  fill(late);
  struct cmp_signal x = signal(a), y = signal(b);
  struct cmp_signal_pair m;
  cmp_signal_compare(&x, &y, 0.1, 0.5, &m);
  EXPECT_NEAR(m.shift.value, late, 1e-5);
  EXPECT(m.rms_after.value < 1e-4 && m.rms.value > 0.03);
  cmp_signal_compare(&y, &x, 0.1, 0.5, &m);
  EXPECT_NEAR(m.shift.value, -late, 1e-5);
}

static void test_identity_is_zero(void) {
  fill(0);
  struct cmp_signal x = signal(b);
  struct cmp_signal_pair m;
  cmp_signal_compare(&x, &x, 0.1, 0.5, &m);
  EXPECT(m.rms.value == 0 && m.shift.value == 0 && m.rms_after.value == 0);
}

/* rms of a constant offset is the offset; of sin, 1/sqrt 2 over whole periods. */
static void test_rms_of_known_differences(void) {
  for (int i = 0; i < N; i++) {
    t[i] = 4 * M_PI * i / (N - 1);
    a[i] = 1.25;
    b[i] = 1.25 + sin(t[i]);
  }
  struct cmp_signal x = signal(a), y = signal(b);
  struct cmp_signal_pair m;
  cmp_signal_compare(&x, &y, 9, 0.5, &m);
  EXPECT_NEAR(m.rms.value, sqrt(0.5), 1e-5);
  EXPECT(!cmp_known(&m.a.onset) && m.a.onset.why[0]);
}

/* Only the common range counts, and signals that share none say so. */
static void test_common_range(void) {
  double u[] = {0, 1, 2}, v[] = {1, 1, 1}, w[] = {1.5, 3}, z[] = {2, 2}, far[] = {7, 8};
  struct cmp_signal x = {3, u, v}, y = {2, w, z}, away = {2, far, z};
  struct cmp_signal_pair m;
  cmp_signal_compare(&x, &y, 0.1, 0.1, &m);
  EXPECT_NEAR(m.from, 1.5, 0);
  EXPECT_NEAR(m.to, 2, 0);
  EXPECT_NEAR(m.rms.value, 1, 1e-12);
  EXPECT_NEAR(m.a.impulse.value, 0.5, 1e-12);
  cmp_signal_compare(&x, &away, 0.1, 0.1, &m);
  EXPECT(!cmp_known(&m.rms) && m.rms.why[0]);
  struct cmp_signal empty = {0, NULL, NULL};
  cmp_signal_compare(&x, &empty, 0.1, 0.1, &m);
  EXPECT(!cmp_known(&m.rms) && !cmp_known(&m.shift));
}

/* A dry gauge is a gap: a few are left out, too many leave nothing to say. */
static void test_gaps_are_not_zeros(void) {
  fill(0);
  for (int i = 0; i < N; i++) a[i] = i < N / 10 ? NAN : b[i] + 0.5;
  struct cmp_signal x = signal(a), y = signal(b);
  struct cmp_signal_pair m;
  cmp_signal_compare(&x, &y, 0.1, 0.1, &m);
  EXPECT_NEAR(m.rms.value, 0.5, 1e-9);
  EXPECT(!cmp_known(&m.a.impulse));
  for (int i = 0; i < N / 2; i++) a[i] = NAN;
  cmp_signal_compare(&x, &y, 0.1, 0.1, &m);
  EXPECT(!cmp_known(&m.rms) && !strcmp(m.rms.why, "too many gaps in the signals"));
  for (int i = 0; i < N; i++) a[i] = NAN;
  cmp_signal_compare(&x, &y, 0.1, 0.1, &m);
  EXPECT(!cmp_known(&m.rms) && !strcmp(m.rms.why, "dry in one of the two"));
  for (int i = 0; i < N; i++) b[i] = NAN;
  cmp_signal_compare(&x, &y, 0.1, 0.1, &m);
  EXPECT(!cmp_known(&m.rms) && strstr(m.rms.why, "dry in both"));
}

/* A gauge that is dry in both until t = 2 and then 0.1 higher in one. */
static void test_dry_in_both_is_no_gap(void) {
  fill(0);
  for (int i = 0; i < N; i++) {
    b[i] = t[i] < 2 ? NAN : 0.3 + 0.1 * sin(t[i]);
    a[i] = b[i] + 0.1;
  }
  struct cmp_signal x = signal(a), y = signal(b);
  struct cmp_signal_pair m;
  cmp_signal_compare(&x, &y, 0.1, 0.1, &m);
  EXPECT_NEAR(m.rms.value, 0.1, 1e-9);
  EXPECT_NEAR(m.a.onset.value, 2, 0.0026); /* the first wet row */
}

static void expect_means(const struct cmp_signal *s, double over, double *mean) {
  EXPECT_OK(cmp_signal_average(s, over, mean));
}

/* The mean of sin(w t) over T is sin(w T/2)/(w T/2) of it; interpolation between rows h apart is
 * off by up to (w h)^2/8, and so is its mean. Near the ends, the mean of what there is. */
static void test_mean_of_a_sine(void) {
  static double mean[N];
  const double w = 7, T = 0.6, h = 5.0 / (N - 1);
  fill(0);
  for (int i = 0; i < N; i++) a[i] = sin(w * t[i]);
  struct cmp_signal s = signal(a);
  expect_means(&s, T, mean);
  for (int i = 0; i < N; i++) {
    double from = fmax(t[i] - T / 2, 0), to = fmin(t[i] + T / 2, 5);
    double exact = (cos(w * from) - cos(w * to)) / (w * (to - from));
    if (fabs(mean[i] - exact) > w * w * h * h / 8) TEST_FAIL("off at t = %g", t[i]);
    if (from > 0 && to < 5) EXPECT_NEAR(exact, sin(w * T / 2) / (w * T / 2) * a[i], 1e-12);
  }
}

/* A step becomes a ramp as long as T; a line stays a line, and its ends are means of a half. */
static void test_mean_of_a_step_and_a_line(void) {
  double u[] = {0, 1.9, 2 - 1e-9, 2 + 1e-9, 2.1, 3, 4}, step[] = {0, 0, 0, 1, 1, 1, 1}, mean[7];
  struct cmp_signal s = {7, u, step}, line = {7, u, u};
  expect_means(&s, 0.5, mean);
  const double ramp[] = {0, 0.3, 0.5, 0.5, 0.7, 1, 1};
  for (int i = 0; i < 7; i++) EXPECT_NEAR(mean[i], ramp[i], 1e-8);
  expect_means(&line, 0.5, mean);
  EXPECT_NEAR(mean[0], 0.125, 1e-15);
  EXPECT_NEAR(mean[6], 4 - 0.125, 1e-15);
  for (int i = 1; i < 6; i++) EXPECT_NEAR(mean[i], u[i], 1e-14);
}

/* The same signal with rows at other places has the same mean; T = 0 gives the very values. */
static void test_mean_does_not_depend_on_sampling(void) {
  double u[] = {0, 0.3, 1, 1.1, 2.5, 4}, v[] = {0.1, 2, -1, 3, 0.7, 0.7}, few[6];
  static double mean[N];
  struct cmp_signal coarse = {6, u, v}, fine = {N, t, a};
  for (int i = 0; i < N; i++) { /* every row of the coarse one is among them */
    t[i] = 4.0 * i / (N - 1);
    a[i] = cmp_signal_at(&coarse, t[i]);
  }
  for (double T = 0.02; T < 20; T *= 3) {
    expect_means(&coarse, T, few);
    expect_means(&fine, T, mean);
    for (int k = 0; k < 6; k++) EXPECT_NEAR(few[k], mean[(int)round(u[k] / 4 * (N - 1))], 1e-11);
  }
  expect_means(&coarse, 0, few);
  EXPECT(!memcmp(few, v, sizeof v));
}

/* A gap spoils the means that reach it and no other. */
static void test_mean_over_a_gap_is_a_gap(void) {
  double u[] = {0, 1, 2, 3, 4, 5, 6}, v[] = {1, 1, NAN, 1, 1, 1, INFINITY}, mean[7];
  struct cmp_signal s = {7, u, v}, one = {1, u, v}, empty = {0, NULL, NULL};
  expect_means(&s, 1, mean);
  for (int i = 0; i < 7; i++) EXPECT(i == 0 || i == 4 ? mean[i] == 1 : isnan(mean[i]));
  expect_means(&one, 1, mean);
  EXPECT(mean[0] == 1);
  expect_means(&empty, 1, mean);
}

int main(void) {
  RUN(test_pulse_has_its_peak_impulse_and_onset);
  RUN(test_shift_is_found_and_not_applied);
  RUN(test_identity_is_zero);
  RUN(test_rms_of_known_differences);
  RUN(test_common_range);
  RUN(test_gaps_are_not_zeros);
  RUN(test_dry_in_both_is_no_gap);
  RUN(test_mean_of_a_sine);
  RUN(test_mean_of_a_step_and_a_line);
  RUN(test_mean_does_not_depend_on_sampling);
  RUN(test_mean_over_a_gap_is_a_gap);
  return TEST_RESULT;
}

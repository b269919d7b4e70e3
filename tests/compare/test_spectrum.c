/* Spectra and filters of signals whose waves are known. */
#include "compare/spectrum.h"

#include "compare/filters.h"
#include "tests/compare/shapes.h"
#include "tests/test.h"

enum { MOST = 5000 };
static double t[MOST], x[MOST], y[MOST];

static struct cmp_signal signal(size_t n) {
  return (struct cmp_signal){n, t, x};
}

static double noise(void) { /* in [-1, 1), the same at every run */
  static uint64_t state = 2385;
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (double)(state >> 11) / 4503599627370496.0 - 1;
}

/* The power adds up to the mean square of the windowed signal over that of the window, 3/8, to
 * rounding; for an even and an odd number of samples. */
static void test_power_adds_up(void) {
  for (size_t n = 998; n < 1000; n++) {
    double mean = 0, square = 0;
    for (size_t i = 0; i < n; i++) {
      t[i] = 0.013 * (double)i;
      x[i] = 3.7 + noise();
      mean += (0.5 - 0.5 * cos(2 * M_PI * (double)i / (double)n)) * x[i] / (0.5 * (double)n);
    }
    for (size_t i = 0; i < n; i++) {
      const double w = 0.5 - 0.5 * cos(2 * M_PI * (double)i / (double)n);
      square += pow(w * (x[i] - mean), 2) / (0.375 * (double)n);
    }
    struct cmp_spectrum s;
    const struct cmp_signal signal_ = signal(n);
    EXPECT_OK(cmp_spectrum_create(&signal_, 0, INFINITY, 3, &s));
    double sum = 0;
    for (size_t k = 0; k < s.n; k++) sum += s.power[k] * s.step;
    EXPECT(!s.resampled && s.n == n / 2 + 1);
    EXPECT_NEAR(s.mean, mean, 1e-12);
    EXPECT_NEAR(sum / square, 1, 1e-12);
    EXPECT_NEAR(s.mean_square / square, 1, 1e-12);
    cmp_spectrum_destroy(&s);
  }
}

/* A sine anywhere between two bins has its frequency and amplitude: the interpolation is exact but
 * for what the other half of the spectrum leaks there, some k^-3 at bin k. */
static void test_a_sine_between_bins_is_found(void) {
  enum { N = 1000 };
  for (int part = 0; part <= 10; part++) {
    const double step = 1 / (N * 0.02), f = (50 + part / 10.) * step;
    for (size_t i = 0; i < N; i++) {
      t[i] = 0.02 * (double)i;
      x[i] = 5 + 0.723 * sin(2 * M_PI * f * t[i] + 0.4);
    }
    struct cmp_spectrum s;
    const struct cmp_signal signal_ = signal(N);
    EXPECT_OK(cmp_spectrum_create(&signal_, 0, INFINITY, 3, &s));
    EXPECT(s.n_peaks == 1); /* side lobes are none */
    EXPECT_NEAR(s.step, step, 1e-12);
    EXPECT_NEAR(s.peak[0].frequency, f, 1e-4 * step);
    EXPECT_NEAR(s.peak[0].amplitude, 0.723, 1e-4);
    EXPECT_NEAR(s.mean_square, 0.5 * 0.723 * 0.723, 1e-4);
    cmp_spectrum_destroy(&s);
  }
}

/* Steps that change by a half: 20 rows a wave or so are even again to (w dt)^4/43. Gaps and all
 * rows before the longest stretch without one are left out. */
static void test_uneven_rows_are_made_even(void) {
  size_t n = 0;
  double time = 0;
  for (; n < 2000; n++) {
    t[n] = time;
    x[n] =
        n < 7 || n == 20 ? NAN : 2 * cos(2 * M_PI * 1.3 * time) + 0.5 * cos(2 * M_PI * 4.1 * time);
    time += 0.012 * (1 + 0.25 * sin(0.01 * (double)n));
  }
  struct cmp_spectrum s;
  const struct cmp_signal signal_ = signal(n);
  EXPECT_OK(cmp_spectrum_create(&signal_, 0, 20, 5, &s));
  EXPECT(s.resampled && s.from == t[21] && s.to <= 20);
  EXPECT(s.n_peaks == 2);
  EXPECT_NEAR(s.peak[0].frequency, 1.3, 0.001 * s.step);
  EXPECT_NEAR(s.peak[0].amplitude, 2, 0.001);
  EXPECT_NEAR(s.peak[1].frequency, 4.1, 0.01 * s.step);
  EXPECT_NEAR(s.peak[1].amplitude, 0.5, 0.5 * 0.01);
  cmp_spectrum_destroy(&s);
  EXPECT_OK(cmp_spectrum_create(&signal_, 0, 0.1, 5, &s));
  EXPECT(!cmp_known(&s.interval) && s.interval.why[0] && s.n == 0 && s.n_peaks == 0);
  cmp_spectrum_destroy(&s);
}

/* ---- filters ---- */

/* Of cosines over the whole duration those of twice the period stay, the one of it is halved, those
 * of 2/3 of it go, to rounding. */
static void test_low_pass_takes_what_is_short(void) {
  enum { N = 801 };
  const double D = 4;
  for (size_t i = 0; i < N; i++) {
    t[i] = 1 + D * (double)i / (N - 1);
    const double at = M_PI * (t[i] - 1) / D;
    x[i] = 0.3 + cos(7 * at) + 0.9 * cos(20 * at) + 0.8 * cos(40 * at) + 0.5 * cos(60 * at) +
           0.4 * cos(231 * at);
  }
  const struct cmp_signal s = signal(N);
  EXPECT_OK(cmp_signal_low_pass(&s, 2 * D / 40, y));
  for (size_t i = 0; i < N; i++) {
    const double at = M_PI * (t[i] - 1) / D;
    EXPECT_NEAR(y[i], 0.3 + cos(7 * at) + 0.9 * cos(20 * at) + 0.4 * cos(40 * at), 1e-12);
  }
}

/* The peak of p exp(-t^2/2s^2) when w and what is above goes is p erf(w s/sqrt 2); that of a
 * gradual end the mean of it over where it may be, from w/2 to 3 w/2 with the weight (pi/2w) cos(pi
 * (v/w - 1)). */
static double peak_left(double p, double s, double w) {
  enum { STEPS = 1000 };
  double sum = 0;
  for (int i = 0; i < STEPS; i++) {
    const double part = (i + 0.5) / STEPS - 0.5;
    sum += M_PI / 2 * cos(M_PI * part) * erf(w * (1 + part) * s / M_SQRT2) / STEPS;
  }
  return p * sum;
}

/* An impact keeps its impulse, p s sqrt(2 pi), and has the peak that is known: the cosines are an
 * integral's trapezoids, over a duration that is long. Rows that are not even in time change next
 * to nothing. A quarter of a time before it there is nothing of it. */
static void test_a_filtered_impact_keeps_its_impulse(void) {
  enum { N = 4001 };
  const double width = 0.05, period = 0.4, peak = 1.7;
  for (int uneven = 0; uneven < 2; uneven++) {
    for (size_t i = 0; i < N; i++) {
      const double u = 2. * (double)i / (N - 1) - 1;
      t[i] = 10 * (u + uneven * 0.02 * sin(M_PI * u));
      x[i] = peak * exp(-t[i] * t[i] / (2 * width * width));
    }
    const struct cmp_signal s = signal(N), after = {N, t, y};
    struct cmp_signal_alone m;
    EXPECT_OK(cmp_signal_low_pass(&s, period, y));
    cmp_signal_measure(&after, t[0], t[N - 1], 0.1, &m);
    EXPECT_NEAR(m.impulse.value, peak * width * sqrt(2 * M_PI), uneven ? 1e-6 : 1e-12);
    EXPECT_NEAR(m.peak.value, peak_left(peak, width, 2 * M_PI / period), 1e-5);
    EXPECT(m.peak.value < 0.7 * peak);
    EXPECT_NEAR(m.peak_time.value, 0, 1e-9);
    for (size_t i = 0; i < N; i++)
      if (fabs(t[i]) > 3) EXPECT(fabs(y[i]) < 1e-3 * peak);
  }
}

/* I(t) of a sine is its integral, up to the trapezoids' (w dt)^2/12; a gap ends it. */
static void test_impulse_is_the_integral(void) {
  enum { N = 2001 };
  const double w = 2 * M_PI * 3;
  for (size_t i = 0; i < N; i++) {
    t[i] = 1e-3 * (double)i;
    x[i] = sin(w * t[i]);
  }
  const struct cmp_signal s = signal(N);
  cmp_signal_integrate(&s, y);
  for (size_t i = 0; i < N; i++)
    EXPECT_NEAR(y[i], (1 - cos(w * t[i])) / w, 1.001 * 2 / w * w * w * 1e-6 / 12);
  x[1000] = NAN;
  cmp_signal_integrate(&s, y);
  EXPECT(isfinite(y[999]) && isnan(y[1000]) && isnan(y[N - 1]));
}

/* Weights of probes that stand evenly are 1 over their number, whatever else is in the tank; a
 * linear pressure has its own value in the middle; half the length ends at a corner. */
static void test_wall_mean_of_a_linear_pressure(void) {
  struct geo_lines tank = shape_tank(4, 3);
  struct cmp_series probe[7] = {0};
  const double places[][2] = {{4, 1.2}, {4, 1.0}, {4, 0.8}, {4, 0}, {3.9, 0}, {0, 1}, {4, 1.6}};
  double weight[7];
  for (size_t k = 0; k < 7; k++)
    probe[k] = (struct cmp_series){.x = places[k][0], .y = places[k][1]};
  size_t taken;
  EXPECT_OK(cmp_wall_weights(&tank, 7, probe, 1, 0.4, weight, &taken));
  EXPECT(taken == 3);
  EXPECT_NEAR(weight[0], 0.25, 1e-12);
  EXPECT_NEAR(weight[1], 0.5, 1e-12);
  EXPECT_NEAR(weight[2], 0.25, 1e-12);
  EXPECT(weight[3] == 0 && weight[4] == 0 && weight[5] == 0 && weight[6] == 0);
  double sum = 0, mean = 0;
  EXPECT_OK(cmp_wall_weights(&tank, 7, probe, 1, 2, weight, &taken));
  EXPECT(taken == 5);
  for (size_t k = 0; k < 7; k++) {
    sum += weight[k];
    mean += weight[k] * (3 - places[k][1]);
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  /* stretches 0-0.4-0.9-1.1-1.4-2 of the probes at 0, 0.8, 1, 1.2, 1.6 */
  EXPECT_NEAR(mean, (0.4 * 3 + 0.5 * 2.2 + 0.2 * 2 + 0.3 * 1.8 + 0.6 * 1.4) / 2, 1e-12);
  geo_lines_destroy(&tank);
}

/* Up a slope of 3 to 4, 5 long: with every wall's probes at random places, some of them at one, the
 * weights are positive and sum to 1, and those at one place are the same. */
static void test_weights_sum_to_1(void) {
  enum { N = 12 };
  struct geo_lines tank = {0};
  shape_open(&tank);
  shape_point(&tank, 0, 3);
  shape_point(&tank, 0, 0);
  shape_point(&tank, 4, 0);
  shape_point(&tank, 8, 3);
  for (int turn = 0; turn < 200; turn++) {
    struct cmp_series probe[N] = {0};
    double weight[N], sum = 0, place[N];
    size_t places, different = 0;
    for (size_t k = 0; k < N; k++) {
      place[k] = k % 3 == 2 ? place[k - 1] : 0.5 + 0.49 * noise();
      const bool sloping = k < N - 3;
      probe[k].x = sloping ? 4 + 4 * place[k] : 4 * place[k];
      probe[k].y = sloping ? 3 * place[k] : 0;
    }
    const double length = 1 + 8 * (double)(turn % 10) / 10;
    EXPECT_OK(cmp_wall_weights(&tank, N, probe, 0, length, weight, &places));
    for (size_t k = 0; k < N; k++) {
      const bool within = k < N - 3 && 5 * fabs(place[k] - place[0]) <= length / 2;
      EXPECT(within ? weight[k] > 0 : weight[k] == 0);
      different += within && k % 3 != 2;
      sum += weight[k];
      if (k % 3 == 2) EXPECT_NEAR(weight[k], weight[k - 1], 1e-15);
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT(places == different);
  }
  geo_lines_destroy(&tank);
}

/* A time that comes out a rounding late or early is the same, and what there is none of is told. */
static void test_a_stretch_that_is_short_says_why(void) {
  enum { N = 101 };
  struct cmp_spectrum s;
  for (size_t i = 0; i < N; i++) {
    t[i] = 0.01 * (double)i;
    x[i] = noise();
  }
  struct cmp_signal rows = signal(N);
  EXPECT_OK(cmp_spectrum_create(&rows, t[30] * (1 + 1e-14), t[60] * (1 - 1e-14), 3, &s));
  EXPECT(s.samples == 31);
  cmp_spectrum_destroy(&s);
  rows.n = 3;
  EXPECT_OK(cmp_spectrum_create(&rows, 0, INFINITY, 3, &s));
  EXPECT_STR(s.interval.why, "3 rows without a gap, where at least 16 are needed");
  cmp_spectrum_destroy(&s);
  for (size_t i = 0; i < N; i++) x[i] = NAN;
  rows.n = N;
  EXPECT_OK(cmp_spectrum_create(&rows, 0, INFINITY, 3, &s));
  EXPECT_STR(s.interval.why, "the series holds no value (dry)");
  cmp_spectrum_destroy(&s);
}

int main(void) {
  RUN(test_power_adds_up);
  RUN(test_a_sine_between_bins_is_found);
  RUN(test_uneven_rows_are_made_even);
  RUN(test_low_pass_takes_what_is_short);
  RUN(test_a_filtered_impact_keeps_its_impulse);
  RUN(test_impulse_is_the_integral);
  RUN(test_wall_mean_of_a_linear_pressure);
  RUN(test_weights_sum_to_1);
  RUN(test_a_stretch_that_is_short_says_why);
  return TEST_RESULT;
}

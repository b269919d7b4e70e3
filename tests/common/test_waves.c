#include "common/flow/waves.h"

#include <stdlib.h>

#include "tests/test.h"

static const double g = 9.81, wavelength = 2.385, bed = -0.31, left = 0.47;

static struct wave_standing wave(double steepness, double kd, int order) {
  double k = 2 * M_PI / wavelength;
  return wave_standing_create(steepness / k, wavelength, kd / k, g, left, bed, order);
}

static void test_frequency_has_its_limits(void) {
  EXPECT_NEAR(wave_frequency_linear(20, 1, g), sqrt(20 * g), 1e-9);
  EXPECT_NEAR(wave_frequency_linear(1e-4, 1, g), 1e-4 * sqrt(g), 1e-11);
  EXPECT_NEAR(wave_frequency_shift(20, 1), -0.125, 1e-12); /* Rayleigh's deep-water value */
  EXPECT(wave_frequency_shift(1, 1.05) > 0); /* Tadjbakhsh & Keller: it changes sign at 1.058 */
  EXPECT(wave_frequency_shift(1, 1.06) < 0);
}

static void test_water_starts_at_rest_below_a_cosine(void) {
  for (int order = 1; order <= 2; order++)
    for (double kd = 0.5; kd < 9; kd *= 2) {
      struct wave_standing w = wave(0.13, kd, order);
      for (int i = 0; i <= 10; i++) {
        double x = left + wavelength * i / 20, u[2];
        double y = bed + w.depth + w.amplitude * cos(w.k * (x - left));
        EXPECT_NEAR(wave_standing_elevation(&w, x, 0), y, 1e-14);
        wave_standing_velocity(&w, x, y - 0.1 * i * w.depth, 0, u);
        EXPECT(u[0] == 0 && u[1] == 0);
        EXPECT(wave_standing_rise(&w, x, 0) == 0);
        EXPECT(wave_standing_potential(&w, x, y, 0) == 0);
      }
    }
}

/* Central differences with h = 1e-4 m: relative error (2 k h)^2/6 = 5e-8 of k times the potential.
 */
static void test_velocity_is_the_gradient_of_a_harmonic_potential_between_walls(void) {
  struct wave_standing w = wave(0.2, 1.1, 2);
  const double h = 1e-4, t = 0.83;
  for (int i = 0; i <= 8; i++) {
    double x = left + 0.3 * wavelength * i / 8, y = bed + w.depth * (1 - 0.11 * i), u[2], p[4];
    wave_standing_velocity(&w, x, y, t, u);
    for (int k = 0; k < 4; k++)
      p[k] = wave_standing_potential(&w, x + (k == 0) * h - (k == 1) * h,
                                     y + (k == 2) * h - (k == 3) * h, t);
    double phi = wave_standing_potential(&w, x, y, t);
    EXPECT_NEAR(u[0], (p[0] - p[1]) / (2 * h), 1e-7);
    EXPECT_NEAR(u[1], (p[2] - p[3]) / (2 * h), 1e-7);
    EXPECT_NEAR((p[0] + p[1] + p[2] + p[3] - 4 * phi) / (h * h), 0, 1e-5); /* rounding over h^2 */
    for (int wall = 0; wall < 2; wall++) {
      wave_standing_velocity(&w, left + wall * wavelength / 2, y, t, u);
      EXPECT_NEAR(u[0], 0, 1e-14);
    }
    wave_standing_velocity(&w, x, bed, t, u);
    EXPECT_NEAR(u[1], 0, 1e-14);
  }
}

/* The largest residuals of the free-surface conditions over a period, in units of g/k and
 * sqrt(g/k). */
static void residuals(const struct wave_standing *w, double *kinematic, double *dynamic) {
  *kinematic = *dynamic = 0;
  for (int j = 0; j < 40; j++)
    for (int i = 0; i <= 20; i++) {
      double x = left + wavelength / 2 * i / 20, t = 2 * M_PI / w->omega * j / 40, u[2];
      double y = wave_standing_elevation(w, x, t);
      wave_standing_velocity(w, x, y, t, u);
      double rise = wave_standing_rise(w, x, t) + u[0] * wave_standing_slope(w, x, t) - u[1];
      double p = wave_standing_pressure(w, x, y, t);
      *kinematic = fmax(*kinematic, fabs(rise) / sqrt(g / w->k));
      *dynamic = fmax(*dynamic, fabs(p) * w->k / g);
    }
}

static void test_free_surface_conditions_hold_to_the_order_above_the_theorys(void) {
  for (double kd = 0.7; kd < 9; kd *= 2)
    for (int order = 1; order <= 2; order++) {
      double before[2] = {0, 0}, r[2];
      for (double steepness = 0.02; steepness > 0.004; steepness /= 2) {
        struct wave_standing w = wave(steepness, kd, order);
        residuals(&w, &r[0], &r[1]);
        for (int k = 0; k < 2; k++) {
          /* the next order is below 6 % of it at this steepness */
          if (before[k] != 0) EXPECT_NEAR(log2(before[k] / r[k]), order + 1, 0.1);
          before[k] = r[k];
        }
      }
    }
}

static void test_energy_is_kept_to_fourth_order(void) {
  double width = 1.5 * wavelength, before = 0;
  for (double steepness = 0.08; steepness > 0.01; steepness /= 2) {
    struct wave_standing w = wave(steepness, 2.2, 2);
    double first = 0, drift = 0;
    for (int j = 0; j <= 40; j++) {
      double t = 2 * M_PI / w.omega * j / 40;
      double e = wave_standing_kinetic(&w, width, t) + wave_standing_potential_energy(&w, width, t);
      if (j == 0) first = e;
      drift = fmax(drift, fabs(e - first));
    }
    if (before != 0) EXPECT_NEAR(log2(before / drift), 4, 0.15);
    before = drift;
  }
}

/* ---- the fully nonlinear wave, to compare with ---- */

/* phi = sum_m b_m cos(m k x) cosh(m k (y - bed))/cosh(m k d) + b_0 is fitted to phi at the nodes of
 * the surface in each evaluation: spectrally accurate while k a is small. Half a wavelength, k = g
 * = 1. */
enum { MODES = 12 };

struct tank_state {
  double eta[MODES + 1], phi[MODES + 1];
};

static void solve(double a[MODES + 1][MODES + 1], double *b) {
  for (int i = 0; i <= MODES; i++) {
    int pivot = i;
    for (int j = i; j <= MODES; j++)
      if (fabs(a[j][i]) > fabs(a[pivot][i])) pivot = j;
    for (int k = 0; k <= MODES; k++) {
      double swap = a[i][k];
      a[i][k] = a[pivot][k];
      a[pivot][k] = swap;
    }
    double swap = b[i];
    b[i] = b[pivot];
    b[pivot] = swap;
    for (int j = i + 1; j <= MODES; j++) {
      double f = a[j][i] / a[i][i];
      for (int k = i; k <= MODES; k++) a[j][k] -= f * a[i][k];
      b[j] -= f * b[i];
    }
  }
  for (int i = MODES; i >= 0; i--) {
    for (int k = i + 1; k <= MODES; k++) b[i] -= a[i][k] * b[k];
    b[i] /= a[i][i];
  }
}

/* Coefficients of the cosine series through values at the nodes x_i = pi i/MODES. */
static void cosine_series(const double *value, double *c) {
  for (int m = 0; m <= MODES; m++) {
    c[m] = 0;
    for (int i = 0; i <= MODES; i++)
      c[m] += (i % MODES ? 2.0 : 1.0) / MODES * value[i] * cos(M_PI * m * i / MODES);
    if (m % MODES == 0) c[m] /= 2;
  }
}

static struct tank_state rate(const struct tank_state *s, double d) {
  struct tank_state r;
  double a[MODES + 1][MODES + 1], b[MODES + 1], c[MODES + 1];
  for (int i = 0; i <= MODES; i++) {
    for (int m = 0; m <= MODES; m++)
      a[i][m] = cos(M_PI * m * i / MODES) * cosh(m * (s->eta[i] + d)) / cosh(m * d);
    b[i] = s->phi[i];
  }
  solve(a, b);
  cosine_series(s->eta, c);
  for (int i = 0; i <= MODES; i++) {
    double u = 0, v = 0, slope = 0, x = M_PI * i / MODES;
    for (int m = 1; m <= MODES; m++) {
      u -= m * b[m] * sin(m * x) * cosh(m * (s->eta[i] + d)) / cosh(m * d);
      v += m * b[m] * cos(m * x) * sinh(m * (s->eta[i] + d)) / cosh(m * d);
      slope -= m * c[m] * sin(m * x);
    }
    r.eta[i] = v - u * slope;
    r.phi[i] = -s->eta[i] - (u * u + v * v) / 2 + v * r.eta[i];
  }
  return r;
}

static void step(struct tank_state *s, double d, double dt) {
  const double part[4] = {0.5, 0.5, 1, 0}, weight[4] = {1, 2, 2, 1};
  struct tank_state sum = *s, at = *s;
  for (int k = 0; k < 4; k++) {
    struct tank_state r = rate(&at, d);
    for (int i = 0; i <= MODES; i++) {
      sum.eta[i] += weight[k] * dt / 6 * r.eta[i];
      sum.phi[i] += weight[k] * dt / 6 * r.phi[i];
      at.eta[i] = s->eta[i] + part[k] * dt * r.eta[i];
      at.phi[i] = s->phi[i] + part[k] * dt * r.phi[i];
    }
  }
  *s = sum;
}

/* Runs `periods` linear periods; returns the largest |eta - theory| and, by the instant at which
 * the first harmonic last crossed zero upwards, the frequency over the linear one. */
static double compare(double steepness, double kd, int order, int periods, double *frequency) {
  struct wave_standing w = wave_standing_create(steepness, 2 * M_PI, kd, 1, 0, -kd, order);
  double linear = wave_frequency_linear(1, kd, 1), period = 2 * M_PI / linear, error = 0, last = 0;
  enum { STEPS = 120 };
  struct tank_state s = {{0}, {0}};
  for (int i = 0; i <= MODES; i++) s.eta[i] = steepness * cos(M_PI * i / MODES);
  int crossings = 0;
  for (int n = 1; n <= STEPS * periods; n++) {
    double c[MODES + 1], t = period * n / STEPS;
    step(&s, kd, period / STEPS);
    cosine_series(s.eta, c);
    if (last < 0 && c[1] >= 0) {
      crossings++;
      *frequency = (crossings - 0.25) * period / (t - period / STEPS * c[1] / (c[1] - last));
    }
    last = c[1];
    for (int i = 0; i <= MODES; i++)
      error = fmax(error, fabs(s.eta[i] - wave_standing_elevation(&w, M_PI * i / MODES, t)));
  }
  return error;
}

static void test_theory_differs_from_the_nonlinear_wave_by_the_order_above_its_own(void) {
  for (double kd = 1; kd < 4; kd += 1.07)
    for (int order = 1; order <= 2; order++) {
      double before = 0, f;
      for (double steepness = 0.06; steepness > 0.01; steepness /= 2) {
        double error = compare(steepness, kd, order, 3, &f);
        if (before != 0) EXPECT_NEAR(log2(before / error), order + 1, 0.15);
        before = error;
      }
    }
}

/* Measured over 12 periods: what third-order modes add to the first harmonic nudges its crossings
 * by (ka)^2 of a radian, which is up to 1/75 of (ka)^2 in frequency; 0.0042 measured. */
static void test_frequency_shift_is_that_of_the_nonlinear_wave(void) {
  for (double kd = 0.8; kd < 4; kd *= 2) {
    double f = 0, steepness = 0.04;
    compare(steepness, kd, 2, 12, &f);
    EXPECT_NEAR((f - 1) / (steepness * steepness), wave_frequency_shift(1, kd), 0.005);
  }
}

/* The estimate is one: the true error of the surface over the amplitude, over three periods, lies
 * within a factor of 1.5 of it at both orders. */
static void test_error_is_estimated(void) {
  for (double kd = 1; kd < 4; kd += 1.07)
    for (int order = 1; order <= 2; order++)
      for (double steepness = 0.06; steepness > 0.01; steepness /= 2) {
        struct wave_standing w = wave_standing_create(steepness, 2 * M_PI, kd, 1, 0, 0, order);
        double f, true_error = compare(steepness, kd, order, 3, &f) / steepness;
        double estimate = wave_standing_error(&w, 6 * M_PI / w.omega);
        printf("     kd %.2f, ka %.3f, order %d: error %.2e, estimate %.2e\n", kd, steepness, order,
               true_error, estimate);
        EXPECT(estimate > true_error / 1.5 && estimate < 1.5 * true_error);
      }
}

/* A quarter of the amplitude, a sixteenth of the error; a bed at another height, the same. */
static void test_error_estimate_has_its_order_and_no_place(void) {
  struct wave_standing w = wave_standing_create(0.04, 2, 1, 9.81, 0, 0, 2);
  struct wave_standing low = wave_standing_create(0.01, 2, 1, 9.81, 0, 0, 2);
  struct wave_standing deep = wave_standing_create(0.04, 2, 1, 9.81, 0, -1000, 2);
  double error = wave_standing_error(&w, 4);
  EXPECT_NEAR(error / wave_standing_error(&low, 4), 16, 1);
  EXPECT_NEAR(wave_standing_error(&deep, 4), error, 1e-9);
}

int main(void) {
  RUN(test_frequency_has_its_limits);
  RUN(test_water_starts_at_rest_below_a_cosine);
  RUN(test_velocity_is_the_gradient_of_a_harmonic_potential_between_walls);
  RUN(test_free_surface_conditions_hold_to_the_order_above_the_theorys);
  RUN(test_energy_is_kept_to_fourth_order);
  RUN(test_theory_differs_from_the_nonlinear_wave_by_the_order_above_its_own);
  RUN(test_frequency_shift_is_that_of_the_nonlinear_wave);
  RUN(test_error_is_estimated);
  RUN(test_error_estimate_has_its_order_and_no_place);
  return TEST_RESULT;
}

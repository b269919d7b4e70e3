/* Runs that say how accurate they shall be: the surface of standing waves as steep as those that
 * `accuracy` was calibrated by, after ten periods, against one with many nodes. */
#include "tests/bem/run.h"

static const char text[] =
    "title: accuracy\n"
    "fluid: {density: 1, gravity: 1}\n"
    "scales: {H: 0.5}\n"
    "tank: {walls: [[[0, 1], [0, 0], %s[0.5, 0], [0.5, 1]]]}\n"
    "water: {wave: {kind: standing, amplitude: %.15g, wavelength: 1, depth: 0.5}}\n"
    "time: {end: %.15g, every: %.15g, sample: %.15g}\n"
    "runs: [{name: bem, solver: bem, %s}]\n";

static const char flat[] = "", bent[] = "[0.25, 1e-7], "; /* a bed that makes it any tank */

static struct result_file *wave(double ka, const char *bed, const char *how) {
  const double k = 2 * M_PI, end = 10 * 2 * M_PI / sqrt(k * tanh(k / 2));
  char with[sizeof text + 200];
  snprintf(with, sizeof with, text, bed, ka / k, end, end, end, how);
  return run_bem(with);
}

/* The elevation at x of a surface, by the cubic through four of its points. */
static double elevation(const struct geo_lines *s, double x) {
  size_t at = 0;
  double sum = 0;
  while (at + 4 < s->points && s->p[at + 2][0] < x) at++;
  for (size_t i = at; i < at + 4; i++) {
    double term = s->p[i][1];
    for (size_t j = at; j < at + 4; j++)
      if (j != i) term *= (x - s->p[j][0]) / (s->p[i][0] - s->p[j][0]);
    sum += term;
  }
  return sum;
}

static void expect_accurate(double ka, const char *bed, double accuracy) {
  char how[40];
  snprintf(how, sizeof how, "accuracy: %g", accuracy);
  struct result_file *f = wave(ka, bed, how),
                     *fine = wave(ka, flat, "accuracy: 1e-6, resolution: 60");
  if (!f || !fine) return;
  const struct geo_lines *is = &f->surface[f->n_surfaces - 1],
                         *should = &fine->surface[fine->n_surfaces - 1];
  double mean = 0;
  for (size_t i = 0; i < is->points; i++)
    mean += fabs(is->p[i][1] - elevation(should, is->p[i][0])) / (double)is->points;
  mean /= ka / (2 * M_PI);
  printf("     ka = %g%s, accuracy %g: %zu nodes, off by %.1e\n", ka, *bed ? ", any tank" : "",
         accuracy, is->points, mean);
  EXPECT(mean < accuracy);
  result_file_destroy(f);
  result_file_destroy(fine);
}

static void test_waves_are_as_accurate_as_they_shall_be(void) {
  expect_accurate(0.02, flat, 1e-3);
  expect_accurate(0.2, flat, 1e-3);
  expect_accurate(0.2, flat, 1e-4);
  expect_accurate(0.3, flat, 1e-4);
  expect_accurate(0.2, bent, 1e-3);
  expect_accurate(0.2, bent, 1e-4);
}

int main(void) {
  RUN(test_waves_are_as_accurate_as_they_shall_be);
  return TEST_RESULT;
}

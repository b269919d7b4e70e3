/* Every solver on one standing wave, depth = half the wavelength, against theory: frequency, decay
 * and shape. The tank is half a wavelength wide, so the walls are antinodes. */
#include <stdlib.h>
#include <unistd.h>

#include "cli/registry.h"
#include "common/base/progress.h"
#include "common/case/case.h"
#include "common/flow/waves.h"
#include "common/result/result.h"
#include "tests/test.h"

static const double g = 9.81, depth = 1, wavelength = 2;

static double linear_frequency(void) {
  return wave_frequency_linear(2 * M_PI / wavelength, depth, g);
}

/* Runs one solver for some linear periods, 120 samples each, and reads its result; the caller
 * frees. */
static struct result_file *run(const char *solver, double resolution, double amplitude,
                               double periods, const char *keys) {
  char folder[] = "/tmp/plunge-standing-XXXXXX", path[64], text[1024];
  double period = 2 * M_PI / linear_frequency();
  struct problems problems = {0};
  struct case_file *c = NULL;
  struct result *out = NULL;
  struct result_file *f = NULL;
  snprintf(text, sizeof text,
           "scales: {H: 1}\n"
           "tank: {walls: [[[0, 1.5], [0, 0], [1, 0], [1, 1.5]]]}\n"
           "water: {wave: {kind: standing, amplitude: %.17g, wavelength: 2, depth: 1}}\n"
           "gauges: [{name: left, x: 0}, {name: right, x: 1}, {name: inner-left, x: 0.15},"
           " {name: inner-right, x: 0.85}]\n"
           "time: {end: %.17g, every: %.17g, sample: %.17g}\n"
           "runs: [{solver: %s, resolution: %.17g%s}]\n",
           amplitude, periods * period, period / 4, period / 120, solver, resolution, keys);
  EXPECT_OK(case_parse("standing.yaml", text, &registry, &problems, &c));
  for (size_t i = 0; i < problems.n; i++) fprintf(stderr, "%s\n", problems.text[i]);
  problems_destroy(&problems);
  if (!c || !mkdtemp(folder)) exit(1);
  struct progress *progress = progress_create(PROGRESS_QUIET);
  progress_begin(progress, solver, c->end, 1);
  snprintf(path, sizeof path, "%s/run.h5", folder);
  EXPECT_OK(result_create(path, c, &c->runs[0], &out));
  EXPECT_OK(c->runs[0].solver->run(c, &c->runs[0], out, progress));
  EXPECT_OK(result_finish(out));
  result_destroy(out);
  progress_end(progress, "done");
  progress_destroy(progress);
  case_destroy(c);
  EXPECT_OK(result_read(path, &f));
  unlink(path);
  snprintf(path, sizeof path, "%s/run.xdmf", folder);
  unlink(path);
  EXPECT(rmdir(folder) == 0);
  if (!f) exit(1);
  return f;
}

struct oscillation {
  double shift; /* omega over that of linear theory, less 1 */
  double decay; /* rate of the amplitude, 1/s */
};

/* Half the difference of two gauges at equal distances from the walls has no even harmonics. Its
 * zero crossings give the frequency and its extremes between them the decay. A constant part moves
 * crossings and extremes to and fro; it cancels in whole periods, and in the mean of an extreme
 * with those before and after it. */
static struct oscillation measure(const struct result_file *f, size_t left, size_t right) {
  const struct result_series *l = &f->gauges[left], *r = &f->gauges[right];
  double crossing[100], extreme[100] = {0};
  size_t n = 0;
  for (size_t i = 1; i < l->n && n < 99; i++) {
    double a = (l->value[i - 1] - r->value[i - 1]) / 2, b = (l->value[i] - r->value[i]) / 2;
    extreme[n] = fmax(extreme[n], fabs(b)); /* between the crossings n - 1 and n */
    if (a * b < 0) crossing[n++] = l->t[i - 1] + a / (a - b) * (l->t[i] - l->t[i - 1]);
  }
  EXPECT(n > 5);
  if (n <= 5) exit(1);
  size_t whole = (n - 1) / 2 * 2;
  double omega = M_PI * (double)whole / (crossing[whole] - crossing[0]);
#define MEAN(k) (extreme[(k)-1] / 4 + extreme[k] / 2 + extreme[(k) + 1] / 4)
  return (struct oscillation){
      .shift = omega / linear_frequency() - 1,
      .decay = log(MEAN(2) / MEAN(n - 2)) * omega / (M_PI * (double)(n - 4)),
  };
#undef MEAN
}

static void test_theory_has_its_own_frequency(void) {
  double a = 0.03, k = 2 * M_PI / wavelength;
  struct result_file *f = run("exact", 20, a, 5, "");
  struct oscillation o = measure(f, 0, 1);
  EXPECT_NEAR(o.shift, k * k * a * a * wave_frequency_shift(k, depth), 1e-5); /* interpolation */
  EXPECT_NEAR(o.decay, 0, 0.003); /* third harmonics of the product of both modes */
  result_file_destroy(f);
}

/* A viscosity nu damps the amplitude at the rate 2 nu k^2 (Lamb, Hydrodynamics, art. 348); in two
 * dimensions the artificial one is nu = alpha c0 h/8 (Monaghan, Rep. Prog. Phys. 68, 2005). */
static const double alpha = 0.01;

static double expected_decay(int resolution) {
  double k = 2 * M_PI / wavelength, h = 4.0 / 3 / resolution;
  return 2 * (alpha * 20 * sqrt(g * depth) * h / 8) * k * k;
}

/* Largest difference between the gauge on the left wall and what the inner one tells of it, in
 * particle spacings. Theory of second order has both differ by a factor, but for (ka)^2. */
static double meniscus(const struct result_file *f, int resolution) {
  const struct result_series *wall = &f->gauges[0], *inner = &f->gauges[2];
  double largest = 0;
  for (size_t i = 0; i < wall->n; i++) {
    double level = depth + (inner->value[i] - depth) / cos(2 * M_PI / wavelength * 0.15);
    EXPECT(isfinite(wall->value[i]) && isfinite(level));
    largest = fmax(largest, fabs(wall->value[i] - level) * resolution);
  }
  return largest;
}

static struct oscillation wave_of_particles(const char *walls, int resolution, double *off) {
  char keys[100];
  snprintf(keys, sizeof keys, ", alpha: %g, c0: 20 sqrt(gH), walls: %s", alpha, walls);
  struct result_file *f = run("sph", resolution, 0.03, 5, keys);
  struct oscillation o = measure(f, 2, 3);
  *off = meniscus(f, resolution);
  printf("     %s, H/dx = %d: decay over theory %.3f, shift %.4f, wall off by %.2f dx\n", walls,
         resolution, o.decay / expected_decay(resolution), o.shift, *off);
  result_file_destroy(f);
  return o;
}

/* Two errors of the decay, both of the order h, work against each other: pairs that are missing
 * above the surface take nothing out, and the diffusion takes out what it should not. */
static void test_sph_has_the_decay_of_theory_and_its_frequency_converges(void) {
  double k = 2 * M_PI / wavelength, coarse = 0, off;
  double shift = k * k * 0.03 * 0.03 * wave_frequency_shift(k, depth);
  for (int resolution = 15; resolution <= 30; resolution *= 2) {
    struct oscillation mirror = wave_of_particles("mirror", resolution, &off);
    EXPECT_NEAR(mirror.decay / expected_decay(resolution), 1, 0.05);
    EXPECT(off < 0.06);
    struct oscillation ghost = wave_of_particles("ghost", resolution, &off);
    EXPECT_NEAR(ghost.decay / expected_decay(resolution), 1, 0.1); /* their fits take out more */
    EXPECT(off < 0.2);
    EXPECT_NEAR(ghost.shift, shift, 9.0 / (resolution * resolution));
    if (coarse != 0) EXPECT(log2((coarse - shift) / (ghost.shift - shift)) > 1.7);
    coarse = ghost.shift;
  }
}

/* Largest distance in y between the surface of a run and theory of second order, over the run's
 * outputs. */
static double distance(const struct result_file *f, double amplitude) {
  struct wave_standing w = wave_standing_create(amplitude, wavelength, depth, g, 0, 0, 2);
  double largest = 0;
  for (size_t k = 0; k < f->n_surfaces; k++)
    for (size_t i = 0; i < f->surface[k].points; i++) {
      const double *p = f->surface[k].p[i];
      double y = wave_standing_elevation(&w, p[0], f->surface_time[k]);
      largest = fmax(largest, fabs(p[1] - y));
    }
  return largest;
}

/* Theory of second order leaves out (ka)^3. */
static void test_bem_differs_from_theory_by_third_order(void) {
  double before = 0;
  for (double a = 0.04; a > 0.008; a /= 2) {
    struct result_file *f = run("bem", 32, a, 4, "");
    double largest = distance(f, a);
    if (before != 0) EXPECT_NEAR(log2(before / largest), 3, 0.1);
    before = largest;
    result_file_destroy(f);
  }
}

/* 64 nodes a wavelength. Crossings are nudged by (ka)^2 of a radian by the third harmonics, which
 * over 24 periods is 1/150 of (ka)^2. */
static void test_bem_has_the_frequency_of_theory_and_its_shift_with_amplitude(void) {
  double k = 2 * M_PI / wavelength, small = 1e-3, large = 0.03;
  struct result_file *f = run("bem", 32, small, 10, "");
  EXPECT_NEAR(measure(f, 0, 1).shift, k * k * small * small * wave_frequency_shift(k, depth), 2e-6);
  EXPECT_NEAR(measure(f, 0, 1).decay, 0, 1e-4);
  result_file_destroy(f);
  f = run("bem", 32, large, 24, "");
  EXPECT_NEAR(measure(f, 0, 1).shift / (k * k * large * large), wave_frequency_shift(k, depth),
              1.0 / 150);
  result_file_destroy(f);
}

int main(void) {
  RUN(test_theory_has_its_own_frequency);
  RUN(test_bem_differs_from_theory_by_third_order);
  RUN(test_bem_has_the_frequency_of_theory_and_its_shift_with_amplitude);
  RUN(test_sph_has_the_decay_of_theory_and_its_frequency_converges);
  return TEST_RESULT;
}

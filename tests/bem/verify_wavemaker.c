/* Wavemakers of small stroke in a long tank against their linear theory: height of the waves over
 * the stroke at still water (Dean & Dalrymple, Water Wave Mechanics for Engineers and Scientists,
 * 1991, chapter 6). */
#include "tests/bem/run.h"

/* The wire is four depths away, where what decays with the distance is less than 1e-3 of the wave;
 * the waves come back from the other end after the last period only. */
static const char text[] =
    "title: wavemaker\n"
    "fluid: {density: 1, gravity: 1}\n"
    "scales: {H: 1}\n"
    "tank:\n"
    "  walls: [[[0, 2], [0, 0], [%.15g, 0], [%.15g, 2]]]\n"
    "  motions: [{kind: %s, side: left, amplitude: %.15g, period: %.15g, ramp: %.15g}]\n"
    "water: {wave: {kind: still, depth: 1}}\n"
    "time: {end: %.15g, every: %.15g, sample: %.15g}\n"
    "gauges: [{name: wire, x: 4}]\n"
    "runs: [{name: bem, solver: bem, resolution: 8}]\n";

enum { ROWS = 64 }; /* of a period */

struct maker {
  const char *kind;
  double k;       /* wave number times depth */
  double periods; /* until the wave at the wire is steady */
};

/* Height over stroke. */
static double transfer(const struct maker *m) {
  const double k = m->k, below = sinh(2 * k) + 2 * k;
  if (!strcmp(m->kind, "piston")) return 2 * (cosh(2 * k) - 1) / below;
  return 4 * sinh(k) / k * (k * sinh(k) - cosh(k) + 1) / below;
}

/* The first harmonic of the last period: trapezoidal sums, exact for all harmonics that the rows
 * resolve. */
static double harmonic(const struct result_series *s) {
  double part[2] = {0};
  for (size_t i = s->n - ROWS; i < s->n; i++) {
    const double angle = 2 * M_PI * (double)i / ROWS;
    part[0] += (s->value[i] - 1) * cos(angle) * 2 / ROWS;
    part[1] += (s->value[i] - 1) * sin(angle) * 2 / ROWS;
  }
  return hypot(part[0], part[1]);
}

static void check(const struct maker *m) {
  const double amplitude = 0.002, omega = sqrt(m->k * tanh(m->k)), period = 2 * M_PI / omega,
               group = omega / (2 * m->k) * (1 + 2 * m->k / sinh(2 * m->k)),
               end = m->periods * period, length = fmax(16, group * end / 2 + 4);
  char *filled;
  if (asprintf(&filled, text, length, length, m->kind, amplitude, period, 2 * period, end, end,
               period / ROWS) < 0)
    abort();
  struct result_file *f = run_bem(filled);
  free(filled);
  if (!f) return;
  const double found = harmonic(&f->gauges[0]) / amplitude, asked = transfer(m);
  printf("  %s, k h = %.1f: height over stroke %.4f, by theory %.4f, off by %.2f %%\n", m->kind,
         m->k, found, asked, 100 * (found / asked - 1));
  EXPECT_NEAR(found, asked, 0.01 * asked); /* what linear theory leaves out is of the stroke^2 */
  result_file_destroy(f);
}

static void test_waves_are_as_high_as_by_linear_theory(void) {
  static const struct maker makers[] = {{"piston", 0.7, 6}, {"piston", 1.5, 7}, {"piston", 3, 12},
                                        {"flap", 0.7, 6},   {"flap", 1.5, 7},   {"flap", 3, 12}};
  for (size_t i = 0; i < sizeof makers / sizeof *makers; i++) check(&makers[i]);
}

int main(void) {
  RUN(test_waves_are_as_high_as_by_linear_theory);
  return TEST_RESULT;
}

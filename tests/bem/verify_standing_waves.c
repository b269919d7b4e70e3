/* Standing waves at rest at their highest, between walls half a wavelength apart, for a hundred
 * periods: none dies of the sawtooth of two spacings, and the energy that the wave has, what the
 * filter took added back, stays. Heights count from the level at rest, so that the volume's own
 * error does not count as energy of the wave. */
#include "tests/bem/run.h"

static const char text[] =
    "title: standing wave\n"
    "fluid: {density: 1, gravity: 1}\n"
    "scales: {H: %.15g}\n"
    "tank: {walls: [[[0, %g], [0, 0], [0.5, 0], [0.5, %g]]]}\n"
    "water: {wave: {kind: standing, amplitude: %.15g, wavelength: 1, depth: %g}}\n"
    "time: {end: %.15g, every: %.15g, sample: %.15g}\n"
    "runs: [{name: bem, solver: bem, resolution: %.15g}]\n";

enum { PERIODS = 100 };

/* nodes: per wavelength. */
static void expect_alive(double steepness, double depth, int nodes, double bound) {
  const double k = 2 * M_PI, a = steepness / k, omega = sqrt(k * tanh(k * depth)),
               period = 2 * M_PI / omega, rest = 0.5 * 0.5 * depth * depth;
  char with[sizeof text + 200];
  snprintf(with, sizeof with, text, depth, depth + 0.5, depth + 0.5, a, depth, PERIODS * period,
           10 * period, period / 2, nodes * depth);
  double start = progress_wall_clock(), initial = 0, drift = 0, budget = 0;
  struct result_file *f = run_bem(with);
  if (!f) return;
  for (size_t i = 0; i < f->n_energy; i++) {
    double e = f->energy[i].total - depth * f->steps[i].volume + rest;
    if (i == 0) initial = e;
    drift = fmax(drift, fabs(e / initial - 1));
    budget = fmax(budget, fabs((e + f->energy[i].term[0]) / initial - 1));
  }
  double reached = f->energy[f->n_energy - 1].time / period;
  printf(
      "  ka = %.2f, d = %.3f wavelengths, %d nodes: %.1f periods, energy %.1e, with the filter's "
      "share %.1e, %.0f evaluations, %.1f s %s\n",
      steepness, depth, nodes, reached, drift, budget, run_statistic(f, "evaluations"),
      progress_wall_clock() - start, f->ended);
  fflush(stdout);
  EXPECT(reached > PERIODS - 0.6);
  EXPECT(budget < bound);
  result_file_destroy(f);
}

static void test_standing_waves_live_on_and_keep_their_energy(void) {
  expect_alive(0.01, 2, 64, 1e-4);
  expect_alive(0.02, 0.0796, 64, 1e-4);
  expect_alive(0.1, 0.2, 64, 1e-4);
}

int main(void) {
  RUN(test_standing_waves_live_on_and_keep_their_energy);
  return TEST_RESULT;
}

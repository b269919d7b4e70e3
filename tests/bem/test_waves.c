/* Small standing waves, depth half a wavelength: omega^2 = g k tanh(k d) up to terms of order
 * (ka)^2, here (2 pi 5e-4)^2/8 = 1.2e-6 of the frequency (Tadjbakhsh & Keller 1960). */
#include "tests/bem/run.h"

static const char text[] =
    "title: standing wave\n"
    "fluid: {density: 1, gravity: 1}\n"
    "scales: {H: 1}\n"
    "tank: {walls: [[[0, 2], [0, 0], [3, 0], [3, 2]]]}\n"
    "water: {wave: {kind: standing, amplitude: %g, wavelength: 1, depth: 0.5}}\n"
    "time: {end: %g, every: %g, sample: 0.01}\n"
    "gauges: [{name: left, x: 0}]\n"
    "runs: [{name: bem, solver: bem, resolution: %d}]\n";

struct wave {
  double frequency; /* relative to theory */
  double drift;     /* largest relative change of the wave's energy */
  double budget;    /* the same with what the filter took */
};

/* Over ten periods; frequency from the zeros of the elevation at the left wall between first and
 * last. */
static struct wave standing(int nodes) {
  const double amplitude = 5e-4, k = 2 * M_PI, omega = sqrt(k * tanh(0.5 * k)),
               end = 20 * M_PI / omega;
  char with[sizeof text + 80];
  struct wave out = {NAN, 0, 0};
  snprintf(with, sizeof with, text, amplitude, end, end, nodes);
  struct result_file *f = run_bem(with);
  if (!f) return out;
  const struct result_series *g = &f->gauges[0];
  double first = 0, last = 0;
  int zeros = 0;
  for (size_t i = 2; i + 1 < g->n; i++) { /* cubic through four samples, by its inverse */
    double y[4] = {g->value[i - 2] - 0.5, g->value[i - 1] - 0.5, g->value[i] - 0.5,
                   g->value[i + 1] - 0.5};
    if (y[1] * y[2] > 0) continue;
    double t = 0;
    for (int a = 0; a < 4; a++) {
      double term = g->t[i - 2 + (size_t)a];
      for (int b = 0; b < 4; b++)
        if (b != a) term *= y[b] / (y[b] - y[a]);
      t += term;
    }
    if (!zeros++) first = t;
    last = t;
  }
  out.frequency = M_PI * (zeros - 1) / (last - first) / omega - 1;
  /* energy of the wave: kinetic + 1/2 integral (y - 1/2)^2 dx */
  double initial = 0;
  for (size_t i = 0; i < f->n_energy; i++) {
    double e = f->energy[i].total - 0.5 * f->steps[i].volume + 0.5 * 0.25 * 3;
    if (i == 0) initial = e;
    out.drift = fmax(out.drift, fabs(e / initial - 1));
    out.budget = fmax(out.budget, fabs((e + f->energy[i].term[0]) / initial - 1));
  }
  printf("  %3d nodes per wavelength: frequency %+.2e, energy %.1e, with the filter's share %.1e, "
         "%.0f CVODE steps, %.0f "
         "evaluations, %.0f "
         "initialisations\n",
         nodes, out.frequency, out.drift, out.budget, run_statistic(f, "cvode_steps"),
         run_statistic(f, "evaluations"), run_statistic(f, "initialisations"));
  EXPECT(run_statistic(f, "initialisations") == 1);
  result_file_destroy(f);
  return out;
}

/* Differences of twelfth order are off by (kh)^12 (6!)^2/13! of a slope: 3.5e-8 with 12 nodes,
 * 9e-12 with 24. What is left is the amplitude's own: 1.2e-6, and second harmonics of the order ka
 * at the wall, which move its zeros by no more than their part of a radian. */
static void test_standing_wave_frequency_and_energy_are_exact_with_few_nodes(void) {
  const double slope = 3.5e-8, integrator = 3e-8;
  const struct wave coarse = standing(12), fine = standing(24), usual = standing(64);
  EXPECT_NEAR(coarse.frequency, usual.frequency, 3 * slope + integrator);
  EXPECT_NEAR(fine.frequency, usual.frequency, integrator);
  EXPECT_NEAR(usual.frequency, 0, 1e-5);
  EXPECT(coarse.budget < 1e-6 && fine.budget < 1e-6 && usual.drift < 1e-6);
}

/* kH = 0.5, ka = 0.02: without the filter a sawtooth of two spacings ends it at 27 periods. */
static void test_gentle_waves_outlive_the_sawtooth(void) {
  static const char gentle[] =
      "title: gentle wave\n"
      "fluid: {density: 1, gravity: 1}\n"
      "scales: {H: 0.5}\n"
      "tank: {walls: [[[0, 1], [0, 0], [3.14159265358979, 0], [3.14159265358979, 1]]]}\n"
      "water: {wave: {kind: standing, amplitude: 0.02, wavelength: 6.28318530717958, depth: 0.5}}\n"
      "time: {end: 369.7, every: 9.2425, sample: 2.310625}\n" /* 40 periods of 9.2429 */
      "runs: [{name: bem, solver: bem, resolution: 5}]\n";
  struct result_file *f = run_bem(gentle);
  if (!f) return;
  double initial = 0, budget = 0, lost = 0;
  for (size_t i = 0; i < f->n_energy; i++) {
    double e = f->energy[i].total - 0.5 * f->steps[i].volume + 0.5 * 0.25 * M_PI;
    if (i == 0) initial = e;
    lost = f->energy[i].term[0] / initial;
    budget = fmax(budget, fabs((e + f->energy[i].term[0]) / initial - 1));
  }
  printf("  gentle wave: %.1f periods, filter %.1e of its energy, unaccounted %.1e\n",
         f->energy[f->n_energy - 1].time / 9.2429, lost, budget);
  EXPECT(f->energy[f->n_energy - 1].time > 369 && !*f->ended);
  EXPECT(budget < 1e-4);
  result_file_destroy(f);
}

/* A crest 15 h from either wall, whose tails end there with a kink of a millionth of its height:
 * the surface is smooth all the same, and integrated as such, without a new start. */
static void test_a_solitary_wave_between_walls_is_smooth(void) {
  struct result_file *f =
      run_bem("title: solitary\n"
              "fluid: {density: 1, gravity: 1}\n"
              "scales: {H: 1}\n"
              "tank: {walls: [[[0, 2], [0, 0], [32, 0], [32, 2]]]}\n"
              "water: {wave: {kind: solitary, amplitude: 0.3, depth: 1, x: 15}}\n"
              "time: {end: 1, every: 1, sample: 0.1}\n"
              "runs: [{name: bem, solver: bem, resolution: 8, tolerance: 1e-5}]\n");
  if (!f) return;
  EXPECT(run_statistic(f, "initialisations") == 1);
  result_file_destroy(f);
}

static void test_still_water_stays_still_under_hydrostatic_pressure(void) {
  struct result_file *f =
      run_bem("title: tank at rest\n"
              "fluid: {density: 1000, gravity: 9.81}\n"
              "scales: {H: 0.5}\n"
              "tank: {walls: [[[1, 1], [1, 0], [2.2, 0], [2.2, 1]]]}\n"
              "water: {regions: [[[1, 0], [2.2, 0], [2.2, 0.5], [1, 0.5]]]}\n"
              "time: {end: 2, every: 1, sample: 0.1}\n"
              "probes: [{name: low, at: [1, 0.1]}, {name: bed, at: [1.7, 0], size: 0.1}, "
              "{name: dry, at: [2.2, 0.7]}]\n"
              "gauges: [{name: middle, x: 1.5}]\n"
              "runs: [{name: bem, solver: bem, resolution: 20}]\n");
  if (!f) return;
  for (size_t i = 0; i < f->n_energy; i++) EXPECT_NEAR(f->energy[i].kinetic, 0, 1e-12);
  const double expected[3] = {1000 * 9.81 * 0.4, 1000 * 9.81 * 0.5, 0};
  for (size_t p = 0; p < 3; p++)
    for (size_t i = 0; i < f->probes[p].n; i++)
      EXPECT_NEAR(f->probes[p].value[i], expected[p], 1e-6);
  for (size_t i = 0; i < f->gauges[0].n; i++) EXPECT_NEAR(f->gauges[0].value[i], 0.5, 1e-12);
  result_file_destroy(f);
}

int main(void) {
  RUN(test_standing_wave_frequency_and_energy_are_exact_with_few_nodes);
  RUN(test_gentle_waves_outlive_the_sawtooth);
  RUN(test_a_solitary_wave_between_walls_is_smooth);
  RUN(test_still_water_stays_still_under_hydrostatic_pressure);
  return TEST_RESULT;
}

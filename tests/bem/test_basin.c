/* Tanks that are not rectangular. */
#include "tests/bem/run.h"

/* ---- still water ---- */

static const char still[] = "title: tank at rest\n"
                            "fluid: {density: 1000, gravity: 9.81}\n"
                            "scales: {H: 0.5}\n"
                            "tank: {walls: [%s]}\n"
                            "water: {wave: {kind: still, depth: 0.5}}\n"
                            "time: {end: 4.6, every: 4.6, sample: 0.23}\n"
                            "probes: [{name: slope, at: [%s], size: 0.02}]\n"
                            "gauges: [{name: middle, x: 1.5}]\n"
                            "runs: [{name: bem, solver: bem, resolution: 20, tolerance: 1e-9}]\n";

/* For 20 sqrt(H/g): rounding alone moves it, up to the tolerance, as steps are as long as damping
 * stands them. */
static void test_still_water_stays_still_in_any_tank(void) {
  static const struct {
    const char *name, *walls, *probe;
    double y; /* of the probe */
  } tank[] = {
      {"inclined", "[[0.1, 1.4], [1, 0.5], [1.5, 0], [3.5, 2]]", "1.75, 0.25", 0.25},
      {"wedge", "[[0.5, 1], [1.5, 0], [2.5, 1]]", "1.3, 0.2", 0.2},
      {"step", "[[1, 1], [1, 0], [2, 0], [2, 0.3], [3, 0.3], [3, 1]]", "2, 0.15", 0.15},
      {"beach", "[[1, 1], [1, 0], [1.6, 0], [4.6, 1]]", "2.2, 0.2", 0.2},
      {"bar", "[[1, 1], [1, 0], [1.7, 0], [2, 0.2], [2.3, 0.2], [2.5, 0], [3, 0], [3, 1]]",
       "2.4, 0.1", 0.1},
  };
  for (size_t i = 0; i < sizeof tank / sizeof *tank; i++) {
    char text[sizeof still + 200];
    snprintf(text, sizeof text, still, tank[i].walls, tank[i].probe);
    struct result_file *f = run_bem(text);
    double speed = 0, change = 0, pressure = 0, level = 0;
    for (size_t k = 0; f && k < f->n_energy; k++) {
      speed =
          fmax(speed, sqrt(2 * f->energy[k].kinetic / 1000 / f->steps[k].volume / (9.81 * 0.5)));
      change = fmax(change, fabs(f->energy[k].total / f->energy[0].total - 1));
      pressure =
          fmax(pressure, fabs(f->probes[0].value[k] / (1000 * 9.81 * (0.5 - tank[i].y)) - 1));
      level = fmax(level, fabs(f->gauges[0].value[k] - 0.5));
    }
    printf("  %-8s: speed %.1e sqrt(gH), energy changed by %.1e, pressure off by %.1e, level by "
           "%.1e m\n",
           tank[i].name, speed, change, pressure, level);
    EXPECT(f && f->n_energy == 21);
    EXPECT(speed < 1e-8 && change < 1e-9 && pressure < 1e-9 && level < 1e-9);
    result_file_destroy(f);
  }
}

/* ---- a wedge of 90 degrees ---- */

/* phi = A x y is harmonic and has no flux through y = |x|, and on the surface y = h the linear
 * condition phi_tt + g phi_y = 0 holds at any x if A'' = -(g/h) A: a flat surface that tilts to and
 * fro (Lamb, Hydrodynamics, art. 258). Here at rest at its steepest. */
static void test_water_in_a_wedge_sloshes_as_theory_says(void) {
  struct result_file *f =
      run_bem("title: wedge\n"
              "fluid: {density: 1, gravity: 1}\n"
              "scales: {H: 1}\n"
              "tank: {walls: [[[-2, 2], [0, 0], [2, 2]]]}\n"
              "water: {regions: [[[0, 0], [1.0005, 1.0005], [-0.9995, 0.9995]]]}\n"
              "time: {end: 32, every: 32, sample: 0.02}\n"
              "gauges: [{name: side, x: 0.8}]\n"
              "runs: [{name: bem, solver: bem, resolution: 20, tolerance: 1e-9}]\n");
  if (!f) return;
  const struct result_series *g = &f->gauges[0];
  double first = 0, last = 0, volume = 0, energy = 0;
  int zeros = 0;
  for (size_t i = 0; i + 1 < g->n; i++) {
    const double a = g->value[i] - 1, b = g->value[i + 1] - 1;
    if (a * b > 0) continue;
    last = g->t[i] + (g->t[i + 1] - g->t[i]) * a / (a - b);
    if (!zeros++) first = last;
  }
  for (size_t i = 0; i < f->n_energy; i++) {
    volume = fmax(volume, fabs(f->steps[i].volume - f->steps[0].volume));
    energy = fmax(energy, fabs(f->energy[i].total - f->energy[0].total));
  }
  const double frequency = M_PI * (zeros - 1) / (last - first);
  printf("  frequency %.6f in %d half periods, volume changed by %.1e, energy by %.1e\n", frequency,
         zeros - 1, volume, energy);
  EXPECT(zeros >= 10);
  EXPECT_NEAR(frequency, 1, 2e-5); /* the zeros are interpolated to 2e-5 of a half period */
  EXPECT(volume < 1e-9 && energy < 1e-9);
  result_file_destroy(f);
}

/* Corners of the water on a slope are off it by rounding, to either side. */
static void test_water_may_begin_anywhere_on_a_slope(void) {
  for (int i = 1; i < 30; i++) {
    char text[400];
    const double x = 1.6 + 0.1 * i, y = (x - 1.6) / 3;
    snprintf(text, sizeof text,
             "title: slope\nfluid: {density: 1, gravity: 1}\nscales: {H: 0.5}\n"
             "tank: {walls: [[[1, 1], [1, 0], [1.6, 0], [4.6, 1]]]}\n"
             "water: {regions: [[[1, 0], [1.6, 0], [%.15g, %.15g], [1, 0.46]]]}\n"
             "time: {end: 1}\nruns: [{solver: bem, resolution: 20}]\n",
             x, y);
    struct case_file *c = run_case(text);
    EXPECT(c != NULL);
    case_destroy(c);
  }
}

/* ---- a wave over a bar ---- */

struct drift {
  double volume, energy; /* largest changes, of all and of the wave's */
};

static struct drift over_a_bar(int resolution) {
  static const char bar[] =
      "title: bar\n"
      "fluid: {density: 1, gravity: 1}\n"
      "scales: {H: 1}\n"
      "tank: {walls: [[[0, 2], [0, 0], [3, 0], [4, 0.6], [5, 0.6], [6, 0], [8, 0], [8, 2]]]}\n"
      "water: {wave: {kind: standing, amplitude: 0.03, wavelength: 8, depth: 1}}\n"
      "time: {end: 20, every: 20, sample: 0.5}\n"
      "runs: [{name: bem, solver: bem, resolution: %d}]\n";
  const double wave = 0.03 * 0.03 * 8 / 4;
  char text[sizeof bar + 20];
  struct drift d = {0, 0};
  snprintf(text, sizeof text, bar, resolution);
  struct result_file *f = run_bem(text);
  if (!f) return (struct drift){NAN, NAN};
  for (size_t i = 0; i < f->n_energy; i++) {
    const double filtered = f->energy[i].term[0];
    d.volume = fmax(d.volume, fabs(f->steps[i].volume / f->steps[0].volume - 1));
    d.energy = fmax(d.energy, fabs(f->energy[i].total + filtered - f->energy[0].total) / wave);
  }
  EXPECT_NEAR(f->steps[0].volume, 6.8, 1e-6); /* 8 less the bar */
  printf("  %d nodes per H: volume changed by %.1e, energy by %.1e of the wave's\n", resolution,
         d.volume, d.energy);
  result_file_destroy(f);
  return d;
}

/* Fourth order. */
static void test_a_wave_over_a_bar_keeps_its_water_and_its_energy(void) {
  const struct drift coarse = over_a_bar(10), fine = over_a_bar(20);
  EXPECT(log2(coarse.volume / fine.volume) > 3.5 && log2(coarse.energy / fine.energy) > 3.5);
  EXPECT(fine.volume < 5e-8 && fine.energy < 2e-4);
}

/* ---- bends ---- */

/* Edges run up a slope to where it becomes steeper, or gentler, and on. */
static void test_an_edge_passes_bends(void) {
  static const struct {
    const char *name, *slopes;
    double wavelength, x; /* of the bend */
  } tank[] = {{"steeper", "[2, 1], [3, 2]", 7.8, 2}, {"gentler", "[1.01, 1.01], [4, 2]", 6, 1.01}};
  for (size_t i = 0; i < sizeof tank / sizeof *tank; i++) {
    char text[500];
    snprintf(text, sizeof text,
             "title: bend\n"
             "fluid: {density: 1, gravity: 1}\n"
             "scales: {H: 1}\n"
             "tank: {walls: [[[-2, 2], [-2, 0], [0, 0], %s]]}\n"
             "water: {wave: {kind: standing, amplitude: 0.05, wavelength: %g, depth: 0.98}}\n"
             "time: {end: 4, every: 4, sample: 0.2}\n"
             "runs: [{name: bem, solver: bem, resolution: 12}]\n",
             tank[i].slopes, tank[i].wavelength);
    struct result_file *f = run_bem(text);
    if (!f) continue;
    const struct result_event_read bend = run_event(f, "bend");
    const struct result_energy *last = f->energy + f->n_energy - 1;
    const double wave = 0.05 * 0.05 * tank[i].wavelength / 8, first = f->energy[0].total;
    const double energy = (last->total + last->term[0] + last->removed - first) / wave;
    const double volume = f->steps[f->n_energy - 1].volume / f->steps[0].volume - 1;
    printf("  %s: at t = %.3f, x = %.4f; energy changed by %.1e of the wave's, volume by %.1e\n",
           tank[i].name, bend.time, bend.x, energy, volume);
    EXPECT(last->time > 3.99 && bend.x > tank[i].x && bend.x < tank[i].x + 0.02);
    EXPECT(fabs(energy) < 0.02 && fabs(volume) < 1e-4);
    result_file_destroy(f);
  }
}

int main(void) {
  RUN(test_still_water_stays_still_in_any_tank);
  RUN(test_water_in_a_wedge_sloshes_as_theory_says);
  RUN(test_water_may_begin_anywhere_on_a_slope);
  RUN(test_a_wave_over_a_bar_keeps_its_water_and_its_energy);
  RUN(test_an_edge_passes_bends);
  return TEST_RESULT;
}

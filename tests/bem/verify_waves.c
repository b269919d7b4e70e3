/* Waves whose course is known exactly, by boundary elements: steady waves over twenty periods, a
 * solitary wave over a hundred depths, and the frequency of standing waves of finite height. */
#include "common/flow/crest.h"
#include "common/flow/waves.h"
#include "tests/bem/run.h"

/* ---- steady waves ---- */

/* Solved directly: GMRES at its least residual of 1e-11 leaves 1e-7 of the energy in 20 periods. */
static const char steady[] =
    "title: steady wave\n"
    "fluid: {density: 1, gravity: 1}\n"
    "scales: {H: 1}\n"
    "tank: {walls: [[[0, 3], [0, 0], [%.15g, 0], [%.15g, 3]]], sides: periodic}\n"
    "water: {wave: {kind: stream, height: %.15g, wavelength: %.15g, depth: 1}}\n"
    "time: {end: %.15g, every: %.15g, sample: %.15g}\n"
    "runs: [{name: bem, solver: bem, resolution: %.15g, tolerance: 1e-6, dense: 400}]\n";

struct course {
  double phase;  /* rad, after the last period */
  double growth; /* of its height, relative */
  double shape;  /* rms of the surface's distance in height from the wave that is so far, over H */
  double drift;  /* largest change of the energy with the filter's share, over that of the wave */
  double taken;  /* by the filter, over the same */
};

/* rms of y - eta(x - ahead) at the points of a surface. */
static double misfit(const struct geo_lines *s, const struct crest *w, double ahead) {
  double sum = 0;
  for (size_t k = 0; k < s->points; k++) {
    const double x = remainder(s->p[k][0] - ahead, w->length);
    sum += pow(s->p[k][1] - 1 - wave_crest_elevation(w, x), 2);
  }
  return sqrt(sum / (double)s->points);
}

/* How much higher the wave is, by its part of what is off. */
static double growth(const struct geo_lines *s, const struct crest *w, double ahead) {
  double part = 0, whole = 0;
  for (size_t k = 0; k < s->points; k++) {
    const double eta = wave_crest_elevation(w, remainder(s->p[k][0] - ahead, w->length));
    part += (s->p[k][1] - 1 - eta) * eta;
    whole += eta * eta;
  }
  return part / whole;
}

/* That of the wave which fits best: the minimum of a parabola in the square, which it nearly is. */
static double best_ahead(const struct geo_lines *s, const struct crest *w) {
  double ahead = w->length / 2, step = 0.01;
  for (int i = 0; i < 12; i++, step /= 4) {
    const double a = pow(misfit(s, w, ahead - step), 2), b = pow(misfit(s, w, ahead), 2),
                 c = pow(misfit(s, w, ahead + step), 2);
    if (a + c > 2 * b) ahead += fmax(-1, fmin(1, 0.5 * (a - c) / (a + c - 2 * b))) * step;
  }
  return ahead;
}

/* So many times round its length, and half of it, so that its crest should be in the middle. */
static struct course follow(const struct crest *w, int nodes, int rounds) {
  struct course out = {NAN, NAN, NAN, 0, 0};
  char text[sizeof steady + 200];
  const double end = (rounds + 0.5) * w->length / w->speed;
  snprintf(text, sizeof text, steady, w->length, w->length, w->height, w->length, end, end,
           end / 80, nodes / w->length);
  const double start = progress_wall_clock(), whole = w->kinetic + w->potential;
  struct result_file *f = run_bem(text);
  if (!f) return out;
  EXPECT(!*f->ended && f->n_surfaces == 2);
  const struct geo_lines *last = &f->surface[f->n_surfaces - 1];
  const double ahead = best_ahead(last, w);
  out.phase = 2 * M_PI * ahead / w->length - M_PI;
  out.growth = growth(last, w, ahead);
  out.shape = misfit(last, w, ahead) / w->height;
  for (size_t i = 0; i < f->n_energy; i++) {
    const double e = f->energy[i].total - f->steps[i].volume; /* heights from the mean level */
    const double first = f->energy[0].total - f->steps[0].volume;
    out.taken = f->energy[i].term[0] / whole;
    out.drift = fmax(out.drift, fabs((e - first) / whole + out.taken));
  }
  printf("  lambda = %.4g h, H = %.4g h, %3d nodes: phase %+.2e rad, height %+.1e, shape %.1e H, "
         "energy %.1e, "
         "filter %.1e, %.0f evaluations, %.1f s\n",
         w->length, w->height, nodes, out.phase, out.growth, out.shape, out.drift, out.taken,
         run_statistic(f, "evaluations"), progress_wall_clock() - start);
  fflush(stdout);
  result_file_destroy(f);
  return out;
}

/* What is asked of steady waves over twenty periods. */
static void expect_exact(const struct course *c) {
  EXPECT(fabs(c->phase) < 1e-7 && c->shape < 1e-7 && c->drift < 1e-7);
}

/* Of twelfth order where it is resolved: from 64 to 128 nodes the crest of Fenton's wave, 85 % of
 * the limit, only becomes so. */
static void test_steady_waves_keep_their_pace_shape_and_energy(void) {
  struct crest fenton, steep;
  EXPECT_OK(wave_crest_create_periodic(0.2, 1.6526, &fenton));
  EXPECT_OK(wave_crest_create_periodic(0.9 * wave_crest_limit(6.2), 6.2, &steep));
  const struct course coarse = follow(&fenton, 64, 20), fine = follow(&fenton, 128, 20);
  const struct course highest = follow(&steep, 192, 20);
  EXPECT(log2(coarse.phase / fine.phase) > 5 && log2(coarse.drift / fine.drift) > 5);
  EXPECT(log2(coarse.shape / fine.shape) > 5);
  expect_exact(&fine);
  expect_exact(&highest);
  wave_crest_destroy(&fenton);
  wave_crest_destroy(&steep);
}

/* ---- the solitary wave ---- */

/* As a steady wave of 25 depths, to 1e-4 of its height (4 exp(-kappa 12.5)) a solitary one on the
 * water of its troughs: four times round, and half, are 112 depths. */
static void test_a_solitary_wave_keeps_speed_and_height_over_a_hundred_depths(void) {
  struct crest w;
  EXPECT_OK(wave_crest_create_periodic(0.3, 25, &w));
  const struct course coarse = follow(&w, 150, 4), fine = follow(&w, 300, 4);
  const double depths = 25 / (2 * M_PI) / 112.5; /* of the way, for each radian */
  EXPECT(fabs(coarse.phase) * depths < 1e-5 && fabs(fine.phase) * depths < 1e-6);
  EXPECT(fabs(fine.growth) < 1e-5);
  wave_crest_destroy(&w);
}

/* ---- standing waves of finite height ---- */

static const char standing[] =
    "title: standing wave\n"
    "fluid: {density: 1, gravity: 1}\n"
    "scales: {H: 1}\n"
    "tank: {walls: [[[0, 3], [0, 0], [0.5, 0], [0.5, 3]]]}\n"
    "water: {wave: {kind: standing, amplitude: %.15g, wavelength: 1, depth: %.15g, order: 2}}\n"
    "time: {end: %.15g, every: %.15g, sample: %.15g}\n"
    "gauges: [{name: a, x: 0}, {name: b, x: 0.125}, {name: c, x: 0.25}, {name: d, x: 0.375}, "
    "{name: e, x: 0.5}]\n"
    "runs: [{name: bem, solver: bem, resolution: %d, tolerance: 1e-4, gmres: 1e-10}]\n";

enum { BEATS = 10 }; /* periods */

/* What the surface has of cos kx, by the five wires between the walls: none of the next five
 * harmonics, bound or free, which move the zeros at a wire. */
static double first_mode(const struct result_file *f, size_t row) {
  double sum = 0;
  for (size_t i = 0; i < 5; i++)
    sum += (i % 4 ? 0.5 : 0.25) * f->gauges[i].value[row] * cos(M_PI * (double)i / 4);
  return sum;
}

/* (omega/omega0 - 1)/(ka)^2, from the first zero of that and the last. */
static double shift_of(double steepness, double kd, int nodes) {
  const double k = 2 * M_PI, d = kd / k, omega = sqrt(k * tanh(kd)), period = 2 * M_PI / omega;
  char text[sizeof standing + 160];
  double first = 0, last = 0;
  int zeros = 0;
  snprintf(text, sizeof text, standing, steepness / k, d, BEATS * period, BEATS * period,
           period / 200, nodes);
  struct result_file *f = run_bem(text);
  if (!f) return NAN;
  const struct result_series *g = &f->gauges[0];
  for (size_t i = 2; i + 1 < g->n; i++) { /* cubic through four samples, by its inverse */
    double y[4], t = 0;
    for (size_t a = 0; a < 4; a++) y[a] = first_mode(f, i - 2 + a);
    if (y[1] * y[2] > 0) continue;
    for (size_t a = 0; a < 4; a++) {
      double term = g->t[i - 2 + a];
      for (size_t b = 0; b < 4; b++)
        if (b != a) term *= y[b] / (y[b] - y[a]);
      t += term;
    }
    if (!zeros++) first = t;
    last = t;
  }
  result_file_destroy(f);
  return (M_PI * (zeros - 1) / (last - first) / omega - 1) / (steepness * steepness);
}

/* Tadjbakhsh & Keller (1960): omega = omega0 (1 + c (ka)^2 + O((ka)^4)); the next term goes by two
 * heights. */
static void test_standing_waves_have_the_frequency_of_tadjbakhsh_and_keller(void) {
  static const struct {
    double kd, steepness;
    int nodes;
  } wave[] = {{0.5, 0.01, 96}, {0.8, 0.02, 96}, {1.5, 0.08, 96}, {2, 0.08, 96}, {3, 0.08, 96}};
  for (size_t i = 0; i < sizeof wave / sizeof *wave; i++) {
    const double theory = wave_frequency_shift(1, wave[i].kd);
    const double low = shift_of(wave[i].steepness, wave[i].kd, wave[i].nodes),
                 high = shift_of(2 * wave[i].steepness, wave[i].kd, wave[i].nodes),
                 found = (4 * low - high) / 3;
    printf("  kH = %.1f: ka %.2f and %.2f %.6f, %.6f; together %.6f, theory %.6f: %+.2f %%\n",
           wave[i].kd, wave[i].steepness, 2 * wave[i].steepness, low, high, found, theory,
           100 * (found / theory - 1));
    fflush(stdout);
    EXPECT_NEAR(found, theory, 0.01 * fabs(theory));
  }
}

int main(void) {
  RUN(test_a_solitary_wave_keeps_speed_and_height_over_a_hundred_depths);
  RUN(test_steady_waves_keep_their_pace_shape_and_energy);
  RUN(test_standing_waves_have_the_frequency_of_tadjbakhsh_and_keller);
  return TEST_RESULT;
}

/* What a run leaves in its file: energies above rest, mass and volume of the particles, gauges. */
#include "tests/test.h"

#include <unistd.h>

#include "common/base/progress.h"
#include "common/result/result.h"
#include "sph/fluid/energy.h"
#include "sph/observe/gauge.h"
#include "tests/common/result_water.h"
#include "tests/sph/pool.h"

/* Mechanical energy at the start above the solver's own water at rest, J/m. */
static double above_rest(const char *head, const char *run, double *potential) {
  struct case_file *c = pool_case(head, run);
  struct sph *s = pool_create(c);
  struct result_energy e = sph_energy(s);
  *potential = e.potential;
  double above = e.kinetic + e.potential - sph_rest_potential(s);
  sph_destroy(s);
  case_destroy(c);
  return above;
}

/* Compression by its own weight is no energy that could become motion. Rounding of sums. */
static void test_still_water_is_at_rest(void) {
  static const char *const runs[] = {"resolution: 20", "resolution: 23.85, c0: 45"};
  for (int k = 0; k < 2; k++) {
    double potential, above = above_rest(POOL_STILL, runs[k], &potential);
    EXPECT_NEAR(above / potential, 0, 1e-12);
  }
}

/* A wave of k a = 0.05, rho g a^2/4 a metre, with 6.6 times as much elastic energy under it. What
 * is left is the exchange with that energy, of the order g d/c0^2. */
static void test_wave_starts_with_its_energy(void) {
  const double a = 0.05 / M_PI;
  for (int k = 0; k < 4; k++) {
    char run[100];
    double froude = k < 2 ? 20 : 40, potential;
    snprintf(run, sizeof run, "resolution: %d, c0: %g sqrt(gH)", k % 2 ? 40 : 20, froude);
    double above = above_rest(
        "title: wave\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [1, 0], [1, 2]]]}\n"
        "water: {wave: {kind: standing, amplitude: 0.0159155, wavelength: 2, depth: "
        "1}}\n" POOL_TIMES,
        run, &potential);
    printf("     %s: energy over that of the wave %.5f\n", run, above / (9810 * a * a / 4));
    EXPECT_NEAR(above / (9810 * a * a / 4), 1, 1 / (froude * froude));
  }
}

/* The rest level is that of the mass: a dam break has rho g/2 (H^2 L - L^2 H^2/W) above it, less by
 * the compression, which is of the order g H/c0^2 of it. */
static void test_dam_break_has_the_energy_of_its_fall(void) {
  double potential, above = above_rest(POOL_DAM, "resolution: 30", &potential);
  double expected = 9810 * 0.6 * 0.6 * 0.6 * (1 - 2 / 5.366);
  EXPECT_NEAR(above / expected, 1, 1. / 400);
}

/* ---- the file ---- */

static bool text_holds(const char *path, const char *word) {
  static char text[100000];
  FILE *in = fopen(path, "r");
  if (!in) return false;
  text[fread(text, 1, sizeof text - 1, in)] = 0;
  fclose(in);
  return strstr(text, word) != NULL;
}

static double *field_of(const struct result_file *f, size_t output, const char *name) {
  struct result_water water;
  EXPECT_OK(water_read(f->path, name, false, output, &water));
  free(water.p);
  return water.value[0];
}

/* Every output has the particles' masses, the same ones, and volumes that sum to the series'. */
static void expect_masses(const struct result_file *f, double mass) {
  double *m[2];
  for (size_t k = 0; k < 2; k++) {
    m[k] = field_of(f, k, "mass");
    double *V = field_of(f, k, "volume"), *rho = field_of(f, k, "density"), sum = 0, volume = 0;
    for (int64_t i = 0; i < f->output_points[k]; i++) {
      EXPECT_NEAR(V[i] * rho[i] / m[k][i], 1, 1e-14);
      sum += m[k][i];
      volume += V[i];
    }
    EXPECT_NEAR(sum / mass, 1, 1e-12);
    if (k == 0) EXPECT_NEAR(volume / f->steps[0].volume, 1, 1e-12);
    free(V);
    free(rho);
  }
  EXPECT(memcmp(m[0], m[1], (size_t)f->output_points[0] * sizeof **m) == 0);
  free(m[0]);
  free(m[1]);
}

struct finished {
  char folder[32], path[64], xdmf[64];
  struct case_file *c;
  struct result_file *f;
};

static struct finished finished_create(const char *head, const char *keys) {
  struct finished a = {.folder = "/tmp/plunge-output-XXXXXX", .c = pool_case(head, keys)};
  EXPECT(mkdtemp(a.folder));
  snprintf(a.path, sizeof a.path, "%s/run.h5", a.folder);
  snprintf(a.xdmf, sizeof a.xdmf, "%s/run.xdmf", a.folder);
  struct progress *progress = progress_create(PROGRESS_QUIET);
  struct result *out = NULL;
  EXPECT_OK(result_create(a.path, a.c, &a.c->runs[0], &out));
  EXPECT_OK(sph_solver.run(a.c, &a.c->runs[0], out, progress));
  EXPECT_OK(result_finish(out));
  result_destroy(out);
  progress_destroy(progress);
  EXPECT_OK(result_read(a.path, &a.f));
  if (!a.f) exit(1);
  return a;
}

static void finished_destroy(struct finished *a) {
  result_file_destroy(a->f);
  case_destroy(a->c);
  unlink(a->path);
  unlink(a->xdmf);
  EXPECT(rmdir(a->folder) == 0);
}

/* How often treatments came: after 7, 14, ... of 50 steps. */
static void test_treatments_are_counted(void) {
  struct finished a = finished_create(
      "title: drop\nscales: {H: 1}\ntank: {walls: [[[0, 3], [0, 0], [3, 0], [3, 3]]]}\n"
      "water: {regions: [[[1, 1], [2, 1], [2, 2], [1, 2]]]}\n"
      "time: {end: 0.05, every: 0.05, sample: 0.05}\n",
      "resolution: 10, dt: 1 ms, shifting: 7");
  double shifts = NAN;
  for (size_t k = 0; k < a.f->n_statistics; k++) {
    const struct result_statistic_read *one = &a.f->statistics[k];
    if (strcmp(one->name, "applied_shifting") == 0) shifts = one->value;
    EXPECT(strcmp(one->name, "applied_smoothing") != 0);
  }
  EXPECT(shifts == 7);
  finished_destroy(&a);
}

static void test_file_holds_mass_volume_and_rest(void) {
  struct finished a = finished_create(
      "title: still water\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [2, 0], [2, 2]]]}\n"
      "water: {regions: [[[0, 0], [2, 0], [2, 1], [0, 1]]]}\n"
      "time: {end: 0.01, every: 0.01, sample: 0.001}\n",
      "resolution: 15");
  /* rho0 H L (1 + g H/2c0^2) */
  expect_masses(a.f, 2000 * (1 + 1. / 800));
  EXPECT_NEAR(a.f->energy[0].potential / a.f->rest_potential, 1, 1e-12);
  EXPECT(text_holds(a.xdmf, "Name=\"mass\"") && text_holds(a.xdmf, "Name=\"volume\""));
  finished_destroy(&a);
}

/* A row of a point at every step, and at every third one: of the state that each step begins with.
 */
static void test_points_follow_the_steps(void) {
  struct finished a = finished_create(
      "title: drop\nscales: {H: 1}\ntank: {walls: [[[0, 3], [0, 0], [3, 0], [3, 3]]]}\n"
      "water: {regions: [[[1, 1], [2, 1], [2, 2], [1, 2]]], pressure: released}\n"
      "points: [{name: each, at: [1.5, 1.5]}, {name: third, at: [1.5, 1.5], every: 3}, {name: dry, "
      "at: [0, 0]}]\ntime: {end: 0.05, every: 0.05, sample: 0.05}\n",
      "resolution: 10, precision: double, dt: 1 ms");
  EXPECT(a.f->n_points == 3 && a.f->n_steps == 2);
  const struct result_point_read *each = &a.f->points[0], *third = &a.f->points[1];
  EXPECT_STR(each->name, "each");
  EXPECT(each->n == 50 && third->n == 17);
  for (size_t i = 0; i < each->n; i++) {
    EXPECT_NEAR(each->t[i], 0.001 * (double)i, 1e-12);
    EXPECT_NEAR(each->value[CASE_POINT_v][i], -9.81 * each->t[i], 1e-9); /* it falls freely */
    EXPECT_NEAR(each->value[CASE_POINT_a_y][i], -9.81, 1e-9);
    EXPECT(isnan(a.f->points[2].value[CASE_POINT_a_y][i]));
    if (i % 3) continue;
    for (int k = 0; k < CASE_POINT_FIELDS; k++) EXPECT(third->value[k][i / 3] == each->value[k][i]);
  }
  finished_destroy(&a);
}

/* ---- accelerations ---- */

#define ACCELERATED                                                                                \
  "title: drop\nscales: {H: 1}\ntank: {walls: [[[0, 3], [0, 0], [3, 0], [3, 3]]]}\n"               \
  "water: {regions: [[[1, %d], [2, %d], [2, 2], [1, 2]]], pressure: %s}\n"                         \
  "time: {end: %s, every: %s, sample: 0.05 ms}\n"

static struct result_water vectors_of(const struct result_file *f, size_t output,
                                      const char *name) {
  struct result_water water;
  EXPECT_OK(water_read(f->path, name, true, output, &water));
  return water;
}

/* Water that falls freely, at every output and at the end of the run. */
static void test_accelerations_of_falling_water(void) {
  char head[600];
  snprintf(head, sizeof head, ACCELERATED, 1, 1, "released", "0.05", "0.01");
  struct finished a = finished_create(head, "resolution: 10, precision: double, dt: 1 ms, "
                                            "accelerations: true");
  EXPECT(a.f->n_outputs == 6);
  for (size_t k = 0; k < a.f->n_outputs; k++) {
    struct result_water w = vectors_of(a.f, k, "acceleration");
    EXPECT_NEAR(a.f->output_time[k], 0.01 * (double)k, 1e-12);
    EXPECT(w.n == 100);
    for (size_t i = 0; i < w.n; i++) {
      EXPECT_NEAR(w.value[0][2 * i], 0, 1e-9);
      EXPECT_NEAR(w.value[0][2 * i + 1], -9.81, 1e-9);
    }
    result_water_free(&w);
  }
  finished_destroy(&a);
  a = finished_create(head, "resolution: 10, dt: 1 ms");
  struct result_water none;
  EXPECT(water_read(a.f->path, "acceleration", true, 0, &none) == ERR_INPUT);
  finished_destroy(&a);
}

/* A column that its own pressure drives apart, written at every step: velocities change as the
 * accelerations in between say, to (w dt)^2/6 = 1e-4 of each wave on the lattice, w dt being below
 * c0 dt/h = 0.024 times the largest symbol of a derivative, 1.04, and waves add up; rates of the
 * step before would be off by w dt. */
static void test_accelerations_are_those_of_the_state(void) {
  const double dt = 5e-5;
  char head[600];
  snprintf(head, sizeof head, ACCELERATED, 0, 0, "hydrostatic", "0.001", "0.05 ms");
  struct finished a = finished_create(head, "resolution: 10, precision: double, dt: 0.05 ms, "
                                            "alpha: 0, diffusion: none, accelerations: true");
  EXPECT(a.f->n_outputs == 21);
  double most = 0, worst = 0;
  for (size_t k = 1; k + 1 < a.f->n_outputs; k++) {
    struct result_water before = vectors_of(a.f, k - 1, "velocity");
    struct result_water after = vectors_of(a.f, k + 1, "velocity");
    struct result_water now = vectors_of(a.f, k, "acceleration");
    for (size_t i = 0; i < 2 * now.n; i++) {
      most = fmax(most, fabs(now.value[0][i]));
      worst =
          fmax(worst, fabs((after.value[0][i] - before.value[0][i]) / (2 * dt) - now.value[0][i]));
    }
    result_water_free(&before);
    result_water_free(&after);
    result_water_free(&now);
  }
  printf("     off by %.2g of the largest acceleration, %.3g m/s^2\n", worst / most, most);
  EXPECT(worst < 1e-3 * most);
  finished_destroy(&a);
}

/* ---- gauges ---- */

/* In a basin of still water that settles, a gauge on a wall and within two spacings of it shows the
 * level as one in the middle does. Ghost particles press the topmost particle beside them down
 * (without the correction -0.5 dx on the wall); measured 0.11 dx at worst here, 0.08 at
 * eleven instants with H/dx = 20 and 25, and 0.002 with mirror images. */
static void test_gauge_on_a_wall_shows_the_level(void) {
  static const char *const walls[] = {"ghost", "mirror"};
  for (int k = 0; k < 2; k++) {
    char keys[64];
    snprintf(keys, sizeof keys, "resolution: 16, walls: %s", walls[k]);
    struct finished a = finished_create(
        "title: basin\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [1, 0], [1, 2]]]}\n"
        "water: {regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]], pressure: hydrostatic}\n"
        "gauges: [{name: wall, x: 0}, {name: half, x: 0.03125}, {name: one, x: 0.0625},"
        " {name: right, x: 1}]\n"
        "time: {end: 4 sqrt(H/g), every: 4 sqrt(H/g), sample: 0.05 sqrt(H/g)}\n",
        keys);
    double worst = 0;
    for (size_t i = 0; i < 4; i++)
      for (size_t t = 0; t < a.f->gauges[i].n; t++) {
        EXPECT(isfinite(a.f->gauges[i].value[t]));
        worst = fmax(worst, fabs(a.f->gauges[i].value[t] - 1) * 16);
      }
    EXPECT(a.f->gauges[3].n > 80);
    printf("     walls: %s: off by %.3f spacings at worst\n", walls[k], worst);
    EXPECT(worst < (k == 0 ? 0.2 : 0.02));
    finished_destroy(&a);
  }
}

/* What is read at x off a surface with the given points, spacing 0.1, ghosts in a tank of 2 by 2.
 */
static double reading(size_t n, double (*p)[2], double x) {
  struct geo_lines l = {0};
  EXPECT_OK(geo_lines_begin(&l, false));
  for (size_t i = 0; i < n; i++) EXPECT_OK(geo_lines_add(&l, p[i][0], p[i][1]));
  struct case_file *c = pool_case(POOL_STILL, "resolution: 10");
  struct sph *s = pool_create(c);
  double read = sph_gauge(s, &l, x);
  sph_destroy(s);
  case_destroy(c);
  geo_lines_destroy(&l);
  return read;
}

static void test_gauge_corrects_the_meniscus_only(void) {
  double low[][2] = {{0, .95}, {.1, .99}, {.2, 1}, {2, 1}};
  EXPECT_NEAR(reading(4, low, 0), 1, 1e-12);
  EXPECT_NEAR(reading(4, low, 0.05), 1, 1e-12);
  EXPECT_NEAR(reading(4, low, 0.2), 1, 1e-12);
  double slope[][2] = {{0, .7}, {.2, .8}, {2, 1.7}}; /* 0.75 by the line */
  EXPECT_NEAR(reading(3, slope, 0), 0.7, 1e-12);
  double deep[][2] = {{0, .5}, {.2, 1}, {2, 1}}; /* no meniscus, whose depth is less than dx */
  EXPECT_NEAR(reading(3, deep, 0), 0.6, 1e-12);
  double jet[][2] = {{0, 1.8}, {.1, 1.2}, {.2, 1}, {2, 1}};
  EXPECT_NEAR(reading(4, jet, 0), 1.8, 1e-12);
  double film[][2] = {{0, .4}, {.1, 0}}; /* dry at two and four spacings */
  EXPECT_NEAR(reading(2, film, 0.05), 0.2, 1e-12);
  double away[][2] = {{.1, 0}, {.2, 1}, {2, 1}}; /* the wall is dry */
  EXPECT(isnan(reading(3, away, 0)));
}

/* With eos split the density that evolves is rho0 in water at rest; what is written weighs. */
static void test_density_is_written_with_its_weight(void) {
  struct finished a = finished_create(
      "title: still water\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [2, 0], [2, 2]]]}\n"
      "water: {regions: [[[0, 0], [2, 0], [2, 1], [0, 1]]]}\n"
      "time: {end: 0.001, every: 0.001, sample: 0.001}\n",
      "resolution: 10, c0: 5 sqrt(gH), eos: split, momentum: reference");
  double *rho = field_of(a.f, 0, "density"), *V = field_of(a.f, 0, "volume"), most = 0;
  double *m = field_of(a.f, 0, "mass");
  for (int64_t i = 0; i < a.f->output_points[0]; i++) {
    most = fmax(rho[i], most);
    EXPECT_NEAR(m[i] / V[i] / 1000, 1, 1e-12);
  }
  EXPECT_NEAR(most / 1000, 1 + 0.95 / 25, 1e-12); /* half a spacing above the bed */
  free(rho);
  free(V);
  free(m);
  finished_destroy(&a);
}

int main(void) {
  RUN(test_still_water_is_at_rest);
  RUN(test_wave_starts_with_its_energy);
  RUN(test_dam_break_has_the_energy_of_its_fall);
  RUN(test_treatments_are_counted);
  RUN(test_file_holds_mass_volume_and_rest);
  RUN(test_density_is_written_with_its_weight);
  RUN(test_points_follow_the_steps);
  RUN(test_accelerations_of_falling_water);
  RUN(test_accelerations_are_those_of_the_state);
  RUN(test_gauge_on_a_wall_shows_the_level);
  RUN(test_gauge_corrects_the_meniscus_only);
  return TEST_RESULT;
}

/* What a run leaves in its file: energies above rest, mass and volume of the particles. */
#include "tests/test.h"

#include <unistd.h>

#include "common/progress.h"
#include "common/result.h"
#include "sph/energy.h"
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
  struct result_cloud cloud;
  EXPECT_OK(result_read_points(f->path, name, 1, &output, &cloud));
  free(cloud.p);
  return cloud.value;
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

static void test_file_holds_mass_volume_and_rest(void) {
  char folder[] = "/tmp/plunge-output-XXXXXX", path[64], xdmf[64];
  EXPECT(mkdtemp(folder));
  snprintf(path, sizeof path, "%s/run.h5", folder);
  snprintf(xdmf, sizeof xdmf, "%s/run.xdmf", folder);
  struct case_file *c = pool_case(
      "title: still water\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [2, 0], [2, 2]]]}\n"
      "water: {regions: [[[0, 0], [2, 0], [2, 1], [0, 1]]]}\n"
      "time: {end: 0.01, every: 0.01, sample: 0.001}\n",
      "resolution: 15");
  struct progress *progress = progress_create(PROGRESS_QUIET);
  struct result *out = NULL;
  struct result_file *f = NULL;
  EXPECT_OK(result_create(path, c, &c->runs[0], &out));
  EXPECT_OK(sph_solver.run(c, &c->runs[0], out, progress));
  EXPECT_OK(result_finish(out));
  result_destroy(out);
  EXPECT_OK(result_read(path, &f));
  if (!f) return;
  /* rho0 H L (1 + g H/2c0^2) */
  expect_masses(f, 2000 * (1 + 1. / 800));
  EXPECT_NEAR(f->energy[0].potential / f->rest_potential, 1, 1e-12);
  EXPECT(text_holds(xdmf, "Name=\"mass\"") && text_holds(xdmf, "Name=\"volume\""));
  result_file_destroy(f);
  case_destroy(c);
  progress_destroy(progress);
  unlink(path);
  unlink(xdmf);
  EXPECT(rmdir(folder) == 0);
}

int main(void) {
  RUN(test_still_water_is_at_rest);
  RUN(test_wave_starts_with_its_energy);
  RUN(test_dam_break_has_the_energy_of_its_fall);
  RUN(test_file_holds_mass_volume_and_rest);
  return TEST_RESULT;
}

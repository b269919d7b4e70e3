/* The diagnostics of a run. */
#include "sph/observe/diagnose.h"

#include <omp.h>

#include "tests/sph/pool.h"
#include "tests/test.h"

/* Water that falls freely and turns as a solid: its accelerations are g, its momenta known, and the
 * means of linear velocities on a lattice are they themselves, to rounding. */
static void test_falling_water_is_quiet(void) {
  struct case_file *c =
      pool_case(POOL_DROP, "resolution: 20, alpha: 0, precision: double, diagnostics: true");
  struct sph *s = pool_create(c);
  double value[SPH_DIAGNOSTIC_COUNT], mass = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    s->f.w.rho[i] = s->rho0;
    s->f.w.u[i] = 2 - 3 * (s->f.w.y[i] - 1.5);
    s->f.w.v[i] = 1 + 3 * (s->f.w.x[i] - 1.5);
    mass += s->f.m[i];
  }
  sph_particles_pad(&s->f);
  EXPECT_OK(sph_rates(s, 0, true, true));
  EXPECT_OK(sph_diagnose(s, c->H, c->g, value));
  EXPECT_NEAR(value[SPH_DIAGNOSTIC_shaking], 1, 1e-12);
  EXPECT_NEAR(value[SPH_DIAGNOSTIC_noise_ax], 0, 1e-12);
  EXPECT_NEAR(value[SPH_DIAGNOSTIC_noise_ay], 0, 1e-12);
  EXPECT_NEAR(value[SPH_DIAGNOSTIC_noise_p], 0, 1e-12);
  EXPECT(value[SPH_DIAGNOSTIC_compressed] == 0);
  EXPECT(value[SPH_DIAGNOSTIC_inner] > 0.5 && value[SPH_DIAGNOSTIC_inner] < 1);
  EXPECT_NEAR(value[SPH_DIAGNOSTIC_momentum_x] / mass, 2, 1e-12);
  EXPECT_NEAR(value[SPH_DIAGNOSTIC_momentum_y] / mass, 1, 1e-12);
  /* about the origin: that of the centre, (1.5, 1.5), and the turning's, 3 (2/12) (1 - 1/n^2) */
  const double turning = 0.5 * (1 - 1 / 400.);
  EXPECT_NEAR(value[SPH_DIAGNOSTIC_angular_momentum] / mass, 1.5 - 3 + turning, 1e-12);
  sph_destroy(s);
  case_destroy(c);
}

/* The noise of a field by its definition: every particle against every other, with the Gaussian. */
static double noise_by_hand(const struct sph *s, const double *f) {
  double squares = 0, n = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    double w = 0, wu = 0;
    for (size_t j = 0; j < s->f.n; j++) {
      const double x = (s->f.w.x[j] - s->f.w.x[i]) / s->h, y = (s->f.w.y[j] - s->f.w.y[i]) / s->h;
      const double q2 = x * x + y * y, V = s->f.m[j] / s->f.w.rho[j] / (s->h * s->h);
      if (q2 > 9 * (1 - 1e-9)) continue; /* a lattice has neighbours on the edge, where W is 0 */
      const double W = (exp(-q2) - exp(-9)) / (M_PI * (1 - 10 * exp(-9))) * V;
      w += W;
      wu += W * f[j];
    }
    if (w <= 0.9) continue;
    squares += (f[i] - wu / w) * (f[i] - wu / w);
    n++;
  }
  return sqrt(squares / n);
}

/* A velocity that changes its sign from one row to the next has next to no mean: nearly all of it
 * is noise. */
static void test_noise_is_what_the_mean_leaves(void) {
  struct case_file *c =
      pool_case(POOL_DROP, "resolution: 20, alpha: 0, precision: double, diagnostics: true");
  struct sph *s = pool_create(c);
  double value[SPH_DIAGNOSTIC_COUNT];
  const double speed = 0.1 * sqrt(s->g * c->H);
  for (size_t i = 0; i < s->f.n; i++) {
    const bool odd = (long)floor(s->f.w.x[i] / s->dx) % 2 != 0;
    s->f.w.u[i] = odd ? speed : -speed;
    s->f.w.rho[i] = s->rho0 * (odd ? 1.02 : 1);
  }
  sph_particles_pad(&s->f);
  EXPECT_OK(sph_rates(s, 0, true, true));
  EXPECT_OK(sph_diagnose(s, c->H, c->g, value));
  EXPECT_NEAR(value[SPH_DIAGNOSTIC_noise_u] * sqrt(c->g * c->H), noise_by_hand(s, s->f.w.u), 1e-12);
  const double noise_p = noise_by_hand(s, s->f.p) / (s->rho0 * c->g * c->H);
  const double noise_ax = noise_by_hand(s, s->f.k[0].u) / c->g;
  const double noise_ay = noise_by_hand(s, s->f.k[0].v) / c->g;
  EXPECT(noise_p > 1 && noise_ax > 1 && noise_ay > 0.1);
  EXPECT_NEAR(value[SPH_DIAGNOSTIC_noise_p] / noise_p, 1, 1e-11);
  EXPECT_NEAR(value[SPH_DIAGNOSTIC_noise_ax] / noise_ax, 1, 1e-11);
  EXPECT_NEAR(value[SPH_DIAGNOSTIC_noise_ay] / noise_ay, 1, 1e-11);
  EXPECT_NEAR(value[SPH_DIAGNOSTIC_noise_v], 0, 1e-12);
  EXPECT_NEAR(value[SPH_DIAGNOSTIC_compressed], 0.5, 1e-12);
  sph_destroy(s);
  case_destroy(c);
}

/* Nothing of the run changes, and the numbers have the same bits for any number of threads. */
static void test_diagnosing_changes_nothing(void) {
  struct case_file *c = pool_case(POOL_DAM, "resolution: 16, diagnostics: true, forces: true");
  double value[3][SPH_DIAGNOSTIC_COUNT], speed[2] = {0};
  const int most = omp_get_max_threads();
  for (int k = 0; k < 3; k++) {
    struct sph *s = pool_create(c);
    omp_set_num_threads(k + 1);
    for (int n = 0; n < 10; n++) {
      EXPECT_OK(sph_rates(s, 0, true, true));
      if (k) EXPECT_OK(sph_diagnose(s, c->H, c->g, value[k]));
      EXPECT_OK(sph_step(s, sph_timestep(s, 1)));
    }
    if (k < 2)
      for (size_t i = 0; i < s->f.n; i++) speed[k] += s->f.w.u[i] * s->f.w.rho[i];
    sph_destroy(s);
  }
  omp_set_num_threads(most);
  EXPECT(speed[0] == speed[1]);
  EXPECT(!memcmp(value[1], value[2], sizeof value[1]));
  case_destroy(c);
}

/* Water at rest whose density is more than a hundredth above rho0 from a quarter of its depth on,
 * g d/c0^2 = 0.04 d/H, whichever density it is that evolves. */
static void test_compression_is_of_the_density(void) {
  static const char *const laws[] = {"linear", "tait", "dynamic, momentum: reference",
                                     "split, momentum: reference"};
  for (size_t k = 0; k < sizeof laws / sizeof *laws; k++) {
    char run[200];
    double value[SPH_DIAGNOSTIC_COUNT];
    snprintf(run, sizeof run, "resolution: 20, c0: 5 sqrt(gH), diagnostics: true, eos: %s",
             laws[k]);
    struct case_file *c = pool_case(POOL_STILL, run);
    struct sph *s = pool_create(c);
    EXPECT_OK(sph_rates(s, 0, true, true));
    EXPECT_OK(sph_diagnose(s, c->H, c->g, value));
    EXPECT_NEAR(value[SPH_DIAGNOSTIC_compressed], 0.75, 1e-12);
    sph_destroy(s);
    case_destroy(c);
  }
}

int main(void) {
  RUN(test_falling_water_is_quiet);
  RUN(test_noise_is_what_the_mean_leaves);
  RUN(test_compression_is_of_the_density);
  RUN(test_diagnosing_changes_nothing);
  return TEST_RESULT;
}

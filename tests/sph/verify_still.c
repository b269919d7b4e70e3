/* Water that stands still, and water that diffusion should bring to rest. */
#include "sph/fluid/energy.h"
#include "tests/sph/pool.h"
#include "tests/test.h"

/* P, section V.A and Figure 3, L/H = 2, no viscosity: over 20 sqrt(H/g) Antuono's term keeps the
 * potential energy within 0.1 %; Ferrari's lets it fall, visibly (P: "a rapid decrease"), and less
 * so with a finer spacing. */
static double still_water(const char *diffusion, const char *integrator, double resolution) {
  char run[200];
  snprintf(run, sizeof run, "resolution: %g, diffusion: %s, integrator: %s, alpha: 0", resolution,
           diffusion, integrator);
  struct case_file *c = pool_case(POOL_STILL, run);
  struct sph *s = pool_create(c);
  double before = sph_energy(s).potential, worst = 0;
  for (int k = 1; k <= 40; k++) {
    EXPECT_OK(pool_march(s, 0.5 * k / sqrt(s->g)));
    double change = sph_energy(s).potential / before - 1;
    if (fabs(change) > fabs(worst)) worst = change;
  }
  printf("     %s, H/dx = %g: potential energy changes by up to %.4f %%\n", diffusion, resolution,
         100 * worst);
  sph_destroy(s);
  case_destroy(c);
  return worst;
}

static void test_only_antuono_keeps_water_still(void) {
  EXPECT_NEAR(still_water("antuono", "rk4-frozen", 25), 0, 1e-3);
  double coarse = still_water("ferrari", "tvd-rk3", 15),
         fine = still_water("ferrari", "tvd-rk3", 30);
  EXPECT(coarse < -0.02 && fine < -0.01);
  EXPECT(fabs(fine) < 0.75 * fabs(coarse));
}

/* Water in disorder, its particles moved by up to 0.3 dx and given random velocities and pressures,
 * without viscosity: diffusion alone calms it, with steps as long as the bounds allow. Returns what
 * is left of the kinetic energy, the most after 7 sqrt(H/g) of 10, and *gained the energy gained
 * over it. */
static double noise_left(const char *diffusion, const char *integrator, double *gained) {
  char run[200];
  snprintf(run, sizeof run, "resolution: 10, alpha: 0, diffusion: %s, integrator: %s", diffusion,
           integrator);
  struct case_file *c = pool_case(POOL_STILL, run);
  struct sph *s = pool_create(c);
  pool_shake(s, 0.3, 0.03 * s->c0, 0.009 * s->rho0 * s->c0 * s->c0);
  struct result_energy start = sph_energy(s);
  double left = 0;
  const double end = 10 / sqrt(s->g);
  while (s->t < end) {
    EXPECT_OK(sph_rates(s, 0, true, true));
    EXPECT_OK(sph_step(s, sph_timestep(s, 1e9)));
    if (s->t > 0.7 * end) left = fmax(left, sph_energy(s).kinetic / start.kinetic);
  }
  *gained = (sph_energy(s).total - start.total) / start.kinetic;
  sph_destroy(s);
  case_destroy(c);
  return left;
}

/* Frozen with P's step, Ferrari's diffusion let such noise grow again, to 300 times its
 * start; stable, 0.03 of it or less is left. */
static void test_diffusion_calms_noise(void) {
  static const char *const rows[][2] = {{"molteni", "rk4-frozen"},
                                        {"ferrari", "rk4-frozen"},
                                        {"ferrari", "auto"},
                                        {"antuono", "auto"}};
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
    double gained, left = noise_left(rows[k][0], rows[k][1], &gained);
    printf("     %s, %s: %.3f of the noise is left, energy gained %.2f\n", rows[k][0], rows[k][1],
           left, gained);
    EXPECT(left < 0.1);
    EXPECT(gained < 0);
  }
}

int main(void) {
  RUN(test_diffusion_calms_noise);
  RUN(test_only_antuono_keeps_water_still);
  return TEST_RESULT;
}

/* Treatments of the water between steps. */
#include "tests/test.h"

#include "sph/fluid/energy.h"
#include "sph/treat/treat.h"
#include "tests/sph/pool.h"

/* A wave of pressure on a lattice, far from its edges: the mean weighted by a Gaussian is
 * exp(-(kh)^2/4) of it, and what a square lattice with h/dx = 4/3 and the cut at 3h leave is below
 * 1e-3. */
static void test_shepard_mean_damps_a_wave_by_its_transform(void) {
  struct case_file *c = pool_case(POOL_DROP, "resolution: 40, shepard: 1, precision: double");
  struct sph *s = pool_create(c);
  const double k = 2 * M_PI / 0.4, p0 = 1e3;
  for (size_t i = 0; i < s->f.n; i++)
    s->f.w.rho[i] = s->rho0 + p0 / (s->c0 * s->c0) * sin(k * s->f.w.x[i]);
  sph_particles_pad(&s->f);
  s->steps = 1;
  const double before = sph_energy(s).total;
  EXPECT_OK(sph_treat(s));
  double worst = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    double x = s->f.w.x[i], y = s->f.w.y[i];
    if (fmin(fmin(x - 1, 2 - x), fmin(y - 1, 2 - y)) < 3.1 * s->h) continue;
    double p = (s->f.w.rho[i] - s->rho0) * s->c0 * s->c0;
    worst = fmax(worst, fabs(p / p0 - exp(-k * k * s->h * s->h / 4) * sin(k * x)));
  }
  EXPECT_NEAR(worst, 0, 1e-3);
  EXPECT(s->budget.diffusion > 0);
  EXPECT_NEAR(sph_energy(s).total + s->budget.diffusion, before, 1e-12 * before);
  sph_destroy(s);
  case_destroy(c);
}

/* A uniform pressure stays, to the rounding of densities near 1000; at the surface too. */
static void test_shepard_mean_of_a_constant_is_it(void) {
  struct case_file *c = pool_case(POOL_DROP, "resolution: 20, shepard: 1");
  struct sph *s = pool_create(c);
  pool_shake(s, 0.3, 1, 0);
  for (size_t i = 0; i < s->f.n; i++) s->f.w.rho[i] = s->rho0 * 1.01;
  sph_particles_pad(&s->f);
  s->steps = 1;
  EXPECT_OK(sph_treat(s));
  for (size_t i = 0; i < s->f.n; i++) EXPECT_NEAR(s->f.w.rho[i] / s->rho0, 1.01, 1e-14);
  sph_destroy(s);
  case_destroy(c);
}

/* After as many steps as the key says, and the budget of a run stays closed. */
static void test_treatments_come_after_so_many_steps(void) {
  struct case_file *c = pool_case(POOL_DAM, "resolution: 16, diffusion: none, shepard: 5");
  struct sph *s = pool_create(c);
  double spent = 0;
  const double before = sph_energy(s).total;
  for (int k = 0; k < 20; k++) {
    EXPECT_OK(sph_treat(s));
    EXPECT((s->budget.diffusion != spent) == (k > 0 && k % 5 == 0));
    spent = s->budget.diffusion;
    EXPECT_OK(sph_rates(s, 0, true, true));
    EXPECT_OK(sph_step(s, sph_timestep(s, 1)));
  }
  const struct result_energy e = sph_energy(s);
  EXPECT_NEAR((e.total + e.viscosity + e.diffusion + e.walls) / before, 1, 1e-6);
  sph_destroy(s);
  case_destroy(c);
}

int main(void) {
  RUN(test_shepard_mean_damps_a_wave_by_its_transform);
  RUN(test_shepard_mean_of_a_constant_is_it);
  RUN(test_treatments_come_after_so_many_steps);
  return TEST_RESULT;
}

/* What holds in the solver for every kernel, whatever its support and the spacing. */
#include "tests/test.h"

#include <omp.h>

#include "sph/domain/wall.h"
#include "sph/fluid/energy.h"
#include "sph/observe/probe.h"
#include "sph/pair/kernel.h"
#include "tests/sph/pool.h"

static const char *const kernels[] = {
#define X(name, help) #name,
    SPH_KERNELS(X)
#undef X
};

/* Every kernel with two spacings: fn(case of the tank or drop, state). */
static void each(const char *head, const char *more,
                 void (*check)(const struct case_file *, struct sph *)) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++)
    for (int wide = 0; wide < 2; wide++) {
      char run[300];
      snprintf(run, sizeof run, "resolution: 20, kernel: %s, h_over_dx: %g, %s", kernels[k],
               wide ? 2 : 4. / 3, more);
      struct case_file *c = pool_case(head, run);
      struct sph *s = pool_create(c);
      check(c, s);
      sph_destroy(s);
      case_destroy(c);
    }
}

/* Forces are opposite in every pair and, with the pressure and the divergence, exchange energy
 * without loss; a few thousand roundings. */
static void check_pairs(const struct case_file *c, struct sph *s) {
  (void)c;
  pool_shake(s, 0.3, 2, 3e3);
  EXPECT_OK(sph_rates(s, 0, true, false));
  const struct sph_state *w = &s->f.w, *rate = &s->f.k[0];
  double fx = 0, fy = 0, force = 0, power = 0, size = 0, out = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    const double m = s->f.m[i], ax = rate->u[i], ay = rate->v[i] + s->g;
    const double elastic = m * pool_p(s, i) / (w->rho[i] * w->rho[i]) * rate->rho[i];
    fx += m * ax;
    fy += m * ay;
    force += m * hypot(ax, ay);
    power += m * (w->u[i] * ax + w->v[i] * ay) + elastic;
    size += m * fabs(w->u[i] * ax + w->v[i] * ay) + fabs(elastic);
  }
#define X(name, ...) out += s->totals.name;
  SPH_POWERS(X)
#undef X
  EXPECT_NEAR(hypot(fx, fy) / force, 0, 1e-13);
  EXPECT_NEAR((power + out) / size, 0, 1e-13);
  EXPECT(s->totals.viscosity > 0);
}

static void test_pairs_conserve_momentum_and_energy(void) {
  each(POOL_DROP, "alpha: 0.1, precision: double", check_pairs);
}

/* Walls continue the linear pressure and Antuono's term vanishes up to them, away from the surface:
 * a plane is fitted exactly where the floors of the fit (mls.h) let it, in the corners too. */
static void check_still(const struct case_file *c, struct sph *s) {
  (void)c;
  EXPECT_OK(sph_rates(s, 0, true, true));
  double worst = 0, D = 0;
  for (size_t k = 0; k < s->w.n; k++)
    if (s->w.y[k] < 1 - 3 * s->h && s->w.pack[k].V > 0)
      worst = fmax(worst, fabs(s->w.pack[k].p / (s->rho0 * s->g) - (1 - s->w.y[k])));
  for (size_t i = 0; i < s->f.n; i++)
    if (s->f.w.y[i] < 1 - 2 * s->support) D = fmax(D, fabs(s->f.D[i]));
  /* rho* f instead of rho0 f in their pressure: g depth / c0^2 = 1/400 of what is added, 2 supports
   */
  EXPECT_NEAR(worst, 0, 2 * (s->support + s->dx) / 400);
  EXPECT_NEAR(D / (s->scheme.delta * s->rho0 * s->g / s->c0), 0, 1e-2);
}

static void test_walls_continue_still_water(void) {
  for (size_t k = 0; sph_wall_names[k]; k++) {
    char more[100];
    if (!pool_holds_still(sph_wall_names[k])) continue;
    snprintf(more, sizeof more, "walls: %s", sph_wall_names[k]);
    each(POOL_STILL, more, check_still);
  }
}

static void check_probes(const struct case_file *c, struct sph *s) {
  const double at[][2] = {{2, 0.2385}, {0.77, 0}, {0, 0}};
  sph_pack_water(s);
  for (int k = 0; k < 3; k++) {
    const struct case_probe probe = {.x = at[k][0], .y = at[k][1]};
    double p = NAN;
    EXPECT_OK(sph_probe(s, &probe, &c->walls, &p));
    EXPECT_NEAR(p / (s->rho0 * s->g), 1 - at[k][1], 1e-9);
  }
}

static void test_probes_read_still_water(void) {
  each(POOL_STILL, "alpha: 0", check_probes);
}

/* The same bits from one thread and from three. */
static void check_threads(const struct case_file *c, struct sph *s) {
  struct sph *other = pool_create(c);
  const int most = omp_get_max_threads();
  omp_set_num_threads(1);
  for (int k = 0; k < 10; k++)
    if (sph_rates(s, 0, true, true) != OK || sph_step(s, sph_timestep(s, 1)) != OK) exit(1);
  omp_set_num_threads(3);
  for (int k = 0; k < 10; k++)
    if (sph_rates(other, 0, true, true) != OK || sph_step(other, sph_timestep(other, 1)) != OK)
      exit(1);
  omp_set_num_threads(most);
#define X(name, unit, help) EXPECT(!memcmp(s->f.w.name, other->f.w.name, s->f.n * sizeof(double)));
  SPH_EVOLVING(X)
#undef X
  sph_destroy(other);
}

static void test_bits_do_not_depend_on_threads(void) {
  each(POOL_DROP, "diffusion: ferrari", check_threads);
}

int main(void) {
  RUN(test_pairs_conserve_momentum_and_energy);
  RUN(test_walls_continue_still_water);
  RUN(test_probes_read_still_water);
  RUN(test_bits_do_not_depend_on_threads);
  return TEST_RESULT;
}

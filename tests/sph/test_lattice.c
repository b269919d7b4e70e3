/* Kernels on an undisturbed lattice: sums, plane waves, and up to what time step they are stable.
 */
#include "tests/test.h"

#include "common/base/array.h"
#include "sph/pair/continuity.h"
#include "sph/pair/rates.h"
#include "sph/theory/lattice.h"
#include "sph/theory/stability.h"
#include "sph/time/integrator.h"
#include "sph/time/linear.h"
#include "sph/time/timestep.h"
#include "tests/sph/pool.h"

enum { ALL = SPH_LATTICE_REACH };

static struct sph_lattice lattice(enum sph_kernel k, double h_over_dx) {
  struct sph_lattice l;
  sph_lattice_of(k, h_over_dx, &l);
  return l;
}

/* sum y^n grad W V upwards, with `above` as in lattice.h. */
static double upwards(const struct sph_lattice *l, int n, int above) {
  double sum = 0;
  for (size_t k = 0; k < l->n; k++)
    if (l->near[k].j <= above) sum += pow(l->near[k].y, n) * l->near[k].gy;
  return sum;
}

/* Exact: what the kernel is on the nine points (thesis, eqs. (2.112) to (2.125)). */
static void test_tensor_kernel_with_h_of_a_spacing_is_exact(void) {
  const struct sph_lattice l = lattice(SPH_KERNEL_tensor, 1);
  EXPECT_NEAR(sph_lattice_moment(&l, 0, 0, ALL), 1, 1e-14);
  EXPECT_NEAR(sph_lattice_moment(&l, 0, 1, ALL), 0, 1e-14);
  EXPECT_NEAR(sph_lattice_moment(&l, 2, 0, ALL), 1. / 3, 1e-14);
  EXPECT_NEAR(sph_lattice_gradient_moment(&l, 0, 0, ALL), 0, 1e-14);
  EXPECT_NEAR(sph_lattice_gradient_moment(&l, 1, 0, ALL), 1, 1e-14);
  EXPECT_NEAR(sph_lattice_gradient_moment(&l, 2, 0, ALL), 0, 1e-14);
  EXPECT_NEAR(sph_lattice_gradient_moment(&l, 3, 0, ALL), 1, 1e-14);
  EXPECT_NEAR(sph_lattice_moment(&l, 0, 0, 0), 5. / 6, 1e-14); /* at a surface */
  EXPECT_NEAR(upwards(&l, 0, 0), -0.5, 1e-14);
  for (double kx = 0.1; kx < 3; kx += 0.4)
    for (double ky = 0; ky < 3; ky += 0.7) {
      struct sph_symbols a;
      sph_lattice_symbols(&l, SPH_DIFFUSION_molteni, kx, ky, &a);
      const double Wx = 1 - 2. / 3 * pow(sin(kx / 2), 2), Wy = 1 - 2. / 3 * pow(sin(ky / 2), 2);
      EXPECT_NEAR(a.W, Wx * Wy, 1e-14);
      EXPECT_NEAR(a.Gx, sin(kx) * Wy, 1e-14);
      EXPECT_NEAR(a.Gy, Wx * sin(ky), 1e-14);
    }
  double sound, decay;
  sph_lattice_extremes(&l, SPH_DIFFUSION_molteni, &sound, &decay);
  EXPECT_NEAR(sound, 1.038, 1e-3); /* the digits that are known */
}

/* Of the spline along one axis, in other ratios: the product's sums are those of two. */
static void test_spline_sums_fail_between_whole_ratios(void) {
  const double ratio[] = {1.2, 4. / 3, 1.5, 2};
  const double sum[] = {1.80e-3, 3.91e-3, 4.12e-3, 0}, slope[] = {2.24e-2, 1.95e-2, -1.24e-2, 0};
  for (int k = 0; k < 4; k++) {
    const struct sph_lattice l = lattice(SPH_KERNEL_tensor, ratio[k]);
    const double one = sqrt(sph_lattice_moment(&l, 0, 0, ALL));
    EXPECT_NEAR(one - 1, sum[k], 1e-5); /* the last digit */
    EXPECT_NEAR(sph_lattice_gradient_moment(&l, 1, 0, ALL) / one - 1, slope[k], 1e-4);
  }
}

/* B = <x^2>/4 for kernels of the distance. P's 1/8 is that of a Gaussian without an end: the cut
 * takes 10 exp(-9)/4 and twice the like away. */
static void test_B_of_the_continuum(void) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++) {
    const double B = sph_kernel_slope_moment((enum sph_kernel)k, 4, 0) / 12;
    EXPECT_NEAR(sph_kernel_moment((enum sph_kernel)k, 0, 0), 1, 1e-6);
    if (kernel_is_radial((enum sph_kernel)k))
      EXPECT_NEAR(B, sph_kernel_moment((enum sph_kernel)k, 2, 0) / 4, 1e-6);
    if (k == SPH_KERNEL_gaussian) EXPECT_NEAR(B, 0.125, 1e-3);
    if (k == SPH_KERNEL_cubic) EXPECT_NEAR(B, 0.0791, 5e-5);
  }
}

/* With the renormalised gradient's own smoothing the lattice has three times as much: for the
 * Gaussian 3/8 in the continuum, (4/k^2h^2)... by its symbol, 0.3705 at dx = 3/4 h. */
static void test_B_of_the_lattice_is_three_times_as_large(void) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++) {
    const struct sph_lattice l = lattice((enum sph_kernel)k, 4. / 3);
    const double B = sph_lattice_slope_moment(&l, 4, 0, ALL) / 4, wave = 0.02;
    struct sph_symbols a;
    sph_lattice_symbols(&l, SPH_DIFFUSION_antuono, wave, 0, &a);
    EXPECT_NEAR(a.D / pow(wave, 4) / B, 1, 1e-3); /* wave^2, and rounding over wave^4 */
  }
  const struct sph_lattice fine = lattice(SPH_KERNEL_gaussian, 3);
  for (double wave = 0.2; wave < 4; wave += 0.3) {
    struct sph_symbols a;
    const double s = wave * wave / 4, D = 4 * (1 - exp(-s)) - wave * wave * exp(-2 * s);
    sph_lattice_symbols(&fine, SPH_DIFFUSION_antuono, wave, 0, &a);
    EXPECT_NEAR(a.D, D, 5e-3); /* what the cut leaves out */
  }
}

/* The viscosity that P's (17) has, alpha h c0/8 across and three times that along. */
static void test_viscosity_of_long_waves(void) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++) {
    const struct sph_lattice l = lattice((enum sph_kernel)k, 3);
    const double wave = 0.02;
    struct sph_symbols a;
    if (!kernel_is_radial((enum sph_kernel)k)) continue;
    sph_lattice_symbols(&l, SPH_DIFFUSION_none, wave, 0, &a);
    EXPECT_NEAR(a.xx / (wave * wave), 3. / 8, 2e-3); /* the lattice's sums are off by so much */
    EXPECT_NEAR(a.yy / (wave * wave), 1. / 8, 2e-3);
    EXPECT_NEAR(a.xy, 0, 1e-15);
  }
}

/* What is known has four decimals. */
static void test_largest_decay_rates_of_the_diffusions(void) {
  const struct sph_lattice l = lattice(SPH_KERNEL_gaussian, 4. / 3);
  const double known[SPH_DIFFUSION_COUNT] = {[SPH_DIFFUSION_molteni] = 4.0016,
                                             [SPH_DIFFUSION_ferrari] = 1.9641,
                                             [SPH_DIFFUSION_antuono] = 4.0016};
  EXPECT(l.n == 45);
  for (int d = 0; d < SPH_DIFFUSION_COUNT; d++) {
    double sound, decay;
    sph_lattice_extremes(&l, (enum sph_diffusion)d, &sound, &decay);
    EXPECT_NEAR(decay, known[d], 5.1e-5);
  }
}

/* Rows below a surface, dx/2 and more: sum W V, dx sum grad W V, and with the pressure of water at
 * rest the acceleration of each form over g, to all digits that are known. */
struct rows {
  enum sph_kernel kernel;
  double Gamma[3], fall[3], alone[3], plus[3], minus[3];
};

static void expect_rows(const struct rows *r) {
  const struct sph_lattice l = lattice(r->kernel, 4. / 3);
  const double dx = 3. / 4;
  for (int row = 0; row < 3; row++) {
    const double S = upwards(&l, 0, row), depth = (row + 0.5) * dx;
    const double alone = upwards(&l, 1, row) - depth * S - 1;
    EXPECT_NEAR(sph_lattice_moment(&l, 0, 0, row), r->Gamma[row], 5.1e-5);
    EXPECT_NEAR(S * dx, r->fall[row], 5.1e-5);
    EXPECT_NEAR(alone, r->alone[row], 5.1e-5);
    EXPECT_NEAR(alone - depth * S, r->plus[row], 5.1e-5);
    EXPECT_NEAR(alone + depth * S, r->minus[row], 5.1e-5);
  }
}

static void test_rows_below_a_surface(void) {
  expect_rows(&(struct rows){SPH_KERNEL_cubic,
                             {.7571, .9883, 1.0006},
                             {-.4446, -.0628, 0},
                             {-.2703, -.0166, .0149},
                             {-.0480, .0777, .0149},
                             {-.4926, -.1108, .0149}});
  expect_rows(&(struct rows){SPH_KERNEL_gaussian,
                             {.7117, .9530, .9974},
                             {-.3810, -.1095, -.0090},
                             {-.3100, -.0648, -.0056},
                             {-.1195, .0994, .0169},
                             {-.5005, -.2290, -.0281}});
}

/* The same rows: what the diffusions make of the density of water at rest, in rho0 g/(c0^2 dx). */
static void test_diffusion_below_a_surface(void) {
  const struct sph_lattice l = lattice(SPH_KERNEL_gaussian, 4. / 3);
  const double molteni[] = {.7620, .2189, .0180, 0}, ferrari[] = {.4558, .1866, .0212, 0};
  for (int row = 0; row < 4; row++) {
    double D[2] = {0};
    for (size_t n = 0; n < l.n; n++) {
      if (l.near[n].j > row) continue;
      D[0] -= 2 * l.near[n].e * l.near[n].y * 0.75;
      D[1] -= l.near[n].e * sqrt(l.near[n].q2) * l.near[n].y * 0.75;
    }
    EXPECT_NEAR(D[0], molteni[row], 5.1e-5);
    EXPECT_NEAR(D[1], ferrari[row], 5.1e-5);
  }
}

/* ---- stable steps ---- */

static struct sph_scheme scheme(enum sph_kernel k, enum sph_diffusion d, double delta,
                                int integrator) {
  return (struct sph_scheme){.kernel = k,
                             .diffusion = d,
                             .delta = delta,
                             .integrator = integrator,
                             .h_over_dx = 4. / 3,
                             .cfl_acoustic = 2.2,
                             .cfl_diffusive = 0.44,
                             .cfl_viscous = 0.125,
                             .cfl_acceleration = 0.25};
}

static const double slowly = 1e-7; /* c0/h */

/* The known ones are of waves along rows and diagonals; others are unstable up to 0.4 % earlier. */
static void test_longest_stable_steps(void) {
  static const struct {
    enum sph_kernel kernel;
    enum sph_diffusion diffusion;
    double delta;
    int integrator;
    double known;
  } of[] = {
      {SPH_KERNEL_gaussian, SPH_DIFFUSION_none, 0, SPH_INTEGRATOR_rk4, 3.29},
      {SPH_KERNEL_gaussian, SPH_DIFFUSION_none, 0, SPH_INTEGRATOR_tvd_rk3, 2.02},
      {SPH_KERNEL_gaussian, SPH_DIFFUSION_antuono, 0.2, SPH_INTEGRATOR_rk4_frozen, 2.50},
      {SPH_KERNEL_gaussian, SPH_DIFFUSION_antuono, 0.2, SPH_INTEGRATOR_rk4, 3.43},
      {SPH_KERNEL_gaussian, SPH_DIFFUSION_ferrari, 1, SPH_INTEGRATOR_rk4_frozen, 1.018},
      {SPH_KERNEL_gaussian, SPH_DIFFUSION_ferrari, 1, SPH_INTEGRATOR_rk4, 1.418},
      {SPH_KERNEL_gaussian, SPH_DIFFUSION_ferrari, 1, SPH_INTEGRATOR_tvd_rk3, 1.279},
      {SPH_KERNEL_gaussian, SPH_DIFFUSION_molteni, 0.5, SPH_INTEGRATOR_rk4_frozen, 1.000},
      {SPH_KERNEL_gaussian, SPH_DIFFUSION_molteni, 0.5, SPH_INTEGRATOR_rk4, 1.392},
      {SPH_KERNEL_cubic, SPH_DIFFUSION_antuono, 0.2, SPH_INTEGRATOR_rk4_frozen, 1.738},
  };
  for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
    const struct sph_scheme o =
        scheme(of[k].kernel, of[k].diffusion, of[k].delta, of[k].integrator);
    double courant;
    EXPECT_OK(sph_stable_courant(&o, slowly, &courant));
    EXPECT_NEAR(courant / of[k].known, 1, 5e-3);
  }
}

/* The 9-point fit: i (sin a (1 + 2 cos b), sin b (1 + 2 cos a))/3 h for phases (a, b) of a spacing,
 * at most 1/h, which RK4 stands to 2 sqrt(2). */
static void test_waves_by_a_fit(void) {
  struct sph_scheme o = scheme(SPH_KERNEL_quintic, SPH_DIFFUSION_none, 0, SPH_INTEGRATOR_rk4);
  struct sph_lattice l;
  struct sph_symbols a;
  double courant;
  o.derivative_radius = 1.5;
  o.h_over_dx = 1;
  EXPECT_OK(sph_stable_courant(&o, slowly, &courant));
  EXPECT(courant > 3.2); /* by the kernel's sums */
  for (int d = SPH_DERIVATIVE_mls; d <= SPH_DERIVATIVE_mueller; d++) {
    o.derivative = d;
    sph_lattice_of_scheme(&o, &l);
    sph_lattice_symbols(&l, SPH_DIFFUSION_none, 1.3, 0.7, &a);
    EXPECT_NEAR(a.Gx, sin(1.3) * (1 + 2 * cos(0.7)) / 3, 1e-14);
    EXPECT_NEAR(a.Gy, sin(0.7) * (1 + 2 * cos(1.3)) / 3, 1e-14);
    EXPECT_OK(sph_stable_courant(&o, slowly, &courant));
    EXPECT_NEAR(courant / (2 * sqrt(2)), 1, 3e-3);
  }
  o.derivative = SPH_DERIVATIVE_renormalised; /* exact for long waves */
  sph_lattice_of_scheme(&o, &l);
  sph_lattice_symbols(&l, SPH_DIFFUSION_none, 1e-3, 0, &a);
  EXPECT_NEAR(a.Gx / 1e-3, 1, 1e-6);
}

/* Densities that are sums: each integrator's own step of a displacement (time/linear.h). */
static void test_waves_of_densities_that_are_sums(void) {
  for (int k = 0; k < SPH_INTEGRATOR_COUNT; k++) {
    struct sph_scheme o = scheme(SPH_KERNEL_gaussian, SPH_DIFFUSION_none, 0, k);
    const struct sph_lattice l = lattice(SPH_KERNEL_gaussian, 4. / 3);
    struct sph_modes *m;
    struct sph_symbols a;
    double growth, alone, wave[2];
    o.continuity = SPH_CONTINUITY_summation;
    EXPECT_OK(sph_modes_create(&o, 16, &m));
    EXPECT_OK(sph_modes_growth(m, 3.1, &growth, wave));
    sph_lattice_symbols(&l, SPH_DIFFUSION_none, wave[0], wave[1], &a);
    const struct sph_linear sound = sph_linear_sound_direct(hypot(a.Gx, a.Gy));
    EXPECT_OK(sph_linear_growth(sph_integrators[k], &sound, 3.1, &alone));
    EXPECT_NEAR(growth, alone, 1e-7); /* of a pair that meets */
    sph_modes_destroy(m);
  }
}

static void test_modified_pc_is_neutral_where_the_density_is_a_sum(void) {
  struct sph_scheme o = scheme(SPH_KERNEL_gaussian, SPH_DIFFUSION_none, 0, SPH_INTEGRATOR_rk4);
  double rk4, summed, shepard, advanced;
  EXPECT_OK(sph_stable_courant(&o, slowly, &rk4));
  o.integrator = SPH_INTEGRATOR_modified_pc;
  EXPECT_OK(sph_stable_courant(&o, slowly, &advanced));
  o.continuity = SPH_CONTINUITY_summation;
  EXPECT_OK(sph_stable_courant(&o, slowly, &summed));
  o.continuity = SPH_CONTINUITY_shepard;
  EXPECT_OK(sph_stable_courant(&o, slowly, &shepard));
  EXPECT(advanced < 0.02);
  EXPECT_NEAR(summed * sqrt(2) / rk4, 1, 1e-3);
  EXPECT(shepard > summed);
}

static void test_steps_at_rest_are_stable_for_every_derivative(void) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++)
    for (int d = 0; d < SPH_DERIVATIVE_COUNT; d++) {
      struct sph_scheme o = scheme((enum sph_kernel)k, SPH_DIFFUSION_none, -1, SPH_INTEGRATOR_AUTO);
      struct sph_bounds bounds;
      double courant;
      o.derivative = d;
      o.derivative_radius = 1.5;
      EXPECT_OK(sph_stable_courant(&o, slowly, &courant));
      const double part = sph_courant_at_rest(&o, &bounds) / courant;
      EXPECT_NEAR(part, 2.2 / 3.292, 5e-3);
    }
}

/* The bounds of a run, for every kernel, stay within what is stable. */
static void test_steps_at_rest_are_stable_for_every_kernel(void) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++)
    for (int d = 0; d < SPH_DIFFUSION_COUNT; d++)
      for (double h_over_dx = 1; h_over_dx < 2.5; h_over_dx += 0.5) {
        struct sph_scheme o =
            scheme((enum sph_kernel)k, (enum sph_diffusion)d, -1, SPH_INTEGRATOR_AUTO);
        struct sph_bounds bounds;
        double courant;
        o.h_over_dx = h_over_dx;
        EXPECT_OK(sph_stable_courant(&o, slowly, &courant));
        const double part = sph_courant_at_rest(&o, &bounds) / courant;
        EXPECT(part > 0.5 && part < 0.9);
      }
}

/* A step of the integrator multiplies sound and diffusion by what its table says of z = -delta D dt
 * where there is no sound: in the corner of the zone. */
static void test_modes_grow_as_the_integrator_has_it(void) {
  const struct sph_scheme o =
      scheme(SPH_KERNEL_gaussian, SPH_DIFFUSION_molteni, 0.5, SPH_INTEGRATOR_rk4);
  struct sph_modes *m;
  double growth, wave[2];
  EXPECT_OK(sph_modes_create(&o, 16, &m));
  EXPECT_OK(sph_modes_growth(m, 2, &growth, wave));
  struct sph_symbols a;
  const struct sph_lattice l = lattice(SPH_KERNEL_gaussian, 4. / 3);
  sph_lattice_symbols(&l, SPH_DIFFUSION_molteni, wave[0], wave[1], &a);
  const double z = -0.5 * a.D * 2;
  EXPECT_NEAR(hypot(a.Gx, a.Gy), 0, 1e-14);
  EXPECT_NEAR(growth, 1 + z + z * z / 2 + z * z * z / 6 + z * z * z * z / 24, 1e-13);
  sph_modes_destroy(m);
}

/* Water at rest from wall to wall, with noise in its density too weak to move it: what is left of
 * the noise, rms, after steps of `part` of the longest stable ones. */
static double noise_left(const char *run, double part) {
  char text[500], more[200];
  snprintf(
      text, sizeof text, "%s",
      "title: still\nscales: {H: 1}\nfluid: {gravity: 1e-9}\n"
      "tank: {walls: [[[0, 2], [0, 0], [1, 0], [1, 2]]]}\n"
      "water: {regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]], pressure: hydrostatic}\n" POOL_TIMES);
  snprintf(more, sizeof more, "resolution: 24, c0: 10, alpha: 0, walls: mirror, %s", run);
  struct case_file *c = pool_case(text, more);
  struct sph *s = pool_create(c);
  double courant, before = 0, after = 0;
  EXPECT_OK(sph_stable_courant(&s->scheme, slowly, &courant));
  for (size_t i = 0; i < s->f.n; i++) {
    const double noise = 1e-9 * sin(12.9898 * (double)s->f.id[i] * (double)s->f.id[i]);
    s->f.w.rho[i] = s->rho0 * (1 + noise);
    before += noise * noise;
  }
  sph_particles_pad(&s->f);
  for (int k = 0; k < 200 && after < 1e8 * before; k++) {
    EXPECT_OK(sph_rates(s, 0, true, false));
    EXPECT_OK(sph_step(s, part * courant * s->h / s->c0));
    after = 0;
    for (size_t i = 0; i < s->f.n; i++) after += pow(s->f.w.rho[i] / s->rho0 - 1, 2);
  }
  sph_destroy(s);
  case_destroy(c);
  return sqrt(after / before);
}

/* The solver itself, below and above the longest stable steps: what grows, grows by some % of those
 * 3 % a step at least, e^6 in 200. A free surface carries sound that is faster than the lattice's,
 * by some 5 % with the Gaussian: without diffusion, that is what is unstable first. */
static void test_solver_is_stable_up_to_the_longest_steps(void) {
  static const struct {
    const char *run;
    double below;
  } of[] = {
      {"diffusion: none, integrator: rk4, kernel: gaussian", 0.92},
      {"diffusion: none, integrator: tvd-rk3, kernel: wendland_c2, h_over_dx: 2", 0.97},
      {"diffusion: antuono, integrator: rk4-frozen, kernel: gaussian", 0.97},
      {"diffusion: antuono, integrator: rk4-frozen, kernel: cubic", 0.97},
      {"diffusion: molteni, integrator: rk4, kernel: tensor", 0.97},
      {"diffusion: ferrari, integrator: rk4-frozen, kernel: quintic", 0.97},
      {"diffusion: ferrari, integrator: tvd-rk3, kernel: wendland_c4, h_over_dx: 2", 0.97},
  };
  for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
    const double below = noise_left(of[k].run, of[k].below), above = noise_left(of[k].run, 1.03);
    printf("     %s: %.2g, %.2g\n", of[k].run, below, above);
    EXPECT(below < 1);
    EXPECT(above > 100);
  }
}

int main(void) {
  RUN(test_tensor_kernel_with_h_of_a_spacing_is_exact);
  RUN(test_spline_sums_fail_between_whole_ratios);
  RUN(test_B_of_the_continuum);
  RUN(test_B_of_the_lattice_is_three_times_as_large);
  RUN(test_viscosity_of_long_waves);
  RUN(test_largest_decay_rates_of_the_diffusions);
  RUN(test_rows_below_a_surface);
  RUN(test_diffusion_below_a_surface);
  RUN(test_longest_stable_steps);
  RUN(test_waves_by_a_fit);
  RUN(test_waves_of_densities_that_are_sums);
  RUN(test_modified_pc_is_neutral_where_the_density_is_a_sum);
  RUN(test_steps_at_rest_are_stable_for_every_derivative);
  RUN(test_steps_at_rest_are_stable_for_every_kernel);
  RUN(test_modes_grow_as_the_integrator_has_it);
  RUN(test_solver_is_stable_up_to_the_longest_steps);
  return TEST_RESULT;
}

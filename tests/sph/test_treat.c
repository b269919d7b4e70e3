/* Treatments of the water between steps. */
#include "tests/test.h"

#include <omp.h>

#include "sph/fluid/energy.h"
#include "sph/theory/lattice.h"
#include "sph/treat/loops.h"
#include "sph/treat/treat.h"
#include "tests/sph/pool.h"

/* Of the list, those for any tank; for tanks with periodic sides see test_modes.c, too. */
static const struct {
  const char *name;
  const struct sph_treatment *is;
} treatments[] = {
#define X(name, ...) {#name, &sph_treatment_##name},
    SPH_TREATMENTS(X)
#undef X
};

#define POOL_ROUND                                                                                 \
  "title: periodic water\nscales: {H: 1}\n"                                                        \
  "tank: {walls: [[[0, 2], [0, 0], [2, 0], [2, 2]]], sides: periodic}\n"                           \
  "water: {regions: [[[0, 0], [2, 0], [2, 1], [0, 1]]], pressure: hydrostatic}\n" POOL_TIMES

static struct sph *open_water(struct case_file **c, const char *head, const char *run) {
  *c = pool_case(head, run);
  return pool_create(*c);
}

static void close_water(struct case_file *c, struct sph *s) {
  sph_destroy(s);
  case_destroy(c);
}

/* What treatments have taken so far, J/m. */
static double taken(const struct sph *s) {
  double sum = 0;
#define X(name, ...) sum += s->budget.name;
  SPH_TREATMENTS(X)
#undef X
  return sum;
}

/* Applies what is due after a step; checks that what it takes out of the energy is booked. */
static void treat(struct sph *s) {
  s->steps = 1;
  sph_particles_pad(&s->f);
  const double before = sph_energy(s).total;
  EXPECT_OK(sph_treat(s));
  EXPECT(taken(s) != 0 && s->budget.diffusion == 0);
  EXPECT_NEAR(sph_energy(s).total + taken(s), before, 1e-12 * fabs(before));
}

/* Whether the support of a particle of the drop is full. */
static bool is_inside(const struct sph *s, size_t i) {
  const double x = s->f.w.x[i], y = s->f.w.y[i];
  return fmin(fmin(x - 1, 2 - x), fmin(y - 1, 2 - y)) > s->support + 0.1 * s->dx;
}

/* What the mean over a square lattice leaves of a wave along it; k in 1/h. */
static double symbol(enum sph_kernel kernel, double k) {
  struct sph_lattice l;
  struct sph_symbols sums;
  sph_lattice_of(kernel, 4. / 3, &l);
  sph_lattice_symbols(&l, SPH_DIFFUSION_none, k, 0, &sums);
  return sums.W / sph_lattice_moment(&l, 0, 0, SPH_LATTICE_REACH);
}

static const char *const kernels[] = {
#define X(name, help) #name,
    SPH_KERNELS(X)
#undef X
};

/* Of velocities (m/s) and densities: a wave of each keeps as much as the symbol says, to the
 * rounding of densities near 1000 and the kernel's exponential, 1e-14 each. */
static void expect_symbol(int kernel, const char *treatment, bool of_velocity) {
  char run[100];
  snprintf(run, sizeof run, "resolution: 40, kernel: %s, %s: 1, precision: double", kernels[kernel],
           treatment);
  for (int waves = 2; waves <= 20; waves += 6) {
    struct case_file *c;
    struct sph *s = open_water(&c, POOL_DROP, run);
    const double k = 2 * M_PI * waves, dx = s->dx;
    const double S = symbol((enum sph_kernel)kernel, k * s->h);
    for (size_t i = 0; i < s->f.n; i++) {
      const double wave = cos(k * (s->f.w.x[i] - dx / 2));
      s->f.w.rho[i] = s->rho0 * (1 + 1e-3 * wave);
      s->f.m[i] = s->f.w.rho[i] * dx * dx; /* equal volumes, for the symbol */
      s->f.w.u[i] = 3 * wave;
      s->f.w.v[i] = 1 + wave;
    }
    treat(s);
    double worst = 0;
    for (size_t i = 0; i < s->f.n; i++) {
      if (!is_inside(s, i)) continue;
      const double wave = cos(k * (s->f.w.x[i] - dx / 2)), left = of_velocity ? S * wave : wave;
      worst = fmax(worst, fabs((s->f.w.rho[i] / s->rho0 - 1) * 1e3 - S * wave));
      worst = fmax(worst, fabs(s->f.w.u[i] - 3 * left));
      worst = fmax(worst, fabs(s->f.w.v[i] - 1 - left));
    }
    EXPECT_NEAR(worst, 0, 1e-10);
    close_water(c, s);
  }
}

static void test_means_damp_waves_by_their_symbol(void) {
  for (int k = 0; k < SPH_KERNEL_COUNT; k++) {
    expect_symbol(k, "shepard", false);
    expect_symbol(k, "smoothing", true);
    expect_symbol(k, "mls_volume", false); /* on a lattice the plane's value is the mean */
  }
}

/* Coefficients of (kh)^2 and symbols of the shortest wave, of sums by hand: the spline's are those
 * of the thesis' runs, h = dx/0.75, whose smoothing after every n steps is a viscosity of 1.261/(n
 * mu) h c0/8. */
static void test_symbols_of_the_thesis_and_the_paper(void) {
  const double k = 0.01, shortest = M_PI * 4 / 3;
  EXPECT_NEAR((1 - symbol(SPH_KERNEL_cubic, k)) / (k * k), 0.1576, 5e-5);
  EXPECT_NEAR(8 * (1 - symbol(SPH_KERNEL_cubic, k)) / (k * k), 1.261, 5e-4);
  EXPECT_NEAR(symbol(SPH_KERNEL_cubic, shortest), 0.0757, 5e-5);
  /* 1/4 of a whole Gaussian; cut at 3h and lowered by C0, as in the plane */
  const double C0 = exp(-9), moment = 0.25 * (1 - 40.5 * C0 / (1 - 10 * C0));
  EXPECT_NEAR((1 - symbol(SPH_KERNEL_gaussian, k)) / (k * k), moment, 1e-3 * moment);
}

/* Whatever is uniform stays, to the rounding of densities near 1000; at the surface too. */
static void test_treatments_keep_a_constant(void) {
  for (int k = 0; k < SPH_TREATMENT_COUNT; k++) {
    if (treatments[k].is->periodic) continue; /* it takes away what is uniform */
    char run[100];
    snprintf(run, sizeof run, "resolution: 20, %s: 1", treatments[k].name);
    struct case_file *c;
    struct sph *s = open_water(&c, POOL_DROP, run);
    pool_shake(s, 0.3, 0, 0);
    for (size_t i = 0; i < s->f.n; i++) {
      s->f.w.u[i] = 2;
      s->f.w.v[i] = -3;
    }
    s->steps = 1;
    sph_particles_pad(&s->f);
    EXPECT_OK(sph_treat(s));
    for (size_t i = 0; i < s->f.n; i++) {
      EXPECT_NEAR(s->f.w.rho[i] / s->rho0, 1, 1e-14);
      EXPECT_NEAR(s->f.w.u[i], 2, 1e-14);
      EXPECT_NEAR(s->f.w.v[i], -3, 1e-14);
    }
    close_water(c, s);
  }
}

/* With any neighbours, at the surface too; to the rounding of densities, a few of whose units the
 * inverse of the moments multiplies. */
static void test_mls_by_volumes_keeps_a_linear_density(void) {
  struct case_file *c;
  struct sph *s = open_water(&c, POOL_DROP, "resolution: 20, mls_volume: 1, precision: double");
  pool_shake(s, 0.2, 1, 0);
  double linear[4096];
  for (size_t i = 0; i < s->f.n; i++)
    linear[s->f.id[i]] = s->f.w.rho[i] = s->rho0 * (1 + 0.01 * s->f.w.x[i] - 0.02 * s->f.w.y[i]);
  s->steps = 1;
  sph_particles_pad(&s->f);
  EXPECT_OK(sph_treat(s));
  for (size_t i = 0; i < s->f.n; i++) EXPECT_NEAR(s->f.w.rho[i] / linear[s->f.id[i]], 1, 1e-13);
  close_water(c, s);
}

/* Still water whose densities went astray has its hydrostatic ones again. */
static void test_mls_by_masses_gives_the_first_density(void) {
  struct case_file *c;
  struct sph *s = open_water(&c, POOL_STILL, "resolution: 20, mls_mass: 1, precision: double");
  double first[4096];
  for (size_t i = 0; i < s->f.n; i++) first[s->f.id[i]] = s->f.w.rho[i];
  pool_shake(s, 0, 1, 1e4);
  treat(s);
  for (size_t i = 0; i < s->f.n; i++) EXPECT_NEAR(s->f.w.rho[i] / first[s->f.id[i]], 1, 1e-13);
  close_water(c, s);
}

/* In still water means of the density lift the pressure of the top row, by the mean depth of a
 * lattice's lower half under the kernel; those of its excess over the hydrostatic density, which is
 * constant, leave it to rounding, and so do both where the density that evolves is that excess. */
static void test_smoothing_the_excess_keeps_the_top_row(void) {
  static const struct {
    const char *keys;
    double lift; /* rho g dx */
  } runs[] = {{"smoothing_of: density", 0.47472},
              {"smoothing_of: density, kernel: cubic", 0.33789},
              {"smoothing_of: excess", 0},
              {"smoothing_of: density, eos: split, momentum: reference", 0},
              {"smoothing_of: excess, eos: split, momentum: reference", 0}};
  for (size_t k = 0; k < sizeof runs / sizeof *runs; k++) {
    char run[200];
    snprintf(run, sizeof run, "resolution: 20, walls: mirror, precision: double, smoothing: 1, %s",
             runs[k].keys);
    struct case_file *c;
    struct sph *s = open_water(&c, POOL_STILL, run);
    double first[4096], least = INFINITY, most = -INFINITY;
    for (size_t i = 0; i < s->f.n; i++) first[s->f.id[i]] = pool_p(s, i);
    s->steps = 1;
    EXPECT_OK(sph_treat(s));
    for (size_t i = 0; i < s->f.n; i++) {
      if (s->f.w.y[i] < 1 - s->dx) continue;
      const double lifted = (pool_p(s, i) - first[s->f.id[i]]) / (s->rho0 * s->g * s->dx);
      least = fmin(lifted, least);
      most = fmax(lifted, most);
    }
    printf("     the top row is lifted by %.5f to %.5f rho g dx\n", least, most);
    if (runs[k].lift == 0)
      EXPECT_NEAR(fmax(most, -least), 0, 1e-9);
    else
      EXPECT_NEAR(most, runs[k].lift, 2e-3); /* volumes differ by g H/c0^2 = 2.5e-3 */
    close_water(c, s);
  }
}

/* After as many steps as the key says, and the budget of a run stays closed. */
static void test_treatments_come_after_so_many_steps(void) {
  struct case_file *c = pool_case(POOL_DAM, "resolution: 16, diffusion: none, shepard: 5");
  struct sph *s = pool_create(c);
  double spent = 0;
  const double before = sph_energy(s).total;
  for (int k = 0; k < 20; k++) {
    EXPECT_OK(sph_treat(s));
    EXPECT((s->budget.shepard != spent) == (k > 0 && k % 5 == 0));
    spent = s->budget.shepard;
    EXPECT_OK(sph_rates(s, 0, true, true));
    EXPECT_OK(sph_step(s, sph_timestep(s, 1)));
  }
  const struct result_energy e = sph_energy(s);
  EXPECT_NEAR(result_energy_budget(&e) / before, 1, 1e-6);
  sph_destroy(s);
  case_destroy(c);
}

/* The mean and the relative spread of the distances of particles inside the drop to their nearest
 * neighbours. */
static double spread_of_distances(const struct sph *s, double *mean) {
  double n = 0, sum = 0, sum2 = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    if (!is_inside(s, i)) continue;
    double nearest = INFINITY;
    for (size_t j = 0; j < s->f.n; j++) {
      const double d = hypot(s->f.w.x[j] - s->f.w.x[i], s->f.w.y[j] - s->f.w.y[i]);
      if (j != i) nearest = fmin(nearest, d);
    }
    n++;
    sum += nearest / s->dx;
    sum2 += nearest * nearest / (s->dx * s->dx);
  }
  *mean = sum / n;
  return sqrt(sum2 / n - *mean * *mean) / *mean;
}

/* Particles thrown about by up to 0.3 dx: shifts spread them evenly, by what a speed of 0.1 c0 and
 * a Courant number of 1.5 make of the paper's, and leave velocities and densities. */
static void test_shifting_undoes_clumps(void) {
  struct case_file *c;
  struct sph *s = open_water(&c, POOL_DROP, "resolution: 40, shifting: 1");
  pool_shake(s, 0.3, 0, 0);
  for (size_t i = 0; i < s->f.n; i++) s->f.w.u[i] = 0.1 * s->c0;
  s->steps = 1;
  s->dt = 1.5 * s->h / s->c0;
  sph_particles_pad(&s->f);
  double before, after, x = 0;
  const double spread = spread_of_distances(s, &before);
  for (size_t i = 0; i < s->f.n; i++) x += s->f.m[i] * s->f.w.x[i];
  for (int k = 0; k < 40; k++) EXPECT_OK(sph_treat(s));
  const double left = spread_of_distances(s, &after);
  for (size_t i = 0; i < s->f.n; i++) {
    x -= s->f.m[i] * s->f.w.x[i];
    EXPECT(s->f.w.u[i] == 0.1 * s->c0 && s->f.w.v[i] == 0 && s->f.w.rho[i] == s->rho0);
  }
  printf("     nearest neighbours: %.3f dx, spread %.3f, after 40 shifts %.3f dx, spread %.3f; "
         "centre moved %.1e dx\n",
         before, spread, after, left, x / s->rho0 / s->dx);
  EXPECT(left < spread / 2);
  EXPECT(after > before);
  close_water(c, s);
}

/* Shifts of pairs are equal and opposite, times their masses: in double precision the sum is zero
 * to rounding. */
static void test_shifts_keep_the_centre_of_mass(void) {
  struct case_file *c;
  struct sph *s = open_water(&c, POOL_DROP, "resolution: 20, precision: double");
  pool_shake(s, 0.3, 1, 1e6);
  for (size_t i = 0; i < s->f.n; i++) s->f.m[i] *= 1 + 0.2 * pool_random();
  EXPECT_OK(sph_neighbours_update(s));
  sph_pack_water(s);
  double x = 0, size = 0;
  for (size_t k = 0; k < s->water_water.n_clusters; k++) {
    const struct sph_targets i = sph_targets_of(s, k);
    const struct sph_near water = sph_near_of(&s->water_water, k, s->pack);
    struct sph_vector_sums a;
    sph_treat_loops_for(s, &i)->crowd(s, 0.2, &i, &water, &a);
    for (size_t l = 0; l < SPH_LANES; l++) {
      x += s->f.m[k * SPH_LANES + l] * a.x[l];
      size += s->f.m[k * SPH_LANES + l] * fabs(a.x[l]);
    }
  }
  EXPECT_NEAR(x / size, 0, 1e-13);
  close_water(c, s);
}

/* As often as sound goes 4.25 h / (0.158/moment) with this kernel, whatever the steps. */
static void test_smoothing_by_itself_diffuses_alike(void) {
  static const char *const runs[] = {
      "resolution: 16, smoothing: auto, kernel: cubic",
      "resolution: 16, smoothing: auto, kernel: cubic, cfl_acoustic: 0.8"};
  for (int r = 0; r < 2; r++) {
    struct case_file *c;
    struct sph *s = open_water(&c, POOL_DAM, runs[r]);
    int applied = 0;
    double time = 0; /* over 4.25 h/c0, when last looked */
    for (int k = 0; k < 60; k++) {
      const double spent = s->budget.smoothing;
      time = s->t * s->c0 / s->h / 4.25;
      EXPECT_OK(sph_treat(s));
      applied += s->budget.smoothing != spent;
      EXPECT_OK(sph_rates(s, 0, true, true));
      EXPECT_OK(sph_step(s, sph_timestep(s, 1)));
    }
    printf("     %d times in %.2f times 4.25 h/c0\n", applied, time);
    EXPECT(applied <= 1.01 * time && applied > 0.99 * time - 1); /* 0.158 is a rounded moment */
    close_water(c, s);
  }
}

/* Densities and speeds after eight steps. */
static void run_with(const char *head, const char *key, const char *value, int threads,
                     double sum[4096]) {
  char run[100];
  struct case_file *c;
  snprintf(run, sizeof run, "resolution: 20, %s: %s", key, value);
  struct sph *s = open_water(&c, head, run);
  omp_set_num_threads(threads);
  for (int k = 0; k < 8; k++) {
    EXPECT_OK(sph_treat(s));
    EXPECT_OK(sph_rates(s, 0, true, true));
    EXPECT_OK(sph_step(s, sph_timestep(s, 1)));
  }
  for (size_t i = 0; i < s->f.n; i++) sum[s->f.id[i]] = s->f.w.rho[i] + s->f.w.u[i] * s->f.w.v[i];
  sum[s->f.n] = taken(s);
  close_water(c, s);
}

static void expect_same_bits(const char *head, const char *key, const char *value) {
  double sum[3][4096] = {{0}};
  for (int threads = 1; threads <= 3; threads++) {
    run_with(head, key, value, threads, sum[threads - 1]);
  }
  EXPECT(!memcmp(sum[0], sum[1], sizeof sum[0]) && !memcmp(sum[0], sum[2], sizeof sum[0]));
}

static void test_treatments_are_the_same_bits_for_any_number_of_threads(void) {
  const int most = omp_get_max_threads();
  for (int k = 0; k < SPH_TREATMENT_COUNT; k++)
    expect_same_bits(treatments[k].is->periodic ? POOL_ROUND : POOL_DAM, treatments[k].name, "3");
#define X(name, ...) expect_same_bits(POOL_DAM, #name, "0.5");
  SPH_CORRECTIONS(X)
#undef X
  omp_set_num_threads(most);
}

int main(void) {
  RUN(test_means_damp_waves_by_their_symbol);
  RUN(test_symbols_of_the_thesis_and_the_paper);
  RUN(test_treatments_keep_a_constant);
  RUN(test_mls_by_volumes_keeps_a_linear_density);
  RUN(test_mls_by_masses_gives_the_first_density);
  RUN(test_smoothing_the_excess_keeps_the_top_row);
  RUN(test_shifting_undoes_clumps);
  RUN(test_shifts_keep_the_centre_of_mass);
  RUN(test_smoothing_by_itself_diffuses_alike);
  RUN(test_treatments_come_after_so_many_steps);
  RUN(test_treatments_are_the_same_bits_for_any_number_of_threads);
  return TEST_RESULT;
}

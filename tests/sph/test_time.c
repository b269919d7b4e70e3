/* Integrators and time steps. */
#include "tests/test.h"

#include "sph/pair/diffuse.h"
#include "sph/pair/kernel.h"
#include "sph/theory/lattice.h"
#include "sph/time/chebyshev.h"
#include "sph/time/integrator.h"
#include "sph/time/linear.h"
#include "sph/time/stages.h"
#include "sph/time/timestep.h"
#include "tests/sph/pool.h"

/* Sixteen particles in a block so small that no pair ever leaves the support: the rates are smooth,
 * and the measured order is the method's. */
static struct sph *cluster(int integrator, struct case_file **c) {
  char run[200];
  const struct sph_integrator *m = sph_integrators[integrator];
  snprintf(run, sizeof run,
           "resolution: 4, h_over_dx: 2, diffusion: %s, alpha: 0.1, integrator: %s, dt: 1e-6, "
           "damping: %d, precision: double",
           m->split ? "molteni" : "antuono", sph_integrator_names[integrator], m->damps ? 20 : 0);
  *c = pool_case(
      "title: sixteen\nscales: {H: 1}\ntank: {walls: [[[0, 30], [0, 0], [30, 0], [30, 30]]]}\n"
      "water: {regions: [[[14, 14], [15, 14], [15, 15], [14, 15]]], pressure: "
      "hydrostatic}\n" POOL_TIMES,
      run);
  struct sph *s = pool_create(*c);
  for (size_t i = 0; i < s->f.n; i++) { /* the same in every run: by place, not by order of calls */
    double k = (double)s->f.id[i];
    s->f.w.u[i] = 0.5 * sin(1.7 * k);
    s->f.w.v[i] = 0.5 * cos(2.3 * k);
    s->f.w.rho[i] = s->rho0 * (1 + 1e-3 * sin(3.1 * k));
  }
  sph_particles_pad(&s->f);
  return s;
}

static void state_of(const struct sph *s, double out[16][4]) {
  for (size_t i = 0; i < 16; i++) {
    double *o = out[s->f.id[i]];
    o[0] = s->f.w.x[i];
    o[1] = s->f.w.y[i];
    o[2] = s->f.w.u[i] / s->c0;
    o[3] = s->f.w.rho[i] / s->rho0;
  }
}

static void march(int integrator, int steps, double time, double out[16][4]) {
  struct case_file *c;
  struct sph *s = cluster(integrator, &c);
  for (int k = 0; k < steps; k++)
    if (sph_rates(s, 0, true, true) != OK || sph_step(s, time / steps) != OK) exit(1);
  state_of(s, out);
  sph_destroy(s);
  case_destroy(c);
}

static double difference(double a[16][4], double b[16][4]) {
  double worst = 0;
  for (int i = 0; i < 16; i++)
    for (int k = 0; k < 4; k++) worst = fmax(worst, fabs(a[i][k] - b[i][k]));
  return worst;
}

/* Steps dt, dt/2, dt/4: the ratio of successive differences is 2^order. Within 0.25: the largest
 * step is a fifth of the stability limit. */
static void test_integrators_have_the_order_they_declare(void) {
  for (int k = 0; k < SPH_INTEGRATOR_COUNT; k++) {
    double a[16][4], b[16][4], c[16][4];
    const double time = 0.02;
    march(k, 8, time, a);
    march(k, 16, time, b);
    march(k, 32, time, c);
    double order = log2(difference(a, b) / difference(b, c));
    printf("     %s: order %.3f\n", sph_integrator_names[k], order);
    EXPECT_NEAR(order, sph_integrators[k]->order, 0.25);
  }
}

/* Each bound by hand, for water at rest, h = 1/15 m. */
static void test_time_step_obeys_every_bound(void) {
  struct case_file *c = pool_case(POOL_DROP, "resolution: 20, diffusion: antuono, delta: 0.3, "
                                             "alpha: 0.4, integrator: rk4, c0: 50");
  struct sph *s = pool_create(c);
  EXPECT_OK(sph_rates(s, 0, true, true));
  struct sph_bounds b = sph_timestep_bounds(s);
  double h = 4. / 3 / 20;
  EXPECT_NEAR(b.diffusive, 0.44 * h / (0.3 * 50), 1e-14);
  EXPECT_NEAR(b.viscous, 0.125 * h * h / (0.4 * h * 50 / 8), 1e-14);
  EXPECT_NEAR(b.acoustic, 2.2 * h / 50, 1e-14); /* at rest pi = 0 */
  double most = 0;
  for (size_t i = 0; i < s->f.n; i++) most = fmax(most, hypot(s->f.k[0].u[i], s->f.k[0].v[i]));
  EXPECT_NEAR(b.acceleration, 0.25 * sqrt(h / most), 1e-14);
  double dt = fmin(fmin(b.diffusive, b.viscous), fmin(b.acceleration, b.acoustic));
  EXPECT_NEAR(sph_timestep(s, 1e9 * dt), dt, 1e-6 * dt);
  /* equal steps to the next output, rather than one tiny one */
  EXPECT_NEAR(sph_timestep(s, 2.5 * dt), 2.5 * dt / 3, 1e-14);
  EXPECT_NEAR(sph_timestep(s, 0.1 * dt), 0.1 * dt, 1e-14);
  s->scheme.dt = 3 * dt; /* or the one that is given */
  EXPECT_NEAR(sph_timestep(s, 60 * dt), 3 * dt, 1e-14);
  sph_destroy(s);
  case_destroy(c);
}

/* First dt at which the method amplifies the wave, by steps of 1e-3. Next to 0 it does so by
 * rounding at most. */
static double stable_up_to(const struct sph_integrator *m, const struct sph_linear *p) {
  double dt = 0, growth;
  do {
    dt += 1e-3;
    if (sph_linear_growth(m, p, dt, &growth) != OK) exit(1);
  } while (growth <= 1 + 1e-12);
  return dt;
}

/* Sound and convection lie on the imaginary axis, diffusion on the negative real one; P found its
 * factors for classic RK4. Within the steps of the search. */
static void test_time_step_factors_are_the_limits_of_stability(void) {
  const struct sph_linear sound = sph_linear_sound(1), decay = {.rate = 1};
  const double acoustic = stable_up_to(&sph_rk4, &sound);
  const double diffusive = stable_up_to(&sph_rk4, &decay);
  EXPECT_NEAR(acoustic, sqrt(8), 1e-3);
  for (int k = 0; k < SPH_INTEGRATOR_COUNT; k++) {
    struct sph_integrator m = *sph_integrators[k];
    m.frozen = false; /* what that costs depends on the term */
    EXPECT_NEAR(m.acoustic, stable_up_to(&m, &sound) / acoustic, 1e-3);
    if (m.split)
      EXPECT(isinf(m.diffusive));
    else
      EXPECT_NEAR(m.diffusive, stable_up_to(&m, &decay) / diffusive, 1e-3);
  }
}

/* A plane wave of density on a square lattice at rest, dx = 1: frequency of its sound over c0, and
 * rate at which a diffusion lets it decay over delta c0, along the wave number (kx, ky). */
static void lattice_wave(const struct sph_lattice *l, enum sph_diffusion d, double kx, double ky,
                         double *omega, double *rate) {
  const double h = l->h_over_dx;
  struct sph_symbols wave;
  sph_lattice_symbols(l, d, kx * h, ky * h, &wave);
  *omega = hypot(wave.Gx, wave.Gy) / h;
  *rate = wave.D / h;
}

/* Every mode decays, none by much less or more than it should, and the slow ones at their rate. */
static void test_exponential_of_the_diffusion_lets_every_mode_decay(void) {
  EXPECT(sph_chebyshev_of(1e9).degree == SPH_CHEBYSHEV_MOST + 1);
  for (double Z = 0.01; Z < 300; Z *= 1.1) {
    const struct sph_chebyshev p = sph_chebyshev_of(Z);
    double most = 0, off = 0;
    for (int k = 1; k <= 1000; k++) {
      const double z = -Z * k / 1000, g = sph_chebyshev_value(&p, z);
      most = fmax(most, fabs(g));
      off = fmax(off, fabs(g - exp(z)));
    }
    EXPECT(most < 1);
    EXPECT(off < 0.03);
    EXPECT_NEAR((1 - sph_chebyshev_value(&p, -1e-6 * Z)) / (1e-6 * Z), 1, 2e-6 * (1 + Z));
  }
}

/* rho' = i omega u - rate rho, u' = i omega rho. */
static struct sph_linear damped_sound(double omega, double rate, double fastest) {
  struct sph_linear p = sph_linear_sound(omega);
  p.rate = rate;
  p.fastest = fastest;
  return p;
}

/* Sound and diffusion together, in every wave that a lattice carries along its rows and diagonals,
 * with every kernel and integrator: steps a ninth longer than the bounds of water at rest are
 * stable. (Ferrari's frozen ones were not, and broke down where particles are in disorder.) */
static void expect_stable_steps(enum sph_kernel kernel, enum sph_diffusion d, int integrator) {
  struct case_file *c = pool_case(POOL_DROP, "resolution: 20, alpha: 0, c0: 50");
  struct sph_scheme o = *(const struct sph_scheme *)c->runs[0].options;
  struct sph_lattice lattice;
  struct sph *s;
  o.kernel = (int)kernel;
  o.diffusion = (int)d;
  o.integrator = integrator;
  sph_lattice_of(kernel, o.h_over_dx, &lattice);
  EXPECT_OK(sph_create(c, 20, &o, &s));
  EXPECT_OK(sph_rates(s, 0, true, true));
  struct sph_bounds b = sph_timestep_bounds(s);
  double dt = 10. / 9 * fmin(b.diffusive, b.acoustic) * s->c0 / s->dx, most = 0;
  double fastest = sph_diffuse(s, s->f.k[1].rho) * s->dx / s->c0;
  for (int n = 1; n <= 32; n++)
    for (int diagonal = 0; diagonal < 2; diagonal++) {
      double omega, rate, growth, wave = M_PI * n / 32;
      lattice_wave(&lattice, d, wave, wave * diagonal, &omega, &rate);
      const struct sph_linear p = damped_sound(omega, rate * s->scheme.delta, fastest);
      EXPECT_OK(sph_linear_growth(sph_integrators[integrator], &p, dt, &growth));
      most = fmax(most, growth);
    }
  if (most > 1 + 1e-9)
    printf("     kernel %d, diffusion %d, %s: grows by %g\n", (int)kernel, (int)d,
           sph_integrator_names[integrator], most);
  EXPECT(most <= 1 + 1e-9);
  sph_destroy(s);
  case_destroy(c);
}

static void test_default_steps_are_stable_with_every_diffusion(void) {
  for (int kernel = 0; kernel < SPH_KERNEL_COUNT; kernel++)
    for (int d = 1; d < SPH_DIFFUSION_COUNT; d++)
      for (int k = 0; k < SPH_INTEGRATOR_COUNT; k++) {
        if (sph_integrators[k]->split && diffusion_needs_gradient((enum sph_diffusion)d)) continue;
        if (sph_integrators[k]->acoustic == 0) continue; /* has no step of its own */
        expect_stable_steps((enum sph_kernel)kernel, (enum sph_diffusion)d, k);
      }
}

/* How wrong a step of dt makes the frequency and the damping of sound, over its frequency, at worst
 * in the waves of 64 dx and down to 10.7 dx = 8 h along the rows of a lattice. The exact factor a
 * unit of time is exp(-rate/2 +- i sqrt(omega^2 - rate^2/4)). */
static double sound_error(enum sph_diffusion d, double delta, const struct sph_integrator *m,
                          double fastest, double dt) {
  struct sph_lattice lattice;
  double worst = 0;
  sph_lattice_of(SPH_KERNEL_gaussian, 4. / 3, &lattice);
  for (int n = 1; n <= 6; n++) {
    double omega, rate, off = INFINITY;
    double complex G[SPH_LINEAR][SPH_LINEAR], factor[SPH_LINEAR];
    lattice_wave(&lattice, d, M_PI * n / 32, 0, &omega, &rate);
    rate *= delta;
    const struct sph_linear p = damped_sound(omega, rate, fastest);
    sph_linear_step(m, &p, dt, G);
    EXPECT_OK(sph_linear_factors(G, factor));
    const double complex exact = -rate / 2 + I * csqrt(omega * omega - rate * rate / 4);
    for (int k = 0; k < SPH_LINEAR; k++) off = fmin(off, cabs(clog(factor[k]) / dt - exact));
    worst = fmax(worst, off / omega);
  }
  return worst;
}

/* The long steps of rk4-split against the short ones that diffusion leaves to the frozen method,
 * with its error of first order: sound is carried better. */
static void test_split_steps_carry_sound_better_than_frozen_ones(void) {
  const enum sph_diffusion of[2] = {SPH_DIFFUSION_molteni, SPH_DIFFUSION_ferrari};
  for (int k = 0; k < 2; k++) {
    double error[SPH_INTEGRATOR_COUNT], dt[SPH_INTEGRATOR_COUNT];
    for (int m = 0; m < SPH_INTEGRATOR_COUNT; m++) {
      if (sph_integrators[m]->acoustic == 0) continue; /* has no step of its own */
      struct case_file *c = pool_case(POOL_DROP, "resolution: 20, alpha: 0, c0: 50");
      struct sph_scheme o = *(const struct sph_scheme *)c->runs[0].options;
      o.diffusion = of[k];
      o.integrator = m;
      struct sph *s;
      EXPECT_OK(sph_create(c, 20, &o, &s));
      EXPECT_OK(sph_rates(s, 0, true, true));
      struct sph_bounds b = sph_timestep_bounds(s);
      dt[m] = fmin(b.diffusive, b.acoustic) * s->c0 / s->dx;
      error[m] = sound_error(of[k], s->scheme.delta, sph_integrators[m],
                             sph_diffuse(s, s->f.k[1].rho) * s->dx / s->c0, dt[m]);
      printf("     %s, %s: c0 dt/dx = %.3f, sound wrong by %.1e\n", k ? "ferrari" : "molteni",
             sph_integrator_names[m], dt[m], error[m]);
      sph_destroy(s);
      case_destroy(c);
    }
    EXPECT(dt[SPH_INTEGRATOR_rk4_split] > 2 * dt[SPH_INTEGRATOR_rk4_frozen]);
    EXPECT(error[SPH_INTEGRATOR_rk4_split] < error[SPH_INTEGRATOR_rk4_frozen]);
  }
}

/* Freezing is for free only where it leaves the step as it is. */
static void test_auto_freezes_only_what_is_stable_frozen(void) {
  for (int d = 0; d < SPH_DIFFUSION_COUNT; d++) {
    struct case_file *c = pool_case(POOL_DROP, "resolution: 20, c0: 50");
    struct sph_scheme o = *(const struct sph_scheme *)c->runs[0].options;
    o.diffusion = d;
    struct sph *s;
    EXPECT_OK(sph_create(c, 20, &o, &s));
    const struct sph_integrator *m = sph_integrators[s->scheme.integrator];
    EXPECT(m->frozen == (diffusion_frozen((enum sph_diffusion)d) == 1));
    EXPECT(m->split == !m->frozen);
    sph_destroy(s);
    case_destroy(c);
  }
}

/* The bounds of other integrators and diffusions than RK4 with Antuono's are scaled. */
static void test_time_step_bounds_know_the_integrator_and_the_diffusion(void) {
  struct case_file *c = pool_case(POOL_DROP, "resolution: 20, diffusion: ferrari, alpha: 0, "
                                             "integrator: tvd-rk3, c0: 50");
  struct sph *s = pool_create(c);
  EXPECT_OK(sph_rates(s, 0, true, true));
  struct sph_bounds b = sph_timestep_bounds(s);
  double h = 4. / 3 / 20;
  EXPECT_NEAR(b.diffusive / (0.44 * h / (sqrt(M_PI) / 4 * 50)), 2.513 / 2.785, 1e-3);
  EXPECT_NEAR(b.acoustic / (2.2 * h / 50), sqrt(3) / sqrt(8), 1e-3);
  EXPECT(isinf(b.viscous));
  sph_destroy(s);
  case_destroy(c);
}

/* u = (a x, 0) has pi = a x^2/r^2, at most a. */
static void test_acoustic_bound_sees_velocity_gradients(void) {
  struct case_file *c = pool_case(POOL_DROP, "resolution: 20, alpha: 0, c0: 50");
  struct sph *s = pool_create(c);
  const double a = -300; /* compression counts as well */
  double fastest = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    s->f.w.u[i] = a * (s->f.w.x[i] - 1.5);
    fastest = fmax(fastest, fabs(s->f.w.u[i]));
  }
  sph_particles_pad(&s->f);
  EXPECT_OK(sph_rates(s, 0, true, true));
  EXPECT_NEAR(sph_timestep_bounds(s).acoustic, 2.2 * s->h / (50 + fastest + s->h * fabs(a)), 1e-12);
  sph_destroy(s);
  case_destroy(c);
}

/* A state at the end of a step is one step on: rates weigh one in all. */
static void test_stages_are_consistent(void) {
  for (int k = 0; k < SPH_INTEGRATOR_COUNT; k++) {
    const struct sph_stages s = sph_stages_of(sph_integrators[k], 0);
    const struct sph_row *end = &s.row[s.n];
    double x = end->own, u = 0, rho = 0;
    for (int r = 0; r < s.n; r++) {
      x += end->x[r];
      u += end->u[r];
      rho += end->rho[r];
    }
    EXPECT(end->keep == 1 && s.row[0].keep == 1 && s.n == sph_integrators[k]->evaluations);
    EXPECT_NEAR(x, 1, 1e-15);
    EXPECT_NEAR(u, 1, 1e-15);
    EXPECT_NEAR(rho, 1, 1e-15);
  }
}

/* Fast water whose lists do not hold within a step has the step done again with wider ones, and
 * ends where it would have; water whose lists hold keeps its places within a step. Rounding of
 * sums. */
static void test_steps_beyond_the_lists_are_done_again(void) {
  struct case_file *c[2];
  struct sph *s[2];
  const double dt = 0.001;
  for (int k = 0; k < 2; k++) {
    s[k] = cluster(SPH_INTEGRATOR_rk4, &c[k]);
    EXPECT_OK(sph_rates(s[k], 0, true, true));
    uint32_t before[16];
    memcpy(before, s[k]->f.id, sizeof before);
    size_t evaluations = s[k]->evaluations;
    if (k == 1) s[k]->skin = 1e-4 * s[k]->dx; /* moves 5e-4 m, dx = 0.25 m: again and again */
    EXPECT_OK(sph_step(s[k], dt));
    EXPECT((s[k]->evaluations - evaluations > 3) == (k == 1));
    if (k == 0) EXPECT(memcmp(before, s[k]->f.id, sizeof before) == 0);
  }
  double out[2][16][4];
  for (int k = 0; k < 2; k++) {
    state_of(s[k], out[k]);
    EXPECT(s[k]->t == dt && s[k]->steps == 1);
    sph_destroy(s[k]);
    case_destroy(c[k]);
  }
  EXPECT_NEAR(difference(out[0], out[1]), 0, 1e-14);
}

int main(void) {
  RUN(test_integrators_have_the_order_they_declare);
  RUN(test_time_step_obeys_every_bound);
  RUN(test_time_step_factors_are_the_limits_of_stability);
  RUN(test_default_steps_are_stable_with_every_diffusion);
  RUN(test_exponential_of_the_diffusion_lets_every_mode_decay);
  RUN(test_split_steps_carry_sound_better_than_frozen_ones);
  RUN(test_auto_freezes_only_what_is_stable_frozen);
  RUN(test_time_step_bounds_know_the_integrator_and_the_diffusion);
  RUN(test_acoustic_bound_sees_velocity_gradients);
  RUN(test_stages_are_consistent);
  RUN(test_steps_beyond_the_lists_are_done_again);
  return TEST_RESULT;
}

/* What integrators do to sound, momentum and energy: by the formulas of the thesis T, in the linear
 * problem that their stages give, and in the solver. */
#include "tests/test.h"

#include "sph/fluid/energy.h"
#include "sph/time/linear.h"
#include "tests/sph/pool.h"

/* |lambda|^2 of sound, z = omega dt (T, eqs. (2.246) to (2.268)). */
static double euler(double z) {
  return 1 + z * z;
}
static double heun(double z) {
  return 1 + pow(z, 4) / 4;
}
static double neutral(double z) {
  return z <= 2 ? 1 : NAN;
}
static double rk4(double z) {
  return 1 - pow(z, 6) / 72 + pow(z, 8) / 576;
}
static double tvd_rk3(double z) { /* |1 + iz - z^2/2 - i z^3/6|^2 */
  return pow(1 - z * z / 2, 2) + pow(z - z * z * z / 6, 2);
}

static const struct law {
  int integrator;
  double (*evolved)(double z), (*direct)(double z); /* of a density that evolves or is summed */
} laws[] = {{SPH_INTEGRATOR_euler, euler, euler},
            {SPH_INTEGRATOR_predictor_corrector, heun, heun},
            {SPH_INTEGRATOR_modified_pc, heun, neutral},
            {SPH_INTEGRATOR_rk4, rk4, rk4},
            {SPH_INTEGRATOR_rk4_frozen, rk4, rk4},
            {SPH_INTEGRATOR_rk4_split, rk4, rk4},
            {SPH_INTEGRATOR_tvd_rk3, tvd_rk3, tvd_rk3},
            {SPH_INTEGRATOR_stoermer_verlet, neutral, neutral}};
enum { LAWS = sizeof laws / sizeof *laws };

/* How far the nearest factor's magnitude is from this one. */
static double off(const struct sph_integrator *m, const struct sph_linear *p, double dt,
                  double magnitude) {
  double complex G[SPH_LINEAR][SPH_LINEAR], factor[SPH_LINEAR];
  double nearest = INFINITY;
  sph_linear_step(m, p, dt, G);
  EXPECT_OK(sph_linear_factors(G, factor));
  for (int k = 0; k < SPH_LINEAR; k++)
    if (fabs(cimag(factor[k])) > 1e-3 || cabs(factor[k] - 1) > 1e-3) /* not what stays as it is */
      nearest = fmin(nearest, fabs(cabs(factor[k]) - magnitude));
  return nearest;
}

static void test_sound_is_amplified_as_the_thesis_has_it(void) {
  for (int k = 0; k < LAWS; k++)
    for (double z = 0.1; z < 2; z += 0.1) {
      const struct sph_integrator *m = sph_integrators[laws[k].integrator];
      const struct sph_linear evolved = sph_linear_sound(1), direct = sph_linear_sound_direct(1);
      EXPECT_NEAR(off(m, &evolved, z, sqrt(laws[k].evolved(z))), 0, 1e-13);
      EXPECT_NEAR(off(m, &direct, z, sqrt(laws[k].direct(z))), 0, 1e-13);
    }
}

/* T, figures 3-1 and 3-2, and the limits of stability. */
static void test_initial_damping_is_that_of_the_thesis(void) {
  static const double zeta[3] = {1, 1.005, 1.025}, s[4] = {.2, .5, .7, 1};
  static const double sine[3][4] = {{1.000200, 1.007782, 1.029575, 1.118034},
                                    {.995211, 1.002756, 1.024441, 1.112461},
                                    {.975500, .982900, 1.004167, 1.090492}};
  static const double mu[4] = {.01, .1, .5, 1};
  static const double sinh[3][4] = {{1.01005, 1.10500, 1.62500, 2.50000},
                                    {1.006199, 1.099627, 1.616940, 2.487575},
                                    {1.001928, 1.081051, 1.585975, 2.439329}};
  static const double limit[3] = {0, 0.447772, 0.672881};
  for (int q = 0; q < 3; q++) {
    const double damping = 2 * (zeta[q] - 1);
    for (int i = 0; i < 4; i++)
      for (int direct = 0; direct < 2; direct++) {
        struct sph_linear p = direct ? sph_linear_sound_direct(s[i]) : sph_linear_sound(s[i]);
        p.damping = damping;
        EXPECT_NEAR(off(&sph_damped_pc, &p, 1, sine[q][i]), 0, 1e-6);
        p = direct ? sph_linear_sound_direct(mu[i]) : sph_linear_sound(mu[i]);
        for (int a = 0; a < SPH_LINEAR; a++) /* grows: omega^2 < 0 */
          for (int b = 0; b < SPH_LINEAR; b++)
            if (a != 0 && p.K[a][b] != 0) p.K[a][b] = direct ? mu[i] * mu[i] : mu[i];
        p.damping = damping;
        EXPECT_NEAR(off(&sph_damped_pc, &p, 1, sinh[q][i]), 0, 1e-5);
      }
    if (q == 0) continue;
    double growth, low = limit[q] - 1e-5, high = limit[q] + 1e-5;
    struct sph_linear p = sph_linear_sound(1);
    for (int side = 0; side < 2; side++) {
      const double dt = side ? high : low;
      p.damping = damping / dt;
      EXPECT_OK(sph_linear_growth(&sph_damped_pc, &p, dt, &growth));
      EXPECT((growth > 1 + 1e-9) == side);
    }
  }
}

/* ---- in the solver ---- */

/* Sixteen particles at rest, which never leave each other's support, next to no
 * gravity. */
static struct sph *sixteen(int integrator, double damping, struct case_file **c) {
  char run[300];
  snprintf(run, sizeof run,
           "resolution: 4, h_over_dx: 2, diffusion: none, alpha: 0, c0: 100, integrator: %s, "
           "dt: 1e-6, damping: %g, precision: double",
           sph_integrator_names[integrator], damping);
  *c = pool_case("title: sixteen\nscales: {H: 1}\nfluid: {gravity: 1e-9}\ntank: {walls: [[[0, 30], "
                 "[0, 0], [30, 0], [30, 30]]]}\n"
                 "water: {regions: [[[14, 14], [15, 14], [15, 15], [14, 15]]], pressure: "
                 "hydrostatic}\n" POOL_TIMES,
                 run);
  struct sph *s = pool_create(*c);
  for (size_t i = 0; i < s->f.n; i++) s->f.w.rho[i] = s->rho0;
  sph_particles_pad(&s->f);
  return s;
}

/* A state of sound: velocities and pressures of the places by id, in units in which the square of
 * all is twice its energy. */
struct sound {
  double u[16], v[16], q[16];
};

static double size_of(const struct sound *a) {
  double sum = 0;
  for (int i = 0; i < 16; i++) sum += a->u[i] * a->u[i] + a->v[i] * a->v[i] + a->q[i] * a->q[i];
  return sqrt(sum);
}

static void put(struct sph *s, const struct sound *a, double scale) {
  for (size_t i = 0; i < 16; i++) {
    const uint32_t id = s->f.id[i];
    s->f.w.u[i] = scale * a->u[id];
    s->f.w.v[i] = scale * a->v[id];
    s->f.w.rho[i] = s->rho0 * (1 + scale * a->q[id] / s->c0);
  }
  sph_particles_pad(&s->f);
}

static struct sound get(const struct sph *s, const struct sph_state *w, double rest) {
  struct sound a;
  for (size_t i = 0; i < 16; i++) {
    const uint32_t id = s->f.id[i];
    a.u[id] = w->u[i];
    a.v[id] = w->v[i];
    a.q[id] = s->c0 * (w->rho[i] / s->rho0 - rest);
  }
  return a;
}

/* The fastest sound of the sixteen, by iteration of its squared rate; its frequency (1/s). */
static double fastest_sound(struct sph *s, struct sound *a) {
  const double small = 1e-6;
  double omega2 = 0;
  for (int i = 0; i < 16; i++) *a = (struct sound){.u = {1, 0, 0, -2}, .q = {1, 2, 0, 0, 3}};
  for (int k = 0; k < 4000; k++) {
    struct sound rate = *a;
    for (int twice = 0; twice < 2; twice++) {
      put(s, &rate, small);
      EXPECT_OK(sph_rates(s, 0, true, false));
      rate = get(s, &s->f.k[0], 0);
      for (int i = 0; i < 16; i++) {
        rate.u[i] /= small;
        rate.v[i] /= small;
        rate.q[i] /= small;
      }
    }
    omega2 = size_of(&rate) / size_of(a);
    const double scale = 1 / size_of(&rate);
    for (int i = 0; i < 16; i++) {
      a->u[i] = rate.u[i] * scale;
      a->v[i] = rate.v[i] * scale;
      a->q[i] = rate.q[i] * scale;
    }
  }
  return sqrt(omega2);
}

/* Over some steps sound has grown as often by the factor of one, as steps of Runge-Kutta methods
 * and of those that are one with them do it (they are normal). Of stoermer-verlet, whose waves are
 * ellipses, it has not grown beyond them. */
static void test_sound_in_the_solver_grows_by_the_factor_of_its_stages(void) {
  for (int k = 0; k < LAWS; k++)
    for (int i = 0; i < 2; i++) {
      const struct sph_integrator *m = sph_integrators[laws[k].integrator];
      if (m->frozen || m->split) continue; /* there is no diffusion */
      struct case_file *c;
      struct sph *s = sixteen(laws[k].integrator, 0, &c);
      struct sound a;
      const int steps = 12;
      const double z = i ? 1.1 : 0.5, omega = fastest_sound(s, &a), small = 1e-7;
      put(s, &a, small);
      for (int n = 0; n < steps; n++) {
        EXPECT_OK(sph_rates(s, 0, true, true));
        EXPECT_OK(sph_step(s, z / omega));
      }
      const struct sound b = get(s, &s->f.w, 1);
      const double grown = pow(size_of(&b) / small, 1. / steps), law = sqrt(laws[k].evolved(z));
      if (laws[k].integrator == SPH_INTEGRATOR_stoermer_verlet)
        EXPECT(fabs(log(grown)) < log(2 / sqrt(4 - z * z)) / steps + 1e-6);
      else
        EXPECT_NEAR(grown, law, 1e-6);
      sph_destroy(s);
      case_destroy(c);
    }
}

/* Forces of pairs are equal and opposite, and every method adds them up with the same weights for
 * both. */
static void test_momentum_is_conserved_to_rounding(void) {
  for (int k = 0; k < SPH_INTEGRATOR_COUNT; k++) {
    char run[300];
    const struct sph_integrator *m = sph_integrators[k];
    snprintf(run, sizeof run,
             "resolution: 16, diffusion: %s, integrator: %s, alpha: 0.1, c0: 50, "
             "dt: 1e-5, precision: double",
             m->split ? "molteni" : "antuono", sph_integrator_names[k]);
    struct case_file *c = pool_case(POOL_DROP, run);
    struct sph *s = pool_create(c);
    double before[2] = {0}, after[2] = {0}, magnitude = 0, mass = 0;
    pool_shake(s, 0.2, 1, 1e3);
    for (size_t i = 0; i < s->f.n; i++) {
      before[0] += s->f.m[i] * s->f.w.u[i];
      before[1] += s->f.m[i] * s->f.w.v[i];
      magnitude += s->f.m[i] * hypot(s->f.w.u[i], s->f.w.v[i]);
      mass += s->f.m[i];
    }
    EXPECT_OK(pool_march(s, 0.002));
    for (size_t i = 0; i < s->f.n; i++) {
      after[0] += s->f.m[i] * s->f.w.u[i];
      after[1] += s->f.m[i] * s->f.w.v[i];
    }
    EXPECT_NEAR((after[0] - before[0]) / magnitude, 0, 1e-13);
    EXPECT_NEAR((after[1] - before[1] + mass * s->g * 0.002) / magnitude, 0, 1e-13);
    sph_destroy(s);
    case_destroy(c);
  }
}

/* By how much the energy of sixteen particles without losses is off in the first and in the last
 * tenth of many periods of sound, at worst, over that of its sound. */
static void energy_errors(int integrator, double dt, double worst[2]) {
  struct case_file *c;
  struct sph *s = sixteen(integrator, 0, &c);
  const int steps = 4000;
  for (size_t i = 0; i < s->f.n; i++) {
    const double k = (double)s->f.id[i];
    s->f.w.u[i] = 0.02 * sin(1.7 * k);
    s->f.w.v[i] = 0.02 * cos(2.3 * k);
  }
  sph_particles_pad(&s->f);
  const double first = sph_energy(s).total, scale = sph_energy(s).kinetic;
  worst[0] = worst[1] = 0;
  for (int n = 0; n < steps; n++) {
    EXPECT_OK(sph_rates(s, 0, true, true));
    EXPECT_OK(sph_step(s, dt));
    const double error = fabs(sph_energy(s).total - first) / scale;
    if (n < steps / 10) worst[0] = fmax(worst[0], error);
    if (n >= steps - steps / 10) worst[1] = fmax(worst[1], error);
  }
  sph_destroy(s);
  case_destroy(c);
}

/* Where every other method's energy goes one way, this one's keeps near the first. */
static void test_stoermer_verlet_energy_does_not_drift(void) {
  double verlet[2], other[2];
  energy_errors(SPH_INTEGRATOR_stoermer_verlet, 1e-3, verlet);
  energy_errors(SPH_INTEGRATOR_predictor_corrector, 1e-3, other);
  printf("     energy off by %.1e at first, %.1e at last; Heun's %.1e, %.1e\n", verlet[0],
         verlet[1], other[0], other[1]);
  EXPECT(verlet[1] < 2 * verlet[0]);
  EXPECT(other[1] > 5 * other[0]);
}

/* A drop that no wall touches slows down as exp(-Gamma t), to (Gamma dt)^3 a step, until damping
 * ends. */
static void test_damping_ends(void) {
  struct case_file *c =
      pool_case(POOL_DROP, "resolution: 10, integrator: damped-pc, damping: 5, damping_end: 0.05, "
                           "dt: 0.5e-3");
  struct sph *s = pool_create(c);
  for (size_t i = 0; i < s->f.n; i++) s->f.w.u[i] = 1;
  EXPECT_OK(pool_march(s, 0.08));
  double momentum = 0, mass = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    momentum += s->f.m[i] * s->f.w.u[i];
    mass += s->f.m[i];
  }
  EXPECT_NEAR(momentum / mass, exp(-5 * 0.05), 100 * pow(5 * 0.5e-3, 3));
  EXPECT(s->budget.damping > 0);
  sph_destroy(s);
  case_destroy(c);
}

int main(void) {
  RUN(test_sound_is_amplified_as_the_thesis_has_it);
  RUN(test_initial_damping_is_that_of_the_thesis);
  RUN(test_sound_in_the_solver_grows_by_the_factor_of_its_stages);
  RUN(test_momentum_is_conserved_to_rounding);
  RUN(test_stoermer_verlet_energy_does_not_drift);
  RUN(test_damping_ends);
  return TEST_RESULT;
}

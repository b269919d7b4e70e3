/* What treatments add to the rates: XSPH and the tensile correction. */
#include "sph/fluid/energy.h"
#include "sph/treat/treat.h"
#include "tests/sph/pool.h"
#include "tests/test.h"

/* The product of cubic splines at h = dx, whose sums over a lattice are short. */
#define DROP   "resolution: 40, precision: double, alpha: 0, diffusion: none"
#define SPLINE ", kernel: tensor, h_over_dx: 1"

static bool is_inside(const struct sph *s, size_t i) {
  const double x = s->f.w.x[i], y = s->f.w.y[i];
  return fmin(fmin(x - 1, 2 - x), fmin(y - 1, 2 - y)) > s->support + 0.1 * s->dx;
}

static struct sph *drop(struct case_file **c, const char *more) {
  char run[300];
  snprintf(run, sizeof run, DROP "%s", more);
  *c = pool_case(POOL_DROP, run);
  return pool_create(*c);
}

/* Thesis, 3.4.1: a wave of velocity moves particles 1 + xsph (S - 1) times as much, with S = 1 -
 * (2/3) sin^2(kh/2); to the rounding of single velocities near 1. The water as a whole moves with
 * its momentum, and what lifts it is booked. */
static void test_xsph_moves_a_wave_by_its_symbol(void) {
  for (int waves = 1; waves <= 20; waves += 3) {
    struct case_file *c;
    struct sph *s = drop(&c, SPLINE ", xsph: 0.5");
    const double k = 2 * M_PI * waves, half = sin(k * s->h / 2), S = 1 - 2. / 3 * half * half;
    double worst = 0, sum = 0, size = 0, power = 0;
    for (size_t i = 0; i < s->f.n; i++) {
      s->f.w.u[i] = cos(k * s->f.w.x[i]);
      s->f.w.v[i] = sin(k * s->f.w.y[i]);
    }
    sph_particles_pad(&s->f);
    EXPECT_OK(sph_rates(s, 0, true, true));
    for (size_t i = 0; i < s->f.n; i++) {
      const double m = s->f.m[i], more = s->f.k[0].x[i] - s->f.w.u[i];
      sum += m * more;
      size += m * fabs(more);
      power -= m * s->g * (s->f.k[0].y[i] - s->f.w.v[i]);
      if (!is_inside(s, i)) continue;
      worst = fmax(worst, fabs(more - 0.5 * (S - 1) * s->f.w.u[i]));
      worst = fmax(worst, fabs(s->f.k[0].y[i] - s->f.w.v[i] * (1 + 0.5 * (S - 1))));
    }
    EXPECT_NEAR(worst, 0, 1e-13);
    EXPECT_NEAR(sum / size, 0, 1e-13);
    EXPECT_NEAR(s->totals.xsph, power, 1e-12 * size * s->g);
    sph_destroy(s);
    case_destroy(c);
  }
}

/* The acceleration, m/s^2, by a pressure of `base` and 1000 Pa/m along x. */
static double acceleration(const char *more, double base) {
  struct case_file *c;
  struct sph *s = drop(&c, more);
  double a = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    s->f.w.rho[i] = s->rho0 + (base + 1e3 * s->f.w.x[i]) / (s->c0 * s->c0);
    s->f.m[i] = s->f.w.rho[i] * s->dx * s->dx;
  }
  sph_particles_pad(&s->f);
  EXPECT_OK(sph_rates(s, 0, true, true));
  for (size_t i = 0; i < s->f.n; i++)
    if (is_inside(s, i)) a = s->f.k[0].u[i];
  sph_destroy(s);
  case_destroy(c);
  return a;
}

/* Thesis, eq. (3.57). Beside a particle stand two in x with f = 1 and the weight w'(h) w(0) = 1/3,
 * and four with f = 1/4 and the weight w'(h) w(h) = 1/12 each; the square of the speed of sound
 * falls as the force does. (In one dimension there are the two alone: 1 - tensile.) */
static void test_tension_pushes_less(void) {
  const double less = 1 - 0.1 * (2. / 3 + 1. / 3 * pow(0.25, 4)), under = -1e4;
  const double less2 = 1 - 0.1 * (2. / 3 + 1. / 3 * pow(0.25, 2));
  EXPECT_NEAR(acceleration(SPLINE ", tensile: 0.1", under) / acceleration(SPLINE, under), less,
              1e-9);
  EXPECT_NEAR(acceleration(SPLINE ", tensile: 0.1, tensile_power: 2", under) /
                  acceleration(SPLINE, under),
              less2, 1e-9);
  EXPECT_NEAR(acceleration(SPLINE ", tensile: 0.1", 1e4), acceleration(SPLINE, 1e4), 0);
}

/* At h = 4/3 dx, by the Gaussian, cut at 3h: every pair of the lattice counts 1 - tensile
 * (W/W(dx))^4 in the force of a pressure that rises along x. */
static void test_tension_counts_from_the_spacing(void) {
  const double edge = exp(-9), per = 0.75 * 0.75; /* (dx/h)^2 */
  double all = 0, less = 0;
  for (int i = -4; i <= 4; i++)
    for (int j = -4; j <= 4; j++) {
      const double q2 = per * (i * i + j * j), f = (exp(-q2) - edge) / (exp(-per) - edge);
      if (q2 >= 9 || q2 == 0) continue;
      all += i * i * exp(-q2);
      less += i * i * exp(-q2) * (1 - 0.1 * pow(f, 4));
    }
  const char *const more = ", kernel: gaussian, h_over_dx: 1.3333333333333333";
  char relaxed[200];
  snprintf(relaxed, sizeof relaxed, "%s, tensile: 0.1", more);
  EXPECT_NEAR(acceleration(relaxed, -1e4) / acceleration(more, -1e4), less / all, 1e-9);
}

/* Beside walls and in motion, under tension too: to 1e-6 as without them (4e-7), which is the time
 * integration's. */
static void budget_closes(const char *eos) {
  char run[300];
  snprintf(run, sizeof run,
           "resolution: 16, diffusion: none, integrator: rk4, cfl_acoustic: 0.5, xsph: 0.5, "
           "tensile: 0.3, %s",
           eos);
  struct case_file *c = pool_case(POOL_DAM, run);
  struct sph *s = pool_create(c);
  pool_shake(s, 0.1, 0.1, 100);
  const double before = sph_energy(s).total;
  EXPECT_OK(pool_march(s, 0.05));
  const struct result_energy e = sph_energy(s);
  EXPECT_NEAR(result_energy_budget(&e) / before, 1, 1e-6);
  EXPECT(fabs(s->budget.xsph / before) > 1e-6 && fabs(s->budget.tensile / before) > 1e-6);
  sph_destroy(s);
  case_destroy(c);
}

static void test_the_budget_closes_with_corrections(void) {
  budget_closes("eos: linear");
  budget_closes("eos: tait");
  budget_closes("eos: split, momentum: reference, c0: 12");
  budget_closes("eos: dynamic, momentum: reference");
}

int main(void) {
  RUN(test_xsph_moves_a_wave_by_its_symbol);
  RUN(test_tension_pushes_less);
  RUN(test_tension_counts_from_the_spacing);
  RUN(test_the_budget_closes_with_corrections);
  return TEST_RESULT;
}

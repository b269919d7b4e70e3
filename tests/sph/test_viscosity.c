/* Viscous forces pair by pair, against their formulas. */
#include "sph/pair/viscosity.h"

#include "tests/sph/pool.h"
#include "tests/test.h"

/* Accelerations of a drop whose particles have been shaken, the same way each time. */
struct pushed {
  struct case_file *c;
  struct sph *s;
};

static struct pushed pushed_create(const char *viscosity, double alpha) {
  char run[200];
  snprintf(run, sizeof run, "resolution: 12, precision: double, viscosity: %s, alpha: %g",
           viscosity, alpha);
  struct pushed p = {.c = pool_case(POOL_DROP, run)};
  p.s = pool_create(p.c);
  for (size_t i = 0; i < p.s->f.n; i++) {
    const double k = (double)p.s->f.id[i];
    p.s->f.w.x[i] += 0.1 * p.s->dx * sin(17 * k);
    p.s->f.w.y[i] += 0.1 * p.s->dx * sin(23 * k);
    p.s->f.w.u[i] = sin(5 * k);
    p.s->f.w.v[i] = sin(11 * k);
    p.s->f.w.rho[i] = p.s->rho0 * (1 + 0.2 * sin(7 * k));
  }
  sph_particles_pad(&p.s->f);
  EXPECT_OK(sph_rates(p.s, 0, true, true));
  return p;
}

static void pushed_destroy(struct pushed *p) {
  sph_destroy(p->s);
  case_destroy(p->c);
}

/* What a pair's force is per V_j grad W and unit of alpha, m/s^2 m, after P eq. (1) and T eq.
 * (3.46); with the Gaussian of P. */
static double pair_push(const struct sph *s, bool monaghan, size_t i, size_t j, double x,
                        double y) {
  const double r2 = x * x + y * y, h2 = s->h * s->h;
  const double approach = (s->f.w.u[j] - s->f.w.u[i]) * x + (s->f.w.v[j] - s->f.w.v[i]) * y;
  const double ri = s->f.w.rho[i], rj = s->f.w.rho[j], c = s->h * s->c0 / ri;
  if (!monaghan) return c * s->rho0 * approach / r2;
  return approach < 0 ? c * 2 * ri * rj / (ri + rj) * approach / (r2 + 0.01 * h2) : 0;
}

static void expect_pushes(const char *name, bool monaghan) {
  struct pushed a = pushed_create(name, 0.1), b = pushed_create(name, 0.3);
  const struct sph *s = a.s;
  const double h2 = s->h * s->h, C = 2 / (M_PI * (1 - 10 * exp(-9)) * h2 * h2);
  double worst = 0, size = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    double ax = 0, ay = 0;
    for (size_t j = 0; j < s->f.n; j++) {
      const double x = s->f.w.x[j] - s->f.w.x[i], y = s->f.w.y[j] - s->f.w.y[i];
      if (j == i || x * x + y * y > 9 * h2) continue;
      const double push = pair_push(s, monaghan, i, j, x, y) * C * exp(-(x * x + y * y) / h2) *
                          s->f.m[j] / s->f.w.rho[j];
      ax += push * x;
      ay += push * y;
    }
    const double ex = (b.s->f.k[0].u[i] - s->f.k[0].u[i]) / 0.2 - ax;
    const double ey = (b.s->f.k[0].v[i] - s->f.k[0].v[i]) / 0.2 - ay;
    worst = fmax(worst, hypot(ex, ey));
    size = fmax(size, hypot(ax, ay));
  }
  EXPECT_NEAR(worst / size, 0,
              1e-10); /* differences of accelerations some hundred times as large */
  pushed_destroy(&a);
  pushed_destroy(&b);
}

static void test_pairs_push_as_written(void) {
  expect_pushes("artificial", false);
  expect_pushes("monaghan", true);
}

int main(void) {
  RUN(test_pairs_push_as_written);
  return TEST_RESULT;
}

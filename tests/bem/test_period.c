/* Water without sides: a harmonic function under a curved closed chain, with and without a bed that
 * is felt; systems that go round; where the surface is cut; a wave of permanent form. */
#include <stdlib.h>

#include "bem/cyclic.h"
#include "bem/flow.h"
#include "bem/integrals.h"
#include "tests/bem/run.h"

static const double L = 2.385, CURRENT = 0.37;

/* Real on the bed y = 0 but for the current, which is not periodic; poles above the surface. */
static double complex dipoles(const struct bem_period *p, double complex z) {
  double complex zeta = bem_period_map(p, z), a = bem_period_map(p, CMPLX(0.7, p->level + 0.35)),
                 b = bem_period_map(p, CMPLX(2.1, p->level + 0.4));
  return zeta / (zeta - a) - p->bed / (conj(a) * zeta - p->bed) +
         I * (b / (zeta - b) - conj(b) * zeta / (p->bed - conj(b) * zeta));
}

static double complex slope_of(const struct bem_period *p, double complex z) {
  const double h = 1e-3;
  double complex d = 0; /* of sixth order: 1e-13 */
  const double weight[] = {45. / 60, -9. / 60, 1. / 60};
  for (int i = 0; i < 3; i++)
    d += weight[i] * (dipoles(p, z + (i + 1) * h) - dipoles(p, z - (i + 1) * h)) / h;
  return d;
}

struct errors {
  double surface, inside;
};

static struct errors errors_of(size_t n, double level) {
  struct bem_flow f = {0};
  struct bem_surface *s = &f.surface;
  struct errors e = {0};
  EXPECT_OK(bem_solve_create(&(struct bem_solve_options){1e-13, n < 60 ? 1000 : 0}, &f.solve));
  EXPECT_OK(bem_surface_reserve(s, n + 1));
  EXPECT_OK(bem_flow_reserve(&f, n + 1));
  s->period = bem_period_create(L, level);
  double *x = s->state, *y = x + s->n, *phi = y + s->n, scale = 0;
  for (size_t k = 0; k <= n; k++) {
    double part = (double)k / (double)n;
    x[k] = L * (0.1 + part + 0.03 * sin(2 * M_PI * part)); /* spacing that varies */
    y[k] = level + 0.12 * cos(4 * M_PI * part);
    double complex z = CMPLX(x[k], y[k]);
    phi[k] = creal(dipoles(&s->period, z)) + CURRENT * x[k];
  }
  EXPECT_OK(bem_flow_solve(&f, s->state, 0));
  for (size_t k = 0; k <= n; k++) {
    double complex exact = slope_of(&s->period, CMPLX(x[k], y[k]));
    scale = fmax(scale, cabs(exact));
    e.surface = fmax(e.surface, cabs(f.w[k] - exact - CURRENT));
  }
  for (double at = 0.05; at < L; at += 0.3) { /* points of the bed */
    double complex z = at, value, slope;
    bem_integrals_inside(&f.panels, f.phi_round, f.psi_round, bem_period_map(&s->period, z), &value,
                         &slope);
    slope *= bem_period_slope(&s->period, z);
    e.inside = fmax(e.inside, cabs(slope - slope_of(&s->period, z)));
    e.inside = fmax(e.inside, cabs(value - dipoles(&s->period, z)));
  }
  e.surface /= scale, e.inside /= scale;
  bem_flow_destroy(&f);
  return e;
}

/* Cubic panels and a five-node stencil everywhere. */
static void test_velocity_under_a_closed_chain_is_of_fourth_order(void) {
  const double level[] = {0.3, 0.8, 40};
  for (size_t i = 0; i < sizeof level / sizeof *level; i++) {
    struct errors before = {0};
    for (size_t n = 32; n <= 256; n *= 2) {
      struct errors e = errors_of(n, level[i]);
      printf("  depth %4.1f, %3zu nodes: velocity %.2e, on the bed %.2e", level[i], n, e.surface,
             e.inside);
      if (before.surface > 0) {
        double order = log2(before.surface / e.surface);
        printf("; order %.2f", order);
        if (n > 64) EXPECT(order > 3.7);
        EXPECT(e.inside < 0.1 * e.surface);
      }
      printf("\n");
      before = e;
    }
  }
}

static void test_systems_that_go_round_are_solved(void) {
  enum { N = 7 };
  double x[2 * N], f[2 * N], d[N], b[N], scratch[N];
  for (int i = 0; i < 2 * N; i++) x[i] = cos(i * i);
  for (int i = 0; i < N; i++) b[i] = 0.4 + 0.1 * i, d[i] = 2.5 + 0.01 * i * i;
  for (int k = 0; k < 2; k++)
    for (int i = 0; i < N; i++) {
      int before = (i + N - 1) % N, after = (i + 1) % N;
      f[k * N + i] = d[i] * x[k * N + i] + b[before] * x[k * N + before] + b[i] * x[k * N + after];
    }
  EXPECT_OK(bem_cyclic_solve(N, d, b, 2, N, f, scratch));
  for (int i = 0; i < 2 * N; i++) EXPECT_NEAR(f[i], x[i], 1e-14);
}

int main(void) {
  RUN(test_velocity_under_a_closed_chain_is_of_fourth_order);
  RUN(test_systems_that_go_round_are_solved);
  return TEST_RESULT;
}

/* Water without sides: a harmonic function under a curved closed chain, with and without a bed that
 * is felt; systems that go round; where the surface is cut; a wave of permanent form. */
#include <stdlib.h>

#include "bem/kernel/integrals.h"
#include "bem/shape/cyclic.h"
#include "bem/water/flow.h"
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

static struct errors errors_of(size_t n, double level, bool smooth) {
  struct bem_flow f = {0};
  struct bem_surface *s = &f.surface;
  struct errors e = {0};
  EXPECT_OK(bem_solve_create(&(struct bem_solve_options){1e-13, n < 60 ? 1000 : 0}, &f.solve));
  EXPECT_OK(bem_surface_reserve(s, n + 1));
  EXPECT_OK(bem_flow_reserve(&f, n + 1));
  s->period = bem_period_create(L, level);
  s->smooth = smooth;
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
    bem_integrals_inside(&f.panels, f.phi_own, f.psi_own, bem_period_map(&s->period, z), &value,
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
      struct errors e = errors_of(n, level[i], false);
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

/* The trapezoidal rule and differences of twelfth order; where the dipoles are near, the rule's
 * exp(-n) is seen first. The bed is still integrated by panels. */
static void test_velocity_under_a_smooth_closed_chain_is_of_high_order(void) {
  const double level[] = {0.3, 0.8, 40};
  for (size_t i = 0; i < sizeof level / sizeof *level; i++) {
    struct errors before = {0};
    for (size_t n = 32; n <= 128; n *= 2) {
      const struct errors e = errors_of(n, level[i], true);
      const double order = log2(before.surface / e.surface);
      printf("  depth %4.1f, %3zu nodes: velocity %.2e; order %.2f\n", level[i], n, e.surface,
             order);
      if (n > 32) EXPECT(order > 6);
      if (n > 64) EXPECT(order > 8);
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

/* ---- a small wave ---- */

static const char text[] =
    "title: small wave\n"
    "fluid: {density: 1, gravity: 1}\n"
    "scales: {H: 1}\n"
    "tank: {walls: [[[0.3, 2], [0.3, 0.1], [%g, 0.1], [%g, 2]]], sides: periodic}\n"
    "water: {wave: {kind: airy, amplitude: %g, wavelength: 1, depth: 0.5}}\n"
    "time: {end: %g, every: %g, sample: 0.02}\n"
    "gauges: [{name: wire, x: 0.7}]\n"
    "probes: [{name: bed, at: [0.9, 0.1]}]\n"
    "runs: [{name: bem, solver: bem, resolution: %d}]\n";

static const double A = 5e-4, K = 2 * M_PI, DEPTH = 0.5;

struct wave {
  double phase, drift, pressure; /* error over the run, rad; relative; over that of the crest */
};

/* Phase at t = 0 of the wave of frequency omega that fits best around this mean. */
static double phase_of(const struct result_series *g, size_t from, double mean, double omega) {
  double cc = 0, ss = 0, cs = 0, c = 0, s = 0;
  for (size_t i = from; i < g->n; i++) {
    const double a = cos(omega * g->t[i]), b = sin(omega * g->t[i]), f = g->value[i] - mean;
    cc += a * a, ss += b * b, cs += a * b, c += f * a, s += f * b;
  }
  return atan2(cc * s - cs * c, ss * c - cs * s);
}

/* Ten periods; phase from the last two. */
static struct wave small_wave(int waves, int nodes) {
  const double omega = sqrt(K * tanh(K * DEPTH)), end = 20 * M_PI / omega;
  char with[sizeof text + 80];
  struct wave out = {NAN, 0, 0};
  snprintf(with, sizeof with, text, 0.3 + waves, 0.3 + waves, A, end, end, nodes);
  struct result_file *f = run_bem(with);
  if (!f) return out;
  const struct result_series *g = &f->gauges[0], *p = &f->probes[0];
  size_t from = g->n;
  while (from > 0 && g->t[from - 1] > end - 4 * M_PI / omega) from--;
  out.phase = remainder(phase_of(g, from, 0.1 + DEPTH, omega) - K * (0.7 - 0.3), 2 * M_PI);
  for (size_t i = 0; i < f->n_energy; i++) {
    double e = f->energy[i].total + f->energy[i].term[0], first = f->energy[0].total;
    out.drift = fmax(out.drift, fabs(e - first) / f->energy[0].kinetic / 2);
  }
  for (size_t i = 0; i < p->n; i++) {
    double push = A / cosh(K * DEPTH);
    double theory = DEPTH + push * cos(K * (0.9 - 0.3) - omega * p->t[i]);
    out.pressure = fmax(out.pressure, fabs(p->value[i] - theory) / push);
  }
  printf("  %3d nodes per wavelength: phase %+.2e, energy %.1e, pressure %.1e, %.0f evaluations\n",
         nodes, out.phase, out.drift, out.pressure, run_statistic(f, "evaluations"));
  result_file_destroy(f);
  return out;
}

/* Ten periods with the speed of Stokes' second approximation; what that leaves out at a wire are
 * the second harmonics, of the order ka, which is why even 16 nodes are as near (panels of fourth
 * order were off by 3e-2). */
static void expect_theory(struct wave w) {
  const double stokes = -10 * M_PI * K * K * A * A;
  EXPECT_NEAR(w.phase, stokes, 0.3 * K * A);
  EXPECT(w.pressure < K * A);
  EXPECT(w.drift < 1e-5);
}

static void test_a_small_wave_runs_round_as_theory_says(void) {
  for (int nodes = 16; nodes <= 64; nodes *= 2) expect_theory(small_wave(2, nodes));
}

/* Fewer than 26 nodes round the circle are all near the mirror image of each, which is nearly at
 * its centre: integrals that are exact there must be so all round. */
static void test_few_nodes_round_deep_water_keep_the_energy_of_a_wave(void) {
  const struct wave panels = small_wave(1, 10); /* too few for differences of high order */
  EXPECT(panels.drift < 1e-4);
  expect_theory(small_wave(1, 20));
}

int main(void) {
  RUN(test_velocity_under_a_closed_chain_is_of_fourth_order);
  RUN(test_velocity_under_a_smooth_closed_chain_is_of_high_order);
  RUN(test_systems_that_go_round_are_solved);
  RUN(test_a_small_wave_runs_round_as_theory_says);
  RUN(test_few_nodes_round_deep_water_keep_the_energy_of_a_wave);
  return TEST_RESULT;
}

/* The map of tanks of any walls, against its own integral, and a harmonic function in them. */
#include <stdlib.h>

#include "bem/kernel/integrals.h"
#include "bem/kernel/solve.h"
#include "bem/map/conformal.h"
#include "tests/test.h"

enum { MOST = 12 };

struct tank_case {
  const char *name;
  size_t n;
  double wall[MOST][2];
  double y[2]; /* of the surface at both ends, and where it meets the walls */
  double x[2];
};

static const struct tank_case tanks[] = {
    {"rectangle", 4, {{0, 2}, {0, 0}, {2.385, 0}, {2.385, 2}}, {0.8, 0.8}, {0, 2.385}},
    {"wedge", 3, {{-2, 2}, {0, 0}, {2, 2}}, {1, 1}, {-1, 1}},
    {"step", 6, {{0, 3}, {0, 0}, {1.3, 0}, {1.3, 0.45}, {3.1, 0.45}, {3.1, 2}}, {1, 1}, {0, 3.1}},
    {"beach", 4, {{0, 3}, {0, 0}, {2, 0}, {8, 2}}, {1, 1}, {0, 5}},
    {"bar",
     8,
     {{0, 2}, {0, 0}, {2, 0}, {2.5, 0.6}, {3, 0.6}, {4, 0}, {5.3, 0}, {5.3, 2}},
     {1, 1},
     {0, 5.3}},
    {"inclined",
     4,
     {{-1.5, 1.5 * 1.7320508075688772},
      {0, 0},
      {2, 2 / 1.7320508075688772},
      {0.5, 2 / 1.7320508075688772 + 1.5 * 1.7320508075688772}},
     {1.5, 1.5},
     {-1.5 / 1.7320508075688772, 2 - (1.5 - 2 / 1.7320508075688772) / 1.7320508075688772}},
};
enum { TANKS = sizeof tanks / sizeof *tanks };

/* ---- the map ---- */

static void test_sides_have_their_lengths_and_bends_are_where_they_are(void) {
  for (int i = 0; i < TANKS; i++) {
    struct bem_conformal *m = NULL;
    EXPECT_OK(bem_conformal_create(tanks[i].n, tanks[i].wall, NULL, &m));
    double worst = 0;
    for (size_t side = 1; side < m->n; side++) /* from near one end of each to near the other */
      for (double part = 0.02; part < 1; part += 0.24) {
        const double complex a = m->point[side], b = m->point[side + 1];
        struct bem_chart c, d;
        double complex zeta, slope, z = a + part * (b - a), back = b + 0.015 * (a - b);
        EXPECT_OK(bem_conformal_start(m, side, z, &c));
        EXPECT_OK(bem_conformal_start(m, side, back, &d));
        EXPECT_OK(bem_chart_walk(m, &c, back));
        EXPECT(bem_chart_find(&c, back, &zeta, &slope));
        worst = fmax(worst, cabs((zeta - d.zeta) / slope));
      }
    printf("  %-9s: %zu bends, from both ends of a side %.1e apart\n", tanks[i].name, m->n, worst);
    EXPECT(worst < 1e-13); /* some hundred steps, each with the rounding of z */
    bem_conformal_destroy(m);
  }
}

static void test_map_of_a_rectangle_is_the_squared_sine(void) {
  const double L = tanks[0].x[1];
  struct bem_conformal *m = NULL;
  struct bem_chart c;
  double worst = 0;
  EXPECT_OK(bem_conformal_create(tanks[0].n, tanks[0].wall, NULL, &m));
  EXPECT_OK(bem_conformal_start(m, 0, CMPLX(0, 0.8), &c));
  for (int i = 1; i < 100; i++) {
    const double complex z = CMPLX(L * i / 100, 0.8 + 0.3 * sin(0.17 * i));
    double complex zeta, slope;
    EXPECT_OK(bem_chart_walk(m, &c, z));
    EXPECT(bem_chart_find(&c, z, &zeta, &slope));
    worst = fmax(worst, cabs((1 - zeta) / 2 - bem_map(L, z)) / cabs(bem_map(L, z)));
    worst = fmax(worst, cabs(-slope / 2 / bem_map_slope(L, z) - 1));
  }
  printf("  worst difference %.1e\n", worst);
  EXPECT(worst < 1e-13);
  bem_conformal_destroy(m);
}

/* What is known exactly: the quarter plane's square, turned, for a wedge of 90 degrees. */
static void test_map_of_a_wedge_of_90_degrees_is_a_square(void) {
  struct bem_conformal *m = NULL;
  struct bem_chart c;
  double complex zeta, slope, z = CMPLX(0.3, 1.1), first;
  EXPECT_OK(bem_conformal_create(tanks[1].n, tanks[1].wall, NULL, &m));
  EXPECT_OK(bem_conformal_start(m, 1, CMPLX(1, 1), &c));
  EXPECT(bem_chart_find(&c, CMPLX(1, 1), &first, &slope));
  EXPECT_OK(bem_chart_walk(m, &c, z));
  EXPECT(bem_chart_find(&c, z, &zeta, &slope));
  const double complex expected = creal(first) * z * z / cpow(CMPLX(1, 1), 2);
  EXPECT_NEAR(cabs(zeta - expected), 0, 1e-14);
  EXPECT_NEAR(cabs(slope - 2 * expected / z), 0, 1e-13);
  bem_conformal_destroy(m);
}

/* ---- harmonic functions ----
 *
 * Cubic panels and a five-node stencil: fourth order, at the edges of the water too, where mirror
 * images complete the stencils. There stencils of fourth order on one side gave 5e-7 to 5e-6 with
 * 201 nodes, and third order. */

/* Poles above the surface and their mirror images: real on the walls. */
static double complex poles(const double complex at[2], double complex zeta, int slope) {
  double complex sum = 0;
  for (int i = 0; i < 2; i++) {
    const double scale = cimag(at[i]) * (i ? 0.3 : 1);
    const double complex a = zeta - at[i], b = zeta - conj(at[i]);
    sum += slope ? -scale * (1 / (a * a) + 1 / (b * b)) : scale * (1 / a + 1 / b);
  }
  return sum;
}

struct errors {
  double inner, edge; /* of the velocity, relative to its largest, inside and at the edges */
  double slide;       /* exact velocity across the walls at the edges */
};

/* A surface with waves, nodes unevenly spaced. */
static void shape(const struct tank_case *t, size_t n, double *x, double *y) {
  for (size_t k = 0; k < n; k++) {
    const double s = (double)k / (double)(n - 1), at = s + 0.03 * sin(2 * M_PI * s);
    x[k] = t->x[0] + (t->x[1] - t->x[0]) * at;
    y[k] = t->y[0] + 0.05 * sin(2 * M_PI * at) * sin(M_PI * at);
  }
}

static struct errors errors_of(const struct tank_case *t, size_t n) {
  struct bem_conformal *m = NULL;
  struct bem_panels p = {0};
  struct bem_solve *s = NULL;
  struct errors e = {0, 0, 0};
  double *x = malloc(4 * n * sizeof *x), *y = x + n, *phi = y + n, *psi = phi + n;
  double complex *w = malloc(n * sizeof *w), at[2];
  EXPECT_OK(bem_conformal_create(t->n, t->wall, NULL, &m));
  EXPECT_OK(bem_solve_create(&(struct bem_solve_options){1e-13, 1000}, &s));
  EXPECT_OK(bem_panels_reserve(&p, n));
  shape(t, n, x, y);
  const size_t side[2] = {bem_conformal_side(m, CMPLX(x[0], y[0])),
                          bem_conformal_side(m, CMPLX(x[n - 1], y[n - 1]))};
  EXPECT_OK(bem_panels_set_walls(&p, n, x, y, m, side));
  for (int i = 0; i < 2; i++) { /* above two nodes */
    const size_t k = (n - 1) * (i ? 5 : 2) / 8;
    struct bem_chart c = p.chart[k];
    double complex slope, z = CMPLX(x[k], t->y[0] + (i ? 0.4 : 0.3));
    EXPECT_OK(bem_chart_walk(m, &c, z));
    EXPECT(bem_chart_find(&c, z, &at[i], &slope));
  }
  for (size_t k = 0; k < n; k++) {
    phi[k] = creal(poles(at, p.zeta[k], 0));
    psi[k] = 0;
  }
  EXPECT_OK(bem_solve_first(s, &p, phi, psi, 0));
  bem_panels_velocity(&p, phi, psi, w);
  double scale = 0;
  for (size_t k = 0; k < n; k++) {
    const double complex exact = poles(at, p.zeta[k], 1) * p.dzeta[k];
    const int edge = k == 0 || k + 1 == n;
    double *worst = edge ? &e.edge : &e.inner;
    scale = fmax(scale, cabs(exact));
    *worst = fmax(*worst, cabs(w[k] - exact));
    if (edge) e.slide = fmax(e.slide, fabs(cimag(exact * bem_conformal_along(m, k ? m->n : 0))));
  }
  e.inner /= scale, e.edge /= scale, e.slide /= scale;
  bem_solve_destroy(s);
  bem_panels_destroy(&p);
  bem_conformal_destroy(m);
  free(x);
  free(w);
  return e;
}

static void test_velocity_of_a_harmonic_function_is_of_fourth_order(void) {
  for (int i = 0; i < TANKS; i++) {
    struct errors before = {0, 0, 0};
    for (size_t n = 51; n <= 401; n = 2 * n - 1) {
      const struct errors e = errors_of(&tanks[i], n);
      printf("  %-9s, %3zu nodes: velocity %.2e, at the edges %.2e", tanks[i].name, n, e.inner,
             e.edge);
      if (before.inner > 0) {
        const double inner = log2(before.inner / e.inner), edge = log2(before.edge / e.edge);
        printf("; orders %.2f %.2f", inner, edge);
        if (n > 200) EXPECT(inner > 3.7);
        if (n > 400) EXPECT(inner > 4 && edge > 3.3 && e.edge < 0.2 * e.inner);
      }
      printf("\n");
      EXPECT(e.slide < 1e-15);
      before = e;
    }
  }
}

int main(void) {
  RUN(test_sides_have_their_lengths_and_bends_are_where_they_are);
  RUN(test_map_of_a_rectangle_is_the_squared_sine);
  RUN(test_map_of_a_wedge_of_90_degrees_is_a_square);
  RUN(test_velocity_of_a_harmonic_function_is_of_fourth_order);
  return TEST_RESULT;
}

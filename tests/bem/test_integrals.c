/* A harmonic function in a box: Dirichlet data on a curved surface, impermeable walls and bed. */
#include <stdlib.h>

#include "bem/kernel/integrals.h"
#include "bem/kernel/solve.h"
#include "tests/test.h"

static const double L = 2.385;

/* Poles mirrored about all walls lie above the surface: beta is analytic in the water and real on
 * the walls, and no polynomial. */
static double complex dipoles(double complex z) {
  double complex zeta = bem_map(L, z), a = bem_map(L, CMPLX(0.7, 1.25)),
                 b = bem_map(L, CMPLX(2.1, 1.4));
  return 1 / (zeta - a) + 1 / (zeta - conj(a)) + 0.3 / (zeta - b) + 0.3 / (zeta - conj(b));
}

static double complex dipoles_slope(double complex z) {
  double complex zeta = bem_map(L, z), a = bem_map(L, CMPLX(0.7, 1.25)),
                 b = bem_map(L, CMPLX(2.1, 1.4));
  return -bem_map_slope(L, z) * (cpow(zeta - a, -2) + cpow(zeta - conj(a), -2) +
                                 0.3 * cpow(zeta - b, -2) + 0.3 * cpow(zeta - conj(b), -2));
}

struct errors {
  double inner, corner, probe; /* of the velocity, relative to its largest value */
};

static struct errors box_errors(size_t n, double wave, int smooth, size_t dense_up_to) {
  struct bem_panels p = {.smooth = smooth};
  struct bem_solve *s = NULL;
  struct errors e = {0};
  double *x = malloc(5 * n * sizeof *x), *y = x + n, *phi = y + n, *psi = phi + n;
  double complex *w = malloc(n * sizeof *w);
  for (size_t k = 0; k < n; k++) {
    double s01 = (double)k / (double)(n - 1);
    x[k] = L * (s01 + 0.03 * sin(2 * M_PI * s01));               /* spacing that varies */
    y[k] = 0.8 + wave * cos((smooth ? 4 * M_PI / L : 5) * x[k]); /* upright to the walls, or not */
    phi[k] = creal(dipoles(CMPLX(x[k], y[k])));
    psi[k] = 0;
  }
  EXPECT_OK(bem_solve_create(&(struct bem_solve_options){1e-13, dense_up_to}, &s));
  EXPECT_OK(bem_panels_reserve(&p, n));
  bem_panels_set(&p, n, x, y, 0, L);
  EXPECT_OK(bem_solve_first(s, &p, phi, psi, 0));
  bem_panels_velocity(&p, phi, psi, w);
  double scale = 0;
  for (size_t k = 0; k < n; k++) {
    double complex exact = dipoles_slope(CMPLX(x[k], y[k]));
    scale = fmax(scale, cabs(exact));
    double *worst = k == 0 || k + 1 == n ? &e.corner : &e.inner;
    *worst = fmax(*worst, cabs(w[k] - exact));
  }
  for (double at = 0.05; at < 0.7; at += 0.1) { /* points of the right wall */
    double complex z = CMPLX(L, at), value, slope;
    bem_integrals_inside(&p, phi, psi, bem_map(L, z), &value, &slope);
    e.probe = fmax(e.probe, cabs(slope * bem_map_slope(L, z) - dipoles_slope(z)));
    e.probe = fmax(e.probe, cabs(value - dipoles(z)));
  }
  e.inner /= scale, e.corner /= scale, e.probe /= scale;
  bem_solve_destroy(s);
  bem_panels_destroy(&p);
  free(x);
  free(w);
  return e;
}

/* Cubic panels and a five-node stencil: fourth order inside (observed 3.5 to 4.2 here). At a
 * contact point the stencils are one-sided and the order between second and third is what is left
 * (observed 2.5 to 4.5). */
static void
test_velocity_of_a_harmonic_function_is_of_fourth_order_and_better_than_second_at_corners(void) {
  for (int curved = 0; curved < 2; curved++) {
    struct errors before = {0};
    for (size_t n = 33; n <= 257; n = 2 * n - 1) {
      struct errors e = box_errors(n, curved ? 0.07 : 0, 0, curved ? 0 : 1000);
      printf("  %s, %3zu nodes: velocity %.2e, at the corners %.2e, inside %.2e",
             curved ? "curved" : "flat  ", n, e.inner, e.corner, e.probe);
      if (before.inner > 0) {
        double o[3] = {log2(before.inner / e.inner), log2(before.corner / e.corner),
                       log2(before.probe / e.probe)};
        printf("; orders %.2f %.2f %.2f", o[0], o[1], o[2]);
        if (n > 60) EXPECT(o[0] > 3.5 && o[1] > 2.4);
        EXPECT(e.probe < 0.1 * e.inner); /* an integral is smoother than a difference */
      }
      printf("\n");
      before = e;
    }
  }
}

/* The trapezoidal rule and differences of twelfth order, mirrored at the walls: errors of the
 * differences, which fall by 2^12 while the rule's fall as exp(-n): observed 8.6 and 10.8. The
 * inside is still the panels'. */
static void test_a_smooth_surface_is_of_high_order_up_to_the_walls(void) {
  struct errors before = {0};
  for (size_t n = 33; n <= 129; n = 2 * n - 1) {
    const struct errors e = box_errors(n, 0.07, 1, 1000);
    const double order = log2(before.inner / e.inner), corner = log2(before.corner / e.corner);
    printf(
        "  smooth, %3zu nodes: velocity %.2e, at the walls %.2e, inside %.2e; orders %.2f %.2f\n",
        n, e.inner, e.corner, e.probe, order, corner);
    if (n > 33) EXPECT(order > 8 && corner > 8 && e.probe < 1e-4);
    before = e;
  }
}

int main(void) {
  RUN(test_a_smooth_surface_is_of_high_order_up_to_the_walls);
  RUN(test_velocity_of_a_harmonic_function_is_of_fourth_order_and_better_than_second_at_corners);
  return TEST_RESULT;
}

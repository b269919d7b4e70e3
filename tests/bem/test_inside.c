/* What is written of points inside the water: against harmonic functions, down to its surface, and
 * against what a released column is under. */
#include "bem/water/inside.h"
#include "bem/water/lattice.h"
#include "common/base/geometry.h"
#include "common/flow/flow.h"
#include "common/flow/release.h"
#include "tests/bem/water.h"

static const char box[] = "[[0, 3], [0, 0], [2.385, 0], [2.385, 3]]", level[] = "depth: 0.8";
static const char wedge[] = "[[-3, 3], [0, 0], [3, 3]]", high[] = "depth: 1.3";
static const char text[] = "title: inside\n"
                           "fluid: {density: 1, gravity: 1}\n"
                           "scales: {H: 1}\n"
                           "tank: {walls: [%s]}\n"
                           "water: {wave: {kind: still, %s}}\n"
                           "time: {end: 1, every: 1}\n"
                           "runs: [{name: bem, solver: bem, resolution: %d}]\n";

/* Real on the walls of the box, with poles above the surface. */
static double complex in_box(double complex z, double complex *slope) {
  const double L = 2.385;
  const double complex zeta = bem_map(L, z), a = bem_map(L, CMPLX(0.7, 1.25));
  *slope = -bem_map_slope(L, z) * (cpow(zeta - a, -2) + cpow(zeta - conj(a), -2));
  return 1 / (zeta - a) + 1 / (zeta - conj(a));
}

/* The same in a right angle that stands on its tip, at x = 3. */
static double complex in_wedge(double complex z, double complex *slope) {
  const double complex q = CMPLX(0, -1) * (z - 3) * (z - 3), at = CMPLX(0.4, 1.7),
                       a = CMPLX(0, -1) * at * at;
  *slope = CMPLX(0, 2) * (z - 3) * (cpow(q - a, -2) + cpow(q - conj(a), -2));
  return 1 / (q - a) + 1 / (q - conj(a));
}

/* Waves on the surface, which end on the walls at rest. */
static double wavy(const struct bem_flow *f, double from, double to, double x) {
  return f->level + 0.05 * sin(5 * M_PI * (x - from) / (to - from));
}

typedef double complex function(double complex z, double complex *slope);

static bool begin(struct water *w, const char *walls, const char *depth, int resolution,
                  function *beta) {
  char with[1000];
  double complex slope;
  snprintf(with, sizeof with, text, walls, depth, resolution);
  if (!water_start(w, run_case(with), 0)) return false;
  const size_t n = w->f.surface.n;
  double *x = w->f.surface.state, *y = x + n, *phi = y + n;
  for (size_t k = 0; k < n; k++) {
    if (k > 0 && k + 1 < n) y[k] = wavy(&w->f, x[0], x[n - 1], x[k]);
    phi[k] = creal(beta(CMPLX(x[k], y[k]), &slope));
  }
  water_solve(w);
  return true;
}

enum { DISTANCES = 6, PLACES = 3 };
static const double distance[DISTANCES] = {0.1, 0.03, 1e-2, 1e-3, 1e-4, 1e-6};

/* Largest errors of the velocity and of phi, relative to their largest values, so far below the
 * surface: under nodes and between them, a little way from the walls. */
static void measure(struct water *w, function *beta, double worst[DISTANCES][2]) {
  const size_t n = w->f.surface.n;
  const double *state = w->f.surface.state, *x = state, *y = x + n;
  double largest[2] = {0};
  struct bem_inside inside = {0};
  EXPECT_OK(bem_inside_begin(&inside, &w->f));
  memset(worst, 0, DISTANCES * sizeof *worst);
  for (size_t k = n / 8; k < n - n / 8; k++)
    for (int i = 0; i < PLACES * DISTANCES; i++) {
      const double part = (double)(i % PLACES) / PLACES;
      const double complex a = CMPLX(x[k], y[k]), b = CMPLX(x[k + 1], y[k + 1]);
      /* the surface itself, within the fourth power of the spacing */
      const double px = creal(a + part * (b - a)), py = wavy(&w->f, x[0], x[n - 1], px);
      const double complex z = CMPLX(px, py - distance[i / PLACES]);
      double complex slope;
      struct bem_place is;
      bem_inside_start(&inside, &w->p, &w->f, k);
      EXPECT(bem_inside_at(&inside, &w->p, &w->f, state, z, &is));
      const double phi = creal(beta(z, &slope));
      largest[0] = fmax(largest[0], cabs(slope));
      largest[1] = fmax(largest[1], fabs(phi));
      double *e = worst[i / PLACES];
      e[0] = fmax(e[0], cabs(is.w - slope));
      e[1] = fmax(e[1], fabs(is.phi - phi));
    }
  for (int d = 0; d < DISTANCES; d++)
    for (int i = 0; i < 2; i++) worst[d][i] /= largest[i];
  bem_inside_destroy(&inside);
}

/* Of fourth order everywhere, at the surface as well. */
static void expect_exact(const char *walls, const char *depth, function *beta) {
  double worst[2][DISTANCES][2];
  struct water w;
  for (int i = 0; i < 2; i++) {
    if (!begin(&w, walls, depth, i ? 80 : 40, beta)) return;
    measure(&w, beta, worst[i]);
    printf("     %zu nodes, velocity, potential at", w.f.surface.n);
    for (int d = 0; d < DISTANCES; d++)
      printf(" %g: %.1e, %.1e;", distance[d], worst[i][d][0], worst[i][d][1]);
    printf("\n");
    water_end(&w);
  }
  for (int d = 0; d < DISTANCES; d++) {
    EXPECT(log2(worst[0][d][0] / worst[1][d][0]) > 3.3);
    EXPECT(worst[1][d][0] < 3 * worst[1][DISTANCES - 1][0]); /* no worse than at the surface */
    EXPECT(worst[1][d][1] < 1e-5);
  }
}

static void test_velocity_inside_is_of_fourth_order_up_to_the_surface(void) {
  expect_exact(box, level, in_box);
  expect_exact(wedge, high, in_wedge);
}

static const char column[] = WATER_COLUMN "time: {end: 1, every: 1}\n"
                                          "runs: [{name: bem, solver: bem, resolution: 30}]\n";

/* On the lattice: every cell of the column has its point, and the pressure of the series there. */
static void test_lattice_has_the_pressure_of_a_released_column(void) {
  struct water w;
  struct bem_lattice l = {0};
  double worst = 0;
  if (!water_start(&w, run_case(column), 0)) return;
  water_solve(&w);
  EXPECT_OK(bem_lattice_fill(&l, &w.p, &w.f, w.f.surface.state, 0.05));
  const double h = sqrt(l.cell);
  size_t inside = 0;
  for (double x = h / 2; x < 2; x += h)
    for (double y = h / 2; y < 1; y += h) inside++;
  EXPECT(l.n == inside);
  for (size_t k = 0; k < l.n; k++) {
    worst = fmax(worst, fabs(l.pressure[k] - release_head(l.x[k], l.y[k], 2, 1)));
    EXPECT(fabs(l.u[k]) < 1e-10 && fabs(l.v[k]) < 1e-10 && fabs(l.phi[k]) < 1e-10);
  }
  printf("     %zu points, pressure off by %.1e rho g H\n", l.n, worst);
  EXPECT(worst < 1e-5);
  bem_lattice_destroy(&l);
  water_end(&w);
}

static const char waves[] = WATER_WAVE "fluid: {density: 1, gravity: 1}\n"
                                       "time: {end: 1, every: 1}\n"
                                       "runs: [{name: bem, solver: bem, resolution: %d}]\n";

/* Round a tank, against the wave's own velocity. */
static double worst_under_wave(int resolution) {
  char with[1000];
  struct water w;
  struct bem_lattice l = {0};
  struct flow_water theory;
  double worst = 0, area = 0;
  snprintf(with, sizeof with, waves, resolution);
  if (!water_start(&w, run_case(with), 0)) return NAN;
  EXPECT_OK(flow_open(w.c, (struct flow_use){0}, &theory));
  water_solve(&w);
  EXPECT_OK(bem_lattice_fill(&l, &w.p, &w.f, w.f.surface.state, 0.1));
  for (size_t k = 0; k < l.n; k++) {
    double u[2];
    flow_velocity(&theory, l.x[k] - 1, l.y[k] - 0.7, 0, u);
    worst = fmax(worst, hypot(l.u[k] - u[0], l.v[k] - u[1]));
    area += l.cell;
  }
  EXPECT_NEAR(area, 5 * 0.9, 0.1 * 0.1);
  flow_close(&theory);
  bem_lattice_destroy(&l);
  water_end(&w);
  return worst;
}

static void test_lattice_has_the_velocity_of_a_steady_wave(void) {
  const double coarse = worst_under_wave(20), fine = worst_under_wave(40);
  printf("     velocity off by %.1e, %.1e sqrt(gH)\n", coarse, fine);
  EXPECT(fine < 1e-6 && log2(coarse / fine) > 3.3);
}

static const char alcove[] = "title: alcove\n"
                             "fluid: {density: 1, gravity: 1}\n"
                             "scales: {H: 1}\n"
                             "tank: {walls: [[%s]]}\n"
                             "water: {wave: {kind: still, depth: 1.5}}\n"
                             "time: {end: 1, every: 1}\n"
                             "runs: [{name: bem, solver: bem, resolution: 10}]\n";

/* Under an overhang there is no surface near, and the way from it is round a corner. */
static void expect_lattice_under_overhang(const char *walls, size_t expected) {
  char with[1000];
  struct water w;
  struct bem_lattice l = {0};
  double worst = 0;
  snprintf(with, sizeof with, alcove, walls);
  if (!water_start(&w, run_case(with), 2000)) return;
  water_solve(&w);
  EXPECT_OK(bem_lattice_fill(&l, &w.p, &w.f, w.f.surface.state, 0.1));
  for (size_t k = 0; k < l.n; k++) worst = fmax(worst, fabs(l.pressure[k] - (1.5 - l.y[k])));
  printf("     %zu points, %zu missing, pressure off by %.1e\n", l.n, l.missing, worst);
  EXPECT(l.n == expected && l.missing == 0 && worst < 1e-10);
  bem_lattice_destroy(&l);
  water_end(&w);
}

static void test_lattice_fills_alcoves(void) {
  const char *const left = "[1.5, 3], [1.5, 1], [0, 1], [0, 0], [5, 0], [5, 3]",
                    *const right = "[0, 3], [0, 0], [5, 0], [5, 1], [3.5, 1], [3.5, 3]",
                    *const twice =
                        "[2, 3], [2, 0.8], [1, 0.8], [1, 1.2], [0, 1.2], [0, 0], [5, 0], "
                        "[5, 3]";
  expect_lattice_under_overhang(left, 15 * 10 + 35 * 15);
  expect_lattice_under_overhang(right, 15 * 10 + 35 * 15);
  expect_lattice_under_overhang(twice, 10 * 12 + 10 * 8 + 30 * 15);
}

/* A breaker, round and round: whichever of its nodes is the first, even one under its jet. */
static size_t fill_breaker(double part, double *area, double *volume) {
  char with[1000];
  struct water w;
  struct bem_lattice l = {0};
  snprintf(with, sizeof with, waves, 40);
  if (!water_start(&w, run_case(with), 2000)) return 0;
  const size_t n = w.f.surface.n;
  double *x = w.f.surface.state, *y = x + n, *phi = y + n;
  for (size_t k = 0; k < n; k++) {
    const double t = (double)k / (double)(n - 1) + part, a = sin(2 * M_PI * t);
    x[k] = 5 * t + a, y[k] = 0.9 + 0.3 * a, phi[k] = 0.1 * cos(2 * M_PI * t);
  }
  water_solve(&w);
  EXPECT_OK(bem_lattice_fill(&l, &w.p, &w.f, x, 0.05));
  const size_t points = l.n;
  *area = (double)l.n * l.cell;
  *volume = bem_surface_totals(&w.f.surface, w.f.psi).volume;
  bem_lattice_destroy(&l);
  water_end(&w);
  return points;
}

static void test_lattice_does_not_depend_on_which_node_is_the_first(void) {
  static const double part[] = {0, 0.25, 0.5, 1.5, -2.5}; /* half of it is under the jet */
  size_t points[5];
  for (int i = 0; i < 5; i++) {
    double area, volume;
    points[i] = fill_breaker(part[i], &area, &volume);
    printf("     from %g: %zu points, %.4f H^2 of %.4f\n", part[i], points[i], area, volume);
    EXPECT(points[i] == points[0]);
    EXPECT_NEAR(area, volume, 0.05 * 0.05 * 5);
  }
}

/* A bend of the walls has no velocity, not one that is not a number. */
static void test_node_on_a_corner_is_refused(void) {
  struct water w;
  struct bem_inside inside = {0};
  char with[1000];
  snprintf(with, sizeof with, text, box, level, 20);
  if (!water_start(&w, run_case(with), 2000)) return;
  const size_t n = w.f.surface.n;
  double *x = w.f.surface.state, *y = x + n;
  for (size_t k = 0; k < n; k++) y[k] = 0.8 * (1 - x[k] / x[n - 1]);
  EXPECT_OK(bem_flow_solve(&w.f, x, 1));
  EXPECT(bem_inside_begin(&inside, &w.f) == ERR_SOLVER);
  EXPECT(strstr(status_message(), "on a bend of the walls, x = 2.385 H, y = 0 H"));
  bem_inside_destroy(&inside);
  water_end(&w);
}

/* What is estimated of a run, s. */
static double estimated(const char *more) {
  char with[1000];
  struct solver_estimate e = {0};
  snprintf(with, sizeof with, "%.*s%s}]\n", (int)(strrchr(column, '}') - column), column, more);
  struct case_file *c = run_case(with);
  EXPECT(c);
  if (c) bem_solver.estimate(c, &c->runs[0], &e);
  case_destroy(c);
  return e.seconds;
}

/* That costs as its points do, and more than the run itself if there are enough. */
static void test_lattice_is_part_of_the_estimate(void) {
  const double plain = estimated(""), wide = estimated(", velocity_lattice: 0.1") - plain,
               fine = estimated(", velocity_lattice: 0.01") - plain;
  printf("     %.2g s, with lattices %.2g and %.2g s more\n", plain, wide, fine);
  EXPECT_NEAR(fine, 100 * wide, 1e-9 * fine);
  EXPECT(fine > plain);
}

int main(void) {
  RUN(test_velocity_inside_is_of_fourth_order_up_to_the_surface);
  RUN(test_lattice_has_the_velocity_of_a_steady_wave);
  RUN(test_lattice_has_the_pressure_of_a_released_column);
  RUN(test_lattice_fills_alcoves);
  RUN(test_lattice_does_not_depend_on_which_node_is_the_first);
  RUN(test_node_on_a_corner_is_refused);
  RUN(test_lattice_is_part_of_the_estimate);
  return TEST_RESULT;
}

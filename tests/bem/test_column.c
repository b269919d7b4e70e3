/* The released column, L/H = 2, at t = 0+: p/(rho g) = H - y - sum a_n cos(k_n y) cosh(k_n
 * x)/cosh(k_n L), k_n = (2n+1) pi/(2H), a_n = 8H/((2n+1)^2 pi^2). */
#include "bem/kernel/integrals.h"
#include "bem/shape/surface.h"
#include "tests/bem/water.h"

static const char text[] = WATER_COLUMN "time: {end: 1, every: 1}\n"
                                        "runs: [{name: bem, solver: bem, resolution: %d}]\n";

static double exact_pressure(double x, double y) {
  double p = 1 - y;
  for (int n = 0; n < 200; n++) {
    double k = (2 * n + 1) * M_PI / 2, a = 2 / (k * k);
    p -= a * cos(k * y) * (exp(k * (x - 2)) + exp(-k * (x + 2))) / (1 + exp(-4 * k));
  }
  return p;
}

struct column {
  double pressure, acceleration, growth,
      worst; /* worst: relative error of the pressure on the bed */
};

static struct column release(int resolution) {
  char with[sizeof text + 20];
  struct column out = {0};
  struct water w;
  snprintf(with, sizeof with, text, resolution);
  if (!water_start(&w, run_case(with), 0)) return out;
  water_solve(&w);
  double *state = w.f.surface.state;
  const size_t n = w.f.surface.n;
  EXPECT_OK(bem_pressure_at(&w.p, &w.f, state, 0, 0, &out.pressure));
  for (double x = 0; x < 1.9; x += 0.1) {
    double is = NAN;
    EXPECT_OK(bem_pressure_at(&w.p, &w.f, state, x, 0, &is));
    out.worst = fmax(out.worst, fabs(is / exact_pressure(x, 0) - 1));
  }
  /* phi = t phi_t at first: accelerations are the velocities of phi_t, kinetic energy t^2 times its
   * own */
  bem_panels_velocity(&w.f.panels, w.p.phi_t, w.p.psi_t, w.f.w);
  out.acceleration = -cimag(w.f.w[0]);
  for (size_t k = 0; k < n; k++) state[2 * n + k] = w.p.phi_t[k];
  out.growth = bem_surface_totals(&w.f.surface, w.p.psi_t).kinetic;
  printf("  %2d nodes per H (%zu): p(0,0) %.6f, corner acceleration %.6f, kinetic energy %.6f t^2, "
         "bed %.1e\n",
         resolution, n, out.pressure, out.acceleration, out.growth, out.worst);
  water_end(&w);
  return out;
}

/* The velocity is logarithmically infinite at the toe, which limits the order but not by much: the
 * tolerances are a few times what 20 nodes per H give, all far below the half per cent in use. */
static void test_released_column_starts_as_the_series_says(void) {
  struct column coarse = release(20), fine = release(40);
  EXPECT_NEAR(coarse.pressure, 0.930060, 2e-6);
  EXPECT_NEAR(coarse.acceleration, -0.109770, 4e-6);
  EXPECT_NEAR(coarse.growth, 0.270415, 1e-5);
  EXPECT(coarse.worst < 3e-6);
  EXPECT(fabs(fine.growth - 0.270415) < fabs(coarse.growth - 0.270415) + 1e-6);
  EXPECT(fine.worst < coarse.worst);
}

/* The map of walls cannot be followed so far up them, where it is no finite number. */
static void test_pressure_that_cannot_be_found_is_left_as_it_was(void) {
  const double wall[4][2] = {{0, 2}, {0, 0}, {2, 0}, {2, 2}};
  struct bem_conformal *m = NULL;
  struct bem_flow f = {0};
  struct bem_pressure p = {0};
  double is = NAN;
  EXPECT_OK(bem_conformal_create(4, wall, NULL, &m));
  f.surface.walls = m;
  EXPECT(bem_pressure_at(&p, &f, NULL, 0, 1e100, &is) == ERR_SOLVER);
  EXPECT(isnan(is));
  bem_conformal_destroy(m);
}

int main(void) {
  RUN(test_released_column_starts_as_the_series_says);
  RUN(test_pressure_that_cannot_be_found_is_left_as_it_was);
  return TEST_RESULT;
}

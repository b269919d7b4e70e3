/* Sound with diffusion: the closed forms of the paper, their check values, and the eigenvalues of
 * the equations that they solve. */
#include <complex.h>

#include "tests/theory/evaluate.h"
#include "theory/linear.h"

static void test_figure_1_of_the_paper(void) {
  struct theory_result r = THEORY("dispersion", "to", "4", "points", "5");
  EXPECT_NEAR(value_of(&r, 0, "mu_star"), 2.5251334289, 1e-9);
  EXPECT_NEAR(value_of(&r, 0, "b_star"), -1.0126256671, 1e-9);
  EXPECT_NEAR(cell_of(&r, 0, 1, "a"), 0.9981983771, 1e-9);
  EXPECT_NEAR(cell_of(&r, 0, 1, "b"), -0.065, 1e-9);
  EXPECT_NEAR(cell_of(&r, 0, 2, "a"), 0.8688929738, 1e-9);
  EXPECT_NEAR(cell_of(&r, 0, 2, "b"), -0.505, 1e-9);
  EXPECT(cell_of(&r, 0, 3, "a") == 0);
  EXPECT_NEAR(cell_of(&r, 0, 3, "b"), -0.3450370375, 1e-9);
  theory_result_destroy(&r);
  r = THEORY("dispersion", "points", "2", "alpha", "0.01");
  EXPECT_NEAR(cell_of(&r, 0, 1, "b"), -0.1313719670, 1e-9);
  theory_result_destroy(&r);
}

static void test_damping_falls_and_rises(void) {
  struct theory_result r = THEORY("dispersion", "points", "300");
  double end = value_of(&r, 0, "mu_star");
  for (size_t i = 0; i + 1 < r.curve[0].n; i++) {
    double rise = cell_of(&r, 0, i + 1, "b") - cell_of(&r, 0, i, "b");
    if (cell_of(&r, 0, i + 1, "mu") < end) EXPECT(rise < 0);
    if (cell_of(&r, 0, i, "mu") > end) EXPECT(rise > 0);
    if (cell_of(&r, 0, i, "mu") > end) EXPECT(cell_of(&r, 0, i, "a") == 0);
  }
  theory_result_destroy(&r);
}

/* d/dt of (rho/rho0, u/c0) in h/c0: [-delta B mu^4, -i mu; -i mu, -(alpha/2) mu^2]; a wave goes
 * like exp(-i mu (a + i b) t). */
static void test_waves_are_eigenvalues(void) {
  struct theory_result r =
      THEORY("dispersion", "alpha", "0, 0.01, 1.3", "delta", "0.2, 1", "points", "60");
  EXPECT(r.n == 6);
  for (size_t c = 0; c < r.n; c++)
    for (size_t i = 1; i < r.curve[c].n; i++) {
      static const double alpha[] = {0, 0.01, 1.3}, delta[] = {0.2, 1};
      double mu = cell_of(&r, c, i, "mu"), m2 = mu * mu;
      struct theory_matrix m = {
          2, {{-delta[c % 2] * m2 * m2 / 8, -I * mu}, {-I * mu, -alpha[c / 2] / 2 * m2}}};
      double complex lambda[THEORY_LARGEST];
      EXPECT_OK(theory_eigenvalues(&m, lambda));
      double slow = fmax(creal(lambda[0]), creal(lambda[1]));
      EXPECT_NEAR(mu * cell_of(&r, c, i, "b"), slow, 1e-7 * fmax(1, m2 * m2)); /* where both meet */
      EXPECT_NEAR(mu * cell_of(&r, c, i, "a"), fabs(cimag(lambda[0])), 1e-7 * fmax(1, m2 * m2));
      double product = creal(lambda[0] * lambda[1]), sum = creal(lambda[0] + lambda[1]);
      double f = m2 * (alpha[c / 2] * delta[c % 2] * m2 * m2 / 16 + 1);
      EXPECT_NEAR(product / f, 1, 1e-10);
      EXPECT_NEAR(mu * (cell_of(&r, c, i, "b") + cell_of(&r, c, i, "b_minus")), sum,
                  1e-10 * fmax(1, m2 * m2));
    }
  theory_result_destroy(&r);
}

static void test_regime_changes_where_viscosity_and_diffusion_say(void) {
  struct theory_result r = THEORY("dispersion", "alpha", "0", "delta", "0.2");
  EXPECT_NEAR(value_of(&r, 0, "mu_star"), 4.309, 5e-4); /* beyond the shortest wave, 4.189 */
  theory_result_destroy(&r);
  r = THEORY("dispersion", "alpha", "2", "delta", "0");
  EXPECT_NEAR(value_of(&r, 0, "mu_star"), 2, 1e-12);
  theory_result_destroy(&r);
  r = THEORY("dispersion", "alpha", "0", "delta", "0");
  EXPECT(isnan(value_of(&r, 0, "mu_star")));
  theory_result_destroy(&r);
}

static void test_bounds_of_diffusion(void) {
  struct theory_result r = THEORY("diffusion", "to", "2.864788975654116", "points", "2");
  EXPECT_NEAR(value_of(&r, 0, "delta_most"), 0.21770, 5e-6);
  EXPECT_NEAR(value_of(&r, 0, "alpha_most"), 0.95493, 5e-6);
  EXPECT_NEAR(value_of(&r, 0, "alpha_meet"), 2.86479, 5e-6);
  EXPECT_NEAR(cell_of(&r, 0, 0, "most"), value_of(&r, 0, "delta_most"), 1e-15);
  EXPECT_NEAR(cell_of(&r, 0, 1, "least"), cell_of(&r, 0, 1, "most"), 1e-12);
  theory_result_destroy(&r);
}

/* The lower bound of (22) is highest at mu = 6/alpha, where it is that of (23). On the bounds F =
 * 0: dispersion's change of regime is there. */
static void test_bounds_at_a_wavenumber(void) {
  struct theory_result r = THEORY("regime", "alpha", "2", "from", "2", "to", "4", "points", "201");
  for (size_t i = 0; i < r.curve[0].n; i++)
    EXPECT(!(cell_of(&r, 0, i, "least") > cell_of(&r, 0, 100, "least")));
  EXPECT_NEAR(cell_of(&r, 0, 100, "least"), pow(2. / 6, 3) * 8, 1e-12);
  char most[32];
  snprintf(most, sizeof most, "%.17g", cell_of(&r, 0, 150, "most"));
  struct theory_result d = THEORY("dispersion", "alpha", "2", "delta", most);
  EXPECT_NEAR(value_of(&d, 0, "mu_star"), 3.5, 1e-10);
  theory_result_destroy(&d);
  theory_result_destroy(&r);
}

static void test_bounds_of_the_time_step(void) {
  struct theory_result r =
      THEORY("timestep", "alpha", "0.01", "from", "0.2", "to", "1", "points", "2", "load", "0.01");
  EXPECT_NEAR(cell_of(&r, 0, 0, "diffusion"), 2.2, 1e-12); /* those of (27) and (29) coincide */
  EXPECT_NEAR(cell_of(&r, 0, 0, "sound"), 2.2, 1e-12);
  EXPECT_NEAR(cell_of(&r, 0, 0, "viscosity"), 100, 1e-10);
  EXPECT_NEAR(cell_of(&r, 0, 0, "acceleration"), 2.5, 1e-12);
  EXPECT_NEAR(cell_of(&r, 0, 1, "least"), 0.44, 1e-12);
  EXPECT_NEAR(value_of(&r, 0, "delta_meet"), 0.2, 1e-12);
  theory_result_destroy(&r);
}

int main(void) {
  RUN(test_figure_1_of_the_paper);
  RUN(test_damping_falls_and_rises);
  RUN(test_waves_are_eigenvalues);
  RUN(test_regime_changes_where_viscosity_and_diffusion_say);
  RUN(test_bounds_of_diffusion);
  RUN(test_bounds_at_a_wavenumber);
  RUN(test_bounds_of_the_time_step);
  return TEST_RESULT;
}

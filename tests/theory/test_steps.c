/* Steps of integrators: closed forms of the thesis' section 2.6.4 and of its treatments, and
 * schemes that are carried out. */
#include <complex.h>

#include "tests/theory/evaluate.h"
#include "theory/spline.h"

/* Squares of |lambda| (2.248)-(2.261); rounding of eigenvalues of matrices with entries of order
 * z^2.
 */
static void expect_law(const char *integrator, const char *density, double (*law)(double z),
                       double most) {
  struct theory_result r = THEORY("amplification", "integrator", integrator, "density", density,
                                  "points", "40", "to", "2.7");
  for (size_t i = 0; i < r.curve[0].n; i++) {
    double z = cell_of(&r, 0, i, "z"), lambda = cell_of(&r, 0, i, "lambda");
    if (most > 0 && z >= most) continue;
    EXPECT_NEAR(lambda * lambda, law(z), 1e-13 * fmax(1, pow(z, 8)));
  }
  EXPECT_NEAR(value_of(&r, 0, "z_most"), most, 1e-7); /* Verlet's: the root of rounding */
  theory_result_destroy(&r);
}

static double euler(double z) {
  return 1 + z * z;
}
static double heun(double z) {
  return 1 + pow(z, 4) / 4;
}
static double verlet(double z) {
  (void)z;
  return 1;
}
static double rk3(double z) {
  return pow(1 - z * z / 2, 2) + pow(z - z * z * z / 6, 2);
}
static double rk4(double z) {
  return 1 - pow(z, 6) / 72 + pow(z, 8) / 576;
}

static void test_amplification_and_courant_limits(void) {
  expect_law("euler", "direct", euler, 0);
  expect_law("predictor-corrector", "direct", heun, 0);
  expect_law("modified-pc", "direct", verlet, 2);
  expect_law("tvd-rk3", "direct", rk3, sqrt(3));
  expect_law("rk4", "direct", rk4, 2 * sqrt(2));
  expect_law("predictor-corrector", "advanced", heun, 0);
  expect_law("modified-pc", "advanced", heun, 0); /* (2.267) */
  expect_law("stoermer-verlet", "advanced", verlet, 2);
  expect_law("rk4", "advanced", rk4, 2 * sqrt(2));
}

static void test_decaying_modes_grow_in_any_step(void) {
  struct theory_result r =
      THEORY("amplification", "mode", "decaying", "density", "direct, advanced", "points", "20",
             "integrator",
             "euler, predictor-corrector, modified-pc, damped-pc, stoermer-verlet, "
             "tvd-rk3, rk4");
  EXPECT(r.n == 14);
  for (size_t c = 0; c < r.n; c++) {
    EXPECT(value_of(&r, c, "z_most") == 0);
    for (size_t i = 1; i < 20; i++) EXPECT(cell_of(&r, c, i, "lambda") > 1);
  }
  theory_result_destroy(&r);
}

/* Figures 3-1 and 3-2. */
static void test_initial_damping(void) {
  static const char *const at[] = {"0.2", "0.5", "0.7", "1"};
  static const double lambda[3][4] = {{1.000200, 1.007782, 1.029575, 1.118034},
                                      {.995211, 1.002756, 1.024441, 1.112461},
                                      {.975500, .982900, 1.004167, 1.090492}};
  static const double limit[] = {0, 0.447772, 0.672881};
  static const char *const decaying_at[] = {"0.01", "0.1", "0.5", "1"};
  static const double decaying[3][4] = {{1.01005, 1.10500, 1.62500, 2.50000},
                                        {1.006199, 1.099627, 1.616940, 2.487575},
                                        {1.001928, 1.081051, 1.585975, 2.439329}};
  for (int k = 0; k < 4; k++) {
    struct theory_result r = THEORY("damping", "to", at[k], "points", "2");
    struct theory_result d =
        THEORY("damping", "to", decaying_at[k], "points", "2", "mode", "decaying");
    for (size_t c = 0; c < 3; c++) {
      EXPECT_NEAR(cell_of(&r, c, 1, "lambda"), lambda[c][k], 5e-7);
      if (c) EXPECT_NEAR(value_of(&r, c, "courant_most"), limit[c], 1e-6); /* found by halving */
      EXPECT_NEAR(cell_of(&d, c, 1, "lambda"), decaying[c][k], 5e-6);
    }
    EXPECT(value_of(&r, 0, "courant_most") == 0);
    for (size_t c = 0; c < 3; c++) EXPECT(value_of(&d, c, "courant_most") == 0);
    theory_result_destroy(&r);
    theory_result_destroy(&d);
  }
}

/* The damped step itself, of y'' = -s^2 y in units of the step: bounded below its limit, and
 * growing above (0.447772 and 0.672881). */
static double damped_after(double zeta, double s, int steps) {
  double y = 1, v = 0;
  for (int i = 0; i < steps; i++) {
    double y_p = y + v / 2, v_p = (v - s * s * y / 2) / zeta;
    y += v_p;
    v = 2 / zeta * (v - s * s * y_p / 2) - v;
  }
  return hypot(y, v / s);
}

static void test_damped_steps_do_what_their_eigenvalues_say(void) {
  struct theory_result r = THEORY("damping", "to", "0.46", "points", "24", "steps", "20000");
  for (size_t i = 0; i < 24; i++) {
    double s = cell_of(&r, 1, i, "courant"), after = damped_after(1.005, s, 20000);
    EXPECT_NEAR(cell_of(&r, 1, i, "lambda"), cell_of(&r, 1, i, "closed"), 1e-8); /* they meet */
    if (s > 0) EXPECT_NEAR(cell_of(&r, 1, i, "after") / fmax(after, 1e-300), 1, 1e-9);
  }
  EXPECT(cell_of(&r, 1, 23, "after") > 1e3);
  theory_result_destroy(&r);
  r = THEORY("damping", "density", "advanced", "mode", "oscillating, decaying", "points", "21");
  for (size_t c = 0; c < r.n; c++)
    for (size_t i = 0; i < 21; i++)
      EXPECT_NEAR(cell_of(&r, c, i, "lambda"), cell_of(&r, c, i, "closed"), 1e-8);
  theory_result_destroy(&r);
  EXPECT(damped_after(1.005, 0.4478, 20000) < 3);
  EXPECT(damped_after(1.005, 0.460, 20000) > 1e3);
  EXPECT(damped_after(1.025, 0.672, 20000) < 3);
  EXPECT(damped_after(1.025, 0.690, 20000) > 1e3);
}

/* A_av: without viscosity 1.0e-3 a step at mu_c = 0.3; alpha = 0.01 and 0.05 keep steps stable up
 * to 0.3 and 0.5; to first order in alpha the limit is mu_c^3 = 27 alpha/8. */
static void test_viscosity_stabilises_the_midpoint_step(void) {
  struct theory_result r = THEORY("viscosity", "alpha", "0, 0.01, 0.05, 1e-5", "points", "9");
  EXPECT_NEAR(value_of(&r, 0, "growth_most"), sqrt(1 + pow(0.3, 4) / 4) - 1, 1e-9);
  EXPECT_NEAR(value_of(&r, 0, "growth_most"), 1.0e-3, 5e-5);
  EXPECT(value_of(&r, 0, "courant_most") == 0);
  EXPECT_NEAR(value_of(&r, 1, "courant_most"), 0.32811, 1e-4);
  EXPECT_NEAR(value_of(&r, 2, "courant_most"), 0.57676, 1e-4);
  EXPECT_NEAR(pow(value_of(&r, 3, "courant_most"), 3) / (27e-5 / 8), 1, 5e-3);
  theory_result_destroy(&r);
  r = THEORY("viscosity", "alpha", "100"); /* 1 + g + g^2/2 = 1 at kh = pi, g = -2 alpha mu_c */
  EXPECT_NEAR(value_of(&r, 0, "courant_most"), 0.01, 1e-9);
  theory_result_destroy(&r);
  r = THEORY("viscosity", "alpha", "0.05", "courant", "0.4", "pairs", "both", "points", "7");
  for (size_t i = 0; i < 7; i++) { /* the closed form */
    double kh = cell_of(&r, 0, i, "kh"), s = 0.4 * sin(kh);
    double g = -2 * 0.05 * 0.4 * pow(sin(kh / 2), 2);
    double complex root = csqrt(-16 * s * s + 4 * g * g - 16 * s * s * g - 4 * s * s * g * g +
                                4 * g * g * g + g * g * g * g);
    double middle = 1 - s * s / 2 + g / 2 + g * g / 4;
    double radius = fmax(cabs(middle + root / 4), cabs(middle - root / 4));
    EXPECT_NEAR(cell_of(&r, 0, i, "growth"), radius - 1, 1e-8); /* both meet at kh = 0, pi */
  }
  theory_result_destroy(&r);
}

/* T's (3.35) and its neighbours: closed forms of what particles do. XSPH and the tensile correction
 * are factors of rates, of which there are none at k = 0 and kh = pi; that of the correction is
 * under tension, which takes 1e-12/F^2 of it, F = sin kh. */
static void test_treatments(void) {
  struct theory_result r = THEORY("treatments", "strength", "0.1", "points", "33");
  for (size_t i = 0; i < 33; i++) {
    double k = cell_of(&r, 0, i, "kh"), s = pow(sin(k / 2), 2), sh = pow(sinh(k / 2), 2);
    if (i > 0 && i < 32) {
      EXPECT_NEAR(cell_of(&r, 0, i, "oscillating"), sqrt(1 - 0.1 * 2 / 3 * s), 1e-12);
      EXPECT_NEAR(cell_of(&r, 0, i, "decaying"), sqrt(1 + 0.1 * 2 / 3 * sh), 1e-12);
      EXPECT_NEAR(cell_of(&r, 1, i, "oscillating"), 0.9486832980505138, 1e-9);
    }
    EXPECT_NEAR(cell_of(&r, 2, i, "oscillating"), 1 - 2. / 3 * s, 1e-14);
    EXPECT_NEAR(cell_of(&r, 2, i, "decaying"), 1 + 2. / 3 * sh, 1e-14);
    EXPECT_NEAR(cell_of(&r, 3, i, "oscillating"), (1 + 2 * cos(k)) / 3, 1e-14);
    EXPECT_NEAR(cell_of(&r, 3, i, "decaying"), 1 + 4. / 3 * sh, 1e-14);
  }
  for (size_t c = 0; c < 4; c++) { /* the coefficient of f'', from the symbol at a long wave */
    const double k = cell_of(&r, c, 1, "kh");
    const double at_0 = c == 1 ? 0.9486832980505138 : 1;
    const double lost = at_0 - cell_of(&r, c, 1, "oscillating");
    EXPECT_NEAR(lost / (k * k), value_of(&r, c, "second"), 1e-3);
  }
  theory_result_destroy(&r);
  r = THEORY("treatments", "treatment", "xsph", "strength", "1.5, 1.51");
  EXPECT_NEAR(value_of(&r, 0, "growth_most"), 0, 1e-7); /* neutral up to 3/2 */
  double most = 0; /* (3.35): sin^2 kh (strength (2/3) sin^2(kh/2) - 1), whatever is drawn */
  for (int i = 0; i < 100000; i++) {
    const double k = M_PI * i / 100000;
    most = fmax(most, pow(sin(k), 2) * (1.51 * 2 / 3 * pow(sin(k / 2), 2) - 1));
  }
  EXPECT_NEAR(value_of(&r, 1, "growth_most") / sqrt(most), 1, 1e-3);
  struct theory_result few = THEORY("treatments", "treatment", "xsph, tensile", "strength", "0.9",
                                    "points", "2, 50", "to", "1, 20");
  EXPECT(few.n == 8);
  for (size_t c = 0; c < 8; c++)
    EXPECT(value_of(&few, c, "growth_most") == value_of(&few, c / 4 * 4, "growth_most"));
  theory_result_destroy(&few);
  few = THEORY("treatments", "treatment", "tensile", "strength", "0", "points", "2");
  EXPECT_NEAR(value_of(&few, 0, "growth_most") / sqrt(8e-12), 1, 1e-3); /* of the tension alone */
  theory_result_destroy(&few);
  theory_result_destroy(&r);
  r = THEORY("treatments", "treatment", "xsph", "strength", "0.5, 3", "density", "advanced");
  for (size_t c = 0; c < r.n; c++)
    for (size_t i = 1; i < 399; i++) {
      EXPECT_NEAR(cell_of(&r, c, i, "oscillating"), 1, 1e-12);
      EXPECT_NEAR(cell_of(&r, c, i, "decaying"), 1, 1e-12);
    }
  theory_result_destroy(&r);
}

/* Table 3.1 on a ring of 64 particles with dx = h, and on a line for decaying modes. */
static void test_formulations(void) {
  struct theory_result r = THEORY("formulations", "points", "33"); /* kh = pi j/32 */
  for (size_t j = 0; j < 33; j++) {
    double kh = cell_of(&r, 0, j, "kh"), sum = 0;
    for (int b = 0; b < 64; b++) { /* the derivative of sin(kx) at x = 0 */
      int near = b > 32 ? b - 64 : b;
      sum += theory_spline_slope(-near) * sin(kh * b);
    }
    EXPECT_NEAR(cell_of(&r, 0, j, "symbol_oscillating"), sum, 1e-12);
    EXPECT_NEAR(cell_of(&r, 0, j, "symbol_oscillating"), sin(kh), 1e-12);
    EXPECT_NEAR(cell_of(&r, 0, j, "symbol_decaying"), sinh(kh), 1e-12 * cosh(kh));
    EXPECT_NEAR(cell_of(&r, 0, j, "direct"), fabs(sin(kh)), 1e-7); /* eigenvalues meet at 0 */
    EXPECT_NEAR(cell_of(&r, 0, j, "advanced"), fabs(sin(kh)), 1e-12);
    EXPECT_NEAR(cell_of(&r, 0, j, "direct_growth") / fmax(1, sinh(kh)),
                cell_of(&r, 0, j, "advanced_growth") / fmax(1, sinh(kh)), 1e-7);
    EXPECT_NEAR(cell_of(&r, 0, j, "advanced_still"), 0, 1e-12 * cosh(kh));
    EXPECT_NEAR(cell_of(&r, 0, j, "advanced_growth"), sinh(kh), 1e-12 * cosh(kh));
  }
  EXPECT(value_of(&r, 0, "ring_off") < 1e-12);
  EXPECT(value_of(&r, 0, "line_off") < 1e-12);
  theory_result_destroy(&r);
}

int main(void) {
  RUN(test_amplification_and_courant_limits);
  RUN(test_decaying_modes_grow_in_any_step);
  RUN(test_initial_damping);
  RUN(test_damped_steps_do_what_their_eigenvalues_say);
  RUN(test_viscosity_stabilises_the_midpoint_step);
  RUN(test_treatments);
  RUN(test_formulations);
  return TEST_RESULT;
}

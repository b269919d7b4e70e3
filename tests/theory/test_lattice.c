/* Kernels on a square lattice: the numbers of the thesis' and the paper's operators. */
#include "tests/theory/evaluate.h"

/* Symbols of the paper's diffusive terms at h/dx = 4/3, Gaussian: largest of any wave; B. */
static void test_symbols_of_diffusion(void) {
  static const double most[] = {4.0016, 1.9641, 4.0016};
  struct theory_result r = THEORY("kernel", "kernel", "gaussian", "diffusion",
                                  "molteni, ferrari, antuono", "points", "2");
  for (size_t c = 0; c < 3; c++) EXPECT_NEAR(value_of(&r, c, "diffusion_most"), most[c], 5e-5);
  EXPECT(value_of(&r, 0, "neighbours") == 45);
  EXPECT_NEAR(value_of(&r, 2, "B"), 1. / 8, 1e-3); /* cut at 3h and renormalised */
  EXPECT_NEAR(value_of(&r, 2, "B_lattice") / (3 * value_of(&r, 2, "B")), 1, 0.01);
  theory_result_destroy(&r);
  r = THEORY("kernel", "kernel", "gaussian", "points", "84"); /* kh = 0.05 in the first row */
  double kh = M_PI * cell_of(&r, 0, 0, "kdx") * 4 / 3;
  EXPECT_NEAR(cell_of(&r, 0, 0, "diffusion") / pow(kh, 4), 0.3705, 5e-5);
  EXPECT_NEAR(cell_of(&r, 0, 0, "diffusion") / pow(kh, 4), value_of(&r, 0, "B_lattice"), 4e-4);
  theory_result_destroy(&r);
  r = THEORY("kernel", "kernel", "cubic", "points", "2");
  EXPECT_NEAR(value_of(&r, 0, "B"), 0.0791, 5e-5);
  EXPECT_NEAR(value_of(&r, 0, "sum_x_dW"), 1.0149, 5e-5); /* T's runs: dx = 0.75 h */
  EXPECT_NEAR(value_of(&r, 0, "sum_x2_W") / value_of(&r, 0, "sum_W") / 2, 0.1576, 5e-5);
  theory_result_destroy(&r);
}

/* T's tensor product at dx = h: sum W = 1, sum x^2 W = 1/3, sum x dW/dx = 1; the symbols
 * 1 - (2/3) sin^2 and sin(kh)/(kh), and |gradient| <= 1.038/h of waves in any direction. */
static void test_tensor_product_at_its_own_spacing(void) {
  struct theory_result r = THEORY("kernel", "kernel", "tensor", "ratio", "1", "points", "20");
  EXPECT_NEAR(value_of(&r, 0, "sum_W"), 1, 1e-14);
  EXPECT_NEAR(value_of(&r, 0, "sum_x2_W"), 1. / 3, 1e-14);
  EXPECT_NEAR(value_of(&r, 0, "sum_x_dW"), 1, 1e-14);
  EXPECT_NEAR(value_of(&r, 0, "gradient_most"), 1.038, 1e-3);
  for (size_t i = 0; i < 20; i++) {
    double k = M_PI * cell_of(&r, 0, i, "kdx");
    EXPECT_NEAR(cell_of(&r, 0, i, "interpolation"), 1 - 2. / 3 * pow(sin(k / 2), 2), 1e-14);
    EXPECT_NEAR(cell_of(&r, 0, i, "gradient"), sin(k) / k, 1e-14);
    double transform = pow(2 * sin(k / 2) / k, 4);
    EXPECT_NEAR(cell_of(&r, 0, i, "transform"), transform, 1e-4); /* by the midpoint rule */
  }
  theory_result_destroy(&r);
}

/* What other spacings make of the moments of a line, here of the product of two; -1/81 at h/dx
 * = 1.5.
 */
static void test_other_spacings_miss_the_moments(void) {
  static const double zeroth[] = {1.80e-3, 3.91e-3, 4.12e-3, 0};
  static const double first[] = {2.24e-2, 1.95e-2, -1.235e-2, 0};
  struct theory_result r = THEORY("kernel", "kernel", "tensor", "ratio",
                                  "1.2, 1.3333333333333333, 1.5, 2", "points", "2");
  for (size_t c = 0; c < 4; c++) {
    EXPECT_NEAR(sqrt(value_of(&r, c, "sum_W")) - 1, zeroth[c], 5e-6);
    EXPECT_NEAR(value_of(&r, c, "sum_x_dW") / sqrt(value_of(&r, c, "sum_W")) - 1, first[c], 5e-5);
  }
  theory_result_destroy(&r);
}

static void expect_rows(const struct theory_result *r, const char *key, size_t n,
                        const double *row) {
  for (size_t i = 0; i < n; i++) EXPECT_NEAR(cell_of(r, 0, i, key), row[i], 6e-5);
}

/* Half a space of Gaussian particles at h/dx = 4/3. */
static void test_rows_below_a_surface(void) {
  struct theory_result r = THEORY("surface", NULL);
  expect_rows(&r, "molteni", 4, (const double[]){.7620, .2189, .0180, 0});
  expect_rows(&r, "ferrari", 4, (const double[]){.4558, .1866, .0212, 0});
  for (size_t i = 0; i < 6; i++) EXPECT_NEAR(cell_of(&r, 0, i, "antuono"), 0, 1e-12);
  expect_rows(&r, "fill", 4, (const double[]){.7117, .9530, .9974, 1});
  expect_rows(&r, "slope", 4, (const double[]){.3810, .1095, .0090, 0});
  expect_rows(&r, "variable", 4, (const double[]){-.3100, -.0648, -.0056, -.0011});
  expect_rows(&r, "plus", 4, (const double[]){-.1195, .0994, .0169, -.0011});
  expect_rows(&r, "minus", 4, (const double[]){-.5005, -.2290, -.0281, -.0011});
  theory_result_destroy(&r);
  r = THEORY("surface", "kernel", "cubic");
  expect_rows(&r, "variable", 4, (const double[]){-.2703, -.0166, .0149, .0149});
  expect_rows(&r, "plus", 4, (const double[]){-.0480, .0777, .0149, .0149});
  expect_rows(&r, "minus", 4, (const double[]){-.4926, -.1108, .0149, .0149});
  expect_rows(&r, "slope", 3, (const double[]){.4446, .0628, 0});
  expect_rows(&r, "fill", 3, (const double[]){.7571, .9883, 1.0006});
  theory_result_destroy(&r);
}

/* Figure 2-24: six particles, the top row on the surface; (2.157)-(2.170) and (3.17). */
static void test_figure_2_24(void) {
  struct theory_result r =
      THEORY("surface", "kernel", "tensor", "ratio", "1", "offset", "0, 0.5", "rows", "3");
  EXPECT_NEAR(cell_of(&r, 0, 0, "slope"), 1. / 2, 1e-13);
  EXPECT_NEAR(cell_of(&r, 0, 0, "gradient_x"), 5. / 6, 1e-13);
  EXPECT_NEAR(cell_of(&r, 0, 0, "gradient_y"), 1. / 2, 1e-13);
  EXPECT_NEAR(cell_of(&r, 0, 0, "fill"), 5. / 6, 1e-13);
  static const char *const form[] = {"variable", "plus", "minus"};
  for (size_t k = 0; k < 3; k++) EXPECT_NEAR(cell_of(&r, 0, 0, form[k]), -1. / 2, 1e-13);
  /* y = -h/2: -(g/2)(1 + y/h) by (2.12), -g (1/2 + y/h) with both pressures */
  EXPECT_NEAR(cell_of(&r, 1, 0, "variable"), -1. / 4, 1e-13);
  EXPECT_NEAR(cell_of(&r, 1, 0, "plus"), 0, 1e-13);
  EXPECT_NEAR(cell_of(&r, 1, 0, "minus"), -1. / 2, 1e-13);
  for (size_t k = 0; k < 3; k++) EXPECT_NEAR(cell_of(&r, 1, 1, form[k]), 0, 1e-13);
  EXPECT_NEAR(cell_of(&r, 0, 0, "gradient_cross"), 0, 1e-15);
  EXPECT_NEAR(cell_of(&r, 0, 0, "symmetric"), -1. / 2, 1e-13);
  EXPECT_NEAR(value_of(&r, 0, "slope_integral"), 2. / 3, 1e-13); /* W(0) int W dx */
  theory_result_destroy(&r);
  /* the Gaussian's but for its cut at 3h, per dx = 3h/4 */
  r = THEORY("surface", "rows", "1");
  EXPECT_NEAR(value_of(&r, 0, "slope_integral"), 0.75 / sqrt(M_PI), 5e-4);
  theory_result_destroy(&r);
}

/* With the density of rest and beta = 20, h = 0.04: -(3/8)(g h/c^2) g in the top row by (2.15), to
 * first order; below, where sums are complete, (h^2/6) P''' of T's kernel. */
static void test_surface_of_stratified_water(void) {
  struct theory_result r = THEORY("surface", "kernel", "tensor", "ratio", "1", "rows", "3",
                                  "stratification", "0.002, 1e-9, 0");
  EXPECT_NEAR(cell_of(&r, 0, 0, "symmetric") / (-0.375 * 0.002), 1, 3e-3);
  EXPECT_NEAR(cell_of(&r, 0, 0, "symmetric"), -7.5e-4, 5e-6);
  EXPECT_NEAR(cell_of(&r, 0, 0, "variable"), -0.2496, 5e-5);
  EXPECT_NEAR(cell_of(&r, 0, 2, "symmetric"), 0.002 * 0.002 / 6, 1e-9);
  static const char *const form[] = {"variable", "plus", "minus", "symmetric"};
  for (size_t k = 0; k < 4; k++)
    EXPECT_NEAR(cell_of(&r, 1, 0, form[k]), cell_of(&r, 2, 0, form[k]), 1e-8);
  theory_result_destroy(&r);
}

/* Along a row, delta = 0.2: waves cease to travel at k dx = 0.70 pi, although delta is below the
 * paper's bound; long waves are damped like h^2 B k^4 with B = 0.3705. Of all waves 62 % stand:
 * 0.615925 by another program with 200 squares along the zone's half. Without diffusion and
 * viscosity none does. */
static void test_sound_on_a_lattice(void) {
  struct theory_result r =
      THEORY("dispersion", "operator", "lattice", "alpha", "0", "delta", "0.2", "points", "1001");
  EXPECT_NEAR(value_of(&r, 0, "mu_star") * 3 / 4 / M_PI, 0.70, 5e-3);
  EXPECT_NEAR(value_of(&r, 0, "standing"), 0.6159, 1e-3);
  double mu = cell_of(&r, 0, 20, "mu");
  EXPECT_NEAR(cell_of(&r, 0, 20, "b") / (-0.2 * 0.3705 * pow(mu, 3) / 2), 1, 0.01);
  EXPECT_NEAR(cell_of(&r, 0, 20, "a"), 1, 0.01);
  theory_result_destroy(&r);
  r = THEORY("dispersion", "operator", "lattice", "alpha", "0", "delta", "0", "points", "2");
  EXPECT_NEAR(value_of(&r, 0, "standing"), 0, 0);
  theory_result_destroy(&r);
  /* 3 nu k/2, nu = alpha h c0/8; the sum lacks the particle itself, a share (dx/h)^2 */
  r = THEORY("dispersion", "operator", "lattice", "alpha", "0.3", "delta", "0", "ratio",
             "1.3333333333333333, 4", "points", "1001");
  EXPECT_NEAR(cell_of(&r, 0, 20, "b") / (-0.3 * mu * 3 / 16), 1, 0.02);
  EXPECT_NEAR(cell_of(&r, 1, 20, "b") / (-0.3 * cell_of(&r, 1, 20, "mu") * 3 / 16), 1, 0.003);
  theory_result_destroy(&r);
}

/* Largest stable c0 dt/h at rest, h/dx = 4/3: the Gaussian with the paper's deltas, and the cubic
 * spline. Half of the last digit, and what waves between the 32 along an axis can take away. */
static void test_stable_steps_of_the_solver(void) {
  static const struct {
    const char *kernel, *diffusion, *delta, *integrator;
    double courant;
  } of[] = {{"gaussian", "none", "0", "rk4", 3.29},
            {"gaussian", "none", "0", "tvd-rk3", 2.02},
            {"gaussian", "antuono", "0.2", "rk4-frozen", 2.50},
            {"gaussian", "antuono", "0.2", "rk4", 3.43},
            {"gaussian", "ferrari", "1", "rk4-frozen", 1.018},
            {"gaussian", "ferrari", "1", "rk4", 1.418},
            {"gaussian", "ferrari", "1", "tvd-rk3", 1.279},
            {"gaussian", "molteni", "0.5", "rk4-frozen", 1.000},
            {"gaussian", "molteni", "0.5", "rk4", 1.392},
            {"cubic", "antuono", "0.2", "rk4-frozen", 1.738}};
  for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
    struct theory_result r =
        THEORY("stability", "kernel", of[k].kernel, "diffusion", of[k].diffusion, "delta",
               of[k].delta, "integrator", of[k].integrator, "points", "2", "to", "3");
    EXPECT_NEAR(value_of(&r, 0, "courant_most"), of[k].courant, 0.005 + 3e-3 * of[k].courant);
    double below = cell_of(&r, 0, 0, "lambda"), above = cell_of(&r, 0, 1, "lambda"); /* 1.5, 3 */
    EXPECT((below > 1 + 1e-6) == (of[k].courant < 1.5) &&
           (above > 1 + 1e-6) == (of[k].courant < 3));
    theory_result_destroy(&r);
  }
}

/* The word of a run stands for a number, and for itself where parameters are told. */
static void test_delta_may_be_auto(void) {
  struct theory_result r = THEORY("stability", "delta", "auto, 0.5", "diffusion", "molteni",
                                  "integrator", "rk4", "points", "2", "waves", "8");
  EXPECT(strcmp(r.curve[0].name, "delta = auto") == 0);
  EXPECT(value_of(&r, 0, "delta") == 0.5);
  EXPECT(value_of(&r, 0, "courant_most") == value_of(&r, 1, "courant_most"));
  theory_result_destroy(&r);
}

int main(void) {
  RUN(test_symbols_of_diffusion);
  RUN(test_tensor_product_at_its_own_spacing);
  RUN(test_other_spacings_miss_the_moments);
  RUN(test_rows_below_a_surface);
  RUN(test_figure_2_24);
  RUN(test_surface_of_stratified_water);
  RUN(test_sound_on_a_lattice);
  RUN(test_stable_steps_of_the_solver);
  RUN(test_delta_may_be_auto);
  return TEST_RESULT;
}

/* Tables of the thesis: 2.1 (potentials), 2.4 (rates) and 3.2 (derivatives, densities). */
#include <complex.h>

#include "tests/theory/evaluate.h"

/* With roots of (2.57) all of table 2.1 holds to rounding; with (2 n + 1) pi/2 the bed's condition
 * is off by delta H, and the incompressible mode's always by kappa e^(-kappa H) over 2 kappa. */
static void test_table_2_1(void) {
  static const char *const key[] = {"horizontal", "vertical", "pressure",
                                    "equation",   "surface",  "bed"};
  struct theory_result r = THEORY("potentials", "mode", "-1, 0, 10, 60", "sound", "1, 5");
  for (size_t c = 0; c < r.n; c++) {
    bool acoustic = c > 1;
    for (size_t k = 0; k < (acoustic ? 6 : 5); k++) EXPECT(value_of(&r, c, key[k]) < 1e-13);
    if (!acoustic) EXPECT_NEAR(value_of(&r, c, "bed"), exp(-2 * M_PI) / 2, 1e-12);
  }
  theory_result_destroy(&r);
  r = THEORY("potentials", "mode", "0, 10", "root", "leading");
  for (size_t c = 0; c < r.n; c++) {
    EXPECT(value_of(&r, c, "equation") < 1e-13);
    EXPECT(value_of(&r, c, "bed") > 1e-3 && value_of(&r, c, "bed") < 0.05);
  }
  theory_result_destroy(&r);
}

/* psi'' - kappa^2 psi of the columns, which is zero where the water is incompressible. */
static void test_laplacian_of_table_2_1(void) {
  struct theory_result r = THEORY("potentials", "mode", "-1, 3", "points", "2001");
  double kappa = 2 * M_PI, h = 1. / 2000;
  for (size_t c = 0; c < 2; c++)
    for (size_t i = 1; i < 2000; i += 97) {
      double psi = cell_of(&r, c, i, "potential"), lap = cell_of(&r, c, i, "laplacian");
      double bend =
          cell_of(&r, c, i + 1, "potential") - 2 * psi + cell_of(&r, c, i - 1, "potential");
      EXPECT_NEAR(bend / (h * h) - kappa * kappa * psi, lap, 2e-3);
      if (!c) EXPECT_NEAR(lap, 0, 1e-13);
    }
  theory_result_destroy(&r);
}

/* Table 2.4: closed forms are the eigenvalues; what is printed is, where it is. */
static void test_table_2_4(void) {
  struct theory_result r = THEORY("rates", "mode", "decaying, oscillating", "points", "40");
  EXPECT(r.n == 12);
  for (size_t c = 0; c < 10; c++) EXPECT(value_of(&r, c, "off") < 1e-11);
  EXPECT_NEAR(value_of(&r, 1, "printed_off"), 0, 1e-13); /* c sinh(mu h)/h */
  EXPECT_NEAR(value_of(&r, 3, "printed_off"), 0, 1e-13); /* c mu sqrt(1 + 2 delta/mu) */
  double mu = 2. / 40 / 0.02;                            /* gravity belongs to another variable */
  EXPECT_NEAR(value_of(&r, 0, "printed_off"), 1 - sqrt(1 - 1 / (20 * mu)), 1e-12);
  EXPECT(value_of(&r, 9, "printed_off") > 0.9); /* delta/nu */
  for (size_t i = 0; i < 40; i++) {
    EXPECT(fabs(cell_of(&r, 6, i, "eigenvalue")) < 1e-9); /* waves on uniform density */
    EXPECT(cell_of(&r, 8, i, "eigenvalue") < 1e-9);       /* with RK4 they decay */
    double kh = cell_of(&r, 10, i, "kh"), c_delta = 1 / (2 * sqrt(20.)), dh = 0.02 / 40;
    double nu = kh / 0.02, small = 1 / (40 * nu);
    EXPECT_NEAR(cell_of(&r, 9, i, "closed") / c_delta, 1, small * small);
    EXPECT_NEAR(cell_of(&r, 10, i, "closed") / (c_delta * (2 - cos(kh))), 1,
                pow(dh * (2 - cos(kh)) / sin(kh), 2));
    EXPECT_NEAR(cell_of(&r, 10, i, "eigenvalue") / (c_delta * (2 - cos(kh))), 1,
                2 * pow(dh * (2 - cos(kh)) / sin(kh), 2));
  }
  theory_result_destroy(&r);
}

/* The rate of the particle at the surface among its two neighbours at rest that grows, h = 0.02,
 * c^2 = 20, W of h = 1/2 and W'' of 1: from y' = v, v' = Y y + R r, r' = V v, of which one rate is
 * zero and the others are +-sqrt(Y + R V). */
static double complex rate_at_rest(double kh) {
  const double c2 = 20, h = 0.02;
  double complex Y = 0, R = 0, V = 0;
  for (int j = -1; j <= 1; j += 2) { /* j rows above: y_b - y_a = j h, W' of y_a - y_b is j/2 */
    const double rho = exp(-j * h / c2), P = c2 * (rho - 1), mass = rho * h;
    const double complex there = cexp(I * j * kh);
    Y -= mass * P / (rho * rho) * (1 - there) / pow(h, 3);
    R -= mass * c2 * (1 + (2 / (rho * rho) - 1 / rho) * there) * j / (2 * h * h);
    V += mass * (1 - there) * j / (2 * h * h);
  }
  const double complex rate = csqrt(Y + R * V);
  return creal(rate) < 0 ? -rate : rate;
}

/* Discrete waves at rest, which have no closed form to rounding: ln |R(rate dt)|/dt. */
static void test_steps_at_rest(void) {
  struct theory_result r = THEORY("rates", "mode", "oscillating", "base", "rest", "system",
                                  "lattice, discrete", "points", "40");
  const double dt = 0.5 * 0.02 / sqrt(20);
  for (size_t i = 0; i < 40; i++) {
    const double complex rate = rate_at_rest(cell_of(&r, 0, i, "kh"));
    double growth = -INFINITY;
    for (int side = -1; side <= 1; side += 2) {
      const double complex z = side * rate * dt;
      const double complex step = 1 + z + z * z / 2 + z * z * z / 6 + z * z * z * z / 24;
      growth = fmax(growth, log(cabs(step)) / dt);
    }
    EXPECT_NEAR((cell_of(&r, 0, i, "eigenvalue") - creal(rate)) / cabs(rate), 0, 1e-11);
    EXPECT_NEAR((cell_of(&r, 1, i, "eigenvalue") - growth) / cabs(rate), 0, 1e-11);
  }
  theory_result_destroy(&r);
}

/* Waves on a lattice at rest: the system of the sums has the growth of the closed form up to the
 * square of theta = 2 delta |y|; of longer waves than these delta h counts, too. */
static void test_sums_at_rest(void) {
  struct theory_result r = THEORY("rates", "mode", "oscillating", "base", "rest", "system",
                                  "lattice", "depth", "1, 0.5", "points", "10", "to", "1");
  EXPECT(r.n == 2);
  for (size_t i = 4; i < 10; i++) {
    double off[2];
    for (size_t c = 0; c < 2; c++)
      off[c] = cell_of(&r, c, i, "eigenvalue") / cell_of(&r, c, i, "closed") - 1;
    EXPECT_NEAR(off[0], 0, 0.05 * 0.05);
    EXPECT_NEAR(off[0] / off[1], 4, 0.4);
  }
  theory_result_destroy(&r);
}

/* Where the system has kappa and nothing else, `growth` and `oscillation` have the same rates. */
static void test_rates_are_those_of_other_topics(void) {
  struct theory_result r = THEORY("rates", "base", "rest", "points", "10", "to", "1");
  struct theory_result g =
      THEORY("growth", "kappa", "0", "spacing", "0.02", "points", "11", "courant", "0.5");
  static const char *const key[] = {"pressure", "lattice", "discrete"};
  for (size_t c = 0; c < 3; c++)
    for (size_t i = 0; i < 10; i++)
      EXPECT_NEAR(cell_of(&r, c, i, "closed") / cell_of(&g, 0, i + 1, key[c]), 1, 1e-12);
  theory_result_destroy(&r);
  theory_result_destroy(&g);
}

/* Values to second order; slopes to first, on a lattice, where third moments vanish, to second. */
static void test_orders_of_fits(void) {
  struct theory_result r = THEORY("derivatives", NULL);
  static const double order[] = {2, 2, 2, 1, 2, 1};
  for (size_t c = 0; c < 6; c++) {
    EXPECT_NEAR(value_of(&r, c, "order"), order[c], 0.05);
    EXPECT(fabs(value_of(&r, c, "line")) < 1e-14);
    if (c > 1) EXPECT(fabs(value_of(&r, c, "nearly")) > 1e3); /* f'' dx/1e-6 for a slope of f */
  }
  theory_result_destroy(&r);
}

/* Shepard's and MLS with volumes smooth by (h^2/6) rho''; MLS of masses has the first density. */
static void test_densities(void) {
  struct theory_result r = THEORY("densities", "wave", "0.05", "delta", "0, 1e-4");
  for (size_t c = 0; c < 4; c++) {
    EXPECT_NEAR(value_of(&r, c, "second"), 1. / 6, 0.01 / 6);
    EXPECT_NEAR(value_of(&r, c, "kept"), 1 - 0.0025 / 6, 1e-5);
  }
  EXPECT_NEAR(value_of(&r, 4, "kept"), 0, 1e-12);
  EXPECT_NEAR(value_of(&r, 5, "kept"), 0, 1e-5);
  theory_result_destroy(&r);
}

/* By the symbol, 1 - (2/3) sin^2(kh/2), whatever the wave. */
static void test_densities_follow_the_symbol(void) {
  struct theory_result r =
      THEORY("densities", "wave", "1", "amplitude", "1e-6", "scheme", "shepard");
  EXPECT_NEAR(value_of(&r, 0, "kept"), 1 - 2. / 3 * pow(sin(0.5), 2), 1e-5);
  theory_result_destroy(&r);
}

int main(void) {
  RUN(test_table_2_1);
  RUN(test_laplacian_of_table_2_1);
  RUN(test_table_2_4);
  RUN(test_steps_at_rest);
  RUN(test_sums_at_rest);
  RUN(test_rates_are_those_of_other_topics);
  RUN(test_orders_of_fits);
  RUN(test_densities);
  RUN(test_densities_follow_the_symbol);
  return TEST_RESULT;
}

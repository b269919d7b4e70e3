/* Growth in columns of particles: figures 2-28, 2-29, 2-33 and 4-18 of the thesis, and table 2.4.
 */
#include <complex.h>

#include "tests/theory/evaluate.h"
#include "theory/column.h"

/* Figures 2-28 and 2-29: mu = 2 pi/(25 h), kappa = 2 pi, beta = 20. */
static void test_growth_of_decaying_modes(void) {
  struct theory_result r = THEORY("growth", "points", "2");
  EXPECT_NEAR(value_of(&r, 0, "mu"), 12.566, 5e-4);
  EXPECT_NEAR(value_of(&r, 0, "potential"), 48.540, 5e-4);
  EXPECT_NEAR(value_of(&r, 0, "pressure"), 48.798, 5e-4);
  EXPECT_NEAR(value_of(&r, 0, "lattice"), 49.18, 5e-3);
  EXPECT_NEAR(value_of(&r, 1, "potential"), 108.712, 5e-4);
  EXPECT_NEAR(value_of(&r, 1, "pressure"), 108.943, 5e-4);
  EXPECT_NEAR(value_of(&r, 1, "lattice"), 110.02, 5e-3);
  /* RK4's ln R(z) = z - z^5/120 + ... */
  double z = value_of(&r, 1, "lattice") * 0.25 * 0.01 / sqrt(20);
  EXPECT_NEAR(value_of(&r, 1, "discrete") / value_of(&r, 1, "lattice"), 1 - pow(z, 4) / 120, 1e-7);
  theory_result_destroy(&r);
}

/* Table 2.4, first row: eigenvalues of [0 1 0; 0 0 -g - c^2 mu; 0 -mu 0] (2.193) give (2.195) for
 * kappa = 0, and with gravity in the other equation (2.176); the lattice's without gravity is
 * c sinh(mu h)/h. A potential e^((mu + 2 delta) y) grows like the pressure e^(mu y). */
static void test_table_2_4_decaying(void) {
  struct theory_result r = THEORY("growth", "kappa", "0", "spacing", "0.02", "points", "21");
  for (size_t i = 1; i < 21; i++) {
    double mu = cell_of(&r, 0, i, "mu"), beta = 20, delta = 1 / (2 * beta);
    double complex lambda[THEORY_LARGEST];
    struct theory_matrix m = {3, {{0, 1, 0}, {0, 0, -1 - beta * mu}, {0, -mu, 0}}};
    EXPECT_OK(theory_eigenvalues(&m, lambda));
    double growth = fmax(creal(lambda[0]), fmax(creal(lambda[1]), creal(lambda[2])));
    EXPECT_NEAR(cell_of(&r, 0, i, "pressure") / growth, 1, 1e-10);
    EXPECT_NEAR(cell_of(&r, 0, i, "pressure"), sqrt(beta) * mu * sqrt(1 + 2 * delta / mu), 1e-10);
    EXPECT_NEAR(cell_of(&r, 0, i, "potential"), sqrt(beta) * mu * sqrt(1 - 2 * delta / mu), 1e-10);
    double shifted = mu + 2 * delta;
    EXPECT_NEAR(beta * shifted * shifted - shifted, beta * mu * mu + mu, 1e-10 * mu * mu * beta);
    double s = sinh(mu * 0.02) / 0.02; /* y' = v, v' = -(g + c^2 s) r, r' = -s v */
    EXPECT_NEAR(cell_of(&r, 0, i, "lattice"), sqrt(beta * s * s + s), 1e-10 * s);
  }
  theory_result_destroy(&r);
}

static void test_table_2_4_oscillating(void) {
  struct theory_result r = THEORY("oscillation", "to", "20", "points", "2");
  double exact = cell_of(&r, 0, 0, "continuum"), law = 1 / (2 * sqrt(10.));
  EXPECT_NEAR(exact, creal(csqrt(-10 * 100 - I * 10)), 1e-12); /* (2.196) */
  EXPECT_NEAR(exact, 0.15811, 5e-6);
  EXPECT_NEAR(exact / law, 1, pow(0.05 / 10, 2)); /* c delta to the order of (delta/nu)^2 */
  EXPECT_NEAR(cell_of(&r, 0, 0, "leading"), law, 1e-14);
  EXPECT_NEAR(cell_of(&r, 0, 0, "printed"), 0.005, 1e-15);
  theory_result_destroy(&r);
  /* the lattice's, from its matrix of position and velocity; RK4's at a small step */
  r = THEORY("oscillation", "spacing", "0.02", "courant", "0.01", "to", "60", "points", "12");
  for (size_t i = 0; i < 12; i++) {
    double nu = cell_of(&r, 0, i, "nu"), kh = nu * 0.02, dh = 0.05 * 0.02, c = sqrt(10.);
    double complex q = -pow(sin(kh), 2) - 2 * I * dh * sin(kh) * (2 - cos(kh));
    double growth = fabs(creal(csqrt(q))) * c / 0.02;
    EXPECT_NEAR(cell_of(&r, 0, i, "lattice") / growth, 1, 2 * pow(dh / sin(kh), 2));
    EXPECT_NEAR(cell_of(&r, 0, i, "discrete") / growth, 1, 1e-6);
  }
  theory_result_destroy(&r);
}

/* Figure 2-33: the printed matrix (a), the matrix of the printed equations (b), and the corrected
 * equations (c). */
static void test_figure_2_33(void) {
  static const double printed[] = {1.18718, 0.28943, 0.07125, 0.00489};
  static const double at[] = {M_PI, M_PI, 1.213, 1.558};
  static const double corrected[] = {7.26e-4, 7.46e-4, 5.70e-4, 1.193e-4};
  struct theory_result r =
      THEORY("hydrostatic", "layer", "printed, equations, stratified", "points", "2000");
  for (size_t c = 0; c < 4; c++) {
    EXPECT_NEAR(value_of(&r, c, "growth_most"), printed[c], 1e-5);
    EXPECT_NEAR(value_of(&r, c, "kh_most"), at[c], 2e-3);
    EXPECT_NEAR(value_of(&r, c + 4, "growth_most"), 0, 1e-12);
    EXPECT_NEAR(value_of(&r, c + 8, "growth_most"), corrected[c], 5e-3 * corrected[c]);
  }
  static const double courant[] = {1, 0.8, 0.5, 0.1};
  for (size_t c = 0; c < 4; c++)
    for (size_t i = 0; i < r.curve[8 + c].n; i++) {
      double kh = cell_of(&r, 8 + c, i, "kh"), dh = 0.025 * 0.02;
      EXPECT(cell_of(&r, 8 + c, i, "growth") <=
             courant[c] * dh * (2 - cos(kh)) + 4 * dh * dh + 1e-15);
    }
  theory_result_destroy(&r);
  r = THEORY("hydrostatic", "layer", "stratified", "courant", "0.1", "depth", "0", "points", "100");
  for (size_t i = 0; i < 100; i++) {
    double kh = cell_of(&r, 0, i, "kh"), dh = 0.025 * 0.02;
    if (sin(kh) <= 20 * dh) continue;
    EXPECT_NEAR(cell_of(&r, 0, i, "growth") / (0.1 * dh * (2 - cos(kh))), 1, 0.01);
  }
  theory_result_destroy(&r);
}

/* (2.273) is RK4's matrix but for five entries. */
static void test_slips_of_the_printed_matrix(void) {
  static const bool misprinted[3][3] = {
      {true, false, false}, {false, true, false}, {true, true, true}};
  struct theory_matrix printed = theory_column_printed(0.83, 1.1, THEORY_LITERAL);
  struct theory_matrix right = theory_column_step(0.83, 1.1, 1, 0);
  struct theory_matrix repaired = theory_column_printed(0.83, 1.1, THEORY_FIRST);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      EXPECT((cabs(printed.a[i][j] - right.a[i][j]) > 1e-3) == misprinted[i][j]);
  EXPECT(cabs(repaired.a[0][0] - right.a[0][0]) < 1e-14);
  struct theory_matrix sign = theory_column_printed(0.83, 1.1, THEORY_SIGN);
  EXPECT(cabs(sign.a[2][0] - right.a[2][0]) < 1e-14);
}

/* Figure 4-18, as T: least n of (4.55) and where (known on a grid of 0.01), largest |lambda| and
 * where; mu_c = 1, 0.8, 0.5, 0.1. */
static void expect_figure_4_18(const char *reading, const double n[4], const double at[4]) {
  struct theory_result r =
      THEORY("smoothing", "reading", reading, "courant", "1, 0.8, 0.5, 0.1", "points", "3142");
  for (size_t c = 0; c < 4; c++) {
    EXPECT_NEAR(value_of(&r, c, "printed_least") / n[c], 1, 2e-3);
    EXPECT_NEAR(value_of(&r, c, "printed_kh"), at[c], 0.01);
  }
  EXPECT(floor(value_of(&r, 1, "printed_least")) == 5); /* T's "optimal n = 5" */
  theory_result_destroy(&r);
}

static void test_smoothing_as_printed(void) {
  expect_figure_4_18("literal", (const double[]){5.09, 5.86, 9.69, 173.1},
                     (const double[]){.78, .92, 1.15, 1.31});
  expect_figure_4_18("first", (const double[]){4.82, 5.58, 9.43, 172.8},
                     (const double[]){.81, .95, 1.17, 1.31});
  static const double most[] = {1.2339, 1.2137, 1.1440, 1.0088}, at[] = {.85, 1.03, 1.37, 1.61};
  struct theory_result r = THEORY("smoothing", "courant", "1, 0.8, 0.5, 0.1", "points", "3142");
  for (size_t c = 0; c < 4; c++) {
    EXPECT_NEAR(1 + value_of(&r, c, "growth_most"), most[c], 1e-4);
    EXPECT_NEAR(value_of(&r, c, "kh_most"), at[c], 0.01);
  }
  theory_result_destroy(&r);
}

/* Figures 2-25 to 2-32: largest growth in columns 50 high, beta = 40, as an independent program has
 * it, in three or more digits; that of fits, whose weights there fall with the distance, by 0.5 %.
 */
static void test_spectra_of_columns_at_rest(void) {
  static const struct {
    const char *momentum, *continuity, *derivative, *surface, *walls, *points;
    double most, within;
  } known[] = {
      {"neighbour", "absolute", "kernel", "natural", "mirror-exponential", "6", 0, 0.01},
      {"mass", "mass", "kernel", "natural", "mirror-exponential", "6", 0, 0.01},
      {"mass", "absolute", "kernel", "natural", "mirror-exponential", "2", 8.796, 5e-4},
      {"neighbour", "mass", "kernel", "natural", "mirror-exponential", "2", 7.08, 5e-3},
      {"mass", "mass", "kernel", "level", "mirror-exponential", "2", 2.10, 5e-3},
      {"mass", "absolute", "kernel", "level", "mirror-exponential", "2", 7.86, 5e-3},
      {"neighbour", "absolute", "kernel", "fitted", "mirror-exponential", "26", 1.34, 5e-3},
      {"mass", "absolute", "kernel", "fitted", "mirror-exponential", "26", 2.45, 5e-3},
      {"minus", "divergence", "mls", "fitted", "mirror-exponential", "26", 3.94, 0.02},
      {"minus", "divergence", "mls", "level", "mirror-reference", "2", 4.78, 5e-3},
  };
  for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
    struct theory_result r =
        THEORY("spectrum", "momentum", known[i].momentum, "continuity", known[i].continuity,
               "derivative", known[i].derivative, "free_surface", known[i].surface, "walls",
               known[i].walls, "points", known[i].points);
    EXPECT_NEAR(value_of(&r, 0, "growth_most"), known[i].most, known[i].within);
    if (strcmp(known[i].derivative, "mls") != 0) EXPECT(value_of(&r, 0, "growth_uniform") < 0.01);
    theory_result_destroy(&r);
  }
  /* the largest that a tank of 50 columns has with du/dt, which is 0 by symmetry at k dx = pi */
  struct theory_result r = THEORY("spectrum", "continuity", "absolute");
  EXPECT_NEAR(cell_of(&r, 0, 24, "growth"), 7.796, 5e-4);
  theory_result_destroy(&r);
}

static enum status spectrum_of(size_t n, const struct theory_setting *setting) {
  struct theory_result r = {0};
  const enum status status = theory_evaluate(theory_topic_find("spectrum"), n, setting, &r);
  theory_result_destroy(&r);
  return status;
}

/* Rows that fall apart, whose steps would shrink without end; and what a run is refused for, by the
 * names that parameters have here. */
static void test_what_spectrum_refuses(void) {
  static const struct theory_setting apart[] = {
      {"points", "2"},       {"rows", "16"},
      {"beta", "1"},         {"at", "settled"},
      {"momentum", "minus"}, {"continuity", "reference"},
      {"kernel", "cubic"},   {"derivative", "renormalised"},
      {"ratio", "1.5"},      {"alpha", "0.1"},
  };
  EXPECT(spectrum_of(THEORY_COUNT(apart), apart) == ERR_SOLVER);
  EXPECT(strstr(status_message(), "do not come to rest"));
  static const struct theory_setting narrow[] = {{"points", "2"},       {"rows", "8"},
                                                 {"momentum", "minus"}, {"continuity", "reference"},
                                                 {"derivative", "mls"}, {"radius", "1"}};
  EXPECT(spectrum_of(THEORY_COUNT(narrow), narrow) == ERR_USAGE);
  EXPECT(!strncmp(status_message(), "radius: found", 13));
  EXPECT(strstr(status_message(), "over ratio;"));
  static const struct theory_setting wide[] = {{"points", "2"}, {"rows", "8"}, {"ratio", "3"}};
  EXPECT_OK(spectrum_of(THEORY_COUNT(wide), wide)); /* in a tank that is high enough */
}

/* The strength that a run takes by itself; there is none without diffusion. */
static void test_spectrum_tells_its_diffusion(void) {
  struct theory_result r =
      THEORY("spectrum", "points", "2", "rows", "8", "continuity", "mass", "kernel", "gaussian",
             "ratio", "1.3333333333333333", "diffusion", "none, antuono");
  EXPECT(isnan(value_of(&r, 0, "delta")));
  EXPECT_NEAR(value_of(&r, 1, "delta"), 0.2, 1e-12); /* P's, with its kernel */
  theory_result_destroy(&r);
}

static void test_smoothing_corrected(void) {
  struct theory_result r = THEORY("smoothing", "layer", "equations", "courant", "1, 0.8, 0.5, 0.1");
  static const double courant[] = {1, 0.8, 0.5, 0.1};
  for (size_t c = 0; c < 4; c++) {
    for (size_t i = 0; i < r.curve[c].n; i++) { /* 0, +- i sqrt(8 s2 + s1^2) c/h */
      const double kh = cell_of(&r, c, i, "kh");
      const double sound = sqrt(8 * pow(sin(kh / 2), 2) + pow(sin(kh), 2)), z = courant[c] * sound;
      EXPECT_NEAR(cell_of(&r, c, i, "frequency"), sound, 1e-12);
      EXPECT_NEAR(cell_of(&r, c, i, "still"), 0, 1e-12);
      EXPECT_NEAR(cell_of(&r, c, i, "sound"), sqrt(1 - pow(z, 6) / 72 + pow(z, 8) / 576) - 1,
                  1e-12);
    }
    EXPECT(value_of(&r, c, "growth_most") < 1e-12);
    EXPECT(isnan(value_of(&r, c, "printed_least")) && isnan(value_of(&r, c, "period_least")));
  }
  theory_result_destroy(&r);
  r = THEORY("smoothing", "layer", "corrected", "courant", "0.8", "depth", "0, 0.5, 1", "points",
             "3142");
  double most = 0, bound = 0.8 / 24 / 118.9263; /* mu_c g h/c^2 */
  for (size_t c = 0; c < 3; c++) most = fmax(most, value_of(&r, c, "growth_most"));
  EXPECT_NEAR(most / bound, 1, 1e-3);
  EXPECT_NEAR(most, 2.8e-4, 1e-6);
  theory_result_destroy(&r);
  /* waves of kh > 0.5, whatever the points of the curve: 161.26, 162.41 and 163.58 steps */
  static const double period[] = {161.260, 162.413, 163.579};
  for (int fine = 0; fine < 2; fine++) {
    r = THEORY("smoothing", "layer", "corrected", "courant", "0.8", "depth", "0, 0.5, 1", "points",
               fine ? "3142" : "7");
    for (size_t c = 0; c < 3; c++) {
      EXPECT_NEAR(value_of(&r, c, "period_least"), period[c], 0.01);
      EXPECT(value_of(&r, c, "period_kh") == 0.5);
    }
    theory_result_destroy(&r);
  }
}

int main(void) {
  RUN(test_growth_of_decaying_modes);
  RUN(test_table_2_4_decaying);
  RUN(test_table_2_4_oscillating);
  RUN(test_figure_2_33);
  RUN(test_slips_of_the_printed_matrix);
  RUN(test_smoothing_as_printed);
  RUN(test_spectra_of_columns_at_rest);
  RUN(test_what_spectrum_refuses);
  RUN(test_spectrum_tells_its_diffusion);
  RUN(test_smoothing_corrected);
  return TEST_RESULT;
}

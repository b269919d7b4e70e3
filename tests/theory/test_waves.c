/* Waves: graphic roots, profiles, frequencies, orthogonality and projection of the thesis. */
#include "tests/theory/evaluate.h"
#include "theory/modes.h"

/* Figures 2-4 and 2-5: eps = 1e-3, a = 5, 10, 100. */
static void test_roots_of_shallow_water(void) {
  static const double root[] = {0.998002015267, 0.998002065065, 0.998008612387};
  static const double flat[] = {8.67e-6, 3.37e-5, 3.33e-3}, a[] = {5, 10, 100};
  struct theory_result r = THEORY("roots", "points", "50");
  for (size_t c = 0; c < 3; c++) {
    double y = value_of(&r, c, "y1"), eps = 1e-3;
    EXPECT_NEAR(y, root[c], 1e-10);
    EXPECT_NEAR((1 - y) / (1 - value_of(&r, c, "y1_shallow")), 1, 1e-4);
    EXPECT(fabs(y - (1 - 2 * eps)) < 1e-5);
    EXPECT_NEAR(value_of(&r, c, "flatness") / flat[c], 1, 0.01);
    EXPECT_NEAR(value_of(&r, c, "flatness"), eps * eps * (1 + a[c] * a[c]) / 3, 0.01 * flat[c]);
    EXPECT(value_of(&r, c, "roots") == 1);
    EXPECT_NEAR(cell_of(&r, c, 0, "y"), -1 / (a[c] * a[c]), 1e-15);
    EXPECT_NEAR(cell_of(&r, c, 0, "f2"), 1 / eps, 1e-9); /* (2.46) */
    size_t at = 0;                                       /* the row where the curves cross */
    while (at < r.curve[c].n && isnan(cell_of(&r, c, at, "root"))) at++;
    EXPECT(r.curve[c].n == 51 && at < 51 && cell_of(&r, c, at, "y") == y);
    EXPECT_NEAR(cell_of(&r, c, at, "f1") / cell_of(&r, c, at, "f2"), 1, 1e-9);
    for (size_t i = 1; i < 51; i++) EXPECT(cell_of(&r, c, i, "y") > cell_of(&r, c, i - 1, "y"));
  }
  theory_result_destroy(&r);
}

/* Figure 2-6: a = 5, eps = 0.5, 1, 10, 100. */
static void test_roots_of_deep_water(void) {
  static const double count[] = {1, 1, 2, 2}, mu[] = {4.0454, 4.0009, 4, 4};
  static const double large[] = {0.614608518, 0.600285628, 0.6, 0.6};
  struct theory_result r = THEORY("roots", "a", "5", "eps", "0.5, 1, 10, 100", "points", "20");
  for (size_t c = 0; c < 4; c++) {
    EXPECT(value_of(&r, c, "roots") == count[c]);
    EXPECT_NEAR(value_of(&r, c, "y1"), large[c], c < 2 ? 1e-9 : 2e-9);
    EXPECT_NEAR(value_of(&r, c, "mu1"), mu[c], 5e-5);
    EXPECT_NEAR(value_of(&r, c, "y1_deep"), 0.6, 1e-15);
    EXPECT_NEAR(value_of(&r, c, "eps_o"), 13. / 12, 1e-15);
  }
  EXPECT_NEAR(value_of(&r, 2, "y0"), -3.926e-10, 4e-12);
  EXPECT_NEAR(value_of(&r, 2, "y0") / (-2 * exp(-20) / 10.5), 1, 0.01);
  EXPECT(fabs(value_of(&r, 3, "y0")) < 1e-14);
  EXPECT_NEAR(value_of(&r, 3, "mu0"), 1, 1e-12);
  theory_result_destroy(&r);
  r = THEORY("roots", "a", "5", "eps", "10", "from", "0.5", "points", "20");
  EXPECT(r.curve[0].n == 21 && cell_of(&r, 0, 0, "y") == 0.5); /* the small one lies before */
  theory_result_destroy(&r);
  r = THEORY("roots", "a", "5", "eps", "1.0833, 1.0834", "points", "2");
  EXPECT(value_of(&r, 0, "roots") == 1 && value_of(&r, 1, "roots") == 2);
  theory_result_destroy(&r);
}

/* The root of the graph is that of the mode. */
static void test_roots_are_those_of_modes(void) {
  struct theory_result r = THEORY("roots", "a", "20", "eps", "0.3", "points", "2");
  struct wave_column tank = {.gravity = 1, .sound = sqrt(1 / 0.6), .depth = 1, .wavenumber = 6};
  struct wave_mode m = wave_mode_gravity(&tank);
  EXPECT_NEAR(value_of(&r, 0, "mu1") * 0.3, m.root, 1e-12);
  theory_result_destroy(&r);
}

/* Figures 2-7 to 2-9, tables 2.2 and 2.3: what they state, kappa = 2 pi, n = 10. */
static void test_profiles_of_the_tables(void) {
  double kappa = 2 * M_PI, nu = 10.5 * M_PI;
  struct theory_result r = THEORY("profiles", "points", "3");
  struct theory_result p = THEORY("profiles", "points", "3", "unit", "pressure");
  for (size_t k = 0; k < 3; k++) {
    double c = (double[]){1, 2, 5}[k], s = 1 / (c * c * nu);
    EXPECT_NEAR(value_of(&r, k, "u_surface"), sqrt(kappa), 1e-12); /* 2.506628 */
    EXPECT_NEAR(value_of(&r, k, "v_surface"), sqrt(kappa), 1e-12);
    EXPECT_NEAR(value_of(&r, k, "pressure_surface"), 1, 1e-12);
    EXPECT_NEAR(value_of(&r, k + 3, "u_surface"), kappa / (c * nu), 1e-12);
    EXPECT_NEAR(value_of(&r, k + 3, "v_surface"), c * nu, 1e-10);
    EXPECT_NEAR(value_of(&r, k + 3, "pressure_surface"), 1, 1e-12);
    EXPECT_NEAR(value_of(&r, k + 3, "u_most"), c * kappa * hypot(1, s), 1e-11);
    EXPECT_NEAR(value_of(&r, k + 3, "pressure_most"), c * c * nu * hypot(1, s), 1e-10);
    EXPECT_NEAR(value_of(&p, k, "eta"), 1, 1e-12);
    EXPECT_NEAR(value_of(&p, k + 3, "eta"), 1 / (c * c * nu), 1e-14); /* not 1/(c nu) */
    EXPECT_NEAR(value_of(&p, k + 3, "u_surface"), kappa / (c * nu) * s, 1e-13);
    /* (2.70)-(2.72) and (2.74)-(2.77); delta = 1/(2 c^2) */
    double delta = 1 / (2 * c * c), g = 2 * c * c * delta;
    EXPECT_NEAR(value_of(&r, k, "u_surface") / value_of(&r, k + 3, "u_surface"),
                c * nu / sqrt(g * kappa), 1e-9);
    EXPECT_NEAR(value_of(&r, k, "v_surface") / value_of(&r, k + 3, "v_surface"),
                sqrt(g * kappa) / (c * nu), 1e-12);
    EXPECT_NEAR(value_of(&p, k, "eta") / value_of(&p, k + 3, "eta"), nu / (2 * delta), 1e-8);
    EXPECT_NEAR(value_of(&p, k, "u_surface") / value_of(&p, k + 3, "u_surface") /
                    sqrt(pow(nu, 4) / (8 * pow(delta, 3) * kappa)),
                1, 1e-12);
  }
  theory_result_destroy(&r);
  theory_result_destroy(&p);
}

/* Exact over tables, c = 5 and 1: v and u at the surface, largest u and pressure. */
static void test_profiles_of_exact_modes(void) {
  static const double ratio[2][4] = {{1.01800, 0.98232, 1.01701, 1.03531},
                                     {1.01851, 0.98183, 0.99333, 1.01172}};
  static const char *const key[] = {"v_surface", "u_surface", "u_most", "pressure_most"};
  struct theory_result r =
      THEORY("profiles", "mode", "10", "sound", "5, 1", "layer", "table, exact", "points", "2");
  for (size_t c = 0; c < 2; c++)
    for (size_t k = 0; k < 4; k++)
      EXPECT_NEAR(value_of(&r, 2 * c + 1, key[k]) / value_of(&r, 2 * c, key[k]), ratio[c][k], 1e-5);
  theory_result_destroy(&r);
}

/* The largest amplitudes are those of the columns, but for what lies between two points, (nu h)^2/8
 * of the largest: also where the first antinode lies below the bed (mode 0), and of sound so slow
 * or waves so short that psi(0) is no longer small. */
static void test_largest_amplitudes_are_those_of_the_columns(void) {
  static const char *const sound[] = {"5", "100", "0.72", "0.75", "5"};
  static const char *const kappa[] = {"6.283185307179586", "0.5", "30", "2", "1000"};
  static const char *const key[][2] = {{"u", "u_most"}, {"pressure", "pressure_most"}};
  for (size_t k = 0; k < 5; k++) {
    struct theory_result r =
        THEORY("profiles", "mode", "-1, 0, 1, 2, 3, 10", "layer", "table, exact", "unit",
               "potential, elevation", "sound", sound[k], "kappa", kappa[k], "points", "4001");
    EXPECT(r.n == 24);
    for (size_t c = 0; c < r.n; c++)
      for (size_t q = 0; q < 2; q++) {
        const double most = value_of(&r, c, key[q][1]);
        double column = 0;
        for (size_t i = 0; i < 4001; i++) column = fmax(column, fabs(cell_of(&r, c, i, key[q][0])));
        EXPECT(column > 0 && column <= most * (1 + 1e-12));
        EXPECT_NEAR(column / most, 1, pow(11 * M_PI / 4000, 2) / 8);
      }
    theory_result_destroy(&r);
  }
}

/* Table 2.1: u and v are the gradient of the potential; tables 2.2 and 2.3 are its limit, the error
 * below kappa^2/nu^2 + 2 delta H. */
static void test_table_2_1_and_its_limits(void) {
  struct theory_result r = THEORY("profiles", "mode", "-1, 60", "sound", "8", "layer", "exact",
                                  "unit", "potential", "points", "20001");
  double h = 1. / 20000;
  for (size_t c = 0; c < 2; c++)
    for (size_t i = 1; i < 20000; i += 997) { /* differences: h^2 psi'''/6 */
      double rise = (cell_of(&r, c, i + 1, "u") - cell_of(&r, c, i - 1, "u")) / (2 * h);
      EXPECT_NEAR(rise / (2 * M_PI), cell_of(&r, c, i, "v"),
                  c ? 190 * 190 * 190 * h * h / 5 : 1e-6);
    }
  theory_result_destroy(&r);
  r = THEORY("profiles", "mode", "60", "sound", "8", "layer", "table, exact", "unit",
             "elevation, pressure", "points", "101");
  double nu = 60.5 * 2 * M_PI / 2, bound = pow(2 * M_PI / nu, 2) + 1. / 64;
  for (size_t unit = 0; unit < 2; unit++)
    for (size_t k = 1; k < 4; k++) {
      static const char *const key[] = {"", "u", "v", "pressure"};
      double far = 0, size = 0;
      for (size_t i = 0; i < 101; i++) {
        double table = cell_of(&r, 2 * unit, i, key[k]);
        double exact = cell_of(&r, 2 * unit + 1, i, key[k]);
        far = fmax(far, fabs(table - exact));
        size = fmax(size, fabs(table));
      }
      EXPECT(far < bound * size);
    }
  theory_result_destroy(&r);
}

/* Figures 2-14 to 2-18: beta = 10, h = 0.01. */
static void test_acoustic_modes_follow_the_lattice(void) {
  static const struct {
    size_t n;
    double omega, period, lattice, lattice_period;
  } of[] = {{0, 20.481, 0.30678, 20.466, 0.30700},
            {10, 106.189, 0.05917, 104.344, 0.06022},
            {15, 155.263, 0.04047, 149.554, 0.04201},
            {20, 204.626, 0.03071, 191.697, 0.03278},
            {40, 402.841, 0.01560, 310.561, 0.02023}};
  struct theory_result r = THEORY("acoustic", NULL);
  for (size_t i = 0; i < 5; i++) {
    EXPECT_NEAR(cell_of(&r, 0, of[i].n, "omega_leading"), of[i].omega, 5e-4);
    EXPECT_NEAR(cell_of(&r, 0, of[i].n, "period"), of[i].period, 6e-6);
    EXPECT_NEAR(cell_of(&r, 0, of[i].n, "omega_lattice"), of[i].lattice, 5e-4);
    EXPECT_NEAR(cell_of(&r, 0, of[i].n, "period_lattice"), of[i].lattice_period, 6e-6);
  }
  EXPECT_NEAR(fabs(cell_of(&r, 0, 20, "nu_first") - cell_of(&r, 0, 20, "nu")), 8.8e-9, 1e-10);
  theory_result_destroy(&r);
}

static void test_waves(void) {
  struct theory_result r =
      THEORY("waves", "beta", "10, 1e8", "from", "6.283185307179586", "to", "7", "points", "2");
  double airy = cell_of(&r, 0, 0, "airy"), deep = cell_of(&r, 0, 0, "deep");
  double ratio = cell_of(&r, 0, 0, "compressible") / deep;
  EXPECT_NEAR(deep, 2.506628, 5e-7);
  EXPECT_NEAR(airy / deep * airy / deep, 0.99999303, 5e-9);
  EXPECT_NEAR(ratio * ratio, 0.99999229, 5e-9);
  EXPECT_NEAR(cell_of(&r, 0, 0, "mu"), 6.2331857, 5e-8);
  EXPECT_NEAR(cell_of(&r, 1, 0, "shift"), 0, 1e-9);
  theory_result_destroy(&r);
}

static double square_of(double z, const void *with) { /* of a mode, weighted */
  const struct theory_mode *m = with;
  return exp(-2 * m->exact.delta * z) * pow(theory_mode_psi(m, z), 2);
}

/* Figure 2-20 and the tops of 2-22 and 2-23. */
static void test_orthogonality(void) {
  struct theory_result r = THEORY("orthogonality", "profile", "exact, deep");
  double kappa = 2 * M_PI;
  for (size_t n = 0; n <= 50; n++) {
    struct theory_mode m;
    EXPECT(cell_of(&r, 0, n, "share") < 1e-10);
    EXPECT_OK(theory_mode_find(10, kappa, (int)n, THEORY_DEEP, &m));
    double square = m.exact.omega * m.exact.omega;
    double law =
        exp(0.1) * square * theory_mode_psi(&m, -1) * kappa * exp(-kappa) / (square - kappa);
    EXPECT_NEAR(cell_of(&r, 1, n, "product") / fabs(law), 1, 1e-6);
    EXPECT_NEAR(cell_of(&r, 1, n, "closed") / fabs(law), 1, 1e-12);
    double norm = square * (pow(theory_mode_psi(&m, 0), 2) + theory_integral(square_of, &m) / 10);
    EXPECT_NEAR(theory_inner_product(&m, &m) / norm, 1, 1e-10);
    EXPECT_NEAR(cell_of(&r, 0, n, "own") / cell_of(&r, 0, n, "own_closed"), 1, 1e-10);
    EXPECT(isnan(cell_of(&r, 0, n, "closed")));
  }
  EXPECT_NEAR(cell_of(&r, 1, 0, "product"), 0.0125, 5e-5);
  EXPECT_NEAR(cell_of(&r, 1, 50, "product"), 0.01234, 5e-6);
  theory_result_destroy(&r);
  r = THEORY("orthogonality", "profile", "deep", "amplitude", "3.81e-5", "last", "0");
  EXPECT_NEAR(cell_of(&r, 0, 0, "product"), 4.7e-7, 1e-8); /* T's 1e-6 */
  theory_result_destroy(&r);
  r = THEORY("orthogonality", "mode", "20", "profile", "exact", "last", "30", "kappa",
             "6.283185307179586, 31.41592653589793");
  for (size_t c = 0; c < 2; c++)
    for (size_t n = 0; n <= 30; n++)
      if (n != 20) EXPECT(cell_of(&r, c, n, "product") < 1e-9);
  EXPECT_NEAR(value_of(&r, 0, "norm"), 2093.67, 5e-3);
  EXPECT_NEAR(value_of(&r, 1, "norm"), 2567.37, 5e-3);
  theory_result_destroy(&r);
  r = THEORY("orthogonality", "mode", "20", "profile", "leading", "last", "30");
  double most = 0;
  for (size_t n = 0; n <= 30; n++)
    if (n != 20) most = fmax(most, cell_of(&r, 0, n, "product"));
  EXPECT_NEAR(most, 0.049, 5e-4);
  theory_result_destroy(&r);
}

/* Figure 2-21. */
static void test_projection(void) {
  struct theory_result r = THEORY("projection", NULL);
  double kappa = 2 * M_PI, delta = 0.05;
  for (size_t n = 0; n <= 50; n++) {
    struct theory_mode m;
    EXPECT_OK(theory_mode_find(10, kappa, (int)n, THEORY_DEEP, &m));
    double bed = theory_mode_psi(&m, -1), square = m.exact.omega * m.exact.omega;
    double plain = (m.exact.s - exp(-kappa) * bed) / (1 - exp(-2 * kappa));
    double product = -exp(2 * delta) * square * bed * kappa * exp(-kappa) / (square - kappa);
    double norm = kappa * kappa * (1 - exp(-2 * (kappa - delta))) / (kappa - delta);
    EXPECT_NEAR(cell_of(&r, 0, n, "error") / fabs(plain), 1, 1e-6);
    EXPECT_NEAR(cell_of(&r, 0, n, "amplitude"), 2 + plain, 1e-10);
    EXPECT_NEAR(cell_of(&r, 1, n, "error") / fabs(product / norm), 1, 1e-6);
    EXPECT(cell_of(&r, 2, n, "error") < 1e-10);
    EXPECT_NEAR(cell_of(&r, 0, n, "closed") / fabs(plain), 1, 1e-12);
    EXPECT_NEAR(cell_of(&r, 1, n, "closed") / fabs(product / norm), 1, 1e-12);
    EXPECT(cell_of(&r, 2, n, "closed") == 0);
    for (size_t c = 0; c < 3; c++) EXPECT_NEAR(cell_of(&r, c, n, "own"), 1, 1e-13);
  }
  EXPECT_NEAR(value_of(&r, 0, "error_most"), 9.54e-3, 5e-6);
  EXPECT(value_of(&r, 0, "error_mode") == 2);
  EXPECT_NEAR(value_of(&r, 1, "error_most"), 1.95e-3, 5e-5);
  theory_result_destroy(&r);
}

/* (2.85) and (2.94) as they stand: modes without e^(delta y) are not orthogonal, and the filter
 * does not find e^(kappa y) alone: its integrals in closed form. */
static void test_what_is_printed_is_no_projection(void) {
  double kappa = 2 * M_PI, delta = 0.05, most = 0;
  struct theory_result r = THEORY("orthogonality", "profile", "printed");
  for (size_t n = 0; n <= 50; n++) most = fmax(most, cell_of(&r, 0, n, "product"));
  EXPECT(most > 0.05);
  theory_result_destroy(&r);
  r = THEORY("projection", "filter", "printed", "last", "0");
  double wide = 2 * kappa - 3 * delta, narrow = 2 * (kappa - 2 * delta);
  double above = (2 * kappa - delta) * kappa * (1 - exp(-wide)) / wide;
  double below =
      (2 * kappa * kappa - 2 * kappa * delta + delta * delta) * (1 - exp(-narrow)) / narrow;
  EXPECT_NEAR(cell_of(&r, 0, 0, "own"), above / below, 1e-10);
  theory_result_destroy(&r);
}

/* Figures 2-22 and 2-23, bottom. */
static void test_filter(void) {
  struct theory_result r = THEORY("filter", "kappa", "6.283185307179586, 31.41592653589793");
  EXPECT_NEAR(value_of(&r, 0, "amplitude_reduced"), 1.003314, 1e-6);
  EXPECT_NEAR(value_of(&r, 1, "amplitude_reduced"), 1.001254, 1e-6);
  for (size_t c = 0; c < 2; c++) {
    double k = c ? 10 * M_PI : 2 * M_PI;
    double leak = 2. / 3 * (1 - exp(-3 * k)) / (1 - exp(-2 * k));
    EXPECT_NEAR(value_of(&r, c, "amplitude") - value_of(&r, c, "amplitude_reduced"), leak, 1e-10);
    EXPECT_NEAR(leak, 0.66667, 1e-5);
  }
  theory_result_destroy(&r);
}

/* Sound so slow that a second mode decays, eps >= eps_o = 1.08333 with a = 5. */
static void test_slow_sound_is_refused(void) {
  struct wave_column tank;
  EXPECT_OK(theory_tank(1 / (2 * 1.0833), 5 * 1.0833, &tank));
  EXPECT(theory_tank(1 / (2 * 1.0834), 5 * 1.0834, &tank) == ERR_USAGE);
  EXPECT(strstr(status_message(), "below which two modes decay"));
}

/* Errors of the first two rows at h = 1/16, 1/32, 1/64 in u, v, p_d, a_x, a_y, of another program,
 * to its digits and where projections fall; the frequency of u of the first row; and growth at 1/16
 * and 1/32. */
static void test_hsph(void) {
  static const char *const key[] = {"u", "v", "p", "a_x", "a_y"};
  static const double error[3][2][5] = {
      {{.23, .17, .18, .29, .51}, {.14, .15, .29, .23, .38}},
      {{.066, .042, .043, .11, .16}, {.034, .037, .052, .047, .12}},
      {{.018, .011, .011, .051, .053}, {.010, .011, .012, .011, .036}}};
  static const double frequency[] = {0.977, 0.9944, 0.9985}, growth[] = {2.1, 3.1};
  static const double waves[] = {7, 13};
  struct theory_result r = THEORY("hsph", "rows", "16, 32, 64", "radius", "1.5");
  for (size_t c = 0; c < 3; c++) {
    for (size_t row = 0; row < 2; row++)
      for (size_t q = 0; q < 5; q++)
        EXPECT_NEAR(cell_of(&r, c, row, key[q]) / error[c][row][q], 1, 0.06);
    EXPECT_NEAR(value_of(&r, c, "fitted"), frequency[c], 3e-4);
    if (c == 2) continue;
    EXPECT_NEAR(value_of(&r, c, "growth"), growth[c], 0.05);
    EXPECT(value_of(&r, c, "waves") == waves[c]);
  }
  theory_result_destroy(&r);
  /* a support of 3 h on a surface that is kept: of u on the first row, as docs/theory.md has it */
  r = THEORY("hsph", "rows", "16, 32", "radius", "3");
  EXPECT_NEAR(cell_of(&r, 0, 0, "u"), 0.860, 1e-3);
  EXPECT_NEAR(cell_of(&r, 1, 0, "u"), 0.390, 1e-3);
  theory_result_destroy(&r);
  r = THEORY("hsph", "surface", "natural", "every", "0, 15"); /* neither support carries a wave */
  EXPECT(r.n == 4);
  for (size_t c = 0; c < r.n; c++) EXPECT(cell_of(&r, c, 0, "u") > 1);
  theory_result_destroy(&r);
  r = THEORY("hsph", "rows", "8", "surface", "kept, natural", "every", "0", "periods", "20",
             "waves", "0");
  EXPECT_NEAR(value_of(&r, 0, "fitted"), value_of(&r, 0, "frequency"), 0.05);
  EXPECT(fabs(value_of(&r, 1, "frequency")) < 0.01 && isnan(value_of(&r, 1, "fitted")));
  theory_result_destroy(&r);
}

int main(void) {
  RUN(test_roots_of_shallow_water);
  RUN(test_roots_of_deep_water);
  RUN(test_roots_are_those_of_modes);
  RUN(test_profiles_of_the_tables);
  RUN(test_profiles_of_exact_modes);
  RUN(test_largest_amplitudes_are_those_of_the_columns);
  RUN(test_table_2_1_and_its_limits);
  RUN(test_acoustic_modes_follow_the_lattice);
  RUN(test_waves);
  RUN(test_hsph);
  RUN(test_orthogonality);
  RUN(test_projection);
  RUN(test_what_is_printed_is_no_projection);
  RUN(test_filter);
  RUN(test_slow_sound_is_refused);
  return TEST_RESULT;
}

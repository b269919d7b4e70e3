/* The linearised columns of water at rest: what is neutral, frequencies, and a line of particles
 * that has the same fits. */
#include "sph/theory/column.h"

#include <lapack.h>

#include "tests/sph/pool.h"
#include "tests/test.h"

/* g = H = 1, c0^2 = beta; rows a spacing apart from dx/2 up; the tensor kernel with h = dx unless
 * the forms have another. */
static struct case_file *column_case(int rows, int columns, double beta, const char *forms,
                                     const char *free_surface) {
  const double dx = 1. / rows, width = columns * dx;
  const bool below = !strcmp(free_surface, "natural"), smooth = strstr(forms, "kernel:");
  char head[600], run[400];
  snprintf(head, sizeof head,
           "title: column\nfluid: {density: 1, gravity: 1}\nscales: {H: 1}\n"
           "tank: {walls: [[[0, 2], [0, 0], [%.17g, 0], [%.17g, 2]]], sides: periodic}\n"
           "water: {wave: {kind: pressed, strength: 1e-30, wavelength: %.17g, decay: 0.25, depth: "
           "%.17g}}\n" POOL_TIMES,
           width, width, width, below ? 1 : 1 - dx / 2);
  snprintf(run, sizeof run,
           "resolution: %d, %s%s, free_surface: %s, walls: "
           "mirror-exponential, c0: %.17g, diffusion: none, alpha: 0, integrator: rk4, precision: "
           "double",
           rows, smooth ? "" : "kernel: tensor, h_over_dx: 1, ", forms, free_surface, sqrt(beta));
  return pool_case(head, run);
}

static struct sph_column *open_column(int rows, double beta, const char *forms) {
  struct case_file *c = column_case(rows, 9, beta, forms, "natural");
  struct sph *s = pool_create(c);
  struct sph_column *column = NULL;
  EXPECT_OK(sph_column_create(s, &column));
  sph_destroy(s);
  case_destroy(c);
  if (!column) exit(1);
  return column;
}

static void open_spectrum(const struct sph_column *c, double turn, double **re, double **im) {
  const size_t n = 5 * sph_column_rows(c);
  *re = malloc(n * sizeof **re);
  *im = malloc(n * sizeof **im);
  EXPECT_OK(sph_column_spectrum(c, turn, *re, *im, NULL));
}

static double largest_growth(const struct sph_column *c, double turn) {
  double *re, *im, most = 0;
  open_spectrum(c, turn, &re, &im);
  for (size_t k = 0; k < 5 * sph_column_rows(c); k++) most = fmax(most, re[k]);
  free(re);
  free(im);
  return most;
}

/* Adjoint sums keep the energy of disturbances about rest, so that squares of eigenvalues are real;
 * in these columns none is positive. Those of rows that shift along themselves are double zeros;
 * moving particles by 1e-5 dx across the jumps of the spline's slopes makes errors of 1e-5 p/(rho
 * dx^2) in the squares. */
static void test_adjoint_forms_are_neutral(void) {
  static const struct {
    const char *forms;
    bool neutral;
  } pairs[] = {{"momentum: mass, continuity: mass", true},
               {"momentum: neighbour, continuity: absolute", true},
               {"momentum: plus, continuity: divergence", true},
               {"momentum: mass, continuity: absolute", false},
               {"momentum: neighbour, continuity: mass", false}};
  const int rows = 20;
  const double shifts = sqrt(1e-5) * rows;
  for (size_t p = 0; p < sizeof pairs / sizeof *pairs; p++) {
    struct sph_column *c = open_column(rows, 40, pairs[p].forms);
    double most = 0;
    EXPECT(largest_growth(c, 0) < shifts);
    for (int i = 1; i <= 10; i++) most = fmax(most, largest_growth(c, M_PI * i / 10));
    if (pairs[p].neutral)
      EXPECT(most < shifts);
    else
      EXPECT(most > 30 * shifts);
    sph_column_destroy(c);
  }
}

/* The law of the lattice of sound between bed and surface, nu = (n + 1/2) pi/H, at mid-depth: by
 * 0.5 %; by 0.3 % of n = 40, whose neighbours are 1.1 % away. */
static void test_sound_has_the_frequencies_of_the_lattice(void) {
  const int rows = 100;
  const double h = 1. / rows, beta = 10, kh = 2 * M_PI * h, c0 = sqrt(beta);
  struct sph_column *c = open_column(rows, beta, "momentum: mass, continuity: mass");
  double *re, *im;
  open_spectrum(c, kh, &re, &im);
  static const int modes[] = {0, 10, 15, 20, 40};
  for (size_t m = 0; m < sizeof modes / sizeof *modes; m++) {
    const double nu = (modes[m] + 0.5) * M_PI * h;
    const double along = sin(nu) * (1 - 2. / 3 * pow(sin(kh / 2), 2));
    const double across = sin(kh) * (1 - 2. / 3 * pow(sin(nu / 2), 2));
    const double law =
        c0 / h * sqrt(along * along + across * across + 8 / (2 * beta) * pow(sin(nu / 2), 4));
    double nearest = 0;
    for (size_t k = 0; k < 5 * (size_t)rows; k++)
      if (fabs(im[k] - law) < fabs(nearest - law)) nearest = im[k];
    printf("     n = %d: law %.3f, found %.3f\n", modes[m], law, nearest);
    EXPECT_NEAR(nearest / law, 1, modes[m] < 40 ? 0.005 : 0.003);
  }
  free(re);
  free(im);
  sph_column_destroy(c);
}

/* A first row on the surface starts with g/2, since the sums feel p = 0 half a spacing above it;
 * settled, adjoint sums are neutral there, too, and the others grow faster than at the start. Fits,
 * which let water stretch, do not come to rest. */
static void test_rows_settle(void) {
  static const char *const forms[] = {"momentum: mass, continuity: mass",
                                      "momentum: mass, continuity: absolute",
                                      "derivative: mls, momentum: minus"};
  const int rows = 20;
  for (int f = 0; f < 3; f++) {
    struct case_file *c = column_case(rows, 9, 40, forms[f], "level");
    struct sph *s = pool_create(c);
    struct sph_column *start = NULL, *settled = NULL;
    EXPECT_OK(sph_column_create(s, &start));
    EXPECT((sph_column_settle(s, 1e-6) == OK) == (f < 2));
    EXPECT_OK(sph_column_create(s, &settled));
    if (!start || !settled) exit(1);
    const double before = largest_growth(start, M_PI), after = largest_growth(settled, M_PI);
    printf("     %s: growth at k dx = pi %.3f, settled %.3f sqrt(g/H)\n", forms[f], before, after);
    if (f < 2) {
      EXPECT_NEAR(sph_column_unrest(start), 0.5, 0.01);
      EXPECT(sph_column_unrest(settled) <= 1e-6);
    }
    if (f == 0) EXPECT(before > 1 && after < sqrt(1e-5) * rows);
    if (f == 1) EXPECT(after > 2 * before);
    sph_column_destroy(start);
    sph_column_destroy(settled);
    sph_destroy(s);
    case_destroy(c);
  }
}

/* How many columns or rows away a particle that has moved by 1e-3 dx changes the rates of others,
 * by more than 1e-10 g: rounding of summed densities makes 3e-13. A support of 3.8 dx has
 * neighbours 3 columns away, so three supports 9. */
static int farthest_of(struct sph *s, int rows, int columns) {
  const size_t n = s->f.n;
  double *before = malloc(2 * n * sizeof *before);
  const double x = (columns / 2 + 0.5) * s->dx, y = (rows / 2 + 0.5) * s->dx;
  int most = 0;
  size_t moved = 0;
  EXPECT_OK(sph_rates(s, 0, true, false)); /* sorts */
  EXPECT_OK(sph_rates(s, 1, true, false));
  memcpy(before, s->f.k[1].u, n * sizeof *before);
  memcpy(before + n, s->f.k[1].v, n * sizeof *before);
  for (size_t i = 0; i < n; i++)
    if (hypot(s->f.w.x[i] - x, s->f.w.y[i] - y) < s->dx / 4) moved = i;
  s->f.w.x[moved] += 1e-3 * s->dx;
  s->f.w.y[moved] += 1e-3 * s->dx;
  sph_particles_pad(&s->f);
  EXPECT_OK(sph_rates(s, 1, true, false));
  for (size_t i = 0; i < n; i++) {
    if (hypot(s->f.k[1].u[i] - before[i], s->f.k[1].v[i] - before[n + i]) < 1e-10) continue;
    const double away = fmax(fabs(s->f.w.x[i] - x), fabs(s->f.w.y[i] - y));
    most = (int)fmax(most, round(away / s->dx));
  }
  free(before);
  return most;
}

static void test_no_rate_depends_on_what_lies_beyond_reach(void) {
  static const struct {
    const char *forms;
    int farthest, reach;
  } known[] = {{"kernel: cubic, h_over_dx: 1.9, momentum: mass, continuity: mass", 3, 4},
               {"kernel: cubic, h_over_dx: 1.9, momentum: mass, continuity: summation", 6, 8},
               {"kernel: cubic, h_over_dx: 1.9, momentum: mass, continuity: shepard", 9, 12}};
  const int rows = 20, columns = 27;
  for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
    struct case_file *c = column_case(rows, columns, 40, known[k].forms, "natural");
    struct sph *s = pool_create(c);
    struct sph_column *column = NULL;
    EXPECT_OK(sph_column_create(s, &column));
    if (!column) exit(1);
    const int farthest = farthest_of(s, rows, columns);
    printf("     %s: %d spacings away\n", known[k].forms, farthest);
    EXPECT(farthest == known[k].farthest);
    EXPECT((int)sph_column_reach(column) == known[k].reach);
    sph_column_destroy(column);
    sph_destroy(s);
    case_destroy(c);
  }
}

/* ---- a line of particles ---- */

enum { ROWS = 50, MOVING = 3 * ROWS };
static const double beta = 40, spacing = 1. / ROWS;

/* Rates of heights, velocities and densities of rows that do not vary along the tank, by the slopes
 * of lines fitted to the rows within 1.5 spacings, of which the three columns there have as many
 * particles as are within that of one; images below the bed by dp/dy = -rho g. */
static void line_rates(const double *s, double *rate) {
  const double *y = s, *v = s + ROWS, *rho = s + 2 * ROWS, radius = 1.5 * spacing;
  for (int i = 0; i < ROWS; i++) {
    double n = 0, t = 0, tt = 0, p = 0, tp = 0, w = 0, tw = 0;
    for (int j = -ROWS; j < ROWS; j++) {
      const int k = j < 0 ? -j - 1 : j;
      const double below = j < 0 ? -1 : 1;
      const double away = below * y[k] - y[i];
      if (fabs(away) >= radius) continue;
      const double density = rho[k] * (j < 0 ? exp(2 * y[k] / beta) : 1);
      double count = 0;
      for (int column = -1; column <= 1; column++) count += hypot(away, column * spacing) < radius;
      n += count;
      t += count * away;
      tt += count * away * away;
      p += count * beta * (density - 1);
      tp += count * away * beta * (density - 1);
      w += count * below * v[k];
      tw += count * away * below * v[k];
    }
    const double spread = fmax(n * tt - t * t, 1e-9 * radius * radius); /* alone, it falls */
    rate[i] = v[i];
    rate[ROWS + i] = -(n * tp - t * p) / spread / rho[i] - 1;
    rate[2 * ROWS + i] = -rho[i] * (n * tw - t * w) / spread;
  }
}

static void line_start(double *s) {
  for (int i = 0; i < ROWS; i++) {
    s[i] = (i + 0.5) * spacing;
    s[ROWS + i] = 0;
    s[2 * ROWS + i] = exp((1 - spacing / 2 - s[i]) / beta);
  }
}

static void line_step(double *s, double dt) {
  static const double ahead[] = {0, 0.5, 0.5, 1}, weight[] = {1, 2, 2, 1};
  double k[4][MOVING], moved[MOVING];
  for (int stage = 0; stage < 4; stage++) {
    for (int q = 0; q < MOVING; q++)
      moved[q] = s[q] + (stage ? ahead[stage] * dt * k[stage - 1][q] : 0);
    line_rates(moved, k[stage]);
  }
  for (int stage = 0; stage < 4; stage++)
    for (int q = 0; q < MOVING; q++) s[q] += weight[stage] / 6 * dt * k[stage][q];
}

static double line_growth(void) {
  double s[MOVING], high[MOVING], low[MOVING], M[MOVING * MOVING], re[MOVING], im[MOVING];
  double work[8 * MOVING], most = 0;
  const lapack_int n = MOVING, one = 1, room = 8 * MOVING;
  lapack_int info;
  line_start(s);
  for (int b = 0; b < MOVING; b++) {
    const double by = 1e-6, at = s[b];
    s[b] = at + by;
    line_rates(s, high);
    s[b] = at - by;
    line_rates(s, low);
    s[b] = at;
    for (int a = 0; a < MOVING; a++) M[b * MOVING + a] = (high[a] - low[a]) / (2 * by);
  }
  LAPACK_dgeev("N", "N", &n, M, &n, re, im, NULL, &one, NULL, &one, work, &room, &info);
  EXPECT(info == 0);
  for (int k = 0; k < MOVING; k++) most = fmax(most, re[k]);
  return most;
}

static struct sph *open_fitted_column(struct case_file **c) {
  *c = column_case(ROWS, 9, beta, "derivative: mls, momentum: minus", "level");
  return pool_create(*c);
}

/* No condition holds the surface of water whose slopes are fitted: it stretches. While nothing
 * varies along the tank its rows are such a line, whose growth is that of the columns and whose
 * heights, at t = 1, are theirs. */
static void test_fitted_slopes_let_the_column_stretch(void) {
  struct case_file *c;
  struct sph *s = open_fitted_column(&c);
  struct sph_column *column = NULL;
  double line[MOVING], off = 0;
  const int steps = 600;
  EXPECT_OK(sph_column_create(s, &column));
  if (!column) exit(1);
  const double growth = largest_growth(column, 0), of_line = line_growth();
  EXPECT_NEAR(growth, of_line, 1e-4);
  sph_column_destroy(column);
  line_start(line);
  for (int k = 0; k < steps; k++) {
    EXPECT_OK(sph_rates(s, 0, true, true));
    EXPECT_OK(sph_step(s, 1. / steps));
    line_step(line, 1. / steps);
  }
  EXPECT(line[ROWS - 1] - (1 - spacing / 2) > spacing / 2);
  for (size_t i = 0; i < s->f.n; i++) {
    double near = INFINITY;
    for (int j = 0; j < ROWS; j++) near = fmin(near, fabs(s->f.w.y[i] - line[j]));
    off = fmax(off, near);
  }
  printf("     growth %.5f, of the line %.5f sqrt(g/H); rows are %.1e dx off it\n", growth, of_line,
         off / spacing);
  EXPECT(off < 1e-8 * spacing); /* rounding of pressures, 1e-16 (c0/dx)^2 g H, for a while */
  sph_destroy(s);
  case_destroy(c);
}

/* What the line does later, as the gallery's T 2-31 has it: how far the first row has risen at t =
 * 5.25, and when it has lost the others and falls. */
static void test_the_first_row_loses_the_others(void) {
  const double dt = 0.5 * spacing / sqrt(beta);
  double line[MOVING], rate[MOVING], t = 0, risen = 0;
  line_start(line);
  do {
    line_step(line, dt);
    t += dt;
    if (t < 5.25 + dt / 2) risen = line[ROWS - 1] - (1 - spacing / 2);
    line_rates(line, rate);
  } while (t < 10 && rate[2 * ROWS - 1] > -0.5);
  printf("     risen by %.4f H at t = 5.25; falls from t = %.3f\n", risen, t);
  EXPECT_NEAR(risen, 0.3610, 2e-4);
  EXPECT_NEAR(t, 6.035, 5e-3);
}

/* ---- what is refused ---- */

static void test_columns_that_are_not_alike_are_refused(void) {
  struct case_file *c = column_case(8, 9, 40, "momentum: mass, continuity: mass", "natural");
  struct sph *s = pool_create(c);
  struct sph_column *column;
  s->f.w.y[11] += 1e-3 * s->dx;
  EXPECT(sph_column_create(s, &column) == ERR_INPUT);
  sph_destroy(s);
  case_destroy(c);
  c = column_case(8, 9, 40, "momentum: mass, continuity: mass", "natural");
  s = pool_create(c);
  s->scheme.diffusion = SPH_DIFFUSION_antuono; /* sees two supports far */
  EXPECT(sph_column_create(s, &column) == ERR_INPUT);
  sph_destroy(s);
  case_destroy(c);
}

static void test_rates_that_are_not_finite_are_refused(void) {
  struct case_file *c = column_case(8, 9, 40, "momentum: mass, continuity: mass", "natural");
  struct sph *s = pool_create(c);
  struct sph_column *column;
  s->f.w.rho[11] = NAN;
  sph_particles_pad(&s->f);
  EXPECT(sph_column_create(s, &column) == ERR_SOLVER);
  EXPECT(strstr(status_message(), "not finite"));
  EXPECT(sph_column_settle(s, 1e-6) == ERR_SOLVER); /* NaN is no rest */
  sph_destroy(s);
  case_destroy(c);
}

int main(void) {
  RUN(test_adjoint_forms_are_neutral);
  RUN(test_sound_has_the_frequencies_of_the_lattice);
  RUN(test_rows_settle);
  RUN(test_no_rate_depends_on_what_lies_beyond_reach);
  RUN(test_fitted_slopes_let_the_column_stretch);
  RUN(test_the_first_row_loses_the_others);
  RUN(test_columns_that_are_not_alike_are_refused);
  RUN(test_rates_that_are_not_finite_are_refused);
  return TEST_RESULT;
}

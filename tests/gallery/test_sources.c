/* Curves of results whose particles, surfaces and events are known functions, and of other curves.
 */
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/result/result.h"
#include "gallery/desk.h"
#include "gallery/sources/water.h"
#include "tests/test.h"

static const double H = 2.385, G = 9.81, RHO = 998.2, C2 = 25; /* c0^2/(g H) */
enum { NX = 30, NY = 10, N = NX * NY, OUTPUTS = 21, POINTS = 121 };

static char folder[] = "/tmp/plunge-sources-XXXXXX", path[128];

/* ---- what is written, in H and sqrt(H/g) ---- */

struct options {
  double c0;
};
static const struct param options_table[] = {{.key = "c0",
                                              .type = PARAM_REAL,
                                              .quantity = QTY_VELOCITY,
                                              .min = 0,
                                              .max = 1e9,
                                              .value = "1",
                                              .help = "speed of sound"}};

static double time_of(size_t k) {
  return 0.1 * (double)k;
}
static double shift(double t) { /* along x, of all */
  return 0.03 * sin(t);
}
static const double K = 4 * M_PI / 3; /* two waves along a row */
static double u_of(double X, double Y, double t) {
  return Y * cos(K * X - 2 * t);
}
static double dynamic_of(double Y, double t) {
  return 0.1 * Y * cos(2 * t);
}
static double surface_of(double x, double t) {
  return 1 + 0.1 * cos(M_PI * x) * cos(t);
}
static double front_of(double t) {
  return 1 + 0.5 * t;
}

static struct geo_lines box, none;
static struct case_probe probe = {.name = "P", .x = 3 * 2.385, .y = 0.5};
static double measured_t[] = {0, 1}, measured_p[] = {0, 500};
static struct case_experiment measured = {.label = "sensor 1",
                                          .source = "nobody",
                                          .target = "P",
                                          .n = 2,
                                          .t = measured_t,
                                          .value = measured_p};

static struct result *begin(const char *name, bool sound) {
  static struct options options;
  struct result *r = NULL;
  options.c0 = sqrt(C2 * G * H);
  const struct result_about about = {.solver = "test",
                                     .run = name,
                                     .title = "known",
                                     .version = "",
                                     .revision = "",
                                     .case_text = "",
                                     .fingerprint = "",
                                     .water_fingerprint = "",
                                     .H = H,
                                     .g = G,
                                     .density = RHO,
                                     .resolution = NY,
                                     .rest_potential = 0,
                                     .walls = strcmp(name, "bare") ? &box : &none,
                                     .n_probes = 1,
                                     .probes = &probe,
                                     .params = options_table,
                                     .n_params = sound ? 1 : 0,
                                     .options = &options,
                                     .n_experiments = 1,
                                     .experiments = &measured};
  char where[100];
  snprintf(where, sizeof where, "%s/c", folder);
  mkdir(where, 0700);
  snprintf(path, sizeof path, "%s/%s.h5", where, name);
  EXPECT_OK(result_begin(path, &about, &r));
  if (!r) exit(1);
  return r;
}

static void add_line(struct geo_lines *l, size_t n, const double (*p)[2]) {
  EXPECT_OK(geo_lines_begin(l, false));
  for (size_t i = 0; i < n; i++) EXPECT_OK(geo_lines_add(l, p[i][0] * H, p[i][1] * H));
}

/* A lattice that shifts along x; the last particle is taken out after ten outputs of `lost`. */
static void write_particles(struct result *r, size_t k, bool lost) {
  static double x[N], y[N], p[N], rho[N], m[N], u[N], v[N], ax[N], ay[N];
  const double t = time_of(k), dx = H / NY;
  for (size_t i = 0; i < N; i++) {
    const double X = ((double)(i / NY) + 0.5) / NY, Y = ((double)(i % NY) + 0.5) / NY;
    x[i] = (X + shift(t)) * H;
    y[i] = Y * H;
    p[i] = RHO * G * H * (C2 * expm1(-(Y - 1) / C2) + dynamic_of(Y, t));
    rho[i] = RHO * (1 + 0.01 * Y);
    m[i] = RHO * dx * dx;
    u[i] = sqrt(G * H) * u_of(X, Y, t);
    v[i] = -sqrt(G * H) * 0.5 * t * X;
    ax[i] = G * Y * t;
    ay[i] = -G * X;
  }
  const struct result_field field[] = {{"pressure", "Pa", "", p, NULL},
                                       {"density", "kg/m^3", "", rho, NULL},
                                       {"mass", "kg/m", "", m, NULL},
                                       {"velocity", "m/s", "", u, v},
                                       {"acceleration", "m/s^2", "", ax, ay}};
  EXPECT_OK(result_points(r, t * sqrt(H / G), lost && k >= 10 ? N - 1 : N, x, y, RESULT_VERTICES, 5,
                          field));
}

/* A standing wave, with a drop above it that is no part of the main piece. */
static void wave(struct geo_lines *l, double t) {
  static double p[POINTS][2];
  for (size_t i = 0; i < POINTS; i++) {
    p[i][0] = 3 * (double)i / (POINTS - 1);
    p[i][1] = surface_of(p[i][0], t);
  }
  add_line(l, POINTS, (const double(*)[2])p);
  EXPECT_OK(geo_lines_begin(l, true));
  const double drop[3][2] = {{1, 2}, {1.1, 2.1}, {1.2, 2}};
  for (int i = 0; i < 3; i++) EXPECT_OK(geo_lines_add(l, drop[i][0] * H, drop[i][1] * H));
}

static void flat(struct geo_lines *l, double t) {
  add_line(l, 2, (const double[][2]){{0, 1 + 0.05 * t}, {3, 1 + 0.05 * t}});
}

static void level(struct geo_lines *l, double t) {
  (void)t;
  add_line(l, 2, (const double[][2]){{0, 1}, {3, 1}});
}

/* A column whose face runs to the right, from t = 1 on with a jet. */
static void column(struct geo_lines *l, double t) {
  const double f = front_of(t);
  if (t < 0.95)
    add_line(l, 3, (const double[][2]){{0, 1.5}, {f, 1.5}, {f, 0}});
  else
    add_line(
        l, 6,
        (const double[][2]){{0, 1.8}, {1, 1.8}, {1 + 0.6 * t, 1.5}, {1, 1.2}, {1, 0.5}, {3, 0.5}});
}

static void write_run(const char *name, bool sound, bool particles, bool lost,
                      void (*surface)(struct geo_lines *l, double t)) {
  struct result *r = begin(name, sound);
  struct geo_lines l = {0};
  for (size_t k = 0; k < OUTPUTS; k++) {
    geo_lines_clear(&l);
    surface(&l, time_of(k));
    if (particles) write_particles(r, k, lost);
    EXPECT_OK(result_surface(r, time_of(k) * sqrt(H / G), &l));
    EXPECT_OK(result_flush(r));
  }
  EXPECT_OK(result_event(r, "wall_impact", 1.7 * sqrt(H / G), 0, 0.1 * H)); /* the left wall */
  EXPECT_OK(result_event(r, "wall_impact", 1.9 * sqrt(H / G), 3 * H, 0.2 * H));
  EXPECT_OK(result_event(r, "overflow", 0.7 * sqrt(H / G), 0, 3 * H));
  EXPECT_OK(result_statistic(r, "projections", 17, "1", "how often"));
  EXPECT_OK(result_finish(r));
  result_destroy(r);
  geo_lines_destroy(&l);
}

static void write_all(void) {
  EXPECT(mkdtemp(folder));
  EXPECT_OK(geo_lines_begin(&box, false));
  const double wall[4][2] = {{0, 3}, {0, 0}, {3, 0}, {3, 3}};
  for (int i = 0; i < 4; i++) EXPECT_OK(geo_lines_add(&box, wall[i][0] * H, wall[i][1] * H));
  write_run("known", true, true, false, wave);
  write_run("lost", true, true, true, wave);
  write_run("flat", false, true, false, flat);
  write_run("level", false, false, false, level);
  write_run("column", true, false, false, column);
  write_run("bare", true, false, false, column);
}

static void remove_all(void) {
  static const char *const runs[] = {"known", "lost", "flat", "level", "column", "bare"};
  char name[160];
  for (int i = 0; i < 6; i++) {
    snprintf(name, sizeof name, "%s/c/%s.h5", folder, runs[i]);
    unlink(name);
    snprintf(name, sizeof name, "%s/c/%s.xdmf", folder, runs[i]);
    unlink(name);
  }
  snprintf(name, sizeof name, "%s/c", folder);
  EXPECT(rmdir(name) == 0 && rmdir(folder) == 0);
  geo_lines_destroy(&box);
}

/* ---- entries that consist of curves ---- */

static struct gallery_book *book;
static struct gallery_desk *desk;

/* Each of the curves, up to NULL, is the inside of a mapping. */
static void open_desk(const char *const *curves) {
  static char text[8000];
  struct problems problems;
  size_t n = (size_t)snprintf(
      text, sizeof text,
      "cases:\n  - {name: c, file: dam-break.yaml}\nentries:\n  - id: P 1\n    title: t\n"
      "    where: w\n    kind: run\n    setup: s\n    curves:\n");
  for (size_t k = 0; curves[k]; k++)
    n += (size_t)snprintf(text + n, sizeof text - n, "      - {%s}\n", curves[k]);
  const struct gallery_file file = {"entries.yaml", text, strlen(text)};
  EXPECT_OK(gallery_book_read(1, &file, &problems, &book));
  for (size_t i = 0; i < problems.n; i++) fprintf(stderr, "%s\n", problems.text[i]);
  problems_destroy(&problems);
  if (!book) exit(1);
  EXPECT_OK(gallery_desk_create(book, folder, false, &desk));
  EXPECT_OK(gallery_desk_begin(desk, book->entries));
}

static void close_desk(void) {
  gallery_desk_destroy(desk);
  gallery_book_destroy(book);
  desk = NULL;
  book = NULL;
}

static double value(const char *formula) {
  double v = NAN;
  EXPECT_OK(gallery_desk_formula(desk, formula, &v));
  return v;
}

static void expect_failure(const char *curve, const char *why) {
  const struct gallery_curve *c;
  EXPECT(gallery_desk_curve(desk, curve, &c) == ERR_INPUT);
  if (!strstr(status_message(), why)) TEST_FAIL("the message is: %s", status_message());
}

/* To rounding: numbers of about 1 that have been multiplied by scales and back. */
static const double ROUNDING = 1e-12;

/* The particle at (1.25, 0.35): X and Y of it, by fields, at t = 1.3. */
static void test_one_particle(void) {
  static const char *const field[] = {"x",        "y",       "u",           "v",       "speed",
                                      "pressure", "dynamic", "excess",      "density", "mass",
                                      "a_x",      "a_y",     "acceleration"};
  enum { FIELDS = sizeof field / sizeof *field };
  const double X = 1.25, Y = 0.35, t = 1.3, u = u_of(X, Y, t), v = -0.5 * t * X;
  const double p = C2 * expm1(-(Y - 1) / C2) + dynamic_of(Y, t);
  const double expected[FIELDS] = {
      X + shift(t), Y,    u,     v,  hypot(u, v),    p, dynamic_of(Y, t), p + Y - 1,
      1 + 0.01 * Y, 0.01, Y * t, -X, hypot(Y * t, X)};
  static char text[FIELDS][100];
  const char *curves[FIELDS + 1] = {NULL};
  char formula[40];
  for (int i = 0; i < FIELDS; i++) {
    snprintf(text[i], sizeof *text,
             "name: c%d, from: particle, run: c/known, x: 1.26, y: 0.33, field: %s", i, field[i]);
    curves[i] = text[i];
  }
  open_desk(curves);
  for (int i = 0; i < FIELDS; i++) {
    snprintf(formula, sizeof formula, "at(\"c%d\", 1.3)", i);
    EXPECT_NEAR(value(formula), expected[i], ROUNDING);
    snprintf(formula, sizeof formula, "count(\"c%d\")", i);
    EXPECT(value(formula) == OUTPUTS);
  }
  close_desk();
}

static void test_times_start_and_loss(void) {
  static const char *const curves[] = {
      "name: some, from: particle, run: c/known, x: 0.05, y: 0.05, field: x, start: 0.3, to: 1.1, "
      "every: 2, less: start",
      "name: lost, from: particle, run: c/lost, x: 0.05, y: 0.05, field: y",
      "name: all, from: particles, run: c/lost, field: mass, take: count",
      "name: cut, from: cut, run: c/lost, of: row, x: 0, y: 0.05, field: y, at: 1.5, over: x",
      "name: still, from: particle, run: c/flat, x: 0, y: 0, field: excess",
      "name: silent, from: particle, run: c/flat, x: 0, y: 0, field: dynamic",
      "name: late, from: cut, run: c/known, of: all, field: u, at: 2.2, over: x",
      "name: never, from: particles, run: c/known, field: u, take: most, start: 3",
      "name: volume, from: particles, run: c/known, field: volume, take: sum",
      "name: dry, from: particles, run: c/level, field: u, take: most",
      NULL};
  open_desk(curves);
  EXPECT(value("count(\"some\")") == 4); /* 0.4, 0.6, 0.8, 1.0 */
  EXPECT_NEAR(value("first(\"some\")"), 0, 0);
  EXPECT_NEAR(value("at(\"some\", 1)"), shift(1) - shift(0.4), ROUNDING);
  EXPECT(value("count(\"lost\")") == OUTPUTS);
  EXPECT_NEAR(value("at(\"lost\", 0.9)"), 0.05, ROUNDING);
  EXPECT(isnan(value("at(\"lost\", 1)")));
  EXPECT(value("at(\"all\", 0.9)") == N && value("last(\"all\")") == N - 1);
  EXPECT_NEAR(value("at(\"still\", 1)"), C2 * expm1(0.95 / C2) - 0.95 + 0.005 * cos(2), ROUNDING);
  expect_failure("cut", "has lost particles by t = 1.5");
  expect_failure("silent", "has no speed of sound");
  expect_failure("late", "has no output near t = 2.2; the nearest is at 2");
  expect_failure("never", "has no output between t = 3 and 1e+09");
  expect_failure("volume", "has no dataset");
  expect_failure("dry", "has no particles");
  close_desk();
}

static void test_many_particles(void) {
  static const char *const curves[] = {
      "name: highest, from: particles, run: c/known, field: v, take: most",
      "name: deepest, from: particles, run: c/known, field: v, take: least",
      "name: largest, from: particles, run: c/known, field: v, take: largest",
      "name: mass, from: particles, run: c/known, field: mass, take: sum",
      "name: middle, from: particles, run: c/known, of: row, y: 0.44, x: 0.3, field: a_x, take: mean",
      "name: n, from: particles, run: c/known, of: column, y: 0.44, x: 0.3, field: a_x, take: "
      "count",
      "name: spread, from: particles, run: c/known, of: row, y: 0.44, field: u, take: rms",
      NULL};
  open_desk(curves);
  EXPECT_NEAR(value("last(\"highest\")"), -0.05, ROUNDING);
  EXPECT_NEAR(value("last(\"deepest\")"), -2.95, ROUNDING);
  EXPECT_NEAR(value("last(\"largest\")"), 2.95, ROUNDING);
  EXPECT_NEAR(value("last(\"mass\")"), 3, ROUNDING);
  EXPECT_NEAR(value("at(\"middle\", 1.5)"), 0.45 * 1.5, ROUNDING);
  EXPECT(value("last(\"n\")") == NY);
  EXPECT_NEAR(value("last(\"spread\")"), 0.45 / sqrt(2), ROUNDING); /* whole waves */
  close_desk();
}

/* Y cos(K (x - shift) - 2 t) has the amplitude Y and the phase 2 t + K shift. */
static void test_waves_along_a_row(void) {
  static char text[4][100];
  const char *curves[5] = {NULL};
  const double t = 0.7, phase = 2 * t + K * shift(t);
  static const char *const part[] = {"amplitude", "phase", "cos", "sin"};
  for (int i = 0; i < 4; i++) {
    snprintf(text[i], sizeof *text,
             "name: c%d, from: row, run: c/known, x: 1, y: 0.75, field: u, k: %.17g, take: %s", i,
             K, part[i]);
    curves[i] = text[i];
  }
  open_desk(curves);
  EXPECT_NEAR(value("at(\"c0\", 0.7)"), 0.75, ROUNDING);
  EXPECT_NEAR(value("at(\"c1\", 0.7)"), phase, ROUNDING);
  EXPECT_NEAR(value("at(\"c2\", 0.7)"), 0.75 * cos(phase), ROUNDING);
  EXPECT_NEAR(value("at(\"c3\", 0.7)"), 0.75 * sin(phase), ROUNDING);
  close_desk();
}

static void test_cuts(void) {
  static const char *const curves[] = {
      "name: column, from: cut, run: c/known, of: column, x: 1.25, y: 0, field: u, at: 0.52, over: "
      "y",
      "name: row, from: cut, run: c/known, of: row, x: 0, y: 0.95, field: v, at: 1, over: x",
      "name: all, from: cut, run: c/known, of: all, field: y, at: 0, over: y", NULL};
  open_desk(curves);
  EXPECT(value("count(\"column\")") == NY && value("count(\"row\")") == NX);
  EXPECT(value("count(\"all\")") == N);
  EXPECT_NEAR(value("at(\"column\", 0.45)"), u_of(1.25, 0.45, 0.5), ROUNDING);
  EXPECT_NEAR(value("slope(\"row\", 0, 3)"), -0.5, ROUNDING); /* v = -t X/2 */
  EXPECT_NEAR(value("integral(\"all\", 0, 1)"), (0.95 * 0.95 - 0.05 * 0.05) / 2, ROUNDING);
  close_desk();
}

static void test_surfaces(void) {
  static const char *const curves[] = {
      "name: s, from: surface, run: c/known, at: 0.81",
      "name: high, from: elevation, run: c/known, take: highest",
      "name: low, from: elevation, run: c/known, take: lowest, left: -0.01, right: 0.51",
      "name: middle, from: elevation, run: c/known, take: mean, left: 0, right: 2",
      "name: far, from: distance, run: c/flat, against: c/level",
      "name: near, from: distance, run: c/known, against: c/level, to: 0.5, left: 0.4, right: 0.6, "
      "bottom: 0.5, top: 1.5",
      "name: out, from: distance, run: c/flat, against: c/level, left: 5, right: 6",
      "name: late, from: surface, run: c/known, at: 2.3",
      NULL};
  open_desk(curves);
  EXPECT(value("count(\"s\")") == POINTS); /* without the drop */
  EXPECT_NEAR(value("at(\"s\", 0.5)"), 1, ROUNDING);
  EXPECT_NEAR(value("at(\"s\", 2)"), surface_of(2, 0.8), ROUNDING);
  EXPECT_NEAR(value("at(\"high\", 0.8)"), 1 + 0.1 * cos(0.8), ROUNDING);
  EXPECT_NEAR(value("at(\"low\", 0.8)"), 1, ROUNDING);
  EXPECT_NEAR(value("at(\"middle\", 0.8)"), 1, ROUNDING); /* a whole wave, by trapezia */
  EXPECT(value("count(\"far\")") == OUTPUTS);
  EXPECT_NEAR(value("at(\"far\", 1.6)"), 0.08, ROUNDING);
  EXPECT_NEAR(value("first(\"far\")"), 0, ROUNDING);
  /* heights of 0.031, 0.016, 0, 0.016 and 0.031; back, a slope of up to 0.1 pi shortens them by 5 %
   */
  EXPECT_NEAR(value("first(\"near\")"), 0.0182, 0.0004);
  EXPECT(value("count(\"near\")") == 6);
  EXPECT(isnan(value("last(\"out\")")));
  expect_failure("late", "has no surface near t = 2.3; its last is at 2");
  close_desk();
}

static void test_fronts_jets_and_events(void) {
  static const char *const curves[] = {
      "name: front, from: front, run: c/column",
      "name: tip_x, from: jet, run: c/column, take: x",
      "name: tip_y, from: jet, run: c/column, take: y",
      "name: overhang, from: jet, run: c/column, take: overhang",
      "name: gap, from: jet, run: c/column, take: gap",
      "name: impact, from: event, run: c/column, event: wall_impact",
      "name: impact_y, from: event, run: c/column, event: wall_impact, take: y",
      "name: over, from: event, run: c/column, event: overflow, take: y",
      "name: turn, from: event, run: c/column, event: overturning",
      "name: touch, from: event, run: c/column, event: touchdown",
      "name: steps, from: statistic, run: c/column, statistic: projections",
      "name: none, from: statistic, run: c/column, statistic: steps",
      "name: sensor, from: experiment, run: c/column, label: sensor 1",
      "name: bare, from: event, run: c/bare, event: touchdown",
      "name: sensors, from: experiment, run: c/column, label: sensor 2",
      NULL};
  open_desk(curves);
  EXPECT_NEAR(value("at(\"front\", 0.6)"), front_of(0.6), ROUNDING);
  EXPECT(isnan(value("at(\"tip_x\", 0.8)")));
  EXPECT_NEAR(value("at(\"tip_x\", 1.5)"), 1.9, ROUNDING);
  EXPECT_NEAR(value("at(\"tip_y\", 1.5)"), 1.5, ROUNDING);
  EXPECT_NEAR(value("at(\"overhang\", 1.5)"), 0.9, ROUNDING);
  EXPECT_NEAR(value("at(\"gap\", 1.5)"), sqrt(0.9), ROUNDING); /* from (1, 1.2) */
  EXPECT_NEAR(value("first(\"impact\")"), 1.9, ROUNDING); /* of the wall that the front runs to */
  EXPECT_NEAR(value("first(\"impact_y\")"), 0.2, ROUNDING);
  EXPECT_NEAR(value("first(\"over\")"), 3, ROUNDING);
  EXPECT(value("first(\"turn\")") < 1.01); /* at the latest when the first jet is seen */
  EXPECT(value("count(\"touch\")") == 0);
  EXPECT(value("first(\"steps\")") == 17);
  expect_failure("none", "has no statistic 'steps'");
  EXPECT_NEAR(value("last(\"sensor\")"), 500 / (RHO * G * H), ROUNDING);
  EXPECT_NEAR(value("crosses(\"sensor\", 0.5*last(\"sensor\"))"), 0.5 / sqrt(H / G), ROUNDING);
  expect_failure("bare", "run c/bare has no walls");
  expect_failure("sensors", "has no measured series 'sensor 2'");
  close_desk();
}

static void test_signals(void) {
  /* 400 samples of one period 2 pi: bins at whole numbers */
  static const char *const curves[] = {"name: wave, from: formula, y: '2*cos(7*x) + 0.3*cos(90*x) "
                                       "+ 5', to: 6.267477343911637, points: 400",
                                       "name: spectrum, from: spectrum, curve: wave",
                                       "name: half, from: spectrum, curve: wave, to: 3.14",
                                       "name: low, from: lowpass, curve: wave, period: 0.2",
                                       "name: square, from: formula, y: x^2, points: 31, to: 3",
                                       "name: rise, from: derivative, curve: square",
                                       "name: area, from: integral, curve: rise",
                                       "name: smooth, from: average, curve: rise, over: 0.55",
                                       "name: rest, from: highpass, curve: square, over: 0.6",
                                       "name: between, from: without, curve: square, period: 0.35",
                                       "name: back, from: formula, y: x, at: 0-x, points: 31",
                                       "name: wrong, from: derivative, curve: back",
                                       "name: few, from: spectrum, curve: square, to: 1",
                                       "name: itself, from: integral, curve: itself",
                                       NULL};
  open_desk(curves);
  EXPECT(value("count(\"spectrum\")") == 201);
  EXPECT_NEAR(value("at(\"spectrum\", 7)"), 2, 1e-11);
  EXPECT_NEAR(value("at(\"spectrum\", 90)"), 0.3, 1e-11);
  EXPECT_NEAR(value("at(\"spectrum\", 40)"), 0, 1e-11);
  EXPECT(value("beyond(\"spectrum\", 80)") < 0.03 && value("beyond(\"spectrum\", 80)") > 0.02);
  EXPECT(value("count(\"half\")") == 101); /* 0 to 3.1259: 200 rows */
  EXPECT_NEAR(value("slope(\"rise\", 0, 3)"), 2, 1e-11);
  EXPECT_NEAR(value("first(\"rise\")"), 0, 1e-11);
  EXPECT_NEAR(value("last(\"rise\")"), 6, 1e-11);
  EXPECT_NEAR(value("last(\"area\")"), 9, 1e-11);
  EXPECT_NEAR(value("at(\"smooth\", 1.5)"), 3, 1e-11);
  /* the mean of x^2 over 0.6 is 0.03 above it, of its chords 0.1 wide 1/600 more */
  EXPECT_NEAR(value("at(\"rest\", 1.5)"), -0.03 - 1. / 600, 1e-11);
  EXPECT(value("count(\"between\")") == 31 - 4); /* without 0.7, 1.4, 2.1 and 2.8 */
  EXPECT_NEAR(value("at(\"between\", 0.7)"), (0.36 + 0.64) / 2, 1e-11);
  EXPECT_NEAR(value("first(\"between\")"), 0, 1e-11);
  /* 90 is beyond 1.5 times 2 pi/0.2: nothing is left but for the ends, where the even continuation
   * has kinks */
  EXPECT_NEAR(value("amplitude(\"wave\", 90, 1, 5)"), 0.3, 0.03);
  EXPECT(value("amplitude(\"low\", 90, 1, 5)") < 0.03);
  EXPECT_NEAR(value("amplitude(\"low\", 7, 1, 5)"), 2, 0.02);
  expect_failure("wrong", "goes from x = 0 to -0.0333333; it must ascend");
  expect_failure("few", "there is no spectrum of curve 'square': 11 rows without a gap");
  expect_failure("itself", "needs itself");
  close_desk();
}

int main(void) {
  write_all();
  RUN(test_one_particle);
  RUN(test_times_start_and_loss);
  RUN(test_many_particles);
  RUN(test_waves_along_a_row);
  RUN(test_cuts);
  RUN(test_surfaces);
  RUN(test_fronts_jets_and_events);
  RUN(test_signals);
  remove_all();
  return TEST_RESULT;
}

/* Series at points in the water: against a wave that theory knows, against the pressure that a
 * column starts with, against probes where a point is on a wall; and what they have where it is
 * dry.
 */
#include <complex.h>

#include "common/flow/flow.h"
#include "common/flow/release.h"
#include "tests/bem/water.h"

static const struct result_point_read *point(const struct result_file *f, const char *name) {
  for (size_t k = 0; k < f->n_points; k++)
    if (!strcmp(f->points[k].name, name)) return &f->points[k];
  EXPECT(!"a series of the point");
  return NULL;
}

static double worse(double now, double off) {
  return isnan(off) || off > now ? off : now;
}

/* ---- a wave that theory knows ---- */

static const char waves[] = WATER_WAVE
    "fluid: {density: 1000, gravity: 9.81}\n"
    "time: {end: 1, every: 1, sample: 0.1}\n"
    "points: [{name: mid, at: [0.3, -0.2]}, {name: high, at: [2.9, 0.02]},\n"
    "         {name: edge, at: [4, -0.5]}, {name: bed, at: [1, -0.7]}, {name: air, at: [1, 1]}]\n"
    "runs: [{name: bem, solver: bem, resolution: %d}]\n";

/* What theory has at a point, of velocities in sqrt(gH) and of pressure in rho g H. */
static double off_theory(const struct flow_water *w, const struct result_point_read *p) {
  double worst = 0;
  for (size_t i = 0; i < p->n; i++) {
    double u[2];
    const double pressure = w->c->flow->pressure(w, p->x, p->y, p->t[i]);
    flow_velocity(w, p->x, p->y, p->t[i], u);
    worst = worse(worst, fabs(p->value[CASE_POINT_p][i] / 1000 - pressure) / 9.81);
    worst = worse(worst, hypot(p->value[CASE_POINT_u][i] - u[0], p->value[CASE_POINT_v][i] - u[1]) /
                             sqrt(9.81));
    EXPECT(p->value[CASE_POINT_cover][i] == 1 && p->value[CASE_POINT_rho][i] == 1000);
    EXPECT(isnan(p->value[CASE_POINT_a_x][i]) && isnan(p->value[CASE_POINT_a_y][i]));
  }
  return worst;
}

static void expect_dry(const struct result_point_read *p, size_t from, size_t to) {
  for (size_t i = from; i < to; i++) {
    EXPECT(p->value[CASE_POINT_cover][i] == 0);
    for (int k = 0; k < CASE_POINT_cover; k++) EXPECT(isnan(p->value[k][i]));
  }
}

static double worst_under_wave(int resolution) {
  static const char *const names[] = {"mid", "high", "edge", "bed"};
  char with[1200];
  struct flow_water w;
  double worst = 0;
  snprintf(with, sizeof with, waves, resolution);
  struct case_file *c = run_case(with);
  struct result_file *f = run_bem(with);
  if (!c || !f) return NAN;
  EXPECT_OK(flow_open(c, (struct flow_use){0}, &w));
  for (size_t k = 0; k < 4; k++) {
    const struct result_point_read *p = point(f, names[k]);
    EXPECT(p && p->n == 11 && p->n == f->n_energy);
    if (p) worst = worse(worst, off_theory(&w, p));
  }
  if (point(f, "air")) expect_dry(point(f, "air"), 0, 11);
  flow_close(&w);
  result_file_destroy(f);
  case_destroy(c);
  return worst;
}

/* The order is that of the integrals inside. */
static void test_points_have_what_theory_has_under_a_steady_wave(void) {
  const double coarse = worst_under_wave(10), fine = worst_under_wave(20);
  printf("     off by %.1e, %.1e of rho g H and sqrt(gH)\n", coarse, fine);
  EXPECT(fine < 1e-4 && log2(coarse / fine) > 3.3);
}

/* ---- a column ---- */

static const char column[] = WATER_COLUMN
    "time: {end: 2, every: 1, sample: 0.05}\n"
    "probes: [{name: bed, at: [1, 0]}, {name: side, at: [0, 0.3]}]\n"
    "gauges: [{name: falls, x: 1.4}, {name: comes, x: 3}]\n"
    "points: [{name: a, at: [1.4, 0.8]}, {name: b, at: [3, 0.1]}, {name: c, at: [0.7, 0.5]},\n"
    "         {name: d, at: [1, 0]}, {name: e, at: [0, 0.3]}, {name: f, at: [5.366, 1]}]\n"
    "runs: [{name: bem, solver: bem, resolution: 20}]\n";

/* In the water exactly where the gauge over it says so; how often it changes. */
static size_t follow_gauge(const struct result_point_read *p, const struct result_series *g) {
  size_t changes = 0;
  for (size_t i = 0; i < p->n; i++) {
    const bool wet = g->value[i] > p->y;
    EXPECT(p->value[CASE_POINT_cover][i] == wet && isfinite(p->value[CASE_POINT_p][i]) == wet);
    if (!wet) expect_dry(p, i, i + 1);
    changes += i > 0 && p->value[CASE_POINT_cover][i] != p->value[CASE_POINT_cover][i - 1];
  }
  return changes;
}

static double off_probe(const struct result_point_read *p, const struct result_series *probe) {
  double worst = 0;
  EXPECT(p->n == probe->n);
  for (size_t i = 0; i < p->n && p->n == probe->n; i++)
    worst = worse(worst, fabs(p->value[CASE_POINT_p][i] - probe->value[i]));
  return worst;
}

/* The corner of the column is cut off by its mesh, 0.03 H wide at most: 1e-4 are left of that. */
static void test_points_of_a_column_start_as_its_series_and_fall_dry(void) {
  struct result_file *f = run_bem(column);
  if (!f) return;
  const struct result_point_read *a = point(f, "a"), *b = point(f, "b"), *c = point(f, "c");
  const double off_a = fabs(a->value[CASE_POINT_p][0] - release_head(a->x, a->y, 2, 1)),
               off_c = fabs(c->value[CASE_POINT_p][0] - release_head(c->x, c->y, 2, 1)),
               bed = off_probe(point(f, "d"), &f->probes[0]),
               side = off_probe(point(f, "e"), &f->probes[1]);
  printf("     series off by %.1e, %.1e, walls by %.1e, %.1e rho g H\n", off_a, off_c, bed, side);
  EXPECT(off_a < 1e-4 && off_c < 1e-4 && bed < 1e-5 && side < 1e-5);
  EXPECT(follow_gauge(a, &f->gauges[0]) == 1 && follow_gauge(b, &f->gauges[1]) == 1);
  expect_dry(point(f, "f"), 0, a->n);
  result_file_destroy(f);
}

/* ---- any tank ---- */

/* A step, whose face is in line with points above and below, and a slope. */
static const char any[] =
    "title: tank\n"
    "fluid: {density: 1, gravity: 1}\n"
    "scales: {H: 1}\n"
    "tank:\n"
    "  walls: [[[0, 2], [0, 0], [2, 0], [2, 0.5], [4, 0.5], [5.5, 2]]]\n"
    "%s"
    "water: {wave: {kind: still, depth: 1}}\n"
    "time: {end: %g, every: 0.1}\n"
    "probes: [{name: face, at: [2, 0.3]}, {name: slope, at: [4.3, 0.8]}]\n"
    "points: [{name: a, at: [2, 0.3]}, {name: b, at: [4.3, 0.8]}, {name: c, at: [1, 0.2]},\n"
    "         {name: d, at: [3, 0.9]}, {name: e, at: [2, 0.7]}, {name: f, at: [5, 1.5]}]\n"
    "runs: [{name: bem, solver: bem, resolution: 14}]\n";

static struct result_file *in_any_tank(const char *motions, double end) {
  char with[1500];
  snprintf(with, sizeof with, any, motions, end);
  return run_bem(with);
}

static void test_still_water_is_so_at_points_of_any_tank(void) {
  struct result_file *f = in_any_tank("", 0.3);
  double worst = 0;
  if (!f) return;
  EXPECT(f->n_points == 6);
  for (size_t k = 0; k < f->n_points; k++) {
    const struct result_point_read *p = &f->points[k];
    EXPECT(p->n == f->n_energy && p->n > 30);
    if (p->y > 1) expect_dry(p, 0, p->n);
    for (size_t i = 0; i < p->n && p->y < 1; i++) {
      worst = worse(worst, fabs(p->value[CASE_POINT_p][i] - (1 - p->y)));
      worst = worse(worst, hypot(p->value[CASE_POINT_u][i], p->value[CASE_POINT_v][i]));
    }
  }
  printf("     off by %.1e\n", worst);
  EXPECT(worst < 1e-9);
  result_file_destroy(f);
}

/* Where both are, a point has the pressure of the probe, whose integrals are others. */
static void expect_probes(const char *motions, double end) {
  struct result_file *f = in_any_tank(motions, end);
  if (!f) return;
  const double face = off_probe(point(f, "a"), &f->probes[0]),
               slope = off_probe(point(f, "b"), &f->probes[1]);
  const struct result_point_read *c = point(f, "c");
  printf("     off by %.1e, %.1e rho g H\n", face, slope);
  EXPECT(face < 1e-4 && slope < 1e-4);
  EXPECT(fabs(c->value[CASE_POINT_u][c->n - 1]) > 1e-3); /* it moves */
  result_file_destroy(f);
}

static void test_points_on_walls_have_the_pressure_of_probes_in_tanks_that_move(void) {
  expect_probes("  motions: [{kind: sway, amplitude: 0.1, period: 3, ramp: 1}]\n", 1);
  expect_probes("  motions: [{kind: roll, amplitude: 0.05, period: 3, ramp: 1}]\n", 1);
  expect_probes("  motions: [{kind: piston, side: left, amplitude: 0.05, period: 3, ramp: 1}]\n",
                0.4);
}

/* ---- behind a side that moves ---- */

/* In both kinds of tanks: the piston passes the bed at 0.02 m, and carries what is on it. */
static void test_a_probe_behind_a_piston_reads_nothing(void) {
  static const struct {
    const char *top, *on;
  } side[] = {{"[0, 2]", "0, 0.25"}, {"[-1, 2]", "-0.125, 0.25"}};
  for (int k = 0; k < 2; k++) {
    char with[800];
    snprintf(
        with, sizeof with,
        "scales: {H: 1}\ntank: {walls: [[%s, [0, 0], [4, 0], [4, 2]]], motions: [{kind: "
        "piston, side: left, amplitude: 0.1, period: 3, ramp: 1}]}\n"
        "water: {wave: {kind: still, depth: 1}}\ntime: {end: 0.9, every: 0.3, sample: 0.1}\n"
        "probes: [{name: bed, at: [0.02, 0]}, {name: side, at: [%s]}, {name: far, at: [2, 0]}]\n"
        "runs: [{name: bem, solver: bem, resolution: 8}]\n",
        side[k].top, side[k].on);
    struct case_file *c = run_case(with);
    struct result_file *f = run_bem(with);
    if (!c || !f) continue;
    size_t behind = 0;
    for (size_t i = 0; i < f->probes[0].n; i++) {
      double q[3];
      tank_motion_at(&c->motions[0], f->probes[0].t[i], q);
      EXPECT(isnan(f->probes[0].value[i]) == (q[0] > 0.02));
      EXPECT(f->probes[1].value[i] > 6500 && f->probes[2].value[i] > 9000);
      behind += q[0] > 0.02;
    }
    EXPECT(behind > 1 && behind < f->probes[0].n - 1);
    result_file_destroy(f);
    case_destroy(c);
  }
}

int main(void) {
  RUN(test_points_have_what_theory_has_under_a_steady_wave);
  RUN(test_points_of_a_column_start_as_its_series_and_fall_dry);
  RUN(test_still_water_is_so_at_points_of_any_tank);
  RUN(test_points_on_walls_have_the_pressure_of_probes_in_tanks_that_move);
  RUN(test_a_probe_behind_a_piston_reads_nothing);
  return TEST_RESULT;
}

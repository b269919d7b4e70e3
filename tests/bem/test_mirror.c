/* A column at the right wall is the mirror image of the same column at the left one. */
#include <hdf5.h>

#include "common/base/gauge.h"
#include "tests/bem/run.h"

static const char text[] =
    "title: column\n"
    "fluid: {density: 1000, gravity: 9.81}\n"
    "scales: {H: 0.6}\n"
    "tank:\n"
    "  walls: [[[%g, 2], [%g, -0.1], [%g, -0.1], [%g, %g]]]\n"
    "  motions: [{kind: sway, amplitude: %g, period: 2, ramp: 1}]\n"
    "water: {regions: [[[%g, -0.1], [%g, -0.1], [%g, 0.5], [%g, 0.5]]], velocity: [%g, -0.05], "
    "pressure: "
    "released}\n"
    "time: {end: 1.6, every: 0.2, sample: 0.02}\n"
    "probes: [{name: P, at: [%g, 0.03], size: 0.05}, {name: bed, at: [%g, -0.1]}]\n"
    "gauges: [{name: G, x: %g}]\n"
    "points: [{name: in, at: [%g, 0.3]}, {name: ahead, at: [%g, 0.05]}]\n"
    "runs: [{name: bem, solver: bem, resolution: 14, forces: true, velocity_lattice: 0.06}]\n";

enum { LEFT = -2 };             /* x of the left wall, m */
static const double W = 3.2196; /* width of the tank, m */

/* way: 1, or -1 for the mirror image; places are counted from the wall that the column stands at.
 */
static double at(int way, double x) {
  return way > 0 ? LEFT + x : LEFT + W - x;
}

/* The points of all outputs and what they have, one after another. */
struct points {
  size_t n;
  double (*at)[3], (*velocity)[3]; /* [n], owned */
  double *pressure;                /* [n], owned */
};

static double *read_all(hid_t file, const char *name, size_t *n) {
  const hid_t set = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(set);
  *n = (size_t)H5Sget_simple_extent_npoints(space);
  double *all = calloc(*n, sizeof *all);
  EXPECT(all && H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, all) >= 0);
  H5Sclose(space);
  H5Dclose(set);
  return all;
}

static void read_points(const char *path, void *with) {
  struct points *p = with;
  size_t n[3] = {0};
  const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
  p->at = (double(*)[3])read_all(file, "/VTKHDF/Points", n);
  p->velocity = (double(*)[3])read_all(file, "/VTKHDF/PointData/velocity", n + 1);
  p->pressure = read_all(file, "/VTKHDF/PointData/pressure", n + 2);
  H5Fclose(file);
  p->n = n[2];
  EXPECT(n[0] == 3 * p->n && n[1] == 3 * p->n);
}

static void forget_points(struct points *p) {
  free(p->at);
  free(p->velocity);
  free(p->pressure);
}

static struct result_file *column(int way, struct points *points) {
  char with[2000];
  const double a = at(way, way > 0 ? 0 : 1.2), b = at(way, way > 0 ? 1.2 : 0);
  snprintf(with, sizeof with, text, at(1, 0), at(1, 0), at(1, W), at(1, W), 2., way * 0.02, a, b, b,
           a, way * 0.1, at(way, W), at(way, 0.5), at(way, 0.9), at(way, 0.7), at(way, 1.8));
  return run_bem_and(run_case(with), read_points, points);
}

static double middle = LEFT + W / 2; /* of the mirror that is looked into */

static double mirrored(double x) {
  return 2 * middle - x;
}

static double worst(double now, double a, double b, double size) {
  const double off = isnan(a) && isnan(b) ? 0 : fabs(a - b) / size;
  return off > now ? off : now;
}

static double worst_event(const struct result_file *a, const struct result_file *b) {
  double off = 0;
  EXPECT(a->n_events == b->n_events && a->n_events >= 3);
  for (size_t i = 0; i < a->n_events && i < b->n_events; i++) {
    const struct result_event_read *p = &a->events[i], *q = &b->events[i];
    EXPECT(!strcmp(p->name, q->name));
    off = worst(off, p->time, q->time, 1);
    off = worst(off, mirrored(p->x), q->x, 1);
    off = worst(off, p->y, q->y, 1);
  }
  return off;
}

static double worst_surface(const struct result_file *a, const struct result_file *b) {
  double off = 0;
  for (size_t k = 0; k < a->n_surfaces && k < b->n_surfaces; k++) {
    const struct geo_lines *p = &a->surface[k], *q = &b->surface[k];
    EXPECT(p->points == q->points);
    for (size_t i = 0; i < p->points && p->points == q->points; i++) {
      const size_t j = q->points - 1 - i;
      off = worst(off, mirrored(p->p[i][0]), q->p[j][0], 1);
      off = worst(off, p->p[i][1], q->p[j][1], 1);
    }
  }
  return off;
}

static const struct result_series *diagnostic(const struct result_file *f, const char *name) {
  for (size_t d = 0; d < f->n_diagnostics; d++)
    if (!strcmp(f->diagnostics[d].name, name)) return &f->diagnostics[d];
  return NULL;
}

/* One side's force is the other's, the other way; upwards stays. */
static double worst_forces(const struct result_file *a, const struct result_file *b) {
  static const struct {
    const char *name, *of_mirror;
    double sign;
  } pairs[] = {{"force_left", "force_right", -1}, {"force_right", "force_left", -1},
               {"force_x", "force_x", -1},        {"force_y", "force_y", 1},
               {"moment", "moment", -1},          {"momentum_x", "momentum_x", -1},
               {"momentum_y", "momentum_y", 1}};
  double off = 0, largest = 0;
  for (size_t k = 0; k < sizeof pairs / sizeof *pairs; k++) {
    const struct result_series *p = diagnostic(a, pairs[k].name),
                               *q = diagnostic(b, pairs[k].of_mirror);
    EXPECT(p && q);
    for (size_t i = 0; p && q && i < a->n_energy; i++) {
      off = worst(off, pairs[k].sign * p->value[i], q->value[i], 1e4);
      if (k == 0) largest = fmax(largest, fabs(p->value[i]));
    }
  }
  EXPECT(largest > 100); /* N/m: the water rests on that wall */
  return off;
}

/* Of a point the nearest mirror image of the same output. */
static double worst_point(const struct points *a, size_t i, const struct points *b, size_t from,
                          size_t n) {
  double least = INFINITY, off = 0;
  size_t at = from;
  for (size_t j = from; j < from + n; j++) {
    const double way = hypot(mirrored(a->at[i][0]) - b->at[j][0], a->at[i][1] - b->at[j][1]);
    if (way < least) least = way, at = j;
  }
  off = worst(off, least, 0, 1);
  off = worst(off, -a->velocity[i][0], b->velocity[at][0], 1);
  off = worst(off, a->velocity[i][1], b->velocity[at][1], 1);
  return worst(off, a->pressure[i], b->pressure[at], 1e4);
}

static double worst_points(const struct result_file *f, const struct points *a,
                           const struct points *b) {
  double off = 0;
  size_t from = 0;
  EXPECT(a->n == b->n && a->n > 100);
  for (size_t k = 0; a->n == b->n && k < f->n_outputs; k++) {
    const size_t n = (size_t)f->output_points[k];
    for (size_t i = from; i < from + n; i++) off = worst(off, worst_point(a, i, b, from, n), 0, 1);
    from += n;
  }
  return off;
}

/* The sentence that a run ended with: the same, but for where that was. */
static void expect_mirrored_end(const struct result_file *a, const struct result_file *b) {
  const char *p = strstr(a->ended, ", x = "), *q = strstr(b->ended, ", x = ");
  double x[2] = {NAN, NAN};
  EXPECT(p && q);
  if (!p || !q) return;
  EXPECT(p - a->ended == q - b->ended && !strncmp(a->ended, b->ended, (size_t)(p - a->ended)));
  EXPECT(sscanf(p, ", x = %lf", &x[0]) == 1 && sscanf(q, ", x = %lf", &x[1]) == 1);
  EXPECT_NEAR(mirrored(x[0]), x[1], 2e-3); /* four digits of it are written */
}

static double worst_point_series(const struct result_file *a, const struct result_file *b) {
  double off = 0;
  EXPECT(a->n_points == b->n_points);
  for (size_t k = 0; k < a->n_points && k < b->n_points; k++) {
    const struct result_point_read *p = &a->points[k], *q = &b->points[k];
    EXPECT(p->n == a->n_energy && q->n == p->n);
    off = worst(off, mirrored(p->x), q->x, 1);
    for (size_t i = 0; i < p->n && i < q->n; i++) {
      EXPECT(p->value[CASE_POINT_cover][i] == q->value[CASE_POINT_cover][i]);
      off = worst(off, p->value[CASE_POINT_p][i], q->value[CASE_POINT_p][i], 1e4);
      off = worst(off, -p->value[CASE_POINT_u][i], q->value[CASE_POINT_u][i], 1);
      off = worst(off, p->value[CASE_POINT_v][i], q->value[CASE_POINT_v][i], 1);
    }
  }
  return off;
}

static double worst_series(const struct result_file *a, const struct result_file *b) {
  double off = fmax(worst_forces(a, b), worst_point_series(a, b));
  EXPECT(a->n_energy == b->n_energy && a->n_diagnostics == b->n_diagnostics);
  for (size_t i = 0; i < a->n_energy; i++) {
    off = worst(off, a->energy[i].kinetic, b->energy[i].kinetic, 1e3);
    for (size_t k = 0; k < 2; k++)
      off = worst(off, a->probes[k].value[i], b->probes[k].value[i], 1e4);
    off = worst(off, a->gauges[0].value[i], b->gauges[0].value[i], 1);
  }
  return off;
}

/* In a tank that sways, so that right and left matter. */
static void test_right_column_is_the_mirror_image_of_the_left_one(void) {
  struct points points[2] = {0};
  struct result_file *left = column(1, &points[0]), *right = column(-1, &points[1]);
  if (left && right) {
    EXPECT(left->n_surfaces == right->n_surfaces && left->n_surfaces > 5);
    EXPECT(left->n_energy > 50 && left->n_diagnostics > 3 && left->n_points == 2);
    const double event = worst_event(left, right), surface = worst_surface(left, right),
                 series = worst_series(left, right),
                 inside = worst_points(left, &points[0], &points[1]);
    printf("     events off by %.1e, surfaces %.1e m, series %.1e, %zu points %.1e\n", event,
           surface, series, points[0].n, inside);
    printf("     %s\n     %s\n", left->ended, right->ended);
    EXPECT(event < 1e-9 && surface < 1e-9 && series < 1e-9 && inside < 1e-9);
    expect_mirrored_end(left, right);
    EXPECT(right->surface[0].p[0][0] < right->surface[0].p[right->surface[0].points - 1][0]);
    EXPECT(gauge_front(&right->surface[0], -0.1, 0.01) > 1); /* stands at the right wall */
  }
  for (int i = 0; i < 2; i++) forget_points(&points[i]);
  result_file_destroy(left);
  result_file_destroy(right);
}

static const char leaning[] =
    "title: leaning sides\n"
    "fluid: {density: 1000, gravity: 9.81}\n"
    "scales: {H: 0.6}\n"
    "tank: {walls: [[%s]]}\n"
    "water: {regions: [[%s]], velocity: [%g, 0]}\n"
    "time: {end: 0.3, every: 0.1, sample: 0.02}\n"
    "probes: [{name: P, at: [%g, 0]}, {name: Q, at: [%g, 0]}]\n"
    "gauges: [{name: G, x: %g}]\n"
    "runs: [{name: bem, solver: bem, resolution: 14, forces: true, velocity_lattice: 0.06}]\n";

/* Between sides that lean, each in its own way. */
static void test_mirror_image_between_leaning_sides(void) {
  char with[2][2000];
  struct points points[2] = {0};
  snprintf(with[0], sizeof with[0], leaning, "[-0.2, 2], [0, 0], [3, 0], [3.5, 2]",
           "[0, 0], [1, 0], [1, 0.6], [-0.06, 0.6]", 0.1, 0.5, 0.7, 0.4);
  snprintf(with[1], sizeof with[1], leaning, "[-0.5, 2], [0, 0], [3, 0], [3.2, 2]",
           "[2, 0], [3, 0], [3.06, 0.6], [2, 0.6]", -0.1, 2.5, 2.3, 2.6);
  struct result_file *left = run_bem_and(run_case(with[0]), read_points, &points[0]),
                     *right = run_bem_and(run_case(with[1]), read_points, &points[1]);
  if (left && right) {
    middle = 1.5;
    const double surface = worst_surface(left, right), series = worst_series(left, right),
                 inside = worst_points(left, &points[0], &points[1]);
    printf("     surfaces off by %.1e m, series %.1e, %zu points %.1e\n", surface, series,
           points[0].n, inside);
    EXPECT(left->n_surfaces == 4 && right->n_surfaces == 4);
    /* two maps, whose rounding grows in the run: found 7e-10 and 1.2e-9 m; what is no mirror image
     * is off by far more than the time tolerance allows, 1e-6 */
    EXPECT(surface < 1e-8 && series < 1e-8 && inside < 1e-8);
  }
  for (int i = 0; i < 2; i++) forget_points(&points[i]);
  result_file_destroy(left);
  result_file_destroy(right);
}

int main(void) {
  RUN(test_right_column_is_the_mirror_image_of_the_left_one);
  RUN(test_mirror_image_between_leaning_sides);
  return TEST_RESULT;
}

/* Water of any shape: exact area, pressure from the surface above, released pressure. */
#include "tests/test.h"

#include "common/flow/release.h"
#include "sph/fluid/energy.h"
#include "sph/start/cells.h"
#include "tests/sph/pool.h"

#define TANK    "title: polygons\nscales: {H: 1}\ntank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]}\n"
#define L_SHAPE "[[0, 0], [4, 0], [4, 0.27], [0.97, 0.27], [0.97, 1], [0, 1]]"
#define OCTAGON                                                                                    \
  "[[2.5, 1], [2.8, 1.1], [2.9, 1.4], [2.8, 1.7], [2.5, 1.8], [2.2, 1.7], [2.1, 1.4], [2.2, 1.1]]"

static struct case_file *water_of(const char *water, double resolution) {
  char head[2000], run[100];
  snprintf(head, sizeof head, TANK "water: {%s}\n" POOL_TIMES, water);
  snprintf(run, sizeof run, "resolution: %g", resolution);
  return pool_case(head, run);
}

/* ---- area ---- */

static const char *const shapes[] = {
    "regions: [[[0, 0], [1, 0], [0, 1]]]",
    "regions: [" OCTAGON "]",
    "regions: [" L_SHAPE "]",
    "regions: [[[0, 0], [1, 0], [0, 1]], " OCTAGON "]",
    /* a trough open upwards, a notch, points on slanting sides */
    "regions: [[[0.3, 0], [3.1, 0], [3.5, 1.3], [2.9, 1.1], [2.1, 0.4], [1.2, 0.5], [0.9, 1.41]]]",
    "regions: [[[0, 0], [4, 0], [4, 0.5], [2.03, 0.71], [2, 2.2], [1.55, 2.2], [1.5, 0.71], [0, "
    "0.5]]]",
};

/* Area and both first moments of a polygon. */
static void moments_of(const struct geo_lines *l, double m[3]) {
  m[0] = m[1] = m[2] = 0;
  for (size_t k = 0; k < l->pieces; k++)
    for (size_t i = l->first[k]; i < l->first[k + 1]; i++) {
      const double *p = l->p[i], *q = l->p[i + 1 < l->first[k + 1] ? i + 1 : l->first[k]];
      double cross = p[0] * q[1] - q[0] * p[1];
      m[0] += cross / 2;
      m[1] += cross * (p[0] + q[0]) / 6;
      m[2] += cross * (p[1] + q[1]) / 6;
    }
}

/* To rounding: the area, so the mass; the centroid, so the potential energy. No particle is lighter
 * than half a cell nor, where pieces of a corner gather, heavier than two and a half. */
static void expect_exact(const char *water, double resolution) {
  struct case_file *c = water_of(water, resolution);
  struct sph *s = pool_create(c);
  double exact[3], sum[3] = {0}, least = INFINITY, most = 0;
  moments_of(&c->water, exact);
  for (size_t i = 0; i < s->f.n; i++) {
    double V = pool_V(s, i);
    sum[0] += V;
    sum[1] += V * s->f.w.x[i];
    sum[2] += V * s->f.w.y[i];
    least = fmin(least, V / (s->dx * s->dx));
    most = fmax(most, V / (s->dx * s->dx));
  }
  for (int k = 0; k < 3; k++) EXPECT_NEAR(sum[k] / exact[k], 1, 1e-12);
  /* the lattice is stretched to the box, by up to half a spacing a side of 0.8 */
  double stretch = 1 + 1 / (0.8 * resolution);
  EXPECT(least > 0.5 / stretch && most < 2.5 * stretch);
  sph_destroy(s);
  case_destroy(c);
}

static void test_area_and_centroid_are_exact(void) {
  for (size_t k = 0; k < sizeof shapes / sizeof *shapes; k++)
    for (double resolution = 15; resolution < 70; resolution *= 1.59)
      expect_exact(shapes[k], resolution);
}

static void test_circle_of_many_sides_is_exact(void) {
  enum { SIDES = 500 };
  struct geo_lines circle = {0};
  EXPECT_OK(geo_lines_begin(&circle, true));
  for (int i = 0; i < SIDES; i++)
    EXPECT_OK(geo_lines_add(&circle, 2 + 0.4 * cos(2 * M_PI * i / SIDES),
                            0.4 * sin(2 * M_PI * i / SIDES)));
  struct sph_cell *cells;
  size_t n;
  EXPECT_OK(sph_cells_create(&circle, 0.03, 0, &n, &cells));
  double area = 0;
  for (size_t i = 0; i < n; i++) area += cells[i].area;
  EXPECT_NEAR(area / geo_piece_area(&circle, 0), 1, 1e-12);
  free(cells);
  geo_lines_destroy(&circle);
}

/* ---- hydrostatic pressure ---- */

static double surface_of_L(double x) {
  return x < 0.97 ? 1 : 0.27;
}

/* Every particle's pressure is rho g times the depth below `surface` of x, zero where that is NaN.
 */
static void expect_depth(const char *water, double (*surface)(double)) {
  struct case_file *c = water_of(water, 23.85);
  struct sph *s = pool_create(c);
  double worst = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    double top = surface(s->f.w.x[i]), depth = isnan(top) ? 0 : top - s->f.w.y[i];
    worst = fmax(worst, fabs(pool_p(s, i) / (s->rho0 * s->g) - depth));
  }
  EXPECT_NEAR(worst, 0, 1e-9);
  sph_destroy(s);
  case_destroy(c);
}

static double one(double x) {
  (void)x;
  return 1;
}

static double slope(double x) {
  return 1 - 0.25 * x;
}

static double nowhere(double x) {
  (void)x;
  return NAN;
}

static double table_top(double x) { /* its leg stands on the bed, its wings fall free */
  return fabs(x - 2) < 0.5 ? 1.5 : NAN;
}

static void test_depth_counts_from_the_surface_above(void) {
  expect_depth("regions: [" L_SHAPE "]", surface_of_L);
  expect_depth("regions: [[[0, 0], [0.97, 0], [0.97, 1], [0, 1]], "
               "[[0.97, 0], [4, 0], [4, 0.27], [0.97, 0.27]]]",
               surface_of_L);
  expect_depth(
      "regions: [[[0, 0], [4, 0], [4, 0.31], [0, 0.31]], [[0, 0.31], [4, 0.31], [4, 1], [0, 1]]]",
      one);
  expect_depth("regions: [[[0, 0], [4, 0], [0, 1]]]", slope);
}

static void test_water_that_falls_free_has_no_pressure(void) {
  expect_depth("regions: [" OCTAGON "]", nowhere);
  expect_depth("regions: [" OCTAGON "], pressure: released", nowhere);
  expect_depth("regions: [[[3.2, 0.5], [4, 0.5], [4, 1.5], [3.2, 1.5]]]", nowhere); /* at a wall */
  expect_depth("regions: [[[1.5, 0], [2.5, 0], [2.5, 0.8], [3.5, 0.8], [3.5, 1.5], [0.5, 1.5], "
               "[0.5, 0.8], [1.5, 0.8]]]",
               table_top);
}

/* Water 1 m deep round solids: a block and a plate thinner than two particles that hang in it, one
 * over the other and off the bed; a block whose top is dry; a ledge under water at a wall that
 * leans over it. */
static const struct covered {
  const char *name, *walls, *water;
} covered[] = {
    {"block",
     "[[0, 2], [0, 0], [3, 0], [3, 2]], [[1, 0.3], [1, 0.6], [1.7, 0.6], [1.7, 0.3], [1, 0.3]]",
     "[[0, 0], [3, 0], [3, 0.3], [0, 0.3]], [[0, 0.3], [1, 0.3], [1, 0.6], [0, 0.6]], [[1.7, 0.3], "
     "[3, 0.3], [3, 0.6], [1.7, 0.6]], [[0, 0.6], [3, 0.6], [3, 1], [0, 1]]"},
    {"plate",
     "[[0, 2], [0, 0], [3, 0], [3, 2]], [[1, 0.45], [1, 0.55], [2, 0.55], [2, 0.45], [1, 0.45]]",
     "[[0, 0], [3, 0], [3, 0.5], [2, 0.5], [2, 0.45], [1, 0.45], [1, 0.5], [0, 0.5]], [[0, 0.5], "
     "[1, 0.5], [1, 0.55], [2, 0.55], [2, 0.5], [3, 0.5], [3, 1], [0, 1]]"},
    {"two plates",
     "[[0, 2], [0, 0], [3, 0], [3, 2]], [[1, 0.6], [1, 0.7], [2.5, 0.7], [2.5, 0.6], [1, 0.6]], "
     "[[0.5, 0.3], [0.5, 0.4], [2, 0.4], [2, 0.3], [0.5, 0.3]]",
     "[[0, 0], [3, 0], [3, 0.3], [0, 0.3]], [[0, 0.3], [0.5, 0.3], [0.5, 0.4], [0, 0.4]], [[2, "
     "0.3], [3, 0.3], [3, 0.4], [2, 0.4]], [[0, 0.4], [3, 0.4], [3, 0.6], [0, 0.6]], [[0, 0.6], "
     "[1, 0.6], [1, 0.7], [0, 0.7]], [[2.5, 0.6], [3, 0.6], [3, 0.7], [2.5, 0.7]], [[0, 0.7], [3, "
     "0.7], [3, 1], [0, 1]]"},
    {"pier", "[[0, 2], [0, 0], [3, 0], [3, 2]], [[1, 0.5], [1, 1.5], [2, 1.5], [2, 0.5], [1, 0.5]]",
     "[[0, 0], [3, 0], [3, 1], [2, 1], [2, 0.5], [1, 0.5], [1, 1], [0, 1]]"},
    {"ledge", "[[0, 2], [0, 0], [3, 0], [3, 0.4], [2, 0.4], [2, 0.7], [3, 0.7], [2.5, 2]]",
     "[[0, 0], [3, 0], [3, 0.4], [2, 0.4], [2, 0.7], [3, 0.7], [2.884615385, 1], [0, 1]]"},
};

static struct case_file *covered_case(const struct covered *k, const char *pressure) {
  char head[2000];
  snprintf(head, sizeof head,
           "title: %s\nscales: {H: 1}\ntank: {walls: [%s]}\n"
           "water: {regions: [%s], pressure: %s}\n" POOL_TIMES,
           k->name, k->walls, k->water, pressure);
  return pool_case(head, "resolution: 20");
}

static void test_depth_under_obstacles_counts_from_the_level_around(void) {
  for (size_t k = 0; k < sizeof covered / sizeof *covered; k++) {
    struct case_file *c = covered_case(&covered[k], "hydrostatic");
    struct sph *s = pool_create(c);
    double worst = 0;
    for (size_t i = 0; i < s->f.n; i++)
      worst = fmax(worst, fabs(pool_p(s, i) / (s->rho0 * s->g) - (1 - s->f.w.y[i])));
    printf("     %s: off by %.1e H\n", covered[k].name, worst);
    EXPECT_NEAR(worst, 0, 1e-8);
    sph_destroy(s);
    case_destroy(c);
  }
}

/* The largest speed up to sqrt(H/g), over c0. */
static double mach_of(const struct covered *k, const char *pressure) {
  struct case_file *c = covered_case(k, pressure);
  struct sph *s = pool_create(c);
  double most = 0;
  for (int i = 1; i <= 10; i++) {
    EXPECT_OK(pool_march(s, 0.1 * i / sqrt(s->g)));
    for (size_t j = 0; j < s->f.n; j++) most = fmax(most, hypot(s->f.w.u[j], s->f.w.v[j]) / s->c0);
  }
  sph_destroy(s);
  case_destroy(c);
  return most;
}

/* As still as with the released pressure, which is the same in water at rest, but for rounding; no
 * more moves than the lattice beside corners does. */
static void test_water_round_obstacles_rests(void) {
  for (size_t k = 0; k < 2; k++) {
    const double rest = mach_of(&covered[k], "released"),
                 mach = mach_of(&covered[k], "hydrostatic");
    printf("     %s: Mach %.5f, released %.5f\n", covered[k].name, mach, rest);
    EXPECT_NEAR(mach / rest, 1, 1e-3);
    EXPECT(mach < 0.02);
  }
}

/* ---- released pressure ---- */

/* Depths that are no multiple of the spacing, over a beach: the first row of still water is half a
 * row below the level, though a crest elsewhere and the walls are as high as they like; the area is
 * exact. In water of fewer than three rows slivers on the slope join the first one. */
static void expect_level(const char *wave, double depth, double from, double to, double near) {
  char head[1000];
  snprintf(head, sizeof head,
           "scales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [12, 0], [16, 2]]]}\n"
           "water: {wave: {%s, depth: %g}}\n" POOL_TIMES,
           wave, depth);
  struct case_file *c = pool_case(head, "resolution: 11.3");
  struct sph *s = pool_create(c);
  const double row = depth / (double)geo_intervals(depth, s->dx);
  double worst = 0, area = 0;
  size_t n = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    area += pool_V(s, i);
    if (s->f.w.x[i] < from || s->f.w.x[i] > to || s->f.w.y[i] < depth - row) continue;
    worst = fmax(worst, fabs(s->f.w.y[i] - (depth - row / 2)) / row);
    n++;
  }
  EXPECT(n >= (size_t)((to - from) / s->dx) - 1);
  EXPECT_NEAR(worst, 0, near);
  EXPECT_NEAR(area / case_water_area(c), 1, 1e-12);
  sph_destroy(s);
  case_destroy(c);
}

static void test_first_row_of_a_wave_is_half_a_row_below_its_level(void) {
  expect_level("kind: still", 0.987, 0, 13.3, 1e-9);
  expect_level("kind: still", 0.61, 0, 12.6, 1e-9);
  /* the crest's tail is up to a thousandth of it high */
  expect_level("kind: solitary, amplitude: 0.33, x: 5.5", 0.613, 10.3, 12.6, 0.02);
}

/* Nothing can start to move: hydrostatic, exactly, since the solution is linear. */
static void test_released_water_between_walls_stays_hydrostatic(void) {
  expect_depth("regions: [[[0, 0], [4, 0], [4, 1], [0, 1]]], pressure: released", one);
  expect_depth(
      "regions: [[[0, 0], [4, 0], [4, 0.31], [0, 0.31]], [[0, 0.31], [4, 0.31], [4, 1], [0, "
      "1]]], pressure: released",
      one);
}

/* Bits that do not depend on anything but the case. */
static void test_start_is_repeatable(void) {
  struct case_file *c = water_of("regions: [" L_SHAPE "], pressure: released", 20);
  struct sph *a = pool_create(c), *b = pool_create(c);
  EXPECT(a->f.n == b->f.n && memcmp(a->f.m, b->f.m, a->f.n * sizeof *a->f.m) == 0);
  sph_destroy(a);
  sph_destroy(b);
  case_destroy(c);
}

int main(void) {
  RUN(test_area_and_centroid_are_exact);
  RUN(test_circle_of_many_sides_is_exact);
  RUN(test_depth_counts_from_the_surface_above);
  RUN(test_water_that_falls_free_has_no_pressure);
  RUN(test_depth_under_obstacles_counts_from_the_level_around);
  RUN(test_water_round_obstacles_rests);
  RUN(test_first_row_of_a_wave_is_half_a_row_below_its_level);
  RUN(test_released_water_between_walls_stays_hydrostatic);
  RUN(test_start_is_repeatable);
  return TEST_RESULT;
}

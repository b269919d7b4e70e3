/* Distances and areas between surfaces whose answers are known in closed form. */
#include "compare/outline.h"

#include "compare/furthest.h"
#include "compare/polyline.h"
#include "tests/compare/shapes.h"
#include "tests/test.h"

static struct cmp_geos *geos;
static const struct geo_box everywhere = {{-10, -10}, {20, 20}};

struct answer {
  struct cmp_value mean, largest, hausdorff, frechet, area;
  double enclosed_a, enclosed_b;
};

static struct answer measure(const struct geo_lines *a, const struct geo_lines *b,
                             const struct geo_lines *tank, const struct geo_box *window,
                             double spacing, double film) {
  struct answer m = {0};
  struct cmp_outline *p = NULL, *q = NULL;
  struct cmp_distance d;
  EXPECT_OK(cmp_outline_create(geos, a, tank, window, spacing, film, &p));
  EXPECT_OK(cmp_outline_create(geos, b, tank, window, spacing, film, &q));
  EXPECT_OK(cmp_outline_distance(p, q, &d, &m.mean, &m.largest));
  EXPECT_OK(cmp_outline_hausdorff(p, q, &m.hausdorff));
  EXPECT_OK(cmp_outline_frechet(p, q, &m.frechet));
  EXPECT_OK(cmp_outline_area(p, q, &m.area));
  m.enclosed_a = cmp_outline_enclosed(p);
  m.enclosed_b = cmp_outline_enclosed(q);
  cmp_outline_destroy(p);
  cmp_outline_destroy(q);
  return m;
}

/* A level raised by d: every distance is d, the area d times the tank's length. */
static void test_raised_level_is_its_own_distance(void) {
  struct geo_lines tank = shape_tank(5.366, 3), a = {0}, b = {0};
  const double d = 0.0385;
  shape_line(&a, 0, 0.7, 5.366, 0.7, 37);
  shape_line(&b, 0, 0.7 + d, 5.366, 0.7 + d, 101);
  struct answer m = measure(&a, &b, &tank, &everywhere, 0.01, 0);
  EXPECT_NEAR(m.mean.value, d, 1e-12);
  EXPECT_NEAR(m.largest.value, d, 1e-12);
  EXPECT_NEAR(m.hausdorff.value, d, 1e-12);
  /* points of the two need not stand above each other: up to half a spacing aside */
  EXPECT(m.frechet.value >= d - 1e-12 && m.frechet.value <= hypot(d, 0.01));
  EXPECT_NEAR(m.area.value, d * 5.366, 1e-12);
  EXPECT_NEAR(m.enclosed_a, 0.7 * 5.366, 1e-12);
  geo_lines_destroy(&tank);
  geo_lines_destroy(&a);
  geo_lines_destroy(&b);
}

/* A surface against itself is at distance zero, but for the rounding of sample points. */
static void test_identity_is_zero(void) {
  struct geo_lines tank = shape_tank(4, 2), a = {0};
  shape_jet(&a, 0.1, 2.2, 40);
  shape_circle(&a, 1, 1.2, 0.05, 12, true);
  struct answer m = measure(&a, &a, &tank, &everywhere, 0.017, 0.02);
  EXPECT(m.mean.value <= 1e-15 && m.largest.value <= 1e-15);
  EXPECT(m.hausdorff.value == 0 && m.frechet.value == 0 && m.area.value == 0);
  geo_lines_destroy(&tank);
  geo_lines_destroy(&a);
}

/* Two circles of one radius, d apart, one begun a third of a turn later: the translation is the
 * best partner of every point, but for the half spacing by which sample points may miss each other.
 */
static void test_closed_lines_begin_anywhere(void) {
  struct geo_lines tank = shape_tank(4, 4), a = {0}, b = {0};
  const double r = 0.5, d = 0.02, spacing = 0.01;
  EXPECT_OK(geo_lines_begin(&b, true));
  for (int i = 0; i < 300; i++) {
    const double turn = 2 * M_PI * (1. / 3 - i / 300.);
    EXPECT_OK(geo_lines_add(&b, 2 + d + r * cos(turn), 2 + r * sin(turn)));
  }
  shape_circle(&a, 2, 2, r, 300, true);
  struct answer m = measure(&a, &b, &tank, &everywhere, spacing, 0);
  EXPECT(m.frechet.value >= m.hausdorff.value - 1e-12);
  EXPECT(m.frechet.value > d - spacing && m.frechet.value < d + spacing);
  struct answer n = measure(&b, &a, &tank, &everywhere, spacing, 0);
  EXPECT_NEAR(n.frechet.value, m.frechet.value, spacing / 2);
  geo_lines_destroy(&tank);
  geo_lines_destroy(&a);
  geo_lines_destroy(&b);
}

/* Concentric drops: distances are the difference of the radii, the area pi (R^2 - r^2). Chords of n
 * segments miss the circle by r (1 - cos(pi/n)). */
static void test_concentric_drops(void) {
  struct geo_lines tank = shape_tank(4, 4), a = {0}, b = {0};
  const double r = 0.5, R = 0.63;
  const size_t n = 720;
  shape_circle(&a, 2, 2, r, n, true);
  shape_circle(&b, 2, 2, R, n, true);
  struct answer m = measure(&a, &b, &tank, &everywhere, 0.005, 0);
  double chord = R * (1 - cos(M_PI / (double)n));
  EXPECT_NEAR(m.mean.value, R - r, 2 * chord);
  EXPECT_NEAR(m.largest.value, R - r, 2 * chord);
  EXPECT_NEAR(m.hausdorff.value, R - r, 2 * chord);
  EXPECT_NEAR(m.area.value, M_PI * (R * R - r * r), 2 * M_PI * (R + r) * chord);
  geo_lines_destroy(&tank);
  geo_lines_destroy(&a);
  geo_lines_destroy(&b);
}

/* A triangle of height h on a level: the largest distance and the Hausdorff distance are h from the
 * triangle's side; the area is the triangle's. */
static void test_bump_is_found_and_located(void) {
  struct geo_lines tank = shape_tank(4, 2), a = {0}, b = {0};
  shape_line(&a, 0, 0.5, 4, 0.5, 8);
  shape_open(&b);
  double points[][2] = {{0, 0.5}, {1.9, 0.5}, {2, 0.8}, {2.1, 0.5}, {4, 0.5}};
  for (int i = 0; i < 5; i++) shape_point(&b, points[i][0], points[i][1]);
  struct answer m = measure(&a, &b, &tank, &everywhere, 0.01, 0);
  EXPECT_NEAR(m.hausdorff.value, 0.3, 1e-12);
  EXPECT_NEAR(m.largest.value, 0.3, 0.01); /* the sample nearest to the top: one spacing at most */
  EXPECT_NEAR(m.area.value, 0.5 * 0.2 * 0.3, 1e-12);
  geo_lines_destroy(&tank);
  geo_lines_destroy(&a);
  geo_lines_destroy(&b);
}

/* One drop far away: the Hausdorff distance and the area see it, mean and largest do not. */
static void test_spray_is_not_the_main_surface(void) {
  struct geo_lines tank = shape_tank(4, 4), a = {0}, b = {0};
  shape_line(&a, 0, 0.5, 4, 0.5, 40);
  shape_line(&b, 0, 0.5, 4, 0.5, 40);
  shape_circle(&b, 2, 2.5, 0.03, 100, true);
  struct answer m = measure(&a, &b, &tank, &everywhere, 0.01, 0);
  EXPECT(m.mean.value == 0 && m.largest.value == 0);
  EXPECT_NEAR(m.hausdorff.value, 2.03, 1e-3);
  EXPECT_NEAR(m.area.value, M_PI * 0.03 * 0.03, 3e-6);
  geo_lines_destroy(&tank);
  geo_lines_destroy(&a);
  geo_lines_destroy(&b);
}

static void test_measures_are_symmetric(void) {
  struct geo_lines tank = shape_tank(4, 2), a = {0}, b = {0};
  shape_jet(&a, 0.1, 2.2, 40);
  shape_line(&b, 0, 0.31, 4, 0.62, 23);
  struct answer m = measure(&a, &b, &tank, &everywhere, 0.013, 0.04);
  struct answer n = measure(&b, &a, &tank, &everywhere, 0.013, 0.04);
  EXPECT_NEAR(m.mean.value, n.mean.value, 1e-14);
  EXPECT_NEAR(m.largest.value, n.largest.value, 1e-14);
  EXPECT_NEAR(m.hausdorff.value, n.hausdorff.value, 1e-14);
  EXPECT_NEAR(m.frechet.value, n.frechet.value, 1e-14);
  EXPECT_NEAR(m.area.value, n.area.value, 1e-12); /* GEOS nodes the two in another order */
  EXPECT(m.mean.value > 0.05);
  geo_lines_destroy(&tank);
  geo_lines_destroy(&a);
  geo_lines_destroy(&b);
}

/* Dam break before impact: the surface ends at a toe on the dry bed. */
static void test_toe_on_the_bed_closes_along_the_bed(void) {
  struct geo_lines tank = shape_tank(5, 2), a = {0}, b = {0};
  shape_open(&a);
  shape_point(&a, 0, 1);
  shape_point(&a, 2, 0);
  shape_open(&b);
  shape_point(&b, 0, 1);
  shape_point(&b, 3, 0);
  struct answer m = measure(&a, &b, &tank, &everywhere, 0.02, 0);
  EXPECT_NEAR(m.enclosed_a, 1, 1e-12);
  EXPECT_NEAR(m.enclosed_b, 1.5, 1e-12);
  EXPECT_NEAR(m.area.value, 0.5, 1e-12);
  geo_lines_destroy(&tank);
  geo_lines_destroy(&a);
  geo_lines_destroy(&b);
}

/* Ends that miss the walls by a bit, several bodies of water, a drop and a cavity: the area is
 * right. */
static void test_many_pieces_enclose_their_water(void) {
  struct geo_lines tank = shape_tank(10, 3), a = {0};
  shape_line(&a, 0.004, 1, 2, 0.003, 10); /* triangle at the left wall: 1 x 2 / 2, roughly */
  shape_open(&a);                         /* a heap on the bed: 1 x 0.5 / 2 */
  shape_point(&a, 4, 0.002);
  shape_point(&a, 4.5, 0.5);
  shape_point(&a, 5, 0.001);
  shape_line(&a, 7, 0, 9.997, 2, 10);          /* triangle at the right wall: 3 x 2 / 2 */
  shape_circle(&a, 3, 2, 0.1, 400, true);      /* a drop */
  shape_circle(&a, 9.5, 0.4, 0.1, 400, false); /* a cavity as large */
  struct cmp_outline *o = NULL;
  EXPECT_OK(cmp_outline_create(geos, &a, &tank, &everywhere, 0.02, 0, &o));
  EXPECT_NEAR(cmp_outline_enclosed(o), 1 + 0.25 + 3,
              0.03); /* gaps of 0.004 along sides of 1 to 3 */
  cmp_outline_destroy(o);
  geo_lines_destroy(&tank);
  geo_lines_destroy(&a);
}

/* A surface that crosses itself still encloses an area: a level with a loop of 0.4 by 0.2 below it.
 */
static void test_self_crossing_surface_is_measured(void) {
  struct geo_lines tank = shape_tank(4, 4), a = {0}, b = {0};
  double points[][2] = {{0, 0.5},      {2.2, 0.5}, {2.2, 0.3}, {1.8, 0.3},
                        {1.8, 0.5001}, {1.9, 0.8}, {4, 0.5}};
  shape_open(&a);
  for (int i = 0; i < 7; i++) shape_point(&a, points[i][0], points[i][1]);
  shape_line(&b, 0, 0.5, 4, 0.5, 4);
  struct answer m = measure(&a, &b, &tank, &everywhere, 0.02, 0);
  EXPECT_NEAR(m.enclosed_a, 2, 0.5);
  EXPECT(cmp_known(&m.area) && m.area.value > 0.2 && m.area.value < 0.6);
  geo_lines_destroy(&tank);
  geo_lines_destroy(&a);
  geo_lines_destroy(&b);
}

/* Only what is inside the window counts; where nothing is, there is a reason and no zero. */
static void test_window_cuts_and_says_when_empty(void) {
  struct geo_lines tank = shape_tank(4, 2), a = {0}, b = {0};
  shape_line(&a, 0, 0.5, 4, 0.5, 4);
  shape_line(&b, 0, 0.5, 4, 0.9, 4);
  struct geo_box left = {{0, 0}, {2, 2}}, sky = {{0, 1.5}, {4, 2}};
  struct answer m = measure(&a, &b, &tank, &left, 0.01, 0);
  EXPECT_NEAR(m.area.value, 0.5 * 2 * 0.2, 1e-12);
  EXPECT_NEAR(m.largest.value, 0.2, 1e-3);
  m = measure(&a, &b, &tank, &sky, 0.01, 0);
  EXPECT(!cmp_known(&m.mean) && m.mean.why[0] && !cmp_known(&m.hausdorff) &&
         !cmp_known(&m.frechet));
  geo_lines_destroy(&tank);
  geo_lines_destroy(&a);
  geo_lines_destroy(&b);
}

/* A film 0.02 thick up the wall is left out of the mean when films of 0.04 are. */
static void test_wall_film_is_left_out(void) {
  struct geo_lines tank = shape_tank(4, 4), a = {0}, b = {0};
  shape_line(&a, 0, 0.5, 4, 0.5, 100);
  shape_open(&b);
  double points[][2] = {{0, 0.5}, {3.98, 0.5}, {3.98, 3}, {4, 3}};
  for (int i = 0; i < 4; i++) shape_point(&b, points[i][0], points[i][1]);
  struct answer all = measure(&a, &b, &tank, &everywhere, 0.01, 0);
  struct answer thick = measure(&a, &b, &tank, &everywhere, 0.01, 0.04);
  EXPECT_NEAR(all.largest.value, 2.5, 0.02);
  EXPECT(thick.largest.value <= 1e-15 &&
         thick.mean.value <= 1e-15); /* but for rounding of places */
  geo_lines_destroy(&tank);
  geo_lines_destroy(&a);
  geo_lines_destroy(&b);
}

/* A peak between sample points, and the middle of a valley, which is furthest from both its sides.
 */
static void test_furthest_lies_between_samples(void) {
  struct geo_lines tank = shape_tank(4, 4), a = {0}, b = {0}, level = {0}, valley = {0}, wall = {0};
  const double peak[][2] = {{0, 0.5}, {1.2345, 0.9}, {4, 0.5}},
               v[][2] = {{0, 1}, {1, 0}, {2.6, 1.6}};
  const double spacing = 0.3, slope = sqrt(0.5);
  shape_line(&a, 0, 0.5, 4, 0.5, 1);
  shape_line(&level, 0, 1, 2, 1, 1);
  shape_line(&wall, 0, -9, 0, 9, 1);
  shape_open(&b);
  shape_open(&valley);
  for (int i = 0; i < 3; i++) shape_point(&b, peak[i][0], peak[i][1]);
  for (int i = 0; i < 3; i++) shape_point(&valley, v[i][0], v[i][1]);
  const struct answer m = measure(&a, &b, &tank, &everywhere, spacing, 0);
  EXPECT_NEAR(m.largest.value, 0.4, 1e-12);

  GEOSContextHandle_t h = GEOS_init_r();
  struct cmp_furthest *f = cmp_furthest_create(h, &valley);
  double largest = 0, at[2] = {NAN, NAN};
  EXPECT(f != NULL);
  EXPECT_OK(cmp_furthest_find(f, &level, &tank, 0, spacing, &largest, at));
  EXPECT(largest <= slope + 1e-15 && largest >= slope / 1.001 - 1e-6 * spacing);
  EXPECT_NEAR(at[0], 1, 2e-3);
  /* less than it is known already, it is not looked for; near walls it does not count */
  largest = 0.75;
  EXPECT_OK(cmp_furthest_find(f, &level, &tank, 0, spacing, &largest, at));
  EXPECT(largest == 0.75);
  largest = 0;
  EXPECT_OK(cmp_furthest_find(f, &level, &wall, 1.4, spacing, &largest, at));
  EXPECT_NEAR(largest, 0.6 * slope, 2e-3); /* at x = 1.4 */
  cmp_furthest_destroy(f);
  GEOS_finish_r(h);
  geo_lines_destroy(&tank);
  geo_lines_destroy(&a);
  geo_lines_destroy(&b);
  geo_lines_destroy(&level);
  geo_lines_destroy(&valley);
  geo_lines_destroy(&wall);
}

/* Two parallel lines of many points, where every point is as far: it comes to an end soon. */
static void test_furthest_of_parallel_lines(void) {
  struct geo_lines tank = shape_tank(4, 4), a = {0}, b = {0};
  shape_open(&a);
  shape_open(&b);
  for (int i = 0; i <= 3000; i++) {
    const double x = 4.0 * i / 3000, y = 1 + 0.2 * sin(5 * x);
    shape_point(&a, x, y);
    shape_point(&b, x + 1e-5 * cos(5 * x), y - 1e-5);
  }
  const struct answer m = measure(&a, &b, &tank, &everywhere, 0.01, 0);
  EXPECT(m.largest.value > 0.9e-5 && m.largest.value < 1.5e-5);
  geo_lines_destroy(&tank);
  geo_lines_destroy(&a);
  geo_lines_destroy(&b);
}

static void test_samples_are_evenly_spaced(void) {
  struct geo_lines a = {0}, s = {0};
  shape_line(&a, 0, 0, 3, 4, 7);
  EXPECT_OK(cmp_lines_sample(&a, 0.11, &s));
  EXPECT(s.points == 47); /* 5 / 0.11 rounded up, and one */
  EXPECT_NEAR(s.p[s.points - 1][0], 3, 1e-12);
  for (size_t i = 1; i < s.points; i++)
    EXPECT_NEAR(hypot(s.p[i][0] - s.p[i - 1][0], s.p[i][1] - s.p[i - 1][1]), 5.0 / 46, 1e-12);
  geo_lines_destroy(&a);
  geo_lines_destroy(&s);
}

int main(void) {
  geos = cmp_geos_create();
  RUN(test_raised_level_is_its_own_distance);
  RUN(test_identity_is_zero);
  RUN(test_furthest_lies_between_samples);
  RUN(test_furthest_of_parallel_lines);
  RUN(test_concentric_drops);
  RUN(test_closed_lines_begin_anywhere);
  RUN(test_bump_is_found_and_located);
  RUN(test_spray_is_not_the_main_surface);
  RUN(test_measures_are_symmetric);
  RUN(test_toe_on_the_bed_closes_along_the_bed);
  RUN(test_many_pieces_enclose_their_water);
  RUN(test_self_crossing_surface_is_measured);
  RUN(test_window_cuts_and_says_when_empty);
  RUN(test_wall_film_is_left_out);
  RUN(test_samples_are_evenly_spaced);
  cmp_geos_destroy(geos);
  return TEST_RESULT;
}

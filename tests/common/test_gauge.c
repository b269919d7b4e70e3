#include "common/base/gauge.h"

#include "tests/test.h"

/* All shapes are polygons, so the answers are exact up to the rounding of one interpolation. */
#define ROUNDING 1e-13

#define PIECE(l, closed, ...)                                                                      \
  do {                                                                                             \
    const double p_[][2] = {__VA_ARGS__};                                                          \
    EXPECT_OK(geo_lines_begin(l, closed));                                                         \
    for (size_t i_ = 0; i_ < sizeof p_ / sizeof *p_; i_++)                                         \
      EXPECT_OK(geo_lines_add(l, p_[i_][0], p_[i_][1]));                                           \
  } while (0)

static void test_slope_is_read_between_vertices_on_vertices_and_on_both_walls(void) {
  struct geo_lines l = {0};
  PIECE(&l, false, {0, 1}, {1, 1.5}, {3, 0.5});
  EXPECT_NEAR(gauge_elevation(&l, 0, 0), 1, ROUNDING);
  EXPECT_NEAR(gauge_elevation(&l, 0.5, 0), 1.25, ROUNDING);
  EXPECT_NEAR(gauge_elevation(&l, 1, 0), 1.5, ROUNDING);
  EXPECT_NEAR(gauge_elevation(&l, 2.5, 0), 0.75, ROUNDING);
  EXPECT_NEAR(gauge_elevation(&l, 3, 0), 0.5, ROUNDING);
  EXPECT_NEAR(gauge_elevation(&l, 3 + 1e-12, 0), 0.5, 1e-12); /* a wall missed by rounding */
  EXPECT(isnan(gauge_elevation(&l, 3.01, 0)) && isnan(gauge_elevation(&l, -0.01, 0)));
  geo_lines_destroy(&l);
}

static void test_front_of_a_slope_is_where_the_depth_is_reached(void) {
  struct geo_lines l = {0};
  PIECE(&l, false, {0, 1}, {1, 1.5}, {3, 0});
  EXPECT_NEAR(gauge_front(&l, 0, 0.3), 3 - 0.4, ROUNDING);
  EXPECT_NEAR(gauge_front(&l, -0.1, 0.3), 3 - 0.2 / 0.75, ROUNDING);
  EXPECT_NEAR(gauge_front(&l, 0, 0), 3, ROUNDING);
  EXPECT(isnan(gauge_front(&l, 0, 1.6)));
  geo_lines_destroy(&l);
}

static void test_column_has_its_height_up_to_and_on_its_face(void) {
  struct geo_lines l = {0};
  PIECE(&l, false, {0, 0.6}, {1.2, 0.6}, {1.2, 0.3}, {1.2, 0});
  EXPECT_NEAR(gauge_elevation(&l, 0, 0), 0.6, ROUNDING);
  EXPECT_NEAR(gauge_elevation(&l, 1.2, 0), 0.6, ROUNDING);
  EXPECT(isnan(gauge_elevation(&l, 1.2 + 1e-6, 0)));
  EXPECT_NEAR(gauge_front(&l, 0, 0.1), 1.2, ROUNDING);
  geo_lines_destroy(&l);
}

static void test_water_against_the_right_wall_has_its_front_on_the_wall(void) {
  struct geo_lines l = {0};
  PIECE(&l, false, {0, 0.4}, {3, 0.2}, {3.2, 0.7});
  EXPECT_NEAR(gauge_front(&l, 0, 0.1), 3.2, ROUNDING);
  EXPECT_NEAR(gauge_front(&l, 0, 0.3), 3.2, ROUNDING); /* shallower in between, deeper again */
  EXPECT(isnan(gauge_front(&l, 0, 0.75)));
  geo_lines_destroy(&l);
}

/* An overturning jet over water of depth 1, and over a dry bed. */
static void test_jet_overhead_does_not_count(void) {
  struct geo_lines wet = {0}, dry = {0};
  PIECE(&wet, false, {0, 2}, {2, 3}, {4, 2.5}, {2, 2}, {2, 1}, {6, 1});
  EXPECT_NEAR(gauge_elevation(&wet, 3, 0), 1, ROUNDING);
  EXPECT_NEAR(gauge_elevation(&wet, 1, 0), 2.5, ROUNDING);
  EXPECT_NEAR(gauge_elevation(&wet, 2, 0), 3, ROUNDING); /* vertical there: the higher side */
  EXPECT_NEAR(gauge_front(&wet, 0, 1.5), 2, ROUNDING);

  PIECE(&dry, false, {0, 2}, {2, 3}, {4, 2.5}, {2, 2}, {2, 0});
  EXPECT(isnan(gauge_elevation(&dry, 3, 0)));
  EXPECT_NEAR(gauge_front(&dry, 0, 0.5), 2, ROUNDING);
  geo_lines_destroy(&wet);
  geo_lines_destroy(&dry);
}

static void test_drops_ahead_do_not_count(void) {
  struct geo_lines l = {0};
  PIECE(&l, false, {0, 1}, {2, 0});
  PIECE(&l, true, {4, 0.5}, {4.5, 1}, {5, 0.5}, {4.5, 0.25}); /* clockwise: water inside */
  EXPECT(isnan(gauge_elevation(&l, 4.5, 0)) && isnan(gauge_elevation(&l, 3, 0)));
  EXPECT_NEAR(gauge_front(&l, 0, 0.5), 1, ROUNDING);
  geo_lines_destroy(&l);
}

static void test_water_over_a_cavity_does_not_count(void) {
  struct geo_lines l = {0};
  PIECE(&l, false, {0, 2}, {5, 2});
  PIECE(&l, true, {2, 1}, {2.5, 0.5}, {3, 1}, {2.5, 1.5}); /* counter-clockwise: air inside */
  EXPECT_NEAR(gauge_elevation(&l, 2.5, 0), 0.5, ROUNDING);
  EXPECT_NEAR(gauge_elevation(&l, 2, 0), 2, ROUNDING);
  EXPECT_NEAR(gauge_elevation(&l, 3.1, 0), 2, ROUNDING);
  EXPECT_NEAR(gauge_front(&l, 0, 1), 5, ROUNDING);
  geo_lines_destroy(&l);
}

static void test_air_pocket_on_the_bed_is_dry(void) {
  struct geo_lines l = {0};
  PIECE(&l, false, {0, 2}, {5, 2});
  PIECE(&l, false, {3, 0}, {2.5, 0.5}, {2, 0}); /* an arch: water above it */
  EXPECT(isnan(gauge_elevation(&l, 2.5, 0)));
  EXPECT_NEAR(gauge_elevation(&l, 2, 0), 2, ROUNDING);
  geo_lines_destroy(&l);
}

/* Run-up: a film of thickness 0.02 to 0.1 on the right wall, overhanging at its foot. */
static void test_film_on_the_wall_is_read_at_the_wall(void) {
  struct geo_lines l = {0};
  PIECE(&l, false, {0, 0.3}, {2.95, 0.3}, {2.9, 0.4}, {2.98, 1}, {3, 1.5});
  EXPECT_NEAR(gauge_elevation(&l, 3, 0), 1.5, ROUNDING);
  EXPECT_NEAR(gauge_elevation(&l, 2.99, 0), 1.25, ROUNDING);
  EXPECT_NEAR(gauge_elevation(&l, 2.92, 0), 0.3, ROUNDING); /* under the overhang */
  EXPECT_NEAR(gauge_elevation(&l, 2.96, 0), 0.4 + 0.6 * 0.06 / 0.08, ROUNDING);
  EXPECT_NEAR(gauge_front(&l, 0, 1), 3, ROUNDING);
  geo_lines_destroy(&l);
}

static void test_nothing_is_read_off_no_surface(void) {
  struct geo_lines l = {0};
  EXPECT(isnan(gauge_elevation(&l, 0, 0)) && isnan(gauge_front(&l, 0, 0.1)));
  PIECE(&l, false, {1, 1});
  EXPECT(isnan(gauge_elevation(&l, 1, 0)) && isnan(gauge_front(&l, 0, 0.1)));
  geo_lines_destroy(&l);
}

/* The pieces may be cut anywhere: the same circle-topped surface in one piece and in three. */
static void test_reading_does_not_depend_on_the_cutting(void) {
  struct geo_lines one = {0}, three = {0};
  EXPECT_OK(geo_lines_begin(&one, false));
  for (int i = 0; i <= 90; i++) {
    double x = 0.37 + 0.0213 * i, y = 1.2 + 0.3 * sin(7 * x);
    EXPECT_OK(geo_lines_add(&one, x, y));
    if (i % 30 == 0 && i < 90) {
      if (i) EXPECT_OK(geo_lines_add(&three, x, y));
      EXPECT_OK(geo_lines_begin(&three, false));
    }
    EXPECT_OK(geo_lines_add(&three, x, y));
  }
  for (int i = 0; i <= 180; i++) {
    double x = 0.37 + 0.0213 * 0.5 * i;
    EXPECT_NEAR(gauge_elevation(&three, x, 0), gauge_elevation(&one, x, 0), ROUNDING);
  }
  EXPECT_NEAR(gauge_front(&three, 0, 1.4), gauge_front(&one, 0, 1.4), ROUNDING);
  geo_lines_destroy(&one);
  geo_lines_destroy(&three);
}

int main(void) {
  RUN(test_slope_is_read_between_vertices_on_vertices_and_on_both_walls);
  RUN(test_front_of_a_slope_is_where_the_depth_is_reached);
  RUN(test_column_has_its_height_up_to_and_on_its_face);
  RUN(test_water_against_the_right_wall_has_its_front_on_the_wall);
  RUN(test_jet_overhead_does_not_count);
  RUN(test_drops_ahead_do_not_count);
  RUN(test_water_over_a_cavity_does_not_count);
  RUN(test_air_pocket_on_the_bed_is_dry);
  RUN(test_film_on_the_wall_is_read_at_the_wall);
  RUN(test_nothing_is_read_off_no_surface);
  RUN(test_reading_does_not_depend_on_the_cutting);
  return TEST_RESULT;
}

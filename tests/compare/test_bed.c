/* Fronts over beds that are not level, and the walls that they run to. */
#include "compare/bed.h"

#include "tests/compare/shapes.h"
#include "tests/test.h"

static void add(struct geo_lines *l, size_t n, const double (*p)[2]) {
  shape_open(l);
  for (size_t i = 0; i < n; i++) shape_point(l, p[i][0], p[i][1]);
}
#define ADD(l, ...)                                                                                \
  do {                                                                                             \
    const double p_[][2] = {__VA_ARGS__};                                                          \
    add(l, sizeof p_ / sizeof *p_, p_);                                                            \
  } while (0)

static double front(const struct geo_lines *walls, const struct geo_lines *surface,
                    enum cmp_side side, double depth) {
  double x;
  EXPECT_OK(cmp_bed_front(walls, surface, side, depth, &x));
  return x;
}

/* A wedge of water whose surface falls by 1 on 2 to where it meets a slope of 1 on 4. */
static void test_front_on_a_slope_is_where_it_is_so_deep_there(void) {
  struct geo_lines walls = {0}, surface = {0};
  ADD(&walls, {0, 3}, {0, 0.5}, {1, 0.5}, {9, 2.5}, {9, 4});
  ADD(&surface, {0, 2}, {1, 2}, {3, 1});
  /* depth 2 - (x - 1)/2 - 0.5 - (x - 1)/4 */
  EXPECT_NEAR(front(&walls, &surface, CMP_RIGHT, 0.3), 1 + 1.2 / 0.75, 1e-12);
  EXPECT_NEAR(front(&walls, &surface, CMP_RIGHT, 1e-9), 3, 1e-8);
  EXPECT_NEAR(front(&walls, &surface, CMP_LEFT, 0.3), 0, 1e-12);
  EXPECT_NEAR(cmp_bed_foot(&walls, CMP_LEFT), 0, 0);
  EXPECT_NEAR(cmp_bed_foot(&walls, CMP_RIGHT), 9, 0);
  geo_lines_destroy(&walls);
  geo_lines_destroy(&surface);
}

/* Over a step: below its top the front is at its face, above it on it. */
static void test_front_climbs_a_step(void) {
  struct geo_lines walls = {0}, before = {0}, beyond = {0}, column = {0}, against = {0};
  ADD(&walls, {0, 3}, {0, 0}, {2, 0}, {2, 1}, {5, 1}, {5, 3});
  ADD(&before, {0, 2}, {1, 2}, {2, 0.7});
  ADD(&beyond, {0, 2}, {1, 2}, {3, 1});
  ADD(&column, {0, 1.5}, {1, 1.5}, {1, 0});
  ADD(&against, {0, 1.5}, {2, 1.5}, {2, 0.5}); /* as far as its face is dry */
  EXPECT_NEAR(front(&walls, &before, CMP_RIGHT, 0.2), 2, 1e-12);
  EXPECT_NEAR(front(&walls, &beyond, CMP_RIGHT, 0.2), 2.6, 1e-12);
  EXPECT_NEAR(front(&walls, &column, CMP_RIGHT, 0.2), 1, 1e-12);
  EXPECT_NEAR(front(&walls, &against, CMP_RIGHT, 0.2), 2, 1e-12);
  geo_lines_destroy(&walls);
  geo_lines_destroy(&before);
  geo_lines_destroy(&beyond);
  geo_lines_destroy(&column);
  geo_lines_destroy(&against);
}

/* The same seen in a mirror. */
static void test_fronts_are_mirrored(void) {
  struct geo_lines walls = {0}, surface = {0};
  ADD(&walls, {-9, 4}, {-9, 2.5}, {-1, 0.5}, {0, 0.5}, {0, 3});
  ADD(&surface, {-3, 1}, {-1, 2}, {0, 2});
  EXPECT_NEAR(front(&walls, &surface, CMP_LEFT, 0.3), -(1 + 1.2 / 0.75), 1e-12);
  EXPECT_NEAR(cmp_bed_foot(&walls, CMP_LEFT), -9, 0);
  geo_lines_destroy(&walls);
  geo_lines_destroy(&surface);
}

/* A side that leans out by 1 on 2, broken where it does by 1 on 4; and one that leans in. */
static void test_walls_are_as_high_as_they_are_steep(void) {
  struct geo_lines walls = {0}, beach = {0};
  ADD(&walls, {1, 2}, {0, 0}, {4, 0}, {4.5, 1}, {4.75, 2});
  EXPECT_NEAR(cmp_bed_foot(&walls, CMP_RIGHT), 4, 0);
  EXPECT_NEAR(cmp_bed_foot(&walls, CMP_LEFT), 0, 0);
  EXPECT(cmp_bed_is_at_wall(&walls, CMP_RIGHT, (double[]){4.25, 0.5}, 1e-9));
  EXPECT(cmp_bed_is_at_wall(&walls, CMP_RIGHT, (double[]){4.625, 1.5}, 1e-9));
  EXPECT(!cmp_bed_is_at_wall(&walls, CMP_RIGHT, (double[]){4.75, 0.5}, 1e-9));
  EXPECT(!cmp_bed_is_at_wall(&walls, CMP_RIGHT, (double[]){3, 0}, 1e-9));
  EXPECT(!cmp_bed_is_at_wall(&walls, CMP_LEFT, (double[]){4.25, 0.5}, 1e-9));
  EXPECT(cmp_bed_is_at_wall(&walls, CMP_LEFT, (double[]){0.5, 1}, 1e-9));
  ADD(&beach, {0, 2}, {0, 0}, {4, 0}, {8, 2});
  EXPECT_NEAR(cmp_bed_foot(&beach, CMP_RIGHT), 8, 0);
  EXPECT(!cmp_bed_is_at_wall(&beach, CMP_RIGHT, (double[]){6, 1}, 1e-9));
  geo_lines_destroy(&walls);
  geo_lines_destroy(&beach);
}

/* Of a tank with a lid the walls begin where it is highest. */
static void test_walls_with_a_lid(void) {
  struct geo_lines walls = {0};
  EXPECT_OK(geo_lines_begin(&walls, true));
  static const double p[][2] = {{0, 0}, {4, 0}, {4, 2}, {0, 2}};
  for (int i = 0; i < 4; i++) shape_point(&walls, p[i][0], p[i][1]);
  EXPECT_NEAR(cmp_bed_foot(&walls, CMP_RIGHT), 4, 0);
  EXPECT(cmp_bed_is_at_wall(&walls, CMP_RIGHT, (double[]){4, 0.1}, 1e-9));
  EXPECT(cmp_bed_is_at_wall(&walls, CMP_LEFT, (double[]){0, 1.5}, 1e-9));
  geo_lines_destroy(&walls);
}

int main(void) {
  RUN(test_front_on_a_slope_is_where_it_is_so_deep_there);
  RUN(test_front_climbs_a_step);
  RUN(test_fronts_are_mirrored);
  RUN(test_walls_are_as_high_as_they_are_steep);
  RUN(test_walls_with_a_lid);
  return TEST_RESULT;
}

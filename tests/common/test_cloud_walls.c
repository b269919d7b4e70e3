/* Surfaces of clouds of particles between walls that are not those of a plain tank. */
#include "tests/common/swarm.h"

/* The same tank with its bed in five parts, and as a closed box: the images are the same. */
static void test_walls_may_be_cut_and_closed(void) {
  struct swarm c = {0};
  struct geo_lines walls[3] = {{0}}, l[3] = {{0}};
  double wide = 60 * dx, high = 50 * dx;
  tank(&walls[0], wide, high);
  EXPECT_OK(geo_lines_begin(&walls[1], false));
  EXPECT_OK(geo_lines_add(&walls[1], 0, high));
  for (int i = 0; i <= 5; i++) EXPECT_OK(geo_lines_add(&walls[1], wide * i / 5, 0));
  EXPECT_OK(geo_lines_add(&walls[1], wide, high));
  EXPECT_OK(geo_lines_begin(&walls[2], true));
  EXPECT_OK(geo_lines_add(&walls[2], wide, 0));
  EXPECT_OK(geo_lines_add(&walls[2], wide, high));
  EXPECT_OK(geo_lines_add(&walls[2], 0, high));
  EXPECT_OK(geo_lines_add(&walls[2], 0, 0));
  swarm_block(&c, 0, 0, wide, 7 * dx, dx);
  swarm_block(&c, 50 * dx, 7 * dx, wide, 12 * dx, dx);
  swarm_jitter(&c, 0.1 * dx);
  for (int k = 0; k < 3; k++) extract(&c, NULL, dx, &walls[k], &l[k]);
  EXPECT(l[0].pieces == 1 && !l[0].closed[0]);
  for (int k = 1; k < 3; k++) {
    EXPECT(l[k].points == l[0].points && l[k].pieces == l[0].pieces);
    for (size_t i = 0; i < l[0].points && i < l[k].points; i++) /* rounding of the mirror images */
      EXPECT_NEAR(hypot(l[k].p[i][0] - l[0].p[i][0], l[k].p[i][1] - l[0].p[i][1]), 0, 1e-9 * dx);
  }
  for (int k = 0; k < 3; k++) {
    geo_lines_destroy(&walls[k]);
    geo_lines_destroy(&l[k]);
  }
  swarm_destroy(&c);
}

/* Water that leaves over the top of the right wall is cut straight above it. */
static void test_water_above_the_end_of_a_wall_is_cut_on_its_continuation(void) {
  struct swarm c = {0};
  struct geo_lines walls = {0}, l = {0};
  tank(&walls, 60 * dx, 50 * dx);
  swarm_block(&c, 50 * dx, 55 * dx, 70 * dx, 65 * dx, dx);
  extract(&c, NULL, dx, &walls, &l);
  EXPECT(l.pieces == 1 && !l.closed[0]);
  EXPECT_NEAR(l.p[0][0], 60 * dx, 1e-12);
  EXPECT_NEAR(l.p[l.points - 1][0], 60 * dx, 1e-12);
  EXPECT_NEAR(l.p[0][1], 55 * dx, LATTICE_NOISE); /* the water on the right: from below */
  EXPECT_NEAR(l.p[l.points - 1][1], 65 * dx, LATTICE_NOISE);
  swarm_destroy(&c);
  geo_lines_destroy(&walls);
  geo_lines_destroy(&l);
}

/* A bed that rises at 45 degrees: no curve appears where the walls meet, although the lattice does
 * not follow them. */
static void test_oblique_walls_are_filled(void) {
  struct swarm c = {0};
  struct geo_lines walls = {0}, water = {0}, l = {0};
  const double corner[][2] = {{0, 50}, {0, 0}, {30, 0}, {80, 50}};
  EXPECT_OK(geo_lines_begin(&walls, false));
  EXPECT_OK(geo_lines_begin(&water, true));
  for (int i = 0; i < 4; i++) {
    EXPECT_OK(geo_lines_add(&walls, corner[i][0] * dx, corner[i][1] * dx));
    EXPECT_OK(geo_lines_add(&water, corner[i][0] * dx, corner[i][1] * dx));
  }
  for (int j = 0; j < 20; j++)
    for (int i = 0; i < 80; i++)
      if (geo_lines_contain(&water, (i + 0.25) * dx, (j + 0.5) * dx))
        swarm_add(&c, (i + 0.25) * dx, (j + 0.5) * dx);
  extract(&c, NULL, dx, &walls, &l);
  EXPECT(l.pieces == 1 && !l.closed[0] && l.p[0][0] == 0);
  const double *end = l.p[l.points - 1];
  EXPECT_NEAR(end[0] - 30 * dx, end[1], 1e-12);
  EXPECT_NEAR(end[1], 20 * dx, dx); /* a lattice that stops anywhere within dx of the wall */
  swarm_destroy(&c);
  geo_lines_destroy(&walls);
  geo_lines_destroy(&water);
  geo_lines_destroy(&l);
}

int main(void) {
  RUN(test_walls_may_be_cut_and_closed);
  RUN(test_water_above_the_end_of_a_wall_is_cut_on_its_continuation);
  RUN(test_oblique_walls_are_filled);
  return TEST_RESULT;
}

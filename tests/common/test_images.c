/* Where water goes on behind walls. */
#include "tests/test.h"

#include "common/tank/images.h"

static const double eps = 1e-14;

/* The walls of one piece. */
static struct images images_beside(const double (*p)[2], size_t n, bool closed, double reach,
                                   double beyond) {
  struct images t = {0};
  struct geo_lines walls = {0};
  EXPECT_OK(geo_lines_begin(&walls, closed));
  for (size_t i = 0; i < n; i++) EXPECT_OK(geo_lines_add(&walls, p[i][0], p[i][1]));
  EXPECT_OK(images_set_walls(&t, &walls, 0));
  images_set_reach(&t, reach, beyond);
  geo_lines_destroy(&walls);
  return t;
}

/* The images of (x, y) are at these places, in any order, and each is where its motion takes the
 * point. */
static void expect_images(struct images *t, double x, double y, size_t n, const double (*at)[2]) {
  EXPECT(images_of(t, x, y) == n);
  for (size_t k = 0; k < n; k++) {
    const struct image *image = &t->found[k];
    const struct rigid *m = images_motion(t, image->motion);
    double to[2], nearest = 1;
    rigid_turn(m, x, y, &to[0], &to[1]);
    EXPECT_NEAR(m->at[0] + to[0], image->x, eps);
    EXPECT_NEAR(m->at[1] + to[1], image->y, eps);
    for (size_t l = 0; l < n; l++)
      nearest = fmin(nearest, hypot(at[k][0] - t->found[l].x, at[k][1] - t->found[l].y));
    EXPECT_NEAR(nearest, 0, eps);
  }
}

/* How many of the images that a point has where it is found count where it has gone. */
static size_t counting(struct images *t, const double found[2], double x, double y) {
  size_t n = images_of(t, found[0], found[1]), count = 0;
  for (size_t k = 0; k < n; k++) count += images_counts(t, t->found[k].motion, x, y);
  return count;
}

/* In the line through (1, 0) and (2, 2): the foot of (4, 1) is (2, 2), its image (0, 3). What runs
 * along the line stays, what crosses it turns back. */
static void test_motions_are_those_of_the_plane(void) {
  const double a[2] = {1, 0}, b[2] = {2, 2}, way[3][2] = {{4, 1}, {1, 2}, {-2, 1}};
  const double turned[2][3][2] = {{{-1.6, 3.8}, {1, 2}, {2, -1}}, {{-4, -1}, {-1, -2}, {2, -1}}};
  const struct rigid motion[2] = {rigid_mirror(a, b), rigid_half_turn(b)};
  const double image[2][2] = {{0, 3}, {0, 3}};
  for (int m = 0; m < 2; m++)
    for (int k = 0; k < 3; k++) {
      double x, y;
      rigid_turn(&motion[m], way[k][0], way[k][1], &x, &y);
      EXPECT_NEAR(x, turned[m][k][0], eps);
      EXPECT_NEAR(y, turned[m][k][1], eps);
      if (k > 0) continue;
      EXPECT_NEAR(motion[m].at[0] + x, image[m][0], eps);
      EXPECT_NEAR(motion[m].at[1] + y, image[m][1], eps);
    }
}

static const double tank[4][2] = {{0, 2}, {0, 0}, {3, 0}, {3, 1}};

/* To the bit: where upright and flat walls are is not rounded. */
static void test_mirrors_in_upright_and_flat_walls_are_exact(void) {
  const double shifted[4][2] = {{0.1, 2.3}, {0.1, 0.7}, {3.3, 0.7}, {3.3, 1.9}};
  struct images t = images_beside(shifted, 4, false, 0.5, 0);
  for (uint32_t wall = 0; wall < 3; wall++) {
    const struct rigid *m = images_motion(&t, 2 * wall);
    const double sign = wall == 1 ? 1 : -1;
    EXPECT(m->M[0][0] == sign && m->M[1][1] == -sign && m->M[0][1] == 0 && m->M[1][0] == 0);
    EXPECT(m->at[0] == (wall == 1 ? 0 : 2 * shifted[wall][0]));
    EXPECT(m->at[1] == (wall == 1 ? 1.4 : 0));
  }
  images_destroy(&t);
}

static void test_a_corner_has_three_images(void) {
  struct images t = images_beside(tank, 4, false, 0.5, 0);
  expect_images(&t, 0.1, 0.2, 3, (const double[][2]){{-0.1, 0.2}, {0.1, -0.2}, {-0.1, -0.2}});
  expect_images(&t, 2.9, 0.2, 3, (const double[][2]){{3.1, 0.2}, {2.9, -0.2}, {3.1, -0.2}});
  expect_images(&t, 0.1, 0.6, 1, (const double[][2]){{-0.1, 0.6}});
  expect_images(&t, 1.5, 0.2, 1, (const double[][2]){{1.5, -0.2}});
  expect_images(&t, 0.6, 0.5, 0, NULL);
  images_destroy(&t);
}

/* Water that is through one wall of a corner, or both, is found a little beyond, and goes on behind
 * the other too. */
static void test_a_corner_keeps_its_images_through_the_wall(void) {
  struct images t = images_beside(tank, 4, false, 0.5, 0.1);
  const double inside[2] = {0.01, 0.2};
  expect_images(&t, -0.01, 0.2, 3, (const double[][2]){{0.01, 0.2}, {-0.01, -0.2}, {0.01, -0.2}});
  EXPECT(counting(&t, inside, -0.01, 0.2) == 3);
  EXPECT(counting(&t, inside, 0.2, -0.01) == 3);
  EXPECT(counting(&t, inside, -0.01, -0.01) == 3);
  expect_images(&t, -0.11, 0.2, 1, (const double[][2]){{0.11, 0.2}});
  images_destroy(&t);
}

/* Beyond the top an image may be found, but counts only for a point that has come back. */
static void test_nothing_above_the_end_of_a_wall_counts(void) {
  const double above[2] = {2.9, 1.05};
  struct images t = images_beside(tank, 4, false, 0.5, 0);
  expect_images(&t, 2.9, 1.05, 0, NULL);
  images_set_reach(&t, 0.5, 0.1);
  expect_images(&t, 2.9, 1.05, 1, (const double[][2]){{3.1, 1.05}});
  expect_images(&t, 2.9, 1.15, 0, NULL);
  EXPECT(counting(&t, above, 2.9, 1.05) == 0);
  EXPECT(counting(&t, above, 2.9, 0.95) == 1);
  EXPECT(counting(&t, above, 2.9, 1) == 0);
  const double left[2] = {0.1, 1.95};
  EXPECT(counting(&t, left, 0.1, 1.95) == 1 && counting(&t, left, 0.1, 2.05) == 0);
  images_destroy(&t);
}

/* A wall no higher than the reach: the image in the corner counts where that in the side does. */
static void test_a_low_wall_has_no_corner_above_its_top(void) {
  const double low[4][2] = {{0, 0.3}, {0, 0}, {3, 0}, {3, 0.3}}, below[2] = {0.1, 0.25};
  struct images t = images_beside(low, 4, false, 0.5, 0.1);
  EXPECT(counting(&t, below, 0.1, 0.25) == 3);
  EXPECT(counting(&t, below, 0.1, 0.35) == 1);
  images_destroy(&t);
}

/* A bed that turns up by atan(3/4): water in the middle has its foot on both, and one image more
 * about the vertex; what is on one side of it has one image. */
static const double beach[3][2] = {{-5, 0}, {0, 0}, {4, 3}};

static void test_an_obtuse_corner_is_filled_once(void) {
  struct images t = images_beside(beach, 3, false, 1, 0);
  expect_images(&t, -0.3, 0.9, 3, (const double[][2]){{-0.3, -0.9}, {0.78, -0.54}, {0.3, -0.9}});
  expect_images(&t, -1, 0.5, 1, (const double[][2]){{-1, -0.5}});
  expect_images(&t, 1, 1, 1, (const double[][2]){{1.24, 0.68}});
  images_destroy(&t);
}

/* There is water beyond the ends: what passes them has the images of where it goes. */
static void test_images_at_an_obtuse_corner_count_where_the_foot_is(void) {
  struct images t = images_beside(beach, 3, false, 1, 0.5);
  const double middle[2] = {-0.3, 0.9};
  EXPECT(counting(&t, middle, -0.3, 0.9) == 3);
  EXPECT(counting(&t, middle, 0.1, 0.9) == 1);
  EXPECT(counting(&t, middle, -0.7, 0.9) == 1);
  images_destroy(&t);
}

/* Seen from the right of it, the same corner is no tank's. */
static void test_the_outside_of_a_corner_is_not_sharp(void) {
  const double step[3][2] = {{0, 0}, {0, 2}, {3, 2}}, on_top[2] = {0.11, 2.1};
  struct images t = images_beside(step, 3, false, 0.5, 0.1);
  EXPECT(counting(&t, on_top, 0.11, 2.1) == 1);
  EXPECT(counting(&t, on_top, 0.09, 2.1) == 0); /* its image is the other face's */
  EXPECT(counting(&t, on_top, -0.01, 2.1) == 0);
  expect_images(&t, 0.15, 2.2, 0, NULL);
  expect_images(&t, -0.15, 1.8, 1, (const double[][2]){{0.15, 1.8}});
  images_destroy(&t);
}

/* Anywhere along it, vertices included, exactly one image counts. */
static void test_points_along_a_straight_wall_are_no_matter(void) {
  const double p[5][2] = {{-1, 0}, {0.3, 0}, {0.7, 0}, {0.71, 0}, {3, 0}};
  struct images t = images_beside(p, 5, false, 0.5, 0.1);
  for (int k = 0; k < 200; k++) {
    const double x = k / 100., y = 0.2385, here[2] = {x, y};
    EXPECT(counting(&t, here, x, y) == 1);
    EXPECT(counting(&t, here, x + 0.02, y) == 1);
  }
  images_set_reach(&t, 0.5, 0);
  for (int k = 0; k < 200; k++) {
    EXPECT(images_of(&t, k / 100., 0.2385) == 1);
    EXPECT_NEAR(t.found[0].y, -0.2385, eps);
  }
  images_destroy(&t);
}

/* All four corners of a basin, that at which it closes too. */
static void test_a_closed_wall_has_a_corner_where_it_closes(void) {
  const double basin[4][2] = {{0, 0}, {2, 0}, {2, 1}, {0, 1}}, inside[2] = {0.1, 0.2};
  struct images t = images_beside(basin, 4, true, 0.5, 0.1);
  expect_images(&t, 0.1, 0.2, 3, (const double[][2]){{-0.1, 0.2}, {0.1, -0.2}, {-0.1, -0.2}});
  expect_images(&t, 1.9, 0.2, 3, (const double[][2]){{2.1, 0.2}, {1.9, -0.2}, {2.1, -0.2}});
  expect_images(&t, 1.9, 0.9, 3, (const double[][2]){{2.1, 0.9}, {1.9, 1.1}, {2.1, 1.1}});
  expect_images(&t, 0.1, 0.9, 3, (const double[][2]){{-0.1, 0.9}, {0.1, 1.1}, {-0.1, 1.1}});
  EXPECT(counting(&t, inside, -0.01, 0.2) == 3);
  EXPECT(counting(&t, inside, 0.1, -0.01) == 3);
  images_destroy(&t);
}

/* The way from i to the image of j is the way from j to that of i by the same motion, turned with
 * it and round: what mirror walls rest on (mirror.c). */
static void test_ways_to_images_are_images_of_ways(void) {
  struct images t = images_beside(beach, 3, false, 1, 0.5);
  const double i[2] = {-0.21, 0.33}, j[2] = {0.4, 0.52};
  for (uint32_t k = 0; k < 4; k++) {
    const struct rigid *m = images_motion(&t, k);
    double ji[2], ij[2], turned[2];
    rigid_turn(m, j[0], j[1], &ij[0], &ij[1]);
    rigid_turn(m, i[0], i[1], &ji[0], &ji[1]);
    for (int d = 0; d < 2; d++) {
      ij[d] += m->at[d] - i[d];
      ji[d] += m->at[d] - j[d];
    }
    rigid_turn(m, ij[0], ij[1], &turned[0], &turned[1]);
    EXPECT_NEAR(ji[0], -turned[0], eps * 10);
    EXPECT_NEAR(ji[1], -turned[1], eps * 10);
  }
  images_destroy(&t);
}

int main(void) {
  RUN(test_motions_are_those_of_the_plane);
  RUN(test_mirrors_in_upright_and_flat_walls_are_exact);
  RUN(test_a_corner_has_three_images);
  RUN(test_a_corner_keeps_its_images_through_the_wall);
  RUN(test_nothing_above_the_end_of_a_wall_counts);
  RUN(test_a_low_wall_has_no_corner_above_its_top);
  RUN(test_an_obtuse_corner_is_filled_once);
  RUN(test_images_at_an_obtuse_corner_count_where_the_foot_is);
  RUN(test_the_outside_of_a_corner_is_not_sharp);
  RUN(test_points_along_a_straight_wall_are_no_matter);
  RUN(test_a_closed_wall_has_a_corner_where_it_closes);
  RUN(test_ways_to_images_are_images_of_ways);
  return TEST_RESULT;
}

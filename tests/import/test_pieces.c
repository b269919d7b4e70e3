/* Contours and profiles become surfaces with the water on their right. */
#include "import/pieces.h"

#include <stdlib.h>

#include "common/base/array.h"
#include "import/gap.h"
#include "tests/test.h"

enum { MOST = 200 };
static double x[MOST * MOST], y[MOST * MOST], field[MOST * MOST];
static struct import_mesh mesh;

/* n x n nodes on [0, 1] x [0, 1], squares cut in two by turns; every other triangle goes round the
 * other way. */
static void lay(size_t n) {
  free(mesh.corner);
  mesh = (struct import_mesh){0};
  EXPECT_OK(array_create(&mesh.corner, 6 * n * n, "corners"));
  for (size_t j = 0; j < n; j++)
    for (size_t i = 0; i < n; i++) {
      x[j * n + i] = (double)i / (double)(n - 1);
      y[j * n + i] = (double)j / (double)(n - 1);
    }
  for (size_t j = 0; j + 1 < n; j++)
    for (size_t i = 0; i + 1 < n; i++) {
      const size_t a = j * n + i, b = a + 1, c = b + n, d = a + n;
      const bool turn = (i + j) % 2;
      const size_t corner[6] = {a, b, turn ? d : c, turn ? d : c, turn ? c : d, turn ? b : a};
      for (int k = 0; k < 6; k++) mesh.corner[3 * mesh.n + (size_t)k] = corner[k];
      mesh.n += 2;
    }
}

/* Area inside a drop by the contour of its distance function; and by that of a cavity. */
static double area_of_disc(size_t n, bool below) {
  struct geo_lines l = {0};
  lay(n);
  for (size_t i = 0; i < n * n; i++) field[i] = 0.31 - hypot(x[i] - 0.52, y[i] - 0.47);
  EXPECT_OK(import_contour("disc", n * n, x, y, field, &mesh, 0, below, &l));
  EXPECT(l.pieces == 1 && l.closed[0]);
  const double area = l.pieces ? geo_piece_area(&l, 0) : NAN;
  geo_lines_destroy(&l);
  return area;
}

static void test_disc_is_clockwise_and_of_second_order(void) {
  const double exact = M_PI * 0.31 * 0.31;
  double error[3];
  for (int k = 0; k < 3; k++) {
    error[k] = fabs(area_of_disc((size_t)(20 << k) + 1, false) + exact);
    EXPECT_NEAR(area_of_disc((size_t)(20 << k) + 1, true), exact, 2 * error[k]);
  }
  EXPECT(log2(error[0] / error[2]) / 2 > 1.7); /* 2 by theory */
}

static void test_slope_runs_from_left_to_right_through_nodes_and_between_them(void) {
  struct geo_lines l = {0};
  const size_t n = 12;
  lay(n);
  for (int k = 0; k < 2; k++) { /* the second one goes through a row of nodes */
    const double level = k ? 5.0 / 11 : 0.4321;
    for (size_t i = 0; i < n * n; i++) field[i] = -y[i] + (k ? 0 : 0.2 * x[i]);
    EXPECT_OK(import_contour("slope", n * n, x, y, field, &mesh, -level, false, &l));
    EXPECT(l.pieces == 1 && !l.closed[0]);
    EXPECT(l.p[0][0] == 0 && l.p[l.points - 1][0] == 1);
    for (size_t i = 0; i < l.points; i++) /* linear: exact but for rounding */
      EXPECT_NEAR(l.p[i][1], level + (k ? 0 : 0.2 * l.p[i][0]), 1e-14);
    for (size_t i = 1; i < l.points; i++) EXPECT(l.p[i][0] > l.p[i - 1][0]);
  }
  EXPECT(import_contour("none", n * n, x, y, field, &mesh, 3, false, &l) == ERR_INPUT);
  field[7] = NAN;
  EXPECT(import_contour("hole", n * n, x, y, field, &mesh, -0.5, false, &l) == ERR_INPUT);
  geo_lines_destroy(&l);
}

static void test_profile_closes_and_turns(void) {
  static const double px[] = {2, 1, 0, 0.5, 0.7, 0.7, 0.5}, py[] = {1, 1.1, 1, 0.2, 0.2, 0.4, 0.2};
  static const double piece[] = {1, 1, 1, 2, 2, 2, 2};
  struct geo_lines l = {0};
  EXPECT_OK(import_profile("p", 0, 0.1, 7, px, py, piece, &l));
  EXPECT(l.pieces == 2 && l.points == 6 && !l.closed[0] && l.closed[1]);
  EXPECT(l.p[0][0] == 0 && l.p[2][0] == 2);
  EXPECT_NEAR(geo_piece_area(&l, 1), 0.02, 1e-15); /* a cavity, which was written so */
  EXPECT(import_profile("p", 0, 0.1, 1, px, py, NULL, &l) == ERR_INPUT);
  geo_lines_destroy(&l);
}

enum { CORNERS = 101 };

/* Appends a circle whose last point is its first but for the rounding of sines, and more. */
static size_t add_circle(size_t at, double *piece, double radius, double more) {
  for (size_t i = 0; i < CORNERS; i++) {
    const double angle = 2 * M_PI * (double)i / (CORNERS - 1);
    piece[at + i] = radius;
    x[at + i] = 2 + radius * cos(angle);
    y[at + i] = 2 + radius * sin(angle) + (i + 1 == CORNERS ? more : 0);
  }
  return at + CORNERS;
}

static void test_pieces_close_but_for_rounding(void) {
  static double piece[MOST];
  struct geo_lines l = {0};
  add_circle(0, piece, 0.5, 0);
  EXPECT(y[CORNERS - 1] != y[0]); /* sin 2 pi is not 0 */
  EXPECT_OK(import_profile("p", 0, 0.01, CORNERS, x, y, NULL, &l));
  EXPECT(l.pieces == 1 && l.closed[0] && l.points == CORNERS - 1);
  add_circle(0, piece, 0.5, 1e-6); /* as six digits have it */
  EXPECT_OK(import_profile("p", 0, 0.01, CORNERS, x, y, NULL, &l));
  EXPECT(l.closed[0]);
  add_circle(0, piece, 0.5, 0.005); /* half a spacing is a gap */
  EXPECT_OK(import_profile("p", 0, 0.01, CORNERS, x, y, NULL, &l));
  EXPECT(!l.closed[0]);
  geo_lines_destroy(&l);
}

/* A drop in a hole in a drop, in whichever order and direction, beside the open surface. */
static void test_holes_of_drops_are_air(void) {
  static double piece[4 * CORNERS + 2];
  static const double radius[] = {0.9, 0.6, 0.3};
  const double corners = 0.5 * (CORNERS - 1) * sin(2 * M_PI / (CORNERS - 1)); /* area over r^2 */
  struct geo_lines l = {0};
  for (size_t turn = 0; turn < 3; turn++) {
    size_t n = 0;
    for (size_t k = 0; k < 3; k++) n = add_circle(n, piece, radius[(k + turn) % 3], 0);
    for (size_t k = 0; k < 2; k++, n++) {
      piece[n] = -1;
      x[n] = 4 * (double)k;
      y[n] = 0.5;
    }
    EXPECT_OK(import_profile("p", 0, 0.01, n, x, y, piece, &l));
    EXPECT(l.pieces == 4);
    for (size_t k = 0; k < 3 && l.pieces == 4; k++) {
      const double r = radius[(k + turn) % 3], sign = r == 0.6 ? 1 : -1; /* air: to the left */
      EXPECT_NEAR(geo_piece_area(&l, k), sign * corners * r * r, 1e-13);
    }
  }
  /* under the surface all is the other way round */
  y[3 * CORNERS] = y[3 * CORNERS + 1] = 3.5;
  EXPECT_OK(import_profile("p", 0, 0.01, 3 * CORNERS + 2, x, y, piece, &l));
  for (size_t k = 0; k < 3; k++)
    EXPECT((geo_piece_area(&l, k) > 0) == (radius[(k + 2) % 3] != 0.6));
  geo_lines_destroy(&l);
}

static void test_points_in_one_place_are_no_profile(void) {
  static const double same[] = {1, 1, 1, 1, 1};
  struct geo_lines l = {0};
  for (size_t n = 2; n <= 5; n++)
    EXPECT(import_profile("p", 0, 0.1, n, same, same, NULL, &l) == ERR_INPUT);
  geo_lines_destroy(&l);
}

static void test_walls_move_into_the_water(void) {
  static const double tank[4][2] = {{0, 2}, {0, 0}, {3, 0}, {3, 2}};
  struct geo_lines walls = {0}, moved = {0};
  EXPECT_OK(geo_lines_begin(&walls, false));
  for (int i = 0; i < 4; i++) EXPECT_OK(geo_lines_add(&walls, tank[i][0], tank[i][1]));
  EXPECT_OK(import_gap(&walls, 0.25, &moved));
  EXPECT(moved.pieces == 1 && moved.points == 4);
  static const double inside[4][2] = {{0.25, 2}, {0.25, 0.25}, {2.75, 0.25}, {2.75, 2}};
  for (size_t i = 0; i < 4 && i < moved.points; i++)
    for (int k = 0; k < 2; k++) EXPECT_NEAR(moved.p[i][k], inside[i][k], 1e-14);
  EXPECT(import_gap(&walls, 5, &moved) != OK); /* there is no room */
  geo_lines_destroy(&walls);
  geo_lines_destroy(&moved);
}

int main(void) {
  RUN(test_disc_is_clockwise_and_of_second_order);
  RUN(test_slope_runs_from_left_to_right_through_nodes_and_between_them);
  RUN(test_profile_closes_and_turns);
  RUN(test_pieces_close_but_for_rounding);
  RUN(test_holes_of_drops_are_air);
  RUN(test_points_in_one_place_are_no_profile);
  RUN(test_walls_move_into_the_water);
  free(mesh.corner);
  return TEST_RESULT;
}

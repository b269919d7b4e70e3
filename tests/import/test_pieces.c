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
  EXPECT_OK(import_profile("p", 0, 7, px, py, piece, &l));
  EXPECT(l.pieces == 2 && l.points == 6 && !l.closed[0] && l.closed[1]);
  EXPECT(l.p[0][0] == 0 && l.p[2][0] == 2);
  EXPECT_NEAR(geo_piece_area(&l, 1), 0.02, 1e-15); /* a cavity, which was written so */
  EXPECT(import_profile("p", 0, 1, px, py, NULL, &l) == ERR_INPUT);
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
  RUN(test_walls_move_into_the_water);
  free(mesh.corner);
  return TEST_RESULT;
}

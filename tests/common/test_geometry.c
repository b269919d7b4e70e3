#include "common/base/geometry.h"
#include "common/base/geometry_check.h"
#include "tests/test.h"

static void square(struct geo_lines *l, double x, double y, double side) {
  EXPECT_OK(geo_lines_begin(l, true));
  EXPECT_OK(geo_lines_add(l, x, y));
  EXPECT_OK(geo_lines_add(l, x + side, y));
  EXPECT_OK(geo_lines_add(l, x + side, y + side));
  EXPECT_OK(geo_lines_add(l, x, y + side));
}

static void test_area_and_length_of_a_square(void) {
  struct geo_lines l = {0};
  square(&l, 1e6, -3, 2.385);
  EXPECT_NEAR(geo_piece_area(&l, 0), 2.385 * 2.385, 1e-9); /* rounding of 1e6 + 2.385 */
  EXPECT_NEAR(geo_piece_length(&l, 0), 4 * 2.385, 1e-9);
  geo_lines_destroy(&l);
}

static void test_containment_in_two_pieces(void) {
  struct geo_lines l = {0};
  square(&l, 0, 0, 1);
  square(&l, 3, 0, 1);
  EXPECT(geo_lines_contain(&l, 0.5, 0.5) && geo_lines_contain(&l, 3.9, 0.1));
  EXPECT(!geo_lines_contain(&l, 2, 0.5) && !geo_lines_contain(&l, 0.5, 1.01));
  struct geo_box box = geo_lines_box(&l);
  EXPECT(box.min[0] == 0 && box.max[0] == 4 && box.max[1] == 1);
  geo_lines_destroy(&l);
}

static void test_copy_keeps_offsets(void) {
  struct geo_lines a = {0}, b = {0};
  square(&a, 0, 0, 1);
  EXPECT_OK(geo_lines_begin(&a, false));
  EXPECT_OK(geo_lines_add(&a, 7, 8));
  EXPECT_OK(geo_lines_copy(&b, &a));
  EXPECT(b.pieces == 2 && b.points == 5 && b.first[2] == 5 && b.closed[0] && !b.closed[1]);
  EXPECT(b.p[4][0] == 7 && b.p[4][1] == 8);
  geo_lines_destroy(&a);
  geo_lines_destroy(&b);
}

static void add_polygon(struct geo_lines *l, size_t n, const double (*p)[2]) {
  EXPECT_OK(geo_lines_begin(l, true));
  for (size_t i = 0; i < n; i++) EXPECT_OK(geo_lines_add(l, p[i][0], p[i][1]));
}

/* A U and a square on one of its arms: two bodies on a row above the notch, one on a column. */
static void test_cuts_join_pieces_that_touch(void) {
  static const double U[8][2] = {{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  struct geo_lines l = {0};
  struct geo_cut cut = {0};
  add_polygon(&l, 8, U);
  square(&l, 0, 2 + 1e-10, 1);
  EXPECT_OK(geo_lines_cut(&l, 1, 1.5, 1e-9, &cut));
  EXPECT(cut.n == 2 && cut.span[0][0] == 0 && cut.span[0][1] == 1 && cut.span[1][0] == 2);
  EXPECT(geo_cut_span(&cut, 1.6) == cut.span[1] && geo_cut_span(&cut, -4) == cut.span[0]);
  EXPECT_OK(geo_lines_cut(&l, 0, 0.5, 1e-9, &cut));
  EXPECT(cut.n == 1 && cut.span[0][0] == 0 && cut.span[0][1] == 3 + 1e-10);
  EXPECT_OK(geo_lines_cut(&l, 0, 0.5, 1e-11, &cut));
  EXPECT(cut.n == 2);
  EXPECT_OK(geo_lines_cut(&l, 0, 3.5, 1e-9, &cut));
  EXPECT(cut.n == 0 && !geo_cut_span(&cut, 0));
  geo_cut_destroy(&cut);
  geo_lines_destroy(&l);
}

/* A block with a film: the film is found, with its area and thickness; a film on top of a layer is
 * as thick as both; pointed corners are not thin; a drop below the least area counts as a whole. */
static void test_thin_parts_are_found(void) {
  static const double film[6][2] = {{0, 0}, {3, 0}, {3, 0.02}, {1, 0.02}, {1, 1}, {0, 1}};
  static const double layer[4][2] = {{1, 0.02}, {3, 0.02}, {3, 0.3}, {1, 0.3}};
  static const double wedge[3][2] = {{0, 0}, {9, 0}, {0, 1}};
  struct geo_lines l = {0};
  double area, thickness, at[2] = {0};
  add_polygon(&l, 6, film);
  EXPECT_OK(geo_lines_thin(&l, 0.1, 0.01, &area, &thickness, at));
  EXPECT_NEAR(area, 0.04, 1e-9);
  EXPECT_NEAR(thickness, 0.02, 1e-9);
  EXPECT(at[0] > 1 && at[0] < 3 && at[1] > 0 && at[1] < 0.02);
  EXPECT_OK(geo_lines_thin(&l, 0.0199, 0.01, &area, &thickness, at));
  EXPECT(area == 0);
  add_polygon(&l, 4, layer);
  EXPECT_OK(geo_lines_thin(&l, 0.1, 0.01, &area, &thickness, at));
  EXPECT(area == 0);
  square(&l, 7, 7, 0.09);
  EXPECT_OK(geo_lines_thin(&l, 0.1, 0.01, &area, &thickness, at));
  EXPECT_NEAR(area, 0.09 * 0.09, 1e-12);
  geo_lines_clear(&l);
  add_polygon(&l, 3, wedge);
  EXPECT_OK(geo_lines_thin(&l, 0.1, 0.01, &area, &thickness, at));
  EXPECT(area == 0);
  geo_lines_destroy(&l);
}

int main(void) {
  RUN(test_area_and_length_of_a_square);
  RUN(test_containment_in_two_pieces);
  RUN(test_copy_keeps_offsets);
  RUN(test_cuts_join_pieces_that_touch);
  RUN(test_thin_parts_are_found);
  return TEST_RESULT;
}

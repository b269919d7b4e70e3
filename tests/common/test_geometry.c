#include "common/geometry.h"
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

int main(void) {
  RUN(test_area_and_length_of_a_square);
  RUN(test_containment_in_two_pieces);
  RUN(test_copy_keeps_offsets);
  return TEST_RESULT;
}

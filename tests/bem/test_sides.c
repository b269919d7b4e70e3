/* Where a surface comes near itself or a wall, on shapes of which that is known. Water is on the
 * right of the way along the nodes. */
#include "bem/breaker.h"
#include "tests/test.h"

enum { N = 801, ROOM = 3 * N };

struct shape {
  struct bem_surface surface;
  struct bem_sides sides;
  double state[ROOM];
};

static void shape_create(struct shape *q, double tank) {
  *q = (struct shape){
      .surface = {.n = N, .right = BEM_END_WALL, .tank = tank, .length = tank, .depth = 0.5}};
  EXPECT_OK(bem_sides_reserve(&q->sides, N));
  q->surface.state = q->state;
}

static void put(struct shape *q, size_t k, bool mirrored, double x, double y) {
  const size_t at = mirrored ? N - 1 - k : k;
  q->state[at] = mirrored ? q->surface.tank - x : x;
  q->state[N + at] = y;
}

/* From x = 0 at y = 0.5 to the right, back in the roof of a cavity, round a tip of this radius at
 * (2, 0.5 + gap + radius), and to the right wall at x = 4: a jet to the left; or mirrored. */
static void put_jet(struct shape *q, bool mirrored, double gap, double radius) {
  const double roof = 0.5 + gap, r = gap / 2;
  for (size_t k = 0; k < 300; k++) put(q, k, mirrored, 3 * (double)k / 300, 0.5);
  for (size_t k = 300; k < 400; k++) {
    const double a = M_PI * (double)(k - 300) / 100;
    put(q, k, mirrored, 3 + r * sin(a), 0.5 + r - r * cos(a));
  }
  for (size_t k = 400; k < 500; k++) put(q, k, mirrored, 3 - (double)(k - 400) / 100, roof);
  for (size_t k = 500; k < 600; k++) {
    const double a = M_PI * (double)(k - 500) / 100;
    put(q, k, mirrored, 2 - radius * sin(a), roof + radius - radius * cos(a));
  }
  for (size_t k = 600; k < N; k++)
    put(q, k, mirrored, 2 + 2 * (double)(k - 600) / (N - 601), roof + 2 * radius);
}

static void test_a_cavity_is_as_narrow_as_it_is_to_either_side(void) {
  struct shape q;
  for (int mirrored = 0; mirrored < 2; mirrored++)
    for (double gap = 0.2; gap > 1e-3; gap /= 3) {
      struct bem_near near;
      shape_create(&q, 4);
      put_jet(&q, mirrored, gap, 0.1);
      EXPECT_NEAR(bem_breaker_gap(&q.sides, &q.surface, q.state, 1, &near), gap, 1e-6);
      EXPECT(!near.wall && bem_breaker_falls(&q.surface, q.state, &near));
      bem_sides_destroy(&q.sides);
    }
}

static void test_a_sheet_is_as_thick_as_it_is_and_its_tip_is_none(void) {
  struct shape q;
  struct bem_near near;
  shape_create(&q, 4);
  put_jet(&q, false, 0.3, 0.01);
  bem_sides_set(&q.sides, &q.surface, q.state);
  EXPECT(bem_sides_narrowest(&q.sides, &q.surface, q.state, BEM_WATER, 0.1, &near));
  EXPECT_NEAR(near.distance, 0.02, 1e-6);
  EXPECT(!bem_sides_across(&q.sides, &q.surface, q.state, 550, BEM_WATER, 0.1, &near));
  EXPECT(bem_sides_across(&q.sides, &q.surface, q.state, 450, BEM_WATER, 0.1, &near));
  EXPECT(bem_sides_wall_across(&q.sides, &q.surface, q.state, 150, BEM_WATER, 0.6, &near));
  EXPECT_NEAR(near.distance, 0.5, 1e-12);
  bem_sides_destroy(&q.sides);
}

static void test_faces_that_hang_over_have_the_side_to_which_they_break(void) {
  struct shape q;
  double where;
  for (int mirrored = 0; mirrored < 2; mirrored++) {
    const enum bem_face own = mirrored ? BEM_FALLING : BEM_RISING,
                        other = mirrored ? BEM_RISING : BEM_FALLING;
    shape_create(&q, 4);
    put_jet(&q, mirrored, 0.3, 0.1);
    EXPECT_NEAR(bem_breaker_tangent(&q.surface, q.state, own, &where), -1, 1e-3);
    EXPECT(bem_breaker_tangent(&q.surface, q.state, other, &where) > 0.9);
    bem_sides_destroy(&q.sides);
  }
}

/* A jet pushed into the water below it closes round air, one pinched off is a loop of water. */
static void test_loops_hold_what_the_surface_runs_round(void) {
  struct shape q;
  struct bem_near near;
  struct bem_crossing c;
  for (int mirrored = 0; mirrored < 2; mirrored++) {
    shape_create(&q, 4);
    put_jet(&q, mirrored, 0.3, 0.1);
    for (size_t k = 540; k <= 560; k++) q.state[N + (mirrored ? N - 1 - k : k)] = 0.45;
    EXPECT(bem_breaker_gap(&q.sides, &q.surface, q.state, 1, &near) < 0);
    EXPECT(bem_breaker_falls(&q.surface, q.state, &near));
    EXPECT(bem_sides_cross(&q.sides, &q.surface, q.state, 0, &c) && c.area < -0.2);
    put_jet(&q, mirrored, 0.3, 0.1);
    for (size_t k = 440; k <= 460; k++) q.state[N + (mirrored ? N - 1 - k : k)] += 0.25;
    bem_sides_set(&q.sides, &q.surface, q.state);
    EXPECT(bem_sides_cross(&q.sides, &q.surface, q.state, 0, &c) && c.area > 0.05);
    EXPECT(bem_breaker_gap(&q.sides, &q.surface, q.state, 1, &near) > 0);
    bem_sides_destroy(&q.sides);
  }
}

static void test_a_jet_strikes_a_wall_through_air(void) {
  struct shape q;
  struct bem_near near;
  shape_create(&q, 4);
  put_jet(&q, false, 0.3, 0.1);
  for (size_t k = 0; k < 300; k++) put(&q, k, false, 1.92 + 1.08 * (double)k / 300, 0.5);
  for (size_t k = 0; k < N; k++) q.state[k] -= 1.92;
  q.surface.tank -= 1.92;
  EXPECT(bem_breaker_gap(&q.sides, &q.surface, q.state, 1, &near) < 0);
  EXPECT(near.wall && !bem_breaker_falls(&q.surface, q.state, &near));
  EXPECT_NEAR(near.distance, -0.02, 1e-3);
  EXPECT_NEAR(near.y, 0.9, 0.01);
  bem_sides_destroy(&q.sides);
}

int main(void) {
  RUN(test_a_cavity_is_as_narrow_as_it_is_to_either_side);
  RUN(test_a_sheet_is_as_thick_as_it_is_and_its_tip_is_none);
  RUN(test_faces_that_hang_over_have_the_side_to_which_they_break);
  RUN(test_loops_hold_what_the_surface_runs_round);
  RUN(test_a_jet_strikes_a_wall_through_air);
  return TEST_RESULT;
}

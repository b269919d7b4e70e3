/* Where a surface comes near itself or a wall, on shapes of which that is known. Water is on the
 * right of the way along the nodes. */
#include <complex.h>
#include <stdlib.h>

#include "bem/breaking/breaker.h"
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
  EXPECT_OK(bem_sides_reserve(&q->sides, &q->surface));
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

/* Distance of node k from the nearest place that is three times as far along and faces it. */
static double across_by_all(const struct shape *q, size_t k, enum bem_between between,
                            double reach) {
  const double *x = q->state, *y = x + N, *arc = q->sides.arc;
  const double complex z = CMPLX(x[k], y[k]);
  double complex out = I * (CMPLX(x[k + 1], y[k + 1]) - CMPLX(x[k - 1], y[k - 1]));
  out *= (between == BEM_AIR ? 1 : -1) / cabs(out);
  for (size_t j = 0; j + 1 < N; j++) {
    const double complex a = CMPLX(x[j], y[j]), way = CMPLX(x[j + 1], y[j + 1]) - a;
    const double u = creal((z - a) * conj(way)) / creal(way * conj(way));
    const double part = fmin(fmax(u, 0), 1);
    const double complex over = a + part * way - z;
    if (j != k && j + 1 != k && cabs(over) < reach && creal(over * conj(out)) >= 0.3 * cabs(over) &&
        fabs(arc[j] + part * (arc[j + 1] - arc[j]) - arc[k]) >= 3 * cabs(over))
      reach = cabs(over);
  }
  return reach;
}

static bool cross_by_all(const struct shape *q, struct bem_crossing *c) {
  const double *x = q->state, *y = x + N;
  for (size_t i = 0; i + 1 < N; i++)
    for (size_t j = i + 2; j + 1 < N; j++) {
      const double ax = x[i + 1] - x[i], ay = y[i + 1] - y[i], bx = x[j + 1] - x[j],
                   by = y[j + 1] - y[j], cx = x[j] - x[i], cy = y[j] - y[i],
                   over = ax * by - ay * bx, u = (cx * by - cy * bx) / over,
                   v = (cx * ay - cy * ax) / over;
      *c = (struct bem_crossing){.first = i, .last = j};
      if (over != 0 && u >= 0 && u < 1 && v >= 0 && v < 1) return true;
    }
  return false;
}

/* Of a closed chain nothing else is asked: its images are panels like all others. */
static void test_stretches_that_are_passed_over_hide_nothing(void) {
  struct shape q;
  unsigned short seed[3] = {3, 1, 4};
  int near = 0, crossed = 0;
  for (int trial = 0; trial < 40; trial++) {
    shape_create(&q, 4);
    double x = 0, y = 1, way = 0, bend = 0;
    for (size_t k = 0; k < N; k++) { /* a worm, whose panels are of all lengths */
      const double step = 4. / N * pow(30, erand48(seed) - 1 + (k / 100 % 2));
      bend = 0.9 * bend + 0.03 * (trial + 1) / 10 * (erand48(seed) - 0.5);
      way += bend;
      put(&q, k, false, x += step * cos(way), y += step * sin(way));
    }
    bem_sides_set(&q.sides, &q.surface, q.state);
    for (size_t k = 1; k + 1 < N; k++) {
      struct bem_near found = {.distance = 0.05};
      bem_sides_across(&q.sides, &q.surface, q.state, k, trial % 2, 0.05, &found);
      EXPECT_NEAR(found.distance, across_by_all(&q, k, trial % 2, 0.05), 1e-12);
      near += found.distance < 0.05;
    }
    struct bem_crossing by_all, c;
    const bool cross = cross_by_all(&q, &by_all);
    EXPECT(bem_sides_cross(&q.sides, &q.surface, q.state, 0, &c) == cross);
    EXPECT(!cross || (c.first == by_all.first && c.last == by_all.last));
    crossed += cross;
    bem_sides_destroy(&q.sides);
  }
  printf("  %d of %d nodes have another side, %d of 40 surfaces cross themselves\n", near, 40 * N,
         crossed);
  EXPECT(near > 500 && crossed > 5 && crossed < 35);
}

int main(void) {
  RUN(test_a_cavity_is_as_narrow_as_it_is_to_either_side);
  RUN(test_a_sheet_is_as_thick_as_it_is_and_its_tip_is_none);
  RUN(test_faces_that_hang_over_have_the_side_to_which_they_break);
  RUN(test_loops_hold_what_the_surface_runs_round);
  RUN(test_a_jet_strikes_a_wall_through_air);
  RUN(test_stretches_that_are_passed_over_hide_nothing);
  return TEST_RESULT;
}

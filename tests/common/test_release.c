/* The pressure of water that is let go, in any tank: exact solutions, orders, rotations. */
#include "common/flow/release.h"

#include "common/base/geometry_check.h"
#include "tests/test.h"

#define POINTS(...)                                                                                \
  sizeof(double[][2]){__VA_ARGS__} / sizeof(double[2]), (const double[][2]) {                      \
    __VA_ARGS__                                                                                    \
  }

/* Turned by an angle about the origin. */
static void turn(double by, const double p[2], double out[2]) {
  out[0] = cos(by) * p[0] - sin(by) * p[1];
  out[1] = sin(by) * p[0] + cos(by) * p[1];
}

static void add(struct geo_lines *l, bool closed, double by, size_t n, const double (*p)[2]) {
  EXPECT_OK(geo_lines_begin(l, closed));
  for (size_t i = 0; i < n; i++) {
    double at[2];
    turn(by, p[i], at);
    EXPECT_OK(geo_lines_add(l, at[0], at[1]));
  }
}

/* A tank with water, turned as a whole. */
struct set_up {
  double by;
  struct geo_lines walls, water;
};

static struct release *solve(const struct set_up *s, double spacing) {
  struct release_drive drive = {.source = 0};
  struct release *r = NULL;
  turn(s->by, (double[2]){0, -1}, drive.weight);
  EXPECT_OK(release_create(&s->water, &s->walls, spacing, 1e-9, &drive, &r));
  return r;
}

static double head_at(const struct set_up *s, const struct release *r, double x, double y) {
  double at[2];
  turn(s->by, (double[2]){x, y}, at);
  return r ? release_at(r, at[0], at[1]) : NAN;
}

static void drop(struct set_up *s) {
  geo_lines_destroy(&s->walls);
  geo_lines_destroy(&s->water);
}

/* ---- what is known exactly ---- */

/* Root mean square of the difference from the column's series, over H. `from`: where the column's
 * wall, or its middle, is. */
static double column_error(double x0, double x1, double from, double side, double spacing) {
  const double H = 0.873, L = side > 0 ? x1 - from : from - x0;
  struct set_up s = {0};
  add(&s.walls, false, 0, POINTS({0, 3}, {0, 0}, {4, 0}, {4, 3}));
  add(&s.water, true, 0, POINTS({x0, 0}, {x1, 0}, {x1, H}, {x0, H}));
  struct release *r = solve(&s, spacing);
  double sum = 0;
  int n = 0;
  for (double x = 0.003; x < L; x += 0.0171)
    for (double y = 0.0021; y < H; y += 0.0171, n++)
      sum += pow(head_at(&s, r, from + side * x, y) - release_head(x, y, L, H), 2);
  release_destroy(r);
  drop(&s);
  return sqrt(sum / n) / H;
}

/* Third order, at the foot of the gate, too, where dp/dx has a logarithm; 2.4 to 3.3 measured. */
static void test_columns_meet_their_series(void) {
  static const struct {
    double x0, x1, from, side;
  } columns[] = {{0, 1.31, 0, 1}, {2.77, 4, 4, -1}, {1.17, 3.03, 2.1, 1}}; /* free on both sides */
  for (size_t k = 0; k < sizeof columns / sizeof *columns; k++) {
    double error[3];
    for (int i = 0; i < 3; i++)
      error[i] = column_error(columns[k].x0, columns[k].x1, columns[k].from, columns[k].side,
                              0.04 / (1 << i));
    printf("     column %zu: error over H %.1e %.1e %.1e\n", k, error[0], error[1], error[2]);
    EXPECT(error[2] < 1e-6);
    EXPECT(error[2] < error[0] / 16);
  }
}

/* The same column in a corner that leans by `lean`: its head is that under the part of gravity
 * along its side and, its series being that of the rectangle turned over, of the part along its
 * bed. Slanting walls, a corner at the bottom of a wedge, a surface that meets them slanting. */
static double leaning_error(double lean, double spacing) {
  struct set_up s = {.by = 0};
  add(&s.walls, false, -lean, POINTS({0, 3}, {0, 0}, {3, 0}));
  add(&s.water, true, -lean, POINTS({0, 0}, {1.3, 0}, {1.3, 0.9}, {0, 0.9}));
  struct release *r = solve(&s, spacing);
  double sum = 0;
  int n = 0;
  for (double x = 0.003; x < 1.3; x += 0.0371)
    for (double y = 0.0021; y < 0.9; y += 0.0371, n++) {
      const double exact =
          cos(lean) * release_head(x, y, 1.3, 0.9) - sin(lean) * release_head(y, x, 0.9, 1.3);
      double at[2];
      turn(-lean, (double[2]){x, y}, at);
      sum += pow(head_at(&s, r, at[0], at[1]) - fmax(exact, 0), 2);
    }
  release_destroy(r);
  drop(&s);
  return sqrt(sum / n);
}

static void test_columns_in_leaning_corners_meet_their_series(void) {
  for (int i = 0; i < 3; i++) {
    const double lean = -0.2 - 0.45 * i, coarse = leaning_error(lean, 0.04),
                 fine = leaning_error(lean, 0.01);
    printf("     leaning by %.2f: error %.1e %.1e\n", lean, coarse, fine);
    EXPECT(coarse < 1e-4 && fine < coarse / 16);
  }
}

/* The right triangle of side 1 at the wall has p/(rho g) = 1/2 - y + (y^2 - x^2)/2, zero where
 * x + y = 1: a parabola, which is met to rounding, however the tank is turned. */
static void test_a_parabola_is_exact(void) {
  for (int i = 0; i < 3; i++) {
    struct set_up s = {.by = 0.7 * i};
    add(&s.walls, false, s.by, POINTS({0, 3}, {0, 0}, {3, 0}));
    add(&s.water, true, s.by, POINTS({0, 0}, {1, 0}, {0, 1}));
    struct release *r = solve(&s, 0.043);
    double worst = 0;
    for (double x = 0.003; x < 1; x += 0.0171)
      for (double y = 0.0021; y < 1 - x; y += 0.0171)
        worst = fmax(worst, fabs(head_at(&s, r, x, y) - (0.5 - y + (y * y - x * x) / 2)));
    EXPECT_NEAR(worst, 0, 1e-11);
    release_destroy(r);
    drop(&s);
  }
}

/* Nothing can start to move: linear, to rounding. A beach, a step, a bar, a leaning wall, and an
 * island; in three regions. */
static void test_pools_stay_hydrostatic(void) {
  for (int i = 0; i < 2; i++) {
    struct set_up s = {.by = 0.5236 * i};
    add(&s.walls, false, s.by,
        POINTS({-0.5, 3}, {0, 0}, {1, 0}, {1, 0.3}, {2, 0.3}, {2.3, 0.7}, {2.6, 0.3}, {3, 0.3},
               {5.3, 1.45}, {5.3, 3}));
    add(&s.walls, true, s.by, POINTS({0.4, 0.4}, {0.4, 0.6}, {0.7, 0.6}));
    add(&s.water, true, s.by,
        POINTS({-1 / 15., 0.4}, {0, 0}, {1, 0}, {1, 0.3}, {2, 0.3}, {2.075, 0.4}, {0.4, 0.4}));
    add(&s.water, true, s.by,
        POINTS({-1 / 15., 0.4}, {0.4, 0.4}, {0.4, 0.6}, {0.4, 1}, {-1 / 6., 1}));
    add(&s.water, true, s.by,
        POINTS({0.4, 0.4}, {2.075, 0.4}, {2.3, 0.7}, {2.6, 0.3}, {3, 0.3}, {4.4, 1}, {0.4, 1},
               {0.4, 0.6}, {0.7, 0.6}));
    struct release *r = solve(&s, 0.05);
    double worst = 0;
    for (double x = -0.04; x < 4; x += 0.0371)
      for (double y = 0.013; y < 1; y += 0.0371) {
        double at[2];
        turn(s.by, (double[2]){x, y}, at);
        if (geo_lines_contain(&s.water, at[0], at[1]))
          worst = fmax(worst, fabs(head_at(&s, r, x, y) - (1 - y)));
      }
    EXPECT_NEAR(worst, 0, 1e-11);
    release_destroy(r);
    drop(&s);
  }
}

/* Water on both sides of a plate without thickness, as high as each other and lower behind it: each
 * has the pressure that it has without the other. */
static void test_a_plate_keeps_two_waters_apart(void) {
  for (int lower = 0; lower < 2; lower++) {
    const double high = lower ? 0.5 : 1;
    struct set_up s = {0};
    add(&s.walls, false, 0, POINTS({0, 3}, {0, 0}, {4, 0}, {4, 3}));
    add(&s.walls, false, 0, POINTS({1, 0}, {1, 1.5}));
    add(&s.water, true, 0, POINTS({0, 0}, {1, 0}, {1, 1}, {0, 1}));
    add(&s.water, true, 0, POINTS({1, 0}, {2, 0}, {2, high}, {1, high}));
    struct release *r = solve(&s, 0.02);
    double worst[2] = {0};
    for (double x = 0.003; x < 1; x += 0.0371)
      for (double y = 0.003; y < 1; y += 0.0371) {
        worst[0] = fmax(worst[0], fabs(head_at(&s, r, x, y) - (1 - y)));
        if (y < high)
          worst[1] = fmax(worst[1], fabs(head_at(&s, r, 1 + x, y) - release_head(x, y, 1, high)));
      }
    EXPECT_NEAR(worst[0], 0, 1e-11);
    EXPECT_NEAR(worst[1], 0, 2e-4); /* 6e-5 measured, at the foot of the gate */
    release_destroy(r);
    drop(&s);
  }
}

/* ---- order where nothing is known ---- */

/* A column of 0.97 by 1 on the left of shallow water, 0.27 deep, and a bed with a wedge, a step and
 * a beach: corners of water of 270 degrees and of solid of 74, a surface that meets a slope. */
static struct set_up harbour(double by) {
  struct set_up s = {.by = by};
  add(&s.walls, false, by,
      POINTS({0, 3}, {0, 0}, {0.5, 0}, {0.6, 0.1333333333333333}, {0.7, 0}, {2, 0}, {2, 0.1},
             {2.5, 0.1}, {4.5, 1.1}));
  add(&s.water, true, by,
      POINTS({0, 0}, {0.5, 0}, {0.6, 0.1333333333333333}, {0.7, 0}, {2, 0}, {2, 0.1}, {2.5, 0.1},
             {2.84, 0.27}, {0.97, 0.27}, {0.97, 1}, {0, 1}));
  return s;
}

/* Largest difference of two solutions farther than `away` from the bends of the harbour. */
static double difference(const struct set_up *a, const struct release *p, const struct set_up *b,
                         const struct release *q, double away) {
  static const double bends[][2] = {{0.97, 0.27}, {0.6, 0.13333}, {2, 0.1}};
  double worst = 0;
  for (double x = 0.013; x < 2.8; x += 0.0171)
    for (double y = 0.0113; y < (x < 0.97 ? 1 : 0.27); y += 0.0171) {
      double at[2];
      turn(a->by, (double[2]){x, y}, at);
      bool near = !geo_lines_contain(&a->water, at[0], at[1]);
      for (size_t k = 0; k < sizeof bends / sizeof *bends; k++)
        near = near || hypot(x - bends[k][0], y - bends[k][1]) < away;
      if (!near) worst = fmax(worst, fabs(head_at(a, p, x, y) - head_at(b, q, x, y)));
    }
  return worst;
}

/* Away from the bends, order 2 and more, though the pressure goes like r^0.67 there: a lattice of
 * one spacing would have 4/3. */
static void test_bends_do_not_spoil_the_order(void) {
  struct set_up s = harbour(0);
  struct release *r[4];
  double error[3];
  for (int i = 0; i < 4; i++) r[i] = solve(&s, 0.04 / (1 << i));
  for (int i = 0; i < 3; i++) error[i] = difference(&s, r[i], &s, r[3], 0.1);
  printf("     harbour: error %.1e %.1e %.1e\n", error[0], error[1], error[2]);
  EXPECT(error[0] < 2e-3);
  EXPECT(error[2] < error[0] / 16);
  for (int i = 0; i < 4; i++) release_destroy(r[i]);
  drop(&s);
}

static void test_turning_all_changes_nothing(void) {
  struct set_up s = harbour(0), t = harbour(M_PI / 6);
  struct release *a = solve(&s, 0.04), *b = solve(&t, 0.04);
  EXPECT_NEAR(difference(&s, a, &t, b, 0), 0, 1e-11);
  release_destroy(a);
  release_destroy(b);
  drop(&s);
  drop(&t);
}

/* In the upright line x = 2. */
static void mirror(struct geo_lines *l) {
  for (size_t i = 0; i < l->points; i++) l->p[i][0] = 4 - l->p[i][0];
  for (size_t k = 0; k < l->pieces; k++) geo_piece_reverse(l, k);
}

static void test_a_mirror_image_has_the_same_pressure(void) {
  struct set_up s = harbour(0), t = harbour(0);
  mirror(&t.walls);
  mirror(&t.water);
  struct release *a = solve(&s, 0.04), *b = solve(&t, 0.04);
  double worst = 0;
  for (double x = 0.013; x < 0.97; x += 0.0171)
    for (double y = 0.14; y < 1; y += 0.0171)
      worst = fmax(worst, fabs(head_at(&s, a, x, y) - head_at(&t, b, 4 - x, y)));
  EXPECT_NEAR(worst, 0, 1e-11);
  release_destroy(a);
  release_destroy(b);
  drop(&s);
  drop(&t);
}

/* A wet bed as one polygon and as two: the same water, the same pressure. */
static void test_regions_that_touch_are_one_water(void) {
  struct set_up s[2] = {0};
  struct release *r[2];
  for (int k = 0; k < 2; k++) add(&s[k].walls, false, 0, POINTS({0, 3}, {0, 0}, {4, 0}, {4, 3}));
  add(&s[0].water, true, 0, POINTS({0, 0}, {4, 0}, {4, 0.27}, {0.97, 0.27}, {0.97, 1}, {0, 1}));
  add(&s[1].water, true, 0, POINTS({0, 0}, {0.97, 0}, {0.97, 1}, {0, 1}));
  add(&s[1].water, true, 0, POINTS({0.97, 0}, {4, 0}, {4, 0.27}, {0.97, 0.27}));
  for (int k = 0; k < 2; k++) r[k] = solve(&s[k], 0.05);
  double worst = 0, most = 0;
  for (double x = 0.01; x < 4; x += 0.0371)
    for (double y = 0.01; y < (x < 0.97 ? 1 : 0.27); y += 0.0371) {
      worst = fmax(worst, fabs(head_at(&s[0], r[0], x, y) - head_at(&s[1], r[1], x, y)));
      most = fmax(most, head_at(&s[0], r[0], x, y));
    }
  EXPECT_NEAR(worst, 0, 1e-11);
  /* below the hydrostatic one of the column, above that of a column on a dry bed */
  EXPECT(most < 1 && most > release_head(0, 0, 0.97, 1));
  for (int k = 0; k < 2; k++) {
    release_destroy(r[k]);
    drop(&s[k]);
  }
}

/* Coordinates that people round: a gap of 1e-4 along a slope is none. */
static void test_rounded_coordinates_lie_on_the_wall(void) {
  struct set_up s = {0};
  add(&s.walls, false, 0, POINTS({0, 3}, {0, 0}, {1.985, 0.1}, {1.985, 3}));
  add(&s.water, true, 0, POINTS({0, 0}, {1, 0.0504}, {1.985, 0.1}, {1.985, 0.5}, {0, 0.5}));
  struct release *r = solve(&s, 0.05);
  EXPECT_NEAR(head_at(&s, r, 0.9, 0.1), 0.4, 1e-4);
  release_destroy(r);
  drop(&s);
}

static void test_water_without_surface_is_refused(void) {
  struct set_up s = {0};
  struct release *r = NULL;
  add(&s.walls, true, 0, POINTS({0, 0}, {1, 0}, {1, 1}, {0, 1}));
  add(&s.water, true, 0, POINTS({0, 0}, {1, 0}, {1, 1}, {0, 1}));
  EXPECT(release_create(&s.water, &s.walls, 0.1, 1e-9, &(struct release_drive){.weight = {0, -1}},
                        &r) == ERR_INPUT);
  EXPECT(!r);
  EXPECT_STR(status_message(),
             "water.pressure: 'released' for water that touches walls all round has no surface at "
             "which its pressure is zero; write hydrostatic, or leave air above it");
  drop(&s);
}

int main(void) {
  RUN(test_columns_meet_their_series);
  RUN(test_columns_in_leaning_corners_meet_their_series);
  RUN(test_a_parabola_is_exact);
  RUN(test_pools_stay_hydrostatic);
  RUN(test_a_plate_keeps_two_waters_apart);
  RUN(test_bends_do_not_spoil_the_order);
  RUN(test_turning_all_changes_nothing);
  RUN(test_a_mirror_image_has_the_same_pressure);
  RUN(test_regions_that_touch_are_one_water);
  RUN(test_rounded_coordinates_lie_on_the_wall);
  RUN(test_water_without_surface_is_refused);
  return TEST_RESULT;
}

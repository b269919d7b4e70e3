/* The jet's tip, direction, thickness and cavity on a jet of known shape, and its instants. */
#include "compare/jet.h"

#include "tests/compare/shapes.h"
#include "tests/test.h"

/* An empty world around the surface: no walls, no window. */
static void find(const struct geo_lines *l, struct cmp_jet *jet) {
  static const struct geo_lines no_walls = {0};
  struct cmp_jet_place place = {&no_walls, {{-9, -9}, {9, 9}}, 1, 0.04, 0.04};
  cmp_jet_find(l, &place, jet);
}

/* The band has the thickness w everywhere; the tip is the end of its round cap, half a thickness
 * ahead of the cut, and the direction the tangent there, the mean over 0.2 of a circle of radius
 * 0.55: the chord to the section 0.2 behind turns by about 0.2 / (2 x 0.55) rad. */
static void check_jet(double w, double angle) {
  struct geo_lines l = {0};
  struct cmp_jet jet;
  shape_jet(&l, w, angle, 200);
  find(&l, &jet);
  EXPECT(jet.found && !jet.forward);
  double r = 0.5 + w / 2, tangent = angle + M_PI / 2;
  double tip[2] = {3 + r * cos(angle) + w / 2 * cos(tangent),
                   1 + r * sin(angle) + w / 2 * sin(tangent)};
  /* 0.2 along the inner side turns further than along the outer: half the difference, at most */
  double bias = 0.2 * w / (2 * r);
  EXPECT_NEAR(jet.tip[0], tip[0], bias);
  EXPECT_NEAR(jet.tip[1], tip[1], bias);
  EXPECT_NEAR(remainder(jet.direction.value - (tangent * 180 / M_PI - 0.1 / r * 180 / M_PI), 360),
              0, 3);
  /* circles about the tip cut a curved band a little askew: (0.2)^2 / (2 r) over 0.2, squared */
  EXPECT_NEAR(jet.thickness[1].value, w, 0.02 * w);
  EXPECT_NEAR(jet.thickness[2].value, w, 0.04 * w);
  EXPECT_NEAR(jet.foot[1], 0.2, 1e-9);
  EXPECT(jet.gap <= tip[1] - 0.2 + bias);
  geo_lines_destroy(&l);
}

static void test_jet_has_its_tip_and_thickness(void) {
  check_jet(0.1, 2.0);
  check_jet(0.07, 2.6);
  check_jet(0.1, 3.3); /* droops: the tip is no longer its leftmost point */
}

/* A jet cut off vertically above the trough: the cavity is what a fine polygon sum says. */
static void test_cavity_is_closed_by_the_vertical(void) {
  struct geo_lines l = {0};
  struct cmp_jet jet;
  /* trough at y = 0.2, wall of water at x = 3, square jet from x = 1.5, 1.0 to 1.1 high */
  double points[][2] = {{0, 0.2}, {3, 0.2}, {3, 1}, {1.5, 1}, {1.45, 1.05}, {1.5, 1.1}, {4, 1.1}};
  shape_open(&l);
  for (int i = 0; i < 7; i++) shape_point(&l, points[i][0], points[i][1]);
  find(&l, &jet);
  EXPECT(jet.found && !jet.forward);
  EXPECT_NEAR(jet.tip[0], 1.45, 1e-12);
  /* rectangle 1.5 x 0.8 plus the strip below the bevel, from the foot of the tip's vertical */
  EXPECT_NEAR(jet.cavity.value, 1.5 * 0.8 + 0.05 * (0.8 + 0.85) / 2, 1e-12);
  EXPECT_NEAR(jet.overhang, 1.55, 1e-12);
  geo_lines_destroy(&l);
}

/* The mirror image plunges to the right and measures the same. */
static void test_forward_jet_mirrors_backward_jet(void) {
  struct geo_lines l = {0}, m = {0};
  struct cmp_jet a, b;
  shape_jet(&l, 0.1, 2.3, 100);
  shape_open(&m);
  for (size_t i = l.points; i-- > 0;) shape_point(&m, 4 - l.p[i][0], l.p[i][1]);
  find(&l, &a);
  find(&m, &b);
  EXPECT(!a.forward && b.forward);
  EXPECT_NEAR(b.tip[0], 4 - a.tip[0], 1e-12);
  EXPECT_NEAR(b.tip[1], a.tip[1], 1e-12);
  EXPECT_NEAR(b.cavity.value, a.cavity.value, 1e-12);
  for (int k = 0; k < CMP_JET_STATIONS; k++)
    EXPECT_NEAR(b.thickness[k].value, a.thickness[k].value, 1e-12);
  EXPECT_NEAR(remainder(a.direction.value + b.direction.value - 180, 360), 0, 1e-9);
  geo_lines_destroy(&l);
  geo_lines_destroy(&m);
}

/* Wiggles below the threshold, drops of spray, and a surface that does not overhang: no jet. */
static void test_noise_is_not_a_jet(void) {
  struct geo_lines l = {0};
  struct cmp_jet jet;
  shape_open(&l);
  for (int i = 0; i <= 400; i++) shape_point(&l, 0.01 * i + (i % 2 ? 0.015 : 0), 0.5);
  shape_circle(&l, 2, 1, 0.1, 30, true);
  find(&l, &jet);
  EXPECT(!jet.found && !cmp_known(&jet.cavity) && jet.cavity.why[0]);
  geo_lines_destroy(&l);
  find(&l, &jet); /* nothing at all */
  EXPECT(!jet.found);
}

/* A fold of the film on a wall, or one outside the window, is not the breaker. */
static void test_wall_films_and_what_is_outside_do_not_count(void) {
  struct geo_lines l = {0}, walls = shape_tank(4, 2);
  struct cmp_jet jet;
  double points[][2] = {{0, 0.2},   {3.5, 0.2},  {3.98, 0.5}, {3.99, 1.2},
                        {3.9, 1.3}, {3.99, 1.4}, {4, 1.5}};
  shape_open(&l);
  for (int i = 0; i < 7; i++) shape_point(&l, points[i][0], points[i][1]);
  find(&l, &jet);
  EXPECT(jet.found && jet.overhang > 0.08);
  struct cmp_jet_place place = {&walls, {{-9, -9}, {9, 9}}, 1, 0.04, 0.04};
  cmp_jet_find(&l, &place, &jet);
  EXPECT(!jet.found);
  geo_lines_destroy(&l);
  shape_jet(&l, 0.1, 2.2, 50);
  cmp_jet_find(&l, &place, &jet);
  EXPECT(jet.found);
  place.window.max[1] = 0.9;
  cmp_jet_find(&l, &place, &jet);
  EXPECT(!jet.found);
  geo_lines_destroy(&l);
  geo_lines_destroy(&walls);
}

/* A jet whose overhang grows as (t - 4)^(3/2) and that reaches the water at t = 6.03. */
static void test_instants_come_out_of_the_sequence(void) {
  enum { N = 60 };
  static struct cmp_jet jet[N];
  double t[N];
  for (int i = 0; i < N; i++) {
    t[i] = 3.5 + 0.05 * i;
    double overhang = t[i] > 4 ? 0.3 * pow(t[i] - 4, 1.5) : 0, gap = 0.5 * (6.03 - t[i]);
    jet[i].found = overhang > 0.04 && gap > 0;
    jet[i].overhang = overhang;
    jet[i].gap = gap;
    jet[i].tip[0] = 5 - overhang;
    jet[i].tip[1] = 0.2 + gap;
    jet[i].foot[0] = jet[i].tip[0];
    jet[i].foot[1] = 0.2;
    jet[i].cavity = cmp_number(0.1 * overhang + 0.01);
  }
  struct cmp_instant instant;
  struct cmp_jet_sequence seen = {.n = N, .t = t, .jet = jet, .spacing = 0.01};
  cmp_jet_overturning(&seen, &instant);
  EXPECT_NEAR(instant.time.value, 4, 1e-9); /* the law is exact here */
  EXPECT(instant.error >= 0.025);
  cmp_jet_touchdown(&seen, &instant);
  EXPECT_NEAR(instant.time.value, 6.03, 1e-9);
  EXPECT_NEAR(instant.error, 0.025, 1e-9); /* half an interval; a spacing at speed 0.5 is 0.02 */
  seen.spacing = 0.02;
  cmp_jet_touchdown(&seen, &instant);
  EXPECT_NEAR(instant.error, 0.04, 1e-9);
  seen.n = 45; /* ends at t = 5.7 */
  cmp_jet_touchdown(&seen, &instant);
  EXPECT(!cmp_known(&instant.time) && instant.time.why[0]);
  for (int i = 30; i < N; i++) jet[i].found = false; /* vanishes at t = 5 half a length up */
  seen.n = N;
  cmp_jet_touchdown(&seen, &instant);
  EXPECT(!cmp_known(&instant.time) && strstr(instant.time.why, "lost"));
  seen.n = 5;
  cmp_jet_overturning(&seen, &instant);
  EXPECT(!cmp_known(&instant.time) && instant.time.why[0]);
}

/* A shape that overhangs to begin with is no breaker, whatever becomes of it; one that comes later
 * is. */
static void test_what_overhangs_at_first_is_no_breaker(void) {
  enum { N = 40 };
  static struct cmp_jet jet[N];
  double t[N];
  for (int i = 0; i < N; i++) {
    t[i] = 0.1 * i;
    jet[i].found = i < 10;
    jet[i].overhang = 0.6;
    jet[i].cavity = cmp_number(0.2);
  }
  struct cmp_instant instant;
  struct cmp_jet_sequence seen = {.n = N, .t = t, .jet = jet, .spacing = 0.01};
  cmp_jet_overturning(&seen, &instant);
  EXPECT(!cmp_known(&instant.time) && strstr(instant.time.why, "from the start"));
  cmp_jet_touchdown(&seen, &instant);
  EXPECT(!cmp_known(&instant.time) && strstr(instant.time.why, "from the start"));
  for (int i = 20; i < 30; i++) {
    jet[i].found = true;
    jet[i].overhang = 0.05 * (i - 19);
  }
  cmp_jet_overturning(&seen, &instant);
  EXPECT(cmp_known(&instant.time) && instant.time.value > 1.5 && instant.time.value <= 2);
}

/* A face that leans by 0.05 per unit of height and unit of time, tan(angle) = 0.05 (5 - t), until
 * it turns at t = 5. Over six spacings of 0.02 it is vertical to within a spacing when that is
 * below 1/6: from t = 5 - (1/6)/0.05 = 1.67 on, so that is how far the bar must reach. */
static void test_bar_holds_the_time_for_which_a_face_is_nearly_vertical(void) {
  enum { N = 90 };
  static struct cmp_jet jet[N];
  static struct geo_lines surface[N];
  static const struct geo_lines no_walls = {0};
  double t[N], dx = 0.02;
  struct cmp_jet_sequence seen = {.n = N, .t = t, .jet = jet, .surface = surface, .spacing = dx};
  seen.place = (struct cmp_jet_place){&no_walls, {{-9, -9}, {9, 9}}, 1, 3 * dx, 2 * dx};
  for (int i = 0; i < N; i++) {
    t[i] = 0.1 * i;
    double lean = t[i] < 5 ? 0.05 * (5 - t[i]) : -pow(t[i] - 5, 1.5);
    shape_open(&surface[i]);
    for (int k = 0; k <= 40; k++) shape_point(&surface[i], 0.025 * k, 0.2);
    for (int k = 1; k <= 50; k++) shape_point(&surface[i], 1 + lean * 0.01 * k, 0.2 + 0.01 * k);
    for (int k = 1; k <= 40; k++) shape_point(&surface[i], 1 + 0.5 * lean + 0.025 * k, 0.7);
    cmp_jet_find(&surface[i], &seen.place, &jet[i]);
  }
  struct cmp_instant instant;
  cmp_jet_overturning(&seen, &instant);
  EXPECT(cmp_known(&instant.time));
  EXPECT_NEAR(instant.time.value - instant.error, 5 - 1 / 6.0 / 0.05, 0.1); /* an interval */
  EXPECT(instant.time.value + instant.error >= 5 && instant.time.value - instant.error <= 5);
  seen.surface = NULL;
  cmp_jet_overturning(&seen, &instant);
  EXPECT(instant.time.value - instant.error > 4); /* what the outputs alone would say */
  for (int i = 0; i < N; i++) geo_lines_destroy(&surface[i]);
}

int main(void) {
  RUN(test_jet_has_its_tip_and_thickness);
  RUN(test_cavity_is_closed_by_the_vertical);
  RUN(test_forward_jet_mirrors_backward_jet);
  RUN(test_noise_is_not_a_jet);
  RUN(test_wall_films_and_what_is_outside_do_not_count);
  RUN(test_instants_come_out_of_the_sequence);
  RUN(test_what_overhangs_at_first_is_no_breaker);
  RUN(test_bar_holds_the_time_for_which_a_face_is_nearly_vertical);
  return TEST_RESULT;
}

/* What walls enclose, joined walls, and beds that go round. */
#include "common/tank/room.h"

#include "common/base/geometry_check.h"
#include "common/case/case.h"
#include "common/tank/tank.h"
#include "tests/common/case_registry.h"
#include "tests/test.h"

static struct case_file *case_of(const char *walls, const char *rest) {
  char text[1000];
  struct problems problems;
  struct case_file *c;
  snprintf(text, sizeof text,
           "tank: {walls: %s}\nwater: {%s}\ntime: {end: 9}\nruns: [{solver: sph, resolution: 9}]\n",
           walls, rest);
  if (case_parse("room", text, &fake_registry, &problems, &c) != OK)
    for (size_t i = 0; i < problems.n; i++) TEST_FAIL("%s", problems.text[i]);
  problems_destroy(&problems);
  return c;
}
static const char corner[] = "regions: [[[0, 0], [0.3, 0], [0.3, 0.3], [0, 0.3]]]";

/* A beach, a baffle and an obstacle; the left side is lower than the right one. */
static const char harbour[] = "[[[0, 2], [0, 0], [2, 0], [4, 1], [4, 3]], [[1, 0.5], [1, 1]], "
                              "[[1.5, 0.5], [1.5, 1], [2, 1], [2, 0.5], [1.5, 0.5]]]";

static void test_a_place_is_in_the_tank_or_behind_a_wall(void) {
  static const struct {
    double x, y, distance;
  } place[] = {
      {0.3, 1.7, 0.3},               /* beside the left side */
      {-0.3, 1.7, -0.3},             /* behind it */
      {0.3, 2.4, 0.5},               /* above its top: between the sides, which go on */
      {-0.3, 2.4, -0.5},             /* beyond them */
      {1.75, 0.75, -0.25},           /* in the obstacle */
      {1.2, 0.75, 0.2},              /* between baffle and obstacle */
      {3, 0.4, -0.0894427190999916}, /* under the beach: 0.2/sqrt(5) */
      {3, 0.6, 0.0894427190999916},  /* over it */
      {3.5, 5, 2.0615528128088303},  /* high above */
      {1, -0.2, -0.2},               /* below the bed */
  };
  struct case_file *c = case_of(harbour, corner);
  for (size_t i = 0; c && i < sizeof place / sizeof *place; i++) {
    double nearest[2];
    EXPECT_NEAR(tank_distance(&c->walls, place[i].x, place[i].y, nearest), place[i].distance,
                1e-14);
    EXPECT(tank_contains(&c->walls, place[i].x, place[i].y) == (place[i].distance > 0));
    EXPECT_NEAR(hypot(nearest[0] - place[i].x, nearest[1] - place[i].y), fabs(place[i].distance),
                1e-14);
  }
  case_destroy(c);
}

static void test_walls_that_go_on_are_one(void) {
  static const char *const tank[] = {
      "[[[0, 3], [0, 0], [4, 0], [4, 3]]]",
      "[[[0, 3], [0, 0]], [[0, 0], [4, 0]], [[4, 0], [4, 3]]]",
      "[[[4, 0], [4, 3]], [[0, 3], [0, 0]], [[0, 0], [4, 0]]]",
  };
  char first[33], other[33];
  for (size_t i = 0; i < 3; i++) {
    struct case_file *c = case_of(tank[i], corner);
    if (!c) continue;
    EXPECT(c->walls.pieces == 1 && c->rectangular);
    case_water_fingerprint(c, i ? other : first);
    if (i) EXPECT_STR(other, first);
    case_destroy(c);
  }
  struct case_file *lid = case_of("[[[0, 3], [0, 0], [4, 0], [4, 3]], [[4, 3], [0, 3]]]", corner);
  EXPECT(lid && lid->walls.pieces == 1 && lid->walls.closed[0] && lid->walls.points == 4);
  case_destroy(lid);
}

/* The bed of a tank with periodic sides, as far as it is asked for, has the period of the tank. */
static void test_a_bed_goes_round(void) {
  struct case_file *c =
      case_of("[[[0, 3], [0, 0], [1, 0], [1, 0.2], [2, 0.7], [4, 0], [4, 3]]], sides: periodic",
              "regions: [[[0.1, 1], [1, 1], [1, 2], [0.1, 2]]]");
  struct geo_lines bed = {0};
  if (!c) return;
  const struct tank t = tank_of(&c->walls, c->periodic);
  EXPECT_OK(tank_walls(&t, &c->walls, 6.3, &bed));
  const struct geo_box box = geo_lines_box(&bed);
  EXPECT(bed.pieces == 1);
  EXPECT_NEAR(box.min[0], -6.3, 1e-14);
  EXPECT_NEAR(box.max[0], 10.3, 1e-14);
  for (double x = 0.05; x < 4; x += 0.173)
    for (int k = -1; k <= 1;
         k++) { /* half a metre above the walls of the case is as far from these */
      double nearest[2], on[2];
      size_t piece;
      geo_lines_distance(&c->walls, x, -1, on, &piece);
      EXPECT_NEAR(geo_lines_distance(&bed, x + 4 * k, -1, nearest, &piece),
                  hypot(on[0] - x, on[1] + 1), 1e-13);
    }
  geo_lines_destroy(&bed);
  case_destroy(c);
}

int main(void) {
  RUN(test_a_place_is_in_the_tank_or_behind_a_wall);
  RUN(test_walls_that_go_on_are_one);
  RUN(test_a_bed_goes_round);
  return TEST_RESULT;
}

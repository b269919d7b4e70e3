/* Thin plates under water, drawn with their thickness: water round their ends. */
#include "tests/test.h"

#include "sph/fluid/energy.h"
#include "sph/pair/sums.h"
#include "tests/sph/tanks.h"

struct plate {
  const char *name, *walls, *water;
};

#define TANK "[[0, 2], [0, 0], [3, 0], [3, 2]]"

/* A tenth of the depth thick. */
static const struct plate plates[] = {
    {"a plate under water",
     TANK ", [[1.45, 0.3], [1.45, 0.7], [1.55, 0.7], [1.55, 0.3], [1.45, 0.3]]",
     "[[0, 0], [3, 0], [3, 0.5], [1.55, 0.5], [1.55, 0.3], [1.45, 0.3], [1.45, 0.5], [0, 0.5]], "
     "[[0, 0.5], [1.45, 0.5], [1.45, 0.7], [1.55, 0.7], [1.55, 0.5], [3, 0.5], [3, 1], [0, 1]]"},
    {"a gate", TANK ", [[1.45, 0.4], [1.45, 1.4], [1.55, 1.4], [1.55, 0.4], [1.45, 0.4]]",
     "[[0, 0], [3, 0], [3, 1], [1.55, 1], [1.55, 0.4], [1.45, 0.4], [1.45, 1], [0, 1]]"},
    {"a weir", "[[0, 2], [0, 0], [1.45, 0], [1.45, 0.5], [1.55, 0.5], [1.55, 0], [3, 0], [3, 2]]",
     "[[0, 0], [1.45, 0], [1.45, 0.5], [1.55, 0.5], [1.55, 0], [3, 0], [3, 1], [0, 1]]"},
};
enum { PLATES = sizeof plates / sizeof *plates };

static struct sph *plate_create(const struct plate *p, const char *run, struct case_file **c) {
  char head[1500];
  snprintf(head, sizeof head,
           "title: %s\nscales: {H: 1}\ntank: {walls: [%s]}\n"
           "water: {regions: [%s], pressure: hydrostatic}\n" POOL_TIMES,
           p->name, p->walls, p->water);
  *c = pool_case(head, run);
  return pool_create(*c);
}

static size_t inside(const struct sph *s) {
  size_t n = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    const double x = s->f.w.x[i], y = s->f.w.y[i];
    n += x > 1.45 && x < 1.55 && y > 0.4 && y < 0.5; /* which all have */
  }
  return n;
}

/* From everywhere what is seen, water and ghosts, fills the supports once. */
static void test_what_is_seen_fills_the_supports(void) {
  for (size_t k = 0; k < PLATES; k++) {
    struct case_file *c;
    struct sph *s = plate_create(&plates[k], "resolution: 20, precision: double", &c);
    EXPECT_OK(sph_rates(s, 0, true, true));
    double least = INFINITY, most = 0;
    for (size_t i = 0; i < s->f.n; i++) {
      if (s->f.w.y[i] > 1 - s->support) continue;
      const struct sph_fit_sums a = sph_sums_around(s, i / SPH_LANES, SPH_OF_WATER | SPH_OF_WALLS);
      least = fmin(least, a.w[i % SPH_LANES] / M_PI);
      most = fmax(most, a.w[i % SPH_LANES] / M_PI);
    }
    printf("     %s: sum of W V from %.4f to %.4f\n", plates[k].name, least, most);
    EXPECT(least > 0.98 && most < 1.025);
    sph_destroy(s);
    case_destroy(c);
  }
}

/* Where each side had a solid of its own beyond both corners of the end, water there reached 0.19
 * sqrt(gH) by then, and runs broke off later. */
static void test_still_water_rests_round_a_plate_of_two_spacings(void) {
  for (size_t k = 0; k < PLATES; k++) {
    struct case_file *c;
    struct sph *s = plate_create(&plates[k], "resolution: 20", &c);
    const double before = sph_energy(s).potential;
    EXPECT_OK(pool_march(s, 2 / sqrt(s->g)));
    const double speed = still_tank_speed(s) / sqrt(s->g);
    const double change = sph_energy(s).potential / before - 1;
    printf("     %s: speed %.4f sqrt(gH), potential energy %+.4f %%\n", plates[k].name, speed,
           100 * change);
    EXPECT(speed < 0.06);
    EXPECT_NEAR(change, 0, 1e-3);
    EXPECT(inside(s) == 0);
    sph_destroy(s);
    case_destroy(c);
  }
}

/* Water on one side of a plate does not see that on the other, but both see what is before its end,
 * wherever that is. */
static void test_water_sees_past_an_end_only_from_before_it(void) {
  static const struct {
    double from[2], to[2];
    bool hidden;
  } ways[] = {
      {{1.43, 0.6}, {1.57, 0.6}, true},    /* through the plate */
      {{1.43, 0.69}, {1.57, 0.69}, true},  /* so near its end */
      {{1.42, 0.68}, {1.5, 0.73}, false},  /* over a corner of it */
      {{1.44, 0.68}, {1.56, 0.71}, false}, /* over both, out through the side */
      {{1.44, 0.72}, {1.56, 0.69}, false},
  };
  struct case_file *c;
  struct sph *s = plate_create(&plates[0], "resolution: 20, precision: double", &c);
  for (size_t k = 0; k < sizeof ways / sizeof *ways; k++)
    for (int back = 0; back < 2; back++) {
      const double *from = back ? ways[k].to : ways[k].from, *to = back ? ways[k].from : ways[k].to;
      s->f.w.x[0] = to[0];
      s->f.w.y[0] = to[1];
      double x[SPH_LANES], y[SPH_LANES];
      for (size_t l = 0; l < SPH_LANES; l++) {
        x[l] = from[0];
        y[l] = from[1];
      }
      struct sph_lists lists = {0};
      EXPECT_OK(sph_neighbours_update(s));
      const struct sph_sources water = sph_sources_of_water(s);
      EXPECT_OK(sph_lists_build(&lists, SPH_LANES, x, y, &water, s->support));
      EXPECT_OK(sph_sight_mark(&s->sight, &lists, SPH_LANES, x, y, &water, NULL, s->support));
      size_t found = 0;
      for (size_t at = lists.chunks[0].first[0]; at < lists.chunks[0].first[1]; at++) {
        const uint32_t j = lists.chunks[0].j[at];
        if (hypot(s->f.w.x[j] - to[0], s->f.w.y[j] - to[1]) > 1e-12) continue;
        found++;
        EXPECT((lists.chunks[0].hidden[at] != 0) == ways[k].hidden);
      }
      EXPECT(found == 1);
      sph_lists_destroy(&lists);
    }
  sph_destroy(s);
  case_destroy(c);
}

/* Walls that move take the middle of an end along. */
static void test_halves_of_an_end_follow_it(void) {
  struct case_file *c;
  struct sph *s = plate_create(&plates[2], "resolution: 20", &c);
  struct faces faces = {0};
  struct geo_lines moved = {0};
  size_t halves = 0;
  EXPECT_OK(faces_set(&faces, &c->walls, 0.2, NULL));
  EXPECT_OK(geo_lines_copy(&moved, &c->walls));
  for (size_t i = 0; i < moved.points; i++) moved.p[i][0] += 0.25 + 0.1 * moved.p[i][1];
  faces_move(&faces, (const double(*)[2])moved.p);
  for (size_t k = 0; k < faces.n; k++) {
    const struct face *f = &faces.face[k];
    if (f->end[1] != FACE_END_HALF) continue;
    const struct face *g = &faces.face[f->next];
    halves++;
    EXPECT_NEAR(f->b[0], 1.5 + 0.25 + 0.05, 1e-12);
    EXPECT_NEAR(g->a[0], f->b[0], 0);
    EXPECT_NEAR(f->length, 0.05, 1e-12);
    EXPECT_NEAR(g->length, 0.05, 1e-12);
  }
  EXPECT(halves == 1);
  geo_lines_destroy(&moved);
  faces_destroy(&faces);
  sph_destroy(s);
  case_destroy(c);
}

int main(void) {
  RUN(test_what_is_seen_fills_the_supports);
  RUN(test_halves_of_an_end_follow_it);
  RUN(test_water_sees_past_an_end_only_from_before_it);
  RUN(test_still_water_rests_round_a_plate_of_two_spacings);
  return TEST_RESULT;
}

/* The body force: gravity along any direction, and the frame of a tank that moves. */
#include "sph/fluid/energy.h"
#include "tests/sph/pool.h"
#include "tests/test.h"

/* Water in a square tank, its surface level where gravity is turned by atan(1/4). */
#define TILTED                                                                                     \
  "title: tilted\nfluid: {gravity: [-2.385, -9.54]}\nscales: {H: 1}\n"                             \
  "tank: {walls: [[[0, 2], [0, 0], [2, 0], [2, 2]]]}\n"                                            \
  "water: {regions: [[[0, 0], [2, 0], [2, 0.75], [0, 1.25]]]}\n" POOL_TIMES

static double fastest(const struct sph *s) {
  double most = 0;
  for (size_t i = 0; i < s->f.n; i++) most = fmax(most, hypot(s->f.w.u[i], s->f.w.v[i]));
  return most;
}

/* Walls without whose pressure water fell would let it run down the slope at once. Asked of still
 * water: 2 % of sqrt(gH), 0.1 % of the potential energy, which is counted from the lowest corner.
 */
static void test_water_rests_under_gravity_that_is_turned(void) {
  static const char *const walls[] = {"ghost", "mirror"};
  for (int k = 0; k < 2; k++) {
    char run[100];
    snprintf(run, sizeof run, "resolution: 16, alpha: 0.05, walls: %s", walls[k]);
    struct case_file *c = pool_case(TILTED, run);
    struct sph *s = pool_create(c);
    const double before = sph_energy(s).potential;
    EXPECT_OK(pool_march(s, 5 / sqrt(s->g)));
    printf("     %s: %.4f sqrt(gH), potential energy %+.3f %%\n", walls[k],
           fastest(s) / sqrt(s->g * c->H), 100 * (sph_energy(s).potential / before - 1));
    EXPECT(fastest(s) < 0.02 * sqrt(s->g * c->H));
    EXPECT_NEAR(sph_energy(s).potential / before, 1, 1e-3);
    sph_destroy(s);
    case_destroy(c);
  }
}

/* A tank and gravity, mirrored, have the mirrored water, but for the order of sums. */
static void test_mirrored_gravity_has_mirrored_water(void) {
  static const char *const heads[] = {
      TILTED, "title: tilted\nfluid: {gravity: [2.385, -9.54]}\nscales: {H: 1}\n"
              "tank: {walls: [[[0, 2], [0, 0], [2, 0], [2, 2]]]}\n"
              "water: {regions: [[[0, 0], [2, 0], [2, 1.25], [0, 0.75]]]}\n" POOL_TIMES};
  double x[2], y[2];
  for (int k = 0; k < 2; k++) {
    struct case_file *c = pool_case(heads[k], "resolution: 12, precision: double");
    struct sph *s = pool_create(c);
    x[k] = y[k] = 0;
    EXPECT_OK(pool_march(s, 0.1));
    for (size_t i = 0; i < s->f.n; i++) {
      x[k] += (k ? 2 - s->f.w.x[i] : s->f.w.x[i]) / (double)s->f.n;
      y[k] += s->f.w.y[i] / (double)s->f.n;
    }
    sph_destroy(s);
    case_destroy(c);
  }
  EXPECT_NEAR(x[0], x[1], 1e-10);
  EXPECT_NEAR(y[0], y[1], 1e-10);
}

static void test_potential_at_rest_under_gravity_that_is_turned(void) {
  struct case_file *c = pool_case(TILTED, "resolution: 12");
  /* int -g.r over the water: 2.385 * int x + 9.54 * int y */
  const double along = 2 * 1.25 * 1 - 0.25 * 8 / 3,
               above = (1.25 * 1.25 * 2 - 2 * 1.25 / 4 * 2 + 8. / 48) / 2;
  EXPECT_NEAR(case_rest_potential(c), 1000 * (2.385 * along + 9.54 * above), 1e-6 * 1e4);
  case_destroy(c);
}

int main(void) {
  RUN(test_water_rests_under_gravity_that_is_turned);
  RUN(test_mirrored_gravity_has_mirrored_water);
  RUN(test_potential_at_rest_under_gravity_that_is_turned);
  return TEST_RESULT;
}

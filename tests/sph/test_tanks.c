/* Walls along any straight lines: what continues the water behind them, and who sees what. */
#include "tests/test.h"

#include "sph/domain/wall.h"
#include "sph/fluid/energy.h"
#include "sph/observe/rest.h"
#include "sph/pair/sums.h"
#include "tests/sph/tanks.h"

/* Everywhere in the tank water and ghosts fill the supports: the sum of W V is that of a lattice,
 * 1, but for what cells of different shapes next to each other make of it: as much as the clipped
 * cells of the water do. The Gaussian's value is pi W h^2. */
static void test_ghosts_fill_the_supports(void) {
  for (size_t k = 0; k < STILL_TANKS; k++) {
    struct case_file *c = still_tank_case(&still_tanks[k], "resolution: 20, precision: double");
    struct sph *s = pool_create(c);
    EXPECT_OK(sph_rates(s, 0, true, true));
    double least = INFINITY, most = 0;
    for (size_t i = 0; i < s->f.n; i++) {
      if (s->f.w.y[i] > still_tanks[k].level - s->support) continue;
      const struct sph_fit_sums a = sph_sums_around(s, i / SPH_LANES, SPH_OF_WATER | SPH_OF_WALLS);
      least = fmin(least, a.w[i % SPH_LANES] / M_PI);
      most = fmax(most, a.w[i % SPH_LANES] / M_PI);
    }
    printf("     %s: sum of W V from %.4f to %.4f\n", still_tanks[k].name, least, most);
    EXPECT(least > 0.98 && most < 1.025);
    sph_destroy(s);
    case_destroy(c);
  }
}

/* While particles in cells that a slope has cut find their places, at a coarse spacing. */
static void still_water_stays(const char *run, size_t tanks) {
  for (size_t k = 0; k < tanks; k++) {
    struct case_file *c = still_tank_case(&still_tanks[k], run);
    struct sph *s = pool_create(c);
    const double before = sph_energy(s).potential;
    EXPECT_OK(pool_march(s, 2 / sqrt(s->g)));
    const double speed = still_tank_speed(s) / sqrt(s->g);
    const double change = sph_energy(s).potential / before - 1;
    printf("     %s: speed %.4f sqrt(gH), potential energy %+.4f %%\n", still_tanks[k].name, speed,
           100 * change);
    EXPECT(speed < 0.04);
    EXPECT_NEAR(change, 0, 1e-3);
    EXPECT(still_tank_outside(s, &still_tanks[k]) == 0);
    sph_destroy(s);
    case_destroy(c);
  }
}

static void test_still_water_stays_in_tanks(void) {
  still_water_stays("resolution: 13", STILL_TANKS);
  still_water_stays("resolution: 13, walls: mirror", 2); /* the others have corners of the solid */
}

/* Between a thin plate's sides there is nothing: where one side has water at rest and the other has
 * none, the plate holds it, and no particle sees one that is not there. */
static void test_a_thin_plate_holds_water(void) {
  struct case_file *c = pool_case(
      "title: plate\nscales: {H: 1}\n"
      "tank: {walls: [[[0, 2], [0, 0], [1, 0], [1, 1.5], [1.1, 1.5], [1.1, 0], [2, 0], [2, 2]]]}\n"
      "water: {regions: [[[0, 0], [1, 0], [1, 1], [0, 1]], [[1.1, 0], [2, 0], [2, 0.5], [1.1, "
      "0.5]]], pressure: hydrostatic}\n" POOL_TIMES,
      "resolution: 16");
  struct sph *s = pool_create(c);
  EXPECT_OK(pool_march(s, 2 / sqrt(s->g)));
  EXPECT(still_tank_speed(s) < 0.08 * sqrt(s->g));
  size_t inside = 0;
  for (size_t i = 0; i < s->f.n; i++) inside += s->f.w.x[i] > 1 && s->f.w.x[i] < 1.1;
  EXPECT(inside == 0);
  sph_destroy(s);
  case_destroy(c);
}

/* Over a step, past which water goes to the right: how much of its velocity wall particles have,
 * the least and the most within a support of the corner, or from two on. */
static void slide_past_a_step(double velocity, bool near, double *least, double *most) {
  struct case_file *c = still_tank_case(&still_tanks[3], "resolution: 20, precision: double");
  struct sph *s = pool_create(c);
  for (size_t i = 0; i < s->f.n; i++) s->f.w.u[i] = velocity;
  EXPECT_OK(sph_rates(s, 0, true, true));
  *least = INFINITY;
  *most = -INFINITY;
  for (size_t k = 0; k < s->w.n; k++) {
    const double x = s->w.x[k] - 1.5, y = s->w.y[k] - 0.5, part = s->w.pack[k].u / velocity;
    if (y > 0 || x < -y) continue; /* not behind the top of the step */
    if (near ? hypot(x, y) > s->support : x < 2 * s->support || x > 1.2) continue;
    *least = fmin(*least, part);
    *most = fmax(*most, part);
  }
  sph_destroy(s);
  case_destroy(c);
}

/* Beside corners of the solid they do if the water is fast. */
static void test_walls_slide_as_layers_have_it(void) {
  double least, most;
  slide_past_a_step(1e-6, true, &least, &most);
  EXPECT(least > -1e-5 && most < 1e-5);
  slide_past_a_step(1e-6, false, &least, &most);
  EXPECT(least > 1 - 1e-5 && most < 1 + 1e-5);
  slide_past_a_step(2, true, &least, &most);
  EXPECT(least > 1 - 1e-5 && most < 1 + 1e-5);
}

/* A step ends where the mirror image of what is left of it is, at the first face that it meets and
 * then the next one. */
static void test_water_is_reflected_at_the_face_it_meets(void) {
  struct case_file *c = still_tank_case(&still_tanks[4], "resolution: 16");
  struct sph *s = pool_create(c);
  const double down = sqrt(5);
  s->f.w0.x[0] = 2.5; /* above the beach, whose slope is 1:2 and which is at 0.5 there */
  s->f.w0.y[0] = 0.55;
  s->f.w.x[0] = 2.5 + 0.1 / down;
  s->f.w.y[0] = 0.55 - 0.2 / down;
  s->f.w.u[0] = 1 / down;
  s->f.w.v[0] = -2 / down;
  sph_wall_confine(s);
  EXPECT(s->reflections == 1);
  const double through = 0.1 - 0.05 * 2 / down; /* beyond the face, along its normal */
  EXPECT_NEAR(s->f.w.x[0], 2.5 + 0.1 / down - 2 * through / down, 1e-12);
  EXPECT_NEAR(s->f.w.y[0], 0.55 - 0.2 / down + 4 * through / down, 1e-12);
  EXPECT_NEAR(s->f.w.u[0], -1 / down, 1e-12);
  EXPECT_NEAR(s->f.w.v[0], 2 / down, 1e-12);
  sph_destroy(s);
  case_destroy(c);
}

/* The largest distance of a particle's mirror image in x = 0 from the nearest particle, m. */
static double asymmetry(const struct sph *s) {
  double worst = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    double nearest = INFINITY;
    for (size_t j = 0; j < s->f.n; j++)
      nearest = fmin(nearest, hypot(s->f.w.x[i] + s->f.w.x[j], s->f.w.y[i] - s->f.w.y[j]));
    worst = fmax(worst, nearest);
  }
  return worst;
}

/* A column that stands over a wedge falls to both sides alike. */
static void test_symmetric_water_stays_symmetric(void) {
  struct case_file *c = pool_case(
      "title: column\nscales: {H: 1}\n"
      "tank: {walls: [[[-1.5, 2], [-1.5, 0], [-0.3, 0], [0, 0.4], [0.3, 0], [1.5, 0], [1.5, 2]]]}\n"
      "water: {regions: [[[-0.5, 0], [-0.3, 0], [0, 0.4], [0.3, 0], [0.5, 0], [0.5, 1], [-0.5, "
      "1]]], pressure: hydrostatic}\n" POOL_TIMES,
      "resolution: 14, precision: double");
  struct sph *s = pool_create(c);
  EXPECT_OK(pool_march(s, 0.6 / sqrt(s->g)));
  printf("     symmetric to %.1e m, speed %.2f m/s\n", asymmetry(s), still_tank_speed(s));
  EXPECT(asymmetry(s) < 1e-10);
  EXPECT(still_tank_speed(s) > 0.5);
  sph_destroy(s);
  case_destroy(c);
}

/* Water set up as it stands at rest has the energy of rest: of what its compression adds to that of
 * incompressible water, first order in g H/c0^2, what is left is of the next order, and of cells
 * that slopes cut. */
static void test_rest_is_that_of_compressed_water(void) {
  for (size_t k = 0; k < STILL_TANKS; k++) {
    struct case_file *c = still_tank_case(&still_tanks[k], "resolution: 20, precision: double");
    struct sph *s = pool_create(c);
    double rest;
    EXPECT_OK(sph_rest_find(c, s, &rest));
    const double set_up = sph_energy(s).potential, added = set_up - case_rest_potential(c);
    printf("     %s: compression adds %.3g J/m, of which %.2f %% are left\n", still_tanks[k].name,
           added, 100 * (set_up - rest) / added);
    EXPECT(added > 0 && fabs(set_up - rest) < 0.02 * added);
    sph_destroy(s);
    case_destroy(c);
  }
}

int main(void) {
  RUN(test_ghosts_fill_the_supports);
  RUN(test_rest_is_that_of_compressed_water);
  RUN(test_still_water_stays_in_tanks);
  RUN(test_a_thin_plate_holds_water);
  RUN(test_walls_slide_as_layers_have_it);
  RUN(test_symmetric_water_stays_symmetric);
  RUN(test_water_is_reflected_at_the_face_it_meets);
  return TEST_RESULT;
}

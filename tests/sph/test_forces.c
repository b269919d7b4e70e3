/* Forces of the water on the walls: what they and its weight change its momentum by, and what still
 * water presses with. */
#include "sph/observe/forces.h"

#include <omp.h>

#include "sph/domain/wall.h"
#include "sph/observe/diagnose.h"
#include "tests/sph/pool.h"
#include "tests/test.h"

/* ---- momentum ---- */

#define TANK(walls, more)                                                                          \
  "title: shaken\nscales: {H: 1}\ntank: {walls: [[" walls "]]" more "}\n"                          \
  "water: {regions: [[[0, 0], [1.5, 0], [1.5, 1], [0, 1]]], pressure: hydrostatic}\n" POOL_TIMES

#define BOX   "[0, 2], [0, 0], [2.1, 0], [2.1, 2]"
#define BEACH "[0, 2], [0, 0], [2.1, 0], [3.3, 0.5], [3.3, 0.7], [4, 1.7]" /* with a step in it */
#define SHAKEN                                                                                     \
  ", motions: [{kind: sway, amplitude: 0.3, period: 1.3, ramp: 0.7}, {kind: heave, amplitude: "    \
  "0.2, period: 0.9, phase: 1, ramp: 0.5}, {kind: roll, amplitude: 0.4, period: 1.7, about: "      \
  "[1.1, "                                                                                         \
  "0.4], ramp: 0.6}]"
#define PUSHED ", motions: [{kind: piston, side: left, amplitude: 0.1, period: 1.3}]"

/* Weight and force of the frame, N/m, and their moment about x = y = 0, N. */
struct outside {
  double x, y, moment;
};

static struct outside outside_of(const struct sph *s) {
  const struct sph_state *w = &s->f.w;
  struct outside all = {0};
  for (size_t i = 0; i < s->f.n; i++) {
    double f[2];
    sph_force_at(&s->force, w->x[i], w->y[i], w->u[i], w->v[i], f);
    all.x += s->f.m[i] * f[0];
    all.y += s->f.m[i] * f[1];
    all.moment += s->f.m[i] * (w->x[i] * f[1] - w->y[i] * f[0]);
  }
  return all;
}

/* Rates of momentum and of angular momentum about x = y = 0. */
static struct outside rates_of(const struct sph *s) {
  const struct sph_state *w = &s->f.w, *k = &s->f.k[0];
  struct outside all = {0};
  for (size_t i = 0; i < s->f.n; i++) {
    all.x += s->f.m[i] * k->u[i];
    all.y += s->f.m[i] * k->v[i];
    all.moment += s->f.m[i] * (w->x[i] * k->v[i] - w->y[i] * k->u[i]);
  }
  return all;
}

static double off_balance(struct sph *s) {
  struct sph_forces f;
  EXPECT_OK(sph_rates(s, 0, true, true));
  EXPECT_OK(sph_forces_find(s, &f));
  const struct outside given = outside_of(s), rate = rates_of(s);
  const struct geo_box *box = &s->tank.box;
  const double about[2] = {0.5 * (box->min[0] + box->max[0]), box->min[1]};
  const double moment = f.moment + about[0] * f.y - about[1] * f.x;
  const double unit = s->rho0 * s->g;
  EXPECT(fabs(f.x) > 0.01 * unit && fabs(f.y) > 0.3 * unit && fabs(f.moment) > 0.01 * unit);
  return fmax(fmax(fabs(rate.x - given.x + f.x), fabs(rate.y - given.y + f.y)),
              fabs(rate.moment - given.moment + moment)) /
         unit;
}

/* Forces between particles of water cancel, in pairs; those of the walls and the tank's are left.
 */
static void test_walls_and_weight_change_the_momentum(void) {
  static const struct {
    const char *name, *head, *run;
  } cases[] = {
      {"ghosts", TANK(BOX, ""), "walls: ghost"},
      {"mirrors", TANK(BOX, ""), "walls: mirror"},
      {"dynamic walls", TANK(BOX, ""), "walls: dynamic"},
      {"no slip", TANK(BOX, ""), "slip: no"},
      {"a beach", TANK(BEACH, ""), "walls: ghost"},
      {"a tank that moves", TANK(BEACH, SHAKEN), "walls: ghost"},
      {"a piston", TANK(BOX, PUSHED), "walls: ghost"},
      {"a piston, mirrors, no slip", TANK(BOX, PUSHED), "walls: mirror, slip: no"},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    char run[100];
    snprintf(run, sizeof run, "resolution: 12, precision: double, alpha: 0.05, %s", cases[k].run);
    struct case_file *c = pool_case(cases[k].head, run);
    struct sph *s = pool_create(c);
    EXPECT_OK(pool_march(s, 0.45));
    const double off = off_balance(s);
    printf("     %s: off by %.1e rho g H^2\n", cases[k].name, off);
    EXPECT_NEAR(off, 0, 1e-12);
    sph_destroy(s);
    case_destroy(c);
  }
}

/* ---- over time ---- */

/* Momentum gained in a dam break until it has struck the wall, against the integral of forces and
 * weight by the trapezoidal rule over so many samples; rho H^2 sqrt(gH). */
static double off_over_time(int samples) {
  struct case_file *c = pool_case(TANK(BOX, ""), "resolution: 16, alpha: 0.1, dt: 5e-4, "
                                                 "precision: double, forces: true");
  struct sph *s = pool_create(c);
  const double end = 0.6;
  double value[SPH_DIAGNOSTIC_COUNT], first = 0, sum = 0;
  for (int i = 0; i <= samples; i++) {
    EXPECT_OK(pool_march(s, end * i / samples));
    EXPECT_OK(sph_rates(s, 0, true, true));
    EXPECT_OK(sph_diagnose(s, c->H, c->g, value));
    if (i == 0) first = value[SPH_DIAGNOSTIC_momentum_x];
    sum -= value[SPH_DIAGNOSTIC_force_x] * end / samples * (i % samples ? 1 : 0.5);
  }
  const double gained = value[SPH_DIAGNOSTIC_momentum_x] - first, unit = s->rho0 * sqrt(s->g);
  EXPECT(s->reflections == 0 && gained > 0.1 * unit);
  sph_destroy(s);
  case_destroy(c);
  return fabs(gained - sum) / unit;
}

static void test_forces_add_up_to_momentum(void) {
  const double coarse = off_over_time(75), fine = off_over_time(300);
  printf("     momentum off by %.1e and %.1e with 75 and 300 samples\n", coarse, fine);
  EXPECT(fine < coarse / 8); /* of the second order: 16 */
}

/* ---- at rest ---- */

static struct sph_forces rest_of(const struct case_file *c, struct sph **out) {
  struct sph *s = *out = pool_create(c);
  struct sph_forces f;
  EXPECT_OK(sph_rates(s, 0, true, true));
  EXPECT_OK(sph_forces_find(s, &f));
  const double unit = s->rho0 * s->g;
  return (struct sph_forces){f.x / unit, f.y / unit, f.moment / unit, f.left / unit,
                             f.right / unit};
}

/* Weight, and rho g h^2/2 on each side, but for squares of the spacing. */
static void test_still_water_presses_on_its_sides(void) {
  static const char *const walls[] = {"ghost", "mirror"};
  for (int k = 0; k < 2; k++) {
    char run[100];
    struct sph *s;
    snprintf(run, sizeof run, "resolution: 20, walls: %s", walls[k]);
    struct case_file *c = pool_case(POOL_STILL, run);
    const struct sph_forces f = rest_of(c, &s);
    printf("     %s: %.4f, %.4f on the sides, %.4f below\n", walls[k], f.left, f.right, f.y);
    EXPECT_NEAR(f.x, 0, 1e-5); /* of floats */
    EXPECT_NEAR(f.y, -2, 0.02);
    EXPECT_NEAR(f.moment, 0, 1e-5);
    EXPECT_NEAR(f.left, -0.5, 1. / 400);
    EXPECT_NEAR(f.right, 0.5, 1. / 400);
    sph_destroy(s);
    case_destroy(c);
  }
}

/* On an upright side and a beach of 1:1 whose force along x is as large; the weight of box and
 * triangle acts at their middles. */
static void test_still_water_presses_on_a_beach(void) {
  struct sph *s;
  struct case_file *c = pool_case(
      "title: beach\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [1, 0], [3, 2]]]}\n"
      "water: {regions: [[[0, 0], [1, 0], [2, 1], [0, 1]]], pressure: hydrostatic}\n" POOL_TIMES,
      "resolution: 24");
  const struct sph_forces f = rest_of(c, &s);
  printf("     beach: %.4f and %.4f, %.4f below, moment %.4f\n", f.left, f.right, f.y, f.moment);
  EXPECT_NEAR(f.left, -0.5, 0.01);
  EXPECT_NEAR(f.right, 0.5, 0.02);
  EXPECT_NEAR(f.x, 0, 0.01);
  EXPECT_NEAR(f.y, -1.5, 0.02);
  EXPECT_NEAR(f.moment, -(0.5 + 0.5 * 4 / 3. - 1.5 * 1.5), 0.02);
  sph_destroy(s);
  case_destroy(c);
}

/* Of a dam break the right edge is on the bed, which is level, then on the wall. */
static void test_the_right_piece_is_the_one_that_water_has_reached(void) {
  struct case_file *c = pool_case(POOL_DAM, "resolution: 12");
  struct sph *s;
  struct sph_forces f = rest_of(c, &s);
  EXPECT(f.right == 0 && f.left < -0.1 * c->H * c->H);
  EXPECT_OK(pool_march(s, 3.5 * sqrt(c->H / s->g)));
  EXPECT_OK(sph_rates(s, 0, true, true));
  EXPECT_OK(sph_forces_find(s, &f));
  EXPECT(f.right > 0);
  printf("     dam break on the wall: %.3f and %.3f, together %.3f\n", f.left, f.right, f.x);
  sph_destroy(s);
  case_destroy(c);
}

static void test_forces_do_not_depend_on_threads(void) {
  struct sph_forces f[2];
  for (int k = 0; k < 2; k++) {
    omp_set_num_threads(k ? 3 : 1);
    struct case_file *c = pool_case(POOL_DAM, "resolution: 12");
    struct sph *s = pool_create(c);
    EXPECT_OK(pool_march(s, 0.05));
    EXPECT_OK(sph_rates(s, 0, true, true));
    EXPECT_OK(sph_forces_find(s, &f[k]));
    sph_destroy(s);
    case_destroy(c);
  }
  omp_set_num_threads(1);
  EXPECT(memcmp(&f[0], &f[1], sizeof *f) == 0);
}

int main(void) {
  RUN(test_walls_and_weight_change_the_momentum);
  RUN(test_forces_add_up_to_momentum);
  RUN(test_still_water_presses_on_its_sides);
  RUN(test_still_water_presses_on_a_beach);
  RUN(test_the_right_piece_is_the_one_that_water_has_reached);
  RUN(test_forces_do_not_depend_on_threads);
  return TEST_RESULT;
}

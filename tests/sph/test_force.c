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

/* Where the particles of a dam break over a step are after a while, in the frame of a tank that has
 * been turned by `angle` about the origin together with its gravity; [2 n], by identity. */
static double *turned_run(double angle, size_t *n) {
  static const double walls[][2] = {{0, 2}, {0, 0}, {2, 0}, {2, 0.5}, {3, 0.5}, {3, 2}};
  static const double water[][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const double c = cos(angle), o = sin(angle);
  char head[1200], *at = head, *end = head + sizeof head;
  at += snprintf(at, (size_t)(end - at),
                 "title: turned\nfluid: {gravity: [%.17g, %.17g]}\nscales: {H: 1}\n"
                 "tank: {walls: [[",
                 9.81 * o, -9.81 * c);
  for (int k = 0; k < 6; k++)
    at += snprintf(at, (size_t)(end - at), "[%.17g, %.17g]%s", c * walls[k][0] - o * walls[k][1],
                   o * walls[k][0] + c * walls[k][1], k < 5 ? ", " : "]]}\nwater: {regions: [[");
  for (int k = 0; k < 4; k++)
    at += snprintf(at, (size_t)(end - at), "[%.17g, %.17g]%s", c * water[k][0] - o * water[k][1],
                   o * water[k][0] + c * water[k][1], k < 3 ? ", " : "]]}\n");
  snprintf(at, (size_t)(end - at), POOL_TIMES);
  struct case_file *f = pool_case(head, "resolution: 16, precision: double, alpha: 0.05, dt: 1e-3");
  struct sph *s = pool_create(f);
  double *r = calloc(2 * s->f.n, sizeof *r);
  EXPECT_OK(pool_march(s, 0.4));
  *n = s->f.n;
  for (size_t i = 0; i < s->f.n; i++) {
    r[2 * s->f.id[i]] = c * s->f.w.x[i] + o * s->f.w.y[i];
    r[2 * s->f.id[i] + 1] = -o * s->f.w.x[i] + c * s->f.w.y[i];
  }
  sph_destroy(s);
  case_destroy(f);
  return r;
}

/* By 30 degrees: nothing but rounding, 1e-16, which a flow that is not yet chaotic magnifies. */
static void test_turning_everything_changes_nothing(void) {
  size_t n, m;
  double *a = turned_run(0, &n), *b = turned_run(M_PI / 6, &m), worst = 0;
  EXPECT(n == m && n > 200);
  for (size_t i = 0; i < 2 * n && n == m; i++) worst = fmax(worst, fabs(a[i] - b[i]));
  printf("     turned by 30 degrees: off by %.1e H\n", worst);
  EXPECT(worst < 1e-9);
  free(a);
  free(b);
}

static void test_potential_at_rest_under_gravity_that_is_turned(void) {
  struct case_file *c = pool_case(TILTED, "resolution: 12");
  /* int -g.r over the water: 2.385 * int x + 9.54 * int y */
  const double along = 2 * 1.25 * 1 - 0.25 * 8 / 3,
               above = (1.25 * 1.25 * 2 - 2 * 1.25 / 4 * 2 + 8. / 48) / 2;
  EXPECT_NEAR(case_rest_potential(c), 1000 * (2.385 * along + 9.54 * above), 1e-6 * 1e4);
  case_destroy(c);
}

#define SHAKEN                                                                                     \
  "motions: [{kind: sway, amplitude: 0.3, period: 1.3, ramp: 0.7}, {kind: heave, amplitude: 0.2, " \
  "period: 0.9, phase: 1, ramp: 0.5}, {kind: roll, amplitude: 0.4, period: 1.7, about: [1.1, "     \
  "0.4], ramp: 0.6}]"

/* Against the tank's own account of its frame. */
static void test_force_is_the_frames(void) {
  struct case_file *c =
      pool_case("title: shaken\nscales: {H: 1}\n"
                "tank: {walls: [[[0, 2], [0, 0], [2, 0], [2, 2]]], " SHAKEN "}\n"
                "water: {regions: [[[0, 0], [2, 0], [2, 1], [0, 1]]]}\n" POOL_TIMES,
                "resolution: 8");
  struct sph *s = pool_create(c);
  for (int k = 0; k < 20; k++) {
    const double t = 0.1 * k, p[2] = {pool_random(), pool_random()};
    const double u[2] = {pool_random(), pool_random()};
    double f[2], expected[2];
    struct tank_frame frame;
    tank_frame_at(c->motions, c->n_motions, t, &frame);
    tank_frame_force(&frame, c->gravity, p, u, expected);
    sph_force_set(s, t);
    sph_force_at(&s->force, p[0], p[1], u[0], u[1], f);
    for (int d = 0; d < 2; d++) EXPECT_NEAR(f[d], expected[d], 1e-12 * s->g);
    sph_force_excess(&s->force, p[0], p[1], u[0], u[1], f);
    EXPECT_NEAR(f[0], expected[0], 1e-12 * s->g);
    EXPECT_NEAR(f[1], expected[1] + s->g, 1e-12 * s->g);
  }
  sph_destroy(s);
  case_destroy(c);
}

/* Water that touches no wall stays where it is while the tank sways, heaves and rolls about it: so
 * far as the time steps go, which are of fourth order. Its energy in the frame of the tank is what
 * the frame's force has given it. */
static double drift_of_drop(double dt) {
  char run[100];
  snprintf(run, sizeof run, "resolution: 8, precision: double, integrator: rk4, dt: %g", dt);
  struct case_file *c =
      pool_case("title: drop\nfluid: {gravity: 0}\nscales: {H: 1, g: 9.81}\n"
                "tank: {walls: [[[0, 3], [0, 0], [3, 0], [3, 3]]], " SHAKEN "}\n"
                "water: {regions: [[[1, 1], [2, 1], [2, 2], [1, 2]]]}\n" POOL_TIMES,
                run);
  struct sph *s = pool_create(c);
  double *x = calloc(2 * s->f.n, sizeof *x), worst = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    x[2 * s->f.id[i]] = s->f.w.x[i];
    x[2 * s->f.id[i] + 1] = s->f.w.y[i];
  }
  const struct result_energy a = sph_energy(s);
  EXPECT_OK(pool_march(s, 0.6));
  const struct result_energy b = sph_energy(s);
  struct tank_frame f;
  tank_frame_at(c->motions, c->n_motions, s->t, &f);
  for (size_t i = 0; i < s->f.n; i++) {
    const double X = s->f.w.x[i], Y = s->f.w.y[i], co = cos(f.angle), si = sin(f.angle);
    worst = fmax(worst, hypot(f.at[0] + co * X - si * Y - x[2 * s->f.id[i]],
                              f.at[1] + si * X + co * Y - x[2 * s->f.id[i] + 1]));
  }
  EXPECT(b.kinetic > 100);
  EXPECT_NEAR((result_energy_budget(&b) - a.total) / b.kinetic, 0, 1e-6);
  free(x);
  sph_destroy(s);
  case_destroy(c);
  return worst;
}

static void test_floating_water_stays_while_the_tank_moves(void) {
  const double coarse = drift_of_drop(4e-3), fine = drift_of_drop(2e-3);
  printf("     moves by %.1e and %.1e m in steps of 4 and 2 ms\n", coarse, fine);
  EXPECT(coarse < 1e-6);
  EXPECT(fine < coarse / 8); /* ramps have a third derivative that jumps */
}

/* q = a t^2/2, which the cubic splines are exactly. */
static void accelerate(struct tank_motion *m, double a) {
  enum { ROWS = 6 };
  m->file.n = ROWS;
  EXPECT((m->file.t = calloc(ROWS, sizeof(double))) && (m->file.q = calloc(ROWS, sizeof(double))));
  for (int i = 0; i < ROWS; i++) {
    m->file.t[i] = 0.3 * i;
    m->file.q[i] = a * m->file.t[i] * m->file.t[i] / 2;
  }
  EXPECT_OK(tank_record_finish(&m->file));
}

/* A column in a tank with a beach, in its frame; m, [2 n], by identity. */
static double *column_in_tank(const char *motions, const double a[2], size_t *n) {
  char head[600];
  snprintf(head, sizeof head,
           "title: column\nscales: {H: 1}\n"
           "tank: {walls: [[[0, 2], [0, 0], [2, 0], [4, 1]]]%s}\n"
           "water: {regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]]}\n" POOL_TIMES,
           motions);
  struct case_file *c = pool_case(head, "resolution: 14, precision: double, alpha: 0.05, dt: 1e-3");
  for (size_t k = 0; k < c->n_motions; k++) accelerate(&c->motions[k], a[k]);
  struct sph *s = pool_create(c);
  for (int d = 0; d < 2 && !c->n_motions; d++) s->force.g[d] -= a[d];
  sph_force_set(s, 0);
  double *r = calloc(2 * s->f.n, sizeof *r);
  EXPECT_OK(pool_march(s, 0.4));
  *n = s->f.n;
  for (size_t i = 0; i < s->f.n; i++) {
    r[2 * s->f.id[i]] = s->f.w.x[i];
    r[2 * s->f.id[i] + 1] = s->f.w.y[i];
  }
  sph_destroy(s);
  case_destroy(c);
  return r;
}

/* One that sways and heaves at constant accelerations, and one at rest whose gravity is less by
 * them: nothing but rounding. (Of a roll see the drop above, which no wall touches.) */
static void test_a_tank_that_moves_is_a_force_that_moves(void) {
  static const double a[2] = {2.1, -1.7};
  size_t n, m;
  double *in_motion = column_in_tank(", motions: [{kind: sway, amplitude: 0.1, period: 1}, {kind: "
                                     "heave, amplitude: 0.1, period: 1}]",
                                     a, &n);
  double *at_rest = column_in_tank("", a, &m), worst = 0;
  EXPECT(n == m && n > 150);
  for (size_t i = 0; i < 2 * n && n == m; i++) worst = fmax(worst, fabs(in_motion[i] - at_rest[i]));
  printf("     a tank that moves: off a force by %.1e m\n", worst);
  EXPECT(worst < 1e-10);
  free(in_motion);
  free(at_rest);
}

/* Moment of the elevation about the middle, over length and depth, by linear theory: x - L/2 = sum
 * c_n cos k_n x, eta_n'' + w_n^2 eta_n = -k_n tanh(k_n h) c_n X'', each by small steps. */
static double linear_shift(const struct case_file *c, double L, double h, double end) {
  const int steps = 20000;
  double sum = 0;
  for (int n = 1; n < 40; n += 2) {
    const double k = n * M_PI / L, lift = k * tanh(k * h), cn = -4 * L / pow(n * M_PI, 2);
    double eta = 0, rate = 0, q[3];
    for (int i = 0; i < steps; i++) { /* leapfrog */
      tank_motion_at(&c->motions[0], end * i / steps, q);
      rate += end / steps * (i ? 1 : 0.5) * -(c->gravity * lift * eta + lift * cn * q[2]);
      eta += end / steps * rate;
    }
    sum += eta * cn / (2 * h);
  }
  return sum;
}

/* A tank shaken at its first natural period: how far the centre of the water is from linear theory
 * in three periods of growth, over the farthest that it goes. */
static double error_of_sloshing(double resolution) {
  const double L = 1, h = 0.5, g = 9.81, k = M_PI / L;
  const double period = 2 * M_PI / sqrt(g * k * tanh(k * h));
  char head[500], run[60];
  snprintf(head, sizeof head,
           "title: sloshing\nscales: {H: 0.5}\ntank: {walls: [[[0, 1], [0, 0], [1, 0], [1, 1]]], "
           "motions: [{kind: sway, amplitude: 0.002, period: %.15g}]}\n"
           "water: {regions: [[[0, 0], [1, 0], [1, 0.5], [0, 0.5]]]}\n" POOL_TIMES,
           period);
  snprintf(run, sizeof run, "resolution: %g, alpha: 0.005", resolution);
  struct case_file *c = pool_case(head, run);
  struct sph *s = pool_create(c);
  const struct result_energy a = sph_energy(s);
  double worst = 0, most = 0;
  for (int i = 1; i <= 24; i++) {
    double x = 0, mass = 0;
    EXPECT_OK(pool_march(s, i * period / 8));
    for (size_t j = 0; j < s->f.n; j++) {
      x += s->f.m[j] * s->f.w.x[j];
      mass += s->f.m[j];
    }
    const double expected = linear_shift(c, L, h, s->t);
    worst = fmax(worst, fabs(x / mass - L / 2 - expected));
    most = fmax(most, fabs(expected));
  }
  const struct result_energy b = sph_energy(s);
  printf("     H/dx = %g: centre of the water off by %.2g of %.3g m\n", resolution, worst, most);
  EXPECT(b.term[SPH_TERM_frame] < 0);
  EXPECT_NEAR((result_energy_budget(&b) - a.total) / b.term[SPH_TERM_frame], 0, 1e-3);
  sph_destroy(s);
  case_destroy(c);
  return worst / most;
}

/* The lattice and the viscosity, both of which fall with the spacing. */
static void test_sloshing_grows_as_linear_theory_has_it(void) {
  const double coarse = error_of_sloshing(16), fine = error_of_sloshing(32);
  EXPECT(coarse < 0.1);
  EXPECT(fine < 0.75 * coarse);
}

int main(void) {
  RUN(test_force_is_the_frames);
  RUN(test_floating_water_stays_while_the_tank_moves);
  RUN(test_a_tank_that_moves_is_a_force_that_moves);
  RUN(test_sloshing_grows_as_linear_theory_has_it);
  RUN(test_water_rests_under_gravity_that_is_turned);
  RUN(test_mirrored_gravity_has_mirrored_water);
  RUN(test_turning_everything_changes_nothing);
  RUN(test_potential_at_rest_under_gravity_that_is_turned);
  return TEST_RESULT;
}

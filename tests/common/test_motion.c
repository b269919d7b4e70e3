/* How a tank and its walls move: derivatives, smooth starts, splines of files, places of vertices.
 */
#include "common/tank/motion.h"

#include <stdlib.h>

#include "common/case/case.h"
#include "common/tank/tank.h"
#include "tests/common/case_registry.h"
#include "tests/test.h"

static const struct tank_motion sine = {
    .kind = TANK_MOTION_piston,
    .sine = {.amplitude = 0.37, .period = 2.385, .phase = 0.6, .ramp = 3.1},
};

/* Fourth order in e: 1e-12 of the fifth derivative, and rounding of 1e-16/e. */
static void expect_derivatives(const struct tank_motion *m, double t, double scale) {
  const double e = 1e-3;
  double q[3], at[4][3];
  tank_motion_at(m, t, q);
  for (int k = 0; k < 4; k++) tank_motion_at(m, t + e * (k < 2 ? k - 2 : k - 1), at[k]);
  for (int k = 0; k < 2; k++)
    EXPECT_NEAR(q[k + 1], (8 * (at[2][k] - at[1][k]) - (at[3][k] - at[0][k])) / (12 * e),
                1e-9 * scale);
}

static void test_a_sine_has_its_velocity_and_acceleration(void) {
  for (double t = 0.1; t < 10; t += 0.173) /* no sample within 2e of the ramp's end */
    expect_derivatives(&sine, t, 10);
}

static void test_a_sine_with_ramp_is_smooth_at_both_ends_of_it(void) {
  double before[3], after[3], w = 2 * M_PI / sine.sine.period;
  tank_motion_at(&sine, 0, after);
  for (int k = 0; k < 3; k++) EXPECT_NEAR(after[k], 0, 0);
  tank_motion_at(&sine, -1, before);
  for (int k = 0; k < 3; k++) EXPECT_NEAR(before[k], 0, 0);
  /* R''' = 60/ramp^3 there, times 1e-9 */
  tank_motion_at(&sine, sine.sine.ramp * (1 - 1e-9), before);
  tank_motion_at(&sine, sine.sine.ramp, after);
  for (int k = 0; k < 3; k++) EXPECT_NEAR(before[k], after[k], 1e-7);
  EXPECT_NEAR(after[0], 0.37 * sin(w * 3.1 + 0.6), 1e-15);
  tank_motion_at(&sine, 7.7, after); /* and is the sine behind it */
  EXPECT_NEAR(after[0], 0.37 * sin(w * 7.7 + 0.6), 1e-14);
  EXPECT_NEAR(after[2], -w * w * after[0], 1e-14);
}

/* A record of n rows of f, at uneven times. */
static struct tank_motion record_of(double (*f)(double), size_t n, double end) {
  struct tank_motion m = {.kind = TANK_MOTION_sway, .file = {.n = n}};
  m.file.t = calloc(n, sizeof *m.file.t);
  m.file.q = calloc(n, sizeof *m.file.q);
  for (size_t i = 0; i < n; i++) {
    double s = (double)i / (double)(n - 1);
    m.file.t[i] = end * (s + 0.03 * sin(2 * M_PI * s));
    m.file.q[i] = f(m.file.t[i]);
  }
  EXPECT_OK(tank_record_finish(&m.file));
  return m;
}

static double cubic(double t) {
  return 0.2 + t * (-1.3 + t * (0.7 + t * 0.11));
}

static void test_a_spline_is_exact_for_a_cubic(void) {
  struct tank_motion m = record_of(cubic, 9, 4);
  for (double t = -0.2; t < 4.2; t += 0.0713) {
    double q[3];
    tank_motion_at(&m, t, q);
    EXPECT_NEAR(q[0], cubic(t), 1e-13);
    EXPECT_NEAR(q[1], -1.3 + t * (1.4 + t * 0.33), 1e-12);
    EXPECT_NEAR(q[2], 1.4 + t * 0.66, 1e-11);
  }
  tank_record_destroy(&m.file);
}

static double wave(double t) {
  return sin(2.385 * t);
}

static void test_a_spline_has_a_continuous_acceleration(void) {
  struct tank_motion m = record_of(wave, 23, 6);
  for (size_t i = 1; i + 1 < m.file.n; i++) {
    double before[3], after[3];
    tank_motion_at(&m, nextafter(m.file.t[i], 0), before);
    tank_motion_at(&m, m.file.t[i], after);
    for (int k = 0; k < 3; k++) EXPECT_NEAR(before[k], after[k], 1e-12);
  }
  for (size_t i = 1; i < m.file.n; i++)
    expect_derivatives(&m, (m.file.t[i] + m.file.t[i - 1]) / 2, 10);
  tank_record_destroy(&m.file);
}

static void test_a_spline_is_of_fourth_order(void) {
  double error[2] = {0, 0};
  for (int k = 0; k < 2; k++) {
    struct tank_motion m = record_of(wave, k ? 161 : 81, 6);
    for (double t = 0; t < 6; t += 0.00713) {
      double q[3];
      tank_motion_at(&m, t, q);
      error[k] = fmax(error[k], fabs(q[0] - wave(t)));
    }
    tank_record_destroy(&m.file);
  }
  EXPECT(log2(error[0] / error[1]) > 3.8);
}

/* ---- the whole tank ---- */

static const struct tank_motion ride[] = {
    {.kind = TANK_MOTION_sway, .sine = {.amplitude = 0.3, .period = 1.7, .ramp = 1}},
    {.kind = TANK_MOTION_roll,
     .about = {2.3, -0.4},
     .sine = {.amplitude = 0.4, .period = 2.1, .phase = 0.3, .ramp = 1}},
    {.kind = TANK_MOTION_heave, .sine = {.amplitude = 0.2, .period = 0.9, .ramp = 1}},
    {.kind = TANK_MOTION_sway, .sine = {.amplitude = 0.1, .period = 0.7, .ramp = 1}},
};

/* Where a point of the tank is in the laboratory. */
static void place(double t, const double p[2], double x[2]) {
  struct tank_frame f;
  tank_frame_at(ride, 4, t, &f);
  x[0] = f.at[0] + cos(f.angle) * p[0] - sin(f.angle) * p[1];
  x[1] = f.at[1] + sin(f.angle) * p[0] + cos(f.angle) * p[1];
}

static void test_a_rolling_tank_turns_about_its_point(void) {
  double x[2], sway[3], more[3], heave[3];
  place(3.7, ride[1].about, x);
  tank_motion_at(&ride[0], 3.7, sway);
  tank_motion_at(&ride[3], 3.7, more);
  tank_motion_at(&ride[2], 3.7, heave);
  EXPECT_NEAR(x[0], 2.3 + sway[0] + more[0], 1e-15);
  EXPECT_NEAR(x[1], -0.4 + heave[0], 1e-15);
}

/* A free particle falls by gravity alone in the laboratory: what moves in the tank by the force
 * that it feels there goes along the same parabola. Checked at one instant, by differences. */
static void test_a_free_particle_feels_what_makes_it_fall(void) {
  const double t = 2.9, e = 1e-3, gravity = 9.81, start[2] = {1.1, 2.2}, speed[2] = {0.7, -0.3};
  double p[3][2], u[2], felt[2];
  struct tank_frame f;
  for (int k = -1; k <= 1; k++) { /* the parabola, seen from the tank */
    const double s = k * e,
                 x[2] = {start[0] + s * speed[0], start[1] + s * speed[1] - gravity * s * s / 2};
    tank_frame_at(ride, 4, t + s, &f);
    const double r[2] = {x[0] - f.at[0], x[1] - f.at[1]};
    p[k + 1][0] = cos(f.angle) * r[0] + sin(f.angle) * r[1];
    p[k + 1][1] = cos(f.angle) * r[1] - sin(f.angle) * r[0];
  }
  for (int k = 0; k < 2; k++) u[k] = (p[2][k] - p[0][k]) / (2 * e);
  tank_frame_at(ride, 4, t, &f);
  tank_frame_force(&f, gravity, p[1], u, felt);
  for (int k = 0; k < 2; k++) /* e^2/12 of the fourth derivative, w^4 x: 1e-7 x 1e4 */
    EXPECT_NEAR(felt[k], (p[2][k] - 2 * p[1][k] + p[0][k]) / (e * e), 1e-3);
}

static void test_a_tank_at_rest_feels_gravity(void) {
  struct tank_frame f;
  double felt[2], p[2] = {3, 4}, u[2] = {5, 6};
  tank_frame_at(NULL, 0, 1, &f);
  tank_frame_force(&f, 9.81, p, u, felt);
  EXPECT_NEAR(felt[0], 0, 0);
  EXPECT_NEAR(felt[1], -9.81, 0);
}

/* ---- walls ---- */

static struct case_file *case_of(const char *walls, const char *motions) {
  char text[1000];
  struct problems problems;
  struct case_file *c;
  snprintf(
      text, sizeof text,
      "tank: {walls: %s, motions: [%s]}\nwater: {regions: [[[0, 0], [4, 0], [4, 1], [0, 1]]]}\n"
      "time: {end: 9}\nruns: [{solver: sph, resolution: 9}]\n",
      walls, motions);
  if (case_parse("motion", text, &fake_registry, &problems, &c) != OK)
    for (size_t i = 0; i < problems.n; i++) TEST_FAIL("%s", problems.text[i]);
  problems_destroy(&problems);
  return c;
}

enum { MOST = 16 };
static double p[MOST][2], v[MOST][2], a[MOST][2];
static const char box[] = "[[[0, 3], [0, 2], [0, 0], [4, 0], [4, 3]]]";

/* Whether velocities and accelerations are those of the places. */
static void expect_motion_of_vertices(const struct case_file *c, double t) {
  const double e = 1e-4;
  double before[MOST][2], after[MOST][2], unused[MOST][2];
  tank_vertices_at(&c->walls, c->motions, c->n_motions, t - e, before, unused, NULL);
  tank_vertices_at(&c->walls, c->motions, c->n_motions, t + e, after, unused, NULL);
  tank_vertices_at(&c->walls, c->motions, c->n_motions, t, p, v, a);
  for (size_t i = 0; i < c->walls.points; i++)
    for (int k = 0; k < 2; k++) { /* e^2/6 x w^3 and, of rounding, 1e-16/e^2 */
      EXPECT_NEAR(v[i][k], (after[i][k] - before[i][k]) / (2 * e), 1e-6);
      EXPECT_NEAR(a[i][k], (after[i][k] - 2 * p[i][k] + before[i][k]) / (e * e), 1e-6);
    }
}

static void test_a_piston_moves_its_side_to_the_right(void) {
  struct case_file *c = case_of(box, "{kind: piston, side: left, amplitude: 0.3, period: 2}");
  double q[3];
  if (!c) return;
  expect_motion_of_vertices(c, 2.4);
  tank_motion_at(&c->motions[0], 2.4, q);
  EXPECT(q[0] > 0.1);
  for (size_t i = 0; i < 3; i++) {
    EXPECT_NEAR(p[i][0], q[0], 1e-15);
    EXPECT_NEAR(p[i][1], c->walls.p[i][1], 0);
  }
  for (size_t i = 3; i < 5; i++) EXPECT_NEAR(p[i][0], 4, 0);
  case_destroy(c);
}

static void test_a_flap_turns_its_top_to_the_right(void) {
  struct case_file *c =
      case_of(box, "{kind: flap, side: right, amplitude: 0.2, period: 2, hinge: 1},"
                   "{kind: flap, side: right, amplitude: 0.1, period: 1, hinge: 1},"
                   "{kind: piston, side: right, amplitude: -0.3, period: 3}");
  double flap[3], piston[3];
  if (!c) return;
  expect_motion_of_vertices(c, 2.4);
  tank_side_at(c->motions, c->n_motions, TANK_MOTION_flap, TANK_RIGHT, 2.4, flap);
  tank_motion_at(&c->motions[2], 2.4, piston);
  EXPECT(flap[0] > 0.1);
  const size_t top = c->walls.points - 1;
  EXPECT_NEAR(p[top][0], 4 + piston[0] + 2 * sin(flap[0]), 1e-15);
  EXPECT_NEAR(p[top][1], 1 + 2 * cos(flap[0]), 1e-15);
  EXPECT_NEAR(p[top - 1][0], 4 + piston[0], 1e-15); /* the hinge, which the reader put there */
  EXPECT_NEAR(p[top - 1][1], 1, 0);
  EXPECT_NEAR(p[top - 2][0], 4 + piston[0], 1e-15);
  EXPECT_NEAR(p[top - 2][1], 0, 0);
  case_destroy(c);
}

/* A leaning side carries what is on it; beside that as it is, and behind it, by 1 mm. */
static void test_what_a_side_has_passed_is_behind_it(void) {
  static const char *const motions[] = {
      "{kind: piston, side: left, amplitude: 0.3, period: 2}",
      "{kind: flap, side: left, amplitude: 0.2, period: 2, hinge: 1}",
      "{kind: piston, side: left, amplitude: -0.3, period: 2}",
  };
  for (int k = 0; k < 3; k++) {
    struct case_file *c = case_of("[[[-3, 3], [0, 0], [4, 0], [4, 3]]]", motions[k]);
    if (!c) return;
    const double near = case_near(c), t = 2.4;
    for (double y = 0; y < 2.5; y += 0.3) {
      double at[2] = {-y, y};
      tank_point_at(&c->walls, c->motions, c->n_motions, t, near, at);
      EXPECT(!tank_hides_at(&c->walls, c->motions, c->n_motions, t, near, at));
      at[0] += 1e-3;
      EXPECT(!tank_hides_at(&c->walls, c->motions, c->n_motions, t, near, at));
      at[0] -= 2e-3;
      EXPECT(tank_hides_at(&c->walls, c->motions, c->n_motions, t, near, at));
    }
    EXPECT(tank_hides_at(&c->walls, c->motions, c->n_motions, t, near, (double[]){0.1, 0}) ==
           (k == 0));
    EXPECT(!tank_hides_at(&c->walls, c->motions, c->n_motions, t, near, (double[]){4.1, 1}));
    case_destroy(c);
  }
}

static void test_fingerprints_hold_the_motions(void) {
  const char *const motions[] = {
      "{kind: sway, amplitude: 0.3, period: 2}",
      "{kind: heave, amplitude: 0.3, period: 2}",
      "{kind: sway, amplitude: 0.3, period: 2, phase: 1}",
      "{kind: sway, amplitude: 0.3, period: 2, ramp: 1}",
      "{kind: piston, side: left, amplitude: 0.3, period: 2}",
      "{kind: piston, side: right, amplitude: 0.3, period: 2}",
      "{kind: flap, side: right, amplitude: 0.3, period: 2}",
      "{kind: flap, side: right, amplitude: 0.3, period: 2, hinge: 0.1}",
      "{kind: roll, amplitude: 0.3, period: 2}",
      "{kind: roll, amplitude: 0.3, period: 2, about: [0, 0]}",
  };
  enum { N = sizeof motions / sizeof *motions };
  char water[N][33], whole[N][33];
  for (size_t i = 0; i < N; i++) {
    struct case_file *c = case_of(box, motions[i]);
    if (!c) continue;
    case_water_fingerprint(c, water[i]);
    case_fingerprint(c, &c->runs[0], whole[i]);
    for (size_t k = 0; k < i; k++)
      EXPECT(strcmp(water[i], water[k]) != 0 && strcmp(whole[i], whole[k]) != 0);
    case_destroy(c);
  }
}

int main(void) {
  RUN(test_a_sine_has_its_velocity_and_acceleration);
  RUN(test_a_sine_with_ramp_is_smooth_at_both_ends_of_it);
  RUN(test_a_spline_is_exact_for_a_cubic);
  RUN(test_a_spline_has_a_continuous_acceleration);
  RUN(test_a_spline_is_of_fourth_order);
  RUN(test_a_rolling_tank_turns_about_its_point);
  RUN(test_a_free_particle_feels_what_makes_it_fall);
  RUN(test_a_tank_at_rest_feels_gravity);
  RUN(test_a_piston_moves_its_side_to_the_right);
  RUN(test_a_flap_turns_its_top_to_the_right);
  RUN(test_what_a_side_has_passed_is_behind_it);
  RUN(test_fingerprints_hold_the_motions);
  return TEST_RESULT;
}

/* Water in a tank that heaves at a constant acceleration is water at rest under more gravity. A
 * solver that measures its time in sqrt(H/g) of the gravity that it is told filters at another pace
 * in the two, and places its nodes so: what is left of that falls with the order of the method; a
 * term that is wrong would not. */
#include "common/tank/motion.h"
#include "tests/bem/run.h"

static const double MORE = 0.5; /* of the gravity, 1 */

static const char text[] =
    "title: heave\n"
    "fluid: {density: 1, gravity: %.17g}\n"
    "scales: {H: 1}\n"
    "tank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]%s}\n"
    "water: {regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]], pressure: released}\n"
    "time: {end: 1.2, every: 1.2, sample: 0.05}\n"
    "probes: [{name: corner, at: [0, 0]}, {name: side, at: [0, 0.2]}]\n"
    "gauges: [{name: left, x: 0}]\n"
    "runs: [{name: bem, solver: bem, resolution: %d, tolerance: 1e-9, gmres: 1e-11,\n"
    "        filter: %.17g, smoothing: %.17g}]\n";

/* q = MORE t^2/2, which a cubic spline is exactly. */
static void accelerate(struct tank_motion *m) {
  enum { ROWS = 6 };
  m->file.n = ROWS;
  m->file.t = calloc(ROWS, sizeof(double));
  m->file.q = calloc(ROWS, sizeof(double));
  EXPECT(m->file.t && m->file.q);
  for (int i = 0; i < ROWS; i++) {
    m->file.t[i] = 0.3 * i;
    m->file.q[i] = MORE * m->file.t[i] * m->file.t[i] / 2;
  }
  EXPECT_OK(tank_record_finish(&m->file));
}

static struct result_file *heaving(int resolution) {
  char with[sizeof text + 200];
  snprintf(with, sizeof with, text, 1., ", motions: [{kind: heave, amplitude: 0.1, period: 1}]",
           resolution, 30., 30.);
  struct case_file *c = run_case(with);
  if (!c) return NULL;
  accelerate(&c->motions[0]);
  return run_bem_case(c);
}

/* rate: of filter and smoothing, in its own unit of time. */
static struct result_file *heavier(int resolution, double rate) {
  char with[sizeof text + 200];
  snprintf(with, sizeof with, text, 1 + MORE, "", resolution, rate, rate);
  return run_bem(with);
}

static double apart(const struct result_series *a, const struct result_series *b) {
  double worst = 0;
  EXPECT(a->n == b->n && a->n == 25);
  for (size_t i = 0; i < a->n && i < b->n; i++) {
    const double off = fabs(a->value[i] - b->value[i]);
    worst = off <= worst ? worst : off;
  }
  return worst;
}

/* Largest differences of the level at the wall, where a node is, and of pressures. */
static void compare(int resolution, double rate, double off[2]) {
  struct result_file *a = heaving(resolution), *b = heavier(resolution, rate);
  off[0] = off[1] = NAN;
  if (a && b) {
    off[0] = apart(&a->gauges[0], &b->gauges[0]);
    off[1] = fmax(apart(&a->probes[0], &b->probes[0]), apart(&a->probes[1], &b->probes[1]));
  }
  printf("     %2d nodes per H, filter at %.4g: levels off by %.1e H, pressures by %.1e rho g H\n",
         resolution, rate, off[0], off[1]);
  result_file_destroy(a);
  result_file_destroy(b);
}

static void test_a_tank_that_heaves_is_one_under_more_gravity(void) {
  double coarse[2], fine[2], same[2];
  compare(8, 30, coarse);
  compare(32, 30, fine);
  compare(8, 30 / sqrt(1 + MORE), same);
  EXPECT(log2(coarse[0] / fine[0]) > 2 * 3.5 && log2(coarse[1] / fine[1]) > 2 * 2);
  EXPECT(same[0] < coarse[0] / 10); /* it is the filter's pace */
}

int main(void) {
  RUN(test_a_tank_that_heaves_is_one_under_more_gravity);
  return TEST_RESULT;
}

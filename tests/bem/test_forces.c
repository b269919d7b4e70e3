/* Forces on the walls of any tank, which may move: water at rest, and the law of momentum. */
#include "bem/water/forces.h"
#include "bem/water/spin.h"
#include "tests/bem/water.h"

/* ---- at rest ---- */

static double first(const struct result_file *f, const char *name) {
  for (size_t i = 0; i < f->n_diagnostics; i++)
    if (!strcmp(f->diagnostics[i].name, name)) return f->diagnostics[i].value[0];
  return NAN;
}

/* Between a side that leans out and a beach. */
static void test_water_at_rest_weighs_on_its_walls(void) {
  struct result_file *f =
      run_bem("title: rest\n"
              "fluid: {density: 1000, gravity: 9.81}\n"
              "scales: {H: 0.5}\n"
              "tank: {walls: [[[0.4, 1.2], [1, 0], [1.6, 0], [3.2, 0.8], [4, 1]]]}\n"
              "water: {wave: {kind: still, depth: 0.5}}\n"
              "time: {end: 0.1, every: 0.1, sample: 0.1}\n"
              "runs: [{name: bem, solver: bem, resolution: 20, forces: true, tolerance: 1e-9}]\n");
  if (!f) return;
  const double weight = 1000 * 9.81, h = 0.5, left = 0.25, beach = 1; /* m, across the slopes */
  EXPECT_NEAR(first(f, "force_x") / weight, 0, 1e-9);
  EXPECT_NEAR(first(f, "force_y") / weight, -h * (0.6 + (left + beach) / 2), 1e-9);
  EXPECT_NEAR(first(f, "force_left") / weight, -h * h / 2, 1e-9);
  EXPECT_NEAR(first(f, "force_right") / weight, h * h / 2, 1e-9);
  /* the weight acts at the middle of a box and of two triangles, which a third of their width is
   * from */
  const double at =
      0.6 * h * 1.3 + h * left / 2 * (1 - left / 3) + h * beach / 2 * (1.6 + beach / 3);
  EXPECT_NEAR(first(f, "moment") / weight, -(at - 2.2 * h * (0.6 + (left + beach) / 2)), 1e-9);
  result_file_destroy(f);
}

/* ---- moving ---- */

enum { FIELDS = 3 };

struct flow_case {
  struct water water;
  double t, *k; /* k: rates of the four stages and a state */
};

static bool begin(struct flow_case *w, const char *text) {
  if (!water_start(&w->water, run_case(text), 2000)) return false;
  w->k = calloc(5 * FIELDS * w->water.f.surface.n, sizeof *w->k);
  return true;
}

static void end(struct flow_case *w) {
  water_end(&w->water);
  free(w->k);
}

/* Runge & Kutta's method. */
static void step(struct flow_case *w, double dt) {
  static const double at[4] = {0, 0.5, 0.5, 1}, part[4] = {1. / 6, 1. / 3, 1. / 3, 1. / 6};
  const size_t n = FIELDS * w->water.f.surface.n;
  double *state = w->water.f.surface.state, *trial = w->k + 4 * n;
  for (int s = 0; s < 4; s++) {
    const double *before = w->k + (size_t)(s ? s - 1 : 0) * n;
    for (size_t i = 0; i < n; i++) trial[i] = state[i] + at[s] * dt * before[i];
    EXPECT_OK(bem_flow_rates(&w->water.f, w->t + at[s] * dt, trial, w->k + (size_t)s * n));
  }
  for (size_t i = 0; i < n; i++)
    for (int s = 0; s < 4; s++) state[i] += part[s] * dt * w->k[(size_t)s * n + i];
  w->t += dt;
}

static void momentum_of(struct flow_case *w, double momentum[2]) {
  struct bem_flow *f = &w->water.f;
  struct bem_spin spin;
  f->time = w->t;
  EXPECT_OK(bem_flow_solve(f, f->surface.state, 1));
  EXPECT_OK(bem_pressure_wet(&w->water.p, f));
  if (!f->motion.rolls) {
    double kinetic, known[2] = {0};
    bem_forces_momentum(f, f->surface.state, momentum);
    if (f->moving.map) bem_forces_of_known(f, &w->water.p.wet, &kinetic, known);
    for (int axis = 0; axis < 2; axis++) momentum[axis] += known[axis];
    return;
  }
  EXPECT_OK(bem_spin_find(&w->water.p, f, f->surface.state, 0, &spin));
  memcpy(momentum, spin.momentum, sizeof spin.momentum);
}

/* Volume, and integrals of x and y over the water from the origin of the motion. */
static void moments_of(const struct flow_case *w, double moment[3]) {
  const struct bem_surface *s = &w->water.f.surface;
  const struct bem_rule *wet = &w->water.p.wet;
  const double *x = s->state, *y = x + s->n;
  const double complex origin = w->water.f.motion.origin;
  double *a = w->k, *b = a + s->n, *c = b + s->n;
  for (size_t k = 0; k < s->n; k++) {
    c[k] = y[k] + cimag(origin);
    a[k] = 0.5 * (x[k] + creal(origin)) * (x[k] + creal(origin));
    b[k] = 0.5 * c[k] * c[k];
  }
  moment[0] = bem_surface_integral(s, c, x);
  moment[1] = -bem_surface_integral(s, a, y);
  moment[2] = bem_surface_integral(s, b, x);
  for (size_t j = 0; j < BEM_RULE * wet->panels; j++) {
    const double complex r = wet->z[j] + origin, dz = wet->weight[j] * wet->slope[j];
    moment[0] -= cimag(r) * creal(dz);
    moment[1] += 0.5 * creal(r) * creal(r) * cimag(dz);
    moment[2] -= 0.5 * cimag(r) * cimag(r) * creal(dz);
  }
}

static const char moving[] = "title: moving tank\n"
                             "fluid: {density: 1, gravity: 1}\n"
                             "scales: {H: 1}\n"
                             "tank:\n"
                             "  walls: [[%s]]\n"
                             "  motions: [%s]\n"
                             "water: {wave: {kind: still, depth: 0.8}}\n"
                             "time: {end: 9, every: 1}\n"
                             "runs: [{name: bem, solver: bem, resolution: %d}]\n";

/* By how much the rate of change of momentum at t = 2 is not what weight, the forces in the frame
 * and those on the walls make it, with differences of fourth order. */
static double momentum_error(const char *walls, const char *motions, int resolution,
                             double *force) {
  const double dt = 0.04, late = 0.02;
  char text[800];
  struct flow_case w = {0};
  double p[5][2], moment[3] = {0}, momentum[2] = {0}, error[2] = {0};
  struct bem_forces on = {0};
  snprintf(text, sizeof text, moving, walls, motions, resolution);
  if (!begin(&w, text)) return NAN;
  while (w.t < 2 - 2.5 * late) step(&w, fmin(dt, 2 - 2 * late - w.t));
  for (int i = 0; i < 5; i++) {
    momentum_of(&w, p[i]);
    if (i == 2) {
      memcpy(momentum, p[i], sizeof momentum);
      EXPECT_OK(bem_pressure_solve(&w.water.p, &w.water.f, w.water.f.surface.state));
      EXPECT_OK(bem_forces_find(&w.water.p, &w.water.f, w.water.f.surface.state, momentum, &on));
      moments_of(&w, moment);
      const struct bem_motion *m = &w.water.f.motion;
      const double turn2 = m->turn * m->turn;
      error[0] = moment[0] * m->push[0] + m->turning * moment[2] + turn2 * moment[1] +
                 2 * m->turn * momentum[1] - on.force_x;
      error[1] = moment[0] * (m->push[1] - 1) - m->turning * moment[1] + turn2 * moment[2] -
                 2 * m->turn * momentum[0] - on.force_y;
    }
    step(&w, late);
  }
  for (int k = 0; k < 2; k++)
    error[k] -= (p[0][k] - 8 * p[1][k] + 8 * p[3][k] - p[4][k]) / (12 * late);
  *force = hypot(on.force_x, on.force_y + moment[0]);
  end(&w);
  return hypot(error[0], error[1]);
}

static void test_forces_on_the_walls_change_the_momentum(void) {
  static const struct {
    const char *name, *walls, *motions;
  } tank[] = {
      {"bar that sways", "[0, 2], [0, 0], [1, 0], [1.4, 0.3], [1.7, 0.3], [2, 0], [3, 0], [3, 2]",
       "{kind: sway, amplitude: 0.04, period: 3.3}"},
      {"box that rolls", "[0, 2], [0, 0], [2, 0], [2, 2]",
       "{kind: roll, amplitude: 0.08, period: 3.1, about: [0.8, 0.3]}"},
      {"piston and beach", "[0, 2], [0, 0], [2, 0], [6, 2]",
       "{kind: piston, side: left, amplitude: 0.1, period: 3.1}"},
      {"piston and bar", "[0, 2], [0, 0], [1, 0], [1.4, 0.3], [1.7, 0.3], [2, 0], [4, 0], [4, 2]",
       "{kind: piston, side: right, amplitude: 0.1, period: 3.1}"},
      {"flap at the bed", "[0, 2], [0, 0], [3, 0], [3, 2]",
       "{kind: flap, side: left, amplitude: 0.1, period: 3.1}"},
      {"flap above it", "[0, 2], [0, 0], [3, 0], [4, 2]",
       "{kind: flap, side: left, amplitude: 0.1, period: 3.1, hinge: 0.3}"},
      {"beach that rolls", "[0, 2], [0, 0], [1, 0], [5, 2]",
       "{kind: roll, amplitude: 0.05, period: 3.1, about: [2, -1]}, "
       "{kind: sway, amplitude: 0.05, period: 2.7}"},
  };
  for (size_t i = 0; i < sizeof tank / sizeof *tank; i++) {
    double force, coarse = momentum_error(tank[i].walls, tank[i].motions, 10, &force);
    const double fine = momentum_error(tank[i].walls, tank[i].motions, 20, &force);
    printf("  %-16s: force %.3g from rest; off by %.1e, %.1e\n", tank[i].name, force, coarse, fine);
    EXPECT(force > 0.005);
    EXPECT(fine < 2e-3 * force && fine < coarse);
  }
}

/* A side that bends above the water has the tank taken by its map. */
static struct result_file *piston(const char *top, int resolution) {
  char text[600];
  snprintf(text, sizeof text,
           "title: piston\n"
           "fluid: {density: 1, gravity: 1}\n"
           "scales: {H: 1}\n"
           "tank:\n"
           "  walls: [[[0, 3], [0, 0], [3, 0], [3, 2], [%s, 3]]]\n"
           "  motions: [{kind: piston, side: left, amplitude: 0.05, period: 4}]\n"
           "water: {wave: {kind: still, depth: 1}}\n"
           "time: {end: 4, every: 4, sample: 0.25}\n"
           "probes: [{name: p, at: [0, 0.3], size: 0.02}]\n"
           "gauges: [{name: g, x: 3}]\n"
           "runs: [{name: bem, solver: bem, resolution: %d, tolerance: 1e-9}]\n",
           top, resolution);
  return run_bem(text);
}

static double largest_difference(const struct result_series *a, const struct result_series *b) {
  double most = 0;
  for (size_t i = 0; i < a->n; i++) most = fmax(most, fabs(a->value[i] - b->value[i]));
  return most;
}

static void test_a_piston_is_the_same_by_the_map_of_any_tank(void) {
  double wire[2] = {0}, probe[2] = {0};
  for (int i = 0; i < 2; i++) {
    struct result_file *box = piston("3", i ? 20 : 10), *any = piston("3.2", i ? 20 : 10);
    if (box && any) {
      wire[i] = largest_difference(&box->gauges[0], &any->gauges[0]);
      probe[i] = largest_difference(&box->probes[0], &any->probes[0]);
    }
    result_file_destroy(box);
    result_file_destroy(any);
  }
  printf("  level %.1e, %.1e; pressure on the piston %.1e, %.1e\n", wire[0], wire[1], probe[0],
         probe[1]);
  EXPECT(wire[1] < 1e-6 && probe[1] < 2e-6); /* of waves of 0.01, pressures of 0.1 */
  EXPECT(probe[1] < probe[0] / 4);
}

int main(void) {
  RUN(test_water_at_rest_weighs_on_its_walls);
  RUN(test_forces_on_the_walls_change_the_momentum);
  RUN(test_a_piston_is_the_same_by_the_map_of_any_tank);
  return TEST_RESULT;
}

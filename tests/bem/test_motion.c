/* Tanks that sway and heave, and pistons, against the linear theory of a closed tank: every mode
 * cos(n pi x/L) is an oscillator that the motion drives; and the forces on the walls against the
 * momentum of the water. */
#include "tests/bem/run.h"

enum { MODES = 200 };

static double motion(double t, double amplitude, double period, int derivative) {
  struct tank_motion m = {.sine = {amplitude, period, 0, period}};
  double q[3];
  tank_motion_at(&m, t, q);
  return q[derivative];
}

/* eta at x of still water in a tank of length L and depth h, g = 1, by Runge & Kutta's method for
 * eta_n'' + omega_n^2 eta_n = drive_n q''. In a tank that sways the force is that of the odd terms
 * of x = L/2 - sum 4 L/(n pi)^2 cos; a piston's known potential has (L - x)^2/(2 L) on the surface,
 * L/6 + sum 2 L/(n pi)^2 cos, and lifts the mean. In a tank that rolls by theta about the middle of
 * its width, at y = c, there is on the surface the head theta x, x from that middle, and the
 * potential theta' (x (c - h) + sum 2 x_n/k tanh(k h/2) cos), which no water passes the surface
 * for. */
struct modes {
  double L, h, amplitude, period;
  bool piston, roll;
  double about; /* height that a roll is about */
  double eta[MODES], rate[MODES], t;
};

static double drive(const struct modes *m, int n) {
  const double k = n * M_PI / m->L, part = 2 * m->L / (n * M_PI * n * M_PI);
  if (m->roll)
    return n % 2 ? 2 * part * k * tanh(k * m->h) * (2 / k * tanh(k * m->h / 2) + m->about - m->h)
                 : 0;
  return k * tanh(k * m->h) * (m->piston ? part : n % 2 ? 2 * part : 0);
}

/* What the displacement itself drives. */
static double pull(const struct modes *m, int n) {
  const double k = n * M_PI / m->L;
  return m->roll && n % 2 ? 4 * m->L / (n * M_PI * n * M_PI) * k * tanh(k * m->h) : 0;
}

static void modes_step(struct modes *m, double dt) {
  double q[3], a[3];
  for (int i = 0; i < 3; i++) {
    q[i] = motion(m->t + 0.5 * i * dt, m->amplitude, m->period, 0);
    a[i] = motion(m->t + 0.5 * i * dt, m->amplitude, m->period, 2);
  }
  for (int n = 1; n < MODES; n++) {
    const double k = n * M_PI / m->L, w2 = k * tanh(k * m->h);
    const double f[3] = {drive(m, n) * a[0] + pull(m, n) * q[0],
                         drive(m, n) * a[1] + pull(m, n) * q[1],
                         drive(m, n) * a[2] + pull(m, n) * q[2]};
    const double e = m->eta[n], r = m->rate[n];
    const double k1 = f[0] - w2 * e, r2 = r + dt / 2 * k1;
    const double k2 = f[1] - w2 * (e + dt / 2 * r), r3 = r + dt / 2 * k2;
    const double k3 = f[1] - w2 * (e + dt / 2 * r2), r4 = r + dt * k3;
    const double k4 = f[2] - w2 * (e + dt * r3);
    m->eta[n] += dt / 6 * (r + 2 * r2 + 2 * r3 + r4);
    m->rate[n] += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  m->t += dt;
}

static void modes_to(struct modes *m, double t) {
  const double dt = (t - m->t) / 20;
  for (int i = 0; i < 20; i++) modes_step(m, dt);
}

static double modes_at(const struct modes *m, double x) {
  double sum = m->piston ? m->h / m->L * motion(m->t, m->amplitude, m->period, 0) : 0;
  for (int n = 1; n < MODES; n++) sum += m->eta[n] * cos(n * M_PI * x / m->L);
  return sum;
}

static const char text[] =
    "title: moving tank\n"
    "fluid: {density: 1, gravity: 1}\n"
    "scales: {H: 1}\n"
    "tank:\n"
    "  walls: [[[0, 2], [0, 0], [%g, 0], [%g, 2]]]\n"
    "  motions: [{kind: %s, amplitude: %g, period: %g}]\n"
    "water: {wave: {kind: still, depth: %g}}\n"
    "time: {end: %g, every: %g, sample: %g}\n"
    "gauges: [{name: wire, x: %g}]\n"
    "runs: [{name: bem, solver: bem, resolution: %g, tolerance: %g, forces: true}]\n";

/* Largest distance from theory over the largest elevation; *budget: largest change of the budget of
 * energy over the largest gain. */
static double against_theory(const char *kind, struct modes *m, double end, double nodes, double x,
                             double *most, double *budget) {
  char with[sizeof text + 300];
  const double sample = m->period / 20;
  snprintf(with, sizeof with, text, m->L, m->L, kind, m->amplitude, m->period, m->h, end, end,
           sample, x, nodes, fmax(1e-12, 1e-6 * m->amplitude));
  struct result_file *f = run_bem(with);
  double worst = 0, gain = 0, change = 0;
  *most = 0;
  if (!f) return NAN;
  const struct result_series *g = &f->gauges[0];
  for (size_t i = 0; i < g->n; i++) {
    modes_to(m, g->t[i]);
    worst = fmax(worst, fabs(g->value[i] - m->h - modes_at(m, x)));
    *most = fmax(*most, fabs(modes_at(m, x)));
    const struct result_energy *e = &f->energy[i], *first = f->energy;
    gain = fmax(gain, fabs(e->total - first->total));
    change = fmax(change, fabs(result_energy_budget(e) - result_energy_budget(first)));
  }
  *budget = change / gain;
  result_file_destroy(f);
  return worst / *most;
}

/* Ten cycles at the lowest frequency: the wave grows all the time. */
static void test_a_tank_that_sways_in_resonance_follows_linear_theory_for_ten_cycles(void) {
  struct modes m = {.L = 1.3, .h = 0.6, .amplitude = 2e-6};
  const double k = M_PI / m.L, omega = sqrt(k * tanh(k * m.h));
  double most, budget;
  m.period = 2 * M_PI / omega;
  const double worst = against_theory("sway", &m, 10 * m.period, 24, 0, &most, &budget);
  printf("  amplitude %.1f of the sway's; off by %.1e of it; energy %.1e of what was given\n",
         most / m.amplitude, worst, budget);
  EXPECT(most > 25 * m.amplitude);
  EXPECT(worst < 2e-3);
  EXPECT(budget < 1e-3);
}

/* Anticlockwise, the right side rises: the water there falls in the tank. */
static void test_a_tank_that_rolls_in_resonance_follows_linear_theory_for_ten_cycles(void) {
  struct modes m = {.L = 1.3, .h = 0.6, .amplitude = 2e-6, .roll = true, .about = 0.25};
  const double k = M_PI / m.L, omega = sqrt(k * tanh(k * m.h));
  double most, budget;
  m.period = 2 * M_PI / omega;
  const double worst =
      against_theory("roll, about: [0.65, 0.25]", &m, 10 * m.period, 24, 0, &most, &budget);
  printf("  amplitude %.1f of the roll's; off by %.1e of it; energy %.1e of what was given\n",
         most / m.amplitude, worst, budget);
  EXPECT(most > 10 * m.amplitude);
  EXPECT(worst < 2e-3);
  EXPECT(budget < 1e-3);
}

static void test_a_piston_in_a_closed_tank_follows_linear_theory(void) {
  double worst[2];
  for (int i = 0; i < 2; i++) {
    struct modes m = {.L = 3, .h = 1, .amplitude = 1e-5, .period = 4, .piston = true};
    double most, budget;
    worst[i] = against_theory("piston, side: left", &m, 16, i ? 24 : 12, 3, &most, &budget);
    printf("  amplitude %.2f of the piston's; off by %.1e of it; energy %.1e of what was given\n",
           most / m.amplitude, worst[i], budget);
    EXPECT(budget < 2e-3);
  }
  EXPECT(worst[1] < 2e-4 && worst[1] < 0.1 * worst[0]); /* of fourth order */
}

/* The piston on the right makes the mirror image. */
static void test_a_piston_on_the_right_makes_the_mirror_image(void) {
  struct modes m = {.L = 3, .h = 1, .amplitude = -1e-5, .period = 4, .piston = true}, seen = m;
  double most, budget;
  seen.amplitude = 1e-5;
  char with[sizeof text + 300];
  snprintf(with, sizeof with, text, m.L, m.L, "piston, side: right", m.amplitude, m.period, m.h,
           16., 16., 0.2, 0., 12., 1e-11);
  struct result_file *f = run_bem(with);
  if (!f) return;
  most = budget = 0;
  for (size_t i = 0; i < f->gauges[0].n; i++) {
    modes_to(&seen, f->gauges[0].t[i]);
    most = fmax(most, fabs(modes_at(&seen, 3)));
    budget = fmax(budget, fabs(f->gauges[0].value[i] - m.h - modes_at(&seen, 3)));
  }
  EXPECT(budget < 5e-3 * most);
  result_file_destroy(f);
}

static const double *column(const struct result_file *f, const char *name) {
  for (size_t i = 0; i < f->n_diagnostics; i++)
    if (!strcmp(f->diagnostics[i].name, name)) return f->diagnostics[i].value;
  return NULL;
}

/* Rate of change of momentum = weight + the tank's force - force on the walls, with differences of
 * fourth order; at t = 0 hydrostatics. Waves are steep: 0.2 of the depth from crest to trough. */
static void momentum(const char *kind, double amplitude, bool sways, bool heaves) {
  char with[sizeof text + 300];
  const double L = 2, h = 0.8, period = 3.3, sample = 0.02;
  snprintf(with, sizeof with, text, L, L, kind, amplitude, period, h, 6., 6., sample, 0., 32.,
           1e-9);
  struct result_file *f = run_bem(with);
  if (!f) return;
  const double *fx = column(f, "force_x"), *fy = column(f, "force_y"),
               *mx = column(f, "momentum_x"), *my = column(f, "momentum_y"),
               *moment = column(f, "moment"), *left = column(f, "force_left");
  EXPECT(fx && fy && mx && my && moment && left);
  if (!fx || !fy || !mx || !my || !moment || !left) return;
  EXPECT_NEAR(left[0], -0.5 * h * h, 1e-7);
  EXPECT_NEAR(fx[0], 0, 1e-7);
  EXPECT_NEAR(fy[0], -L * h, 1e-7);
  EXPECT_NEAR(moment[0], 0, 1e-7);
  double worst[2] = {0}, most[2] = {0};
  const double *t = f->diagnostics[0].t;
  for (size_t i = 2; i + 2 < f->diagnostics[0].n; i++) {
    const double a = motion(t[i], amplitude, period, 2), volume = f->steps[i].volume;
    const double px = (mx[i - 2] - 8 * mx[i - 1] + 8 * mx[i + 1] - mx[i + 2]) / (12 * sample);
    const double py = (my[i - 2] - 8 * my[i - 1] + 8 * my[i + 1] - my[i + 2]) / (12 * sample);
    worst[0] = fmax(worst[0], fabs(px + fx[i] + (sways ? a * volume : 0)));
    worst[1] = fmax(worst[1], fabs(py + fy[i] + volume * (1 + (heaves ? a : 0))));
    most[0] = fmax(most[0], fabs(fx[i]));
    most[1] = fmax(most[1], fabs(fy[i] + L * h));
  }
  printf("  %s: forces up to %.3g and %.3g from rest; off by %.1e and %.1e\n", kind, most[0],
         most[1], worst[0], worst[1]);
  EXPECT(worst[0] < 5e-5 && worst[1] < 5e-5); /* of a thousandth of the forces */
  EXPECT(most[0] > 0.01 || heaves);
  result_file_destroy(f);
}

static void test_forces_on_the_walls_change_the_momentum(void) {
  momentum("sway", 0.04, true, false);
  momentum("heave", 0.1, false, true);
  momentum("piston, side: left", 0.05, false, false);
  momentum("piston, side: right", 0.05, false, false);
}

/* Kinetic energy just after water at rest in a tank is hit by a sway whose velocity is 0.5 at once,
 * which a roll has turned by `angle` by then. */
static double kinetic_at_once(double angle) {
  char with[600];
  snprintf(with, sizeof with,
           "title: moved at once\n"
           "fluid: {density: 1, gravity: 1}\n"
           "scales: {H: 1}\n"
           "tank:\n"
           "  walls: [[[0, 2], [0, 0], [2, 0], [2, 2]]]\n"
           "  motions:\n"
           "    - {kind: sway, amplitude: 0.5, period: %.17g, ramp: 0}\n"
           "    - {kind: roll, amplitude: %g, period: 100, phase: %.17g, ramp: 0}\n"
           "water: {wave: {kind: still, depth: 0.8}}\n"
           "time: {end: 0.01, every: 0.01, sample: 0.01}\n"
           "runs: [{name: bem, solver: bem, resolution: 16}]\n",
           2 * M_PI, angle, M_PI_2);
  struct result_file *f = run_bem(with);
  if (!f) return NAN;
  const double kinetic = f->energy[0].kinetic;
  result_file_destroy(f);
  return kinetic;
}

/* Along the tank's width goes the cosine of what it does: the level surface stays level in what
 * remains, and the water goes with it. */
static void test_a_tank_that_is_turned_hits_its_water_along_its_own_axes(void) {
  const double level = kinetic_at_once(0), angle = 0.3, turned = kinetic_at_once(angle);
  printf("  kinetic energy %.6f, turned %.6f of it\n", level, turned / level);
  EXPECT(level > 0.01);
  EXPECT_NEAR(turned, level * cos(angle) * cos(angle), 1e-9);
}

/* The corner is at [0, y], and the sensors on the side above it, where the pressure is a polynomial
 * of the height but for its square times a logarithm: 1e-8 here. */
static void check_corner(const char *walls, const char *motion_of_it, double y) {
  char with[900];
  const double way = 1e-3;
  snprintf(with, sizeof with,
           "title: corner\n"
           "fluid: {density: 1, gravity: 1}\n"
           "scales: {H: 1}\n"
           "tank: {walls: [%s], motions: [{%s, ramp: 3}]}\n"
           "water: {wave: {kind: still, depth: 1}}\n"
           "time: {end: 0.6, every: 0.6, sample: 0.3}\n"
           "probes: [{name: at, at: [0, %g]}, {name: near, at: [0, %g]}, "
           "{name: far, at: [0, %g]}]\n"
           "runs: [{name: bem, solver: bem, resolution: 8}]\n",
           walls, motion_of_it, y, y + way, y + 2 * way);
  struct result_file *f = run_bem(with);
  if (!f) return;
  const double *at = f->probes[0].value, *near = f->probes[1].value, *far = f->probes[2].value;
  const size_t last = f->probes[0].n - 1;
  double worst = 0;
  EXPECT(f->probes[0].n == 3);
  EXPECT(fabs(at[last] - at[0]) > 5e-3);
  for (size_t i = 0; i <= last; i++) {
    const double off = fabs(at[i] - (2 * near[i] - far[i]));
    worst = off <= worst ? worst : off;
  }
  printf("  %s: %.4f to %.4f, off by %.1e\n", motion_of_it, at[0], at[last], worst);
  EXPECT(worst < 1e-5);
  result_file_destroy(f);
}

static void test_pressure_in_a_corner_that_moves_is_that_of_the_side_beside_it(void) {
  const char *rectangle = "[[0, 2], [0, 0], [4, 0], [4, 2]]",
             *mapped = "[[0, 2], [0, 0], [2, 0], [4, 0.2], [4, 2]]";
  check_corner(rectangle, "kind: roll, amplitude: 0.05, period: 9.4", 0);
  check_corner(mapped, "kind: piston, side: left, amplitude: 0.1, period: 9.4", 0);
  check_corner(mapped, "kind: flap, side: left, amplitude: 0.1, hinge: 0, period: 9.4", 0);
}

/* So much further than the film on a wall is thick. */
static void test_a_piston_that_pulls_back_leaves_the_water_whole(void) {
  struct result_file *f =
      run_bem("title: pull\n"
              "fluid: {density: 1, gravity: 1}\n"
              "scales: {H: 1}\n"
              "tank:\n"
              "  walls: [[[0, 2], [0, 0], [4, 0], [4, 2]]]\n"
              "  motions: [{kind: piston, side: left, amplitude: -0.25, period: 24, ramp: 0}]\n"
              "water: {wave: {kind: still, depth: 0.5}}\n"
              "time: {end: 7, every: 7, sample: 0.5}\n"
              "runs: [{name: bem, solver: bem, resolution: 16}]\n");
  if (!f) return;
  const struct result_step *last = f->steps + f->n_steps - 1;
  printf("  volume %.6f to %.6f, removed %g\n", f->steps->volume, last->volume,
         last->removed_volume);
  for (size_t i = 0; i < f->n_events; i++) EXPECT(strcmp(f->events[i].name, "cut"));
  EXPECT(last->removed_volume == 0);
  EXPECT_NEAR(last->volume, 2, 1e-4);
  result_file_destroy(f);
}

int main(void) {
  RUN(test_a_tank_that_sways_in_resonance_follows_linear_theory_for_ten_cycles);
  RUN(test_a_tank_that_rolls_in_resonance_follows_linear_theory_for_ten_cycles);
  RUN(test_a_tank_that_is_turned_hits_its_water_along_its_own_axes);
  RUN(test_a_piston_in_a_closed_tank_follows_linear_theory);
  RUN(test_a_piston_on_the_right_makes_the_mirror_image);
  RUN(test_pressure_in_a_corner_that_moves_is_that_of_the_side_beside_it);
  RUN(test_a_piston_that_pulls_back_leaves_the_water_whole);
  RUN(test_forces_on_the_walls_change_the_momentum);
  return TEST_RESULT;
}

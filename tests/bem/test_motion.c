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

/* ---- roll and sides together ---- */

/* What a case says of its tank, and the area's centre at rest. */
struct tank_case {
  const char *name, *walls, *sides;
  double middle[2];
};

static const double ROLL = 0.05, PERIOD = 3.3, PIVOT[2] = {1, 0.3};

/* Integral of r dA, whose rate of change the momentum is, from one row to the next, by the cubic
 * through four of them. */
static void add_way(const double *p, size_t i, size_t n, double dt, double *way) {
  const size_t first = i == 0 ? 0 : i + 2 < n ? i - 1 : n - 4;
  static const double begin[4] = {9, 19, -5, 1}, middle[4] = {-1, 13, 13, -1};
  const double *weight = i == 0 || first + 4 == i + 2 ? begin : middle;
  for (size_t k = 0; k < 4; k++)
    *way += dt / 24 * weight[first + 4 == i + 2 ? 3 - k : k] * p[first + k];
}

/* Largest difference between the momentum's rate of change and the forces: those of the walls, and
 * weight, rotation and Coriolis's force in the frame of a tank that rolls. */
static void off_balance(const struct result_file *f, const double middle[2], double worst[2]) {
  const double *p[2] = {column(f, "momentum_x"), column(f, "momentum_y")},
               *force[2] = {column(f, "force_x"), column(f, "force_y")}, *t = f->diagnostics[0].t;
  const size_t n = f->diagnostics[0].n;
  const double dt = t[1] - t[0], first = f->steps[0].volume;
  double moment[2] = {first * middle[0], first * middle[1]};
  worst[0] = worst[1] = 0;
  for (size_t i = 0; i + 2 < n; i++) {
    const double angle = motion(t[i], ROLL, PERIOD, 0), rate = motion(t[i], ROLL, PERIOD, 1),
                 turning = motion(t[i], ROLL, PERIOD, 2), volume = f->steps[i].volume;
    const double x = moment[0] - PIVOT[0] * volume, y = moment[1] - PIVOT[1] * volume;
    const double felt[2] = {
        -sin(angle) * volume + turning * y + rate * rate * x + 2 * rate * p[1][i],
        -cos(angle) * volume - turning * x + rate * rate * y - 2 * rate * p[0][i]};
    for (int axis = 0; axis < 2; axis++) {
      const double *m = p[axis] + i;
      if (i >= 2)
        worst[axis] = fmax(worst[axis], fabs((m[-2] - 8 * m[-1] + 8 * m[1] - m[2]) / (12 * dt) +
                                             force[axis][i] - felt[axis]));
      add_way(p[axis], i, n, dt, &moment[axis]);
    }
  }
}

/* Largest change of the budget of energy. */
static double off_budget(const struct result_file *f) {
  double worst = 0;
  for (size_t i = 0; i < f->n_energy; i++)
    worst =
        fmax(worst, fabs(result_energy_budget(&f->energy[i]) - result_energy_budget(f->energy)));
  return worst;
}

/* In a tank that rolls, waves of a tenth of the depth. The bounds are a thousandth of the forces on
 * the walls, which are 0.1 to 0.5, and of the energy that is given, 0.01. */
static void test_forces_change_the_momentum_where_sides_move_in_a_tank_that_rolls(void) {
  static const struct tank_case tanks[] = {
      {"piston",
       "[0, 2], [0, 0], [2, 0], [2, 2]",
       ", {kind: piston, side: left, amplitude: 0.05, period: 3.3}",
       {1, 0.4}},
      {"both, before a step",
       "[0, 2], [0, 0], [1, 0], [1.3, 0.3], [2, 0.3], [2, 2]",
       ", {kind: piston, side: left, amplitude: 0.05, period: 3.3}"
       ", {kind: flap, side: left, amplitude: 0.05, period: 3.3, hinge: 0.3}",
       {0.8918215613382898, 0.4490706319702602}},
  };
  for (size_t i = 0; i < sizeof tanks / sizeof *tanks; i++) {
    char with[1000];
    double worst[2];
    snprintf(with, sizeof with,
             "title: roll\n"
             "fluid: {density: 1, gravity: 1}\n"
             "scales: {H: 1}\n"
             "tank: {walls: [[%s]], motions: [{kind: roll, amplitude: %g, period: %g, about: [%g, "
             "%g]}%s]}\n"
             "water: {wave: {kind: still, depth: 0.8}}\n"
             "time: {end: 2, every: 2, sample: 0.05}\n"
             "runs: [{name: bem, solver: bem, resolution: 12, tolerance: 1e-8, forces: true}]\n",
             tanks[i].walls, ROLL, PERIOD, PIVOT[0], PIVOT[1], tanks[i].sides);
    struct result_file *f = run_bem(with);
    if (!f) continue;
    off_balance(f, tanks[i].middle, worst);
    const double budget = off_budget(f);
    printf("  %s: forces off by %.1e and %.1e, budget by %.1e\n", tanks[i].name, worst[0], worst[1],
           budget);
    EXPECT(worst[0] < 1e-4 && worst[1] < 1e-4 && budget < 1e-4);
    result_file_destroy(f);
  }
}

/* Both sides of a column's tank move like the tank of another: where the water comes to the other
 * side is the same place of it, at the same time. */
static double impact_of(const char *motions) {
  char with[600];
  snprintf(with, sizeof with,
           "title: column\n"
           "fluid: {density: 1, gravity: 1}\n"
           "scales: {H: 1}\n"
           "tank: {walls: [[[0, 3], [0, 0], [3, 0], [3, 3]]], motions: [%s]}\n"
           "water: {regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]], pressure: released}\n"
           "time: {end: 1.68, every: 1.68, sample: 0.1}\n"
           "runs: [{name: bem, solver: bem, resolution: 16}]\n",
           motions);
  struct result_file *f = run_bem(with);
  if (!f) return NAN;
  const double time = run_event(f, "wall_impact").time;
  result_file_destroy(f);
  return time;
}

static void test_a_column_beside_pistons_runs_as_in_a_tank_that_sways(void) {
  const double sway = impact_of("{kind: sway, amplitude: 0.1, period: 4}"),
               pistons = impact_of("{kind: piston, side: left, amplitude: 0.1, period: 4}, "
                                   "{kind: piston, side: right, amplitude: 0.1, period: 4}");
  printf("  impact at %.6f, %.6f\n", sway, pistons);
  EXPECT_NEAR(pistons, sway, 1e-5); /* ten tolerances */
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
  RUN(test_forces_change_the_momentum_where_sides_move_in_a_tank_that_rolls);
  RUN(test_a_column_beside_pistons_runs_as_in_a_tank_that_sways);
  return TEST_RESULT;
}

/* Every initial state of the lists is what its struct says. */
#include "common/flow/flow.h"

#include <stdlib.h>

#include "common/case/case.h"
#include "common/flow/waves.h"
#include "tests/common/case_registry.h"
#include "tests/test.h"

/* The case of a flow's example; NULL, with a failure, when it is refused. */
static struct case_file *example(const struct flow *f) {
  struct problems problems = {0};
  struct case_file *c = NULL;
  char text[2000];
  snprintf(text, sizeof text,
           "%stank: {walls: [[[0, 2], [0, 0], [4, 0], [4, 2]]], sides: %s}\nwater: {%s}\n"
           "time: {end: 1}\nruns: [{solver: sph, resolution: 20}]\n",
           flow_is_body(f) ? "fluid: {gravity: 0}\nscales: {g: 1}\n" : "",
           f->round ? "periodic" : "walls", f->example);
  if (case_parse("example", text, &fake_registry, &problems, &c) != OK)
    TEST_FAIL("%s: %s", flow_name(f), problems.n ? problems.text[0] : status_message());
  problems_destroy(&problems);
  return c;
}

static void for_each(const struct flow_list *list, void (*test)(const struct case_file *c)) {
  for (size_t i = 0; i < list->n; i++) {
    struct case_file *c = example(list->flow[i]);
    if (c) test(c);
    case_destroy(c);
  }
}

static void expect_listed(const struct case_file *c) {
  const struct flow_list *list = flow_is_wave(c->flow)   ? &flow_waves
                                 : flow_is_body(c->flow) ? &flow_bodies
                                                         : &flow_regions;
  EXPECT(list->flow[flow_place(c->flow)] == c->flow);
  if (!strstr(c->text, flow_name(c->flow)) && (flow_place(c->flow) > 0 || c->flow->scale))
    TEST_FAIL("the example of %s does not name it", flow_name(c->flow));
}

static void test_example_of_a_flow_is_that_flow(void) {
  for_each(&flow_regions, expect_listed);
  for_each(&flow_waves, expect_listed);
  for_each(&flow_bodies, expect_listed);
}

static struct flow_water opened(const struct case_file *c, int order) {
  struct flow_water w;
  EXPECT_OK(flow_open(c, (struct flow_use){.order = order, .spacing = 0.05, .sound = 10}, &w));
  return w;
}

/* The outline is a trapezoidal rule with 256 points a length: it misses at most (length/256)^2/12
 * of the largest curvature by width, and a wave is no more curved than twice a cosine. */
static void expect_scale(const struct case_file *c) {
  const struct flow_scale s = c->flow->scale(c);
  struct flow_water w = opened(c, 0);
  double width = c->tank.max[0] - c->tank.min[0], crest = -INFINITY;
  for (int i = 0; i <= 4000; i++) {
    double x = c->tank.min[0] + width * i / 4000;
    crest = fmax(crest, flow_elevation(&w, x, 0) - c->tank.min[1] - s.depth);
  }
  double curvature = 2 * s.amplitude * pow(2 * M_PI / s.length, 2);
  EXPECT_NEAR(crest, s.amplitude, curvature * pow(width / 8000, 2) / 2 + 1e-14);
  EXPECT_NEAR(geo_piece_area(&c->water, 0), case_water_area(c),
              curvature * width * pow(s.length / 256, 2) / 12 + 1e-13);
  flow_close(&w);
}

static void test_scales_of_a_wave_are_those_of_its_elevation(void) {
  for_each(&flow_waves, expect_scale);
}

/* By central differences over h: their error is h^2/6 of a third derivative, here at most twice
 * (2 pi/length)^2 of the velocity; and rounding over h. Later, too, where theory goes on. */
static void expect_gradient(const struct case_file *c) {
  const struct flow_scale s = c->flow->scale(c);
  const double h = 1e-4 * s.length, allowed = 1e-7 * sqrt(c->gravity * s.depth);
  struct flow_water w = opened(c, 2);
  double left = c->tank.min[0], right = c->tank.max[0], bed = c->tank.min[1];
  for (double t = 0; t <= (flow_has_theory(c->flow) ? 0.3 : 0); t += 0.3)
    for (double x = left + 2 * h; x < right; x += 0.0731 * (right - left))
      for (double part = 0.05; part < 1; part += 0.19) {
        double y = bed + part * (flow_elevation(&w, x, t) - bed), u[2];
        flow_velocity(&w, x, y, t, u);
        double east = flow_potential(&w, x + h, y, t), west = flow_potential(&w, x - h, y, t);
        double up = flow_potential(&w, x, y + h, t), down = flow_potential(&w, x, y - h, t);
        EXPECT_NEAR((east - west) / (2 * h), u[0], allowed);
        EXPECT_NEAR((up - down) / (2 * h), u[1], allowed);
      }
  flow_close(&w);
}

static void test_velocity_of_a_wave_is_the_gradient_of_its_potential(void) {
  for_each(&flow_waves, expect_gradient);
}

/* Head at parts of 1/8 of the way from the bottom to the top of a vertical span of water. */
static void expect_heads(const struct flow_water *w, double x, const double span[2]) {
  const struct case_file *c = w->c;
  const bool wave = flow_is_wave(c->flow);
  const struct flow_scale s = wave ? c->flow->scale(c) : (struct flow_scale){0};
  double top = wave ? flow_elevation(w, x, 0) : span[1];
  for (int i = 0; i <= 8; i++) {
    double y = i < 8 ? span[0] + (top - span[0]) * i / 8 : top, head = NAN;
    double rest = wave ? span[0] + s.depth * i / 8 : y;
    EXPECT_OK(flow_head(w, &(struct flow_point){x, y, rest}, &head));
    EXPECT(head >= -1e-15 * top && head <= (top - y + s.amplitude) * (1 + 1e-12));
    if (wave && i == 8) EXPECT_NEAR(head, 0, 1e-15 * top);
  }
}

/* No suction, none on the surface of a wave, and no more than the weight of what stands above, or
 * under a wave of what its highest crest has more. */
static void expect_pressure(const struct case_file *c) {
  struct flow_water w = opened(c, 0);
  struct geo_cut cut = {0};
  if (c->flow->sounds) { /* sucks and pushes */
    flow_close(&w);
    return;
  }
  for (double x = 0.013; x < 4; x += 0.0917) {
    EXPECT_OK(geo_lines_cut(&c->water, 0, x, case_near(c), &cut));
    for (size_t k = 0; k < cut.n; k++) expect_heads(&w, x, cut.span[k]);
  }
  geo_cut_destroy(&cut);
  flow_close(&w);
}

static void test_pressure_ends_at_the_surface(void) {
  for_each(&flow_regions, expect_pressure);
  for_each(&flow_waves, expect_pressure);
}

/* A particle that the wave moves has the velocity that the wave has where it rests; its density,
 * that at rest less what its neighbours move apart, to second order in ways over lengths. */
static void expect_particles(const struct case_file *c) {
  if (!c->flow->start) return;
  struct flow_water w = opened(c, 0);
  const double c0 = w.use.sound, e = 1e-4, g = c->gravity;
  const double bed = c->tank.min[1], depth = c->flow->scale(c).depth;
  for (double X = 0.1; X < 4; X += 0.391)
    for (double Y = bed + 0.03; Y < bed + depth - 0.03; Y += 0.117) {
      struct flow_start p, east, west, up, down;
      double u[2];
      c->flow->start(&w, X, Y, &p);
      c->flow->start(&w, X + e, Y, &east);
      c->flow->start(&w, X - e, Y, &west);
      c->flow->start(&w, X, Y + e, &up);
      c->flow->start(&w, X, Y - e, &down);
      flow_velocity(&w, X, Y, 0, u);
      EXPECT_NEAR(p.u, u[0], 1e-13);
      EXPECT_NEAR(p.v, u[1], 1e-13);
      EXPECT_NEAR(1 + g * p.rest / (c0 * c0), exp(g * (bed + depth - Y) / (c0 * c0)), 1e-13);
      const double apart = (east.x - west.x + up.y - down.y) / (2 * e) - 2;
      const double lighter = (p.rest - p.head) * g / (c0 * c0) / (1 + g * p.rest / (c0 * c0));
      const double way = hypot(p.x - X, p.y - Y);
      if (way > 0) EXPECT_NEAR(lighter, apart, 20 * (way * way + way * g / (c0 * c0)) + 1e-9);
    }
  flow_close(&w);
}

static void test_particles_start_where_the_wave_has_moved_them(void) {
  for_each(&flow_waves, expect_particles);
}

/* What solvers start from is what theory of any order has at t = 0: rounding. */
static void expect_start(const struct flow_water *w) {
  const struct case_file *c = w->c;
  struct flow_water start = opened(c, 0);
  const double speed = sqrt(c->gravity * c->H);
  for (double x = 0.01; x < 4; x += 0.0791) {
    double y = flow_elevation(&start, x, 0), u[2], v[2];
    EXPECT_NEAR(flow_elevation(w, x, 0), y, 1e-14 * c->H);
    c->flow->velocity(w, x, y, 0, u);
    flow_velocity(&start, x, y, 0, v);
    for (int d = 0; d < 2; d++) EXPECT_NEAR(u[d], v[d], 1e-13 * speed);
    EXPECT(c->flow->pressure(w, x, y + 0.01 * c->H, 0) == 0);
  }
  flow_close(&start);
}

static double energy_of(const struct flow_water *w, double t) {
  return w->c->flow->kinetic(w, t) + w->c->flow->potential_energy(w, t);
}

static void expect_theory(const struct case_file *c) {
  if (!flow_has_theory(c->flow)) return;
  for (int order = 1; order <= 2; order++) {
    struct flow_water w = opened(c, order);
    expect_start(&w);
    double error = c->flow->error(&w, c->end), first = energy_of(&w, 0);
    double wave = first - case_rest_potential(c) / c->density;
    EXPECT(error > 0 && error < 0.5 && wave > 0);
    EXPECT_NEAR(energy_of(&w, c->end), first, error * wave);
    flow_close(&w);
  }
}

static void test_theory_starts_from_the_flow_and_knows_its_error(void) {
  for_each(&flow_waves, expect_theory);
}

/* ---- over beds that are not flat ---- */

static struct case_file *parsed_in(const char *walls, const char *sides, const char *water) {
  struct problems problems = {0};
  struct case_file *c = NULL;
  char text[1000];
  snprintf(text, sizeof text,
           "tank: {walls: [%s], sides: %s}\nwater: {%s}\ntime: {end: 1}\nruns: [{solver: sph, "
           "resolution: "
           "20}]\n",
           walls, sides, water);
  if (case_parse("parsed", text, &fake_registry, &problems, &c) != OK)
    TEST_FAIL("%s", problems.n ? problems.text[0] : status_message());
  problems_destroy(&problems);
  return c;
}

static struct case_file *parsed(const char *walls, const char *water) {
  return parsed_in(walls, "walls", water);
}

/* Over a shelf between a trench and a beach the wave is that of a flat tank of the shelf's level,
 * and its water ends at the beach; in the trench it has no more than on the shelf's bed. */
static void test_solitary_wave_starts_over_a_flat_piece_of_bed(void) {
  const char *water = "wave: {kind: solitary, amplitude: 0.4, depth: 1, x: 16}";
  struct case_file *shelf =
      parsed("[[0, 4], [0, 0], [5, 0], [6, 0.5], [12, 0.5], [26, 0.5], [46, 2.5]]", water);
  struct case_file *flat = parsed("[[0, 4], [0, 0.5], [40, 0.5], [40, 4]]", water);
  if (!shelf || !flat) return;
  struct flow_water a = opened(shelf, 0), b = opened(flat, 0);
  for (double x = 1; x < 36; x += 0.913)
    for (double y = 0.5; y < 2; y += 0.31) {
      double u[2], v[2], p, q;
      const struct flow_point at = {x, y, y};
      EXPECT_NEAR(flow_elevation(&a, x, 0), flow_elevation(&b, x, 0), 1e-14);
      EXPECT_NEAR(flow_potential(&a, x, y, 0), flow_potential(&b, x, y, 0), 1e-13);
      flow_velocity(&a, x, y, 0, u);
      flow_velocity(&b, x, y, 0, v);
      for (int k = 0; k < 2; k++) EXPECT_NEAR(u[k], v[k], 1e-13);
      EXPECT_OK(flow_head(&a, &at, &p));
      EXPECT_OK(flow_head(&b, &at, &q));
      EXPECT_NEAR(p, q, 1e-13);
    }
  double deep[2], bed[2];
  flow_velocity(&a, 3, 0.1, 0, deep);
  flow_velocity(&a, 3, 0.5, 0, bed);
  EXPECT_NEAR(deep[0], bed[0], 0);
  EXPECT_NEAR(geo_lines_box(&shelf->water).max[0], 36, 1e-6);
  flow_close(&a);
  flow_close(&b);
  case_destroy(shelf);
  case_destroy(flat);
}

/* ---- what single waves promise ---- */

static const char *const four_by_two = "[[0, 2], [0, 0], [4, 0], [4, 2]]";

/* Rankine-Hugoniot's jump of shallow water: mass and momentum in the frame of the bore; at rest
 * ahead, and no flux through the bed. */
static void test_bore_has_the_velocity_of_a_hydraulic_jump(void) {
  struct case_file *c = parsed(four_by_two, "wave: {kind: bore, height: 0.1, depth: 0.2, width: "
                                            "0.46, x: 2}");
  if (!c) return;
  struct flow_water w = opened(c, 0);
  const double h0 = 0.2, h1 = 0.3, g = c->gravity, speed = sqrt(g * h1 * (h0 + h1) / (2 * h0));
  double behind[2], ahead[2], bed[2];
  flow_velocity(&w, -20, 0.1, 0, behind);
  flow_velocity(&w, 20, 0.1, 0, ahead);
  flow_velocity(&w, 2.1, 0, 0, bed);
  EXPECT_NEAR((speed - behind[0]) * h1, speed * h0, 1e-13);
  EXPECT_NEAR(h1 * pow(speed - behind[0], 2) + g * h1 * h1 / 2,
              h0 * speed * speed + g * h0 * h0 / 2, 1e-13);
  EXPECT_NEAR(ahead[0], 0, 1e-13);
  EXPECT_NEAR(bed[1], 0, 1e-15);
  EXPECT(bed[0] > 0.1 * behind[0]);
  flow_close(&w);
  case_destroy(c);
}

/* Of a low hump, by linear theory: p/(rho g) + y - h on the bed below it is its Fourier integral
 * over cosh kh; what is left is of the order of the height. */
static void test_hump_starts_with_the_pressure_of_water_let_go(void) {
  struct case_file *c = parsed("[[0, 2], [0, 0], [12, 0], [12, 2]]",
                               "wave: {kind: hump, height: 1e-4, width: 0.6, depth: 0.5, x: 6}");
  if (!c) return;
  struct flow_water w = opened(c, 0);
  double sum = 0, head;
  for (double k = 0.005; k < 30; k += 0.01)
    sum += 0.01 * exp(-pow(0.6 * k, 2) / 4) / cosh(0.5 * k) * 0.6 / sqrt(M_PI);
  EXPECT_OK(flow_head(&w, &(struct flow_point){6, 0, 0}, &head));
  EXPECT_NEAR((head - 0.5) / 1e-4, sum, 1e-3 * sum);
  flow_close(&w);
  case_destroy(c);
}

/* A standing wave of second order is at rest at t = 0 and, as theory has it, after each period;
 * one that starts as a cosine is not. */
static void test_standing_wave_of_second_order_repeats_itself(void) {
  for (int order = 1; order <= 2; order++) {
    char water[100];
    snprintf(water, sizeof water,
             "wave: {kind: standing, amplitude: 0.1, wavelength: 4, depth: 0.6, order: %d}", order);
    struct case_file *c = parsed(four_by_two, water);
    if (!c) return;
    struct flow_water w = opened(c, 2);
    const double k = M_PI / 2;
    const double omega = wave_frequency_linear(k, 0.6, c->gravity) *
                         (1 + pow(0.1 * k, 2) * wave_frequency_shift(k, 0.6));
    double worst = 0, moves = 0;
    for (double x = 0.1; x < 4; x += 0.3) {
      double u[2];
      worst = fmax(worst, fabs(flow_elevation(&w, x, 2 * M_PI / omega) - flow_elevation(&w, x, 0)));
      c->flow->velocity(&w, x, 0.3, 0, u);
      moves = fmax(moves, hypot(u[0], u[1]));
    }
    EXPECT_NEAR(moves, 0, 1e-15);
    EXPECT(order == 2 ? worst < 1e-14 : worst > 1e-3);
    EXPECT_NEAR(flow_elevation(&w, 0, 0) - 0.6, c->flow->scale(c).amplitude, 1e-15);
    flow_close(&w);
    case_destroy(c);
  }
}

/* Stokes' wave is the exact one but for the third order of its steepness. */
static void test_stokes_wave_is_the_steady_one_to_second_order(void) {
  double off[2];
  for (int i = 0; i < 2; i++) {
    const double height = i ? 0.04 : 0.08;
    char water[2][100];
    snprintf(water[0], sizeof *water,
             "wave: {kind: stokes, amplitude: %g, wavelength: 4, depth: 0.8}", height / 2);
    snprintf(water[1], sizeof *water, "wave: {kind: stream, height: %g, wavelength: 4, depth: 0.8}",
             height);
    struct case_file *c[2];
    for (int k = 0; k < 2; k++) c[k] = parsed_in(four_by_two, "periodic", water[k]);
    if (!c[0] || !c[1]) return;
    struct flow_water a = opened(c[0], 0), b = opened(c[1], 0);
    off[i] = 0;
    for (double x = 0.05; x < 4; x += 0.1) {
      double u[2], v[2];
      flow_velocity(&a, x, 0.4, 0, u);
      flow_velocity(&b, x, 0.4, 0, v);
      off[i] = fmax(off[i], fabs(flow_elevation(&a, x, 0) - flow_elevation(&b, x, 0)));
      off[i] = fmax(off[i], hypot(u[0] - v[0], u[1] - v[1]) / sqrt(c[0]->gravity));
    }
    flow_close(&a);
    flow_close(&b);
    for (int k = 0; k < 2; k++) case_destroy(c[k]);
  }
  printf("     off by %.2e, %.2e m: order %.2f\n", off[0], off[1], log2(off[0] / off[1]));
  EXPECT(log2(off[0] / off[1]) > 2.7 && off[1] < 1e-4);
}

/* ---- bodies ---- */

/* A polygon of the body's own area, all of whose water theory has at pressure, and whose rim it has
 * without. */
static void expect_outline(const struct case_file *c) {
  struct flow_water w = opened(c, 1);
  EXPECT_NEAR(geo_piece_area(&c->water, 0), case_water_area(c), 1e-13);
  for (double part = 0; c->flow->rim && part < 1; part += 0.0731) {
    double p[2];
    c->flow->rim(&w, part, 0.7, p);
    EXPECT_NEAR(c->flow->pressure(&w, p[0], p[1], 0.7), 0, 1e-14);
    EXPECT(c->flow->pressure(&w, 2 + 0.9 * (p[0] - 2), 1 + 0.9 * (p[1] - 1), 0.7) > 0);
  }
  flow_close(&w);
}

static void test_outline_of_a_body_is_its_rim(void) {
  for_each(&flow_bodies, expect_outline);
}

/* du/dt = -grad p - Omega^2 r by central differences over e, whose error is of order e^2; and the
 * rim moves with the water. */
static void expect_motion(const struct case_file *c) {
  if (!flow_has_theory(c->flow)) return;
  struct flow_water w = opened(c, 1);
  const double e = 1e-4;
  const struct flow_pull pull = c->flow->pull(c);
  for (double t = 0.1; t < 6; t += 0.37) {
    double at[2], u[2], early[2], late[2], before[2], after[2];
    c->flow->rim(&w, 0.137, t, at);
    c->flow->rim(&w, 0.137, t - e, before);
    c->flow->rim(&w, 0.137, t + e, after);
    c->flow->velocity(&w, at[0], at[1], t, u);
    for (int k = 0; k < 2; k++) EXPECT_NEAR((after[k] - before[k]) / (2 * e), u[k], 1e-6);
    double x = 2 + 0.6 * (at[0] - 2), y = 1 + 0.6 * (at[1] - 1);
    c->flow->velocity(&w, x, y, t, u);
    c->flow->velocity(&w, x - e * u[0], y - e * u[1], t - e, early);
    c->flow->velocity(&w, x + e * u[0], y + e * u[1], t + e, late);
    double px = c->flow->pressure(&w, x + e, y, t) - c->flow->pressure(&w, x - e, y, t);
    double py = c->flow->pressure(&w, x, y + e, t) - c->flow->pressure(&w, x, y - e, t);
    double pull2 = pull.rate * pull.rate;
    EXPECT_NEAR((late[0] - early[0]) / (2 * e), -px / (2 * e) - pull2 * (x - pull.x), 1e-6);
    EXPECT_NEAR((late[1] - early[1]) / (2 * e), -py / (2 * e) - pull2 * (y - pull.y), 1e-6);
  }
  flow_close(&w);
}

static void test_theory_of_a_body_obeys_euler(void) {
  for_each(&flow_bodies, expect_motion);
}

/* What there is at the start is there at any time, and at rest a disc would have the rest. */
static void expect_energy(const struct case_file *c) {
  if (!flow_has_theory(c->flow)) return;
  struct flow_water w = opened(c, 1);
  const double first = energy_of(&w, 0), rest = case_rest_potential(c) / c->density;
  EXPECT(c->flow->kinetic(&w, 0) > 0);
  EXPECT_NEAR(c->flow->potential_energy(&w, 0), rest, 1e-14);
  for (double t = 0.1; t < 50; t += 3.7) EXPECT_NEAR(energy_of(&w, t), first, 1e-9 * first);
  flow_close(&w);
}

static void test_theory_of_a_body_keeps_its_energy(void) {
  for_each(&flow_bodies, expect_energy);
}

/* Each region its own velocity, the others that of all; between two, that of the nearer one. */
static void test_regions_move_as_they_say(void) {
  static const char text[] =
      "tank: {walls: [[[0, 2], [0, 0], [4, 0], [4, 2]]]}\n"
      "water: {velocity: [0.5, 0], regions: [[[0, 0], [1, 0], [1, 1], [0, 1]],\n"
      "  {points: [[1, 0], [2, 0], [2, 1], [1, 1]], velocity: [0, -2.385]},\n"
      "  {points: [[3, 0], [4, 0], [4, 1], [3, 1]]}]}\n"
      "time: {end: 1}\nruns: [{solver: sph, resolution: 20}]\n";
  static const double at[][4] = {
      {0.9, 0.5, 0.5, 0}, {1.1, 0.5, 0, -2.385}, {2.2, 0.5, 0, -2.385}, {2.8, 0.5, 0.5, 0}};
  struct problems problems = {0};
  struct case_file *c = NULL;
  struct flow_water w;
  EXPECT_OK(case_parse("regions", text, &fake_registry, &problems, &c));
  EXPECT_OK(flow_open(c, (struct flow_use){0}, &w));
  for (size_t i = 0; i < 4; i++) {
    double velocity[2];
    flow_velocity(&w, at[i][0], at[i][1], 0, velocity);
    EXPECT_NEAR(velocity[0], at[i][2], 0);
    EXPECT_NEAR(velocity[1], at[i][3], 0);
  }
  flow_close(&w);
  problems_destroy(&problems);
  case_destroy(c);
}

int main(void) {
  RUN(test_example_of_a_flow_is_that_flow);
  RUN(test_scales_of_a_wave_are_those_of_its_elevation);
  RUN(test_velocity_of_a_wave_is_the_gradient_of_its_potential);
  RUN(test_pressure_ends_at_the_surface);
  RUN(test_particles_start_where_the_wave_has_moved_them);
  RUN(test_theory_starts_from_the_flow_and_knows_its_error);
  RUN(test_solitary_wave_starts_over_a_flat_piece_of_bed);
  RUN(test_bore_has_the_velocity_of_a_hydraulic_jump);
  RUN(test_hump_starts_with_the_pressure_of_water_let_go);
  RUN(test_standing_wave_of_second_order_repeats_itself);
  RUN(test_stokes_wave_is_the_steady_one_to_second_order);
  RUN(test_outline_of_a_body_is_its_rim);
  RUN(test_theory_of_a_body_obeys_euler);
  RUN(test_theory_of_a_body_keeps_its_energy);
  RUN(test_regions_move_as_they_say);
  return TEST_RESULT;
}

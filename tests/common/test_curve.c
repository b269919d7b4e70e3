/* Water below a surface that hangs over, from a file. */
#include <math.h>

#include "common/case/case.h"
#include "common/flow/flow.h"
#include "common/flow/line.h"
#include "tests/common/bernoulli.h"
#include "tests/common/case_registry.h"
#include "tests/test.h"

static const double STRENGTH = 0.05, LENGTH = 2, DEPTH = 0.5; /* m^2/s, m, m */
enum content { AT_REST, POTENTIAL, VELOCITY };

/* It hangs over to the left of two crests, which are LENGTH/2 apart. */
static void surface_at(double s, double p[2]) {
  p[0] = LENGTH * s + 0.22 * sin(4 * M_PI * s);
  p[1] = DEPTH + 0.12 * sin(4 * M_PI * s);
}

static double wave_number(bool round) {
  return (round ? 2 : 1) * M_PI / LENGTH;
}

static double phase_of(bool round) {
  return round ? 0.7 : 0; /* there is no wall that it would go through */
}

static double phi_at(const double p[2], bool round, double u[2]) {
  const double k = wave_number(round), angle = k * p[0] + phase_of(round),
               part = STRENGTH / cosh(k * DEPTH);
  u[0] = -k * part * sin(angle) * cosh(k * p[1]);
  u[1] = k * part * cos(angle) * sinh(k * p[1]);
  return part * cos(angle) * cosh(k * p[1]);
}

/* From the left side on, or of a period from the way `from` on. */
static void write_curve(int parts, bool round, enum content content, double from) {
  FILE *out = fopen("curve.csv", "w");
  EXPECT(out != NULL);
  if (!out) return;
  fputs("# x, y, ...\n", out);
  for (int i = 0; i <= parts; i++) {
    double p[2], u[2];
    surface_at(from + (double)i / parts, p);
    const double phi = phi_at(p, round, u);
    fprintf(out, "%.17g, %.17g", p[0], p[1]);
    if (content == POTENTIAL) fprintf(out, ", %.17g", phi);
    if (content == VELOCITY) fprintf(out, ", %.17g, %.17g", u[0], u[1]);
    fputc('\n', out);
  }
  EXPECT(fclose(out) == 0);
}

static struct case_file *load(bool round, const char *walls) {
  struct problems problems = {0};
  struct case_file *c = NULL;
  FILE *out = fopen("curve.yaml", "w");
  EXPECT(out != NULL);
  if (!out) return NULL;
  fprintf(out,
          "tank: {walls: [[%s]], sides: %s}\nwater: {wave: {kind: curve, depth: 0.5, file: "
          "curve.csv}}\ntime: {end: 1}\nruns: [{solver: sph, resolution: 20}]\n",
          walls, round ? "periodic" : "walls");
  EXPECT(fclose(out) == 0);
  if (case_load("curve.yaml", 0, NULL, &fake_registry, &problems, &c) != OK)
    TEST_FAIL("%s", problems.n ? problems.text[0] : status_message());
  remove("curve.yaml");
  remove("curve.csv");
  problems_destroy(&problems);
  return c;
}

static const char BOX[] = "[0, 1], [0, 0], [2, 0], [2, 1]";

/* Largest and mean error of the velocity in the water, m/s. */
struct error {
  double largest, mean;
};

static struct error measure(int parts, double spacing, bool round, enum content content) {
  struct error e = {0};
  write_curve(parts, round, content, round ? 0.37 : 0);
  struct case_file *c = load(round, BOX);
  struct flow_water w;
  size_t n = 0;
  if (!c) return e;
  EXPECT_OK(flow_open(c, (struct flow_use){.spacing = spacing}, &w));
  for (double x = 0.0123; x < 2; x += 0.0417)
    for (double y = 0.0071; y < 0.7; y += 0.0313) {
      double u[2], exact[2];
      if (!geo_lines_contain(&c->water, x, y)) continue;
      flow_velocity(&w, x, y, 0, u);
      phi_at((double[2]){x, y}, round, exact);
      const double off = hypot(u[0] - exact[0], u[1] - exact[1]);
      e.largest = fmax(e.largest, off);
      e.mean += off;
      n++;
    }
  e.mean /= (double)n;
  flow_close(&w);
  case_destroy(c);
  return e;
}

/* Linear on panels: second order in the water, first within a panel of the rim. */
static void test_velocities_are_those_of_the_potential_on_the_surface(void) {
  for (int round = 0; round < 2; round++)
    for (enum content content = POTENTIAL; content <= VELOCITY; content++) {
      const struct error a = measure(64, 0.12, round, content),
                         b = measure(128, 0.06, round, content),
                         d = measure(256, 0.03, round, content);
      printf("  %s, from the %s: largest %.1e, %.1e, %.1e, mean %.1e, %.1e, %.1e m/s\n",
             round ? "round" : "between walls", content == POTENTIAL ? "potential" : "velocity",
             a.largest, b.largest, d.largest, a.mean, b.mean, d.mean);
      EXPECT(d.mean > 0 && d.mean < b.mean / 3.5 && b.mean < a.mean / 3.5);
      EXPECT(d.largest < b.largest / 1.8 && b.largest < a.largest / 1.8);
      EXPECT(a.largest < 0.015 * STRENGTH * wave_number(round));
    }
}

/* Without gravity's share: p/(rho g) + y + |u|^2/2g is harmonic, and zero pressure is on the
 * surface; its mean over a circle is what it is in the middle. */
static void test_pressure_is_bernoullis_and_ends_at_the_surface(void) {
  write_curve(256, false, POTENTIAL, 0);
  struct case_file *c = load(false, BOX);
  struct flow_water w;
  if (!c) return;
  EXPECT_OK(flow_open(c, (struct flow_use){.spacing = 0.02}, &w));
  expect_harmonic(&w, 0.83, 0.19, 0.15, 1e-10);
  const struct flow_line *l = flow_line_of(c);
  for (int i = 1; l && i < 100; i++) {
    const struct flow_line_point at = flow_line_at(l, l->from + (l->to - l->from) * i / 100);
    const double way = hypot(at.slope[0], at.slope[1]), deep = 1e-3;
    const double x = at.p[0] + deep * at.slope[1] / way, y = at.p[1] - deep * at.slope[0] / way;
    double head;
    EXPECT_OK(flow_head(&w, &(struct flow_point){x, y, y}, &head));
    EXPECT(head > 0 && head < 3 * deep); /* of water at rest: its depth, 1e-3 below at most */
  }
  flow_close(&w);
  case_destroy(c);
}

/* The area below it is exact, and a period may begin anywhere. */
static void test_area_and_period(void) {
  for (int i = 0; i < 40; i++) {
    write_curve(256, true, AT_REST, i * 0.037);
    struct case_file *c = load(true, BOX);
    if (!c) return;
    const double area = case_water_area(c);
    EXPECT_NEAR(geo_piece_area(&c->water, 0), area, 1e-5);
    EXPECT_NEAR(area, LENGTH * DEPTH, 1e-7); /* the integral of sin(4 pi s) x'(s) is zero */
    case_destroy(c);
  }
}

int main(void) {
  RUN(test_velocities_are_those_of_the_potential_on_the_surface);
  RUN(test_pressure_is_bernoullis_and_ends_at_the_surface);
  RUN(test_area_and_period);
  return TEST_RESULT;
}

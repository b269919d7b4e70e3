/* Water whose surface comes from a file. */
#include <math.h>

#include "common/case/case.h"
#include "common/flow/flow.h"
#include "tests/common/bernoulli.h"
#include "tests/common/case_registry.h"
#include "tests/test.h"

static const double AMPLITUDE = 0.03, STRENGTH = 0.05, DEPTH = 0.5; /* m, m^2/s, m */

/* Waves of a period's length between walls 2 m apart, or round a period of them: cos kx cosh
 * kY/cosh kd below a surface of another height. */
static double wave_number(bool round) {
  return (round ? 2 : 1) * M_PI / 2;
}

static double phase_of(bool round) {
  return round ? 0.7 : 0; /* there is no wall that it would go through */
}

static double eta_at(double x, bool round) {
  return AMPLITUDE * cos(wave_number(round) * x + 2 * phase_of(round));
}

static double phi_at(double x, double y, bool round) {
  const double k = wave_number(round);
  return STRENGTH * cos(k * x + phase_of(round)) * cosh(k * y) / cosh(k * DEPTH);
}

static void write_text(const char *path, const char *text) {
  FILE *out = fopen(path, "w");
  EXPECT(out && fputs(text, out) >= 0 && fclose(out) == 0);
}

enum content { AT_REST, POTENTIAL, VELOCITY };

static void write_surface(int parts, bool round, enum content content) {
  FILE *out = fopen("surface-file.csv", "w");
  EXPECT(out != NULL);
  if (!out) return;
  fputs("# x, eta, phi\n", out);
  for (int i = 0; i <= parts; i++) {
    const double x = 2.0 * i / parts, eta = eta_at(x, round);
    fprintf(out, "%.17g, %.17g", x, eta);
    const double k = wave_number(round), y = DEPTH + eta, angle = k * x + phase_of(round),
                 rate = k * STRENGTH / cosh(k * DEPTH);
    if (content == POTENTIAL) fprintf(out, ", %.17g", phi_at(x, y, round));
    if (content == VELOCITY)
      fprintf(out, ", %.17g, %.17g", -rate * sin(angle) * cosh(k * y),
              rate * cos(angle) * sinh(k * y));
    fputc('\n', out);
  }
  EXPECT(fclose(out) == 0);
}

static struct case_file *load(int parts, bool round, enum content content) {
  struct problems problems = {0};
  struct case_file *c = NULL;
  write_surface(parts, round, content);
  write_text("surface-file.yaml",
             round ? "tank: {walls: [[[0, 1], [0, 0], [2, 0], [2, 1]]], sides: periodic}\n"
                     "water: {wave: {kind: file, depth: 0.5, file: surface-file.csv}}\n"
                     "time: {end: 1}\nruns: [{solver: sph, resolution: 20}]\n"
                   : "tank: {walls: [[[0, 1], [0, 0], [2, 0], [2, 1]]]}\n"
                     "water: {wave: {kind: file, depth: 0.5, file: surface-file.csv}}\n"
                     "time: {end: 1}\nruns: [{solver: sph, resolution: 20}]\n");
  if (case_load("surface-file.yaml", 0, NULL, &fake_registry, &problems, &c) != OK)
    TEST_FAIL("%s", problems.n ? problems.text[0] : status_message());
  remove("surface-file.yaml");
  remove("surface-file.csv");
  problems_destroy(&problems);
  return c;
}

/* Largest errors of surface, m, and of velocities in the water, m/s. */
static void measure(int parts, bool round, enum content content, double error[2]) {
  struct case_file *c = load(parts, round, content);
  struct flow_water w;
  const double k = wave_number(round);
  error[0] = error[1] = 0;
  if (!c) return;
  EXPECT_OK(flow_open(c, (struct flow_use){.spacing = 0.05}, &w));
  for (double x = 0.003; x < 2; x += 0.0173) {
    const double top = DEPTH + eta_at(x, round), angle = k * x + phase_of(round);
    error[0] = fmax(error[0], fabs(flow_elevation(&w, x, 0) - top));
    for (int i = 0; i <= 4; i++) {
      const double y = top * i / 4, rate = k * STRENGTH / cosh(k * DEPTH);
      double u[2];
      flow_velocity(&w, x, y, 0, u);
      error[1] = fmax(error[1], hypot(u[0] + rate * sin(angle) * cosh(k * y),
                                      u[1] - rate * cos(angle) * sinh(k * y)));
    }
  }
  flow_close(&w);
  case_destroy(c);
}

/* A cubic spline errs by 5/384 h^4 of the fourth derivative inside, some ten times that at ends
 * without a knot; twice as many rows make it 16 times smaller. The velocities come from the spline
 * of phi by a fit that damps what it cannot see; they lose at most one order. */
static void expect_order(bool round, enum content content) {
  double coarse[2], fine[2];
  const double h = 2.0 / 32;
  measure(32, round, content, coarse);
  measure(64, round, content, fine);
  EXPECT(coarse[0] <= 10 * 5.0 / 384 * AMPLITUDE * pow(wave_number(round) * h, 4));
  EXPECT(fine[0] > 0 && fine[0] <= coarse[0] / 12);
  EXPECT(coarse[1] <= 1e-3 * STRENGTH * wave_number(round));
  EXPECT(fine[1] > 0 && fine[1] <= coarse[1] / 6);
  printf("surface %.2e %.2e, velocity %.2e %.2e\n", coarse[0], fine[0], coarse[1], fine[1]);
}

static void test_surface_and_velocities_are_those_of_the_file(void) {
  for (enum content content = POTENTIAL; content <= VELOCITY; content++) {
    expect_order(false, content);
    expect_order(true, content);
  }
}

/* No pressure on the surface; with the square of the velocity and the height it is harmonic, so its
 * mean over a circle is what it is in the middle. */
static void test_pressure_of_moving_water_is_bernoullis(void) {
  struct case_file *c = load(64, false, POTENTIAL);
  struct flow_water w;
  if (!c) return;
  EXPECT_OK(flow_open(c, (struct flow_use){.spacing = 0.05}, &w));
  expect_harmonic(&w, 0.83, 0.24, 0.2, 1e-12);
  for (double x = 0.1; x < 2; x += 0.1) {
    double head;
    const double y = flow_elevation(&w, x, 0) - 1e-9;
    EXPECT_OK(flow_head(&w, &(struct flow_point){x, y, y}, &head));
    EXPECT_NEAR(head, 0, 1e-6);
  }
  flow_close(&w);
  case_destroy(c);
}

/* The same water from one file and from another is the same; other heights are other water, and a
 * result's case, without its file, is level. */
static void test_fingerprint_is_that_of_the_rows(void) {
  struct case_file *a = load(32, false, AT_REST), *b = load(32, false, POTENTIAL), *again = NULL;
  struct problems problems = {0};
  char of_a[33], of_b[33];
  if (!a || !b) return;
  case_water_fingerprint(a, of_a);
  case_water_fingerprint(b, of_b);
  EXPECT(strcmp(of_a, of_b) != 0);
  EXPECT_NEAR(case_water_area(a), 1, 1e-6);
  EXPECT_OK(case_parse("result", a->text, &fake_registry, &problems, &again));
  if (again) EXPECT_NEAR(again->flow->scale(again).amplitude, 0, 0);
  problems_destroy(&problems);
  case_destroy(again);
  again = load(32, false, AT_REST);
  if (again) case_water_fingerprint(again, of_b);
  EXPECT(strcmp(of_a, of_b) == 0);
  case_destroy(a);
  case_destroy(b);
  case_destroy(again);
}

int main(void) {
  RUN(test_surface_and_velocities_are_those_of_the_file);
  RUN(test_pressure_of_moving_water_is_bernoullis);
  RUN(test_fingerprint_is_that_of_the_rows);
  return TEST_RESULT;
}

/* How high water runs up a beach: the highest of parabolas through three steps; a solitary wave
 * that does not break, against Synolakis' law. */
#include "bem/breaking/runup.h"
#include "tests/bem/run.h"

static double height(double t) {
  return 1 + 0.3 * t - 0.1 * t * t;
}

static void test_a_parabola_is_found_between_steps_of_any_length(void) {
  struct bem_runup u = {0};
  const double step[] = {0.31, 0.83, 0.71, 0.09, 0.17};
  double t = 0.1;
  for (size_t i = 0; i < sizeof step / sizeof *step; t += step[i++]) {
    EXPECT(bem_runup_found(&u, 1) == (i > 3));
    bem_runup_add(&u, t, 2 * height(t), height(t));
  }
  EXPECT_NEAR(u.top[0], 1.5, 1e-12);
  EXPECT_NEAR(u.top[1], 2 * 1.225, 1e-12);
  EXPECT_NEAR(u.top[2], 1.225, 1e-12);
  EXPECT(!bem_runup_found(&u, 1.2245)); /* less than a thousandth */
}

static void test_what_only_rises_or_falls_has_not_run_up(void) {
  struct bem_runup up = {0}, down = {0};
  for (int i = 0; i < 9; i++) {
    bem_runup_add(&up, i, 0, 1 + 0.1 * i);
    bem_runup_add(&down, i, 0, 1 - 0.1 * i);
  }
  EXPECT(!bem_runup_found(&up, 1) && !bem_runup_found(&down, 1));
}

/* R of a wave A high, in depths, on a beach of 1:cot. */
static double run_up(double cot, double A, int nodes) {
  char text[600];
  snprintf(text, sizeof text,
           "title: run-up\n"
           "fluid: {density: 1, gravity: 1}\n"
           "scales: {H: 1}\n"
           "tank: {walls: [[[0, 1.5], [0, 0], [74, 0], [%g, 1.5]]]}\n"
           "water: {wave: {kind: solitary, amplitude: %g, depth: 1, x: 37}}\n"
           "time: {end: %g, every: 50, sample: 50}\n"
           "runs: [{name: bem, solver: bem, resolution: %d, tolerance: 1e-3}]\n",
           74 + 1.5 * cot, A, 50 + 1.5 * cot, nodes);
  struct result_file *f = run_bem(text);
  if (!f) return NAN;
  const struct result_event_read e = run_event(f, "run_up");
  EXPECT(!*f->ended);
  EXPECT_NEAR(e.y, 1 + (e.x - 74 - cot) / cot, 1e-12); /* on the beach */
  result_file_destroy(f);
  return e.y - 1;
}

/* His law is of the shallow-water equations, which leave out what is of second order in the slope:
 * by how much it fails on 1:5 says how much it may in his tank of 1:19.85. */
static void test_a_wave_that_does_not_break_runs_up_as_synolakis_has_it(void) {
  const double A = 0.0185, cot[] = {5, 19.85}, order = pow(cot[0] / cot[1], 2);
  double off[2];
  for (int i = 0; i < 2; i++) {
    const double law = 2.831 * sqrt(cot[i]) * pow(A, 1.25), R = run_up(cot[i], A, 2);
    off[i] = R / law - 1;
    printf("  on 1:%g R/H = %.6f, the law's %.4f and %+.2f %%\n", cot[i], R, law, 100 * off[i]);
  }
  EXPECT(fabs(off[1]) < order * fabs(off[0]));
  EXPECT_NEAR(run_up(cot[0], A, 3), run_up(cot[0], A, 2), 1e-4);
}

/* Water that swings between two upright sides, beside a slope at the foot of one: gauges know how
 * high it comes. */
static void test_upright_sides_are_no_beaches(void) {
  struct result_file *f =
      run_bem("title: swing\n"
              "fluid: {density: 1, gravity: 1}\n"
              "scales: {H: 1}\n"
              "tank: {walls: [[[0, 3], [0, 0], [2, 0], [3, 0.1], [3, 3]]]}\n"
              "water: {wave: {kind: standing, amplitude: 0.05, depth: 0.8, wavelength: 6}}\n"
              "time: {end: 5, every: 5, sample: 5}\n"
              "runs: [{name: bem, solver: bem, resolution: 8, tolerance: 1e-3}]\n");
  if (!f) return;
  EXPECT(!*f->ended);
  EXPECT(isnan(run_event(f, "run_up").time));
  result_file_destroy(f);
}

int main(void) {
  RUN(test_a_parabola_is_found_between_steps_of_any_length);
  RUN(test_what_only_rises_or_falls_has_not_run_up);
  RUN(test_upright_sides_are_no_beaches);
  RUN(test_a_wave_that_does_not_break_runs_up_as_synolakis_has_it);
  return TEST_RESULT;
}

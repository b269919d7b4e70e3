/* How high water runs up a beach: the highest of parabolas through three steps; a solitary wave
 * that does not break, against Synolakis' law. */
#include "bem/runup.h"
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

/* R/H of a wave 0.05 H high on 1:5. */
static double run_up(int nodes) {
  char text[600];
  snprintf(text, sizeof text,
           "title: run-up\n"
           "fluid: {density: 1, gravity: 1}\n"
           "scales: {H: 1}\n"
           "tank: {walls: [[[0, 2], [0, 0], [44, 0], [54, 2]]]}\n"
           "water: {wave: {kind: solitary, amplitude: 0.05, depth: 1, x: 22}}\n"
           "time: {end: 33, every: 33, sample: 33}\n"
           "runs: [{name: bem, solver: bem, resolution: %d, tolerance: 1e-3}]\n",
           nodes);
  struct result_file *f = run_bem(text);
  if (!f) return NAN;
  const struct result_event_read e = run_event(f, "run_up");
  EXPECT(!*f->ended);
  EXPECT_NEAR(e.y, 1 + (e.x - 49) / 5, 1e-12); /* on the beach */
  result_file_destroy(f);
  return e.y - 1;
}

/* The law, of the shallow-water equations on gentler slopes, is 5 % lower here. */
static void test_a_wave_that_does_not_break_runs_up_as_synolakis_has_it(void) {
  const double law = 2.831 * sqrt(5) * pow(0.05, 1.25), coarse = run_up(2), fine = run_up(3);
  printf("  R/H = %.6f, %.6f with 2 and 3 nodes for each depth; law %.4f\n", coarse, fine, law);
  EXPECT_NEAR(fine, law, 0.1 * law);
  EXPECT_NEAR(coarse, fine, 1e-4);
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

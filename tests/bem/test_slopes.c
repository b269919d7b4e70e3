/* Columns on and before slopes: what stopped them once. */
#include "tests/bem/run.h"
#include "tests/bem/slopes.h"

static struct result_file *run_slope(int n, double resolution, double last) {
  const struct slope s = slope_at(n);
  struct slope_text t;
  slope_write(&t, &s, resolution, last);
  return run_bem(t.text);
}

static void expect_budget(const struct result_file *f, double energy) {
  for (size_t i = 0; i < f->n_energy; i++)
    EXPECT_NEAR(result_energy_budget(&f->energy[i]) / f->energy[0].total, 1, energy);
}

static void expect_alive(struct result_file *f, double energy) {
  if (!f) return;
  EXPECT_STR(f->ended, "");
  expect_budget(f, energy);
  result_file_destroy(f);
}

/* Between an upright face and a bed of 1:1.35 that rises before it there are 127 degrees:
 * velocities have no bound there, and what polynomials across the edge made of them stopped it at t
 * = 0.06. */
static void test_a_front_leans_over_a_bed_that_rises(void) {
  const struct slope s = slope_at(22);
  EXPECT(s.kind == SLOPE_RISING && s.cot < 1.5);
  expect_alive(run_slope(22, 27, 0.12), 2e-4);
}

/* Below a slope the nose of the front puts a tongue out along the bed. Its nodes come as near to it
 * as rounding, and beyond, where the map of the tank ends. */
static void test_a_tongue_on_the_bed_is_taken_away(void) {
  const struct slope s = slope_at(16);
  EXPECT(s.kind == SLOPE_FALLING);
  expect_alive(run_slope(16, 30, 1.3), 2e-4);
}

/* The jet up a slope of 1:1.22 becomes a film two hundredths of a panel thin. */
static void test_a_film_on_a_slope_is_cut_where_the_run_does_not_get_on(void) {
  const struct slope s = slope_at(20);
  EXPECT(s.kind == SLOPE_BEACH && s.cot < 1.25);
  expect_alive(run_slope(20, 17, 1.6), 1e-3);
}

/* The jet up the face of a step passes its top: no film thinner than the panels is to blame. What
 * has come over the brink is no tongue behind it, whose cut took 0.04 of the energy. */
static void test_water_that_leaves_the_wall_is_said_to(void) {
  const struct slope s = slope_at(3);
  EXPECT(s.kind == SLOPE_STEP);
  struct result_file *f = run_slope(3, 16, 1);
  if (!f) return;
  EXPECT(strstr(f->ended, "the water leaves the wall at a bend, with air behind it, and can no "
                          "longer be followed at t = "));
  EXPECT(run_statistic(f, "last_good_time") > 0.6);
  expect_budget(f, 2e-4);
  result_file_destroy(f);
}

/* Parabolas through places before and after an edge was moved led to heights of 80 to 2000 H. An
 * edge at its highest falls no faster than freely: of two surfaces 0.1 apart the nearer one has
 * lost at most half of 0.05^2. */
static void test_a_run_up_is_where_the_water_was(void) {
  struct result_file *f = run_slope(15, 15, 4.2);
  if (!f) return;
  const struct result_event_read e = run_event(f, "run_up");
  double highest = 0;
  for (size_t i = 0; i < f->n_surfaces; i++)
    highest = fmax(highest, geo_lines_box(&f->surface[i]).max[1]);
  printf("     %.6f H, of the surfaces %.6f H\n", e.y, highest);
  EXPECT(isfinite(run_event(f, "cut").time) && run_event(f, "cut").time < e.time);
  EXPECT(e.y < highest + 0.5 * 0.05 * 0.05);
  result_file_destroy(f);
}

int main(void) {
  RUN(test_a_front_leans_over_a_bed_that_rises);
  RUN(test_a_tongue_on_the_bed_is_taken_away);
  RUN(test_a_film_on_a_slope_is_cut_where_the_run_does_not_get_on);
  RUN(test_water_that_leaves_the_wall_is_said_to);
  RUN(test_a_run_up_is_where_the_water_was);
  return TEST_RESULT;
}

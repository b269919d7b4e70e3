/* How a run ends before the end of its case: with a sentence that says why, when and where, and
 * with everything that is known until then. */
#include "bem/run/ending.h"
#include "tests/bem/run.h"

static const char text[] = "title: dam break\n"
                           "fluid: {density: 1, gravity: 1}\n"
                           "scales: {H: 1}\n"
                           "tank: {walls: [[[0, %g], [0, 0], [%g, 0], [%g, %g]]]}\n"
                           "water: {regions: [[[0, 0], [%g, 0], [%g, 1], [0, 1]]], %s}\n"
                           "time: {end: %g, every: 0.5}\n"
                           "runs: [{name: bem, solver: bem, resolution: %g, film: %g}]\n";

struct setting {
  double left, length, right, column, end, film;
  const char *pressure;
  double nodes; /* per H */
};

static void write_case(char with[600], const struct setting *s) {
  snprintf(with, 600, text, s->left, s->length, s->length, s->right, s->column, s->column,
           s->pressure, s->end, s->nodes, s->film);
}

static struct result_file *released(double right, double length, double column) {
  char with[600];
  write_case(with,
             &(struct setting){1.5, length, right, column, 7, 0.005, "pressure: released", 16});
  return run_bem(with);
}

static void test_thick_water_above_the_top_of_a_wall_ends_the_run(void) {
  struct result_file *f = released(1, 3, 1.5);
  if (!f) return;
  struct result_event_read over = run_event(f, "overflow");
  EXPECT(over.time > 1.4 && over.time < 2);
  EXPECT_NEAR(over.x, 3, 1e-9);
  EXPECT_NEAR(over.y, 1, 1e-6);
  EXPECT(strstr(f->ended, "water passed the top of the right wall at t = "));
  EXPECT(isfinite(run_statistic(f, "steps_cut")));
  result_file_destroy(f);
}

/* The film that passes a wall of 3 H in Buchner's tank is a hundredth of H thick. */
static void test_thin_film_above_the_top_is_counted_as_spilled_until_touchdown(void) {
  struct result_file *f = released(2.8, 5.366, 2);
  if (!f) return;
  EXPECT(run_event(f, "overflow").time < run_event(f, "touchdown").time);
  double spilled = run_statistic(f, "spilled_volume");
  EXPECT(spilled > 1e-4 && spilled < 0.02 && spilled < f->steps[f->n_steps - 1].removed_volume);
  EXPECT(strstr(f->ended, "the jet touched down at t = 6.1"));
  EXPECT(strstr(f->ended, "potential flow ends here"));
  for (size_t i = 0; i < f->n_surfaces; i++)
    EXPECT(geo_lines_box(&f->surface[i]).max[1] < 2.8 + 0.05); /* at most a step's rise */
  result_file_destroy(f);
}

static void test_a_run_that_reaches_the_end_of_its_case_ends_without_a_reason(void) {
  char with[600];
  write_case(with, &(struct setting){1.5, 3, 3, 1.5, 0.5, 0.005, "pressure: released", 16});
  struct result_file *f = run_bem(with);
  if (!f) return;
  EXPECT_STR(f->ended, "");
  EXPECT(run_statistic(f, "spilled_volume") == 0);
  EXPECT(isnan(run_statistic(f, "last_good_time")));
  result_file_destroy(f);
}

static void test_a_film_as_thick_as_at_the_impact_is_refused(void) {
  char with[600];
  struct problems problems = {0};
  struct case_file *c = NULL;
  write_case(with, &(struct setting){1.5, 3, 3, 1.5, 0.5, 0.01, "pressure: released", 16});
  EXPECT(case_parse("test", with, &run_registry, &problems, &c) == ERR_INPUT);
  EXPECT(problems.n == 1 && strstr(problems.text[0], "runs.bem.film: found 0.01 m; allowed: less"));
  problems_destroy(&problems);
  case_destroy(c);
}

/* Its film throws spikes, which are cut, each with its place and its share of the volume. */
static void test_a_narrow_tank_comes_to_touchdown_through_many_cuts(void) {
  struct result_file *f = released(4, 2.2, 1.25);
  int cuts = 0, inside = 0;
  if (!f) return;
  for (size_t i = 0; i < f->n_events; i++) {
    const struct result_event_read *e = &f->events[i];
    if (strcmp(e->name, "cut")) continue;
    cuts++;
    inside += e->x > 1.5 && e->x <= 2.2 + 1e-9 && e->y > 0;
  }
  EXPECT(cuts > 3 && inside == cuts);
  EXPECT(strstr(f->ended, "the jet touched down at t = 4."));
  const struct result_step *last = f->steps + f->n_steps - 1;
  printf("  %d cuts, %.2g of the volume\n", cuts, last->removed_volume / f->steps[0].volume);
  EXPECT_NEAR((last->volume + last->removed_volume) / f->steps[0].volume, 1, 2e-3);
  result_file_destroy(f);
}

/* Eight nodes for each H are too few for a gap of 0.44 H: what is known until then is there. */
static void test_a_run_that_is_lost_says_where_and_until_when_it_is_good(void) {
  char with[600];
  write_case(with, &(struct setting){4, 1.48, 4, 1.04, 3, 0.005, "pressure: released", 8});
  struct result_file *f = run_bem(with);
  if (!f) return;
  const double good = run_statistic(f, "last_good_time");
  EXPECT(strstr(f->ended, " and can no longer be followed at t = 0."));
  EXPECT(good > run_event(f, "wall_impact").time && good < 3);
  EXPECT(f->n_energy > 1 && f->energy[f->n_energy - 1].time <= good);
  EXPECT(f->n_surfaces > 0 && f->n_surfaces < 7);
  result_file_destroy(f);
}

/* Nothing about its flow is to blame: here it is at rest. */
static void test_a_run_of_too_many_steps_says_how_far_its_end_still_is(void) {
  char with[600], path[] = "/tmp/plunge-bem-XXXXXX.h5";
  const int handle = mkstemps(path, 3);
  write_case(with, &(struct setting){3, 3, 3, 3, 7.25, 0.005, "pressure: hydrostatic", 16});
  struct case_file *c = run_case(with);
  struct bem_run r = {
      .c = c, .time = 2.385, .pace.steps = 1000000, .output = {.c = c, .time_scale = 1}};
  struct result_file *f = NULL;
  EXPECT(handle >= 0 && c);
  if (!c) return;
  EXPECT_OK(result_create(path, c, &c->runs[0], &r.output.file));
  EXPECT_OK(bem_ending_spent(&r));
  EXPECT(r.ended && r.lost);
  EXPECT_OK(result_finish(r.output.file));
  result_destroy(r.output.file);
  EXPECT_OK(result_read(path, &f));
  EXPECT_STR(f ? f->ended : "",
             "the end of the case is still 4.865 s away after 1000000 steps, at t = 2.385 s "
             "(2.3850 sqrt(H/g)); what was written before is valid: end the case there, or lower "
             "the resolution");
  result_file_destroy(f);
  case_destroy(c);
  close(handle);
  unlink(path);
  char xdmf[sizeof path + 2];
  snprintf(xdmf, sizeof xdmf, "%.*s.xdmf", (int)strlen(path) - 3, path);
  unlink(xdmf);
}

/* With 16 its film puts a tongue out along the wall, which stopped it at t = 0.6. */
static void test_a_narrow_gap_is_lived_through(void) {
  struct result_file *f = released(8, 1.48, 1.04); /* no spray of the film passes such a wall */
  if (!f) return;
  EXPECT(strstr(f->ended, "the jet touched down at t = "));
  result_file_destroy(f);
}

int main(void) {
  RUN(test_thick_water_above_the_top_of_a_wall_ends_the_run);
  RUN(test_thin_film_above_the_top_is_counted_as_spilled_until_touchdown);
  RUN(test_a_run_that_reaches_the_end_of_its_case_ends_without_a_reason);
  RUN(test_a_narrow_tank_comes_to_touchdown_through_many_cuts);
  RUN(test_a_film_as_thick_as_at_the_impact_is_refused);
  RUN(test_a_narrow_gap_is_lived_through);
  RUN(test_a_run_of_too_many_steps_says_how_far_its_end_still_is);
  RUN(test_a_run_that_is_lost_says_where_and_until_when_it_is_good);
  return TEST_RESULT;
}

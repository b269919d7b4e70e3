/* Convergence in the report: made-up runs of known order, groups, and what is said where there is
 * no order. */
#include "compare/report.h"

#include "compare/measures/look.h"
#include "tests/compare/made_up.h"

static struct case_file settings;

/* A level raised by `raised` (H) at H/dx = n. */
static struct result_file *run_of(const char *name, double n, double raised) {
  struct result_file *r =
      made_up(name, "convergence", (struct flaws){.raised = raised, .until = end});
  r->spacing = H / n;
  r->steps[r->n_steps - 1].wall_time = n;
  r->steps[r->n_steps - 1].evaluations = 10 * n;
  return r;
}

static json_t *group_at(size_t i) {
  return json_array_get(json_object_get(report, "convergence"), i);
}

static json_t *row_of(size_t group, const char *name, double t) {
  size_t i;
  json_t *row;
  json_array_foreach(json_object_get(group_at(group), "rows"), i, row) {
    json_t *at = json_object_get(row, "t_star");
    if (!strcmp(json_string_value(json_object_get(row, "name")), name) &&
        (json_is_null(at) || fabs(json_number_value(at) - t) < 1e-9))
      return row;
  }
  TEST_FAIL("no row %s", name);
  return NULL;
}

static double number_of(json_t *object, const char *key) {
  json_t *v = json_object_get(object, key);
  return json_is_number(v) ? json_number_value(v) : NAN;
}

static double item_of(json_t *object, const char *key, size_t i) {
  json_t *v = json_array_get(json_object_get(object, key), i);
  return json_is_number(v) ? json_number_value(v) : NAN;
}

static const char *words_of(json_t *object, const char *key) {
  const char *s = json_string_value(json_object_get(object, key));
  return s ? s : "null";
}

static void destroy(struct result_file *ref, size_t n, struct result_file **runs) {
  result_file_destroy(ref);
  for (size_t i = 0; i < n; i++) result_file_destroy(runs[i]);
}

/* Levels of error h^2, four resolutions given in any order, equal and unequal ratios: the order,
 * the limit and the index of the gauge's rms, which is the error itself. */
static void test_order_of_a_measure(void) {
  struct result_file *ref = made_up("exact", "convergence", (struct flaws){.until = end});
  struct result_file *runs[] = {
      run_of("level-50", 50, pow(50, -2)), run_of("level-10", 10, pow(10, -2)),
      run_of("level-30", 30, pow(30, -2)), run_of("level-20", 20, pow(20, -2))};
  free(ref->solver);
  ref->solver = text("theory");
  compare(&settings, ref, 4, runs);
  EXPECT(json_array_size(json_object_get(report, "convergence")) == 1);
  json_t *group = group_at(0), *row = row_of(0, "gauge_rms", NAN);
  EXPECT_STR(words_of(group, "name"), "level");
  EXPECT_STR(words_of(group, "solver"), "made up");
  EXPECT(json_is_null(json_object_get(group, "settings"))); /* their case has no such run */
  EXPECT(json_is_null(json_object_get(group, "reference")));
  EXPECT(json_array_size(json_object_get(group, "runs")) == 4);
  EXPECT_STR(json_string_value(json_array_get(json_object_get(group, "runs"), 0)), "level-10");
  EXPECT_NEAR(item_of(group, "spacing", 3), 0.02, 1e-12);
  EXPECT_NEAR(item_of(group, "wall_time_s", 1), 20, 1e-12);
  EXPECT_NEAR(item_of(group, "evaluations", 1), 200, 1e-12);
  EXPECT_STR(words_of(row, "trend"), "monotone");
  EXPECT(json_is_true(json_object_get(row, "is_difference")));
  EXPECT_NEAR(number_of(row, "order"), 2, 1e-6);
  EXPECT_NEAR(number_of(row, "richardson"), 0, 1e-9);
  EXPECT_NEAR(number_of(row, "gci"), 1.25, 1e-6);
  EXPECT_NEAR(number_of(row, "error_bar"), 1.25 / 2500, 1e-9);
  EXPECT(json_array_size(json_object_get(row, "triples")) == 2);
  for (size_t i = 0; i < 3; i++) EXPECT_NEAR(item_of(row, "error_orders", i), 2, 1e-6);
  EXPECT(strstr(words_of(row, "says"), "monotone, order 2, limit"));
  EXPECT(strstr(words_of(row, "says"), "coarser ones: order 2"));
  /* the level itself, whose error is from the reference's */
  row = row_of(0, "highest_level", NAN);
  EXPECT(!json_is_true(json_object_get(row, "is_difference")));
  EXPECT_NEAR(number_of(row, "order"), 2, 1e-6);
  EXPECT_NEAR(number_of(row, "richardson"), 1, 1e-9);
  EXPECT_NEAR(item_of(row, "errors", 0), 0.01, 1e-9);
  /* what is right at all resolutions */
  row = row_of(0, "kinetic_energy", 2);
  EXPECT_STR(words_of(row, "trend"), "constant");
  EXPECT(isnan(number_of(row, "order")));
  EXPECT(isnan(item_of(row, "error_orders", 0))); /* zero errors */
  /* the table has a line for every run of every row, and the triple in that of its finest */
  EXPECT(file_says("convergence.csv", "group,quantity,of,units,"));
  EXPECT(file_says("convergence.csv", "\"level\",\"gauge_rms\",\"\",\"H\",,\"level-10\",0.1"));
  EXPECT(file_says("convergence.csv", "\"monotone\",2"));
  /* figures and their data are there */
  EXPECT(file_says("figures/convergence-levels.csv", "\"highest level"));
  EXPECT(file_says("figures/convergence-cost.csv", "\"mean distance at t* = 4\",\"level\""));
  destroy(ref, 4, runs);
}

/* The finest as the reference: its distance from itself is 0, and tells the order all the same. */
static void test_reference_of_the_group(void) {
  struct result_file *ref = run_of("a-40", 40, pow(40, -2));
  struct result_file *runs[] = {run_of("a-20", 20, pow(20, -2)), run_of("a-10", 10, pow(10, -2))};
  compare(&settings, ref, 2, runs);
  json_t *row = row_of(0, "gauge_rms", NAN);
  EXPECT_NEAR(number_of(group_at(0), "reference"), 2, 0);
  EXPECT(item_of(row, "values", 2) == 0);
  EXPECT_NEAR(number_of(row, "order"), 2, 1e-6);
  EXPECT_NEAR(number_of(row, "richardson"), -pow(40, -2), 1e-9);
  EXPECT(isnan(number_of(row, "gci")));
  EXPECT(strstr(words_of(row, "says"), ", if all err to one side"));
  row = row_of(0, "highest_level", NAN);
  EXPECT_NEAR(number_of(row, "order"), 2, 1e-6);
  EXPECT_NEAR(number_of(row, "richardson"), 1, 1e-9);
  EXPECT(item_of(row, "errors", 2) == 0);
  EXPECT(isnan(item_of(row, "error_orders", 1)));
  destroy(ref, 2, runs);
}

/* Two resolutions have no order; of two runs of one spacing one is left out, and named. */
static void test_two_resolutions_and_equal_ones(void) {
  struct result_file *ref = made_up("exact", "convergence", (struct flaws){.until = end});
  struct result_file *runs[] = {run_of("b-20", 20, 0.01), run_of("b-20-again", 20, 0.02),
                                run_of("b-40", 40, 0.003)};
  free(ref->solver);
  ref->solver = text("theory");
  compare(&settings, ref, 3, runs);
  json_t *row = row_of(0, "gauge_rms", NAN),
         *out = json_array_get(json_object_get(group_at(0), "left_out"), 0);
  EXPECT(json_is_null(json_object_get(row, "trend")));
  EXPECT(isnan(number_of(row, "order")));
  EXPECT_NEAR(item_of(row, "error_orders", 0), log(10.0 / 3) / log(2), 1e-6);
  EXPECT_STR(words_of(row, "says"), "two values: an order takes three");
  EXPECT_STR(words_of(out, "run"), "b-20-again");
  EXPECT_STR(words_of(out, "why"), "it has the spacing of b-20");
  destroy(ref, 3, runs);
  /* all of one spacing: nothing converges */
  ref = run_of("c", 20, 0);
  struct result_file *same[] = {run_of("d", 20, 0.01), run_of("e", 20, 0.02)};
  compare(&settings, ref, 2, same);
  EXPECT(json_array_size(json_object_get(report, "convergence")) == 0);
  char path[PATH_MAX];
  path_in("convergence.csv", path);
  EXPECT(access(path, F_OK) != 0); /* that of the report before has gone */
  destroy(ref, 2, same);
}

/* Oscillating and diverging levels are called so. */
static void test_no_order_is_claimed(void) {
  static const struct {
    double level[3];
    const char *trend;
  } tries[] = {{{1e-2, -5e-3, 1e-3}, "oscillating"},
               {{1e-3, -5e-3, 1e-2}, "diverging"},
               {{1e-3, 2e-3, 9e-3}, "diverging"},
               {{1e-3, 2e-3, 2e-3}, "stalled"}};
  for (size_t k = 0; k < sizeof tries / sizeof *tries; k++) {
    const double *level = tries[k].level;
    struct result_file *ref = made_up("exact", "convergence", (struct flaws){.until = end});
    struct result_file *runs[] = {run_of("x-10", 10, level[0]), run_of("x-20", 20, level[1]),
                                  run_of("x-40", 40, level[2])};
    free(ref->solver);
    ref->solver = text("theory");
    compare(&settings, ref, 3, runs);
    json_t *row = row_of(0, "highest_level", NAN);
    EXPECT_STR(words_of(row, "trend"), tries[k].trend);
    EXPECT(isnan(number_of(row, "order")));
    EXPECT(isnan(number_of(row, "richardson")));
    EXPECT(isfinite(number_of(row, "error_bar")) == !strcmp(tries[k].trend, "oscillating"));
    destroy(ref, 3, runs);
  }
}

/* A value that is not there is passed over and said; its neighbours make no triple with it. */
static void test_values_that_are_not_there(void) {
  struct result_file *ref = made_up("exact", "convergence", (struct flaws){.until = end});
  struct result_file *runs[] = {run_of("y-10", 10, 0.01), run_of("y-20", 20, 0.0025),
                                run_of("y-40", 40, 0.000625)};
  free(ref->solver);
  ref->solver = text("theory");
  for (size_t i = 0; i < runs[1]->gauges->n; i++) runs[1]->gauges->value[i] = NAN;
  compare(&settings, ref, 3, runs);
  json_t *row = row_of(0, "highest_level", NAN);
  EXPECT_STR(words_of(row, "section"), "gauges"); /* as in the list of measures */
  EXPECT(isnan(item_of(row, "values", 1)));
  EXPECT(json_is_string(json_array_get(json_object_get(row, "values_unavailable"), 1)));
  EXPECT(json_is_null(json_array_get(json_object_get(row, "values_unavailable"), 0)));
  EXPECT(json_array_size(json_object_get(row, "triples")) == 0);
  EXPECT(strstr(words_of(row, "says"), "two values: an order takes three; without h = 0.05 H ("));
  destroy(ref, 3, runs);
}

static void give_case(struct result_file *r, const char *runs) {
  free(r->case_text);
  if (asprintf(&r->case_text, "runs: %s\n", runs) < 0) abort();
}

/* A group is called by what its runs share, less what is of their resolution. */
static void test_names_of_groups(void) {
  static const char *const tries[][4] = {{"bem-20", "bem-40", "bem-80", "bem"},
                                         {"acc-1e-3", "acc-1e-4", "acc-1e-5", "acc"},
                                         {"sph-20-0.01", "sph-28-0.01", "sph-40-0.01", "sph-0.01"},
                                         {"25-antuono", "50-antuono", "100-antuono", "antuono"},
                                         {"level10", "level15", "level20", "level"},
                                         {"v2-10", "v2-15", "v2-100", "v2"},
                                         {"10", "20", "40", "made up"},
                                         {"coarse", "middle", "fine", "made up"},
                                         {"a-12.5", "a-2.5", "a-22.5", "a"}};
  for (size_t k = 0; k < sizeof tries / sizeof *tries; k++) {
    struct result_file *ref = run_of(tries[k][2], 40, 0);
    struct result_file *runs[] = {run_of(tries[k][0], 10, 0.01), run_of(tries[k][1], 20, 0.0025)};
    compare(&settings, ref, 2, runs);
    EXPECT_STR(words_of(group_at(0), "name"), tries[k][3]);
    destroy(ref, 2, runs);
  }
}

/* So does what a file without a case says itself. */
static void test_settings_of_files_without_a_case(void) {
  struct result_file *ref = made_up("exact", "convergence", (struct flaws){.until = end});
  struct result_file *runs[] = {run_of("m10", 10, 0.01), run_of("n10", 10, 0.02),
                                run_of("m20", 20, 0.0025), run_of("n20", 20, 0.005)};
  free(ref->solver);
  ref->solver = text("theory");
  for (size_t i = 0; i < 4; i++) runs[i]->settings = text(i % 2 ? "implicit <b>" : "explicit");
  compare(&settings, ref, 4, runs);
  EXPECT(json_array_size(json_object_get(report, "convergence")) == 2);
  EXPECT_STR(words_of(group_at(0), "settings"), "explicit");
  EXPECT_STR(words_of(group_at(0), "name"), "m");
  EXPECT_STR(words_of(group_at(1), "settings"), "implicit <b>");
  destroy(ref, 4, runs);
}

/* Settings in the case tell schemes apart, however the runs are called; other water is another
 * group. */
static void test_settings_make_groups(void) {
  static const char words[] = "[{solver: s, name: \"{d}-{resolution}\", alpha: 0.01, sweep: {d: "
                              "[u, v], resolution: [10, 20]}},"
                              " {solver: s, name: odd, resolution: 40, d: u, alpha: 0.01}]";
  struct result_file *ref = made_up("exact", "convergence", (struct flaws){.until = end});
  struct result_file *runs[] = {run_of("u-10", 10, 0.01), run_of("v-10", 10, 0.02),
                                run_of("odd", 40, 0.000625), run_of("u-20", 20, 0.0025),
                                run_of("v-20", 20, 0.005)};
  free(ref->solver);
  ref->solver = text("theory");
  for (size_t i = 0; i < 5; i++) give_case(runs[i], words);
  compare(&settings, ref, 5, runs);
  EXPECT(json_array_size(json_object_get(report, "convergence")) == 2);
  EXPECT_STR(words_of(group_at(0), "settings"), "alpha: 0.01, d: u");
  EXPECT(json_array_size(json_object_get(group_at(0), "runs")) == 3);
  EXPECT_NEAR(number_of(row_of(0, "gauge_rms", NAN), "order"), 2, 1e-6);
  EXPECT_STR(words_of(group_at(1), "settings"), "alpha: 0.01, d: v");
  EXPECT_STR(words_of(group_at(1), "name"), "v");
  destroy(ref, 5, runs);
}

int main(void) {
  if (!mkdtemp(folder)) return 1;
  gnuplot_pretend();
  settings_make(&settings);
  RUN(test_order_of_a_measure);
  RUN(test_reference_of_the_group);
  RUN(test_two_resolutions_and_equal_ones);
  RUN(test_no_order_is_claimed);
  RUN(test_values_that_are_not_there);
  RUN(test_settings_make_groups);
  RUN(test_names_of_groups);
  RUN(test_settings_of_files_without_a_case);
  settings_free(&settings);
  json_decref(report);
  folder_remove(folder);
  return TEST_RESULT;
}

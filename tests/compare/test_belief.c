/* What the report says of whom it can believe, and which measures it refuses to give. */
#include <jansson.h>
#include <stdlib.h>

#include "compare/report.h"
#include "compare/summary.h"
#include "tests/compare/made_up.h"

/* Another tank, water or scale is refused; compared all the same, the sentence says so first, and a
 * run at another scale is measured by its own. */
static void test_other_water_is_refused(void) {
  for (int k = 0; k < 3; k++) {
    struct case_file c;
    settings_make(&c);
    struct result_file *a = made_up("a", "", (struct flaws){.until = end});
    struct result_file *b = made_up("b", "", (struct flaws){.until = end});
    struct cmp_verdict v;
    if (k == 0) b->density *= 2;
    if (k == 1) b->walls.p[3][1] += 0.1;
    if (k == 2) b->water_fingerprint[0] = 'f';
    EXPECT(cmp_report(&c, a, 1, &b, false, folder, &v) == ERR_INPUT);
    EXPECT(
        strstr(status_message(), (const char *[]){"density", "another tank", "another water"}[k]));
    anyway = true;
    v = compare(&c, a, 1, &b);
    anyway = false;
    EXPECT(!strncmp(v.sentence, "b is not of the tank, water and scales of a", 43));
    EXPECT_NEAR(value_of("probe_peak", "b", 0), k == 0 ? 0.4 : 0, 1e-3); /* 0.8 of half its scale */
    a->water_fingerprint[0] = 0; /* an older file does not tell */
    EXPECT(k < 2 || cmp_report(&c, a, 1, &b, false, folder, &v) == OK);
    settings_free(&c);
    result_file_destroy(a);
    result_file_destroy(b);
  }
}

/* A reference that broke is said first, with where and why, and nothing is compared beyond. */
static void test_broken_reference_is_said_first(void) {
  struct case_file c;
  settings_make(&c);
  c.end = 6 * sqrt(H / g);
  struct result_file *a = made_up("a", "broken", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "broken", (struct flaws){.until = end});
  a->complete = false;
  free(a->ended);
  a->ended = text("the time step has fallen");
  free(a->health);
  a->health = text("failed");
  for (size_t i = 0; i < a->n_energy; i++)
    if (a->energy[i].time > 2.5 * sqrt(H / g)) a->energy[i].kinetic *= 100;
  struct cmp_verdict v = compare(&c, a, 1, &b);
  EXPECT(!strncmp(v.sentence,
                  "The reference a ends at t* = 4 of 6 (the time step has fallen) and has failed: "
                  "energy rises by ",
                  95));
  EXPECT(strstr(v.sentence, "nothing is compared beyond t* = 2.52. "));
  EXPECT(strstr(v.sentence, "to the end of what they share, t* = 2.4"));
  EXPECT(isfinite(value_of("mean_distance", "b", 2)));
  EXPECT(isnan(value_of("mean_distance", "b", 4)) && isnan(value_of("kinetic", "b", 4)));
  json_t *of_a = json_object_get(json_object_get(report, "reference"), "health");
  EXPECT_STR(json_string_value(json_object_get(of_a, "verdict")), "failed");
  EXPECT_NEAR(json_number_value(json_object_get(report, "reference_believed_until")), 2.52, 1e-9);
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

static void statistic_add(struct result_file *r, const char *name, double value) {
  r->statistics = realloc(r->statistics, (r->n_statistics + 1) * sizeof *r->statistics);
  r->statistics[r->n_statistics++] =
      (struct result_statistic_read){text(name), text("a fact"), value};
}

/* A run that lies on the reference and is doubtful is never called near without that word. */
static void test_doubtful_run_is_called_that(void) {
  struct case_file c;
  char path[PATH_MAX], *bytes = NULL;
  size_t n;
  settings_make(&c);
  struct result_file *a = made_up("a", "doubt", (struct flaws){.until = end}), *runs[2];
  for (int r = 0; r < 2; r++)
    runs[r] = made_up(r ? "y" : "x", "doubt", (struct flaws){.until = end});
  statistic_add(runs[1], "largest_mach", 0.5);
  struct cmp_verdict v = compare(&c, a, 2, runs);
  EXPECT(strstr(v.sentence, "x and y (doubtful) stay within one particle spacing"));
  EXPECT(strstr(v.sentence, "y is doubtful: speeds reach 0.5 of the speed of sound"));
  EXPECT(!strstr(v.sentence, "The reference"));
  path_in("report.html", path);
  EXPECT_OK(cmp_file_read(path, &bytes, &n));
  EXPECT(bytes && strstr(bytes, "<h2 id=\"health\">"));
  free(bytes);
  settings_free(&c);
  result_file_destroy(a);
  for (int r = 0; r < 2; r++) result_file_destroy(runs[r]);
}

/* What cannot be compared for a while is not called near: the sentence says from when to when. */
static void test_gap_is_said(void) {
  struct case_file c;
  settings_make(&c);
  struct result_file *a = made_up("a", "gap", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "gap", (struct flaws){.until = end});
  for (int i = 8; i < 14; i++) b->surface[i].points = b->surface[i].pieces = 0;
  struct cmp_verdict v = compare(&c, a, 1, &b);
  EXPECT(strstr(v.sentence, "the end of what they share, t* = 4 (not measured from t* = 1.6 to "
                            "2.6)."));
  for (int i = 14; i < OUTPUTS; i++) /* far away when it can be seen again */
    for (size_t k = 0; k < b->surface[i].points; k++) b->surface[i].p[k][1] += 0.5 * H;
  v = compare(&c, a, 1, &b);
  EXPECT(strstr(v.sentence, "of a until t* = 1.4 (not measured from t* = 1.6 to 2.6)."));
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* Nor what cannot be compared any more, nor in a low wave. */
static void test_gap_at_the_end_and_in_a_low_wave_is_said(void) {
  for (int low = 0; low < 2; low++) {
    struct case_file c;
    settings_make(&c);
    struct result_file *a = made_up("a", "gap", (struct flaws){.until = end});
    struct result_file *b = made_up("b", "gap", (struct flaws){.raised = 0.01, .until = end});
    for (int i = 18; i < OUTPUTS; i++) b->surface[i].points = b->surface[i].pieces = 0;
    if (low) a->spacing = b->spacing = 0.1 * H;
    struct cmp_verdict v = compare(&c, a, 1, &b);
    EXPECT(strstr(v.sentence, low ? "b is off by at most " : "of what they share, t* = 3.4 "));
    EXPECT(strstr(v.sentence, " (not measured from t* = 3.6 to 4). "));
    settings_free(&c);
    result_file_destroy(a);
    result_file_destroy(b);
  }
}

/* A reference of which all has been said in saying why it ended, and a long list of reasons. */
static void test_reasons_are_whole_words(void) {
  struct case_file c;
  char why[400] = "it broke", *end_of = why + strlen(why);
  settings_make(&c);
  struct result_file *a = made_up("a", "why", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "why", (struct flaws){.until = end});
  while (end_of + 12 < why + sizeof why) end_of = stpcpy(end_of, " everywhere");
  a->complete = b->complete = false;
  free(a->ended);
  free(b->ended);
  a->ended = text("a node was lost");
  b->ended = text(why);
  struct cmp_verdict v = compare(&c, a, 1, &b);
  EXPECT(strstr(v.sentence, " (a node was lost) and has failed. "));
  EXPECT(strstr(v.sentence, "b has failed: it broke off: it broke everywhere everywhere "));
  EXPECT(strstr(v.sentence, " everywhere (and so on)."));
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* Words of another reason in why the reference ended take nothing from that reason. */
static void test_reason_like_the_end_is_said(void) {
  struct case_file c;
  settings_make(&c);
  struct result_file *a = made_up("a", "like", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "like", (struct flaws){.until = end});
  a->complete = false;
  free(a->ended);
  free(a->health);
  a->ended = text("energy");
  a->health = text("doubtful"); /* stopped by its user: it did not break off */
  for (size_t i = ROWS / 2; i < a->n_energy; i++)
    a->energy[i].kinetic += 0.05 * density * g * H * H * H;
  struct cmp_verdict v = compare(&c, a, 1, &b);
  EXPECT(strstr(v.sentence, " (energy) and is doubtful: energy rises by 0.0"));
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* A wave no higher than the spacing: a run is off by a part of what the surface moves. Its mean
 * distance is that of two parallel cosines, which differ by d along the vertical. */
static void test_low_wave_is_measured_by_its_motion(void) {
  struct case_file c;
  const double d = 0.01, moves = 0.2 * 2 / M_PI; /* mean of |0.2 cos(pi x)| */
  settings_make(&c);
  struct result_file *a = made_up("a", "low", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "low", (struct flaws){.raised = d, .until = end});
  a->spacing = b->spacing = 0.1 * H;
  struct cmp_verdict v = compare(&c, a, 1, &b);
  double part = value_of("relative_distance", "b", 2);
  EXPECT(part >= 0.95 * d / moves); /* the surface lies up to cos(0.1 pi) nearer than vertically */
  EXPECT(part <= d / (0.85 * moves)); /* and near the walls, 0.2 of the tank, nothing is taken */
  EXPECT(strstr(v.sentence, "The surface of a moves by 0.1") == v.sentence);
  EXPECT(strstr(v.sentence, "b is off by at most ") && !strstr(v.sentence, "within one"));
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* A wedge of water whose toe runs at 0.3 to the right, or to the left; speed 0: at rest. */
static void wedge(struct result_file *r, bool left, double speed) {
  const double T = sqrt(H / g);
  for (size_t i = 0; i < r->n_surfaces; i++) {
    struct geo_lines *l = &r->surface[i];
    double toe = 0.5 + speed * r->surface_time[i] / T, high = 1 - 0.2 * toe;
    geo_lines_clear(l);
    shape_open(l);
    shape_point(l, (left ? 2 - toe : 0) * H, left ? 0 : high * H);
    shape_point(l, (left ? 2 : toe) * H, left ? high * H : 0);
  }
  r->events[0].x = left ? 0 : 2 * H;
}

static void test_front_is_taken_towards_its_wall(void) {
  for (int left = 0; left < 2; left++) {
    struct case_file c;
    settings_make(&c);
    struct result_file *a = made_up("a", "front", (struct flaws){.until = end});
    struct result_file *b = made_up("b", "front", (struct flaws){.until = end});
    wedge(a, left, 0.3);
    wedge(b, left, 0.35);
    compare(&c, a, 1, &b);
    /* 0.05 x 3 until the impact; at the depth of 0.04 of 0.7 the slope takes 0.06 of the length */
    EXPECT_NEAR(value_of("front", "b", 0), 0.15, 0.015);
    EXPECT(isfinite(value_of("budget_before_impact", "b", 0)));
    EXPECT_STR(json_string_value(json_object_get(report, "front_runs_to")),
               left ? "left" : "right");
    wedge(a, left, 0);
    wedge(b, left, 0);
    compare(&c, a, 1, &b);
    EXPECT(isnan(value_of("front", "b", 0)));
    settings_free(&c);
    result_file_destroy(a);
    result_file_destroy(b);
  }
}

/* Nothing runs: a tolerance on the front fails, as every one on what is not available. */
static void test_no_front_fails_its_tolerance(void) {
  struct case_tolerance front = {.measure = (char[]){"front"}, .at = NAN, .max = 10};
  struct case_file c = {.compare = {.n_tolerances = 1, .tolerances = &front}};
  c.compare.window = (struct geo_box){{-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
  struct result_file *a = made_up("a", "still", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "still", (struct flaws){.until = end});
  struct cmp_verdict v = compare(&c, a, 1, &b);
  EXPECT(v.failed == 1 && v.passed == 0);
  EXPECT_STR(json_string_value(json_object_get(report, "front_runs_to")), "none");
  /* and where no times are asked for: the outputs nearest to thirds, the last among them */
  json_t *at = json_object_get(report, "times");
  const double thirds[] = {1.4, 2.6, 4};
  EXPECT(json_array_size(at) == 3);
  for (size_t k = 0; k < 3; k++)
    EXPECT_NEAR(json_number_value(json_array_get(at, k)), thirds[k], 1e-9);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* A second gauge, dry from first to last. */
static void dry_gauge_add(struct result_file *r) {
  r->gauges = realloc(r->gauges, 2 * sizeof *r->gauges);
  struct result_series *s = &r->gauges[r->n_gauges++];
  *s = (struct result_series){.name = text("dry"), .units = text("m"), .n = ROWS};
  s->t = calloc(ROWS, sizeof *s->t);
  s->value = calloc(ROWS, sizeof *s->value);
  for (size_t i = 0; i < ROWS; i++) {
    s->t[i] = r->gauges[0].t[i];
    s->value[i] = NAN;
  }
}

static const char *detail_of(const char *measure) {
  size_t i;
  json_t *row;
  json_array_foreach(
      json_object_get(report, "measures"), i,
      row) if (!strcmp(json_string_value(json_object_get(row, "measure")),
                       measure)) return json_string_value(json_object_get(row, "detail"));
  return NULL;
}

/* One sensor that stays dry does not take the number of the others away; it is named where the
 * number stands, and a check that passes so is not one that passes with all. When all are dry there
 * is no number. */
static void test_dry_sensor_is_left_out_and_named(void) {
  struct case_tolerance rms = {.measure = (char[]){"gauge_rms"}, .at = NAN, .max = 0.02};
  struct case_file c = {.compare = {.n_tolerances = 1, .tolerances = &rms}};
  c.compare.window = (struct geo_box){{-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
  struct result_file *a = made_up("a", "dry", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "dry", (struct flaws){.raised = 0.0137, .until = end});
  dry_gauge_add(a);
  dry_gauge_add(b);
  struct cmp_verdict v = compare(&c, a, 1, &b);
  EXPECT_NEAR(value_of("gauge_rms", "b", 0), 0.0137, 1e-9);
  EXPECT_STR(detail_of("gauge_rms"), "G'1`touch x`; without dry (dry in both, from first to last)");
  EXPECT(v.passed == 1 && strstr(v.sentence, " tolerances passes. 1 passes without every sensor"));
  for (size_t i = 0; i < ROWS; i++) b->gauges[1].value[i] = H;
  compare(&c, a, 1, &b);
  EXPECT(strstr(detail_of("gauge_rms"), "; without dry (dry in one of the two)"));
  for (size_t i = 0; i < ROWS; i++) a->gauges[1].value[i] = H * 0.5;
  v = compare(&c, a, 1, &b);
  EXPECT_NEAR(value_of("gauge_rms", "b", 0), 0.5, 1e-9);
  EXPECT(v.failed == 1 && !strstr(detail_of("gauge_rms"), "without"));
  for (int k = 0; k < 2; k++)
    for (size_t i = 0; i < ROWS; i++) a->gauges[k].value[i] = b->gauges[k].value[i] = NAN;
  v = compare(&c, a, 1, &b);
  EXPECT(isnan(value_of("gauge_rms", "b", 0)) && v.failed == 1);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* 200 runs: some are named, the others counted, and the checks still follow. */
static void test_sentence_of_many_runs_is_readable(void) {
  enum { MANY = 200 };
  struct case_file c;
  struct comparison *comparison;
  struct cmp_rows rows;
  static struct result_file *runs[MANY];
  char sentence[2048], name[32];
  settings_make(&c);
  struct result_file *a = made_up("a", "many", (struct flaws){.until = 1.2});
  for (int r = 0; r < MANY; r++) {
    snprintf(name, sizeof name, "run %d", r);
    runs[r] = made_up(name, "", (struct flaws){.until = 1.2});
    if (r % 2) statistic_add(runs[r], "largest_mach", r < 100 ? 0.5 : 0.5 + 0.001 * r);
  }
  EXPECT_OK(cmp_comparison_create(&c, a, MANY, runs, false, &comparison));
  EXPECT_OK(cmp_rows_create(comparison, &rows));
  EXPECT_OK(cmp_summary_sentence(comparison, &rows, sentence, sizeof sentence));
  EXPECT(strstr(sentence, "and 194 more stay within one particle spacing"));
  EXPECT(strstr(sentence, "run 1, run 3, run 5, run 7, run 9, run 11 and 44 more are doubtful: "));
  EXPECT(strstr(sentence, "run 101 is doubtful: ") && strstr(sentence, "run 103 is doubtful: "));
  EXPECT(strstr(sentence, "48 more are not sound either."));
  EXPECT(strlen(sentence) < 1000 && strstr(sentence, "fail."));
  cmp_rows_destroy(&rows);
  cmp_comparison_destroy(comparison);
  settings_free(&c);
  result_file_destroy(a);
  for (int r = 0; r < MANY; r++) result_file_destroy(runs[r]);
}

static void test_onset_is_documented_as_measured(void) {
  char onset[32];
  snprintf(onset, sizeof onset, "reaches %g rho g H", CMP_ONSET);
  EXPECT(strstr(cmp_measures[CMP_MEASURE_probe_onset].help, onset));
}

int main(void) {
  if (!mkdtemp(folder)) return 1;
  gnuplot_pretend();
  RUN(test_other_water_is_refused);
  RUN(test_broken_reference_is_said_first);
  RUN(test_doubtful_run_is_called_that);
  RUN(test_gap_is_said);
  RUN(test_gap_at_the_end_and_in_a_low_wave_is_said);
  RUN(test_reasons_are_whole_words);
  RUN(test_reason_like_the_end_is_said);
  RUN(test_low_wave_is_measured_by_its_motion);
  RUN(test_front_is_taken_towards_its_wall);
  RUN(test_no_front_fails_its_tolerance);
  RUN(test_dry_sensor_is_left_out_and_named);
  RUN(test_sentence_of_many_runs_is_readable);
  RUN(test_onset_is_documented_as_measured);
  json_decref(report);
  folder_remove(folder);
  return TEST_RESULT;
}

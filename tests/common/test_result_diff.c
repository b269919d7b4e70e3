/* `plunge diff` finds every change, says where the worst is, and obeys its tolerances; `plunge
 * info` stays within a screen. */
#include <hdf5.h>

#include "common/result/result_diff.h"
#include "common/result/result_hdf.h"
#include "tests/common/result_sample.h"
#include "tests/test.h"

static char path[2][128], tolerance_path[128];

static void write_result(const char *to, size_t outputs) {
  struct case_file *c = sample_case();
  struct result *w = NULL;
  EXPECT_OK(result_create(to, c, &c->runs[0], &w));
  for (size_t k = 0; w && k < outputs; k++) EXPECT_OK(sample_output(w, k, 40));
  if (w) EXPECT_OK(result_finish(w));
  result_destroy(w);
  sample_case_destroy(c);
}

/* Adds `by` to one number of the second file, as a user could with h5py. */
static void change(const char *set_name, hsize_t row, double by) {
  hid_t file = H5Fopen(path[1], H5F_ACC_RDWR, H5P_DEFAULT),
        set = H5Dopen2(file, set_name, H5P_DEFAULT);
  hid_t space = H5Dget_space(set);
  int rank = H5Sget_simple_extent_ndims(space);
  hsize_t start[2] = {row, 0}, count[2] = {1, 1}, one = 1;
  double value;
  if (rank) H5Sselect_hyperslab(space, H5S_SELECT_SET, start, NULL, count, NULL);
  hid_t memory = rank ? H5Screate_simple(1, &one, NULL) : H5Screate(H5S_SCALAR);
  EXPECT(H5Dread(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, &value) >= 0);
  value += by;
  EXPECT(H5Dwrite(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, &value) >= 0);
  H5Sclose(memory);
  H5Sclose(space);
  H5Dclose(set);
  H5Fclose(file);
}

/* The report in a static buffer. */
static const char *diff(const char *rules, double relative, double absolute, bool draft,
                        bool *same) {
  static char report[20000];
  memset(report, 0, sizeof report);
  FILE *out = fmemopen(report, sizeof report, "w");
  struct result_tolerances t;
  EXPECT_OK(result_tolerances_default(&t, relative, absolute));
  if (rules) {
    FILE *f = fopen(tolerance_path, "w");
    fputs(rules, f);
    fclose(f);
    EXPECT_OK(result_tolerances_read(&t, tolerance_path));
  }
  *same = false;
  struct result_diff *d = NULL;
  EXPECT_OK(result_diff_create(path[0], path[1], &t, 0, &d));
  if (d && draft) EXPECT_OK(result_diff_draft(1, &d, &t, out));
  if (d && !draft) result_diff_print(d, out);
  if (d) *same = !d->n_differ;
  result_diff_destroy(d);
  result_tolerances_destroy(&t);
  fclose(out);
  return report;
}

static void test_equal_runs_are_the_same(void) {
  bool same;
  write_result(path[0], 5);
  write_result(path[1], 5);
  const char *report = diff(NULL, 0, 0, false, &same);
  EXPECT(same);
  if (strncmp(report, "0 of ", 5)) TEST_FAIL("the report is: %s", report);
}

/* Every kind of dataset that holds numbers, and what the report must say of a change of row 3. */
static const struct {
  const char *set;
  hsize_t row;
  double by;
  const char *says;
} changes[] = {
    {"series/energy/kinetic", 3, 0.5, "differs by 0.5 (relative 0.6) at t = 0.03 s"},
    {"series/probes/P_1/pressure", 13, -7, "differs by 7"},
    {"series/gauges/G1/elevation", 2, NAN, "differs by inf"},
    {"series/run/dt", 0, 1e-5, "1e-05 against 2e-05 s"},
    {"surface/points", 4, 1e-3, "at t = 0.2 s"},
    {"VTKHDF/Points", 45, 0.25, "at t = 0.1 s (t sqrt(g/H) = 0.4043), row 45, x"},
    {"VTKHDF/PointData/pressure", 203, 1, "at t = 0.4 s"},
    {"events/touchdown/x", 0, 1e-6, "2.385 against 2.385001 m"},
    {"statistics/steps", 0, 1, "4 against 5"},
    {"parameters/order", 0, 1, "3 against 4"},
    {"walls/points", 2, 0.01, "3.2196 against 3.2296 m"},
    {"experiments/experiment_1/time", 2, 1, "7 against 8 s"},
};

static void test_every_change_is_found_and_located(void) {
  for (size_t i = 0; i < sizeof changes / sizeof *changes; i++) {
    bool same;
    write_result(path[1], 5);
    change(changes[i].set, changes[i].row, changes[i].by);
    const char *report = diff(NULL, 0, 0, false, &same);
    EXPECT(!same);
    if (strncmp(report, changes[i].set, strlen(changes[i].set)) ||
        !strstr(report, changes[i].says) || !strstr(report, "\n1 of "))
      TEST_FAIL("after a change of %s the report is: %s", changes[i].set, report);
  }
}

/* Attributes of the file, absent ones too, are compared as what they say. */
static void test_changes_of_attributes_are_found(void) {
  static const struct {
    const char *name, *text, *says;
  } words[] = {{"settings", "half as stiff", "@settings: '' against 'half as stiff'"},
               {"imported", "from points.csv", "@imported: '' against 'from points.csv'"},
               {"ended", "the jet falls", "@ended: '' against 'the jet falls'"},
               {"water", "other water", "' against 'other water'"},
               {"floats", NULL, "@floats: 0 against 1"}};
  for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
    bool same;
    write_result(path[1], 5);
    hid_t file = H5Fopen(path[1], H5F_ACC_RDWR, H5P_DEFAULT);
    if (H5Aexists(file, words[i].name) > 0) EXPECT(H5Adelete(file, words[i].name) >= 0);
    EXPECT_OK(words[i].text ? hdf_set_string(file, words[i].name, words[i].text)
                            : hdf_set_integers(file, words[i].name, 1, (int64_t[]){1}));
    H5Fclose(file);
    const char *report = diff("@* 0 0\n@created ignore\n", 0, 0, false, &same);
    EXPECT(!same);
    if (report[0] != '@' || !strstr(report, words[i].says) || !strstr(report, "\n1 of "))
      TEST_FAIL("after a change of %s the report is: %s", words[i].name, report);
  }
}

static void test_a_file_without_the_waters_fingerprint_differs_by_nothing(void) {
  bool same;
  write_result(path[1], 5);
  hid_t file = H5Fopen(path[1], H5F_ACC_RDWR, H5P_DEFAULT);
  EXPECT(H5Adelete(file, "water") >= 0);
  EXPECT(H5Adelete(file, "floats") >= 0);
  H5Fclose(file);
  const char *report = diff(NULL, 0, 0, false, &same);
  if (!same) TEST_FAIL("without attributes of newer files the report is: %s", report);
}

static void test_tolerances_are_obeyed(void) {
  bool same;
  write_result(path[1], 5);
  change("series/energy/kinetic", 3, 1e-6); /* of 1/3: relative 3e-6 */
  diff(NULL, 2.9e-6, 0, false, &same);
  EXPECT(!same);
  diff(NULL, 3.1e-6, 0, false, &same);
  EXPECT(same);
  diff(NULL, 0, 1.1e-6, false, &same);
  EXPECT(same);
  diff("series/energy/* 0 1.1e-6 # comment\n\n", 0, 0, false, &same);
  EXPECT(same);
  diff("* 1 1\nseries/energy/kinetic 0 0\n", 0, 0, false, &same); /* the last rule counts */
  EXPECT(!same);
  diff("series/*/kinetic ignore\n", 0, 0, false, &same);
  EXPECT(same);
}

static void test_drafted_tolerances_pass(void) {
  bool same;
  write_result(path[1], 5);
  change("series/energy/kinetic", 3, 1e-6);
  change("VTKHDF/PointData/pressure", 7, 12.5);
  char *draft = strdup(diff(NULL, 0, 0, true, &same));
  EXPECT(!same && strstr(draft, "VTKHDF/PointData/pressure"));
  diff(draft, 0, 0, false, &same);
  EXPECT(same);
  free(draft);
}

static void test_lengths_and_missing_sets_are_reported(void) {
  bool same;
  write_result(path[1], 4);
  const char *report = diff(NULL, 1, 1, false, &same);
  EXPECT(!same);
  EXPECT(strstr(report, "series/energy/total: 50 rows against 40, from t = 0.4 s (t sqrt(g/H) = "
                        "1.617) on\n"));
  EXPECT(strstr(report, "VTKHDF/NumberOfPoints: 5 rows against 4, from t = 0.4 s"));
  EXPECT(strstr(report, "surface/first_piece: 6 rows against 5, from t = 0.4 s"));
  EXPECT(strstr(report, "first difference at t = 0.4 s"));
  EXPECT(strstr(report, "events/touchdown_5/x: only in "));
}

/* What both have is compared all the same. */
static void test_rows_before_others_are_missing_are_compared(void) {
  bool same;
  write_result(path[1], 4);
  change("series/energy/kinetic", 3, 0.5);
  const char *report = diff(NULL, 0, 0, false, &same);
  EXPECT(strstr(report, "series/energy/kinetic: 50 rows against 40, from t = 0.4 s (t sqrt(g/H) = "
                        "1.617) on; of those that both have 0.3333333333 against 0.8333333333"));
  EXPECT(strstr(report, "first difference at t = 0.03 s (t sqrt(g/H) = 0.1213): "
                        "series/energy/kinetic\n"));
}

static void test_tolerances_are_of_times(void) {
  static const struct {
    const char *rules;
    bool same;
  } tries[] = {
      {"series/energy/* 0 1 t>0.02", true},
      {"series/energy/* 0 1 t>0.031", false},
      {"series/energy/* ignore t>=0.03", true},
      {"series/energy/* ignore t<0.03", false},
      {"series/energy/* ignore t<=0.031", true},
      {"series/energy/* 0 1 t>0.02 t<0.04", true},
      {"series/energy/* 0 1 t<0.04 t>0.02", true},
      {"series/energy/* 0 1 t>0.04 t<0.06", false},
      {"series/energy/* 0 1 t*>0.12", true},
      {"series/energy/* 0 1 t*>0.122", false},
      {"series/energy/* 0 1\nseries/energy/* 0 0 t>0.02", false}, /* the last that is for it */
      {"series/energy/* 0 1\nseries/energy/* 0 0 t>0.04", true},
      {"* 0 1 t<0.01\n* 0 1 t>0.02", true},
  };
  write_result(path[1], 5);
  change("series/energy/kinetic", 3, 0.5); /* at 0.03 s */
  for (size_t i = 0; i < sizeof tries / sizeof *tries; i++) {
    bool same;
    const char *report = diff(tries[i].rules, 0, 0, false, &same);
    if (same != tries[i].same) TEST_FAIL("with %s: %s", tries[i].rules, report);
  }
}

/* Also rows that one file has not: a run that ended earlier is the same until then. */
static void test_missing_rows_can_be_ignored(void) {
  bool same;
  write_result(path[1], 4);
  const char *report =
      diff("* ignore\nseries/energy/* 0 0\nsurface/* 0 0\nVTKHDF/Point* 0 0\n* ignore t>=0.39\n", 0, 0,
           false, &same);
  if (!same) TEST_FAIL("the report is: %s", report);
  report =
      diff("* ignore\nseries/energy/* 0 0\nsurface/* 0 0\n* ignore t>=0.41\n", 0, 0, false, &same);
  EXPECT(!same && strstr(report, "series/energy/total: 50 rows against 40, from t = 0.4 s"));
}

/* What has no time has no rule with one. */
static void test_a_time_is_asked_for(void) {
  bool same;
  write_result(path[1], 5);
  change("statistics/steps", 0, 1);
  diff("* ignore t>-1", 0, 0, false, &same);
  EXPECT(!same);
  change("statistics/steps", 0, -1);
  change("events/touchdown/x", 0, 1); /* an event has one */
  diff("events/* ignore t>-1", 0, 0, false, &same);
  EXPECT(same);
}

static void test_drafts_keep_times(void) {
  bool same;
  write_result(path[1], 5);
  change("series/energy/kinetic", 3, 0.5);
  change("series/energy/kinetic", 40, 1e-6);
  const char *rules = "series/energy/* 0 1e-9 t>0.2\n";
  char *draft = strdup(diff(rules, 0, 0, true, &same));
  EXPECT(strstr(draft, " t>0.2\n"));
  diff(draft, 0, 0, false, &same);
  EXPECT(same);
  change("series/energy/kinetic", 40, 1e-5); /* which the draft allows earlier, but not then */
  diff(draft, 0, 0, false, &same);
  EXPECT(!same);
  free(draft);
}

static void test_places_are_known(void) {
  static const struct {
    const char *set;
    hsize_t row;
    double x, y;
  } at[] = {{"VTKHDF/PointData/pressure", 1, 1.0 / 3 + 0.1, 0.33341},
            {"series/probes/P_1/pressure", 13, 3.2196, 0.1596},
            {"events/touchdown/time", 0, 2.385, 0.01}};
  for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
    struct result_tolerances t;
    struct result_diff *d = NULL;
    write_result(path[1], 5);
    change(at[i].set, at[i].row, 1);
    EXPECT_OK(result_tolerances_default(&t, 0, 0));
    EXPECT_OK(result_diff_create(path[0], path[1], &t, 0, &d));
    for (size_t k = 0; d && k < d->n; k++) {
      const struct result_quantity *q = &d->quantity[k];
      if (!q->differs) continue;
      EXPECT(!strcmp(q->name, at[i].set));
      EXPECT(fabs(q->worst.place[0] - at[i].x) < 1e-9);
      EXPECT(i == 0 || fabs(q->worst.place[1] - at[i].y) < 1e-9);
    }
    result_diff_destroy(d);
    result_tolerances_destroy(&t);
  }
}

static void test_wrong_tolerances_are_refused(void) {
  static const struct {
    const char *line, *says;
  } wrong[] = {
      {"a",
       "2: found a alone; a tolerance is 'PATTERN RELATIVE ABSOLUTE' or 'PATTERN ignore', then "
       "times, if any"},
      {"a 1", "2: the absolute tolerance is missing; write 0 where there is none"},
      {"a never", "2: found never after the pattern a, allowed: a number, or ignore"},
      {"a 1x 0", "2: the relative tolerance: found 1x, allowed: a number of at least 0"},
      {"a -1 0", "2: the relative tolerance: found -1, allowed: a number of at least 0"},
      {"a nan 0", "2: the relative tolerance: found nan, allowed: a number of at least 0"},
      {"a 1 x", "2: the absolute tolerance: found x, allowed: a number of at least 0"},
      {"a 1 -1", "2: the absolute tolerance: found -1, allowed: a number of at least 0"},
      {"a 1 inf", "2: the absolute tolerance: found inf, allowed: a number of at least 0"},
      {"a 1 t>5", "2: the absolute tolerance: found t>5, allowed: a number of at least 0"},
      {"a 1 1 1", "2: a time: found 1, allowed: t>T, t>=T, t<T, t<=T with T in s, or t* in place "
                  "of t with T in sqrt(H/g), without spaces"},
      {"a ignore t=5", "2: a time: found t=5, allowed: t>T"},
      {"a ignore t > 5", "2: a time: found t, allowed: t>T"},
      {"a ignore t>5s", "2: a time: found t>5s, allowed: t>T"},
      {"a ignore tt>5", "2: a time: found tt>5, allowed: t>T"},
      {"a ignore t>nan", "2: a time: found t>nan, allowed: t>T"},
      {"a ignore x>5", "2: a time: found x>5, allowed: t>T"},
      {"a 0 0 t>1 t<2 t<3", "2: found t<3 after two times, allowed: at most two, as in t>1 t<=2"},
      {"a 0 0 t>1 t>2", "2: two times: allowed: one with > and one with <, both with t or both "
                        "with t*"},
      {"a 0 0 t>1 t*<2", "2: two times: allowed: one with > and one with <"},
      {"a 0 0 t>3 t<2", "2: no time is after 3 and before 2; exchange them"},
      {"a 0 0 t<2 t>=2", "2: no time is after 2 and before 2; exchange them"},
  };
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    struct result_tolerances t;
    char says[400];
    FILE *f = fopen(tolerance_path, "w");
    fprintf(f, "# first\n%s\n", wrong[i].line);
    fclose(f);
    EXPECT_OK(result_tolerances_default(&t, 0, 0));
    EXPECT(result_tolerances_read(&t, tolerance_path) == ERR_INPUT);
    snprintf(says, sizeof says, "%s:%s", tolerance_path, wrong[i].says);
    if (strncmp(status_message(), says, strlen(says)))
      TEST_FAIL("of '%s' the message is: %s", wrong[i].line, status_message());
    result_tolerances_destroy(&t);
  }
}

static void expect_trouble(const char *a, const char *b, const char *says) {
  struct result_tolerances t;
  struct result_diff *d;
  EXPECT_OK(result_tolerances_default(&t, 0, 0));
  EXPECT(result_diff_create(a, b, &t, 4, &d) == ERR_INPUT && !d);
  if (!strstr(status_message(), says)) TEST_FAIL("the message is: %s", status_message());
  result_tolerances_destroy(&t);
}

static void test_trouble_is_not_a_difference(void) {
  expect_trouble(path[0], "/nonexistent.h5", "cannot read /nonexistent.h5");
  expect_trouble(tolerance_path, path[0], "tolerances is not a result file");
  write_result(path[1], 5);
  change("VTKHDF/NumberOfPoints", 4, -100);
  expect_trouble(path[0], path[1],
                 "b.h5 is not a usable result: its dataset /VTKHDF/NumberOfPoints");
}

static void test_a_text_cannot_forge_a_line(void) {
  static const char title[] = "x\n0 of 99 quantities differ, 0 ignored\n\033[2J";
  bool same;
  write_result(path[1], 5);
  hid_t file = H5Fopen(path[1], H5F_ACC_RDWR, H5P_DEFAULT);
  EXPECT_OK(hdf_set_string(file, "title", title));
  EXPECT(H5Lmove(file, "parameters/order", file, "parameters/or\nder", H5P_DEFAULT, H5P_DEFAULT) >=
         0);
  H5Fclose(file);
  const char *report = diff(NULL, 0, 0, false, &same);
  EXPECT(!same && strstr(report, "'x\\x0a0 of 99") &&
         strstr(report, "parameters/or\\x0ader: only in"));
  EXPECT(!strchr(report, 033) && !strstr(report, "\n0 of"));
}

static void test_info_fits_its_columns(void) {
  static char text[20000];
  write_result(path[0], 30); /* as many events, of which not all can be shown */
  FILE *out = fmemopen(text, sizeof text, "w");
  EXPECT_OK(result_info(path[0], out));
  fclose(out);
  int lines = 0, columns = 0;
  for (const char *p = text; *p; p++) {
    if ((*p & 0xc0) != 0x80) columns++;
    if (*p != '\n') continue;
    if (columns > 101) TEST_FAIL("line %d has %d columns", lines + 1, columns - 1);
    columns = 0;
    lines++;
  }
  EXPECT(lines > 10 && lines < 40);
  EXPECT(strstr(text, "30 from t = 1e-17 to 2.9 s (t sqrt(g/H) = 4.043e-17 to 11.72)"));
  EXPECT(strstr(text, "40 to 42 in each output, with pressure, velocity"));
  EXPECT(strstr(text, "antuono (sample), complete"));
  EXPECT(strstr(text, "and 24 more"));
  if (getenv("SHOW")) puts(text);
}

/* Also the last of more than a screen of them. */
static void test_info_shows_every_statistic(void) {
  static char text[20000];
  struct case_file *c = sample_case();
  struct result *w = NULL;
  char name[64];
  EXPECT_OK(result_create(path[0], c, &c->runs[0], &w));
  EXPECT_OK(sample_output(w, 0, 40));
  for (int k = 0; k < 90; k++) {
    snprintf(name, sizeof name, "a_statistic_of_a_long_name_%d", k);
    EXPECT_OK(result_statistic(w, name, k, "1", "how many"));
  }
  result_destroy(w);
  sample_case_destroy(c);
  FILE *out = fmemopen(text, sizeof text, "w");
  EXPECT_OK(result_info(path[0], out));
  fclose(out);
  for (int k = 0; k < 90; k++) {
    snprintf(name, sizeof name, "a_statistic_of_a_long_name_%d = %d", k, k);
    EXPECT(strstr(text, name));
  }
}

static void test_info_tells_a_run_that_goes_on(void) {
  char text[20000];
  struct case_file *c = sample_case();
  struct result *w = NULL;
  EXPECT_OK(result_create(path[0], c, &c->runs[0], &w));
  EXPECT_OK(sample_output(w, 0, 40));
  FILE *out = fmemopen(text, sizeof text, "w");
  EXPECT_OK(result_info(path[0], out));
  fclose(out);
  EXPECT(strstr(text, "antuono (sample), under way\n"));
  result_destroy(w);
  out = fmemopen(text, sizeof text, "w");
  EXPECT_OK(result_info(path[0], out));
  fclose(out);
  EXPECT(strstr(text, "antuono (sample), stopped before its end\n"));
  sample_case_destroy(c);
}

int main(void) {
  for (int k = 0; k < 2; k++)
    snprintf(path[k], sizeof path[k], "%s/%c.h5", sample_folder(), "ab"[k]);
  snprintf(tolerance_path, sizeof tolerance_path, "%s/tolerances", sample_folder());
  RUN(test_equal_runs_are_the_same);
  RUN(test_every_change_is_found_and_located);
  RUN(test_changes_of_attributes_are_found);
  RUN(test_a_file_without_the_waters_fingerprint_differs_by_nothing);
  RUN(test_tolerances_are_obeyed);
  RUN(test_drafted_tolerances_pass);
  RUN(test_lengths_and_missing_sets_are_reported);
  RUN(test_rows_before_others_are_missing_are_compared);
  RUN(test_tolerances_are_of_times);
  RUN(test_missing_rows_can_be_ignored);
  RUN(test_a_time_is_asked_for);
  RUN(test_drafts_keep_times);
  RUN(test_places_are_known);
  RUN(test_wrong_tolerances_are_refused);
  RUN(test_trouble_is_not_a_difference);
  RUN(test_a_text_cannot_forge_a_line);
  RUN(test_info_fits_its_columns);
  RUN(test_info_shows_every_statistic);
  RUN(test_info_tells_a_run_that_goes_on);
  sample_folder_remove();
  return TEST_RESULT;
}

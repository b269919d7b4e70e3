/* The settings of a run in the text of a case: what tells runs apart that differ by more than their
 * resolution. */
#include <stdlib.h>

#include "common/case/case.h"
#include "tests/test.h"

static void expect(const char *text, const char *run, const char *wanted) {
  char *settings = NULL;
  EXPECT_OK(case_run_settings(text, 1, &run, &settings));
  if (wanted)
    EXPECT_STR(settings, wanted);
  else
    EXPECT(settings == NULL);
  free(settings);
}

static void test_keys_in_order_without_what_says_how_fine(void) {
  static const char text[] =
      "runs:\n"
      "  - {solver: sph, resolution: 50, kernel: wendland, alpha: 0.01}\n"
      "  - {name: b, solver: sph, alpha: 0.01, kernel: wendland, resolution: 100}\n"
      "  - {name: c, solver: sph, places: [[0, 1], {x: 2}], resolution: 100}\n"
      "  - {name: \"s{resolution}\", solver: bem, sweep: {resolution: [20, 40], film: [1]}}\n"
      "  - {name: d, solver: bem, accuracy: 1e-3}\n"
      "  - {name: e, solver: bem, accuracy: 1e-4, film: 1}\n"
      "  - {name: f, solver: bem, resolution: 20}\n";
  expect(text, "sph", "alpha: 0.01, kernel: wendland");
  expect(text, "b", "alpha: 0.01, kernel: wendland");
  expect(text, "c", "places: [[0, 1], {x: 2}]");
  expect(text, "s40", "film: 1");
  expect(text, "d", "by accuracy"); /* which sets more than the resolution */
  expect(text, "e", "film: 1, by accuracy");
  expect(text, "f", "");
  expect(text, "g", NULL);
}

/* Several at once, of which one is not there. */
static void test_many_runs_of_one_text(void) {
  static const char *const names[] = {"b-2", "c", "b-1"};
  char *settings[3];
  EXPECT_OK(case_run_settings("runs: [{name: b, d: x, sweep: {e: [1, 2]}}]\n", 3, names, settings));
  EXPECT_STR(settings[0], "d: x, e: 2");
  EXPECT(settings[1] == NULL);
  EXPECT_STR(settings[2], "d: x, e: 1");
  for (int i = 0; i < 3; i++) free(settings[i]);
}

/* Whatever stands in a file is no reason to fail. */
static void test_no_such_run_or_no_case(void) {
  expect("", "a", NULL);
  expect("title: x\n", "a", NULL);
  expect("runs: 3\n", "a", NULL);
  expect("runs: [3, [a]]\n", "a", NULL);
  expect("runs: [{name: [a]\n", "a", NULL);
  expect("runs: [{name: a, sweep: {b: []}}]\n", "a", NULL);
}

/* What is too long to be kept whole is nobody else's. */
static void test_long_settings_differ(void) {
  const char *const names[] = {"a", "b"};
  char *settings[2], *text, list[8001];
  for (size_t i = 0; i < sizeof list - 1; i++) list[i] = i % 2 ? ',' : '1';
  list[sizeof list - 1] = 0;
  if (asprintf(&text, "runs: [{name: a, x: [%s 1]}, {name: b, x: [%s 2]}]\n", list, list) < 0)
    abort();
  EXPECT_OK(case_run_settings(text, 2, names, settings));
  EXPECT(settings[0] && settings[1] && strcmp(settings[0], settings[1]) != 0);
  free(settings[0]);
  free(settings[1]);
  free(text);
}

/* An alias within itself, and lists that double, end. */
static void test_aliases_end(void) {
  const char *a = "a";
  char *settings = NULL;
  EXPECT_OK(case_run_settings("runs: [{name: a, x: &x [*x, *x]}]\n", 1, &a, &settings));
  EXPECT(settings && strlen(settings) < 20000);
  free(settings);
  EXPECT_OK(case_run_settings(
      "p: &a [1, 1, 1, 1, 1, 1, 1, 1]\nq: &b [*a, *a, *a, *a, *a, *a, *a, *a]\n"
      "r: &c [*b, *b, *b, *b, *b, *b, *b, *b]\ns: &d [*c, *c, *c, *c, *c, *c, *c, *c]\n"
      "runs: [{name: a, x: [*d, *d, *d, *d]}]\n",
      1, &a, &settings));
  EXPECT(settings && strlen(settings) < 20000);
  free(settings);
}

static void expect_ends(const char *text, bool sides, bool bed) {
  bool periodic[2] = {!sides, !bed};
  EXPECT_OK(case_periodic_ends(text, periodic));
  if (periodic[0] != sides || periodic[1] != bed)
    TEST_FAIL("periodic %d, %d: %s", periodic[0], periodic[1], text);
}

/* Whatever else is in it: the case may be of another version, or no case at all. */
static void test_periodic_ends(void) {
  expect_ends("tank: {walls: [[[0, 2], [0, 0], [3, 0], [3, 2]]], sides: periodic}\n", true, false);
  expect_ends("new: 3\ntank: {sides: periodic, bed: periodic, more: []}\nruns: 7\n", true, true);
  expect_ends("tank: {sides: walls, bed: wall}\n", false, false);
  expect_ends("sides: periodic\ntank: [sides, periodic]\n", false, false);
  expect_ends("tank: {sides: [periodic]}\n", false, false);
  expect_ends("tank: {sides: periodic", false, false);
  expect_ends("periodic", false, false);
  expect_ends("", false, false);
}

int main(void) {
  RUN(test_keys_in_order_without_what_says_how_fine);
  RUN(test_many_runs_of_one_text);
  RUN(test_no_such_run_or_no_case);
  RUN(test_long_settings_differ);
  RUN(test_aliases_end);
  RUN(test_periodic_ends);
  return TEST_RESULT;
}

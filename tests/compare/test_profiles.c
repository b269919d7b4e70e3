/* What others have measured or found: surfaces laid over those of runs whose distance from them is
 * known, and numbers of events. */
#include <stdlib.h>

#include "compare/report.h"
#include "tests/compare/made_up.h"

enum { POINTS = 40 };

/* Points 0.1 and 0.2 by turns above the level of a run without flaws, and one far away. */
static struct case_profile seen(const char *label, double time) {
  struct case_profile p = {text(label), text("a & b"), time, POINTS + 1, NULL, NULL};
  p.x = calloc(POINTS + 1, sizeof *p.x);
  p.y = calloc(POINTS + 1, sizeof *p.y);
  for (int i = 0; i < POINTS; i++) {
    const double x = 0.05 + 1.9 * i / (POINTS - 1), above = i % 2 ? 0.2 : 0.1;
    p.x[i] = x * H;
    p.y[i] = H * (1 + above + 0.1 * cos(M_PI * x) * cos(2 * time / sqrt(H / g)));
  }
  p.x[POINTS] = 1e3;
  return p;
}

/* And one of which nothing is in the window. */
static struct case_profile unseen(const char *label, double time) {
  struct case_profile p = seen(label, time);
  for (int i = 0; i < POINTS; i++) p.x[i] = 1e3;
  return p;
}

static struct result_file *reference(size_t n, const struct case_profile *profiles) {
  struct result_file *r = made_up("a", "seen", (struct flaws){.until = end});
  r->n_profiles = n;
  r->profiles = calloc(n, sizeof *r->profiles);
  memcpy(r->profiles, profiles, n * sizeof *profiles);
  return r;
}

/* A run raised by 0.05 is 0.1 below the points on average. The slope of at most 0.1 pi brings
 * points nearer than their height above the surface, by less than its square's half: a twentieth.
 */
static void test_distance_is_that_of_the_points(void) {
  struct case_file c;
  settings_make(&c);
  struct result_file *a = reference(1, (struct case_profile[]){seen("seen <b>", times[0])});
  struct result_file *b = made_up("b", "seen", (struct flaws){.until = end, .raised = 0.05});
  compare(&c, a, 1, &b);
  const double d = value_of("profile_distance", "b", 2);
  EXPECT(d <= 0.1 + 1e-12 && d >= 0.95 * 0.1);
  EXPECT(isnan(value_of("profile_distance", "b", 4)));
  EXPECT(file_says("report.html", "Circles: seen &lt;b&gt;; mean distance from b 0."));
  json_t *sources = json_object_get(json_object_get(report, "about"), "sources"),
         *source = json_array_get(sources, 0);
  EXPECT_STR(json_string_value(json_object_get(source, "label")), "seen <b>");
  EXPECT_STR(json_string_value(json_object_get(source, "target")), "surface");
  EXPECT_STR(json_string_value(json_object_get(source, "source")), "a & b");
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* Of two profiles, in either order, the one that has no point in the window is left out. */
static void test_what_cannot_be_measured_is_left_out(void) {
  for (int order = 0; order < 2; order++) {
    struct case_file c;
    settings_make(&c);
    const struct case_profile in = seen("in", times[0]), out = unseen("out", times[0]);
    struct result_file *a = order ? reference(2, (struct case_profile[]){in, out})
                                  : reference(2, (struct case_profile[]){out, in});
    struct result_file *b = made_up("b", "seen", (struct flaws){.until = end, .raised = 0.05});
    compare(&c, a, 1, &b);
    const double d = value_of("profile_distance", "b", 2);
    EXPECT(d <= 0.1 + 1e-12 && d >= 0.95 * 0.1);
    EXPECT(file_says("report.json", "\"sensors_left_out\": 1"));
    EXPECT(file_says("report.html", "Circles: out."));
    settings_free(&c);
    result_file_destroy(a);
    result_file_destroy(b);
  }
}

static struct cmp_verdict judged(double at, bool measured) {
  struct case_file c;
  settings_make(&c);
  settings_free(&c);
  c.compare.n_tolerances = 1;
  everything[0] = (struct case_tolerance){.measure = text("profile_distance"), .at = at, .max = 1};
  struct result_file *a = measured ? reference(1, (struct case_profile[]){seen("seen", times[0])})
                                   : made_up("a", "seen", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "seen", (struct flaws){.until = end});
  const struct cmp_verdict v = compare(&c, a, 1, &b);
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
  return v;
}

/* A tolerance for all times is for those at which a surface was measured; one for a time at which
 * none was fails, as does any where none was measured at all. */
static void test_tolerance_is_for_times_of_profiles(void) {
  struct cmp_verdict v = judged(NAN, true);
  EXPECT(v.passed == 1 && v.failed == 0);
  v = judged(times[0], true);
  EXPECT(v.passed == 1 && v.failed == 0);
  v = judged(times[1], true);
  EXPECT(v.passed == 0 && v.failed == 1);
  v = judged(NAN, false);
  EXPECT(v.passed == 0 && v.failed == 2);
}

/* ---- events against published numbers ---- */

static void add_event(struct result_file *r, const char *name, double t, double x, double y) {
  r->events = realloc(r->events, (r->n_events + 1) * sizeof *r->events);
  if (!r->events) abort();
  r->events[r->n_events++] = (struct result_event_read){
      .name = text(name), .time = t * sqrt(H / g), .x = x * H, .y = y * H};
}

static struct cmp_verdict held(struct case_event *e) {
  struct case_file c;
  char names[][2] = {"a", "b"};
  struct case_run runs[] = {{.name = names[0]}, {.name = names[1]}};
  settings_make(&c);
  settings_free(&c);
  c.compare.n_tolerances = 0;
  c.n_runs = 2;
  c.runs = runs;
  c.compare.n_events = 1;
  c.compare.events = e;
  struct result_file *a = made_up("a", "seen", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "seen", (struct flaws){.until = end});
  add_event(a, "run_up", 2, 0.5, 1.24997);
  add_event(a, "run_up", 3, 0.5, 1.5); /* not the first */
  add_event(b, "run_up", 2, 0.5, 1.375);
  const struct cmp_verdict v = compare(&c, a, 1, &b);
  result_file_destroy(a);
  result_file_destroy(b);
  return v;
}

/* The reference is held against them, too. */
static void test_events_are_held_against_published_numbers(void) {
  size_t only[] = {1};
  char source[] = "a <source>";
  struct case_event e = {.event = CASE_EVENT_OF_run_up, .part = CASE_EVENT_y, .source = source};
  e.value = 1.3 * H;
  e.within = 0.06 * H;
  struct cmp_verdict v = held(&e); /* off by 0.05 and 0.075 */
  EXPECT(v.passed == 1 && v.failed == 1);
  EXPECT(file_says("report.html", "a &lt;source&gt;"));
  const json_t *first = json_array_get(json_object_get(report, "events"), 0);
  EXPECT_NEAR(json_number_value(json_object_get(first, "value")), 1.24997, 1e-12);
  EXPECT(file_says("report.html", "<td>1.24997</td>"));
  EXPECT_NEAR(json_number_value(json_object_get(first, "published")), 1.3, 1e-12);
  EXPECT(!strcmp(json_string_value(json_object_get(first, "outcome")), "pass"));
  e.within = 0.08 * H;
  v = held(&e);
  EXPECT(v.passed == 2 && v.failed == 0);
  e.n_runs = 1;
  e.runs = only;
  e.within = 0.06 * H;
  v = held(&e);
  EXPECT(v.passed == 0 && v.failed == 1);
  e.n_runs = 0;
  e = (struct case_event){.event = CASE_EVENT_OF_run_up, .source = source};
  e.value = 2.01 * sqrt(H / g);
  e.within = 0.02 * sqrt(H / g);
  v = held(&e);
  EXPECT(v.passed == 2 && v.failed == 0);
}

/* None that has not happened. */
static void test_event_that_has_not_happened_fails(void) {
  char source[] = "s";
  struct case_event e = {.event = CASE_EVENT_OF_overflow,
                         .part = CASE_EVENT_x,
                         .value = 1,
                         .within = 1e9,
                         .source = source};
  struct cmp_verdict v = held(&e);
  EXPECT(v.passed == 0 && v.failed == 2);
  EXPECT(file_says("report.html", "the run has no event overflow"));
}

int main(void) {
  if (!mkdtemp(folder)) return 1;
  gnuplot_pretend();
  RUN(test_distance_is_that_of_the_points);
  RUN(test_what_cannot_be_measured_is_left_out);
  RUN(test_tolerance_is_for_times_of_profiles);
  RUN(test_events_are_held_against_published_numbers);
  RUN(test_event_that_has_not_happened_fails);
  json_decref(report);
  folder_remove(folder);
  return TEST_RESULT;
}

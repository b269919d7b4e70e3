/* Surfaces that were measured, laid over those of runs whose distance from them is known. */
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
  EXPECT(file_says("report.html", "seen &lt;b&gt; (surface): a &amp; b"));
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

int main(void) {
  if (!mkdtemp(folder)) return 1;
  gnuplot_pretend();
  RUN(test_distance_is_that_of_the_points);
  RUN(test_what_cannot_be_measured_is_left_out);
  RUN(test_tolerance_is_for_times_of_profiles);
  json_decref(report);
  folder_remove(folder);
  return TEST_RESULT;
}

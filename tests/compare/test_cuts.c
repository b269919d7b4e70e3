/* Water that a run cuts away, in the curves of its energy and in a sentence. */
#include "compare/output.h"
#include "tests/compare/made_up.h"

enum { AT = 100 }; /* the first row after the cut; the smaller one just before does not show */

static void cut_away(struct result_file *r) {
  const double jump = 0.02 * density * g * H * H * H;
  for (size_t i = AT - 1; i < r->n_energy; i++) {
    r->energy[i].removed = i < AT ? 1e-3 * jump : jump;
    r->steps[i].removed_volume = 0.001 * r->steps[0].volume;
    r->steps[i].volume -= r->steps[i].removed_volume;
  }
  free(r->events->name);
  r->events->name = text("cut");
}

/* Behind the series of two curves: one row, on the curve of the run that was cut. */
static void check_mark(const char *name) {
  char *table = read_whole(name);
  const char *mark = strstr(table, "\"cut\"");
  double t = NAN, value = NAN;
  EXPECT(mark && !strstr(mark + 1, "\"cut\""));
  EXPECT(mark && sscanf(mark, "\"cut\",%lf,%lf", &t, &value) == 2);
  EXPECT_NEAR(t, end * AT / (ROWS - 1), 1e-9);
  EXPECT(isfinite(value));
  free(table);
}

static void test_cuts_are_marked_and_summed_up(void) {
  struct case_file c;
  settings_make(&c);
  struct result_file *a = made_up("a", "whole", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "cut", (struct flaws){.until = end});
  cut_away(b);
  compare(&c, a, 1, &b);
  char *page = read_whole("report.html"), *script = read_whole("figures/energy-kinetic.gp");
  check_mark("figures/energy-kinetic.csv");
  check_mark("figures/energy-potential.csv");
  check_mark("figures/energy-removed.csv");
  EXPECT(strstr(page, " % of E0 and 0.1 % of its water in 1 cut."));
  EXPECT(strstr(script, "with points pointtype 2"));
  free(page);
  free(script);
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

static void test_nothing_is_said_of_cuts_where_there_are_none(void) {
  struct case_file c;
  settings_make(&c);
  struct result_file *a = made_up("a", "whole", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "whole too", (struct flaws){.until = end});
  compare(&c, a, 1, &b);
  char *page = read_whole("report.html");
  EXPECT(!strstr(page, "cut away") && !strstr(page, "energy-removed"));
  free(page);
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

int main(void) {
  if (!mkdtemp(folder)) return 1;
  RUN(test_nothing_is_said_of_cuts_where_there_are_none);
  RUN(test_cuts_are_marked_and_summed_up);
  json_decref(report);
  folder_remove(folder);
  return TEST_RESULT;
}

/* What a run states of its own errors, in the figures and the page: made-up standard errors. */
#include "compare/output.h"
#include "tests/compare/made_up.h"

static const double TIME_ERROR = 0.0125; /* sqrt(H/g), of its overturning */
static const double LEVEL_ERROR = 0.03;  /* H, of the gauge at every row but the last */

static void give_error_bars(struct result_file *r) {
  struct result_series *gauge = r->gauges;
  r->coarser = (struct result_coarser){.ratio = 2, .order = 2};
  gauge->n_errors = gauge->n;
  gauge->error = calloc(gauge->n, sizeof *gauge->error);
  for (size_t i = 0; i < gauge->n; i++) gauge->error[i] = i + 1 < gauge->n ? LEVEL_ERROR * H : NAN;
  free(r->events->name);
  r->events->name = text("overturning");
  r->events->error[0] = TIME_ERROR * sqrt(H / g);
  r->events->error[1] = r->events->error[2] = NAN;
}

/* A row of the gauge's table is the value, and the value less and more its error. */
static void check_rows(const char *table) {
  size_t bars = 0, none = 0;
  double series, t, value, less, more;
  EXPECT(strstr(table, ",elevation [H],less a standard error,and more by one\n"));
  for (const char *at = strchr(table, '\n'); at && at[1]; at = strchr(at + 1, '\n')) {
    EXPECT(sscanf(at + 1, "%lf,\"%*[^\"]\",%lf,%lf,%lf,%lf", &series, &t, &value, &less, &more) ==
           5);
    if (isnan(less)) {
      none++;
      continue;
    }
    bars++;
    EXPECT_NEAR(value - less, LEVEL_ERROR, 1e-9); /* ten digits are written */
    EXPECT_NEAR(more - value, LEVEL_ERROR, 1e-9);
    EXPECT(series == 1); /* the reference */
  }
  EXPECT(bars > 2 && none > bars); /* the other run's rows, and the last */
}

static void test_error_bars_are_shown(void) {
  struct case_file c;
  settings_make(&c);
  struct result_file *a = made_up("a", "with error bars", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "without", (struct flaws){.until = end});
  give_error_bars(a);
  compare(&c, a, 1, &b);
  char *table = read_whole("figures/gauge-G-1-touch-x-.csv"),
       *script = read_whole("figures/gauge-G-1-touch-x-.gp");
  char *page = read_whole("report.html");
  check_rows(table);
  EXPECT(strstr(script, "using ($1==1?$3:NaN):5:6 with filledcurves"));
  EXPECT(!strstr(script, "using ($1==0?$3:NaN):5:6"));
  EXPECT(strstr(page, "Bands: the standard error that a run states of itself."));
  json_t *turns = json_object_get(json_object_get(report, "reference"), "overturning");
  EXPECT_NEAR(json_number_value(json_object_get(turns, "t_star")), 3, 1e-9);
  EXPECT_NEAR(json_number_value(json_object_get(turns, "error")), TIME_ERROR, 1e-9);
  EXPECT(json_is_true(json_object_get(turns, "located_by_solver")));
  free(table);
  free(script);
  free(page);
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

int main(void) {
  if (!mkdtemp(folder)) return 1;
  RUN(test_error_bars_are_shown);
  json_decref(report);
  folder_remove(folder);
  return TEST_RESULT;
}

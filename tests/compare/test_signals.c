/* Filters, spectra and diagnostics in a report: beside what is compared, which they leave alone. */
#include "tests/compare/made_up.h"

enum { STEPS = 2001 };

/* A point whose a_y swings by 0.25 g, three waves in a time, from a dry beginning on. */
static void point_add(struct result_file *r) {
  const double T = sqrt(H / g);
  r->n_points = 1;
  r->points = calloc(1, sizeof *r->points);
  r->points->name = text("mid.dle");
  r->points->x = 0.5 * H;
  r->points->y = 0.25 * H;
  r->points->n = STEPS;
  r->points->t = calloc(STEPS, sizeof(double));
  for (int k = 0; k < CASE_POINT_FIELDS; k++) r->points->value[k] = calloc(STEPS, sizeof(double));
  for (int i = 0; i < STEPS; i++) {
    const double t = end * i / (STEPS - 1);
    r->points->t[i] = t * T;
    r->points->value[CASE_POINT_a_y][i] = i < 10 ? NAN : g * (0.25 * sin(2 * M_PI * 3 * t) - 1);
    r->points->value[CASE_POINT_rho][i] = density;
  }
}

static void diagnostic_add(struct result_file *r, const char *name, const char *units,
                           double (*value)(double t)) {
  r->diagnostics = realloc(r->diagnostics, (r->n_diagnostics + 1) * sizeof *r->diagnostics);
  struct result_series *s = &r->diagnostics[r->n_diagnostics++];
  *s = (struct result_series){
      .name = text(name), .units = text(units), .help = text("what <it> is"), .n = ROWS};
  s->t = calloc(ROWS, sizeof(double));
  s->value = calloc(ROWS, sizeof(double));
  for (int i = 0; i < ROWS; i++) {
    s->t[i] = end * i / (ROWS - 1) * sqrt(H / g);
    s->value[i] = value(end * i / (ROWS - 1));
  }
}

/* A probe that has no value from first to last. */
static void deaf_add(struct result_file *r) {
  r->probes = realloc(r->probes, 2 * sizeof *r->probes);
  struct result_series *s = &r->probes[r->n_probes++];
  *s = (struct result_series){
      .name = text("deaf"), .units = text("Pa"), .help = text(""), .n = ROWS, .y = H};
  s->t = calloc(ROWS, sizeof(double));
  s->value = calloc(ROWS, sizeof(double));
  for (int i = 0; i < ROWS; i++) {
    s->t[i] = end * i / (ROWS - 1) * sqrt(H / g);
    s->value[i] = NAN;
  }
}

static double grows(double t) {
  return 1e-3 * exp(2 * t);
}

static double swings(double t) {
  return 300 * sin(t);
}

static struct case_file settings;
static struct case_probe probes[] = {{.name = "P \"1\""}, {.name = "deaf"}, {.name = "nobody"}};
static struct case_filter filters[] = {
    {0, CASE_FILTER_low_pass, 0, 0}, {0, CASE_FILTER_impulse, 0, 0},
    {0, CASE_FILTER_wall, 0, 0.1},   {0, CASE_FILTER_low_pass, 0, 0},
    {1, CASE_FILTER_impulse, 0, 0},  {2, CASE_FILTER_impulse, 0, 0}};
enum { FILTERS = sizeof filters / sizeof *filters };
static struct case_spectrum spectra[] = {{"mid.dle.a_y", 0, INFINITY, 3},
                                         {"G'1`touch x`", 0, INFINITY, 3}};

static void signals_ask(bool ask) {
  settings.n_probes = 3;
  settings.probes = probes;
  filters[0].period = sqrt(H / g);
  filters[3].period = 1.9 * end / (ROWS - 1) * sqrt(H / g);
  settings.compare.n_filters = ask ? FILTERS : 0;
  settings.compare.filters = filters;
  settings.compare.n_spectra = ask ? 2 : 0;
  settings.compare.spectra = spectra;
}

static json_t *of_run(const char *list, size_t k) {
  json_t *run = json_array_get(json_object_get(report, "runs"), 0);
  return json_array_get(json_object_get(run, list), k);
}

static double number_in(json_t *object, const char *key) {
  return json_number_value(json_object_get(object, key));
}

static bool page_says(const char *word) {
  char path[PATH_MAX], *page = calloc(1, 1 << 24);
  path_in("report.html", path);
  FILE *in = fopen(path, "r");
  size_t n = in && page ? fread(page, 1, (1 << 24) - 1, in) : 0;
  if (in) fclose(in);
  const bool said = n && strstr(page, word);
  free(page);
  return said;
}

/* The pulse 0.8 exp(-(t - 2.3)^2/0.2^2) without periods of 1: its peak is about 0.8 erf(w 0.2/2),
 * and its impulse stays 0.8 0.2 sqrt(pi). */
static void test_filters_stand_beside(void) {
  json_t *low = of_run("filters", 0), *impulse = of_run("filters", 1);
  json_t *raw = json_object_get(low, "raw"), *filtered = json_object_get(low, "filtered");
  const double p = 0.8 * 0.2 * sqrt(M_PI);
  EXPECT_STR(json_string_value(json_object_get(low, "kind")), "low_pass");
  EXPECT_NEAR(number_in(low, "period"), 1, 1e-12);
  EXPECT_NEAR(number_in(raw, "peak"), 0.8, 1e-12);
  EXPECT_NEAR(number_in(filtered, "peak"), 0.8 * erf(2 * M_PI * 0.1), 0.05);
  EXPECT_NEAR(number_in(raw, "impulse"), p, 1e-6);
  EXPECT_NEAR(number_in(filtered, "impulse"), number_in(raw, "impulse"), 1e-12);
  EXPECT(number_in(low, "rms_taken_out") > 0.01);
  EXPECT_NEAR(number_in(json_object_get(impulse, "filtered"), "peak"), p, 1e-6);
  json_t *no = json_object_get(impulse, "filtered"); /* of a curve of impulses */
  EXPECT(json_object_get(no, "impulse_unavailable") && json_object_get(no, "onset_unavailable"));
}

static void expect_not_taken(size_t k, const char *why) {
  json_t *filtered = json_object_get(of_run("filters", k), "filtered");
  EXPECT(json_is_null(json_object_get(filtered, "peak")));
  EXPECT_STR(json_string_value(json_object_get(filtered, "peak_unavailable")), why);
  if (!page_says(why)) TEST_FAIL("the page does not say: %s", why);
}

static void test_what_cannot_be_taken_says_why(void) {
  expect_not_taken(2, "probes at 1 of the 3 places that are needed on the wall");
  expect_not_taken(3, "a period of 0.038, shorter than two intervals between rows, 0.04");
  expect_not_taken(4, "rows of the series are without a value");
  expect_not_taken(5, "the run has no such probe");
  EXPECT_STR(json_string_value(json_object_get(of_run("filters", 5), "probe")), "nobody");
  EXPECT(!page_says(">nan<"));
}

static void test_spectra_have_their_peaks(void) {
  json_t *s = of_run("spectra", 0), *peaks = json_object_get(s, "peaks");
  EXPECT_STR(json_string_value(json_object_get(s, "units")), "g");
  EXPECT(json_array_size(peaks) == 1 && json_is_false(json_object_get(s, "resampled")));
  EXPECT_NEAR(number_in(json_array_get(peaks, 0), "frequency"), 3, 1e-3);
  EXPECT_NEAR(number_in(json_array_get(peaks, 0), "frequency_Hz"), 3 / sqrt(H / g), 1e-2);
  EXPECT_NEAR(number_in(json_array_get(peaks, 0), "amplitude"), 0.25, 1e-3);
  EXPECT_NEAR(number_in(s, "mean"), -1, 1e-3);
  EXPECT_NEAR(number_in(s, "mean_square"), 0.25 * 0.25 / 2, 1e-3);
  EXPECT(number_in(s, "samples") == STEPS - 10);
  json_t *other =
      json_array_get(json_object_get(json_object_get(report, "reference"), "spectra"), 0);
  EXPECT(json_is_null(json_object_get(other, "sampling_interval"))); /* it has no points */
  EXPECT(json_object_get(other, "sampling_interval_unavailable") != NULL);
  EXPECT(json_array_size(json_object_get(of_run("spectra", 1), "peaks")) == 0); /* a constant */
}

/* Of 1e-3 exp(2 t) from 0 to 4: in the middle. No front runs to a wall here. */
static void test_medians_are_in_the_middle(void) {
  json_t *run = json_array_get(json_object_get(report, "runs"), 0);
  json_t *d = json_object_get(run, "diagnostics");
  EXPECT(number_in(d, "from") == 0);
  EXPECT_NEAR(number_in(json_object_get(d, "medians"), "noise_x"), 1e-3 * exp(4), 1e-9);
  EXPECT(json_object_get(json_object_get(report, "reference"), "diagnostics") == NULL);
}

static bool is_there(const char *name) {
  char path[PATH_MAX];
  path_in(name, path);
  return access(path, R_OK) == 0;
}

/* Pictures are drawn, from tables in units that the heads name; a page without the settings and
 * without diagnostics says nothing of them. */
static void test_figures_are_there(void) {
  static const char *const figures[] = {"filter-1-P--1--low_pass", "filter-2-P--1--impulse",
                                        "spectrum-1-mid-dle-a_y", "diagnostics", "energy-terms"};
  static const char *const sections[] = {"Filters, raw → filtered", "id=\"spectra\"",
                                         "id=\"diagnostics\"", "what \\u003cit> is"};
  char name[96];
  for (size_t k = 0; k < sizeof figures / sizeof *figures; k++) {
    snprintf(name, sizeof name, "figures/%s.svg", figures[k]);
    if (!is_there(name)) TEST_FAIL("there is no %s", name);
    snprintf(name, sizeof name, "figures/%s.csv", figures[k]);
    EXPECT(is_there(name));
  }
  for (size_t k = 0; k < 4; k++) EXPECT(page_says(sections[k]));
}

int main(void) {
  if (system("command -v gnuplot >/dev/null")) {
    puts("gnuplot is not installed");
    return 77;
  }
  if (!mkdtemp(folder)) return 1;
  struct result_file *a = made_up("bem", "signals", (struct flaws){0, 0, 0, end});
  struct result_file *b = made_up("sph", "signals", (struct flaws){0.01, 0.01, 0.3, end});
  point_add(b);
  deaf_add(b);
  diagnostic_add(b, "noise_x", "1", grows);
  diagnostic_add(b, "turning", "kg m/s", swings);
  settings_make(&settings);
  signals_ask(false);
  compare(&settings, a, 1, &b);
  json_t *before = json_incref(json_object_get(report, "measures"));
  EXPECT(json_array_size(json_object_get(json_object_get(report, "reference"), "filters")) == 0 &&
         !page_says("id=\"spectra\""));
  signals_ask(true);
  compare(&settings, a, 1, &b);
  EXPECT(json_equal(before, json_object_get(report, "measures"))); /* nothing that is compared */
  RUN(test_filters_stand_beside);
  RUN(test_what_cannot_be_taken_says_why);
  RUN(test_spectra_have_their_peaks);
  RUN(test_medians_are_in_the_middle);
  RUN(test_figures_are_there);
  json_decref(before);
  json_decref(report);
  result_file_destroy(a);
  result_file_destroy(b);
  settings_free(&settings);
  folder_remove(folder);
  return TEST_RESULT;
}

/* The whole comparator on made-up runs whose differences are known: a standing wave of small
 * amplitude in a tank of length 2, whose energy decays at a known rate, with probes, a gauge and a
 * front. */
#include "compare/report.h"

#include <dirent.h>
#include <jansson.h>
#include <libxml/parser.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "compare/measures/look.h"
#include "compare/output.h"
#include "tests/compare/made_up.h"

/* The same file twice: every measure that exists is zero, everything passes. */
static void test_identity_passes_every_check(void) {
  struct case_file c;
  settings_make(&c);
  struct result_file *a = made_up("a", "twice the same", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "twice the same", (struct flaws){.until = end});
  struct cmp_verdict v = compare(&c, a, 1, &b);
  EXPECT(v.failed == 0);
  EXPECT(v.passed >= c.compare.n_tolerances);
  EXPECT(strstr(v.sentence, "to the end of what they share"));
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* What a term of the only run had taken at its last comparison time; NULL: what none has. */
static double ledger_of(const char *term) {
  json_t *run = json_array_get(json_object_get(report, "runs"), 0);
  json_t *budget = json_object_get(run, "energy_budget");
  json_t *last = json_array_get(budget, json_array_size(budget) - 1);
  json_t *value = term ? json_object_get(json_object_get(last, "terms"), term)
                       : json_object_get(last, "unaccounted");
  EXPECT_NEAR(json_number_value(json_object_get(last, "t_star")), 4, 1e-9);
  return value ? json_number_value(value) : NAN;
}

/* What passes to and from sides that move is not lost. */
static void test_what_a_tank_that_moves_takes_is_not_lost(void) {
  struct case_file c;
  settings_make(&c);
  struct result_file *a = made_up("a", "moved", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "moved", (struct flaws){.decay = 0.01, .until = end});
  b->terms[0].outside = true;
  compare(&c, a, 1, &b);
  EXPECT_NEAR(value_of("decay", "b", 4), 0, 1e-9);
  EXPECT_NEAR(value_of("mechanical", "b", 4), 0.04, 1e-9);
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* A level raised by d, energy lost at a rate, a late probe: each measure gives what was put in. */
static void test_known_flaws_are_measured(void) {
  struct case_file c;
  settings_make(&c);
  const double d = 0.0137, decay = 0.01, late = 0.05;
  struct result_file *a = made_up("a", "flaws", (struct flaws){.until = end});
  struct result_file *b = made_up(
      "b", "flaws", (struct flaws){.raised = d, .decay = decay, .late = late, .until = end});
  struct cmp_verdict v = compare(&c, a, 1, &b);
  EXPECT(v.failed > 0);
  for (int k = 0; k < 2; k++) {
    double t = 2 + 2 * k;
    /* the curves are d apart vertically and sloped by at most 0.1 pi: cos of that is 0.95 */
    EXPECT(value_of("mean_distance", "b", t) <= d + 1e-12);
    EXPECT(value_of("mean_distance", "b", t) >= 0.95 * d);
    EXPECT_NEAR(value_of("area", "b", t), 2 * d, 1e-9);
    EXPECT_NEAR(value_of("decay", "b", t), decay * t, 1e-9); /* E0 is rho g H^3 here */
    EXPECT_NEAR(value_of("mechanical", "b", t), decay * t, 1e-9);
    EXPECT_NEAR(value_of("kinetic", "b", t), 0, 1e-12);
    EXPECT(isnan(value_of("jet_tip", "b", t)));
  }
  EXPECT_NEAR(value_of("budget", "b", 0), 0, 1e-12); /* what is lost is in a term */
  EXPECT_NEAR(ledger_of("lost <b>"), 4 * decay, 1e-9);
  EXPECT_NEAR(ledger_of(NULL), 0, 1e-12);
  EXPECT_NEAR(value_of("volume", "b", 0), 0, 1e-12);
  EXPECT_NEAR(value_of("gauge_rms", "b", 0), d, 1e-9);
  EXPECT_NEAR(value_of("probe_peak", "b", 0), 0, 2.1e-3); /* rows h apart miss h^2 p'' / 8 */
  EXPECT_NEAR(value_of("probe_shift", "b", 0), late, 1e-3);
  EXPECT_NEAR(value_of("probe_onset", "b", 0), late, 1e-3);
  EXPECT_NEAR(value_of("probe_impulse", "b", 0), 0, 1e-9);
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* The reference ends early: what comes later is not available, says why, and fails its tolerance.
 */
static void test_missing_times_are_not_zero(void) {
  struct case_file c;
  settings_make(&c);
  struct result_file *a = made_up("a", "short", (struct flaws){.until = 3});
  struct result_file *b = made_up("b", "short", (struct flaws){.until = end});
  struct cmp_verdict v = compare(&c, a, 1, &b);
  EXPECT(isfinite(value_of("mean_distance", "b", 2)));
  EXPECT(isnan(value_of("mean_distance", "b", 4)));
  EXPECT(isnan(value_of("area", "b", 4)));
  EXPECT(v.failed == 6); /* the six measures of surfaces at the second time */
  EXPECT(strstr(v.sentence, "t* = 3"));
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* A run that is further than a spacing from the first output on never stays within it. */
static void test_sentence_of_a_run_that_is_never_near(void) {
  struct case_file c;
  settings_make(&c);
  struct result_file *a = made_up("a", "near", (struct flaws){.until = end}),
                     *b = made_up("b", "far", (struct flaws){.raised = 0.137, .until = end});
  struct cmp_verdict v = compare(&c, a, 1, &b);
  EXPECT(strstr(v.sentence, "along the surface) of a at no time."));
  EXPECT(!strstr(v.sentence, "until t* = 0"));
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* Runs that do equally well are named together. */
static void test_sentence_groups_runs(void) {
  struct case_file c;
  settings_make(&c);
  struct result_file *a = made_up("a", "alike", (struct flaws){.until = end}), *runs[3];
  for (size_t r = 0; r < 3; r++)
    runs[r] = made_up((const char *[]){"x", "y", "z"}[r], "", (struct flaws){.until = end});
  runs[2]->complete = false;
  struct cmp_verdict v = compare(&c, a, 3, runs);
  EXPECT(strstr(v.sentence, "x and y stay within one particle spacing"));
  EXPECT(strstr(v.sentence, "; z to the end of what they share, t* = 4 (unfinished)."));
  settings_free(&c);
  result_file_destroy(a);
  for (size_t r = 0; r < 3; r++) result_file_destroy(runs[r]);
}

/* Each measure says its section, and those taken ALWAYS are in against_time with a number for every
 * common output. */
static void test_measures_list_themselves(void) {
  static const char *const id[] = {[CMP_SECTION_DISTANCE] = "distance",
                                   [CMP_SECTION_ENERGY] = "energy",
                                   [CMP_SECTION_PRESSURE] = "pressure",
                                   [CMP_SECTION_GAUGE] = "gauges"};
  struct case_file c;
  settings_make(&c);
  struct result_file *a = made_up("a", "lists", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "lists", (struct flaws){.until = end});
  compare(&c, a, 1, &b);
  json_t *against =
      json_object_get(json_array_get(json_object_get(report, "runs"), 0), "against_time");
  json_t *list = json_object_get(json_object_get(report, "about"), "measures");
  EXPECT(json_array_size(list) == CMP_N_MEASURES);
  for (size_t m = 0; m < CMP_N_MEASURES; m++) {
    json_t *row = json_object_get(against, cmp_measures[m].name), *own = json_array_get(list, m);
    const enum cmp_section section = cmp_measure_sections[m];
    EXPECT(cmp_measure_always(m) == (row != NULL));
    if (row) EXPECT(json_array_size(row) == a->n_surfaces);
    EXPECT_STR(json_string_value(json_object_get(own, "name")), cmp_measures[m].name);
    EXPECT_STR(json_string_value(json_object_get(own, "help")), cmp_measures[m].help);
    if (section < sizeof id / sizeof *id && id[section])
      EXPECT_STR(json_string_value(json_object_get(own, "section")), id[section]);
  }
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* Without gnuplot there is a page with the numbers that says what is missing, and an error. */
static void test_page_without_figures(void) {
  struct case_file c;
  struct cmp_verdict v;
  char path[PATH_MAX], *bytes = NULL;
  size_t n;
  settings_make(&c);
  struct result_file *a = made_up("a", "bare", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "bare", (struct flaws){.until = end});
  char *usual = text(getenv("PATH"));
  setenv("PATH", "/nonexistent", 1);
  EXPECT(cmp_report(&c, a, 1, &b, false, folder, &v) == ERR_IO);
  setenv("PATH", usual, 1);
  EXPECT(strstr(status_message(), "gnuplot is not installed"));
  EXPECT(*v.sentence);
  path_in("report.html", path);
  EXPECT_OK(cmp_file_read(path, &bytes, &n));
  EXPECT(bytes && strstr(bytes, "There are no figures: ") && strstr(bytes, "mean_distance"));
  EXPECT(bytes && !strstr(bytes, "<img"));
  free(bytes);
  free(usual);
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* Runs that have no time in common are reported, as far as they can be. */
static void test_nothing_in_common(void) {
  struct case_file c;
  settings_make(&c);
  struct result_file *a = made_up("a", "apart", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "apart", (struct flaws){.until = end});
  for (size_t i = 0; i < b->n_surfaces; i++) b->surface_time[i] += 2 * end;
  struct cmp_verdict v = compare(&c, a, 1, &b);
  EXPECT(isnan(value_of("mean_distance", "b", 2)));
  EXPECT(strstr(v.sentence, "cannot be compared"));
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

static char *script_of(const char *figure) {
  char path[PATH_MAX], name[64], *bytes = NULL;
  size_t n;
  snprintf(name, sizeof name, "figures/%s.gp", figure);
  path_in(name, path);
  EXPECT_OK(cmp_file_read(path, &bytes, &n));
  return bytes ? bytes : text("");
}

static size_t count(const char *in, const char *what) {
  size_t n = 0;
  for (const char *at = in; (at = strstr(at, what)); at += strlen(what)) n++;
  return n;
}

/* Each a little further off than the one before. */
static void runs_compare(int n) {
  struct case_file c;
  struct result_file **runs = calloc((size_t)n, sizeof *runs);
  settings_make(&c);
  struct result_file *a = made_up("ref", "many", (struct flaws){.until = end});
  for (int r = 0; r < n; r++) {
    char name[32];
    snprintf(name, sizeof name, "run-%d", r);
    runs[r] = made_up(name, "", (struct flaws){.raised = 1e-4 * r, .decay = 1e-4, .until = end});
  }
  compare(&c, a, (size_t)n, runs);
  settings_free(&c);
  result_file_destroy(a);
  for (int r = 0; r < n; r++) result_file_destroy(runs[r]);
  free(runs);
}

/* gnuplot draws every figure of more runs than it names. */
static void test_unnamed_runs_are_drawn(void) {
  runs_compare(29);
}

/* Sixty runs: keys name 28, each in a style of its own, and say how many there are besides;
 * what has panels has twelve. */
static void test_many_runs(void) {
  runs_compare(60);
  char *energy = script_of("energy"), *pressure = script_of("pressure-P--1-");
  EXPECT(count(energy, "title 'run-") == 28 && count(energy, "title 'ref'") == 1);
  EXPECT(count(energy, "title '32 other runs'") == 1);
  EXPECT(count(energy, "dashtype (9,4) linecolor '#0072b2'") == 1);
  EXPECT(count(energy, "dashtype (9,3,2,3) linecolor '#7f7f7f'") == 1);
  EXPECT(count(pressure, "set yrange") == 12 && count(pressure, "title 'run-") == 12);
  /* the twelve: six that agree longest, six that leave first */
  EXPECT(strstr(pressure, "title 'run-0'") && strstr(pressure, "title 'run-59'"));
  EXPECT(!strstr(pressure, "title 'run-30'"));
  free(energy);
  free(pressure);
  char path[PATH_MAX], *page = NULL;
  size_t n;
  path_in("report.html", path);
  EXPECT_OK(cmp_file_read(path, &page, &n));
  EXPECT(page && strstr(page, "the 32 others are drawn in thin grey"));
  EXPECT(page && strstr(page, "the 48 others have no panel") && !strstr(page, "is missing"));
  free(page);
}

/* A curve far out is named as such in the key, and a mark shows how far; a peak has its mark. One
 * without a series is not drawn, and named so where the key names it. */
static void test_curves_beyond_the_frame(void) {
  struct case_file c;
  settings_make(&c);
  struct result_file *a = made_up("a", "beyond", (struct flaws){.until = end}), *runs[3];
  for (size_t r = 0; r < 3; r++)
    runs[r] = made_up((const char *[]){"fine", "blown-up", "deaf"}[r], "",
                      (struct flaws){.decay = 0.01, .until = end});
  for (size_t i = 0; i < runs[1]->n_energy; i++) runs[1]->energy[i].kinetic += 4e4 * density * g;
  runs[0]->probes->value[100] = 47.5 * density * g * H;
  runs[2]->n_probes = 0;
  compare(&c, a, 3, runs);
  char *energy = script_of("energy"), *pressure = script_of("pressure-P--1-");
  EXPECT(strstr(energy, "title 'blown-up (beyond the frame)'") && strstr(energy, "title 'fine'"));
  EXPECT(count(energy, "head filled") == 1);
  EXPECT(strstr(pressure, "set label '47.5' at 2, graph"));
  EXPECT(strstr(pressure, "title 'fine'") && strstr(pressure, "title 'deaf (has none)'"));
  free(energy);
  free(pressure);
  settings_free(&c);
  result_file_destroy(a);
  for (size_t r = 0; r < 3; r++) {
    runs[r]->n_probes = 1;
    result_file_destroy(runs[r]);
  }
}

/* A gauge that the reference has not is drawn, and said to stand alone. */
static void test_sensor_of_a_run_alone_is_drawn(void) {
  struct case_file c;
  settings_make(&c);
  struct result_file *a = made_up("a", "alone", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "alone", (struct flaws){.until = end});
  free(b->gauges->name);
  b->gauges->name = text("own");
  compare(&c, a, 1, &b);
  char *script = script_of("gauge-own");
  EXPECT(count(script, "title 'b'") == 1 && count(script, "title 'a'") == 0);
  free(script);
  EXPECT(file_says("report.html", "a has none of that name: nothing is compared."));
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* A drop without gravity, which grows, with the energies of any other water: it overhangs from
 * first to last, and nothing of it is a breaker. */
static struct result_file *drop(const char *name) {
  struct result_file *r = made_up(name, "a drop", (struct flaws){.until = end});
  for (size_t i = 0; i < r->n_surfaces; i++) {
    geo_lines_destroy(&r->surface[i]);
    shape_circle(&r->surface[i], H, 1.5 * H, (0.5 + 0.01 * (double)i) * H, 200, true);
  }
  r->floats = true;
  free(r->events[0].name);
  r->n_events = 0;
  return r;
}

static void test_a_body_that_floats_does_not_break(void) {
  static const char why[] = "the water is a body that floats, not a wave that breaks";
  struct case_file c;
  settings_make(&c);
  struct result_file *a = drop("a"), *b = drop("b");
  a->n_gauges = b->n_gauges = 0;
  compare(&c, a, 1, &b);
  json_t *run = json_array_get(json_object_get(report, "runs"), 0);
  static const char *const instants[] = {"overturning", "touchdown"};
  for (size_t k = 0; k < 2; k++) {
    json_t *instant = json_object_get(run, instants[k]);
    EXPECT(json_is_null(json_object_get(instant, "t_star")));
    EXPECT_STR(json_string_value(json_object_get(instant, "t_star_unavailable")), why);
  }
  json_t *at = json_array_get(json_object_get(run, "at_times"), 1);
  EXPECT(json_is_null(json_object_get(at, "jet")));
  EXPECT(!file_says("report.html", "id=\"jet\""));
  a->n_gauges = b->n_gauges = 1;
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* In a picture, gnuplot's own marks and escapes are text as well, and what cannot be shown is
 * visible. */
static void picture_shows(const char *figure, const char *words) {
  char path[PATH_MAX], name[64];
  snprintf(name, sizeof name, "figures/%s.svg", figure);
  path_in(name, path);
  xmlDocPtr picture = xmlReadFile(path, NULL, XML_PARSE_NONET | XML_PARSE_NOERROR);
  EXPECT(picture != NULL);
  xmlChar *content = picture ? xmlNodeGetContent(xmlDocGetRootElement(picture)) : NULL;
  EXPECT(content && strstr((char *)content, words));
  xmlFree(content);
  xmlFreeDoc(picture);
}

/* Hostile names stay text: the page has its own scripts only, may load nothing, and gnuplot and the
 * shell run nothing. What a browser makes of it: tests/page. */
static void test_names_stay_text(void) {
  struct case_file c;
  char path[PATH_MAX], *bytes = NULL;
  size_t n;
  settings_make(&c);
  struct result_file *a =
      made_up("ref'`touch /tmp/plunge-was-here`",
              "</title><script>alert(1)</script> \xff & \x01 \xc0\xae \xed\xa0\x80 é \u202e",
              (struct flaws){.until = end});
  struct result_file *b = made_up("run\"'; system 'touch /tmp/plunge-was-here'; '<img src=x>", "t",
                                  (struct flaws){.raised = 0.01, .until = end}),
                     *d = made_up("\x1b[31m\\n{/Symbol a}^2\xc2\x9b@_b", "t",
                                  (struct flaws){.raised = 0.02, .until = end});
  struct result_file *runs[] = {b, d};
  compare(&c, a, 2, runs);
  EXPECT(access("/tmp/plunge-was-here", F_OK) != 0);
  picture_shows("energy", "\\x1b[31m\\n{/Symbol a}^2\\xc2\\x9b@_b");
  picture_shows("pressure-P--1-", "\\x1b[31m\\n{/Symbol a}^2\\xc2\\x9b@_b");
  path_in("report.html", path);
  EXPECT_OK(cmp_file_read(path, &bytes, &n));
  if (!bytes) return;
  EXPECT(count(bytes, "<script") == 5 && count(bytes, "</script") == 5 &&
         count(bytes, "<!--") == 0);
  EXPECT(strstr(bytes, "default-src 'none'; img-src data:;") && !strstr(bytes, "<img src=x>"));
  EXPECT(strstr(bytes, "&lt;script&gt;alert(1)&lt;/script&gt; \\xff &amp; \\x01 \\xc0\\xae "
                       "\\xed\\xa0\\x80 é \\xe2\\x80\\xae"));
  EXPECT(strstr(bytes, "prefers-color-scheme: dark"));
  free(bytes);
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
  result_file_destroy(d);
}

/* Ten periods of ringing at a probe, of which the mean over a period leaves a bump at either end:
 * A (1 - cos w u)/(w T) while the burst fills u of it, so that over the time 4 its rms is
 * A sqrt(3 T/4)/(2 pi); ten rows a period take (w h)^2/12 = 3 % from sines and bumps alike. The
 * raw signal's is A sqrt(T 10/2/4). An experiment that rings alike is averaged alike. */
static void test_probes_are_compared_by_their_means(void) {
  const double A = 0.3, period = 0.2, p0 = density * g * H, T = sqrt(H / g);
  struct case_probe probe = {.name = (char[]){"P \"1\""}};
  struct case_average average = {0, period * T};
  struct case_file c;
  settings_make(&c);
  c.n_probes = 1;
  c.probes = &probe;
  struct result_file *a = made_up("a", "ringing", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "ringing", (struct flaws){.until = end});
  a->n_experiments = 1;
  a->experiments = calloc(1, sizeof *a->experiments);
  struct case_experiment *e = a->experiments;
  *e = (struct case_experiment){
      text("measured"), text("nobody"), text(probe.name), ROWS, NULL, NULL};
  e->t = calloc(ROWS, sizeof *e->t);
  e->value = calloc(ROWS, sizeof *e->value);
  for (int i = 0; i < ROWS; i++) {
    double t = end * i / (ROWS - 1);
    if (i > 50 && i < 150) b->probes->value[i] += A * p0 * sin(2 * M_PI / period * (t - 1));
    e->t[i] = t * T;
    e->value[i] = b->probes->value[i];
  }
  struct comparison *raw;
  EXPECT_OK(cmp_comparison_create(&c, a, 1, &b, false, &raw));
  EXPECT_NEAR(raw->run[0].pairs[0].m.rms.value, A * sqrt(period * 10 / 2 / 4), 0.04 * A);
  cmp_comparison_destroy(raw);
  c.compare.n_averages = 1;
  c.compare.averages = &average;
  compare(&c, a, 1, &b);
  const double left = A * sqrt(3 * period / 4) / (2 * M_PI);
  EXPECT_NEAR(value_of("probe_rms", "b", 0), left, 0.08 * left);
  EXPECT_NEAR(value_of("experiment_probe_rms", "b", 0), 0, 1e-12);
  EXPECT(file_says("report.html", "running means over 0.2 √(H/g)"));
  EXPECT(file_says("report.json", "P \\\"1\\\", mean over 0.2"));
  EXPECT(file_says("figures/pressure-P--1-.csv", "mean pressure [rho g H],raw pressure [rho g H]"));
  json_t *run = json_array_get(json_object_get(report, "runs"), 0), *signals, *signal;
  size_t i, averaged = 0;
  signals = json_object_get(run, "signals");
  json_array_foreach(signals, i, signal) averaged +=
      fabs(json_number_value(json_object_get(signal, "averaged_over")) - 0.2) < 1e-12;
  EXPECT(json_array_size(signals) == 3 && averaged == 2); /* and the gauge is not */
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
}

/* Every figure is there in three formats with its data and script, and nothing temporary is left.
 */
static void test_figures_are_complete(void) {
  static const char *const suffixes[] = {".svg", ".pdf", ".png", ".gp"};
  char path[PATH_MAX];
  path_in("figures", path);
  DIR *dir = opendir(path);
  EXPECT(dir != NULL);
  size_t figures = 0;
  for (struct dirent *e; dir && (e = readdir(dir));) {
    EXPECT(e->d_name[0] != '.' || strlen(e->d_name) <= 2 || !strcmp(e->d_name, ".written"));
    char *dot = strrchr(e->d_name, '.');
    if (!dot || strcmp(dot, ".gp")) continue;
    figures++;
    for (size_t k = 0; k < 4; k++) {
      char name[300], file[PATH_MAX];
      struct stat info;
      snprintf(name, sizeof name, "figures/%.*s%s", (int)(dot - e->d_name), e->d_name, suffixes[k]);
      path_in(name, file);
      EXPECT(stat(file, &info) == 0 && info.st_size > 200 && info.st_size < 3000000);
    }
  }
  if (dir) closedir(dir);
  EXPECT(figures >= 8); /* distance, 4 energies, probe, gauge, 2 overlays */
}

int main(void) {
  if (system("command -v gnuplot >/dev/null")) {
    puts("gnuplot is not installed");
    return 77;
  }
  if (!mkdtemp(folder)) return 1;
  RUN(test_identity_passes_every_check);
  RUN(test_nothing_in_common);
  RUN(test_unnamed_runs_are_drawn);
  RUN(test_curves_beyond_the_frame);
  RUN(test_probes_are_compared_by_their_means);
  RUN(test_names_stay_text);
  RUN(test_figures_are_complete);
  gnuplot_pretend(); /* pictures are drawn enough */
  RUN(test_known_flaws_are_measured);
  RUN(test_what_a_tank_that_moves_takes_is_not_lost);
  RUN(test_measures_list_themselves);
  RUN(test_missing_times_are_not_zero);
  RUN(test_sentence_of_a_run_that_is_never_near);
  RUN(test_sentence_groups_runs);
  RUN(test_page_without_figures);
  RUN(test_many_runs);
  RUN(test_sensor_of_a_run_alone_is_drawn);
  RUN(test_a_body_that_floats_does_not_break);
  json_decref(report);
  folder_remove(folder);
  return TEST_RESULT;
}

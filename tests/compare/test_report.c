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

#include "compare/output.h"
#include "tests/compare/shapes.h"
#include "tests/test.h"

enum { OUTPUTS = 21, ROWS = 201 };
static const double H = 0.5, g = 9.81, density = 1000, end = 4; /* end in sqrt(H/g) */

static char *text(const char *s) {
  char *copy = strdup(s);
  if (!copy) abort();
  return copy;
}

struct flaws { /* of a run, all dimensionless */
  double raised, decay, late, until;
};

/* The level 1 + 0.1 cos(pi x) cos(2 t), raised by `raised`; mechanical energy 1 - decay t. */
static struct result_file *made_up(const char *name, const char *title, struct flaws f) {
  struct result_file *r = calloc(1, sizeof *r);
  const double T = sqrt(H / g), p0 = density * g * H, E = p0 * H * H;
  r->path = text("no such file.h5");
  r->solver = text("made up");
  r->run = text(name);
  r->title = text(title);
  r->version = text("0");
  r->revision = text("<b>none</b>");
  r->case_text = text("title: <script>alert('case')</script>\n");
  r->fingerprint = text("0123");
  r->water_fingerprint = text("4567");
  r->ended = text("");
  r->health = text("");
  r->complete = true;
  r->H = H;
  r->g = g;
  r->density = density;
  r->spacing = 0.04 * H;
  r->rest_potential = 2 * E;
  r->walls = shape_tank(2 * H, 3 * H);

  r->surface_time = calloc(OUTPUTS, sizeof *r->surface_time);
  r->surface = calloc(OUTPUTS, sizeof *r->surface);
  for (int i = 0; i < OUTPUTS; i++) {
    double t = end * i / (OUTPUTS - 1);
    if (t > f.until + 1e-9) break;
    struct geo_lines *l = &r->surface[r->n_surfaces];
    r->surface_time[r->n_surfaces++] = t * T;
    shape_open(l);
    for (int k = 0; k <= 100; k++) {
      double x = 0.02 * k;
      shape_point(l, x * H, H * (1 + f.raised + 0.1 * cos(M_PI * x) * cos(2 * t)));
    }
  }
  r->energy = calloc(ROWS, sizeof *r->energy);
  r->steps = calloc(ROWS, sizeof *r->steps);
  r->probes = calloc(1, sizeof *r->probes);
  r->gauges = calloc(1, sizeof *r->gauges);
  r->n_probes = r->n_gauges = 1;
  r->n_energy = r->n_steps = ROWS;
  struct result_series *signal[] = {r->probes, r->gauges};
  for (int s = 0; s < 2; s++) {
    signal[s]->name = text(s ? "G'1`touch x`" : "P \"1\"");
    signal[s]->units = text(s ? "m" : "Pa");
    signal[s]->n = ROWS;
    signal[s]->t = calloc(ROWS, sizeof(double));
    signal[s]->value = calloc(ROWS, sizeof(double));
  }
  for (int i = 0; i < ROWS; i++) {
    double t = end * i / (ROWS - 1), pulse = 0.8 * exp(-pow((t - 2 - f.late) / 0.2, 2));
    double lost = f.decay * t;
    r->energy[i] = (struct result_energy){.time = t * T,
                                          .kinetic = 0.25 * E * t / end,
                                          .potential = (3 - 0.25 * t / end - lost) * E,
                                          .viscosity = lost * E};
    r->steps[i] = (struct result_step){.time = t * T, .volume = 2 * H * H * (1 + f.raised)};
    r->probes->t[i] = r->gauges->t[i] = t * T;
    r->probes->value[i] = pulse * p0;
    r->gauges->value[i] = H * (1 + f.raised);
  }
  r->n_events = 1;
  r->events = calloc(1, sizeof *r->events);
  r->events[0] = (struct result_event_read){text("wall_impact"), 3 * T, 2 * H, 0};
  return r;
}

/* What the tests look up in report.json. */
static json_t *report;
static char folder[] = "/tmp/plunge-report-XXXXXX";

static void path_in(const char *name, char *out) {
  if (cmp_path_join(folder, name, out) != OK) abort();
}

static struct cmp_verdict compare(struct case_file *settings, struct result_file *ref, size_t n,
                                  struct result_file *const *runs) {
  struct cmp_verdict verdict = {0};
  char path[PATH_MAX];
  EXPECT_OK(cmp_report(settings, ref, n, runs, folder, &verdict));
  path_in("report.json", path);
  json_decref(report);
  report = json_load_file(path, 0, NULL);
  EXPECT(report != NULL);
  return verdict;
}

static double value_of(const char *measure, const char *run, double t) {
  size_t i;
  json_t *row;
  json_array_foreach(json_object_get(report, "measures"), i, row) {
    if (strcmp(json_string_value(json_object_get(row, "measure")), measure)) continue;
    if (strcmp(json_string_value(json_object_get(row, "run")), run)) continue;
    json_t *at = json_object_get(row, "t_star");
    if (json_is_null(at) || fabs(json_number_value(at) - t) < 1e-9) {
      json_t *value = json_object_get(row, "value");
      return json_is_null(value) ? NAN : json_number_value(value);
    }
  }
  TEST_FAIL("%s of %s is not in the report", measure, run);
  return NAN;
}

static struct case_tolerance everything[64];
static double times[2];

/* One tolerance per measure that these runs have (they have no jet and no experiments). */
static void settings_make(struct case_file *c) {
  static const char *const missing[] = {"jet_", "overturning", "touchdown", "experiment"};
  *c = (struct case_file){0};
  times[0] = 2 * sqrt(H / g);
  times[1] = 4 * sqrt(H / g);
  c->compare.n_times = 2;
  c->compare.times = times;
  c->compare.window = (struct geo_box){{-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
  c->compare.tolerances = everything;
  for (size_t m = 0; m < CMP_N_MEASURES; m++) {
    bool skip = false;
    for (size_t k = 0; k < 4; k++)
      skip = skip || !strncmp(cmp_measures[m].name, missing[k], strlen(missing[k]));
    if (skip) continue;
    everything[c->compare.n_tolerances++] =
        (struct case_tolerance){.measure = text(cmp_measures[m].name), .at = NAN, .max = 1e-12};
  }
}

static void settings_free(struct case_file *c) {
  for (size_t k = 0; k < c->compare.n_tolerances; k++) free(everything[k].measure);
}

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
  EXPECT_NEAR(value_of("budget", "b", 0), 0, 1e-12); /* what is lost is in viscosity */
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
  EXPECT(v.failed == 5); /* the five measures of surfaces at the second time */
  EXPECT(strstr(v.sentence, "t* = 3"));
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
  EXPECT(cmp_report(&c, a, 1, &b, folder, &v) == ERR_IO);
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

/* Two hundred runs: every figure is drawn; keys name 28 runs, each in a style of its own, and say
 * how many there are besides; what has panels has twelve. */
static void test_many_runs(void) {
  enum { MANY = 200 };
  struct case_file c;
  settings_make(&c);
  struct result_file *a = made_up("ref", "many", (struct flaws){.until = end}), *runs[MANY];
  for (int r = 0; r < MANY; r++) {
    char name[32];
    snprintf(name, sizeof name, "run-%d", r);
    runs[r] = made_up(name, "", (struct flaws){.raised = 1e-4 * r, .decay = 1e-4, .until = end});
  }
  compare(&c, a, MANY, runs);
  char *energy = script_of("energy"), *pressure = script_of("pressure-P--1-");
  EXPECT(count(energy, "title 'run-") == 28 && count(energy, "title 'ref'") == 1);
  EXPECT(count(energy, "title '172 other runs'") == 1);
  EXPECT(count(energy, "dashtype (9,4) linecolor '#0072b2'") == 1);
  EXPECT(count(energy, "dashtype (9,3,2,3) linecolor '#7f7f7f'") == 1);
  EXPECT(count(pressure, "set yrange") == 12 && count(pressure, "title 'run-") == 12);
  /* the twelve: six that agree longest, six that leave first */
  EXPECT(strstr(pressure, "title 'run-0'") && strstr(pressure, "title 'run-199'"));
  EXPECT(!strstr(pressure, "title 'run-100'"));
  free(energy);
  free(pressure);
  char path[PATH_MAX], *page = NULL;
  size_t n;
  path_in("report.html", path);
  EXPECT_OK(cmp_file_read(path, &page, &n));
  EXPECT(page && strstr(page, "the 172 others are drawn in thin grey"));
  EXPECT(page && strstr(page, "the 188 others have no panel") && !strstr(page, "is missing"));
  free(page);
  settings_free(&c);
  result_file_destroy(a);
  for (int r = 0; r < MANY; r++) result_file_destroy(runs[r]);
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

static void test_other_scales_are_refused(void) {
  struct case_file c;
  settings_make(&c);
  struct result_file *a = made_up("a", "", (struct flaws){.until = end});
  struct result_file *b = made_up("b", "", (struct flaws){.until = end});
  struct cmp_verdict v;
  b->H *= 2;
  EXPECT(cmp_report(&c, a, 1, &b, folder, &v) == ERR_INPUT);
  EXPECT(strstr(status_message(), "not of the same case"));
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

/* Hostile names stay text: the page is well-formed, has no script, loads nothing, and gnuplot and
 * the shell run nothing. */
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
  xmlDocPtr page = xmlReadMemory(bytes, (int)n, "report.html", NULL,
                                 XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_HUGE);
  EXPECT(page != NULL);
  xmlFreeDoc(page);
  EXPECT(!strstr(bytes, "<script") && !strstr(bytes, "http") && !strstr(bytes, "<img src=x>"));
  EXPECT(strstr(bytes, "&lt;script&gt;alert(1)&lt;/script&gt; \\xff &amp; \\x01 \\xc0\\xae "
                       "\\xed\\xa0\\x80 é \\xe2\\x80\\xae"));
  EXPECT(strstr(bytes, "prefers-color-scheme:dark"));
  free(bytes);
  settings_free(&c);
  result_file_destroy(a);
  result_file_destroy(b);
  result_file_destroy(d);
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
    EXPECT(e->d_name[0] != '.' || strlen(e->d_name) <= 2);
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
  EXPECT(figures >= 9); /* distance, front, 4 energies, probe, gauge, 2 overlays */
}

static void folder_remove(const char *path) {
  DIR *dir = opendir(path);
  for (struct dirent *e; dir && (e = readdir(dir));) {
    char inner[PATH_MAX];
    if (!strcmp(e->d_name, ".") || !strcmp(e->d_name, "..")) continue;
    if (cmp_path_join(path, e->d_name, inner) != OK) continue;
    if (unlink(inner) != 0) folder_remove(inner);
  }
  if (dir) closedir(dir);
  rmdir(path);
}

int main(void) {
  if (system("command -v gnuplot >/dev/null")) {
    puts("gnuplot is not installed");
    return 77;
  }
  if (!mkdtemp(folder)) return 1;
  RUN(test_identity_passes_every_check);
  RUN(test_known_flaws_are_measured);
  RUN(test_missing_times_are_not_zero);
  RUN(test_sentence_groups_runs);
  RUN(test_page_without_figures);
  RUN(test_nothing_in_common);
  RUN(test_many_runs);
  RUN(test_curves_beyond_the_frame);
  RUN(test_other_scales_are_refused);
  RUN(test_names_stay_text);
  RUN(test_figures_are_complete);
  json_decref(report);
  folder_remove(folder);
  return TEST_RESULT;
}

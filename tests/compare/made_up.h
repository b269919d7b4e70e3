/* Runs made up for the comparator, whose differences are known: a standing wave of small amplitude
 * in a tank of length 2, whose energy decays at a known rate, with a probe and a gauge. */
#pragma once
#include <dirent.h>
#include <jansson.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "compare/output.h"
#include "compare/report.h"
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

static inline void made_up_texts(struct result_file *r, const char *name, const char *title) {
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
}

static inline void made_up_surfaces(struct result_file *r, struct flaws f) {
  r->surface_time = calloc(OUTPUTS, sizeof *r->surface_time);
  r->surface = calloc(OUTPUTS, sizeof *r->surface);
  for (int i = 0; i < OUTPUTS; i++) {
    double t = end * i / (OUTPUTS - 1);
    if (t > f.until + 1e-9) break;
    struct geo_lines *l = &r->surface[r->n_surfaces];
    r->surface_time[r->n_surfaces++] = t * sqrt(H / g);
    shape_open(l);
    for (int k = 0; k <= 100; k++) {
      double x = 0.02 * k;
      shape_point(l, x * H, H * (1 + f.raised + 0.1 * cos(M_PI * x) * cos(2 * t)));
    }
  }
}

static inline struct result_series *made_up_signal(const char *name, const char *units) {
  struct result_series *s = calloc(1, sizeof *s);
  s->name = text(name);
  s->units = text(units);
  s->n = ROWS;
  s->t = calloc(ROWS, sizeof(double));
  s->value = calloc(ROWS, sizeof(double));
  return s;
}

static inline void made_up_rows(struct result_file *r, struct flaws f) {
  const double T = sqrt(H / g), p0 = density * g * H, E = p0 * H * H;
  r->energy = calloc(ROWS, sizeof *r->energy);
  r->steps = calloc(ROWS, sizeof *r->steps);
  r->probes = made_up_signal("P \"1\"", "Pa");
  r->gauges = made_up_signal("G'1`touch x`", "m");
  r->n_probes = r->n_gauges = 1;
  r->n_energy = r->n_steps = ROWS;
  for (int i = 0; i < ROWS; i++) {
    double t = end * i / (ROWS - 1), pulse = 0.8 * exp(-pow((t - 2 - f.late) / 0.2, 2));
    double lost = f.decay * t;
    r->energy[i] = (struct result_energy){.time = t * T,
                                          .kinetic = 0.25 * E * t / end,
                                          .potential = (3 - 0.25 * t / end - lost) * E,
                                          .term = {lost * E, 0}};
    r->steps[i] = (struct result_step){.time = t * T, .volume = 2 * H * H * (1 + f.raised)};
    r->probes->t[i] = r->gauges->t[i] = t * T;
    r->probes->value[i] = pulse * p0;
    r->gauges->value[i] = H * (1 + f.raised);
  }
}

/* The level 1 + 0.1 cos(pi x) cos(2 t), raised by `raised`; mechanical energy 1 - decay t. */
static struct result_file *made_up(const char *name, const char *title, struct flaws f) {
  struct result_file *r = calloc(1, sizeof *r);
  made_up_texts(r, name, title);
  r->complete = true;
  r->H = H;
  r->g = g;
  r->density = density;
  r->spacing = 0.02 * H;
  r->rest_potential = 2 * density * g * H * H * H;
  r->walls = shape_tank(2 * H, 3 * H);
  made_up_surfaces(r, f);
  made_up_rows(r, f);
  r->n_terms = 2;
  r->terms = calloc(2, sizeof *r->terms);
  r->terms[0] = (struct result_term_read){text("lost <b>"), text("what was lost"), false};
  r->terms[1] = (struct result_term_read){text("nothing"), text("a term that stays zero"), false};
  r->n_events = 1;
  r->events = calloc(1, sizeof *r->events);
  r->events[0] =
      (struct result_event_read){.name = text("wall_impact"), .time = 3 * sqrt(H / g), .x = 2 * H};
  return r;
}

/* What the tests look up in report.json. */
static json_t *report;
static char folder[] = "/tmp/plunge-report-XXXXXX";

static void path_in(const char *name, char *out) {
  if (cmp_path_join(folder, name, out) != OK) abort();
}

static bool anyway;

/* Where the test is not about pictures: a gnuplot before the real one that draws nothing. */
static inline void gnuplot_pretend(void) {
  static const char script[] = "#!/bin/sh\n"
                               "printf '%40s' '</svg>' >${2%.gp}.svg\n"
                               "printf '%40s' '%%EOF' | tee ${2%.gp}.pdf >${2%.gp}-column.pdf\n"
                               "printf '%40s' IEND >${2%.gp}.png\n";
  char bin[PATH_MAX], path[PATH_MAX], *usual = text(getenv("PATH")), *both;
  path_in("bin", bin);
  if (cmp_directory_make(bin) != OK || cmp_path_join(bin, "gnuplot", path) != OK) abort();
  FILE *f = fopen(path, "w");
  if (!f || fputs(script, f) < 0 || fclose(f) != 0 || chmod(path, 0777) != 0) abort();
  if (asprintf(&both, "%s:%s", bin, usual) < 0) abort();
  setenv("PATH", both, 1);
  free(both);
  free(usual);
}

static struct cmp_verdict compare(struct case_file *settings, struct result_file *ref, size_t n,
                                  struct result_file *const *runs) {
  struct cmp_verdict verdict = {0};
  char path[PATH_MAX];
  EXPECT_OK(cmp_report(settings, ref, n, runs, anyway, folder, &verdict));
  path_in("report.json", path);
  json_decref(report);
  report = json_load_file(path, 0, NULL);
  EXPECT(report != NULL);
  return verdict;
}

/* A file of the report; the caller frees it. */
static inline char *read_whole(const char *name) {
  char path[PATH_MAX], *bytes = NULL;
  size_t n;
  path_in(name, path);
  EXPECT_OK(cmp_file_read(path, &bytes, &n));
  return bytes ? bytes : text("");
}

static inline bool file_says(const char *name, const char *words) {
  char *bytes = read_whole(name);
  const bool said = strstr(bytes, words);
  free(bytes);
  return said;
}

static inline double value_of(const char *measure, const char *run, double t) {
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

/* One tolerance per measure that these runs have (no jet, no experiment, no front, no impact). */
static void settings_make(struct case_file *c) {
  *c = (struct case_file){0};
  times[0] = 2 * sqrt(H / g);
  times[1] = 4 * sqrt(H / g);
  c->compare.n_times = 2;
  c->compare.times = times;
  c->compare.window = (struct geo_box){{-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
  c->compare.tolerances = everything;
  for (size_t m = 0; m < CMP_N_MEASURES; m++) {
    if (cmp_measure_sections[m] == CMP_SECTION_JET ||
        cmp_measure_sections[m] == CMP_SECTION_FRONT || m == CMP_MEASURE_budget_before_impact ||
        m == CMP_MEASURE_experiment_probe_rms || m == CMP_MEASURE_experiment_gauge_rms ||
        m == CMP_MEASURE_profile_distance)
      continue;
    everything[c->compare.n_tolerances++] =
        (struct case_tolerance){.measure = text(cmp_measures[m].name), .at = NAN, .max = 1e-12};
  }
}

static void settings_free(struct case_file *c) {
  for (size_t k = 0; k < c->compare.n_tolerances; k++) free(everything[k].measure);
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

/* A small case built by hand and a run of it with awkward numbers, for the tests of result files.
 */
#pragma once
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "common/case/case.h"
#include "common/flow/flow.h"
#include "common/result/result.h"

struct sample_options {
  double alpha;
  int order, diffusion;
  bool frozen;
};
static const char *const sample_diffusions[] = {"none", "antuono", NULL};
static const struct param sample_params[] = {
    {"alpha", PARAM_REAL, QTY_VELOCITY, offsetof(struct sample_options, alpha), 0, 1, "0.01", NULL,
     "a number with a unit", NULL},
    {"order", PARAM_INT, QTY_NUMBER, offsetof(struct sample_options, order), 1, 4, "4", NULL,
     "a count", NULL},
    {"diffusion", PARAM_CHOICE, QTY_NUMBER, offsetof(struct sample_options, diffusion), 0, 0,
     "none", sample_diffusions, "a choice", NULL},
    {"frozen", PARAM_BOOL, QTY_NUMBER, offsetof(struct sample_options, frozen), 0, 0, "true", NULL,
     "a switch", NULL},
};
static const struct solver_term sample_terms[] = {{"friction", "what friction takes", false},
                                                  {"other", "what else", true}};
static const struct solver sample_solver = {.name = "sample",
                                            .help = "writes made-up numbers",
                                            .params = sample_params,
                                            .n_params = 4,
                                            .terms = sample_terms,
                                            .n_terms = 2,
                                            .options_size = sizeof(struct sample_options)};

static struct sample_options sample_chosen = {0.0123456789012345678, 3, 1, true};
static struct case_run sample_runs[] = {
    {.name = "antuono", .solver = &sample_solver, .resolution = 23.85, .options = &sample_chosen}};
static struct case_probe sample_probes[] = {{"P/1", 3.2196, 0.1596, 0.09}, {"P0", 0, 1e-17, 0}};
static struct case_gauge sample_gauges[] = {{"G1", 1.2000000000000002}};
static struct case_point sample_points[] = {{"above/1", 0.1, 1e-17, 3, false},
                                            {"A", 2.385, 0.3, 1, true}};
static double sample_t[] = {0.1, 0.30000000000000004, 7},
              sample_value[] = {-1e-300, 5e-324, 1.7e308};
static struct case_experiment sample_experiments[] = {
    {"Büchner 2002, digitisation “a”", "a/b & <c>", "P/1", 3, sample_t, sample_value}};

static double sample_profile_x[] = {0.1, 0.2}, sample_profile_y[] = {-1e-300, 0.30000000000000004};
static struct case_profile sample_profiles[] = {
    {"photograph “b”", "c <d>", 0.30000000000000004, 2, sample_profile_x, sample_profile_y}};

/* The caller destroys it with sample_case_destroy. */
static inline struct case_file *sample_case(void) {
  struct case_file *c = calloc(1, sizeof *c);
  c->path = "sample.yaml";
  c->text = "title: sample\nfluid: {density: 1000}\n";
  c->title = "A sample of é, ≤ and \"quotes\"";
  c->density = 998.2;
  c->gravity = c->g = 9.80665;
  c->H = 0.6;
  double walls[][2] = {{0, 1.8}, {0, 0}, {3.2196, 0}, {3.2196, 1.8}};
  double water[][2] = {{0, 0}, {1.2, 0}, {1.2, 0.6}, {0, 0.6}};
  geo_lines_begin(&c->walls, false);
  for (int i = 0; i < 4; i++) geo_lines_add(&c->walls, walls[i][0], walls[i][1]);
  geo_lines_begin(&c->water, true);
  for (int i = 0; i < 4; i++) geo_lines_add(&c->water, water[i][0], water[i][1]);
  c->tank = geo_lines_box(&c->walls);
  c->rectangular = true;
  c->flow = &flow_hydrostatic;
  c->end = 1;
  c->every = 0.1;
  c->sample = 0.01;
  c->n_probes = 2;
  c->probes = sample_probes;
  c->n_gauges = 1;
  c->gauges = sample_gauges;
  c->n_points = 2;
  c->points = sample_points;
  c->n_runs = 1;
  c->runs = sample_runs;
  c->compare.reference = 1;
  c->compare.n_experiments = 1;
  c->compare.experiments = sample_experiments;
  c->compare.n_profiles = 1;
  c->compare.profiles = sample_profiles;
  return c;
}

static inline void sample_case_destroy(struct case_file *c) {
  geo_lines_destroy(&c->walls);
  geo_lines_destroy(&c->water);
  free(c);
}

static inline double sample_time(size_t output) {
  return (double)output * 0.1 + 1e-17;
}

/* Points of one output; n grows and shrinks from output to output. */
static inline size_t sample_n(size_t output, size_t scale) {
  return scale + output % 3;
}
static inline double sample_x(size_t output, size_t i) {
  return 0.1 * (double)i + 1.0 / 3 + 1e-9 * (double)output;
}

/* Appends output k (surface, points, ten rows of each series, an event) and flushes. */
static inline enum status sample_output(struct result *w, size_t k, size_t scale) {
  double t = sample_time(k);
  size_t n = sample_n(k, scale);
  double *x = malloc(3 * n * sizeof *x), *y = x + n, *p = y + n;
  for (size_t i = 0; i < n; i++) {
    x[i] = sample_x(k, i);
    y[i] = sin(12.9898 * (double)(i + k));
    p[i] = 1000 * y[i] / 7;
  }
  struct geo_lines surface = {0};
  enum status status = OK;
  for (size_t piece = 0; piece < k % 4; piece++) { /* the first has no piece at all */
    ATTEMPT(geo_lines_begin(&surface, piece > 0));
    for (size_t i = 0; i <= k + piece; i++) ATTEMPT(geo_lines_add(&surface, x[i % n], y[i % n]));
  }
  struct result_field fields[] = {{"pressure", "Pa", "pressure", p, NULL},
                                  {"velocity", "m/s", "velocity", y, x}};
  ATTEMPT(result_points(w, t, n, x, y, RESULT_VERTICES, 2, fields));
  ATTEMPT(result_surface(w, t, &surface));
  for (int i = 0; i < 10; i++) {
    double ti = t + 0.01 * i;
    ATTEMPT(result_energy(
        w, &(struct result_energy){ti, 1 / 3.0, -2 / 7.0, 1e-300, ti * ti, -0.0, {5, 6}}));
    ATTEMPT(result_step(w, &(struct result_step){ti, 1e-5, 4.0 * (double)k, 0.5, 0.72, 0}));
    ATTEMPT(result_probe(w, 0, ti, ti * 9810));
    if (i % 2)
      ATTEMPT(result_point(w, 1, ti, (double[]){ti, 998.2, -0.0, NAN, 5e-324, 7, 0.5, 0.1, -3}));
    ATTEMPT(result_gauge(w, 0, ti, i % 2 ? NAN : 0.6 + ti));
  }
  ATTEMPT(result_event(w, "touchdown", t, 2.385, 0.01));
  ATTEMPT(result_statistic(w, "steps", (double)k, "1", "number of outputs so far"));
  ATTEMPT(result_flush(w));
done:
  free(x);
  geo_lines_destroy(&surface);
  return status;
}

/* The folder in which a test writes; removed by sample_folder_remove. */
static inline const char *sample_folder(void) {
  static char folder[64];
  if (!*folder) {
    const char *memory = "/dev/shm"; /* finishing a result waits for the disk */
    snprintf(folder, sizeof folder, "%s/plunge-test-XXXXXX",
             access(memory, W_OK) ? "/tmp" : memory);
    if (!mkdtemp(folder)) perror(folder), exit(1);
  }
  return folder;
}

static inline void sample_folder_remove(void) {
  char command[128];
  snprintf(command, sizeof command, "rm -rf '%s'", sample_folder());
  if (system(command)) perror(command);
}

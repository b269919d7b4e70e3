#include <argp.h>
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "common/base/text.h"

/* One line a run: how large, how much memory, how long. */
static void print_estimates(const struct case_file *c) {
  int width = 0;
  for (size_t i = 0; i < c->n_runs; i++)
    if ((int)strlen(c->runs[i].name) > width) width = (int)strlen(c->runs[i].name);
  for (size_t i = 0; i < c->n_runs; i++) {
    const struct case_run *r = &c->runs[i];
    struct solver_estimate e = {0};
    char time[32];
    r->solver->estimate(c, r, &e);
    progress_format_time(time, sizeof time, fmax(1, solver_seconds(&e, omp_get_max_threads())));
    printf("  %-*s  %.0f %s, %.0f MB of memory, roughly %s\n", width, r->name, e.points, e.unit,
           1e-6 * e.bytes, time);
  }
}

/* What to know before the runs, of each that has any. */
static void print_warnings(const struct case_file *c) {
  for (size_t i = 0; i < c->n_runs; i++) {
    const struct case_run *r = &c->runs[i];
    struct problems warnings = {0};
    if (r->solver->warn) r->solver->warn(c, r, &warnings);
    for (size_t k = 0; k < warnings.n; k++)
      fprintf(stderr, "  %s: %s\n", r->name, warnings.text[k]);
    problems_destroy(&warnings);
  }
}

static int check(const char *path, const struct command_set *set) {
  int exit_code;
  struct case_file *c = command_load_case(path, set->n, set->item, &exit_code);
  if (!c) return exit_code;
  exit_code = command_check_room(c, NULL, set->n, set->item);
  if (exit_code == EXIT_FINE) {
    text_show(stdout, c->path, "");
    printf(": fine (%zu run%s)\n", c->n_runs, c->n_runs == 1 ? "" : "s");
    print_estimates(c);
    print_warnings(c);
  }
  case_destroy(c);
  return exit_code;
}

struct check_arguments {
  struct command_set set;
  char **paths; /* [n], in argv */
  size_t n;
};

static error_t parse(int key, char *arg, struct argp_state *state) {
  struct check_arguments *a = state->input;
  switch (key) {
  case 's':
    return command_set_add(&a->set, arg, state);
  case ARGP_KEY_ARGS:
    a->paths = state->argv + state->next;
    a->n = (size_t)(state->argc - state->next);
    return 0;
  case ARGP_KEY_NO_ARGS:
    argp_error(state, "name a case file");
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

int command_check(int argc, char **argv) {
  static const struct argp_option options[] = {
      {"set", 's', "PATH=VALUE", 0, "override a value, as in runs.NAME.alpha=0 or time.end=1.2", 0},
      {0}};
  static const struct argp argp = {
      .options = options,
      .parser = parse,
      .args_doc = "CASE.yaml...",
      .doc = "Validates case files and prints every problem with file, line, key, the value found "
             "and what is allowed; and what a run is warned of.",
  };
  int exit_code = EXIT_FINE;
  struct check_arguments a = {0};
  argp_parse(&argp, argc, argv, 0, NULL, &a);
  for (size_t i = 0; i < a.n; i++) {
    int code = check(a.paths[i], &a.set);
    if (code != EXIT_FINE) exit_code = code;
  }
  free(a.set.item);
  return exit_code;
}

#include <argp.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cli/command.h"
#include "common/text.h"

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
    progress_format_time(time, sizeof time, fmax(1, e.seconds));
    printf("  %-*s  %.0f %s, %.0f MB of memory, roughly %s\n", width, r->name, e.points, e.unit,
           1e-6 * e.bytes, time);
  }
}

static error_t parse(int key, char *arg, struct argp_state *state) {
  int *exit_code = state->input;
  switch (key) {
  case ARGP_KEY_ARG: {
    int code;
    struct case_file *c = command_load_case(arg, 0, NULL, &code);
    code = c ? command_check_room(c, NULL, 0, NULL) : code;
    if (code == EXIT_FINE) {
      text_show(stdout, c->path, "");
      printf(": fine (%zu run%s)\n", c->n_runs, c->n_runs == 1 ? "" : "s");
      print_estimates(c);
    } else
      *exit_code = code;
    case_destroy(c);
    return 0;
  }
  case ARGP_KEY_NO_ARGS:
    argp_error(state, "name a case file");
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

int command_check(int argc, char **argv) {
  static const struct argp argp = {
      .parser = parse,
      .args_doc = "CASE.yaml...",
      .doc = "Validates case files and prints every problem with file, line, key, the value found "
             "and what is allowed.",
  };
  int exit_code = EXIT_FINE;
  argp_parse(&argp, argc, argv, 0, NULL, &exit_code);
  return exit_code;
}

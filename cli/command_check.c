#include <argp.h>
#include <stdio.h>

#include "cli/command.h"
#include "common/text.h"

static error_t parse(int key, char *arg, struct argp_state *state) {
  int *exit_code = state->input;
  switch (key) {
  case ARGP_KEY_ARG: {
    int code;
    struct case_file *c = command_load_case(arg, 0, NULL, &code);
    if (c) {
      text_show(stdout, c->path, "");
      printf(": fine (%zu run%s)\n", c->n_runs, c->n_runs == 1 ? "" : "s");
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

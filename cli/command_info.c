#include <argp.h>
#include <stdio.h>

#include "cli/command.h"
#include "common/result_diff.h"

static error_t parse(int key, char *arg, struct argp_state *state) {
  int *exit_code = state->input;
  switch (key) {
  case ARGP_KEY_ARG: {
    enum status status = result_info(arg, stdout);
    if (status != OK) *exit_code = command_fail(status);
    return 0;
  }
  case ARGP_KEY_NO_ARGS:
    argp_error(state, "name a result file");
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

int command_info(int argc, char **argv) {
  static const struct argp argp = {
      .parser = parse,
      .args_doc = "FILE.h5...",
      .doc = "Prints what is in a result file, in a screenful.",
  };
  int exit_code = EXIT_FINE;
  argp_parse(&argp, argc, argv, 0, NULL, &exit_code);
  return exit_code;
}

#include <argp.h>
#include <stdio.h>
#include <stdlib.h>

#include "cli/command.h"
#include "common/base/text.h"
#include "common/result/result_diff.h"

/* What stands in a file goes to the terminal as text and nothing else. */
static enum status print_info(const char *path) {
  char *text = NULL;
  size_t n = 0;
  FILE *stream = open_memstream(&text, &n);
  CHECK(stream, ERR_MEMORY, "no memory to describe %s", path);
  enum status status = result_info(path, stream);
  if (fclose(stream)) status = status_raise(ERR_MEMORY, "no memory to describe %s", path);
  if (text) text_show(stdout, text, "\n\t");
  free(text);
  return status;
}

static error_t parse(int key, char *arg, struct argp_state *state) {
  int *exit_code = state->input;
  switch (key) {
  case ARGP_KEY_ARG: {
    enum status status = print_info(arg);
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
      .doc = "Prints what is in a result file.",
  };
  int exit_code = EXIT_FINE;
  argp_parse(&argp, argc, argv, 0, NULL, &exit_code);
  return exit_code;
}

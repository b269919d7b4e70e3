#include <argp.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "cli/command.h"
#include "common/base/text.h"
#include "common/result/result_diff.h"

struct diff_arguments {
  const char *file[2], *tolerances;
  double rtol, atol;
  bool draft;
  int n;
};

static double parse_tolerance(struct argp_state *state, const char *name, const char *text) {
  char *end;
  double value = strtod(text, &end);
  if (end == text || *end || !(value >= 0) || isinf(value))
    argp_error(state, "--%s %s: give a number that is not negative", name, text);
  return value;
}

static error_t parse(int key, char *arg, struct argp_state *state) {
  struct diff_arguments *a = state->input;
  switch (key) {
  case 'r':
    a->rtol = parse_tolerance(state, "rtol", arg);
    return 0;
  case 'a':
    a->atol = parse_tolerance(state, "atol", arg);
    return 0;
  case 't':
    a->tolerances = arg;
    return 0;
  case 'd':
    a->draft = true;
    return 0;
  case ARGP_KEY_ARG:
    if (a->n == 2) argp_error(state, "two files are compared; %s is the third", arg);
    a->file[a->n++] = arg;
    return 0;
  case ARGP_KEY_END:
    if (a->n < 2) argp_error(state, "name two result files");
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static enum status diff(const struct diff_arguments *a, bool *same) {
  struct result_tolerances tolerances = {0};
  enum status status;
  char *text = NULL;
  size_t n = 0;
  FILE *stream = open_memstream(&text, &n);
  ATTEMPT(stream ? OK : status_raise(ERR_MEMORY, "no memory to compare"));
  ATTEMPT(result_tolerances_default(&tolerances, a->rtol, a->atol));
  if (a->tolerances) ATTEMPT(result_tolerances_read(&tolerances, a->tolerances));
  ATTEMPT(result_diff(a->file[0], a->file[1], &tolerances, a->draft, stream, same));
done:
  if (stream) fclose(stream);
  if (text) text_show(stdout, text, "\n\t");
  free(text);
  result_tolerances_destroy(&tolerances);
  return status;
}

int command_diff(int argc, char **argv) {
  static const struct argp_option options[] = {
      {"rtol", 'r', "R", 0, "relative to the largest magnitude in a dataset (default 0)", 0},
      {"atol", 'a', "A", 0, "absolute, in the dataset's units (default 0)", 0},
      {"tol", 't', "FILE", 0, "rules per dataset, one a line: PATTERN RELATIVE ABSOLUTE", 0},
      {"draft", 'd', NULL, 0, "print such rules, just wide enough for these two files", 0},
      {0}};
  static const struct argp argp = {
      .options = options,
      .parser = parse,
      .args_doc = "A.h5 B.h5",
      .doc = "Compares two result files dataset by dataset and locates the worst differences. Exit "
             "code: 0 the same within the tolerances, 1 different, 2 trouble.",
  };
  struct diff_arguments a = {0};
  argp_parse(&argp, argc, argv, 0, NULL, &a);
  bool same = false;
  enum status status = diff(&a, &same);
  if (status != OK) {
    command_fail(status);
    return EXIT_BAD_INPUT; /* trouble, of whatever kind */
  }
  return same ? EXIT_FINE : EXIT_VERDICT;
}

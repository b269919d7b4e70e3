/* plunge import: other programs' files become a result. */
#include <argp.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "cli/command.h"
#include "cli/registry.h"
#include "common/base/text.h"
#include "import/import.h"

struct import_arguments {
  const char *sidecar, *out;
};

static error_t parse(int key, char *arg, struct argp_state *state) {
  struct import_arguments *a = state->input;
  switch (key) {
  case 'o':
    a->out = arg;
    return 0;
  case 'k':
    import_print_keys(stdout);
    exit(command_finish(EXIT_FINE));
  case ARGP_KEY_ARG:
    if (a->sidecar) argp_error(state, "name one sidecar at a time");
    a->sidecar = arg;
    return 0;
  case ARGP_KEY_NO_ARGS:
    argp_error(state, "name a sidecar");
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static void print_summary(const char *path, const struct import_summary *m) {
  text_show(stdout, path, "");
  printf(": %zu surface%s", m->surfaces, m->surfaces == 1 ? "" : "s");
  if (m->clouds) printf(", particles at %zu time%s", m->clouds, m->clouds == 1 ? "" : "s");
  if (m->rows) printf(", %zu rows of series", m->rows);
  printf(", from t = %g to %g s\n", m->first, m->last);
  if (m->particles && !m->walls)
    command_warn("the sidecar names no tank, so the surface of the particles goes round all of "
                 "them, along the bed too");
}

int command_import(int argc, char **argv) {
  static const struct argp_option options[] = {
      {"out", 'o', "FILE.h5", 0, "the result (default: RUN.h5 in the working folder)", 0},
      {"keys", 'k', NULL, 0, "print the formats and every key of a sidecar", 0},
      {0}};
  static const struct argp argp = {
      .options = options,
      .parser = parse,
      .args_doc = "SIDECAR.yaml",
      .doc = "Makes a result of other programs' files. A sidecar says what they do not: scales, "
             "units, what which column is, where the walls are (docs/import.md).",
  };
  struct import_arguments a = {0};
  struct problems problems = {0};
  struct import_summary summary;
  char *written = NULL;
  argp_parse(&argp, argc, argv, 0, NULL, &a);
  const enum status status = import_run(a.sidecar, a.out, &registry, &problems, &written, &summary);
  command_list_problems(&problems);
  if (status == OK) print_summary(written, &summary);
  int exit_code = status_exit_code(status);
  if (status != OK && !problems.n) exit_code = command_fail(status);
  problems_destroy(&problems);
  free(written);
  return exit_code;
}

/* plunge compare, and the report that plunge run ends with. */
#include <argp.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/settings.h"
#include "common/base/text.h"
#include "compare/report.h"

int command_report(const struct case_file *c, const struct result_file *ref, size_t n,
                   struct result_file *const *runs, bool anyway, const char *out,
                   struct progress *progress) {
  struct cmp_verdict verdict;
  progress_say(progress, "comparing %zu run%s with %s", n, n == 1 ? "" : "s", ref->run);
  enum status status = cmp_report(c, ref, n, runs, anyway, out, &verdict);
  if (*verdict.sentence) {
    text_show(stdout, verdict.sentence, "\n");
    putchar('\n');
  } /* even when the report could not be written */
  if (status != OK) return command_fail(status);
  if (verdict.passed + verdict.failed)
    printf("%zu of %zu checks passed; ", verdict.passed, verdict.passed + verdict.failed);
  else
    printf("the case sets no tolerance to check; ");
  fputs("report: ", stdout);
  text_show(stdout, out, "");
  puts("/report.html");
  return verdict.failed ? EXIT_VERDICT : EXIT_FINE;
}

struct compare_arguments {
  const char *out, *settings;
  char **files; /* [n], in argv */
  size_t n;
  bool anyway;
};

static error_t parse(int key, char *arg, struct argp_state *state) {
  struct compare_arguments *a = state->input;
  switch (key) {
  case 'o':
    a->out = arg;
    return 0;
  case 's':
    a->settings = arg;
    return 0;
  case 'a':
    a->anyway = true;
    return 0;
  case ARGP_KEY_ARGS:
    a->files = state->argv + state->next;
    a->n = (size_t)(state->argc - state->next);
    return 0;
  case ARGP_KEY_END:
    if (a->n < 2) argp_error(state, "name the reference and at least one run");
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

int command_compare(int argc, char **argv) {
  static const struct argp_option options[] = {
      {"out", 'o', "DIR", 0, "folder of the report (default: comparison)", 0},
      {"settings", 's', "FILE", 0,
       "times, window, tolerances, averages, filters and spectra from the section `compare` of "
       "this file",
       0},
      {"anyway", 'a', NULL, 0,
       "compare also results of another tank, water or scale, each in its own scales", 0},
      {0}};
  static const struct argp argp = {
      .options = options,
      .parser = parse,
      .args_doc = "REF.h5 RUN.h5...",
      .doc = "Compares finished results with a reference, by the settings in the reference's case "
             "or in a file of their own, "
             "and writes report.html, report.json and figures/. Exit code 1 when a check fails.",
  };
  struct compare_arguments a = {.out = "comparison"};
  argp_parse(&argp, argc, argv, 0, NULL, &a);

  int exit_code = EXIT_BAD_INPUT, lock = -1;
  struct case_file *c = NULL;
  struct progress *progress = progress_create(PROGRESS_AUTO);
  struct result_file **files = calloc(a.n, sizeof *files);
  if (!files || !progress) {
    exit_code = command_fail(status_raise(ERR_MEMORY, "no memory"));
    goto done;
  }
  for (size_t i = 0; i < a.n; i++) {
    enum status status = result_read(a.files[i], &files[i]);
    if (status == OK) continue;
    exit_code = command_fail(status);
    goto done;
  }
  const enum status found = command_find_surfaces(a.n, files, progress);
  if (found != OK) {
    exit_code = command_fail(found);
    goto done;
  }
  c = command_settings(a.settings, a.n, files, false, &exit_code);
  if (!c) goto done;
  enum status status = command_lock_folder(a.out, COMMAND_ALONE, false, progress, &lock);
  if (status != OK)
    exit_code = command_fail(status);
  else
    exit_code = command_report(c, files[0], a.n - 1, files + 1, a.anyway, a.out, progress);
done:
  if (lock >= 0) close(lock);
  for (size_t i = 0; files && i < a.n; i++) result_file_destroy(files[i]);
  free(files);
  case_destroy(c);
  progress_destroy(progress);
  return exit_code;
}

/* plunge compare, and the report that plunge run ends with. */
#include <argp.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/registry.h"
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
  printf("report: %s/report.html\n", out);
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

/* The settings in a file of their own; problems are printed. */
static struct case_file *settings_from(const char *path, size_t n, struct result_file *const *files,
                                       int *exit_code) {
  struct problems problems = {0};
  struct case_file *c = NULL;
  const struct result_file *ref = files[0];
  size_t n_probes = ref->n_probes, n_gauges = ref->n_gauges, n_points = 0;
  for (size_t i = 0; i < n; i++) n_points += files[i]->n_points; /* a reference may have none */
  /* of the runs, the probes, the gauges, the points */
  const char **names = calloc(n + n_probes + n_gauges + n_points, sizeof *names), **name = names;
  for (size_t i = 0; names && i < n; i++) *name++ = files[i]->run;
  for (size_t i = 0; names && i < n_probes; i++) *name++ = ref->probes[i].name;
  for (size_t i = 0; names && i < n_gauges; i++) *name++ = ref->gauges[i].name;
  for (size_t i = 0; names && i < n; i++)
    for (size_t k = 0; k < files[i]->n_points; k++) *name++ = files[i]->points[k].name;
  struct case_frame frame = {
      .H = files[0]->H,
      .gravity = files[0]->g,
      .tank = geo_lines_box(&files[0]->walls),
      .n_times = files[0]->n_surfaces,
      .times = files[0]->surface_time,
      .n_runs = n,
      .runs = names,
      .n_probes = n_probes,
      .probes = names ? names + n : NULL,
      .n_gauges = n_gauges,
      .gauges = names ? names + n + n_probes : NULL,
      .n_points = n_points,
      .points = names ? names + n + n_probes + n_gauges : NULL,
  };
  enum status status = names ? case_load_settings(path, &frame, &registry, &problems, &c)
                             : status_raise(ERR_MEMORY, "no memory for %zu runs", n);
  command_list_problems(&problems);
  *exit_code = status_exit_code(status);
  if (status != OK && !problems.n) command_fail(status);
  problems_destroy(&problems);
  free(names);
  return c;
}

/* The settings that stand in the reference's own case; problems are printed. */
static struct case_file *settings_of(const struct result_file *ref) {
  struct problems problems = {0};
  struct case_file *c = NULL;
  if (case_parse(ref->path, ref->case_text, &registry, &problems, &c) != OK) {
    fprintf(stderr, "plunge: the case in %s is not one that this version reads:\n", ref->path);
    command_list_problems(&problems);
  }
  problems_destroy(&problems);
  return c;
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
  c = a.settings ? settings_from(a.settings, a.n, files, &exit_code) : settings_of(files[0]);
  if (!c) goto done;
  enum status status = command_lock_folder(a.out, false, progress, &lock);
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

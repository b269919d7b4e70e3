/* plunge run: every solver run of a case that is missing or changed, then the comparison. */
#include <argp.h>
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "cli/command.h"
#include "cli/traps.h"
#include "compare/output.h"

struct run_arguments {
  const char *case_path, *out;
  char *only;
  const char **set; /* [n_set], owned; the strings are argv's */
  size_t n_set;
  int threads;
  bool force, quiet;
};

static error_t parse(int key, char *arg, struct argp_state *state) {
  struct run_arguments *a = state->input;
  char *end;
  switch (key) {
  case 'o':
    a->out = arg;
    return 0;
  case 'r':
    a->only = arg;
    return 0;
  case 's':
    if (!strchr(arg, '='))
      argp_error(state, "--set %s: write PATH=VALUE, as in runs.NAME.alpha=0", arg);
    a->set = realloc(a->set, (a->n_set + 1) * sizeof *a->set);
    if (!a->set) return ENOMEM;
    a->set[a->n_set++] = arg;
    return 0;
  case 't': {
    long threads = strtol(arg, &end, 10);
    if (end == arg || *end || threads < 1 || threads > 1024)
      argp_error(state, "--threads %s: give a whole number from 1 to 1024", arg);
    a->threads = (int)threads;
    return 0;
  }
  case 'f':
    a->force = true;
    return 0;
  case 'q':
    a->quiet = true;
    return 0;
  case ARGP_KEY_ARG:
    if (a->case_path) argp_error(state, "one case file at a time; %s is the second", arg);
    a->case_path = arg;
    return 0;
  case ARGP_KEY_END:
    if (!a->case_path) argp_error(state, "name a case file");
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

/* Marks the runs that `--only` names, all of them without it. */
static enum status choose_runs(const struct case_file *c, char *only, bool *chosen) {
  for (size_t i = 0; i < c->n_runs; i++) chosen[i] = !only;
  if (!only) return OK;
  for (char *rest = only, *name; (name = strsep(&rest, ","));) {
    size_t i = 0;
    while (i < c->n_runs && strcmp(c->runs[i].name, name)) i++;
    CHECK(i < c->n_runs, ERR_USAGE, "--only %s: %s has no run of that name", name, c->path);
    chosen[i] = true;
  }
  return OK;
}

static enum status result_path(const char *folder, const struct case_run *r, char path[PATH_MAX]) {
  int n = snprintf(path, PATH_MAX, "%s/%s.h5", folder, r->name);
  CHECK(n > 0 && n < PATH_MAX, ERR_USAGE, "--out %s: the path is too long", folder);
  return OK;
}

static enum status run_one(const struct case_file *c, const struct case_run *r, const char *path,
                           struct progress *progress) {
  struct result *out = NULL;
  enum status status;
  progress_begin(progress, r->name, c->end, sqrt(c->H / c->gravity));
  ATTEMPT(result_create(path, c, r, &out));
  traps_enable();
  status = r->solver->run(c, r, out, progress);
  traps_disable();
  if (status == OK)
    status = result_finish(out);
  else { /* the message is also the file's; a file that cannot take it keeps what was flushed */
    char why[1024];
    snprintf(why, sizeof why, "%s", status_message());
    (void)result_ended(out, why);
    (void)status_raise(status, "%s", why);
  }
done:
  result_destroy(out);
  if (status == OK)
    progress_end(progress, "done");
  else if (status == INTERRUPTED)
    progress_end(progress, "stopped; its file holds every output so far");
  else {
    progress_end(progress, "FAILED");
    status_context(status, "run %s: ", r->name);
  }
  return status;
}

/* Reads back the runs that have a file, and compares them. */
static int report(const struct case_file *c, const char *out, struct progress *progress) {
  int exit_code = EXIT_FINE;
  struct result_file *ref = NULL, **runs = calloc(c->n_runs, sizeof *runs);
  size_t n = 0;
  if (!runs) return command_fail(status_raise(ERR_MEMORY, "no memory"));
  for (size_t i = 0; i < c->n_runs; i++) {
    char path[PATH_MAX];
    struct stat s;
    if (result_path(out, &c->runs[i], path) != OK) continue; /* said so when it ran */
    if (stat(path, &s)) {
      progress_say(progress, "%s is not there: left out of the comparison", path);
      continue;
    }
    struct result_file *file = NULL;
    enum status status = result_read(path, &file);
    if (status != OK)
      exit_code = command_fail(status);
    else if (i == c->compare.reference)
      ref = file;
    else
      runs[n++] = file;
  }
  if (ref && n) {
    int verdict = command_report(c, ref, n, runs, out, progress);
    if (exit_code == EXIT_FINE) exit_code = verdict;
  } else
    progress_say(progress, "nothing to compare: the reference and one more run are needed");
  result_file_destroy(ref);
  for (size_t i = 0; i < n; i++) result_file_destroy(runs[i]);
  free(runs);
  return exit_code;
}

static int run_case(struct run_arguments *a, const struct case_file *c, struct progress *progress) {
  char folder[PATH_MAX];
  if (a->out)
    snprintf(folder, sizeof folder, "%s", a->out);
  else {
    const char *base = strrchr(a->case_path, '/');
    base = base ? base + 1 : a->case_path;
    const char *dot = strrchr(base, '.');
    int n = dot > base ? (int)(dot - base) : (int)strlen(base);
    snprintf(folder, sizeof folder, "out/%.*s", n, base);
  }
  bool *chosen = calloc(c->n_runs, sizeof *chosen);
  int exit_code = EXIT_FINE;
  enum status status = chosen ? OK : status_raise(ERR_MEMORY, "no memory");
  if (status == OK) status = choose_runs(c, a->only, chosen);
  if (status == OK) status = cmp_directory_make(folder);
  if (status != OK) {
    free(chosen);
    return command_fail(status);
  }
  for (size_t i = 0; i < c->n_runs; i++) {
    const struct case_run *r = &c->runs[i];
    char path[PATH_MAX], fingerprint[33];
    if (!chosen[i]) continue;
    if (result_path(folder, r, path) != OK) {
      exit_code = command_fail(ERR_USAGE);
      break;
    }
    case_fingerprint(c, r, fingerprint);
    if (!a->force && result_is_current(path, fingerprint)) {
      progress_say(progress, "%-10s is there already, for the same inputs: %s", r->name, path);
      continue;
    }
    status = run_one(c, r, path, progress);
    if (status != OK) exit_code = command_fail(status);
    if (status == INTERRUPTED) break;
  }
  free(chosen);
  if (status != INTERRUPTED && c->compare.reference < c->n_runs) {
    int compared = report(c, folder, progress);
    if (exit_code == EXIT_FINE) exit_code = compared;
  }
  return exit_code;
}

int command_run(int argc, char **argv) {
  static const struct argp_option options[] = {
      {"out", 'o', "DIR", 0, "folder for results and report (default: out/ and the case's name)",
       0},
      {"only", 'r', "RUN[,RUN]", 0, "only these runs of the case", 0},
      {"set", 's', "PATH=VALUE", 0, "override a value, as in runs.NAME.alpha=0 or time.end=1.2", 0},
      {"threads", 't', "N", 0, "threads (default: OMP_NUM_THREADS, else every core)", 0},
      {"force", 'f', NULL, 0, "run again even what is there for the same inputs", 0},
      {"quiet", 'q', NULL, 0, "no progress; errors and the verdict only", 0},
      {0}};
  static const struct argp argp = {
      .options = options,
      .parser = parse,
      .args_doc = "CASE.yaml",
      .doc =
          "Runs every solver run of a case, skipping those whose finished result is already there "
          "for the same inputs; then compares them with the reference and writes report.html, "
          "report.json and figures/.",
  };
  struct run_arguments a = {0};
  argp_parse(&argp, argc, argv, 0, NULL, &a);
  if (a.threads) omp_set_num_threads(a.threads);
  int exit_code = EXIT_BAD_INPUT;
  struct case_file *c = command_load_case(a.case_path, a.n_set, a.set);
  if (c) {
    struct progress *progress = progress_create(a.quiet ? PROGRESS_QUIET : PROGRESS_AUTO);
    progress_catch_signals();
    if (progress)
      exit_code = run_case(&a, c, progress);
    else
      exit_code = command_fail(status_raise(ERR_MEMORY, "no memory"));
    progress_destroy(progress);
  }
  case_destroy(c);
  free(a.set);
  return exit_code;
}

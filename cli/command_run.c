/* plunge run: every solver run of a case that is missing or changed, then the comparison. */
#include <argp.h>
#include <errno.h>
#include <limits.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/jobs.h"
#include "cli/room.h"
#include "cli/running.h"
#include "common/base/array.h"

struct run_arguments {
  const char *case_path, *out;
  char *only;
  struct command_set set;
  int threads, jobs;
  bool force, quiet, wait, no_report;
};

static error_t parse(int key, char *arg, struct argp_state *state) {
  struct run_arguments *a = state->input;
  switch (key) {
  case 'o':
    a->out = arg;
    return 0;
  case 'r':
    a->only = arg;
    return 0;
  case 's':
    return command_set_add(&a->set, arg, state);
  case 't':
    a->threads = command_parse_count("threads", arg, state);
    return 0;
  case 'j':
    a->jobs = command_parse_count("jobs", arg, state);
    return 0;
  case 'f':
    a->force = true;
    return 0;
  case 'q':
    a->quiet = true;
    return 0;
  case 'w':
    a->wait = true;
    return 0;
  case 'n':
    a->no_report = true;
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

/* Run `i` in a process of its own. */
static int run_job(void *data, size_t i) {
  const struct running *g = data;
  return running_job(g, &g->c->runs[i], g->c->runs[i].name);
}

/* In what the file of run r belongs to another case than this one is now; NULL when in nothing. */
static const char *why_stale(const struct case_file *c, const struct case_run *r,
                             const struct result_file *file) {
  char water[33], whole[33];
  case_water_fingerprint(c, water);
  case_fingerprint(c, r, whole);
  if (*file->water_fingerprint && strcmp(file->water_fingerprint, water) != 0)
    return "is of other water, another tank or other scales";
  if (strcmp(file->fingerprint, whole) != 0)
    return "was run with other times, probes, gauges, points or options, or by another version of "
           "plunge";
  return NULL;
}

/* The file of run r when there is one that belongs to the case. One that does not is named, also
 * with
 * --quiet: a report on the rest looks whole. */
static enum status read_current(const struct case_file *c, const struct case_run *r,
                                const char *folder, struct progress *progress,
                                struct result_file **file) {
  char path[PATH_MAX];
  struct stat s;
  TRY(running_path(folder, r, path));
  if (stat(path, &s)) {
    progress_say(progress, "%s is not there: left out of the comparison", path);
    return OK;
  }
  TRY(result_read(path, file));
  const char *why = why_stale(c, r, *file);
  if (!why) return OK;
  command_warn("%s %s: left out of the comparison; run %s again", path, why, r->name);
  result_file_destroy(*file);
  *file = NULL;
  return OK;
}

/* A report that is there already could be taken for one of what was run just now. */
static void say_no_report(const char *folder, struct progress *progress) {
  char path[PATH_MAX];
  int n = snprintf(path, sizeof path, "%s/report.html", folder);
  progress_say(progress, "nothing to compare: the reference and one more run are needed");
  if (n < PATH_MAX && !access(path, F_OK))
    command_warn("%s is of an earlier comparison: there was nothing to compare now", path);
}

/* Reads back the runs that have a file, and compares them. */
static int report(const struct case_file *c, const char *out, struct progress *progress) {
  int exit_code = EXIT_FINE;
  struct result_file *ref = NULL, **runs = calloc(c->n_runs, sizeof *runs);
  size_t n = 0;
  if (!runs) return command_fail(status_raise(ERR_MEMORY, "no memory"));
  for (size_t i = 0; i < c->n_runs; i++) {
    struct result_file *file = NULL;
    enum status status = read_current(c, &c->runs[i], out, progress, &file);
    int judged = status != OK ? command_fail(status) : file ? running_judge(file) : EXIT_FINE;
    if (judged != EXIT_FINE) exit_code = judged;
    if (status == OK && i == c->compare.reference)
      ref = file;
    else if (file)
      runs[n++] = file;
  }
  if (ref && n) {
    int verdict = command_report(c, ref, n, runs, false, out, progress);
    if (exit_code == EXIT_FINE) exit_code = verdict;
  } else
    say_no_report(out, progress);
  result_file_destroy(ref);
  for (size_t i = 0; i < n; i++) result_file_destroy(runs[i]);
  free(runs);
  return exit_code;
}

/* Clears the marks of runs whose finished result is there already. */
static enum status skip_finished(const struct run_arguments *a, const struct case_file *c,
                                 const char *folder, bool *chosen, struct progress *progress,
                                 int *exit_code) {
  for (size_t i = 0; i < c->n_runs; i++) {
    const struct case_run *r = &c->runs[i];
    char path[PATH_MAX], fingerprint[33];
    if (!chosen[i]) continue;
    TRY(running_path(folder, r, path));
    case_fingerprint(c, r, fingerprint);
    if (a->force || !result_is_current(path, fingerprint)) continue;
    progress_say(progress, "%-10s is there already, for the same inputs: %s", r->name, path);
    chosen[i] = false;
    const int judged = a->no_report ? running_judge_file(path) : EXIT_FINE;
    if (judged != EXIT_FINE) *exit_code = judged;
  }
  return OK;
}

/* Every chosen run, also after one that failed; several at a time when they are done sooner by
 * that. INTERRUPTED ends it. */
static enum status run_chosen(const struct run_arguments *a, struct running *g, const bool *chosen,
                              int *exit_code) {
  struct job *job = NULL;
  size_t n = 0;
  enum status status;
  ATTEMPT(array_create(&job, g->c->n_runs, "runs"));
  for (size_t i = 0; i < g->c->n_runs; i++) {
    const struct case_run *r = &g->c->runs[i];
    if (!chosen[i]) continue;
    job[n] = (struct job){.name = r->name, .item = i};
    r->solver->estimate(g->c, r, &job[n++].estimate);
  }
  struct job_plan plan = jobs_plan_here(a->jobs, "run", "runs");
  jobs_plan(n, job, &plan);
  status = jobs_run(n, job, &plan, run_job, g, g->progress, exit_code);
done:
  free(job);
  return status;
}

static int run_case(const struct run_arguments *a, const struct case_file *c,
                    struct progress *progress) {
  char folder[PATH_MAX];
  int exit_code = EXIT_FINE, found = EXIT_FINE, lock = -1;
  enum status status;
  bool *chosen = NULL;
  command_name_folder(a->out, c, folder);
  chosen = calloc(c->n_runs, sizeof *chosen);
  ATTEMPT(chosen ? OK : status_raise(ERR_MEMORY, "no memory for %zu runs", c->n_runs));
  ATTEMPT(command_choose_runs(c, a->only, chosen));
  ATTEMPT(command_lock_folder(folder, a->no_report ? COMMAND_SHARED : COMMAND_ALONE, a->wait,
                              progress, &lock));
  ATTEMPT(skip_finished(a, c, folder, chosen, progress, &found));
  exit_code = command_check_room(c, chosen, a->set.n, a->set.item);
  if (exit_code != EXIT_FINE) goto done;
  exit_code = found;
  ATTEMPT(room_take_for_blas());
  ATTEMPT(run_chosen(a, &(struct running){c, folder, progress}, chosen, &exit_code));
  if (!a->no_report && c->compare.reference < c->n_runs) {
    int compared = report(c, folder, progress);
    if (exit_code == EXIT_FINE) exit_code = compared;
  }
done:
  if (status != OK) exit_code = command_fail(status);
  if (lock >= 0) close(lock);
  free(chosen);
  return exit_code;
}

int command_run(int argc, char **argv) {
  static const struct argp_option options[] = {
      {"out", 'o', "DIR", 0, "folder for results and report (default: out/ and the case's name)",
       0},
      {"only", 'r', "RUN[,RUN]", 0, "only these runs of the case", 0},
      {"set", 's', "PATH=VALUE", 0, "override a value, as in runs.NAME.alpha=0 or time.end=1.2", 0},
      {"threads", 't', "N", 0, "threads (default: OMP_NUM_THREADS, else every core)", 0},
      {"jobs", 'j', "N", 0,
       "so many runs side by side, if there is memory (default: as is estimated to be fastest)", 0},
      {"force", 'f', NULL, 0, "run again even what is there for the same inputs", 0},
      {"quiet", 'q', NULL, 0, "no progress; errors and the verdict only", 0},
      {"no-report", 'n', NULL, 0,
       "no comparison: others may do so with other runs in the same folder at the same time", 0},
      {"wait", 'w', NULL, 0, "wait for another plunge that is at work in the folder", 0},
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
  int exit_code;
  struct case_file *c = command_load_case(a.case_path, a.set.n, a.set.item, &exit_code);
  if (c) {
    struct progress *progress = progress_create(a.quiet ? PROGRESS_QUIET : PROGRESS_AUTO);
    if (progress)
      exit_code = run_case(&a, c, progress);
    else
      exit_code = command_fail(status_raise(ERR_MEMORY, "no memory"));
    progress_destroy(progress);
  }
  case_destroy(c);
  free(a.set.item);
  return exit_code;
}

#include "cli/gallery_runs.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/jobs.h"
#include "cli/room.h"
#include "cli/running.h"
#include "common/base/array.h"
#include "common/base/text.h"
#include "common/result/health.h"
#include "compare/output.h"
#include "gallery/shelf.h"

struct gallery_book *gallery_runs_book(int *exit_code) {
  struct problems problems = {0};
  struct gallery_book *book = NULL;
  struct gallery_file *files = NULL;
  size_t n = 0;
  enum status status;
  ATTEMPT(gallery_shelf_entries(&n, &files));
  status = gallery_book_read(n, files, &problems, &book);
  command_list_problems(&problems);
done:
  *exit_code = status_exit_code(status);
  if (status != OK && !problems.n) command_fail(status);
  problems_destroy(&problems);
  free(files);
  return book;
}

/* ---- files of cases ---- */

/* A file that is there already as it should be stays as old as it is. */
static enum status put_file(const char *folder, const char *name,
                            const struct gallery_shelf_file *file) {
  struct cmp_output out = {0};
  char path[PATH_MAX], *there = NULL;
  size_t n = 0;
  enum status status;
  TRY(cmp_path_join(folder, name, path));
  if (cmp_file_read(path, &there, &n) == OK && n == file->size && !memcmp(there, file->bytes, n)) {
    free(there);
    return OK;
  }
  free(there);
  ATTEMPT(cmp_output_open(path, &out));
  fwrite(file->bytes, 1, file->size, out.stream);
  status = cmp_output_commit(&out);
done:
  cmp_output_abandon(&out);
  return status;
}

/* What cases read beside themselves, from data/. */
static enum status put_data(const char *cases) {
  char folder[PATH_MAX];
  TRY(cmp_path_join(cases, "data", folder));
  TRY(cmp_directory_make(folder));
  for (size_t i = 0; i < gallery_shelf_count; i++) {
    const char *data = strstr(gallery_shelf[i].path, "cases/data/");
    if (data) TRY(put_file(folder, strrchr(data, '/') + 1, &gallery_shelf[i]));
  }
  return OK;
}

/* ---- cases ---- */

static enum status fill_case(struct gallery_runs *runs, const struct gallery_case *of,
                             struct problems *problems, struct gallery_runs_case *c) {
  char cases[PATH_MAX], results[PATH_MAX];
  const struct gallery_shelf_file *file = gallery_shelf_find_case(of->file);
  int exit_code;
  c->of = of;
  CHECK(file, ERR_INPUT, "case %s: there is no file %s in gallery/cases or cases", of->name,
        of->file);
  TRY(cmp_path_join(runs->out, "cases", cases));
  if (runs->n_cases == 1) TRY(put_data(cases));
  TRY(cmp_path_join(cases, of->file, c->path));
  TRY(cmp_path_join(runs->out, "runs", results));
  TRY(cmp_path_join(results, of->name, c->folder));
  TRY(put_file(cases, of->file, file));
  TRY(array_create(&c->set, of->n_set + of->n_quick, "overrides"));
  for (size_t i = 0; i < of->n_set; i++) c->set[c->n_set++] = of->set[i];
  for (size_t i = 0; runs->quick && i < of->n_quick; i++) c->set[c->n_set++] = of->quick[i];
  c->c = command_load_case(c->path, c->n_set, c->set, &exit_code);
  if (!c->c)
    problems_add(problems, 0, "%s:%d: cases.%s: found %s with overrides that it does not take; "
                 "allowed: what the messages above say", of->from, of->line, of->name, of->file);
  return OK;
}

static enum status find_case(struct gallery_runs *runs, const char *name, size_t n,
                             struct problems *problems, size_t *place) {
  for (*place = 0; *place < runs->n_cases; ++*place) {
    const char *known = runs->cases[*place].of->name;
    if (strlen(known) == n && !strncmp(known, name, n)) return OK;
  }
  for (size_t i = 0; i < runs->book->n_cases; i++) {
    const struct gallery_case *of = &runs->book->cases[i];
    if (strlen(of->name) != n || strncmp(of->name, name, n) != 0) continue;
    TRY(array_resize(&runs->cases, runs->n_cases + 1, "cases"));
    runs->cases[*place] = (struct gallery_runs_case){0};
    runs->n_cases++;
    return fill_case(runs, of, problems, &runs->cases[*place]);
  }
  return status_raise(ERR_INPUT, "run %s: the gallery has no case of that name", name);
}

/* ---- what there is ---- */

/* A run that failed by itself has said so in its file; one that was stopped is not over. One that
 * came to its end may be nonsense all the same. */
static void look(const struct gallery_runs_case *c, struct gallery_run *run) {
  char path[PATH_MAX];
  struct result_file *file = NULL;
  run->state = GALLERY_RUN_MISSING;
  *run->why = 0;
  if (running_path(c->folder, run->r, path) != OK) return;
  if (result_is_current(path, run->fingerprint)) {
    struct health h = {0};
    run->state = GALLERY_RUN_DONE;
    if (result_read(path, &file) == OK) health_of_file(file, &h);
    if (h.verdict == HEALTH_FAILED)
      snprintf(run->why, sizeof run->why, "run %s is finished, but not to be believed: %.280s",
               run->name, h.reasons);
  } else if (result_read(path, &file) == OK && !strcmp(file->fingerprint, run->fingerprint) &&
             *file->ended && !strcmp(file->health, "failed")) {
    run->state = GALLERY_RUN_BROKEN;
    snprintf(run->why, sizeof run->why, "run %s broke off: %s", run->name, file->ended);
  }
  result_file_destroy(file);
}

struct gathering {
  struct gallery_runs *runs;
  const struct gallery_entry *entry;
  struct problems *problems;
};

static const struct case_run *run_of(const struct case_file *c, const char *name) {
  for (size_t i = 0; i < c->n_runs; i++)
    if (!strcmp(c->runs[i].name, name)) return &c->runs[i];
  return NULL;
}

/* That a case has no such run, once for each curve or figure that needs it. */
static void complain(const struct gathering *g, const struct gallery_need *need,
                     const struct case_file *c, const char *name) {
  const char *names[c->n_runs + 1];
  for (size_t i = 0; i < c->n_runs; i++) names[i] = c->runs[i].name;
  const char *near = param_nearest(name, c->n_runs, names);
  problems_add(g->problems, 0, "%s:%d: %s: found run '%.160s'; allowed: a run of %s%s%s%s",
               g->entry->file, need->line, need->path, need->run, c->path,
               near ? "; did you mean '" : "", near ? near : "", near ? "'?" : "");
}

static enum status add_run(void *data, const struct gallery_need *need) {
  const struct gathering *g = data;
  struct gallery_runs *runs = g->runs;
  const char *name = need->run, *slash = strchr(name, '/');
  struct gallery_run run = {0};
  if (gallery_runs_find(runs, name)) return OK;
  CHECK(slash, ERR_INPUT, "run %s: write CASE/RUN", name);
  TRY(find_case(runs, name, (size_t)(slash - name), g->problems, &run.of));
  const struct gallery_runs_case *c = &runs->cases[run.of];
  if (!c->c) return OK;
  run.r = run_of(c->c, slash + 1);
  if (!run.r) {
    complain(g, need, c->c, slash + 1);
    return OK;
  }
  case_fingerprint(c->c, run.r, run.fingerprint);
  TRY(array_resize(&runs->run, runs->n + 1, "runs"));
  run.name = strdup(name);
  CHECK(run.name, ERR_MEMORY, "no memory for run %s", name);
  look(c, &run);
  runs->run[runs->n++] = run;
  return OK;
}

enum status gallery_runs_gather(const struct gallery_book *book, const bool *chosen,
                                const char *out, bool quick, struct gallery_runs *runs) {
  struct problems problems = {0};
  enum status status = OK;
  *runs = (struct gallery_runs){.book = book, .out = out, .quick = quick};
  for (size_t i = 0; i < book->n_entries && status == OK; i++)
    if (chosen[i])
      status = gallery_entry_needs(&book->entries[i], add_run,
                                   &(struct gathering){runs, &book->entries[i], &problems});
  command_list_problems(&problems);
  const size_t n = problems.n + problems.unlisted;
  problems_destroy(&problems);
  TRY(status);
  CHECK(!n, ERR_INPUT, "the gallery's entries have %zu problem%s", n, n == 1 ? "" : "s");
  return OK;
}

void gallery_runs_free(struct gallery_runs *runs) {
  for (size_t i = 0; i < runs->n; i++) free(runs->run[i].name);
  for (size_t i = 0; i < runs->n_cases; i++) {
    case_destroy(runs->cases[i].c);
    free(runs->cases[i].set);
  }
  free(runs->run);
  free(runs->cases);
  *runs = (struct gallery_runs){0};
}

const struct gallery_run *gallery_runs_find(const struct gallery_runs *runs, const char *name) {
  for (size_t i = 0; i < runs->n; i++)
    if (!strcmp(runs->run[i].name, name)) return &runs->run[i];
  return NULL;
}

static enum status want(void *data, const char *name) {
  struct gallery_runs *runs = data;
  for (size_t i = 0; i < runs->n; i++) runs->run[i].wanted |= !strcmp(runs->run[i].name, name);
  return OK;
}

enum status gallery_runs_want(struct gallery_runs *runs, const struct gallery_entry *e) {
  return gallery_entry_runs(e, want, runs);
}

struct solver_estimate gallery_runs_estimate(const struct gallery_runs *runs, size_t k) {
  struct solver_estimate e = {0};
  const struct gallery_run *run = &runs->run[k];
  run->r->solver->estimate(runs->cases[run->of].c, run->r, &e);
  return e;
}

/* ---- at work ---- */

struct work {
  struct gallery_runs *runs;
  struct progress *progress;
  bool again;
};

/* What an earlier one has left would pass for what this one could not make. */
static int run_job(void *data, size_t k) {
  const struct work *w = data;
  const struct gallery_run *run = &w->runs->run[k];
  const struct gallery_runs_case *c = &w->runs->cases[run->of];
  char path[PATH_MAX];
  if (w->again && running_path(c->folder, run->r, path) == OK) unlink(path);
  return running_job(&(struct running){c->c, c->folder, w->progress}, run->r, run->name);
}

/* Whether there is memory for it: else why not. */
static bool has_room(struct gallery_run *run, const struct solver_estimate *e) {
  const char *limit;
  const double room = room_available(&limit);
  if (e->bytes <= room) return true;
  snprintf(run->why, sizeof run->why, "run %s needs %.0f MB of memory; there are %.0f MB %s",
           run->name, 1e-6 * e->bytes, 1e-6 * room, limit);
  return false;
}

/* Those that can be made and are not there. */
static enum status list_jobs(struct gallery_runs *runs, bool again, size_t *n, struct job *job) {
  for (size_t k = 0; k < runs->n; k++) {
    struct gallery_run *run = &runs->run[k];
    if (!run->wanted) continue;
    if (again) run->state = GALLERY_RUN_MISSING;
    if (run->state != GALLERY_RUN_MISSING) continue;
    job[*n] =
        (struct job){.name = run->name, .item = k, .estimate = gallery_runs_estimate(runs, k)};
    if (!has_room(run, &job[*n].estimate)) continue;
    TRY(cmp_directory_make(runs->cases[run->of].folder));
    ++*n;
  }
  return OK;
}

enum status gallery_runs_make(struct gallery_runs *runs, bool again, int jobs,
                              struct progress *progress) {
  struct job *job = NULL;
  struct work work = {runs, progress, again};
  int exit_code = EXIT_FINE; /* of the last that failed: each one's file says more */
  size_t n = 0;
  enum status status;
  ATTEMPT(array_create(&job, runs->n, "runs"));
  ATTEMPT(list_jobs(runs, again, &n, job));
  if (!n) goto done;
  ATTEMPT(room_take_for_blas());
  struct job_plan plan = jobs_plan_here(jobs, "run", "runs");
  jobs_plan(n, job, &plan);
  ATTEMPT(jobs_run(n, job, &plan, run_job, &work, progress, &exit_code));
  for (size_t i = 0; i < n; i++) {
    struct gallery_run *run = &runs->run[job[i].item];
    look(&runs->cases[run->of], run);
    if (run->state == GALLERY_RUN_MISSING)
      snprintf(run->why, sizeof run->why, "run %s has failed", run->name);
  }
done:
  free(job);
  return status;
}

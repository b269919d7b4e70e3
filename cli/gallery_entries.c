#include "cli/gallery_entries.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/jobs.h"
#include "cli/plan.h"
#include "common/base/array.h"
#include "compare/figure.h"
#include "compare/json_maker.h"
#include "compare/output.h"
#include "gallery/figures/figures.h"
#include "gallery/json.h"
#include "revision.h"

/* ---- files ---- */

enum status gallery_entries_write(const char *folder, const char *name, const json_t *json) {
  struct cmp_output out = {0};
  char path[PATH_MAX];
  enum status status;
  ATTEMPT(cmp_path_join(folder, name, path));
  ATTEMPT(cmp_output_open(path, &out));
  if (json_dumpf(json, out.stream, JSON_INDENT(1) | JSON_REAL_PRECISION(17)) != 0)
    ATTEMPT(status_raise(ERR_IO, "cannot write %s", path));
  fputc('\n', out.stream);
  status = cmp_output_commit(&out);
done:
  cmp_output_abandon(&out);
  return status;
}

static enum status path_of(const char *out, const struct gallery_entry *e, char folder[PATH_MAX],
                           char name[96]) {
  snprintf(name, 96, "%.64s.json", e->key);
  return cmp_path_join(out, "entries", folder);
}

/* ---- whether it is there ---- */

/* Of what an entry is made but its runs. */
static void fingerprint_of(const struct gallery_entry *e, bool quick, char out[33]) {
  char *text = NULL;
  size_t n = 0;
  FILE *stream = open_memstream(&text, &n);
  out[0] = 0;
  if (!stream) return;
  fprintf(stream, "plunge %s %s\nquick %d\n%s\n", PLUNGE_VERSION, PLUNGE_REVISION, quick, e->text);
  fclose(stream);
  if (text) case_text_fingerprint(text, n, out);
  free(text);
}

struct gathering {
  const struct gallery_runs *runs;
  FILE *stream;
};

static enum status write_run(void *data, const char *name) {
  const struct gathering *g = data;
  const struct gallery_run *run = gallery_runs_find(g->runs, name);
  fprintf(g->stream, "%s %s\n", name, run ? run->fingerprint : "");
  return OK;
}

static void fingerprint_of_runs(const struct gallery_entry *e, const struct gallery_runs *runs,
                                char out[33]) {
  char *text = NULL;
  size_t n = 0;
  FILE *stream = open_memstream(&text, &n);
  out[0] = 0;
  if (!stream) return;
  (void)gallery_entry_runs(e, write_run, &(struct gathering){runs, stream});
  fclose(stream);
  if (text) case_text_fingerprint(text, n, out);
  free(text);
}

static bool has_text(const json_t *object, const char *key, const char *text) {
  const char *found = json_string_value(json_object_get(object, key));
  return found && *found && !strcmp(found, text);
}

static bool stands(const char *folder, const json_t *of, const char *suffix) {
  char name[160], path[PATH_MAX];
  snprintf(name, sizeof name, "%.96s%.16s", gallery_text(of, "name"), suffix);
  return cmp_path_join(folder, name, path) == OK && access(path, R_OK) == 0;
}

/* Whether what it shows is still there: somebody may have tidied up. */
static bool figures_stand(const char *out, const json_t *json) {
  size_t i, k;
  json_t *figure, *file;
  char folder[PATH_MAX];
  if (cmp_path_join(out, "figures", folder) != OK) return false;
  json_array_foreach(json_object_get(json, "figures"), i, figure) {
    if (json_object_get(figure, "table") && !stands(folder, figure, ".csv")) return false;
    json_array_foreach(json_object_get(figure, "files"), k, file) {
      if (!stands(folder, file, ".gp")) return false;
      for (size_t f = 0; f < CMP_FORMATS; f++)
        if (!stands(folder, file, cmp_formats[f].suffix)) return false;
    }
  }
  return true;
}

/* What is there, whoever has made it; NULL: nothing that can be read. */
static json_t *load(const char *out, const struct gallery_entry *e) {
  char folder[PATH_MAX], path[PATH_MAX], name[96];
  json_error_t error;
  if (path_of(out, e, folder, name) != OK || cmp_path_join(folder, name, path) != OK) return NULL;
  return json_load_file(path, 0, &error);
}

enum status gallery_entries_check_folder(const char *out, const struct gallery_book *book,
                                         bool quick) {
  bool other = false;
  for (size_t i = 0; i < book->n_entries && !other; i++) {
    json_t *json = load(out, &book->entries[i]);
    const char *command = gallery_text(json, "command");
    other = *command && (strstr(command, " --quick") != NULL) != quick;
    json_decref(json);
  }
  CHECK(!other, ERR_USAGE,
        "--out: found %s, which has entries made %s --quick; allowed: a folder of its own for each",
        out, quick ? "without" : "with");
  return OK;
}

json_t *gallery_entries_read(const char *out, const struct gallery_entry *e, bool quick,
                             const struct gallery_runs *runs) {
  char own[33], of_runs[33];
  json_t *json = load(out, e);
  fingerprint_of(e, quick, own);
  bool same = has_text(json, "fingerprint", own);
  if (same && runs) {
    fingerprint_of_runs(e, runs, of_runs);
    same = has_text(json, "fingerprint_of_runs", of_runs) &&
           json_is_true(json_object_get(json, "finished")) && figures_stand(out, json);
  }
  if (same) return json;
  json_decref(json);
  return NULL;
}

/* ---- one entry ---- */

struct making {
  const struct gallery_runs *runs;
  struct progress *progress;
};

struct runs_of {
  const struct gallery_runs *runs;
  const char *missing, *broken, *unsound; /* why the first such one is; done, but nonsense */
};

static enum status look_at_run(void *data, const char *name) {
  struct runs_of *of = data;
  const struct gallery_run *run = gallery_runs_find(of->runs, name);
  if (!run || (run->state == GALLERY_RUN_MISSING && !of->missing))
    of->missing = run ? run->why : "a run is not known";
  if (run && run->state == GALLERY_RUN_BROKEN && !of->broken) of->broken = run->why;
  if (run && run->state == GALLERY_RUN_DONE && *run->why && !of->unsound) of->unsound = run->why;
  return OK;
}

/* Nothing can be answered. */
static void answer_none(const struct gallery_entry *e, bool left, const char *why,
                        struct gallery_answer *answer) {
  for (size_t i = 0; i < e->n_checks; i++) {
    answer[i] = (struct gallery_answer){
        .value = NAN, .expected = NAN, .tolerance = NAN, .low = NAN, .high = NAN, .left = left};
    snprintf(answer[i].failure, sizeof answer[i].failure, "%s", why);
  }
}

/* Whether no later override is of the same path. */
static bool is_in_force(const struct gallery_runs_case *c, size_t k) {
  const size_t n = strcspn(c->set[k], "=") + 1;
  for (size_t i = k + 1; i < c->n_set; i++)
    if (!strncmp(c->set[i], c->set[k], n)) return false;
  return true;
}

struct naming { /* of an entry's runs of one case */
  const char *name;
  FILE *stream;
  size_t n;
  char known[PATH_MAX]; /* ",A,B," */
};

static enum status name_run(void *data, const char *run) {
  struct naming *of = data;
  const size_t n = strlen(of->name), used = strlen(of->known);
  char item[CASE_LONGEST_NAME + 3];
  if (strncmp(run, of->name, n) != 0 || run[n] != '/') return OK;
  snprintf(item, sizeof item, ",%.*s,", CASE_LONGEST_NAME, run + n + 1);
  if (strstr(of->known, item)) return OK;
  fprintf(of->stream, "%s%s", of->n++ ? "," : "", run + n + 1);
  snprintf(of->known + used, sizeof of->known - used, "%s", item);
  return OK;
}

/* What makes an entry's runs of a case by hand, in the gallery's folder. NULL: no memory. */
static json_t *command_of(const struct gallery_entry *e, const struct gallery_runs_case *c,
                          const char *file) {
  char *text = NULL, folder[CASE_LONGEST_NAME + 8];
  size_t n = 0;
  FILE *stream = open_memstream(&text, &n);
  if (!stream) return NULL;
  fputs("plunge run ", stream);
  plan_word(stream, file, false);
  fputs(" --only ", stream);
  (void)gallery_entry_runs(e, name_run, &(struct naming){.name = c->of->name, .stream = stream});
  for (size_t k = 0; k < c->n_set; k++) {
    if (!is_in_force(c, k)) continue;
    fputs(" --set ", stream);
    plan_word(stream, c->set[k], false);
  }
  snprintf(folder, sizeof folder, "runs/%.*s", CASE_LONGEST_NAME, c->of->name);
  fputs(" --no-report --out ", stream);
  plan_word(stream, folder, false);
  fclose(stream);
  json_t *json = text ? cmp_json_text(text) : NULL;
  free(text);
  return json;
}

struct listing {
  struct cmp_json_maker *m;
  const struct gallery_runs *runs;
  const struct gallery_entry *e;
  json_t *cases;
};

/* The cases of its runs, with the overrides in force. */
static enum status add_case(void *data, const char *name) {
  const struct listing *l = data;
  const struct gallery_run *run = gallery_runs_find(l->runs, name);
  if (!run) return OK;
  const struct gallery_runs_case *c = &l->runs->cases[run->of];
  size_t i;
  json_t *known;
  json_array_foreach(l->cases, i, known) if (has_text(known, "name", c->of->name)) return OK;
  json_t *o = json_object(), *set = json_array();
  char file[PATH_MAX];
  snprintf(file, sizeof file, "cases/%s", c->of->file);
  cmp_json_set(l->m, o, "name", cmp_json_text(c->of->name));
  cmp_json_set(l->m, o, "file", cmp_json_text(file));
  for (size_t k = 0; k < c->n_set; k++)
    if (is_in_force(c, k)) cmp_json_add(l->m, set, cmp_json_text(c->set[k]));
  cmp_json_set(l->m, o, "command", command_of(l->e, c, file));
  cmp_json_set(l->m, o, "set", set);
  cmp_json_add(l->m, l->cases, o);
  return OK;
}

/* What is first missing of the figures: NULL when they are there. A picture that could not be drawn
 * leaves its entry a verdict; a figure that could not be computed does not. */
static const char *figures_lack(const json_t *figures, bool *computed) {
  size_t i, k;
  json_t *figure, *file;
  const char *lack = NULL;
  json_array_foreach(figures, i, figure) {
    const char *failure = json_string_value(json_object_get(figure, "failure"));
    if (failure) {
      *computed = false;
      return failure;
    }
    json_array_foreach(json_object_get(figure, "files"), k, file) if (!lack) lack =
        json_string_value(json_object_get(file, "missing"));
  }
  return lack;
}

static void set_verdict(struct cmp_json_maker *m, json_t *json, enum gallery_verdict verdict) {
  cmp_json_set(m, json, "verdict", cmp_json_text(gallery_verdict_names[verdict]));
  cmp_json_set(m, json, "verdict_words", cmp_json_text(gallery_verdict_words[verdict]));
}

/* Why it could not be made, in one sentence; false: it could. */
static bool failure_of(const struct gallery_entry *e, const struct gallery_answer *answer,
                       const struct runs_of *of, const char *lack, bool computed, char *out,
                       size_t room) {
  const char *why = of->missing;
  for (size_t i = 0; i < e->n_checks && !why; i++)
    if (*answer[i].failure) why = answer[i].failure;
  if (!why && !computed) why = lack;
  if (!why) return false;
  const char *run = why == of->missing ? NULL : of->broken ? of->broken : of->unsound;
  snprintf(out, room, "%s%s%s%s", why, run ? " (" : "", run ? run : "", run ? ")" : "");
  return true;
}

/* What is known of the entry, complete. */
static enum status describe(const struct gallery_runs *runs, const struct gallery_entry *e,
                            const struct gallery_answer *answer, const struct runs_of *of,
                            json_t *figures, json_t **out) {
  struct cmp_json_maker m = {true};
  char own[33], of_runs[33], failure[900], command[96];
  bool computed = true;
  const char *lack = figures_lack(figures, &computed);
  json_t *json = NULL, *cases = json_array();
  TRY(gallery_json_entry(e, answer, &json));
  fingerprint_of(e, runs->quick, own);
  fingerprint_of_runs(e, runs, of_runs);
  snprintf(command, sizeof command, "plunge gallery %s%s --out .", e->key,
           runs->quick ? " --quick" : "");
  const bool failed = failure_of(e, answer, of, lack, computed, failure, sizeof failure);
  if (failed) {
    set_verdict(&m, json, GALLERY_VERDICT_failed);
    cmp_json_set(&m, json, "failure", cmp_json_text(failure));
  } else {
    if (of->broken) cmp_json_set(&m, json, "broke_off", cmp_json_text(of->broken));
    if (of->unsound) cmp_json_set(&m, json, "not_believed", cmp_json_text(of->unsound));
  }
  (void)gallery_entry_runs(e, add_case, &(struct listing){&m, runs, e, cases});
  cmp_json_set(&m, json, "cases", cases);
  cmp_json_set(&m, json, "figures", figures ? json_incref(figures) : json_array());
  cmp_json_set(&m, json, "command", cmp_json_text(command));
  cmp_json_set(&m, json, "finished", json_boolean(!failed && !lack));
  cmp_json_set(&m, json, "fingerprint", cmp_json_text(own));
  cmp_json_set(&m, json, "fingerprint_of_runs", cmp_json_text(of_runs));
  if (m.ok) {
    *out = json;
    return OK;
  }
  json_decref(json);
  return status_raise(ERR_MEMORY, "no memory for entry %s", e->id);
}

static enum status leave(const struct gallery_runs *runs, const struct gallery_entry *e,
                         const json_t *json) {
  char folder[PATH_MAX], name[96];
  TRY(path_of(runs->out, e, folder, name));
  TRY(cmp_directory_make(folder));
  return gallery_entries_write(folder, name, json);
}

/* An entry of which nothing was computed, and why. */
static enum status leave_unmade(const struct gallery_runs *runs, const struct gallery_entry *e,
                                bool left, const char *why) {
  struct cmp_json_maker m = {true};
  struct gallery_answer *answer = NULL;
  json_t *json = NULL;
  enum status status;
  ATTEMPT(array_create(&answer, e->n_checks, "answers"));
  answer_none(e, left, left ? "" : why, answer);
  ATTEMPT(describe(runs, e, answer, &(struct runs_of){.missing = left ? NULL : why}, NULL, &json));
  if (left) set_verdict(&m, json, GALLERY_VERDICT_left);
  status = leave(runs, e, json);
done:
  json_decref(json);
  free(answer);
  return status;
}

enum status gallery_entries_leave(const struct gallery_runs *runs, const struct gallery_entry *e) {
  return leave_unmade(runs, e, true, "");
}

static enum status draw(struct gallery_desk *desk, const struct gallery_runs *runs,
                        const struct gallery_entry *e, json_t **drawn) {
  struct cmp_figures figures = {.lock = -1};
  enum status status = cmp_figures_open_set(runs->out, e->key, &figures);
  if (status == OK) status = gallery_figures_make(desk, e, &figures, drawn);
  cmp_figures_close(&figures);
  return status;
}

static enum status make(const struct gallery_runs *runs, const struct gallery_entry *e,
                        const struct runs_of *of, struct progress *progress) {
  struct gallery_desk *desk = NULL;
  struct gallery_answer *answer = NULL;
  json_t *drawn = NULL, *json = NULL;
  char folder[PATH_MAX];
  enum status status;
  ATTEMPT(cmp_path_join(runs->out, "runs", folder));
  ATTEMPT(array_create(&answer, e->n_checks, "answers"));
  ATTEMPT(gallery_desk_create(runs->book, folder, runs->quick, &desk));
  ATTEMPT(gallery_desk_begin(desk, e));
  ATTEMPT(gallery_answer_all(desk, e, answer));
  ATTEMPT(draw(desk, runs, e, &drawn));
  ATTEMPT(describe(runs, e, answer, of, drawn, &json));
  ATTEMPT(leave(runs, e, json));
  progress_say(progress, "%-10s %s", e->id,
               json_string_value(json_object_get(json, "verdict_words")));
done:
  gallery_desk_destroy(desk);
  json_decref(drawn);
  json_decref(json);
  free(answer);
  return status;
}

/* What an earlier one has left would pass for what was made now: it stands aside meanwhile. */
struct earlier {
  char path[PATH_MAX], aside[PATH_MAX];
};

static enum status find_earlier(const struct gallery_runs *runs, const struct gallery_entry *e,
                                struct earlier *f) {
  char folder[PATH_MAX], name[96], hidden[112];
  TRY(path_of(runs->out, e, folder, name));
  snprintf(hidden, sizeof hidden, ".%s.before", name);
  TRY(cmp_path_join(folder, name, f->path));
  return cmp_path_join(folder, hidden, f->aside);
}

static enum status set_aside(const struct gallery_runs *runs, const struct gallery_entry *e) {
  struct earlier f;
  TRY(find_earlier(runs, e, &f));
  CHECK(rename(f.path, f.aside) == 0 || errno == ENOENT, ERR_IO, "cannot replace %s: %s", f.path,
        strerror(errno));
  return OK;
}

/* Once its process is over: it comes back if that was stopped before it left anything. */
static void settle(const struct gallery_runs *runs, const struct gallery_entry *e, bool stopped) {
  struct earlier f;
  if (find_earlier(runs, e, &f) != OK) return;
  if (stopped && access(f.path, F_OK) != 0)
    rename(f.aside, f.path);
  else
    unlink(f.aside);
}

/* Made, or with the reason in what it leaves. INTERRUPTED; others when even that cannot be left. */
static enum status make_entry(const struct making *m, const struct gallery_entry *e) {
  struct runs_of of = {.runs = m->runs};
  enum status status = gallery_entry_runs(e, look_at_run, &of);
  if (status == OK)
    status = of.missing ? leave_unmade(m->runs, e, false, of.missing)
                        : make(m->runs, e, &of, m->progress);
  if (status == OK || status == INTERRUPTED) return status;
  char why[1024];
  snprintf(why, sizeof why, "%s", status_message());
  return leave_unmade(m->runs, e, false, why);
}

/* In a process of its own. */
static int make_job(void *data, size_t i) {
  const struct making *m = data;
  const struct gallery_entry *e = &m->runs->book->entries[i];
  enum status status = set_aside(m->runs, e);
  if (status == OK) status = make_entry(m, e);
  if (status == OK || status == INTERRUPTED) return status_exit_code(status);
  return command_fail(status_context(status, "entry %s: ", e->id));
}

/* ---- all of them ---- */

/* Folders of figures that killed ones have left. */
static enum status tidy(const char *out) {
  struct cmp_figures figures = {.lock = -1};
  const enum status status = cmp_figures_open(out, &figures);
  cmp_figures_close(&figures);
  return status;
}

enum status gallery_entries_make(const struct gallery_runs *runs, const bool *chosen, int jobs,
                                 struct progress *progress) {
  const struct gallery_book *book = runs->book;
  struct making making = {runs, progress};
  struct job *job = NULL;
  size_t n = 0;
  int exit_code = EXIT_FINE; /* of the last that failed: what it has not left says more */
  enum status status;
  ATTEMPT(array_create(&job, book->n_entries, "entries"));
  for (size_t i = 0; i < book->n_entries; i++) {
    if (!chosen[i]) continue;
    job[n++] = (struct job){.name = book->entries[i].id,
                            .item = i,
                            .estimate = {.bytes = 3e8, .seconds = 3}}; /* most are gnuplot's */
  }
  if (!n) goto done;
  ATTEMPT(tidy(runs->out));
  struct job_plan plan = jobs_plan_here(jobs, "entry", "entries");
  jobs_plan(n, job, &plan);
  status = jobs_run(n, job, &plan, make_job, &making, progress, &exit_code);
  for (size_t i = 0; i < n; i++)
    settle(runs, &book->entries[job[i].item], status == INTERRUPTED);
  if (status != OK) goto done;
  for (size_t i = 0; i < n; i++) {
    const struct gallery_entry *e = &book->entries[job[i].item];
    json_t *left = gallery_entries_read(runs->out, e, runs->quick, NULL);
    if (!left) ATTEMPT(leave_unmade(runs, e, false, "its process came to no good end"));
    json_decref(left);
  }
done:
  free(job);
  return status;
}

/* plunge gallery: the figures and tables of two documents, made anew and held against what they
 * say. What they are is in the entries that the program carries (gallery/); here are the options,
 * the order of things, and the summary. */
#include <argp.h>
#include <errno.h>
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/gallery_entries.h"
#include "cli/gallery_runs.h"
#include "common/base/array.h"
#include "compare/json_maker.h"
#include "compare/output.h"
#include "gallery/choice.h"
#include "gallery/json.h"
#include "gallery/page/page.h"
#include "gallery/verdict.h"
#include "revision.h"

struct gallery_arguments {
  const char *out;
  const char **entries; /* [n_entries], owned; the strings are argv's */
  size_t n_entries;
  int threads, jobs;
  bool quick, list, force, quiet, wait;
};

static error_t parse(int key, char *arg, struct argp_state *state) {
  struct gallery_arguments *a = state->input;
  switch (key) {
  case 'o':
    a->out = arg;
    return 0;
  case 'k':
    a->quick = true;
    return 0;
  case 'l':
    a->list = true;
    return 0;
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
  case ARGP_KEY_ARG:
    if (array_resize(&a->entries, a->n_entries + 1, "entries") != OK) return ENOMEM;
    a->entries[a->n_entries++] = arg;
    return 0;
  case ARGP_KEY_END:
    if (!a->out) a->out = a->quick ? GALLERY_QUICK_FOLDER : GALLERY_FOLDER;
    if (!*a->out) argp_error(state, "--out: found ''; allowed: a folder");
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static void list(const struct gallery_book *book, const bool *chosen) {
  for (size_t i = 0; i < book->n_entries; i++) {
    const struct gallery_entry *e = &book->entries[i];
    if (chosen[i]) printf("%-10s %-10s %s\n", e->id, gallery_kind_names[e->kind], e->title);
  }
}

/* ---- the summary ---- */

struct totals {
  size_t entries, verdict[GALLERY_N_VERDICTS], checks, hold;
  size_t changed;    /* entries of which a check has */
  size_t incomplete; /* entries that could not be made, or lack a picture */
};

static void print_number(const char *before, const json_t *object, const char *key) {
  const json_t *number = json_object_get(object, key);
  if (json_is_number(number)) printf("%s %.6g", before, json_number_value(number));
}

/* A check that does not hold and nothing explains it, or that holds in spite of an explanation. */
static void print_change(const json_t *check) {
  const bool holds = gallery_is_true(check, "holds");
  if (gallery_is_true(check, "left_out") || gallery_is_true(check, "as_expected")) return;
  printf("           %s:", gallery_text(check, "says"));
  print_number("", check, "measured");
  print_number(", allowed from", check, "low");
  print_number(json_is_number(json_object_get(check, "low")) ? " to" : ", allowed up to", check,
               "high");
  puts(holds ? "; it holds, and its explanation is out of date" : "");
}

static void print_entry(const json_t *json, struct totals *t) {
  const json_t *checks = json_object_get(json, "checks"), *check;
  const struct gallery_tally tally = gallery_json_tally(json);
  const enum gallery_verdict verdict = gallery_json_verdict(json);
  size_t i;
  char counts[48] = "";
  const bool failed = verdict == GALLERY_VERDICT_failed;
  if (tally.checks)
    snprintf(counts, sizeof counts, "%zu of %zu checks hold", tally.hold, tally.checks);
  printf("%-10s %-33s %-24s %s\n", gallery_text(json, "id"), gallery_verdict_words[verdict], counts,
         failed ? gallery_text(json, "failure") : gallery_text(json, "title"));
  if (tally.changed) json_array_foreach(checks, i, check) print_change(check);
  t->entries++;
  t->verdict[verdict]++;
  t->checks += tally.checks;
  t->hold += tally.hold;
  t->changed += tally.changed;
  t->incomplete += !gallery_is_true(json, "finished");
}

static void print_totals(const struct totals *t, double seconds, const char *page) {
  char time[32];
  progress_format_time(time, sizeof time, seconds);
  printf("%zu %s: ", t->entries, t->entries == 1 ? "entry" : "entries");
  for (size_t v = 0, said = 0; v < GALLERY_N_VERDICTS; v++)
    if (t->verdict[v])
      printf("%s%s %zu", said++ ? ", " : "", gallery_verdict_words[v], t->verdict[v]);
  printf("; %zu of %zu checks hold; %s\n", t->hold, t->checks, time);
  if (t->changed) printf("%zu not as they are known to be: see above\n", t->changed);
  printf("page: %s\n", page);
}

/* ---- what is left ---- */

/* gallery.json: what was chosen, and what is there of others; and who is missing. */
static enum status gather(const struct gallery_runs *runs, const bool *chosen, json_t *entries,
                          json_t *missing, struct totals *totals) {
  for (size_t i = 0; i < runs->book->n_entries; i++) {
    const struct gallery_entry *e = &runs->book->entries[i];
    json_t *json = gallery_entries_read(runs->out, e, runs->quick, NULL);
    CHECK(json || !chosen[i], ERR_IO, "entry %s has left nothing in %s/entries", e->id, runs->out);
    if (json && chosen[i]) print_entry(json, totals);
    CHECK(!json_array_append_new(json ? entries : missing, json ? json : json_string(e->id)),
          ERR_MEMORY, "no memory for the gallery");
  }
  return OK;
}

static enum status finish(const struct gallery_runs *runs, const bool *chosen, double began,
                          int *exit_code) {
  struct cmp_json_maker m = {true};
  struct totals totals = {0};
  char page[PATH_MAX];
  json_t *gallery = json_object(), *entries = json_array(), *missing = json_array();
  enum status status;
  ATTEMPT(gather(runs, chosen, entries, missing, &totals));
  cmp_json_set(&m, gallery, "plunge", cmp_json_text(PLUNGE_VERSION));
  cmp_json_set(&m, gallery, "revision", cmp_json_text(PLUNGE_REVISION));
  cmp_json_set(&m, gallery, "quick", json_boolean(runs->quick));
  cmp_json_set(&m, gallery, "entries", json_incref(entries));
  cmp_json_set(&m, gallery, "not_made", json_incref(missing));
  if (!m.ok) ATTEMPT(status_raise(ERR_MEMORY, "no memory for the gallery"));
  ATTEMPT(gallery_entries_write(runs->out, "gallery.json", gallery));
  ATTEMPT(gallery_page_write(runs->out, gallery));
  ATTEMPT(cmp_path_join(runs->out, "gallery.html", page));
  print_totals(&totals, progress_wall_clock() - began, page);
  *exit_code = totals.incomplete ? EXIT_RUN_FAILED : totals.changed ? EXIT_VERDICT : EXIT_FINE;
done:
  json_decref(entries);
  json_decref(missing);
  json_decref(gallery);
  return status;
}

/* ---- the order of things ---- */

/* Marks those that are to be made, and wants their runs. */
static enum status choose_unfinished(const struct gallery_arguments *a, struct gallery_runs *runs,
                                     const bool *made, bool *due, struct progress *progress) {
  size_t n = 0, there = 0;
  for (size_t i = 0; i < runs->book->n_entries; i++) {
    const struct gallery_entry *e = &runs->book->entries[i];
    if (!made[i]) continue;
    json_t *json = a->force ? NULL : gallery_entries_read(runs->out, e, a->quick, runs);
    due[i] = !json;
    json_decref(json);
    n += due[i];
    there += !due[i];
    if (due[i]) TRY(gallery_runs_want(runs, e));
  }
  if (there) progress_say(progress, "%zu of %zu entries are there already", there, n + there);
  return OK;
}

static enum status make_chosen(const struct gallery_arguments *a, const struct gallery_book *book,
                               const bool *chosen, struct progress *progress, int *exit_code) {
  const double began = progress_wall_clock();
  struct gallery_runs runs = {0};
  bool *made = NULL,
       *due = NULL; /* those of the chosen that are not left out; that are not there */
  enum status status;
  ATTEMPT(array_create(&made, book->n_entries, "entries"));
  ATTEMPT(array_create(&due, book->n_entries, "entries"));
  for (size_t i = 0; i < book->n_entries; i++)
    made[i] = chosen[i] && !(a->quick && !book->entries[i].quick);
  ATTEMPT(gallery_runs_gather(book, made, a->out, a->quick, &runs));
  ATTEMPT(choose_unfinished(a, &runs, made, due, progress));
  ATTEMPT(gallery_runs_make(&runs, a->force, a->jobs, progress));
  ATTEMPT(gallery_entries_make(&runs, due, a->jobs, progress));
  for (size_t i = 0; i < book->n_entries; i++)
    if (chosen[i] && !made[i]) ATTEMPT(gallery_entries_leave(&runs, &book->entries[i]));
  status = finish(&runs, chosen, began, exit_code);
done:
  if (status == INTERRUPTED)
    progress_say(progress, "what is finished stays; the same command makes the rest and the page");
  gallery_runs_free(&runs);
  free(made);
  free(due);
  return status;
}

static enum status open_gallery(const struct gallery_arguments *a, const struct gallery_book *book,
                                int *exit_code) {
  struct progress *progress = NULL;
  bool *chosen = NULL;
  int lock = -1;
  enum status status;
  ATTEMPT(array_create(&chosen, book->n_entries, "entries"));
  ATTEMPT(gallery_choose(book, a->n_entries, a->entries, chosen));
  if (a->list) {
    list(book, chosen);
    goto done;
  }
  progress = progress_create(a->quiet ? PROGRESS_QUIET : PROGRESS_AUTO);
  ATTEMPT(progress ? OK : status_raise(ERR_MEMORY, "no memory"));
  ATTEMPT(command_lock_folder(a->out, COMMAND_ALONE, a->wait, progress, &lock));
  ATTEMPT(gallery_entries_check_folder(a->out, book, a->quick));
  status = make_chosen(a, book, chosen, progress, exit_code);
done:
  if (lock >= 0) close(lock);
  progress_destroy(progress);
  free(chosen);
  return status;
}

int command_gallery(int argc, char **argv) {
  static const struct argp_option options[] = {
      {"out", 'o', "DIR", 0,
       "folder for everything (default: " GALLERY_FOLDER ", with --quick " GALLERY_QUICK_FOLDER ")",
       0},
      {"quick", 'k', NULL, 0, "theory, lattices and small runs: minutes in all", 0},
      {"list", 'l', NULL, 0, "print id, kind and title of the entries, and make nothing", 0},
      {"threads", 't', "N", 0,
       "threads of all together (default: OMP_NUM_THREADS, else every core)", 0},
      {"jobs", 'j', "N", 0,
       "so many runs, and then entries, side by side (default: as is estimated to be fastest)", 0},
      {"force", 'f', NULL, 0, "make again even what is there already", 0},
      {"quiet", 'q', NULL, 0, "no progress; errors and verdicts only", 0},
      {"wait", 'w', NULL, 0, "wait for another plunge that is at work in the folder", 0},
      {0}};
  static const struct argp argp = {
      .options = options,
      .parser = parse,
      .args_doc = "[ID...]",
      .doc = "Makes the figures and tables of P (Antuono, Colagrossi & Marrone) and T (Kiara's "
             "thesis), or those that are named: 'P 1', T-2-13, all that begin so (P, 'T 4'), that "
             "fit ('T 4-2*'), or a range ('T 4-20..44'). Runs what they need and is not there, "
             "checks each against what its document says or what follows from its equations, "
             "draws it, and writes gallery.html, gallery.json and figures/. Exit code 1: a check "
             "came out otherwise than it is known to; 3: something could not be made.",
  };
  struct gallery_arguments a = {0};
  argp_parse(&argp, argc, argv, 0, NULL, &a);
  if (a.threads) omp_set_num_threads(a.threads);
  int exit_code = EXIT_FINE;
  struct gallery_book *book = gallery_runs_book(&exit_code);
  if (book) {
    const enum status status = open_gallery(&a, book, &exit_code);
    if (status != OK) exit_code = command_fail(status);
  }
  gallery_book_destroy(book);
  free(a.entries);
  return exit_code;
}

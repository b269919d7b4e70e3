/* The runs that entries of the gallery need: their cases, written where they can be run again, and
 * what there is of each. */
#pragma once
#include <limits.h>

#include "common/base/progress.h"
#include "common/case/case.h"
#include "common/solver.h"
#include "gallery/book.h"

/* Where it goes unless the user says otherwise: what --quick makes leaves what took longer alone. */
#define GALLERY_FOLDER       "out/gallery"
#define GALLERY_QUICK_FOLDER "out/gallery-quick"

/* The entries that the program carries. NULL when they are wrong, which goes to stderr, with the
 * exit code. */
struct gallery_book *gallery_runs_book(int *exit_code);

struct gallery_runs_case {
  const struct gallery_case *of;
  char path[PATH_MAX], folder[PATH_MAX]; /* of its file, of its results */
  size_t n_set;
  const char **set;    /* overrides in force, [n_set]; the texts are the book's */
  struct case_file *c;
};

enum gallery_run_state {
  GALLERY_RUN_MISSING,
  GALLERY_RUN_BROKEN, /* it broke off, as it would again */
  GALLERY_RUN_DONE,
};

struct gallery_run {
  char *name;               /* "CASE/RUN" */
  size_t of;                /* of the cases */
  const struct case_run *r;
  char fingerprint[33];
  bool wanted; /* by an entry that is to be made */
  enum gallery_run_state state;
  char why[400]; /* it broke off, or could not be made, or is done and not to be believed; or "" */
};

struct gallery_runs {
  const struct gallery_book *book;
  const char *out;
  bool quick;
  size_t n, n_cases;
  struct gallery_run *run;
  struct gallery_runs_case *cases;
};

/* Gathers the runs of the entries marked in `chosen` [book->n_entries], each once. Writes the files
 * of their cases into OUT/cases, reads them, and looks what is there in OUT/runs. ERR_INPUT when one
 * cannot be read or lacks a run that is named, which goes to stderr. */
enum status gallery_runs_gather(const struct gallery_book *book, const bool *chosen,
                                const char *out, bool quick, struct gallery_runs *runs);
void gallery_runs_free(struct gallery_runs *runs);

const struct gallery_run *gallery_runs_find(const struct gallery_runs *runs, const char *name);

struct solver_estimate gallery_runs_estimate(const struct gallery_runs *runs, size_t k);

/* Wants the runs of an entry that was gathered. */
enum status gallery_runs_want(struct gallery_runs *runs, const struct gallery_entry *e);

/* Makes those that are wanted and missing, or wanted at all with `again`, and looks what there is
 * then. A run that fails does not end it. INTERRUPTED. */
enum status gallery_runs_make(struct gallery_runs *runs, bool again, int jobs,
                              struct progress *progress);

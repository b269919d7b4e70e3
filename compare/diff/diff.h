/* Results of two programs, versions or machines side by side: two files, or two folders of files,
 * each with the one of the same name; and the report about them (`plunge diff --out`). */
#pragma once
#include "common/case/case.h"
#include "common/result/result_diff.h"
#include "compare/figure.h"

enum cmp_diff_outcome {
  CMP_DIFF_SAME,
  CMP_DIFF_DIFFERS,
  CMP_DIFF_ONLY_A, /* a file that the other folder has not */
  CMP_DIFF_ONLY_B,
  CMP_DIFF_TROUBLE /* one of the files cannot be read */
};

struct cmp_diff_distance {       /* between both surfaces at an instant */
  double t, mean, largest, area; /* sqrt(H/g), H, H, H^2; NaN: not known */
};

struct cmp_diff_run {
  char *name, *path[2]; /* NULL: only one has it */
  enum cmp_diff_outcome outcome;
  char *trouble;          /* why a file cannot be read; NULL */
  struct result_diff *d;  /* NULL unless both could be read */
  char *pictures_missing; /* why there are none of it; NULL */
  size_t n_distances;
  struct cmp_diff_distance distance[2]; /* when the results first differ, and when the most */
  size_t first_figure, n_figures;       /* of all figures */
};

struct cmp_diff {
  char *path[2];
  bool folders;
  size_t n, room;
  struct cmp_diff_run *run; /* [n], in the order of their names */
};

/* Finds what is to be compared. ERR_USAGE when one is a file and the other a folder; ERR_INPUT when
 * neither folder has a result. */
enum status cmp_diff_create(const char *a, const char *b, struct cmp_diff **out);
void cmp_diff_destroy(struct cmp_diff *d); /* NULL is fine */

/* Compares the files of run k; `shown`: what pictures need is kept. What is wrong with a file is an
 * outcome of the run; ERR_MEMORY, INTERRUPTED. */
enum status cmp_diff_compare(struct cmp_diff *d, size_t k,
                             const struct result_tolerances *tolerances, bool shown);

size_t cmp_diff_count(const struct cmp_diff *d, enum cmp_diff_outcome outcome);
/* Of all runs: SAME, TROUBLE when any has that, else DIFFERS. */
enum cmp_diff_outcome cmp_diff_outcome(const struct cmp_diff *d);
const char *cmp_diff_word(enum cmp_diff_outcome outcome); /* "same", "differs", "only in A" */

/* A sentence about all runs, and one about one of them; to be freed. NULL: no memory. */
char *cmp_diff_sentence(const struct cmp_diff *d);
char *cmp_diff_run_sentence(const struct cmp_diff_run *run);

/* What differs in a run, first what does so first in time, what has no time last; *n of them, to be
 * freed. ERR_MEMORY. */
enum status cmp_diff_order(const struct cmp_diff_run *run, size_t *n,
                           const struct result_quantity ***quantity);
/* The largest difference over the largest magnitude; NaN where there is no number. */
double cmp_diff_relative(const struct result_quantity *q);

enum { CMP_DIFF_PICTURED = 8, CMP_DIFF_CURVES = 6 }; /* runs with pictures; series of each */

/* Scripts of the pictures of run k, of which the surfaces are drawn in the tank of `settings`
 * (NULL: with walls at rest), and then forgets what only they need. */
enum status cmp_diff_picture(struct cmp_diff *d, size_t k, const struct case_file *settings,
                             struct cmp_figures *figures);

/* The report: diff.html, diff.json, diff.md and diff.xml in `out_dir`, each whole or not at all. */
enum status cmp_diff_write(const struct cmp_diff *d, const struct cmp_figures *figures,
                           const char *out_dir);

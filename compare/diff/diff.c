#include "compare/diff/diff.h"

#include <errno.h>
#include <fts.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "common/base/array.h"
#include "common/base/text.h"

/* ---- what is to be compared ---- */

static enum status add(struct cmp_diff *d, const char *name, const char *a, const char *b) {
  TRY(array_grow(&d->run, &d->room, d->n + 1, "runs"));
  struct cmp_diff_run *run = &d->run[d->n];
  *run = (struct cmp_diff_run){.outcome = b ? CMP_DIFF_ONLY_B : CMP_DIFF_ONLY_A};
  d->n++;
  run->name = strdup(name);
  if (a) run->path[0] = strdup(a);
  if (b) run->path[1] = strdup(b);
  CHECK(run->name && (!a || run->path[0]) && (!b || run->path[1]), ERR_MEMORY,
        "no memory for %zu runs", d->n);
  return OK;
}

/* What a name that ends like a result leads to; links are followed, but not those to nowhere. */
static bool is_result(const FTSENT *e) {
  return (e->fts_info == FTS_F || e->fts_info == FTS_NS || e->fts_info == FTS_SLNONE) &&
         e->fts_level && e->fts_name[0] != '.' && e->fts_namelen > 3 &&
         !strcmp(e->fts_name + e->fts_namelen - 3, ".h5");
}

static enum status entry_check(const FTSENT *e) {
  switch (e->fts_info) {
  case FTS_DNR:
  case FTS_ERR:
    return status_raise(ERR_INPUT, "cannot read the folder %s: %s", e->fts_path,
                        strerror(e->fts_errno));
  case FTS_DC:
    return status_raise(ERR_INPUT, "%s is a link to the folder that it is in: remove it",
                        e->fts_path);
  case FTS_NS:
    return e->fts_level && !is_result(e)
               ? OK
               : status_raise(ERR_INPUT, "cannot read %s: %s", e->fts_path, strerror(e->fts_errno));
  case FTS_SLNONE:
    return is_result(e)
               ? status_raise(ERR_INPUT, "%s is a link to a file that is not there", e->fts_path)
               : OK;
  default:
    return OK;
  }
}

static enum status entry_add(struct cmp_diff *d, const FTSENT *e, const char *folder, int side) {
  const char *name = e->fts_path + strlen(folder);
  name += strspn(name, "/");
  return add(d, name, side ? NULL : e->fts_path, side ? e->fts_path : NULL);
}

/* The results of one folder and the folders in it, by their paths from there. */
static enum status folder_add(struct cmp_diff *d, const char *folder, int side) {
  char *roots[] = {(char *)folder, NULL};
  FTS *tree = fts_open(roots, FTS_LOGICAL | FTS_NOCHDIR, NULL);
  CHECK(tree, ERR_INPUT, "cannot read the folder %s: %s", folder, strerror(errno));
  enum status status = OK;
  FTSENT *e;
  while (status == OK && (errno = 0, e = fts_read(tree))) {
    if (e->fts_info == FTS_D && e->fts_level && e->fts_name[0] == '.') {
      fts_set(tree, e, FTS_SKIP);
      continue;
    }
    status = entry_check(e);
    if (status == OK && is_result(e)) status = entry_add(d, e, folder, side);
  }
  if (status == OK && errno)
    status = status_raise(ERR_INPUT, "cannot read the folder %s: %s", folder, strerror(errno));
  fts_close(tree);
  return status;
}

static int by_name(const void *a, const void *b) {
  const struct cmp_diff_run *x = a, *y = b;
  const int order = strcmp(x->name, y->name);
  return order ? order : (x->path[1] != NULL) - (y->path[1] != NULL);
}

/* Two entries of one name become one. */
static void pairs_join(struct cmp_diff *d) {
  size_t n = 0;
  if (d->n) qsort(d->run, d->n, sizeof *d->run, by_name);
  for (size_t i = 0; i < d->n; i++) {
    d->run[n++] = d->run[i];
    if (i + 1 == d->n || strcmp(d->run[i].name, d->run[i + 1].name) != 0) continue;
    i++;
    d->run[n - 1].path[1] = d->run[i].path[1];
    free(d->run[i].name);
  }
  d->n = n;
}

static bool is_folder(const char *path) {
  struct stat about;
  return stat(path, &about) == 0 && S_ISDIR(about.st_mode);
}

static enum status runs_find(struct cmp_diff *d) {
  const bool folder[2] = {is_folder(d->path[0]), is_folder(d->path[1])};
  d->folders = folder[0] && folder[1];
  CHECK(folder[0] == folder[1], ERR_USAGE,
        "%s is a folder and %s is not: name two files or two folders", d->path[folder[1]],
        d->path[folder[0]]);
  if (!d->folders) {
    const char *slash = strrchr(d->path[1], '/');
    return add(d, slash ? slash + 1 : d->path[1], d->path[0], d->path[1]);
  }
  for (int k = 0; k < 2; k++) TRY(folder_add(d, d->path[k], k));
  pairs_join(d);
  CHECK(d->n, ERR_INPUT, "there is no result (NAME.h5) in %s nor in %s", d->path[0], d->path[1]);
  return OK;
}

enum status cmp_diff_create(const char *a, const char *b, struct cmp_diff **out) {
  struct cmp_diff *d = *out = calloc(1, sizeof *d);
  CHECK(d, ERR_MEMORY, "no memory to compare %s", a);
  d->path[0] = strdup(a);
  d->path[1] = strdup(b);
  enum status status = d->path[0] && d->path[1]
                           ? runs_find(d)
                           : status_raise(ERR_MEMORY, "no memory to compare %s", a);
  if (status == OK) return OK;
  cmp_diff_destroy(d);
  *out = NULL;
  return status;
}

void cmp_diff_destroy(struct cmp_diff *d) {
  if (!d) return;
  for (size_t i = 0; i < d->n; i++) {
    struct cmp_diff_run *run = &d->run[i];
    free(run->name);
    for (int k = 0; k < 2; k++) free(run->path[k]);
    free(run->trouble);
    free(run->pictures_missing);
    result_diff_destroy(run->d);
  }
  free(d->run);
  for (int k = 0; k < 2; k++) free(d->path[k]);
  free(d);
}

enum status cmp_diff_compare(struct cmp_diff *d, size_t k,
                             const struct result_tolerances *tolerances, bool shown) {
  struct cmp_diff_run *run = &d->run[k];
  if (!run->path[0] || !run->path[1]) return OK;
  const enum status status = result_diff_create(run->path[0], run->path[1], tolerances,
                                                shown ? CMP_DIFF_CURVES : 0, &run->d);
  if (status == ERR_MEMORY || status == INTERRUPTED) return status;
  run->outcome = status != OK       ? CMP_DIFF_TROUBLE
                 : run->d->n_differ ? CMP_DIFF_DIFFERS
                                    : CMP_DIFF_SAME;
  if (status == OK) return OK;
  run->trouble = strdup(status_message());
  CHECK(run->trouble, ERR_MEMORY, "no memory to compare %s", run->name);
  return OK;
}

/* ---- what came out ---- */

size_t cmp_diff_count(const struct cmp_diff *d, enum cmp_diff_outcome outcome) {
  size_t n = 0;
  for (size_t i = 0; i < d->n; i++) n += d->run[i].outcome == outcome;
  return n;
}

enum cmp_diff_outcome cmp_diff_outcome(const struct cmp_diff *d) {
  if (cmp_diff_count(d, CMP_DIFF_TROUBLE)) return CMP_DIFF_TROUBLE;
  return cmp_diff_count(d, CMP_DIFF_SAME) == d->n ? CMP_DIFF_SAME : CMP_DIFF_DIFFERS;
}

const char *cmp_diff_word(enum cmp_diff_outcome outcome) {
  static const char *const word[] = {"same", "differs", "only in A", "only in B", "trouble"};
  return word[outcome];
}

static void counts_say(const struct cmp_diff *d, FILE *out) {
  static const struct {
    enum cmp_diff_outcome outcome;
    const char *words;
  } kind[] = {{CMP_DIFF_ONLY_A, "only in A"},
              {CMP_DIFF_ONLY_B, "only in B"},
              {CMP_DIFF_TROUBLE, "could not be read"}};
  fprintf(out, "%zu of %zu runs differ", cmp_diff_count(d, CMP_DIFF_DIFFERS), d->n);
  for (size_t k = 0; k < sizeof kind / sizeof *kind; k++) {
    const size_t n = cmp_diff_count(d, kind[k].outcome);
    if (n) fprintf(out, ", %zu %s", n, kind[k].words);
  }
}

char *cmp_diff_sentence(const struct cmp_diff *d) {
  char *text = NULL;
  size_t n;
  if (!d->folders) return cmp_diff_run_sentence(&d->run[0]);
  FILE *out = open_memstream(&text, &n);
  if (!out) return NULL;
  counts_say(d, out);
  if (fclose(out) == 0) return text;
  free(text);
  return NULL;
}

static void quantities_say(const struct result_diff *r, FILE *out) {
  const struct result_quantity *first = result_diff_first(r);
  const double since = first ? result_quantity_since(first) : NAN;
  fprintf(out, "%zu of %zu quantities differ, %zu ignored", r->n_differ, r->n_differ + r->n_same,
          r->n_ignored);
  if (!first) return;
  fprintf(out, "; the first at t = %.6g s (t√(g/H) = %.4g): ", since, since / r->time_scale);
  text_show(out, first->name, "");
  if (first->beyond && first->first.time == since && isfinite(first->first.place[0])) {
    fprintf(out, ", at x = %.4g m", first->first.place[0]);
    if (isfinite(first->first.place[1])) fprintf(out, ", y = %.4g m", first->first.place[1]);
  }
}

char *cmp_diff_run_sentence(const struct cmp_diff_run *run) {
  char *text = NULL;
  size_t n;
  FILE *out = open_memstream(&text, &n);
  if (!out) return NULL;
  if (run->trouble)
    text_show(out, run->trouble, "");
  else if (!run->d)
    fputs(cmp_diff_word(run->outcome), out);
  else
    quantities_say(run->d, out);
  if (fclose(out) == 0) return text;
  free(text);
  return NULL;
}

double cmp_diff_relative(const struct result_quantity *q) {
  return q->worst.difference > 0 ? q->worst.difference / q->scale : NAN;
}

static int by_since(const void *a, const void *b) {
  const struct result_quantity *x = *(const struct result_quantity *const *)a,
                               *y = *(const struct result_quantity *const *)b;
  double s = result_quantity_since(x), t = result_quantity_since(y);
  if (isnan(s)) s = INFINITY;
  if (isnan(t)) t = INFINITY;
  if (s != t) return s < t ? -1 : 1;
  s = cmp_diff_relative(x);
  t = cmp_diff_relative(y);
  if (isfinite(s) && isfinite(t) && s != t) return s > t ? -1 : 1;
  return strcmp(x->name, y->name);
}

enum status cmp_diff_order(const struct cmp_diff_run *run, size_t *n,
                           const struct result_quantity ***quantity) {
  const size_t most = run->d ? run->d->n : 0;
  *n = 0;
  TRY(array_create(quantity, most, "differences"));
  for (size_t i = 0; i < most; i++)
    if (run->d->quantity[i].differs) (*quantity)[(*n)++] = &run->d->quantity[i];
  if (*n) qsort(*quantity, *n, sizeof **quantity, by_since);
  return OK;
}

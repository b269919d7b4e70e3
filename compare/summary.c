#include "compare/summary.h"

#include <stdarg.h>
#include <stdlib.h>

double cmp_summary_shared(const struct cmp_run *run) {
  double last = NAN;
  for (size_t i = 0; i < run->evolution.n; i++)
    if (isfinite(run->evolution.mean[i])) last = run->evolution.t[i];
  return last;
}

/* Runs that never leave agree to the end of what is shared; those never compared come last. */
static double agrees_until(const struct cmp_run *run) {
  if (cmp_known(&run->agreement)) return run->agreement.value;
  double shared = cmp_summary_shared(run);
  return isfinite(shared) ? shared + 1e6 : -1;
}

enum status cmp_summary_order(const struct comparison *c, size_t **order) {
  size_t *o = malloc((c->n_runs + 1) * sizeof *o);
  CHECK(o, ERR_MEMORY, "no memory for %zu runs", c->n_runs);
  for (size_t r = 0; r < c->n_runs; r++) { /* insertion: stable, and there are few */
    size_t at = r;
    while (at > 0 && agrees_until(&c->run[o[at - 1]]) < agrees_until(&c->run[r])) {
      o[at] = o[at - 1];
      at--;
    }
    o[at] = r;
  }
  *order = o;
  return OK;
}

struct text {
  char *at;
  size_t room;
};

__attribute__((format(printf, 2, 3))) static void append(struct text *t, const char *format, ...) {
  va_list args;
  va_start(args, format);
  int n = vsnprintf(t->at, t->room, format, args);
  va_end(args);
  size_t used = n < 0 ? 0 : (size_t)n < t->room ? (size_t)n : t->room ? t->room - 1 : 0;
  t->at += used;
  t->room -= used;
}

/* How many runs from the k-th on agree until the same end: they are named together. */
static size_t alike(const struct comparison *c, const size_t *order, size_t k) {
  const struct cmp_run *first = &c->run[order[k]];
  double shared = cmp_summary_shared(first);
  size_t m = k + 1;
  if (cmp_known(&first->agreement) || !first->data.file->complete) return 1;
  while (m < c->n_runs && !cmp_known(&c->run[order[m]].agreement) &&
         c->run[order[m]].data.file->complete && cmp_summary_shared(&c->run[order[m]]) == shared)
    m++;
  return m - k;
}

static bool one_spacing(const struct comparison *c) {
  for (size_t r = 1; r < c->n_runs; r++)
    if (c->run[r].data.dx != c->run[0].data.dx) return false;
  return true;
}

enum status cmp_summary_sentence(const struct comparison *c, const struct cmp_rows *rows,
                                 char *sentence, size_t room) {
  struct text t = {sentence, room};
  size_t *order;
  sentence[0] = 0;
  TRY(cmp_summary_order(c, &order));
  for (size_t k = 0, n; k < c->n_runs; k += n) {
    const struct cmp_run *run = &c->run[order[k]];
    double shared = cmp_summary_shared(run);
    n = alike(c, order, k);
    for (size_t m = 0; m < n; m++)
      append(&t, "%s%.60s",
             m   ? (m + 1 < n ? ", " : " and ")
             : k ? "; "
                 : "",
             c->run[order[k + m]].data.label);
    append(&t, " ");
    if (!isfinite(shared))
      append(&t, "cannot be compared (%s)", run->agreement.why);
    else {
      bool leaves = cmp_known(&run->agreement);
      double until = leaves ? run->agreement.value : shared;
      if (k == 0) {
        append(&t, "%s within one particle spacing (", n > 1 ? "stay" : "stays");
        if (one_spacing(c)) append(&t, "%.3g H, ", run->data.dx);
        append(&t, "on average along the surface) of %.60s ", c->ref.data.label);
      }
      append(&t, leaves ? "until t* = %.3g" : "to the end of what they share, t* = %.3g", until);
      if (!leaves && !run->data.file->complete) append(&t, " (unfinished)");
    }
  }
  if (!c->n_runs) append(&t, "There is no run to compare with %.60s", c->ref.data.label);
  append(&t, ".");
  size_t n = rows->passed + rows->failed;
  if (rows->failed)
    append(&t, " %zu of %zu checks against the case's tolerances %s.", rows->failed, n,
           rows->failed == 1 ? "fails" : "fail");
  else if (n)
    append(&t, " All %zu checks against the case's tolerances pass.", n);
  free(order);
  return OK;
}

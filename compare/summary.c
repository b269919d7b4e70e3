#include "compare/summary.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

double cmp_summary_shared(const struct cmp_run *run) {
  const struct cmp_evolution *e = &run->evolution;
  double last = NAN;
  for (size_t i = 0; i < e->n; i++)
    if (isfinite(e->value[CMP_MEASURE_mean_distance][i])) last = e->t[i];
  return last;
}

/* Runs that never leave agree to the end of what is shared; those never compared come last. */
static double agrees_until(const struct cmp_run *run) {
  if (cmp_known(&run->agreement)) return run->agreement.value;
  double shared = cmp_summary_shared(run);
  return isfinite(shared) ? shared + 1e6 : -1;
}

/* A wave so low that a particle spacing is much of it: then what counts is the part of the wave
 * that a run is off by. */
static bool low_wave(const struct comparison *c) {
  double coarsest = 0;
  for (size_t r = 0; r < c->n_runs; r++) coarsest = fmax(coarsest, c->run[r].data.dx);
  return cmp_known(&c->motion) && c->motion.value < 4 * coarsest;
}

struct placed {
  double merit;
  size_t run;
};

/* The better first, then the one that the case names first. */
static int better_first(const void *a, const void *b) {
  const struct placed *x = a, *y = b;
  if (x->merit != y->merit) return x->merit < y->merit ? 1 : -1;
  return (x->run > y->run) - (x->run < y->run);
}

enum status cmp_summary_order(const struct comparison *c, size_t **order) {
  struct placed *placed = malloc((c->n_runs + 1) * sizeof *placed);
  *order = malloc((c->n_runs + 1) * sizeof **order);
  if (!placed || !*order) {
    free(placed);
    free(*order);
    return status_raise(ERR_MEMORY, "no memory for %zu runs", c->n_runs);
  }
  bool low = low_wave(c);
  for (size_t r = 0; r < c->n_runs; r++) {
    const struct cmp_run *run = &c->run[r];
    double merit = !low ? agrees_until(run) : cmp_known(&run->off) ? -run->off.value : -INFINITY;
    placed[r] = (struct placed){merit, r};
  }
  qsort(placed, c->n_runs, sizeof *placed, better_first);
  for (size_t k = 0; k < c->n_runs; k++) (*order)[k] = placed[k].run;
  free(placed);
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

/* At most so many runs are named, of each kind; the others are counted. */
enum { NAMED = 6 };

static void append_name(struct text *t, const struct cmp_run *run, bool health) {
  append(t, "%.60s", run->data.label);
  if (health && run->health.verdict != HEALTH_SOUND)
    append(t, " (%s)", health_verdicts[run->health.verdict]);
}

/* "x, y (doubtful) and z" of order[0] to order[n - 1], with their health or without. */
static void append_names(struct text *t, const struct comparison *c, const size_t *order, size_t n,
                         bool health) {
  size_t shown = n > NAMED + 1 ? NAMED : n;
  for (size_t k = 0; k < shown; k++) {
    append(t, "%s", !k ? "" : k + 1 < n ? ", " : " and ");
    append_name(t, &c->run[order[k]], health);
  }
  if (shown < n) append(t, " and %zu more", n - shown);
}

/* What is wrong with a run, ": " before it, but for why it ended where that is said already; long
 * lists are cut between two words. */
static void append_reasons(struct text *t, const struct cmp_run *run, bool ended_said) {
  enum { MOST = 260 };
  const char *why = ended_said ? health_other_reasons(&run->health) : run->health.reasons;
  size_t n = strlen(why);
  bool whole = n <= MOST;
  for (n = whole ? n : MOST; !whole && n && why[n] != ' ';) n--;
  if (n) append(t, ": %.*s%s", (int)n, why, whole ? "" : " (and so on)");
}

static const char *verdict_words(const struct cmp_run *run, bool many) {
  if (run->health.verdict == HEALTH_FAILED) return many ? "have failed" : "has failed";
  return many ? "are doubtful" : "is doubtful";
}

/* ---- the reference: where it ends and why, before anything is compared with it ---- */

static double last_of(const struct result_file *f) {
  return f->n_energy     ? f->energy[f->n_energy - 1].time
         : f->n_surfaces ? f->surface_time[f->n_surfaces - 1]
                         : 0;
}

static void append_end(struct text *t, const struct comparison *c) {
  const struct result_file *f = c->ref.data.file;
  append(t, "ends at t* = %.3g", last_of(f) / c->scales.T);
  if (c->settings->end > last_of(f)) append(t, " of %.3g", c->settings->end / c->scales.T);
  append(t, *f->ended ? " (%.300s)" : " (unfinished)", f->ended);
}

/* An older file that is complete, and has no surface for the last two outputs of its case or more.
 */
static bool stops_silently(const struct comparison *c) {
  const struct cmp_data *d = &c->ref.data;
  size_t n = d->file->n_surfaces;
  double end = c->settings->end / c->scales.T;
  return n && d->file->surface_time[n - 1] / c->scales.T < end - 2 * cmp_data_interval(d) - 1e-9;
}

static void append_reference(struct text *t, const struct comparison *c) {
  const struct cmp_run *ref = &c->ref;
  const struct result_file *f = ref->data.file;
  bool early = !f->complete || *f->ended, silent = !early && stops_silently(c);
  bool sound = ref->health.verdict == HEALTH_SOUND;
  if (!early && !silent && sound) return;
  append(t, "The reference %.60s ", ref->data.label);
  if (early) append_end(t, c);
  if (silent)
    append(t, "has no surface after t* = %.3g of %.3g, and does not say why",
           f->surface_time[f->n_surfaces - 1] / c->scales.T, c->settings->end / c->scales.T);
  if (!sound) {
    append(t, early || silent ? " and %s" : "%s", verdict_words(ref, false));
    append_reasons(t, ref, early);
  }
  if (isfinite(c->until)) append(t, "; nothing is compared beyond t* = %.3g", c->until);
  append(t, ". ");
}

static void append_foreign(struct text *t, const struct comparison *c, size_t *chosen) {
  size_t n = 0;
  for (size_t r = 0; r < c->n_runs; r++)
    if (c->run[r].foreign) chosen[n++] = r;
  if (!n) return;
  append_names(t, c, chosen, n, true);
  append(t, " %s not of the tank, water and scales of %.60s, and compared all the same. ",
         n > 1 ? "are" : "is", c->ref.data.label);
}

/* ---- how near the runs are ---- */

static bool same_blind(const struct cmp_run *a, const struct cmp_run *b) {
  if (isnan(a->blind[0]) || isnan(b->blind[0])) return isnan(a->blind[0]) && isnan(b->blind[0]);
  return a->blind[0] == b->blind[0] && a->blind[1] == b->blind[1];
}

/* How many runs from the k-th on agree until the same end: they are named together. */
static size_t alike(const struct comparison *c, const size_t *order, size_t k) {
  const struct cmp_run *first = &c->run[order[k]];
  double shared = cmp_summary_shared(first);
  size_t m = k + 1;
  if (cmp_known(&first->agreement) || !first->data.file->complete) return 1;
  while (m < c->n_runs && !cmp_known(&c->run[order[m]].agreement) &&
         c->run[order[m]].data.file->complete && cmp_summary_shared(&c->run[order[m]]) == shared &&
         same_blind(&c->run[order[m]], first))
    m++;
  return m - k;
}

static bool one_spacing(const struct comparison *c) {
  for (size_t r = 1; r < c->n_runs; r++)
    if (c->run[r].data.dx != c->run[0].data.dx) return false;
  return true;
}

/* The longest stretch in which nothing could be measured. */
static void append_gap(struct text *t, const double *gap) {
  if (isnan(gap[0])) return;
  append(t,
         gap[1] > gap[0] ? " (not measured from t* = %.3g to %.3g)"
                         : " (not measured at t* = %.3g)",
         gap[0], gap[1]);
}

static void append_until(struct text *t, const struct comparison *c, const struct cmp_run *run,
                         bool first, size_t n) {
  double shared = cmp_summary_shared(run);
  if (!isfinite(shared)) {
    append(t, " cannot be compared (%s)", run->agreement.why);
    return;
  }
  if (first) {
    append(t, " %s within one particle spacing (", n > 1 ? "stay" : "stays");
    if (one_spacing(c)) append(t, "%.3g H, ", run->data.dx);
    append(t, "on average along the surface) of %.60s", c->ref.data.label);
  }
  const bool leaves = cmp_known(&run->agreement);
  if (leaves && run->evolution.n && !(run->agreement.value > run->evolution.t[0])) {
    append(t, " at no time");
    return;
  }
  append(t, leaves ? " until t* = %.3g" : " to the end of what they share, t* = %.3g",
         leaves ? run->agreement.value : shared);
  if (!leaves && !run->data.file->complete) append(t, " (unfinished)");
  append_gap(t, run->blind);
}

static void append_agreement(struct text *t, const struct comparison *c, const size_t *order) {
  size_t k = 0, clauses = 0;
  for (size_t n; k < c->n_runs && clauses < NAMED; k += n, clauses++) {
    n = alike(c, order, k);
    if (k) append(t, "; ");
    append_names(t, c, order + k, n, true);
    append_until(t, c, &c->run[order[k]], k == 0, n);
  }
  if (k < c->n_runs) {
    append(t, "; and %zu more", c->n_runs - k);
    if (cmp_known(&c->run[order[k]].agreement))
      append(t, ", none longer than t* = %.3g", c->run[order[k]].agreement.value);
  }
  append(t, ". ");
}

/* "..., of which bem is off by 0.3 %, viscous by 22 %" */
static void append_parts(struct text *t, const struct comparison *c, const size_t *order) {
  append(t,
         "The surface of %.60s moves by %.3g H on average, %.2g of the coarsest particle "
         "spacing; of that ",
         c->ref.data.label, c->motion.value, c->motion.value / (c->depth / 2));
  size_t shown = c->n_runs > NAMED + 1 ? NAMED : c->n_runs;
  for (size_t k = 0; k < shown; k++) {
    const struct cmp_run *run = &c->run[order[k]];
    append(t, "%s", !k ? "" : k + 1 < c->n_runs ? ", " : " and ");
    append_name(t, run, true);
    if (!cmp_known(&run->off))
      append(t, " cannot be compared (%s)", run->off.why);
    else
      append(t, "%s at most %.2g %%", k ? "" : " is off by", 100 * run->off.value);
    if (!run->data.file->complete) append(t, " (unfinished)");
    if (cmp_known(&run->off)) append_gap(t, run->unseen);
  }
  if (shown < c->n_runs)
    append(t, " and %zu more up to %.2g %%", c->n_runs - shown,
           100 * c->run[order[c->n_runs - 1]].off.value);
  append(t, ". ");
}

/* The runs from order[k] on that are unsound for the very reasons of that one. */
static size_t unsound_alike(const struct comparison *c, const size_t *order, size_t k,
                            size_t *chosen) {
  const struct health *first = &c->run[order[k]].health;
  size_t n = 0;
  for (; k < c->n_runs; k++) {
    const struct health *h = &c->run[order[k]].health;
    if (h->verdict == first->verdict && !strcmp(h->reasons, first->reasons)) chosen[n++] = order[k];
  }
  return n;
}

static bool unsound_before(const struct comparison *c, const size_t *order, size_t k) {
  const struct health *h = &c->run[order[k]].health;
  for (size_t i = 0; i < k; i++) {
    const struct health *earlier = &c->run[order[i]].health;
    if (h->verdict == earlier->verdict && !strcmp(h->reasons, earlier->reasons)) return true;
  }
  return false;
}

/* Why those that are doubtful or failed are. */
static void append_unsound(struct text *t, const struct comparison *c, const size_t *order,
                           size_t *chosen) {
  enum { EXPLAINED = 3 };
  size_t reasons = 0, more = 0;
  for (size_t k = 0; k < c->n_runs; k++) {
    const struct cmp_run *run = &c->run[order[k]];
    if (run->health.verdict == HEALTH_SOUND || unsound_before(c, order, k)) continue;
    size_t n = unsound_alike(c, order, k, chosen);
    if (reasons++ >= EXPLAINED) {
      more += n;
      continue;
    }
    append_names(t, c, chosen, n, false);
    append(t, " %s", verdict_words(run, n > 1));
    append_reasons(t, run, false);
    append(t, ". ");
  }
  if (more) append(t, "%zu more %s not sound either. ", more, more > 1 ? "are" : "is");
}

static void append_checks(struct text *t, const struct cmp_rows *rows) {
  size_t n = rows->passed + rows->failed;
  if (rows->failed)
    append(t, "%zu of %zu checks against the case's tolerances %s.", rows->failed, n,
           rows->failed == 1 ? "fails" : "fail");
  else if (n == 1)
    append(t, "The check against the case's tolerances passes.");
  else if (n)
    append(t, "All %zu checks against the case's tolerances pass.", n);
  if (rows->partial)
    append(t, " %zu pass%s without every sensor: the table of checks names those left out.",
           rows->partial, rows->partial == 1 ? "es" : "");
}

enum status cmp_summary_sentence(const struct comparison *c, const struct cmp_rows *rows,
                                 char *sentence, size_t room) {
  struct text t = {sentence, room};
  size_t *order;
  sentence[0] = 0;
  TRY(cmp_summary_order(c, &order));
  size_t *chosen = malloc((c->n_runs + 1) * sizeof *chosen);
  if (!chosen) {
    free(order);
    return status_raise(ERR_MEMORY, "no memory for %zu runs", c->n_runs);
  }
  append_reference(&t, c);
  append_foreign(&t, c, chosen);
  if (!c->n_runs)
    append(&t, "There is no run to compare with %.60s. ", c->ref.data.label);
  else if (low_wave(c))
    append_parts(&t, c, order);
  else
    append_agreement(&t, c, order);
  append_unsound(&t, c, order, chosen);
  append_checks(&t, rows);
  size_t n = strlen(sentence);
  if (n && sentence[n - 1] == ' ') sentence[n - 1] = 0;
  free(order);
  free(chosen);
  return OK;
}

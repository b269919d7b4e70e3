/* What two results differ in, as text: what comes from the files shows what it holds, and stays on
 * its line. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/text.h"
#include "common/result/result_diff.h"

double result_quantity_since(const struct result_quantity *q) {
  return fmin(q->beyond ? q->first.time : NAN, q->what_time); /* of a number and NaN the number */
}

const struct result_quantity *result_diff_first(const struct result_diff *d) {
  const struct result_quantity *first = NULL;
  for (size_t i = 0; i < d->n; i++) {
    const struct result_quantity *q = &d->quantity[i];
    const double t = result_quantity_since(q);
    if (q->differs && isfinite(t) && !(first && t >= result_quantity_since(first))) first = q;
  }
  return first;
}

static void time_say(const struct result_diff *d, double t, FILE *out) {
  fprintf(out, "t = %.6g s (t sqrt(g/H) = %.4g)", t, t / d->time_scale);
}

static void numbers_say(const struct result_diff *d, const struct result_quantity *q, FILE *out) {
  const struct result_spot *w = &q->worst;
  fprintf(out, "%.10g against %.10g%s", w->value[0], w->value[1], *q->units ? " " : "");
  text_show(out, q->units, "");
  fprintf(out, ", differs by %.3g (relative %.3g)", w->difference,
          q->scale > 0 ? w->difference / q->scale : 0);
  if (isfinite(w->time)) fputs(" at ", out), time_say(d, w->time, out);
  if (q->rank) fprintf(out, ", row %zu", w->row);
  if (q->rank == 2) fprintf(out, ", %c", "xyzw"[w->component % 4]);
  if (q->beyond < 2) return;
  fprintf(out, "; %zu of %zu numbers differ", q->beyond, q->n);
  if (isfinite(q->first.time)) fputs(", the first at ", out), time_say(d, q->first.time, out);
}

char *result_quantity_say(const struct result_diff *d, const struct result_quantity *q) {
  char *text = NULL;
  size_t n;
  FILE *out = open_memstream(&text, &n);
  if (!out) return NULL;
  if (q->what) text_show(out, q->what, "");
  if (q->what && isfinite(q->what_time)) {
    fputs(", from ", out);
    time_say(d, q->what_time, out);
    fputs(" on", out);
  }
  if (q->what && q->beyond) fputs("; of those that both have ", out);
  if (q->beyond || (!q->what && q->worst.difference > 0)) numbers_say(d, q, out);
  if (fclose(out) == 0) return text;
  free(text);
  return NULL;
}

static void first_print(const struct result_diff *d, FILE *out) {
  const struct result_quantity *first = result_diff_first(d);
  size_t others = 0;
  if (!first) return;
  const double since = result_quantity_since(first);
  for (size_t i = 0; i < d->n; i++)
    others += d->quantity[i].differs && &d->quantity[i] != first &&
              result_quantity_since(&d->quantity[i]) == since;
  fputs("first difference at ", out);
  time_say(d, since, out);
  fputs(": ", out);
  text_show(out, first->name, "");
  if (others) fprintf(out, " and %zu other%s", others, others == 1 ? "" : "s");
  fputc('\n', out);
}

void result_diff_print(const struct result_diff *d, FILE *out) {
  for (size_t i = 0; i < d->n; i++) {
    const struct result_quantity *q = &d->quantity[i];
    if (!q->differs) continue;
    char *text = result_quantity_say(d, q);
    text_show(out, q->name, "");
    fprintf(out, ": %s\n", text ? text : "differs");
    free(text);
  }
  first_print(d, out);
  fprintf(out, "%zu of %zu quantities differ, %zu ignored\n", d->n_differ, d->n_differ + d->n_same,
          d->n_ignored);
}

/* ---- rules ---- */

struct draft { /* a line of it: what differs in this quantity in the rows of one rule */
  const char *name;
  size_t rule;     /* SIZE_MAX: none was looked for */
  double relative; /* INFINITY: to be ignored */
};

static int by_name_and_rule(const void *a, const void *b) {
  const struct draft *x = a, *y = b;
  const int order = strcmp(x->name, y->name);
  if (order) return order;
  return (x->rule > y->rule) - (x->rule < y->rule);
}

static size_t drafts_of(const struct result_quantity *q, struct draft *draft) {
  if (!q->differs) return 0;
  if (q->what) {
    draft[0] = (struct draft){q->name, SIZE_MAX, INFINITY};
    return 1;
  }
  for (size_t k = 0; k < q->n_used; k++) {
    const double worst = q->used[k].worst;
    const bool none = worst < 0 || (worst > 0 && !(q->scale > 0)); /* that would do */
    draft[k] = (struct draft){q->name, q->used[k].rule,
                              none        ? INFINITY
                              : worst > 0 ? worst / q->scale
                                          : 0};
  }
  return q->n_used;
}

/* A pattern that matches this name only, and stays one word: what may not stand in it is any
 * character. */
static void pattern_print(const char *name, bool padded, FILE *out) {
  int n = 0;
  for (const char *c = name; *c; c++, n++)
    fputc((unsigned char)*c <= ' ' || *c == 127 || strchr("#*?[]\\", *c) ? '?' : *c, out);
  fprintf(out, "%*s", padded && n < 40 ? 40 - n : 0, "");
}

static void draft_print(const struct draft *d, const struct result_tolerances *t, FILE *out) {
  char when[96] = "";
  pattern_print(d->name, true, out);
  if (d->rule != SIZE_MAX) result_tolerance_when(&t->rule[d->rule], when, sizeof when);
  if (isfinite(d->relative))
    fprintf(out, " %.1e 0%s\n", 1.1 * d->relative, when);
  else
    fprintf(out, " ignore%s\n", when);
}

enum status result_diff_draft(size_t n, struct result_diff *const *d,
                              const struct result_tolerances *t, FILE *out) {
  struct draft *draft;
  size_t room = 0, m = 0;
  for (size_t k = 0; k < n; k++)
    for (size_t i = 0; i < d[k]->n; i++) room += d[k]->quantity[i].n_used + 1;
  TRY(array_create(&draft, room, "tolerances"));
  for (size_t k = 0; k < n; k++)
    for (size_t i = 0; i < d[k]->n; i++) m += drafts_of(&d[k]->quantity[i], &draft[m]);
  qsort(draft, m, sizeof *draft, by_name_and_rule);
  for (size_t i = 0; i < m; i++) {
    double relative = draft[i].relative;
    for (; i + 1 < m && !by_name_and_rule(&draft[i], &draft[i + 1]); i++)
      relative = fmax(relative, draft[i + 1].relative);
    draft[i].relative = relative;
    draft_print(&draft[i], t, out);
  }
  free(draft);
  return OK;
}

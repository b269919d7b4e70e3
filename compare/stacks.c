#include "compare/stacks.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"

enum { MOST = 64, PANELS = 6, PANEL_HEIGHT = 130 };

/* The series of one kind of a run. */
typedef const struct cmp_series *list_of(const struct cmp_data *d, size_t *n);

static const struct cmp_series *diagnostics_of(const struct cmp_data *d, size_t *n) {
  *n = d->n_diagnostics;
  return d->diagnostics;
}

static const struct cmp_series *terms_of(const struct cmp_data *d, size_t *n) {
  *n = d->n_terms;
  return d->terms;
}

/* A series that some run has, whatever the run. */
struct number {
  const char *name, *label, *units;
  bool log; /* its axis */
  struct cmp_frame frame;
};

struct stack {
  const struct comparison *c;
  list_of *list;
  bool logs; /* axes may be logarithmic: energies add up, and noise does not */
  size_t n;
  struct number number[MOST];
};

static const struct cmp_series *find(const struct stack *s, size_t r, const char *name) {
  size_t n;
  const struct cmp_series *list = s->list(&cmp_run_or_ref(s->c, r)->data, &n);
  const struct cmp_series *found = cmp_series_find(list, n, name);
  return found && found->n ? found : NULL;
}

/* The i-th of the reference and the runs that have a line of their own, in the order that they are
 * drawn; false: it has none. */
static bool drawn(const struct comparison *c, size_t i, size_t *r) {
  *r = i ? i - 1 : SIZE_MAX;
  return !i || cmp_run_is_picked(c, *r, CMP_NAMED);
}

static bool is_nothing(const struct cmp_series *s) {
  for (size_t i = 0; i < s->n; i++)
    if (s->value[i] != 0) return false;
  return true;
}

static void numbers_add(struct stack *s, size_t r) {
  size_t n;
  const struct cmp_series *list = s->list(&cmp_run_or_ref(s->c, r)->data, &n);
  for (size_t k = 0; k < n && s->n < MOST; k++) {
    bool known = is_nothing(&list[k]);
    for (size_t i = 0; i < s->n && !known; i++) known = !strcmp(s->number[i].name, list[k].name);
    if (known) continue;
    s->number[s->n++] = (struct number){.name = list[k].name,
                                        .label = list[k].label ? list[k].label : "E0",
                                        .units = list[k].units ? list[k].units : "E0"};
  }
}

/* ---- axes ---- */

enum {
  LOG_LEAST = 30, /* times from low to high that a logarithmic axis is worth */
  BEYOND = 1000   /* times the size of the others: of a run that has blown up */
};

struct range { /* of positive numbers: all of them, and from where on nine of ten are */
  double low, high, usual;
};

/* False where any is negative, or one of ten is zero. */
static enum status range_of(const struct cmp_series *s, struct range *range, bool *positive) {
  double *v = malloc((s->n + 1) * sizeof *v);
  CHECK(v, ERR_MEMORY, "no memory for a chart");
  size_t n = 0;
  for (size_t i = 0; i < s->n; i++)
    if (isfinite(s->value[i])) v[n++] = s->value[i];
  qsort(v, n, sizeof *v, array_ascending);
  *positive = n && v[0] >= 0 && v[n / 10] > 0;
  size_t first = 0;
  while (first < n && !(v[first] > 0)) first++;
  if (*positive)
    *range = (struct range){fmin(range->low, v[first]), fmax(range->high, v[n - 1]),
                            fmin(range->usual, v[n / 10])};
  free(v);
  return OK;
}

static enum status axis_choose(struct stack *s, struct number *a, double end) {
  const struct comparison *c = s->c;
  const struct cmp_series **all = calloc(c->n_runs + 1, sizeof(struct cmp_series *));
  struct range range = {INFINITY, 0, INFINITY};
  enum status status = OK;
  CHECK(all, ERR_MEMORY, "no memory for a chart");
  a->log = s->logs;
  for (size_t i = 0, r; i <= c->n_runs; i++) {
    const struct cmp_series *own = drawn(c, i, &r) ? find(s, r, a->name) : NULL;
    bool positive = false;
    if (!own || is_nothing(own)) continue;
    all[i] = own;
    ATTEMPT(range_of(own, &range, &positive));
    a->log = a->log && positive;
  }
  a->log = a->log && range.high > LOG_LEAST * range.usual;
  if (a->log)
    a->frame = (struct cmp_frame){fmax(range.low, 1e-6 * range.high) / 1.5, range.high * 1.5};
  else
    a->frame = cmp_frame_choose(c->n_runs + 1, all, end, BEYOND);
done:
  free(all);
  return status;
}

static void axis_write(FILE *script, const struct number *a) {
  if (a->log)
    fprintf(script,
            "set logscale y\nset yrange [%.6g:%.6g]\nset ytics auto\nset format y '10^{%%L}'\n",
            a->frame.low, a->frame.high);
}

static void axis_reset(FILE *script, const struct number *a) {
  if (a->log) fputs("unset logscale y\nset format y '%g'\n", script);
}

/* ---- one figure ---- */

static void rows_write(const struct stack *s, struct cmp_chart *chart, size_t first, size_t n) {
  for (size_t r = 0; r <= s->c->n_runs; r++) {
    const struct cmp_series *own[PANELS], *time = NULL;
    for (size_t k = 0; k < n; k++) {
      own[k] = find(s, r < s->c->n_runs ? r : SIZE_MAX, s->number[first + k].name);
      if (own[k] && !time) time = own[k]; /* those of a kind share their times */
    }
    for (size_t i = 0; time && i < time->n; i++) {
      double value[PANELS];
      for (size_t k = 0; k < n; k++)
        value[k] = own[k] && i < own[k]->n && own[k]->t[i] == time->t[i] ? own[k]->value[i] : NAN;
      cmp_chart_row(chart, r, cmp_run_or_ref(s->c, r < s->c->n_runs ? r : SIZE_MAX)->data.label,
                    time->t[i], value, n);
    }
  }
}

static void panel_draw(const struct stack *s, struct cmp_chart *chart, size_t panel,
                       size_t number) {
  const struct number *a = &s->number[number];
  const bool last = panel + 1 == chart->panels, pure = !strcmp(a->label, "1");
  char title[96];
  snprintf(title, sizeof title, "%.48s%s%s", a->name, pure ? "" : " / ", pure ? "" : a->label);
  cmp_chart_panel(chart, panel, &a->frame, "", title);
  axis_write(chart->fig->script, a);
  if (!a->log)
    for (size_t i = 0, r; i <= s->c->n_runs; i++) {
      const struct cmp_series *own = drawn(s->c, i, &r) ? find(s, r, a->name) : NULL;
      if (!own) continue;
      struct cmp_beyond beyond = cmp_frame_beyond(&a->frame, own, chart->end);
      cmp_chart_mark(chart, &beyond, cmp_run_style(s->c, r).colour);
    }
  for (size_t i = 0, r; i <= s->c->n_runs; i++) {
    if (!drawn(s->c, i, &r)) continue;
    const bool there = find(s, r, a->name) != NULL;
    if (!there && !last) continue;
    size_t others = 0;
    for (size_t k = number - panel; k <= number; k++)
      others += find(s, r, s->number[k].name) != NULL;
    const size_t id = r == SIZE_MAX ? s->c->n_runs : r;
    cmp_chart_curve(chart,
                    &(struct cmp_curve){.series = id,
                                        .column = panel,
                                        .name = last ? cmp_run_or_ref(s->c, r)->data.label : NULL,
                                        .note = others ? NULL : " (has none)",
                                        .style = cmp_run_style(s->c, r),
                                        .width = 1});
  }
  cmp_chart_others(chart, panel, last);
  cmp_chart_panel_end(chart);
  axis_reset(chart->fig->script, a);
}

struct page_of { /* a figure of a stack */
  enum cmp_section section;
  const char *name, *caption;
};

static enum status figure_write(const struct stack *s, struct cmp_figures *f, size_t first,
                                size_t n, const struct page_of *page) {
  struct cmp_chart chart;
  char columns[PANELS * 96] = "";
  for (size_t k = 0, used = 0; k < n; k++)
    used += (size_t)snprintf(columns + used, sizeof columns - used, "%s%.48s [%s]", k ? "," : "",
                             s->number[first + k].name, s->number[first + k].units);
  const struct cmp_chart_plan plan = {.section = page->section,
                                      .name = page->name,
                                      .columns = columns,
                                      .panels = n,
                                      .panel_height = PANEL_HEIGHT,
                                      .note = strlen(" (has none)")};
  TRY(cmp_chart_begin(s->c, f, &plan, &chart));
  snprintf(chart.fig->caption, sizeof chart.fig->caption, "%s", page->caption);
  rows_write(s, &chart, first, n);
  for (size_t k = 0; k < n; k++) panel_draw(s, &chart, k, first + k);
  return cmp_chart_end(&chart);
}

/* Linear axes first: each figure then is of one kind, as far as that goes. */
static int linear_first(const void *a, const void *b) {
  const struct number *x = a, *y = b;
  return x->log != y->log ? x->log - y->log : strcmp(x->name, y->name);
}

static enum status stack_write(const struct comparison *c, struct cmp_figures *f, list_of *list,
                               bool logs, const struct page_of *page) {
  struct stack *s = calloc(1, sizeof *s);
  CHECK(s, ERR_MEMORY, "no memory for a chart");
  enum status status = OK;
  *s = (struct stack){.c = c, .list = list, .logs = logs};
  for (size_t i = 0, r; i <= c->n_runs; i++)
    if (drawn(c, i, &r)) numbers_add(s, r);
  const struct cmp_chart_plan whole = {0};
  for (size_t k = 0; k < s->n; k++)
    ATTEMPT(axis_choose(s, &s->number[k], cmp_chart_time_end(c, &whole)));
  qsort(s->number, s->n, sizeof *s->number, linear_first);
  const size_t figures = (s->n + PANELS - 1) / PANELS;
  for (size_t k = 0; k < figures; k++) {
    char name[48];
    const size_t first = k * s->n / figures, end = (k + 1) * s->n / figures;
    snprintf(name, sizeof name, figures > 1 ? "%s-%zu" : "%s", page->name, k + 1);
    ATTEMPT(figure_write(s, f, first, end - first,
                         &(struct page_of){page->section, name, page->caption}));
  }
done:
  free(s);
  return status;
}

enum status cmp_stacks_write(const struct comparison *c, struct cmp_figures *f) {
  TRY(stack_write(c, f, terms_of, false,
                  &(struct page_of){CMP_SECTION_ENERGY, "energy-terms",
                                    "What each of the solvers' own terms has taken out of the "
                                    "water since t = 0, in E0; terms that no run has used are left "
                                    "out."}));
  return stack_write(c, f, diagnostics_of, true,
                     &(struct page_of){CMP_SECTION_DIAGNOSTICS, "diagnostics",
                                       "What the runs say of their noise, compression and momenta "
                                       "at every sample; the table says what each is."});
}

#include "compare/family.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "compare/cuts.h"

void cmp_family_caption_end(const struct comparison *c, struct cmp_figure *fig) {
  size_t used = strlen(fig->caption);
  cmp_picked_say(c, CMP_NAMED, "are drawn in thin grey", fig->caption + used,
                 sizeof fig->caption - used);
}

bool cmp_family_empty(const struct comparison *c, const struct cmp_family *family) {
  for (size_t r = 0; r <= c->n_runs; r++)
    if (family->run[r] && family->run[r]->n) return false;
  return true;
}

static bool family_shows(const struct comparison *c, const struct cmp_family *family, size_t k) {
  return family->plan.target &&
         !strcmp(c->ref.data.file->experiments[k].target, family->plan.target);
}

static void series_rows(struct cmp_chart *chart, const struct cmp_family *family, size_t id,
                        const char *name, const struct cmp_series *s) {
  for (size_t i = 0; i < s->n; i++) {
    const double error = s->error ? s->error[i] : NAN;
    double row[4];
    size_t n = 0;
    row[n++] = s->value[i];
    if (family->raw) row[n++] = s->raw ? s->raw[i] : NAN;
    if (family->errors) row[n++] = s->value[i] - error;
    if (family->errors) row[n++] = s->value[i] + error;
    cmp_chart_row(chart, id, name, s->t[i], row, n);
  }
}

/* Series of marks come behind those of experiments. */
static size_t cuts_series(const struct comparison *c, size_t r) {
  return c->n_runs + 1 + c->ref.data.n_experiments + r;
}

static void cut_rows(struct cmp_chart *chart, const struct cmp_family *family, size_t r) {
  const struct cmp_data *d = &cmp_run_or_ref(chart->c, r < chart->c->n_runs ? r : SIZE_MAX)->data;
  const struct cmp_series *s = family->run[r];
  for (size_t i = 1; i < s->n; i++) {
    const double row[] = {s->value[i], NAN, NAN};
    if (cmp_cut_shows(d, i))
      cmp_chart_row(chart, cuts_series(chart->c, r), "cut", s->t[i], row, family->errors ? 3 : 1);
  }
}

static void family_rows(struct cmp_chart *chart, const struct cmp_family *family) {
  const struct comparison *c = chart->c;
  for (size_t r = 0; r <= c->n_runs; r++)
    if (family->run[r])
      series_rows(chart, family, r, cmp_run_or_ref(c, r < c->n_runs ? r : SIZE_MAX)->data.label,
                  family->run[r]);
  for (size_t k = 0; k < c->ref.data.n_experiments; k++)
    if (family_shows(c, family, k))
      series_rows(chart, family, c->n_runs + 1 + k, c->ref.data.experiments[k].name,
                  &c->ref.data.experiments[k]);
  for (size_t r = 0; family->cuts && r <= c->n_runs; r++)
    if (family->run[r]) cut_rows(chart, family, r);
}

/* ---- the range of the axis ---- */

static const struct cmp_series *family_member(const struct comparison *c,
                                              const struct cmp_family *family, size_t k) {
  if (k <= c->n_runs) return family->run[k];
  k -= c->n_runs + 1;
  return family_shows(c, family, k) ? &c->ref.data.experiments[k] : NULL;
}

/* What the key says of a series: a few peaks have their mark, and no word. */
static const char *family_note(const struct comparison *c, const struct cmp_family *family,
                               size_t k) {
  const struct cmp_series *s = family_member(c, family, k);
  if (!s || !s->n) return " (has none)";
  struct cmp_beyond b = cmp_frame_beyond(&family->frame, s, family->plan.end);
  if (b.n && b.outside == b.n) return " (beyond the frame)";
  return 50 * b.outside > b.n ? " (partly beyond the frame)" : NULL;
}

/* In a column of panels, curves far from the others have their own, where the mark says how far. */
static enum status family_frame(const struct comparison *c, struct cmp_family *family) {
  struct cmp_chart_plan *plan = &family->plan;
  plan->end = cmp_chart_time_end(c, plan);
  size_t n = c->n_runs + 1 + c->ref.data.n_experiments;
  const struct cmp_series **all = calloc(n, sizeof(struct cmp_series *));
  CHECK(all, ERR_MEMORY, "no memory for a chart");
  for (size_t k = 0; k < n; k++) all[k] = family_member(c, family, k);
  family->frame = cmp_frame_choose(n, all, plan->end, plan->panels > 1 ? 2.5 : 8);
  free(all);
  for (size_t k = 0; k < n; k++) {
    const char *note = family_note(c, family, k);
    if (note && strlen(note) > plan->note) plan->note = strlen(note);
  }
  return OK;
}

/* Of the series that a panel shows, before its curves. */
static void beyond_mark(struct cmp_chart *chart, const struct cmp_family *family, size_t k,
                        const char *colour) {
  const struct cmp_series *s = family_member(chart->c, family, k);
  if (!s || !s->n) return;
  struct cmp_beyond beyond = cmp_frame_beyond(&family->frame, s, chart->end);
  cmp_chart_mark(chart, &beyond, colour);
}

/* ---- drawing a family ---- */

/* What columns the table has besides, and what the caption says of it. */
static enum status family_begin(const struct comparison *c, struct cmp_figures *f,
                                const char *caption, struct cmp_family *family,
                                struct cmp_chart *chart) {
  char columns[256];
  for (size_t r = 0; r <= c->n_runs; r++) {
    family->raw |= family->run[r] && family->run[r]->raw;
    family->errors |= family->run[r] && family->run[r]->error;
  }
  snprintf(columns, sizeof columns, "%s%s", family->plan.columns,
           family->errors ? ",less a standard error,and more by one" : "");
  family->plan.columns = columns;
  TRY(family_frame(c, family));
  const enum status status = cmp_chart_begin(c, f, &family->plan, chart);
  family->plan.columns = NULL;
  TRY(status);
  snprintf(chart->fig->caption, sizeof chart->fig->caption, "%s%s", caption,
           family->errors ? " Bands: the standard error that a run states of itself." : "");
  return OK;
}

static const char *experiment_colour(size_t shown) {
  return shown % 2 ? "#a08050" : "#707070";
}

static void experiments_mark(struct cmp_chart *chart, const struct cmp_family *family) {
  const struct comparison *c = chart->c;
  for (size_t k = 0, shown = 0; k < c->ref.data.n_experiments; k++)
    if (family_shows(c, family, k))
      beyond_mark(chart, family, c->n_runs + 1 + k, experiment_colour(shown++));
}

static void experiments_draw(struct cmp_chart *chart, const struct cmp_family *family, bool named) {
  static const int symbols[] = {4, 6, 8, 12, 2};
  const struct comparison *c = chart->c;
  size_t shown = 0;
  for (size_t k = 0; k < c->ref.data.n_experiments; k++) {
    if (!family_shows(c, family, k)) continue;
    cmp_chart_curve(
        chart, &(struct cmp_curve){.series = c->n_runs + 1 + k,
                                   .name = named ? c->ref.data.experiments[k].name : NULL,
                                   .note = family_note(c, family, c->n_runs + 1 + k),
                                   .style = {experiment_colour(shown), 0},
                                   .symbol = symbols[shown % 5],
                                   .every = c->ref.data.experiments[k].n / 80 + 1}); /* no smear */
    shown++;
  }
}

/* The reference is wider and below: a run that lies on it is seen. */
static void run_draw(struct cmp_chart *chart, const struct cmp_family *family, size_t r,
                     bool named) {
  if (!family->run[r] || !family->run[r]->n) return;
  bool reference = r == chart->c->n_runs;
  size_t id = reference ? SIZE_MAX : r;
  if (family->run[r]->error)
    cmp_chart_band(chart, r, family->raw ? 2 : 1, cmp_run_style(chart->c, id).colour);
  cmp_chart_curve(chart, &(struct cmp_curve){
                             .series = r,
                             .name = named ? cmp_run_or_ref(chart->c, id)->data.label : NULL,
                             .note = family_note(chart->c, family, r),
                             .style = cmp_run_style(chart->c, id),
                             .width = reference ? 2 : 1,
                         });
}

static void cuts_draw(struct cmp_chart *chart, const struct cmp_family *family, size_t r) {
  const struct comparison *c = chart->c;
  if (!family->cuts || !family->run[r] || !family->run[r]->n) return;
  cmp_chart_curve(chart,
                  &(struct cmp_curve){.series = cuts_series(c, r),
                                      .style = cmp_run_style(c, r < c->n_runs ? r : SIZE_MAX),
                                      .symbol = 2});
}

/* What a mean was taken of, thin and below every mean. */
static void raw_draw(struct cmp_chart *chart, const struct cmp_family *family, size_t r) {
  if (!family->run[r] || !family->run[r]->n || !family->run[r]->raw) return;
  struct cmp_style style = cmp_run_style(chart->c, r < chart->c->n_runs ? r : SIZE_MAX);
  style.dashes = 0;
  cmp_chart_curve(chart,
                  &(struct cmp_curve){.series = r, .column = 1, .style = style, .width = 0.35});
}

static void runs_draw(struct cmp_chart *chart, const struct cmp_family *family) {
  const struct comparison *c = chart->c;
  cmp_chart_others(chart, 0, true);
  run_draw(chart, family, c->n_runs, true);
  for (size_t r = 0; r < c->n_runs; r++)
    if (cmp_run_is_picked(c, r, CMP_NAMED)) run_draw(chart, family, r, true);
  for (size_t r = 0; r <= c->n_runs; r++)
    if (r == c->n_runs || cmp_run_is_picked(c, r, CMP_NAMED)) cuts_draw(chart, family, r);
}

enum status cmp_family_chart(const struct comparison *c, struct cmp_figures *f, const char *caption,
                             struct cmp_family *family) {
  struct cmp_chart chart;
  family->plan.panels = 1;
  family->plan.panel_height = 280;
  TRY(family_begin(c, f, caption, family, &chart));
  if (family->cuts) cmp_cuts_say(c, chart.fig->caption, sizeof chart.fig->caption);
  cmp_family_caption_end(c, chart.fig);
  family_rows(&chart, family);
  cmp_chart_panel(&chart, 0, &family->frame, family->label, NULL);
  experiments_mark(&chart, family);
  for (size_t r = 0; r <= c->n_runs; r++)
    beyond_mark(&chart, family, r, cmp_run_style(c, r < c->n_runs ? r : SIZE_MAX).colour);
  experiments_draw(&chart, family, true);
  runs_draw(&chart, family);
  cmp_chart_panel_end(&chart);
  return cmp_chart_end(&chart);
}

/* The key of a column of panels stands below the last and names every curve of all. */
static void key_draw(struct cmp_chart *chart, const struct cmp_family *family, size_t except) {
  const struct comparison *c = chart->c;
  for (size_t r = 0; r < c->n_runs; r++)
    if (r != except && cmp_run_is_picked(c, r, CMP_PANELS))
      cmp_chart_key_entry(chart, r, family_note(c, family, r));
}

static void run_panel(struct cmp_chart *chart, const struct cmp_family *family, size_t k,
                      size_t r) {
  const struct comparison *c = chart->c;
  bool last = k + 1 == chart->panels, run = r < c->n_runs;
  cmp_chart_panel(chart, k, &family->frame, family->label,
                  chart->panels > 1 ? c->run[r].data.label : NULL);
  experiments_mark(chart, family);
  beyond_mark(chart, family, c->n_runs, cmp_run_style(c, SIZE_MAX).colour);
  if (run) beyond_mark(chart, family, r, cmp_run_style(c, r).colour);
  raw_draw(chart, family, c->n_runs);
  if (run) raw_draw(chart, family, r);
  experiments_draw(chart, family, last);
  run_draw(chart, family, c->n_runs, last);
  if (last) key_draw(chart, family, r);
  if (run && family->run[r] && family->run[r]->n)
    run_draw(chart, family, r, last);
  else if (run && last)
    cmp_chart_key_entry(chart, r, family_note(c, family, r));
  cmp_chart_panel_end(chart);
}

enum status cmp_family_panels(const struct comparison *c, struct cmp_figures *f,
                              const char *caption, struct cmp_family *family) {
  struct cmp_chart chart;
  char left_out[160], whole[640];
  const size_t picked = cmp_runs_picked(c, CMP_PANELS), panels = picked ? picked : 1;
  family->plan.panels = panels;
  family->plan.panel_height = panels == 1 ? 280 : 175;
  cmp_picked_say(c, CMP_PANELS, "have no panel", left_out, sizeof left_out);
  snprintf(whole, sizeof whole, "%s%s", caption, left_out);
  TRY(family_begin(c, f, whole, family, &chart));
  family_rows(&chart, family);
  for (size_t r = 0, k = 0; r < c->n_runs || (k == 0 && r == c->n_runs); r++)
    if (r == c->n_runs || cmp_run_is_picked(c, r, CMP_PANELS)) run_panel(&chart, family, k++, r);
  return cmp_chart_end(&chart);
}

/* The tables that stand in the page without a script. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/chart.h"
#include "compare/page/content.h"
#include "compare/summary.h"

/* The heading cell of a run (SIZE_MAX: the reference): its line and its name. */
static void run_cell(struct markup *m, const struct comparison *c, size_t r) {
  static const char *const dots[] = {"dot", "dot dash", "dot dots", "dot ring"};
  const struct cmp_style style = cmp_run_style(c, r);
  char colour[64];
  snprintf(colour, sizeof colour, "color:%s", r == SIZE_MAX ? "inherit" : style.colour);
  cmp_markup_open(m, "th", "t");
  cmp_markup_open(m, "span", dots[style.dashes]);
  cmp_markup_attribute(m, "style", colour);
  cmp_markup_close(m);
  cmp_markup_text(m, cmp_run_or_ref(c, r)->data.label);
  cmp_markup_close(m);
}

/* A cell with the number, or n/a and why. */
static void value_cell(struct markup *m, const struct cmp_value *v) {
  if (cmp_known(v)) {
    cmp_markup_element(m, "td", NULL, "%.4g", v->value);
    return;
  }
  cmp_markup_open(m, "td", "na");
  cmp_markup_attribute(m, "title", v->why);
  cmp_markup_text(m, "n/a");
  cmp_markup_element(m, "span", "why", "%s", v->why);
  cmp_markup_close(m);
}

/* ---- summary ---- */

/* Columns after the distances; one that no run has a number for is left out. */
static const struct {
  const char *heading;
  size_t measure;
  bool last; /* at the last comparison time */
} columns[] = {{"front / H", CMP_MEASURE_front, false},
               {"touchdown t*", CMP_MEASURE_touchdown_time, false},
               {"probe rms", CMP_MEASURE_probe_rms, false},
               {"rms to experiment", CMP_MEASURE_experiment_probe_rms, false},
               {"energy lost at the last time", CMP_MEASURE_decay, true},
               {"budget until impact", CMP_MEASURE_budget_before_impact, false}};
enum { COLUMNS = sizeof columns / sizeof *columns };

static const struct cmp_row *column_row(const struct cmp_page_content *w, size_t k, size_t r) {
  if (columns[k].last && !w->c->n_times) return NULL;
  return cmp_rows_find(w->rows, columns[k].measure, r,
                       columns[k].last ? w->c->n_times - 1 : SIZE_MAX);
}

static bool column_shown(const struct cmp_page_content *w, size_t k) {
  if (columns[k].measure == CMP_MEASURE_front && !cmp_comparison_has_front(w->c)) return false;
  for (size_t r = 0; r < w->c->n_runs; r++) {
    const struct cmp_row *row = column_row(w, k, r);
    if (row && cmp_known(&row->value)) return true;
  }
  return false;
}

/* Grey below its noise floor (NaN: none). */
static void noisy_cell(struct markup *m, const struct cmp_value *v, double noise) {
  if (cmp_known(v) && v->value < noise)
    cmp_markup_element(m, "td", "below", "%.3g", v->value);
  else
    value_cell(m, v);
}

static void summary_row(struct markup *m, const struct cmp_page_content *w, size_t r) {
  const struct cmp_run *run = &w->c->run[r];
  const double shared = cmp_summary_shared(run);
  cmp_markup_open(m, "tr", NULL);
  run_cell(m, w->c, r);
  cmp_markup_element(m, "td", NULL, "%.4g", run->data.dx);
  if (cmp_known(&run->agreement) || !isfinite(shared))
    value_cell(m, &run->agreement);
  else
    cmp_markup_element(m, "td", NULL, "%.4g (end%s)", shared,
                     isnan(run->blind[0]) ? "" : ", with gaps");
  for (size_t k = 0; k < w->c->n_times; k++) noisy_cell(m, &run->at[k].mean, run->noise);
  for (size_t k = 0; k < COLUMNS; k++) {
    if (!column_shown(w, k)) continue;
    const struct cmp_row *row = column_row(w, k, r);
    noisy_cell(m, &row->value, row->noise);
  }
  cmp_markup_close(m);
}

static enum status summary_head(struct markup *m, const struct cmp_page_content *w) {
  const char **heading = NULL;
  char(*at)[48] = NULL;
  size_t n = 3;
  enum status status = OK;
  ATTEMPT(array_create(&heading, 4 + w->c->n_times + COLUMNS, "headings"));
  ATTEMPT(array_create(&at, w->c->n_times + 1, "headings"));
  heading[0] = "run";
  heading[1] = "dx / H";
  heading[2] = "within one dx until t*";
  for (size_t k = 0; k < w->c->n_times; k++) {
    snprintf(at[k], sizeof *at, "mean distance / H at %.4g", w->c->times[k]);
    heading[n++] = at[k];
  }
  for (size_t k = 0; k < COLUMNS; k++)
    if (column_shown(w, k)) heading[n++] = columns[k].heading;
  heading[n] = NULL;
  cmp_markup_table(m, "summary-table", 1, heading);
done:
  free(heading);
  free(at);
  return status;
}

enum status cmp_page_summary(struct markup *m, const struct cmp_page_content *w) {
  size_t *order;
  TRY(summary_head(m, w));
  TRY(cmp_summary_order(w->c, &order));
  for (size_t k = 0; k < w->c->n_runs; k++) summary_row(m, w, order[k]);
  cmp_markup_table_close(m);
  cmp_markup_element(m, "p", "soft",
                   "All against %s. Distances in H, times in √(H/g), pressures in ρgH (the worst "
                   "probe), energies in E0; grey: below the noise floor, of "
                   "distances half a particle spacing, of instants their error bars.",
                   w->c->ref.data.label);
  free(order);
  return OK;
}

/* ---- health ---- */

static void health_row(struct markup *m, const struct comparison *c, size_t r) {
  static const char *const class[] = {"PASS", "doubt", "FAIL"};
  const struct cmp_run *run = cmp_run_or_ref(c, r);
  const struct health *h = &run->health;
  const char *ended = h->broke_off ? "" : run->data.file->ended; /* else the reasons tell */
  const bool told = !strcmp(health_word(h), health_verdicts[h->verdict]);
  cmp_markup_open(m, "tr", NULL);
  run_cell(m, c, r);
  cmp_markup_element(m, "td", told ? class[h->verdict] : NULL, "%s", health_word(h));
  cmp_markup_element(m, "td", "w", "%s%s%s%s%s%s", h->reasons, *h->reasons && *ended ? "; " : "",
                   ended, *h->missing && (*h->reasons || *ended) ? ". " : "",
                   *h->missing ? "Not told: " : "", h->missing);
  cmp_markup_element(m, "td", "w", "%s", h->facts);
  cmp_markup_close(m);
}

enum status cmp_page_health(struct markup *m, const struct cmp_page_content *w) {
  cmp_markup_table(m, "health-table", 1,
                 (const char *const[]){"run", "health", "why", "measured", NULL});
  health_row(m, w->c, SIZE_MAX);
  for (int v = HEALTH_FAILED; v >= HEALTH_SOUND; v--) /* the worst first */
    for (size_t r = 0; r < w->c->n_runs; r++)
      if (w->c->run[r].health.verdict == (enum health_verdict)v) health_row(m, w->c, r);
  cmp_markup_table_close(m);
  return OK;
}

/* ---- checks ---- */

static void verdict_cell(struct markup *m, bool passed) {
  const char *word = passed ? "PASS" : "FAIL";
  cmp_markup_element(m, "td", word, "%s", word);
}

static void check_row(struct markup *m, const struct comparison *c, const struct cmp_row *row) {
  cmp_markup_open(m, "tr", NULL);
  run_cell(m, c, row->run);
  cmp_markup_element(m, "td", "t", "%s", row->measure->name);
  if (row->time == SIZE_MAX)
    cmp_markup_element(m, "td", NULL, "all");
  else
    cmp_markup_element(m, "td", NULL, "%.4g", c->times[row->time]);
  value_cell(m, &row->value);
  cmp_markup_element(m, "td", NULL, "%.4g", row->limit);
  if (isfinite(row->noise))
    cmp_markup_element(m, "td", NULL, "%.3g", row->noise);
  else
    cmp_markup_element(m, "td", NULL, "–");
  cmp_markup_element(m, "td", "t", "%s", row->measure->units);
  cmp_markup_element(m, "td", "t", "%s", row->detail);
  verdict_cell(m, row->outcome == CMP_PASS);
  cmp_markup_close(m);
}

static void event_checks(struct markup *m, const struct cmp_page_content *w) {
  const struct cmp_checks *checks = &w->rows->checks;
  if (!checks->n) return;
  cmp_markup_element(m, "h3", NULL, "Events against published numbers");
  cmp_markup_table(m, "events-table", 1,
                 (const char *const[]){"run", "event", "value", "published", "within", "units",
                                       "verdict", "source", NULL});
  for (size_t i = 0; i < checks->n; i++) {
    const struct cmp_check *check = &checks->check[i];
    cmp_markup_open(m, "tr", NULL);
    run_cell(m, w->c, check->run);
    cmp_markup_element(m, "td", "t", "%s, %s", case_event_names[check->of->event],
                     case_event_parts[check->of->part]);
    if (cmp_known(&check->value)) /* instants are known to more digits than most measures */
      cmp_markup_element(m, "td", NULL, "%.6g", check->value.value);
    else
      value_cell(m, &check->value);
    cmp_markup_element(m, "td", NULL, "%.6g", check->published);
    cmp_markup_element(m, "td", NULL, "%.3g", check->within);
    cmp_markup_element(m, "td", "t", "%s", cmp_check_units(check));
    verdict_cell(m, check->passed);
    cmp_markup_element(m, "td", "w", "%s", check->of->source);
    cmp_markup_close(m);
  }
  cmp_markup_table_close(m);
}

enum status cmp_page_checks(struct markup *m, const struct cmp_page_content *w) {
  const struct cmp_rows *rows = w->rows;
  if (!rows->passed && !rows->failed)
    cmp_markup_element(m, "p", NULL,
                     "The case sets no tolerance for what was compared, so nothing passes or "
                     "fails. Put tolerances under compare.tolerances, for instance {measure: "
                     "mean_distance, max: 0.02}; the measures are listed at the end of this page.");
  if (rows->passed + rows->failed > rows->checks.n) {
    cmp_markup_table(m, "checks-table", 1,
                   (const char *const[]){"run", "measure", "t*", "value", "limit", "noise floor",
                                         "units", "where", "verdict", NULL});
    for (int pass = 0; pass < 2; pass++) /* failures first */
      for (size_t i = 0; i < rows->n; i++)
        if (rows->row[i].outcome == (pass ? CMP_PASS : CMP_FAIL))
          check_row(m, w->c, &rows->row[i]);
    cmp_markup_table_close(m);
  }
  if (rows->unused)
    cmp_markup_element(m, "p", "soft",
                     "Tolerances of the case that concern none of the runs compared here: %zu.",
                     rows->unused);
  event_checks(m, w);
  return OK;
}

#include "compare/html.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "compare/html_sections.h"
#include "compare/output.h"
#include "compare/summary.h"
#include "embed/cmp_page_style.h"

/* Whether there is anything to say on a subject. */
static bool has_always(const struct comparison *c) {
  (void)c;
  return true;
}

static bool has_overlays(const struct comparison *c) {
  for (size_t k = 0; k < c->n_times; k++)
    if (cmp_comparison_has_output(c, k)) return true;
  return false;
}

static bool has_jet(const struct comparison *c) {
  for (size_t r = 0; r <= c->n_runs; r++) {
    const struct cmp_data *d = &cmp_run_or_ref(c, r < c->n_runs ? r : SIZE_MAX)->data;
    if (cmp_known(&d->overturning.time) || cmp_known(&d->touchdown.time)) return true;
  }
  return false;
}

static bool has_front(const struct comparison *c) {
  return cmp_comparison_has_front(c);
}

static bool has_probes(const struct comparison *c) {
  bool any = c->ref.data.n_probes > 0;
  for (size_t r = 0; r < c->n_runs; r++) any = any || c->run[r].data.n_probes > 0;
  return any;
}

static bool has_gauges(const struct comparison *c) {
  bool any = c->ref.data.n_gauges > 0;
  for (size_t r = 0; r < c->n_runs; r++) any = any || c->run[r].data.n_gauges > 0;
  return any;
}

static bool has_spectra(const struct comparison *c) {
  return c->settings->compare.n_spectra > 0;
}

static bool has_diagnostics(const struct comparison *c) {
  bool any = c->ref.data.n_diagnostics > 0;
  for (size_t r = 0; r < c->n_runs; r++) any = any || c->run[r].data.n_diagnostics > 0;
  return any;
}

/* X(name, title, has): the report's sections, in order. */
#define SECTIONS(X)                                                                                \
  X(health, "Health", has_always)                                                                  \
  X(summary, "Summary", has_always)                                                                \
  X(checks, "Checks", has_always)                                                                  \
  X(distance, "Distance against time", has_always)                                                 \
  X(overlays, "Overlays", has_overlays)                                                            \
  X(jet, "Plunging jet", has_jet)                                                                  \
  X(front, "Front", has_front)                                                                     \
  X(energy, "Energy", has_always)                                                                  \
  X(pressure, "Pressure", has_probes)                                                              \
  X(gauges, "Water height", has_gauges)                                                            \
  X(spectra, "Spectra", has_spectra)                                                               \
  X(diagnostics, "Noise, momenta and forces", has_diagnostics)                                     \
  X(runs, "Runs and provenance", has_always)                                                       \
  X(method, "How it is measured", has_always)

static void section(struct page *p, const char *id, const char *title) {
  cmp_page_open(p, "h2", NULL);
  cmp_page_attribute(p, "id", id);
  cmp_page_text(p, "%s", title);
  cmp_page_close(p);
}

static void contents(struct page *p, const struct comparison *c) {
  cmp_page_open(p, "nav", NULL);
  cmp_page_element(p, "b", NULL, "plunge report");
#define X(name, title, has)                                                                        \
  if (has(c)) {                                                                                    \
    cmp_page_open(p, "a", NULL);                                                                   \
    cmp_page_attribute(p, "href", "#" #name);                                                      \
    cmp_page_text(p, "%s", title);                                                                 \
    cmp_page_close(p);                                                                             \
  }
  SECTIONS(X)
#undef X
  cmp_page_close(p);
}

static void head(struct page *p, const char *title) {
  cmp_page_open(p, "html", NULL);
  cmp_page_attribute(p, "lang", "en");
  cmp_page_open(p, "head", NULL);
  cmp_page_raw(p, "<meta charset=\"utf-8\"/>"
                  "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>");
  cmp_page_element(p, "title", NULL, "%s", title);
  cmp_page_open(p, "style", NULL);
  cmp_page_raw(p, cmp_page_style);
  cmp_page_close(p);
  cmp_page_close(p);
}

/* ---- summary ---- */

static void agreement_cell(struct page *p, const struct cmp_run *run,
                           struct cmp_html_reasons *why) {
  double shared = cmp_summary_shared(run);
  if (cmp_known(&run->agreement) || !isfinite(shared))
    cmp_html_value(p, &run->agreement, why);
  else
    cmp_html_cell(p, NULL, isnan(run->blind[0]) ? "%.4g (end)" : "%.4g (end, with gaps)", shared);
}

/* Columns of the summary after the distances; one that no run has a number for is left out. */
static const struct {
  const char *heading;
  size_t measure;
  bool last; /* at the last comparison time */
} columns[] = {{"front / H", CMP_MEASURE_front, false},
               {"touchdown t*", CMP_MEASURE_touchdown_time, false},
               {"probe rms", CMP_MEASURE_probe_rms, false},
               {"rms to experiment", CMP_MEASURE_experiment_probe_rms, false},
               {"energy lost", CMP_MEASURE_decay, true},
               {"budget until impact", CMP_MEASURE_budget_before_impact, false}};
enum { COLUMNS = sizeof columns / sizeof *columns };

static const struct cmp_row *column_row(const struct comparison *c, const struct cmp_rows *rows,
                                        size_t k, size_t r) {
  if (columns[k].last && !c->n_times) return NULL;
  return cmp_rows_find(rows, columns[k].measure, r, columns[k].last ? c->n_times - 1 : SIZE_MAX);
}

static bool column_shown(const struct comparison *c, const struct cmp_rows *rows, size_t k) {
  if (columns[k].measure == CMP_MEASURE_front && !cmp_comparison_has_front(c)) return false;
  for (size_t r = 0; r < c->n_runs; r++) {
    const struct cmp_row *row = column_row(c, rows, k, r);
    if (row && cmp_known(&row->value)) return true;
  }
  return false;
}

static void summary_row(struct page *p, const struct comparison *c, const struct cmp_rows *rows,
                        size_t r, struct cmp_html_reasons *why) {
  const struct cmp_run *run = &c->run[r];
  cmp_page_open(p, "tr", NULL);
  cmp_html_run(p, c, r);
  cmp_html_cell(p, NULL, "%.4g", run->data.dx);
  agreement_cell(p, run, why);
  for (size_t k = 0; k < c->n_times; k++) {
    const struct cmp_value *v = &run->at[k].mean;
    if (cmp_known(v) && v->value < run->noise)
      cmp_html_cell(p, "below", "%.3g", v->value);
    else
      cmp_html_value(p, v, why);
  }
  for (size_t k = 0; k < COLUMNS; k++)
    if (column_shown(c, rows, k)) cmp_html_value(p, &column_row(c, rows, k, r)->value, why);
  cmp_page_close(p);
}

static enum status summary(struct page *p, const struct comparison *c,
                           const struct cmp_rows *rows) {
  struct cmp_html_reasons why = {0};
  size_t *order;
  TRY(cmp_summary_order(c, &order));
  cmp_html_table_open(p);
  cmp_page_open(p, "tr", NULL);
  cmp_page_element(p, "th", "t", "run");
  cmp_page_element(p, "th", NULL, "dx / H");
  cmp_page_element(p, "th", NULL, "within one dx until t*");
  for (size_t k = 0; k < c->n_times; k++)
    cmp_page_element(p, "th", NULL, "mean distance / H at %.4g", c->times[k]);
  for (size_t k = 0; k < COLUMNS; k++) {
    if (!column_shown(c, rows, k)) continue;
    if (columns[k].last)
      cmp_page_element(p, "th", NULL, "energy lost at %.4g", c->times[c->n_times - 1]);
    else
      cmp_page_element(p, "th", NULL, "%s", columns[k].heading);
  }
  cmp_page_close(p);
  for (size_t k = 0; k < c->n_runs; k++) summary_row(p, c, rows, order[k], &why);
  cmp_html_table_close(p);
  cmp_html_reasons_list(p, &why);
  cmp_page_open(p, "p", "soft");
  cmp_page_text(p,
                "All against %s. Distances in H, times in √(H/g), pressures in ρgH (the worst "
                "probe), energies in E0; grey: below the noise floor of half a particle spacing.",
                c->ref.data.label);
  cmp_page_close(p);
  free(order);
  return OK;
}

/* ---- checks ---- */

static void check_row(struct page *p, const struct comparison *c, const struct cmp_row *row,
                      struct cmp_html_reasons *why) {
  cmp_page_open(p, "tr", NULL);
  cmp_html_run(p, c, row->run);
  cmp_html_cell(p, "t", "%s", row->measure->name);
  cmp_html_cell(p, NULL, row->time == SIZE_MAX ? "all" : "%.4g",
                row->time == SIZE_MAX ? 0. : c->times[row->time]);
  cmp_html_value(p, &row->value, why);
  cmp_html_cell(p, NULL, "%.4g", row->limit);
  if (isfinite(row->noise))
    cmp_html_cell(p, NULL, "%.3g", row->noise);
  else
    cmp_html_cell(p, NULL, "–");
  cmp_html_cell(p, "t", "%s", row->measure->units);
  cmp_html_cell(p, "t", "%s", row->detail);
  const char *outcome = row->outcome == CMP_PASS ? "PASS" : "FAIL";
  cmp_html_cell(p, outcome, "%s", outcome);
  cmp_page_close(p);
}

static void event_row(struct page *p, const struct comparison *c, const struct cmp_check *check,
                      struct cmp_html_reasons *why) {
  const char *outcome = check->passed ? "PASS" : "FAIL";
  const struct case_event *e = check->of;
  cmp_page_open(p, "tr", NULL);
  cmp_html_run(p, c, check->run);
  cmp_html_cell(p, "t", "%s, %s", case_event_names[e->event], case_event_parts[e->part]);
  cmp_html_value(p, &check->value, why);
  cmp_html_cell(p, NULL, "%.5g", check->published);
  cmp_html_cell(p, NULL, "%.3g", check->within);
  cmp_html_cell(p, "t", "%s", cmp_check_units(check));
  cmp_html_cell(p, outcome, "%s", outcome);
  cmp_html_cell(p, "w", "%s", e->source);
  cmp_page_close(p);
}

static void event_checks(struct page *p, const struct comparison *c,
                         const struct cmp_checks *checks) {
  struct cmp_html_reasons why = {0};
  if (!checks->n) return;
  cmp_page_element(p, "h3", NULL, "Events against published numbers");
  cmp_html_table_open(p);
  cmp_html_headings(p, (const char *const[]){"run", "event", "value", "published", "within",
                                             "units", "verdict", "source", NULL});
  for (size_t i = 0; i < checks->n; i++) event_row(p, c, &checks->check[i], &why);
  cmp_html_table_close(p);
  cmp_html_reasons_list(p, &why);
}

static void limit_checks(struct page *p, const struct comparison *c, const struct cmp_rows *rows) {
  struct cmp_html_reasons why = {0};
  if (!rows->passed && !rows->failed) {
    cmp_page_element(
        p, "p", NULL,
        "The case sets no tolerance for what was compared, so nothing passes or fails. Put "
        "tolerances under compare.tolerances, for instance {measure: mean_distance, max: "
        "0.02}; the measures are listed at the end of this page.");
    return;
  }
  if (rows->passed + rows->failed == rows->checks.n) return;
  cmp_html_table_open(p);
  cmp_html_headings(p, (const char *const[]){"run", "measure", "t*", "value", "limit",
                                             "noise floor", "units", "where", "verdict", NULL});
  for (int pass = 0; pass < 2; pass++) /* failures first */
    for (size_t i = 0; i < rows->n; i++)
      if (rows->row[i].outcome == (pass ? CMP_PASS : CMP_FAIL))
        check_row(p, c, &rows->row[i], &why);
  cmp_html_table_close(p);
  cmp_html_reasons_list(p, &why);
  if (rows->unused)
    cmp_page_element(p, "p", "soft",
                     "Tolerances of the case that concern none of the runs compared here: %zu.",
                     rows->unused);
}

static void checks(struct page *p, const struct comparison *c, const struct cmp_rows *rows) {
  limit_checks(p, c, rows);
  event_checks(p, c, &rows->checks);
}

/* ---- the page ---- */

struct content { /* what sections are written from */
  const struct comparison *c;
  const struct cmp_rows *rows;
  const struct cmp_figures *figures;
};

static enum status write_health(struct page *p, const struct content *w) {
  cmp_html_health(p, w->c);
  return OK;
}

static enum status write_summary(struct page *p, const struct content *w) {
  return summary(p, w->c, w->rows);
}

static enum status write_checks(struct page *p, const struct content *w) {
  checks(p, w->c, w->rows);
  return OK;
}

static enum status write_distance(struct page *p, const struct content *w) {
  TRY(cmp_html_figures(p, w->figures, CMP_SECTION_DISTANCE));
  cmp_html_measures(p, w->c, w->rows, CMP_SECTION_DISTANCE);
  return OK;
}

static enum status write_overlays(struct page *p, const struct content *w) {
  return cmp_html_figures(p, w->figures, CMP_SECTION_OVERLAY);
}

static enum status write_jet(struct page *p, const struct content *w) {
  cmp_html_jets(p, w->c);
  TRY(cmp_html_figures(p, w->figures, CMP_SECTION_JET));
  cmp_page_element(p, "h3", NULL, "Differences from the reference");
  cmp_html_measures(p, w->c, w->rows, CMP_SECTION_JET);
  return OK;
}

static enum status write_front(struct page *p, const struct content *w) {
  TRY(cmp_html_figures(p, w->figures, CMP_SECTION_FRONT));
  cmp_html_measures(p, w->c, w->rows, CMP_SECTION_FRONT);
  cmp_html_signals(p, w->c, CMP_FRONT);
  return OK;
}

static enum status write_energy(struct page *p, const struct content *w) {
  TRY(cmp_html_figures(p, w->figures, CMP_SECTION_ENERGY));
  cmp_html_measures(p, w->c, w->rows, CMP_SECTION_ENERGY);
  return cmp_html_ledger(p, w->c);
}

static enum status write_pressure(struct page *p, const struct content *w) {
  TRY(cmp_html_figures(p, w->figures, CMP_SECTION_PRESSURE));
  cmp_html_measures(p, w->c, w->rows, CMP_SECTION_PRESSURE);
  cmp_html_signals(p, w->c, CMP_PRESSURE);
  cmp_html_filters(p, w->c);
  return OK;
}

static enum status write_gauges(struct page *p, const struct content *w) {
  TRY(cmp_html_figures(p, w->figures, CMP_SECTION_GAUGE));
  cmp_html_measures(p, w->c, w->rows, CMP_SECTION_GAUGE);
  cmp_html_signals(p, w->c, CMP_ELEVATION);
  return OK;
}

static enum status write_spectra(struct page *p, const struct content *w) {
  TRY(cmp_html_figures(p, w->figures, CMP_SECTION_SPECTRA));
  cmp_html_spectra(p, w->c);
  return OK;
}

static enum status write_diagnostics(struct page *p, const struct content *w) {
  TRY(cmp_html_figures(p, w->figures, CMP_SECTION_DIAGNOSTICS));
  cmp_html_diagnostics(p, w->c);
  return OK;
}

static enum status write_runs(struct page *p, const struct content *w) {
  cmp_html_provenance(p, w->c);
  return OK;
}

static enum status write_method(struct page *p, const struct content *w) {
  cmp_html_method(p, w->c);
  return OK;
}

static enum status body(struct page *p, const struct content *w) {
#define X(name, title, has)                                                                        \
  if (has(w->c)) {                                                                                 \
    section(p, #name, title);                                                                      \
    TRY(write_##name(p, w));                                                                       \
  }
  SECTIONS(X)
#undef X
  return OK;
}

static void figures_missing(struct page *p, const struct cmp_figures *figures) {
  size_t missing = cmp_figures_missing(figures);
  if (!missing) return;
  if (missing == figures->n)
    cmp_page_element(p, "p", "lead fail", "There are no figures: %s.", figures->figure[0].missing);
  else
    cmp_page_element(p, "p", "lead fail",
                     "%zu of %zu figures are missing; each says why in its place.", missing,
                     figures->n);
}

/* Whether the health of anybody has failed. */
static bool any_failed(const struct comparison *c) {
  bool any = c->ref.health.verdict == HEALTH_FAILED;
  for (size_t r = 0; r < c->n_runs; r++) any = any || c->run[r].health.verdict == HEALTH_FAILED;
  return any;
}

static enum status page_write(struct page *p, const struct comparison *c,
                              const struct cmp_rows *rows, const struct cmp_figures *figures,
                              const char *sentence) {
  const char *title = c->ref.data.file->title;
  head(p, title && *title ? title : "plunge report");
  cmp_page_open(p, "body", NULL);
  contents(p, c);
  cmp_page_open(p, "main", NULL);
  cmp_page_element(p, "h1", NULL, "%s", title && *title ? title : "plunge report");
  cmp_page_element(p, "p",
                   rows->failed || any_failed(c) ? "lead fail"
                   : rows->passed                ? "lead pass"
                                                 : "lead",
                   "%s", sentence);
  figures_missing(p, figures);
  TRY(body(p, &(struct content){c, rows, figures}));
  cmp_page_close(p);
  cmp_page_close(p);
  cmp_page_close(p);
  return OK;
}

enum status cmp_html_write(const struct comparison *c, const struct cmp_rows *rows,
                           const struct cmp_figures *figures, const char *sentence,
                           const char *path) {
  enum status status = OK;
  struct cmp_output out = {0};
  struct page *p = NULL;
  ATTEMPT(cmp_output_open(path, &out));
  p = cmp_page_create(out.stream);
  if (!p) {
    status = status_raise(ERR_MEMORY, "no memory for %s", path);
    goto done;
  }
  ATTEMPT(page_write(p, c, rows, figures, sentence));
  if (!cmp_page_finish(p)) {
    status = status_raise(ERR_IO, "cannot write %s; is the disk full?", path);
    goto done;
  }
  cmp_page_destroy(p);
  p = NULL;
  ATTEMPT(cmp_output_commit(&out));
done:
  cmp_page_destroy(p);
  cmp_output_abandon(&out);
  return status;
}

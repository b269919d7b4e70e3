#include <stdint.h>
#include <string.h>

#include "compare/html_sections.h"

/* ---- against others ---- */

/* "mine (theirs)" */
static void both_cell(struct page *p, const struct cmp_value *mine, const struct cmp_value *theirs,
                      struct cmp_html_reasons *why) {
  if (cmp_known(mine) && cmp_known(theirs))
    cmp_html_cell(p, NULL, "%.3g (%.3g)", mine->value, theirs->value);
  else
    cmp_html_value(p, cmp_known(mine) ? theirs : mine, why);
}

/* "P1 (mean over 0.05) against bem" */
static void pair_cell(struct page *p, const struct comparison *c, const struct cmp_pair *pair) {
  char mean[32] = "";
  if (pair->a->average > 0) snprintf(mean, sizeof mean, " (mean over %.3g)", pair->a->average);
  cmp_html_cell(p, "t", "%s%s against %s", pair->a->name, mean,
                pair->experiment == SIZE_MAX ? c->ref.data.label : pair->b->name);
}

void cmp_html_signals(struct page *p, const struct comparison *c, enum cmp_quantity quantity) {
  struct cmp_html_reasons why = {0};
  size_t shown = 0;
  for (size_t i = 0; i <= c->n_runs; i++) {
    const struct cmp_run *run = cmp_run_or_ref(c, i == 0 ? SIZE_MAX : i - 1);
    for (size_t k = 0; k < run->n_pairs; k++) shown += run->pairs[k].quantity == quantity;
  }
  if (!shown) return;
  cmp_html_table_open(p);
  cmp_html_headings(p, (const char *const[]){"run", "signal", "common t*", "arrival t*", "peak",
                                             "time of peak", "impulse", "rms difference",
                                             "best shift → rms then", NULL});
  for (size_t i = 0; i <= c->n_runs; i++) {
    size_t r = i == 0 ? SIZE_MAX : i - 1;
    const struct cmp_run *run = cmp_run_or_ref(c, r);
    for (size_t k = 0; k < run->n_pairs; k++) {
      const struct cmp_pair *pair = &run->pairs[k];
      if (pair->quantity != quantity) continue;
      const struct cmp_signal_alone *a = &pair->m.a, *b = &pair->m.b;
      cmp_page_open(p, "tr", NULL);
      cmp_html_run(p, c, r);
      pair_cell(p, c, pair);
      cmp_html_cell(p, NULL, "%.3g–%.3g", pair->m.from, pair->m.to);
      both_cell(p, &a->onset, &b->onset, &why);
      both_cell(p, &a->peak, &b->peak, &why);
      both_cell(p, &a->peak_time, &b->peak_time, &why);
      both_cell(p, &a->impulse, &b->impulse, &why);
      cmp_html_value(p, &pair->m.rms, &why);
      if (cmp_known(&pair->m.shift))
        cmp_html_cell(p, NULL, "%.3g → %.3g", pair->m.shift.value, pair->m.rms_after.value);
      else
        cmp_html_value(p, &pair->m.shift, &why);
      cmp_page_close(p);
    }
  }
  cmp_html_table_close(p);
  cmp_page_element(p, "p", "soft",
                   "In brackets: the same of what it is compared with, over the same common time. "
                   "Best shift: positive when the run is late; it is not applied.");
  cmp_html_reasons_list(p, &why);
}

/* ---- filters ---- */

/* "raw → filtered" */
static void change_cell(struct page *p, const struct cmp_value *raw,
                        const struct cmp_value *filtered, struct cmp_html_reasons *why) {
  if (cmp_known(raw) && cmp_known(filtered))
    cmp_html_cell(p, NULL, "%.3g → %.3g", raw->value, filtered->value);
  else
    cmp_html_value(p, cmp_known(raw) ? filtered : raw, why);
}

static void filter_row(struct page *p, const struct comparison *c, size_t r, size_t k,
                       struct cmp_html_reasons *why) {
  const struct cmp_filtered *f = &cmp_run_or_ref(c, r)->filtered[k];
  char what[96];
  cmp_filter_say(f->filter, c->scales.T, c->scales.H, what, sizeof what);
  cmp_page_open(p, "tr", NULL);
  cmp_html_run(p, c, r);
  cmp_html_cell(p, "t", "%s: %s", f->probe, what);
  if (f->filter->kind == CASE_FILTER_impulse) {
    cmp_html_value(p, &f->before.peak, why);
    cmp_html_value(p, &f->before.peak_time, why);
    cmp_html_value(p, &f->before.impulse, why);
  } else {
    change_cell(p, &f->before.peak, &f->after.peak, why);
    change_cell(p, &f->before.peak_time, &f->after.peak_time, why);
    change_cell(p, &f->before.impulse, &f->after.impulse, why);
  }
  cmp_html_value(p, &f->taken, why);
  cmp_page_close(p);
}

void cmp_html_filters(struct page *p, const struct comparison *c) {
  struct cmp_html_reasons why = {0};
  if (!c->settings->compare.n_filters) return;
  cmp_page_element(p, "h3", NULL, "Filters, raw → filtered");
  cmp_html_table_open(p);
  cmp_html_headings(p,
                    (const char *const[]){"run", "filter", "peak / (ρgH)", "time of peak",
                                          "impulse / (ρgH√(H/g))", "rms taken out / (ρgH)", NULL});
  for (size_t k = 0; k < c->settings->compare.n_filters; k++)
    for (size_t i = 0; i <= c->n_runs; i++) filter_row(p, c, i ? i - 1 : SIZE_MAX, k, &why);
  cmp_html_table_close(p);
  cmp_page_element(p, "p", "soft",
                   "Over the whole of each signal. No number of any comparison is taken of a "
                   "filtered signal, and none of it is in the files.");
  cmp_html_reasons_list(p, &why);
}

/* ---- spectra ---- */

static void spectrum_row(struct page *p, const struct comparison *c, size_t r, size_t k,
                         size_t most, struct cmp_html_reasons *why) {
  const struct cmp_spectrum *s = &cmp_run_or_ref(c, r)->spectrum[k];
  cmp_page_open(p, "tr", NULL);
  cmp_html_run(p, c, r);
  if (!s->n) {
    cmp_html_value(p, &s->interval, why);
    for (size_t i = 0; i < 3 + most; i++) cmp_html_cell(p, NULL, " ");
  } else {
    cmp_html_cell(p, NULL, "%.4g–%.4g", s->from, s->to);
    cmp_html_cell(p, NULL, "%zu%s", s->samples, s->resampled ? " ≈" : "");
    cmp_html_cell(p, NULL, "%.3g", s->step);
    cmp_html_cell(p, NULL, "%.3g", sqrt(s->mean_square));
    for (size_t i = 0; i < most; i++)
      if (i < s->n_peaks)
        cmp_html_cell(p, NULL, "%.4g (%.3g)", s->peak[i].frequency, s->peak[i].amplitude);
      else
        cmp_html_cell(p, NULL, "–");
  }
  cmp_page_close(p);
}

static void spectrum_table(struct page *p, const struct comparison *c, size_t k,
                           struct cmp_html_reasons *why) {
  const struct case_spectrum *asked = &c->settings->compare.spectra[k];
  cmp_page_element(p, "h3", NULL, "Peaks of %s", asked->series);
  cmp_html_table_open(p);
  cmp_page_open(p, "tr", NULL);
  cmp_page_element(p, "th", "t", "run");
  cmp_page_element(p, "th", NULL, "t*");
  cmp_page_element(p, "th", NULL, "samples");
  cmp_page_element(p, "th", NULL, "bin");
  cmp_page_element(p, "th", NULL, "rms");
  for (size_t i = 0; i < asked->peaks; i++)
    cmp_page_element(p, "th", NULL, i ? "%zu." : "%zu. peak (amplitude)", i + 1);
  cmp_page_close(p);
  for (size_t i = 0; i <= c->n_runs; i++)
    spectrum_row(p, c, i ? i - 1 : SIZE_MAX, k, asked->peaks, why);
  cmp_html_table_close(p);
}

void cmp_html_spectra(struct page *p, const struct comparison *c) {
  struct cmp_html_reasons why = {0};
  for (size_t k = 0; k < c->settings->compare.n_spectra; k++) spectrum_table(p, c, k, &why);
  cmp_html_reasons_list(p, &why);
  cmp_page_element(
      p, "p", "soft",
      "Frequencies (waves in a time, not radians) and bins in √(g/H); amplitudes and rms in the "
      "series' unit. ≈: rows that are uneven in time, put on as many even instants by the cubic "
      "through the four rows around each.");
}

/* ---- diagnostics ---- */

/* Whether the reference or a run before r has one of that name. */
static bool is_known(const struct comparison *c, size_t before, const char *name) {
  for (size_t i = 0; i < before; i++) {
    const struct result_file *f = cmp_run_or_ref(c, i ? i - 1 : SIZE_MAX)->data.file;
    for (size_t k = 0; k < f->n_diagnostics; k++)
      if (!strcmp(f->diagnostics[k].name, name)) return true;
  }
  return false;
}

/* A row of a diagnostic: the median in each run that has any. */
static void median_row(struct page *p, const struct comparison *c, const struct result_series *s,
                       struct cmp_html_reasons *why) {
  const double from = cmp_comparison_settled(c);
  cmp_page_open(p, "tr", NULL);
  cmp_page_open(p, "th", "t");
  cmp_page_attribute(p, "title", s->help);
  cmp_page_text(p, "%s", s->name);
  cmp_page_close(p);
  for (size_t i = 0; i <= c->n_runs; i++) {
    const struct cmp_data *d = &cmp_run_or_ref(c, i ? i - 1 : SIZE_MAX)->data;
    if (!d->n_diagnostics || (i && !cmp_run_is_picked(c, i - 1, CMP_NAMED))) continue;
    const struct cmp_series *own = cmp_series_find(d->diagnostics, d->n_diagnostics, s->name);
    struct cmp_value median = cmp_unknown("the run has no series of that name");
    if (own) {
      const struct cmp_signal signal = cmp_series_signal(own);
      median = cmp_signal_median(&signal, from);
    }
    cmp_html_value(p, &median, why);
  }
  cmp_html_cell(p, "t", "%s", s->help);
  cmp_page_close(p);
}

void cmp_html_diagnostics(struct page *p, const struct comparison *c) {
  struct cmp_html_reasons why = {0};
  cmp_page_element(p, "h3", NULL, "Medians from t* = %.4g on", cmp_comparison_settled(c));
  cmp_html_table_open(p);
  cmp_page_open(p, "tr", NULL);
  cmp_page_element(p, "th", "t", "number");
  for (size_t i = 0; i <= c->n_runs; i++) {
    const size_t r = i ? i - 1 : SIZE_MAX;
    if (cmp_run_or_ref(c, r)->data.n_diagnostics && (!i || cmp_run_is_picked(c, r, CMP_NAMED)))
      cmp_html_run(p, c, r);
  }
  cmp_page_element(p, "th", "t", "what it is");
  cmp_page_close(p);
  for (size_t i = 0; i <= c->n_runs; i++) {
    const struct result_file *f = cmp_run_or_ref(c, i ? i - 1 : SIZE_MAX)->data.file;
    for (size_t k = 0; k < f->n_diagnostics; k++)
      if (!is_known(c, i, f->diagnostics[k].name)) median_row(p, c, &f->diagnostics[k], &why);
  }
  cmp_html_table_close(p);
  cmp_page_element(
      p, "p", "soft",
      "From the reference's wall impact on, where it has one. In the units of the "
      "figures: momenta in ρH²√(gH), angular momenta in ρH³√(gH), numbers as they are.");
  cmp_html_reasons_list(p, &why);
}

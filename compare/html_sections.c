#include "compare/html_sections.h"

#include <stdint.h>
#include <string.h>

#include "compare/absent.h"
#include "compare/ledger.h"
#include "compare/outline.h"
#include "revision.h"

/* ---- measures ---- */

static void measure_cells(struct page *p, const struct comparison *c, const struct cmp_rows *rows,
                          size_t m, size_t time, struct cmp_html_reasons *why) {
  for (size_t r = 0; r < c->n_runs; r++) {
    const struct cmp_row *row = cmp_rows_find(rows, m, r, time);
    if (!row || !cmp_run_is_picked(c, r, CMP_NAMED)) continue;
    if (cmp_known(&row->value) && row->value.value < row->noise)
      cmp_html_cell(p, "below", "%.4g", row->value.value);
    else
      cmp_html_value(p, &row->value, why);
  }
}

static void measure_rows(struct page *p, const struct comparison *c, const struct cmp_rows *rows,
                         size_t m, struct cmp_html_reasons *why) {
  bool whole = cmp_rows_find(rows, m, 0, SIZE_MAX) != NULL;
  size_t n = whole ? 1 : c->n_times;
  for (size_t i = 0; i < n; i++) {
    cmp_page_open(p, "tr", NULL);
    if (i == 0) {
      char span[24];
      cmp_page_open(p, "th", "t");
      snprintf(span, sizeof span, "%zu", n);
      cmp_page_attribute(p, "rowspan", span);
      cmp_page_attribute(p, "title", cmp_measures[m].help);
      cmp_page_text(p, "%s [%s]", cmp_measures[m].name, cmp_measures[m].units);
      cmp_page_close(p);
    }
    cmp_html_cell(p, NULL, whole ? "all" : "%.4g", whole ? 0. : c->times[i]);
    measure_cells(p, c, rows, m, whole ? SIZE_MAX : i, why);
    cmp_page_close(p);
  }
}

void cmp_html_measures(struct page *p, const struct comparison *c, const struct cmp_rows *rows,
                       enum cmp_section section) {
  struct cmp_html_reasons why = {0};
  char left_out[160];
  size_t first = 0;
  while (first < CMP_N_MEASURES && cmp_measure_sections[first] != section) first++;
  if (first == CMP_N_MEASURES) return;
  cmp_html_table_open(p);
  cmp_page_open(p, "tr", NULL);
  cmp_page_element(p, "th", "t", "measure");
  cmp_page_element(p, "th", NULL, "t*");
  for (size_t r = 0; r < c->n_runs; r++)
    if (cmp_run_is_picked(c, r, CMP_NAMED)) cmp_html_run(p, c, r);
  cmp_page_close(p);
  for (size_t m = first; m < CMP_N_MEASURES; m++)
    if (cmp_measure_sections[m] == section) measure_rows(p, c, rows, m, &why);
  cmp_html_table_close(p);
  cmp_html_reasons_list(p, &why);
  cmp_picked_say(c, CMP_NAMED, "are in report.json", left_out, sizeof left_out);
  if (*left_out) cmp_page_element(p, "p", "soft", "%s", left_out);
}

/* ---- the budget of energy ---- */

/* The value of a row of the ledger, for one run; `name` is that of a term, else NULL. */
typedef struct cmp_value ledger_value(const struct cmp_data *d, const char *name, double t);

static struct cmp_value lost_value(const struct cmp_data *d, const char *name, double t) {
  (void)name;
  return cmp_ledger_lost(d, t);
}

static struct cmp_value elastic_value(const struct cmp_data *d, const char *name, double t) {
  (void)name;
  return cmp_ledger_elastic(d, t);
}

static struct cmp_value rest_value(const struct cmp_data *d, const char *name, double t) {
  (void)name;
  return cmp_ledger_rest(d, t);
}

static void ledger_row(struct page *p, const struct comparison *c,
                       const struct cmp_ledger_term *row, ledger_value *value,
                       struct cmp_html_reasons *why) {
  cmp_page_open(p, "tr", NULL);
  cmp_page_open(p, "th", "t");
  cmp_page_attribute(p, "title", row->help);
  cmp_page_text(p, "%s", row->name);
  cmp_page_close(p);
  for (size_t i = 0; i <= c->n_runs; i++) {
    size_t r = i == 0 ? SIZE_MAX : i - 1;
    if (i && !cmp_run_is_picked(c, r, CMP_NAMED)) continue;
    struct cmp_value v = value(&cmp_run_or_ref(c, r)->data, row->name, c->times[c->n_times - 1]);
    cmp_html_value(p, &v, why);
  }
  cmp_page_close(p);
}

enum status cmp_html_ledger(struct page *p, const struct comparison *c) {
  struct cmp_html_reasons why = {0};
  struct cmp_ledger ledger;
  if (!c->n_times) return OK;
  TRY(cmp_ledger_create(c, &ledger));
  cmp_page_element(p, "h3", NULL, "Where the energy went until t* = %.4g, in E0",
                   c->times[c->n_times - 1]);
  cmp_html_table_open(p);
  cmp_page_open(p, "tr", NULL);
  cmp_page_element(p, "th", "t", "term");
  for (size_t i = 0; i <= c->n_runs; i++)
    if (i == 0 || cmp_run_is_picked(c, i - 1, CMP_NAMED))
      cmp_html_run(p, c, i == 0 ? SIZE_MAX : i - 1);
  cmp_page_close(p);
  ledger_row(p, c, &(struct cmp_ledger_term){"mechanical energy lost", "kinetic + potential"},
             lost_value, &why);
  ledger_row(p, c,
             &(struct cmp_ledger_term){"of that: elastic", "gained by the compressible fluid"},
             elastic_value, &why);
  for (size_t k = 0; k < ledger.n; k++) ledger_row(p, c, &ledger.term[k], cmp_ledger_term, &why);
  ledger_row(p, c,
             &(struct cmp_ledger_term){"unaccounted",
                                       "lost less the rows above: the error of the time steps"},
             rest_value, &why);
  cmp_html_table_close(p);
  cmp_html_reasons_list(p, &why);
  cmp_ledger_destroy(&ledger);
  return OK;
}

/* ---- the jet ---- */

static void jet_cells(struct page *p, const struct cmp_jet *jet, struct cmp_html_reasons *why) {
  cmp_html_cell(p, NULL, "%.4f", jet->tip[0]);
  cmp_html_cell(p, NULL, "%.4f", jet->tip[1]);
  cmp_html_value(p, &jet->direction, why);
  for (size_t k = 0; k < CMP_JET_STATIONS; k++) cmp_html_value(p, &jet->thickness[k], why);
  cmp_html_value(p, &jet->cavity, why);
}

static const struct cmp_jet *jet_of(const struct comparison *c, size_t time, size_t r) {
  for (size_t q = r == SIZE_MAX ? 0 : r; q < c->n_runs; q++) {
    const struct cmp_at *at = &c->run[q].at[time];
    const struct cmp_data *d = r == SIZE_MAX ? &c->ref.data : &c->run[q].data;
    size_t output = r == SIZE_MAX ? at->ref_output : at->output;
    if (output != SIZE_MAX && d->jet[output].found) return &d->jet[output];
    if (r != SIZE_MAX) break;
  }
  return NULL;
}

static void jets_table(struct page *p, const struct comparison *c) {
  struct cmp_html_reasons why = {0};
  bool any = false;
  for (size_t k = 0; k < c->n_times; k++)
    for (size_t r = 0; r <= c->n_runs; r++)
      any = any || jet_of(c, k, r < c->n_runs ? r : SIZE_MAX) != NULL;
  if (!any) {
    cmp_page_element(p, "p", NULL,
                     "No surface overhangs by more than %.3g H at the comparison times.",
                     CMP_JET_LEAST * c->depth);
    return;
  }
  cmp_html_table_open(p);
  cmp_html_headings(p, (const char *const[]){"run", "t*", "tip x/H", "tip y/H", "direction [deg]",
                                             "thickness at 0.05 H", "at 0.1 H", "at 0.2 H",
                                             "cavity / H²", NULL});
  for (size_t k = 0; k < c->n_times; k++)
    for (size_t i = 0; i <= c->n_runs; i++) {
      size_t r = i == 0 ? SIZE_MAX : i - 1;
      const struct cmp_jet *jet = jet_of(c, k, r);
      if (!jet) continue;
      cmp_page_open(p, "tr", NULL);
      cmp_html_run(p, c, r);
      cmp_html_cell(p, NULL, "%.4g", c->times[k]);
      jet_cells(p, jet, &why);
      cmp_page_close(p);
    }
  cmp_html_table_close(p);
  cmp_html_reasons_list(p, &why);
}

static void instant_cells(struct page *p, const struct cmp_instant *i,
                          struct cmp_html_reasons *why) {
  if (!cmp_known(&i->time)) {
    cmp_html_value(p, &i->time, why);
    cmp_html_cell(p, NULL, " ");
    return;
  }
  if (i->error > 0 && i->located)
    cmp_html_cell(p, NULL, "%.5f ± %.1g", i->time.value, i->error);
  else if (i->error > 0)
    cmp_html_cell(p, NULL, "%.3f ± %.2g", i->time.value, i->error);
  else
    cmp_html_cell(p, NULL, "%.4f", i->time.value);
  if (isfinite(i->at[0]))
    cmp_html_cell(p, NULL, "(%.3f, %.3f)", i->at[0], i->at[1]);
  else
    cmp_html_cell(p, NULL, " ");
}

void cmp_html_jets(struct page *p, const struct comparison *c) {
  struct cmp_html_reasons why = {0};
  cmp_page_element(p, "h3", NULL, "Instants");
  cmp_html_table_open(p);
  cmp_html_headings(p,
                    (const char *const[]){"run", "wall impact t*", "at (x, y)/H", "overturning t*",
                                          "at (x, y)/H", "touchdown t*", "at (x, y)/H", NULL});
  for (size_t i = 0; i <= c->n_runs; i++) {
    size_t r = i == 0 ? SIZE_MAX : i - 1;
    const struct cmp_data *d = &cmp_run_or_ref(c, r)->data;
    cmp_page_open(p, "tr", NULL);
    cmp_html_run(p, c, r);
    instant_cells(p, &d->impact, &why);
    instant_cells(p, &d->overturning, &why);
    instant_cells(p, &d->touchdown, &why);
    cmp_page_close(p);
  }
  cmp_html_table_close(p);
  cmp_html_reasons_list(p, &why);
  cmp_page_element(
      p, "p", "soft",
      "A time with three decimals and ± was read off the sequence of surfaces; ± holds the "
      "interval "
      "between outputs and how far the instant moves when the surface does by half a particle "
      "spacing: a face that stands near the vertical for long has no sharp instant. One with more "
      "decimals was located by the solver; ± is then the standard error that its run states.");
  cmp_page_element(p, "h3", NULL, "Shape");
  jets_table(p, c);
}

/* ---- health ---- */

static void health_row(struct page *p, const struct comparison *c, size_t r) {
  static const char *const class[] = {"PASS", "doubt", "FAIL"};
  const struct cmp_run *run = cmp_run_or_ref(c, r);
  const struct health *h = &run->health;
  const struct result_file *f = run->data.file;
  cmp_page_open(p, "tr", NULL);
  cmp_html_run(p, c, r);
  const bool told = !strcmp(health_word(h), health_verdicts[h->verdict]);
  cmp_html_cell(p, told ? class[h->verdict] : NULL, "%s", health_word(h));
  bool ended = *f->ended && !h->broke_off; /* else the reasons tell */
  cmp_html_cell(p, "w", "%s%s%s%s%s%s", h->reasons, *h->reasons && ended ? "; " : "",
                ended ? f->ended : "", *h->missing && (*h->reasons || ended) ? ". " : "",
                *h->missing ? "Not told: " : "", h->missing);
  cmp_html_cell(p, "w", "%s", h->facts);
  cmp_page_close(p);
}

void cmp_html_health(struct page *p, const struct comparison *c) {
  cmp_html_table_open(p);
  cmp_html_headings(p, (const char *const[]){"run", "health", "why", "measured", NULL});
  health_row(p, c, SIZE_MAX);
  for (int v = HEALTH_FAILED; v >= HEALTH_SOUND; v--) /* the worst first */
    for (size_t r = 0; r < c->n_runs; r++)
      if (c->run[r].health.verdict == (enum health_verdict)v) health_row(p, c, r);
  cmp_html_table_close(p);
}

/* ---- provenance ---- */

static void provenance_row(struct page *p, const struct comparison *c, size_t r) {
  const struct cmp_data *d = &cmp_run_or_ref(c, r)->data;
  const struct result_file *f = d->file;
  cmp_page_open(p, "tr", NULL);
  cmp_html_run(p, c, r);
  cmp_html_cell(p, "t", "%s%s", *f->solver ? f->solver : "another program",
                f->complete ? "" : " (unfinished)");
  cmp_html_cell(p, NULL, "%.4g", 1 / d->dx);
  cmp_html_cell(p, NULL, "%zu", d->n);
  cmp_html_cell(p, NULL, "%.4g", d->n ? d->t[d->n - 1] : 0.);
  const struct result_step *last = f->n_steps ? &f->steps[f->n_steps - 1] : NULL;
  if (last && last->evaluations > 0) {
    cmp_html_cell(p, NULL, "%.0f", last->evaluations);
    cmp_html_cell(p, NULL, "%.1f", last->wall_time);
  } else { /* of another program, which does not say */
    cmp_html_cell(p, NULL, "-");
    cmp_html_cell(p, NULL, "-");
  }
  cmp_html_cell(p, "t", *f->version ? "%s, %s" : "", f->version, f->revision);
  cmp_html_cell(p, "w", "%s", f->path);
  cmp_page_close(p);
}

static void statistics_list(struct page *p, const struct comparison *c, size_t r) {
  const struct cmp_data *d = &cmp_run_or_ref(c, r)->data;
  if (!d->file->n_statistics) return;
  cmp_page_open(p, "details", NULL);
  cmp_page_element(p, "summary", NULL, "What %s counted", d->label);
  cmp_html_table_open(p);
  for (size_t k = 0; k < d->file->n_statistics; k++) {
    const struct result_statistic_read *s = &d->file->statistics[k];
    cmp_page_open(p, "tr", NULL);
    cmp_page_element(p, "th", "t", "%s", s->name);
    cmp_html_cell(p, NULL, "%.6g", s->value);
    cmp_html_cell(p, "w", "%s", s->help);
    cmp_page_close(p);
  }
  cmp_html_table_close(p);
  cmp_page_close(p);
}

static void case_text(struct page *p, const struct comparison *c, size_t r) {
  const struct cmp_data *d = &cmp_run_or_ref(c, r)->data;
  const struct result_file *first = c->ref.data.file;
  if (r != SIZE_MAX && !strcmp(first->case_text, d->file->case_text)) return;
  cmp_page_open(p, "details", NULL);
  cmp_page_element(p, "summary", NULL, "The case as run by %s%s", d->label,
                   r == SIZE_MAX ? " (and by every run not listed with its own)" : "");
  cmp_page_open(p, "pre", NULL);
  cmp_page_text(p, "%s", d->file->case_text);
  cmp_page_close(p);
  cmp_page_close(p);
}

/* What a result lacks is not compared: that of every one is named. */
static void absent_say(struct page *p, const struct comparison *c, size_t r) {
  const char *what[CMP_MOST_ABSENT];
  const size_t n = cmp_absent_find(c, cmp_run_or_ref(c, r), what);
  if (!n) return;
  cmp_page_open(p, "p", NULL);
  cmp_page_text(p, "The file of %s has no ", cmp_run_or_ref(c, r)->data.label);
  for (size_t k = 0; k < n; k++)
    cmp_page_text(p, "%s%s", k == 0 ? "" : k + 1 == n ? " or " : ", ", what[k]);
  cmp_page_text(p, ": what needs them is not compared.");
  if (!strcmp(what[0], "walls")) cmp_page_text(p, " It is taken to be of the tank of the others.");
  cmp_page_close(p);
}

void cmp_html_provenance(struct page *p, const struct comparison *c) {
  cmp_html_table_open(p);
  cmp_html_headings(p, (const char *const[]){"run", "solver", "H/spacing", "outputs", "last t*",
                                             "evaluations", "clock [s]", "program", "file", NULL});
  for (size_t i = 0; i <= c->n_runs; i++) provenance_row(p, c, i == 0 ? SIZE_MAX : i - 1);
  cmp_html_table_close(p);
  for (size_t i = 0; i <= c->n_runs; i++) absent_say(p, c, i == 0 ? SIZE_MAX : i - 1);
  cmp_page_element(p, "p", "soft", "This report was made by plunge %s, revision %s.",
                   PLUNGE_VERSION, PLUNGE_REVISION);
  for (size_t i = 0; i <= c->n_runs; i++) statistics_list(p, c, i == 0 ? SIZE_MAX : i - 1);
  for (size_t i = 0; i <= c->n_runs; i++) case_text(p, c, i == 0 ? SIZE_MAX : i - 1);
  const struct result_file *f = c->ref.data.file;
  if (f->n_experiments || f->n_profiles) {
    cmp_page_element(p, "h3", NULL, "Experiments");
    cmp_page_open(p, "ul", NULL);
    for (size_t k = 0; k < f->n_experiments; k++)
      cmp_page_element(p, "li", NULL, "%s (%s): %s", f->experiments[k].label,
                       f->experiments[k].target, f->experiments[k].source);
    for (size_t k = 0; k < f->n_profiles; k++)
      cmp_page_element(p, "li", NULL, "%s (surface): %s", f->profiles[k].label,
                       f->profiles[k].source);
    cmp_page_close(p);
  }
}

/* ---- method ---- */

static void averages_say(struct page *p, const struct comparison *c) {
  size_t said = 0;
  for (size_t k = 0; k < c->ref.data.n_probes; k++) {
    const struct cmp_series *s = &c->ref.data.probes[k];
    if (!(s->average > 0)) continue;
    if (!said) cmp_page_open(p, "li", NULL);
    cmp_page_text(p, "%s%s over %.4g √(H/g)", said++ ? ", " : "Averages in time: pressures at ",
                  s->name, s->average);
  }
  if (!said) return;
  cmp_page_text(p, ". Every number of these signals, of runs, reference and experiments alike, is "
                   "that of the running mean centred on each instant, the exact integral of the "
                   "signal as it is interpolated, over less where the signal ends.");
  cmp_page_close(p);
}

static void filters_say(struct page *p, const struct comparison *c) {
  if (!c->settings->compare.n_filters) return;
  cmp_page_element(
      p, "li", NULL,
      "Filters are of the raw signals of probes, and beside them only. Low pass: the signal, put "
      "on even instants where it is not, is a sum of cosines over its duration (its even "
      "continuation has no jump at the ends); those of its period are halved, of 2/3 of it and "
      "less "
      "gone, of twice it and more left. The mean of the whole stays, and with it the impulse over "
      "it; about a sudden rise the rest overshoots by up to a tenth. Mean over a length of the "
      "wall: each probe on it stands for the stretch "
      "that is nearest to it. Impulse: trapezoids from the first row on.");
}

static void spectra_say(struct page *p, const struct comparison *c) {
  if (!c->settings->compare.n_spectra) return;
  cmp_page_element(
      p, "li", NULL,
      "Spectra are of raw series: the longest stretch of rows without a gap, less its mean, times "
      "a Hann window. Amplitude: that of a sine at the bin. Power density: adds up to the mean "
      "square. A peak's frequency and amplitude are those of the sine that the two highest bins "
      "are of, between them too; peaks below a twentieth of the highest are left out. A figure has "
      "the highest of bins that are closer than 0.2 %%.");
}

static void scales_say(struct page *p, const struct comparison *c) {
  cmp_page_element(
      p, "li", NULL,
      "Scales: lengths in H = %.4g m, times t* in √(H/g) = %.4g s, pressures in ρgH = %.4g "
      "Pa, energies in E0 = %.4g J/m, %s.",
      c->scales.H, c->scales.T, c->scales.p, c->scales.E,
      !c->ref.data.file->n_energy ? "which is ρgH³ since the reference's file has no energies"
      : c->scales.at_rest
          ? "which is ρgH³ since the reference starts at rest"
          : "the reference's initial mechanical energy relative to its own water at rest");
  cmp_page_element(
      p, "li", NULL,
      "Noise floor: the surface of a cloud of particles is known to about half a particle "
      "spacing, dx/2; for the area, dx/2 times the length of the reference's surface in the "
      "window. Values below it are shown in grey: they are zero as far as can be told.");
}

static void surfaces_say(struct page *p, const struct comparison *c) {
  cmp_page_element(
      p, "li", NULL,
      "Main surface: pieces at least %g %% as long as the longest. Shorter ones are spray "
      "and bubbles; they count in the Hausdorff distance and in the area only.",
      100 * CMP_MAIN_FRACTION);
  cmp_page_element(
      p, "li", NULL,
      "Mean and largest distance: from points every dx/2 along one main surface, inside the "
      "window, to the whole of the other, in both directions. Films thinner than %.3g H (two "
      "spacings of the coarsest run) on the tank's walls are left out, since no particle method "
      "resolves them: points closer than that to a wall are not taken. The Hausdorff distance and "
      "the discrete Fréchet distance (of the longest connected parts) leave out nothing.",
      c->depth);
  cmp_page_element(
      p, "li", NULL,
      "Area: free surfaces are closed along the tank into regions of water; the area is "
      "that of their symmetric difference within the window. It is withheld when an outline "
      "encloses less or more than the run's volume by a fifth.");
}

static void front_say(struct page *p, const struct comparison *c) {
  cmp_page_element(
      p, "li", NULL,
      "Front: the furthest x, towards the wall that the reference's water runs to (%s), at which "
      "the water standing on the bed is deeper than %.4g H (two spacings of the coarsest run), the "
      "same depth in every run, until the reference reaches that wall. None runs where the bed is "
      "wet from wall to wall at first.",
      (const char *[]){"the left", "the right", "here none"}[c->side], c->depth);
}

static void health_say(struct page *p) {
  cmp_page_open(p, "li", NULL);
  cmp_page_text(p, "Health: what a run says of itself, against limits. ");
  for (size_t k = 0; k < HEALTH_N; k++) {
    const struct health_measure *m = &health_measures[k];
    cmp_page_text(p, "%s%s (doubtful above %g", k ? ", " : "", m->help, m->doubtful);
    if (isfinite(m->failed)) cmp_page_text(p, ", failed above %g", m->failed);
    cmp_page_text(p, ")");
  }
  cmp_page_text(p, ". Nothing is compared with a reference after the instant at which its energies "
                   "or volumes have failed.");
  cmp_page_close(p);
}

static void jet_say(struct page *p, const struct comparison *c) {
  cmp_page_element(
      p, "li", NULL,
      "Jet: where the longest piece turns back by more than %.4g H "
      "(three spacings of the coarsest run), films on walls left out. The tip is where "
      "the surface turns most sharply around water (points 0.2 H before and after it along the "
      "surface are closest); the direction runs to it from the middle of the section 0.2 H "
      "behind; thickness is the distance between the points where circles about "
      "the tip cut its two sides; the cavity is closed by the vertical through the tip. "
      "Direction is counted counter-clockwise from +x.",
      CMP_JET_LEAST * c->depth);
}

static void signals_say(struct page *p) {
  cmp_page_element(
      p, "li", NULL,
      "Signals are compared over the time both cover, interpolated linearly. Arrival: first "
      "time at %g ρgH (pressure) or %g H (height). The best shift is the one within ±%g "
      "√(H/g) with the smallest rms; positive: the run is late. It is never applied.",
      CMP_ONSET, CMP_ONSET, CMP_SHIFT_REACH);
}

static void energy_say(struct page *p) {
  cmp_page_element(
      p, "li", NULL,
      "Energy: mechanical = kinetic + potential + the energy of water that a solver took "
      "out of its computation. The budget is kinetic + potential + elastic + removed + what "
      "each of the solver's own terms has taken; its closure is its change since t = 0.");
}

static void measures_say(struct page *p) {
  cmp_page_element(p, "h3", NULL, "The measures that compare.tolerances may name");
  cmp_page_open(p, "dl", NULL);
  for (size_t m = 0; m < CMP_N_MEASURES; m++) {
    cmp_page_element(p, "dt", NULL, "%s [%s]", cmp_measures[m].name, cmp_measures[m].units);
    cmp_page_element(p, "dd", NULL, "%s", cmp_measures[m].help);
  }
  cmp_page_close(p);
}

void cmp_html_method(struct page *p, const struct comparison *c) {
  cmp_page_open(p, "ul", NULL);
  scales_say(p, c);
  surfaces_say(p, c);
  front_say(p, c);
  health_say(p);
  jet_say(p, c);
  signals_say(p);
  averages_say(p, c);
  filters_say(p, c);
  spectra_say(p, c);
  energy_say(p);
  if (!c->window_whole)
    cmp_page_element(p, "li", NULL, "Window: x/H from %.4g to %.4g, y/H from %.4g to %.4g.",
                     c->window.min[0], c->window.max[0], c->window.min[1], c->window.max[1]);
  cmp_page_close(p);
  measures_say(p);
}

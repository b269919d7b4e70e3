#include "compare/json.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "compare/about.h"
#include "compare/absent.h"
#include "compare/chart.h"
#include "compare/convergence/json.h"
#include "compare/json_maker.h"
#include "compare/ledger.h"
#include "compare/output.h"
#include "compare/text.h"
#include "revision.h"

static json_t *instant(struct cmp_json_maker *m, const struct cmp_instant *i) {
  json_t *object = json_object();
  cmp_json_set_value(m, object, "t_star", &i->time);
  cmp_json_set(m, object, "error", cmp_json_number(i->error));
  cmp_json_set(m, object, "located_by_solver", json_boolean(i->located));
  cmp_json_set(m, object, "at", cmp_json_point(m, i->at));
  return object;
}

static json_t *jet(struct cmp_json_maker *m, const struct cmp_jet *j) {
  if (!j->found) return json_null();
  json_t *object = json_object(), *thickness = json_array();
  cmp_json_set(m, object, "tip", cmp_json_point(m, j->tip));
  cmp_json_set(m, object, "cavity_end", cmp_json_point(m, j->root));
  cmp_json_set(m, object, "overhang", cmp_json_number(j->overhang));
  cmp_json_set(m, object, "gap_below_tip", cmp_json_number(j->gap));
  cmp_json_set_value(m, object, "direction_degrees", &j->direction);
  cmp_json_set_value(m, object, "cavity_area", &j->cavity);
  for (size_t k = 0; k < CMP_JET_STATIONS; k++) {
    json_t *at = json_object();
    cmp_json_set(m, at, "behind_tip", cmp_json_number(cmp_jet_station[k]));
    cmp_json_set_value(m, at, "thickness", &j->thickness[k]);
    cmp_json_add(m, thickness, at);
  }
  cmp_json_set(m, object, "thickness", thickness);
  return object;
}

static json_t *alone(struct cmp_json_maker *m, const struct cmp_signal_alone *s) {
  json_t *object = json_object();
  cmp_json_set_value(m, object, "peak", &s->peak);
  cmp_json_set_value(m, object, "peak_time", &s->peak_time);
  cmp_json_set_value(m, object, "impulse", &s->impulse);
  cmp_json_set_value(m, object, "onset", &s->onset);
  return object;
}

static json_t *pairs(struct cmp_json_maker *m, const struct comparison *c,
                     const struct cmp_run *run) {
  static const char *const units[] = {"rho g H", "H", "H"};
  json_t *array = json_array();
  for (size_t k = 0; k < run->n_pairs; k++) {
    const struct cmp_pair *p = &run->pairs[k];
    bool experiment = p->experiment != SIZE_MAX;
    json_t *object = json_object();
    cmp_json_set(m, object, "signal", cmp_json_text(p->a->name));
    cmp_json_set(m, object, "against", cmp_json_text(experiment ? p->b->name : c->ref.data.label));
    cmp_json_set(m, object, "experiment", json_boolean(experiment));
    cmp_json_set(m, object, "units", cmp_json_text(units[p->quantity]));
    cmp_json_set(m, object, "averaged_over", cmp_json_number(p->a->average));
    cmp_json_set(m, object, "from", cmp_json_number(p->m.from));
    cmp_json_set(m, object, "to", cmp_json_number(p->m.to));
    cmp_json_set(m, object, "run", alone(m, &p->m.a));
    cmp_json_set(m, object, "other", alone(m, &p->m.b));
    cmp_json_set_value(m, object, "rms", &p->m.rms);
    cmp_json_set_value(m, object, "best_shift", &p->m.shift);
    cmp_json_set_value(m, object, "rms_if_shifted", &p->m.rms_after);
    cmp_json_add(m, array, object);
  }
  return array;
}

static json_t *health(struct cmp_json_maker *m, const struct health *h) {
  json_t *object = json_object(), *measures = json_object();
  cmp_json_set(m, object, "verdict", cmp_json_text(health_word(h)));
  cmp_json_set(m, object, "reasons", cmp_json_text(h->reasons));
  cmp_json_set(m, object, "not_told", cmp_json_text(h->missing));
  cmp_json_set(m, object, "facts", cmp_json_text(h->facts));
  for (size_t k = 0; k < HEALTH_N; k++)
    cmp_json_set(m, measures, health_measures[k].name, cmp_json_number(h->value[k]));
  cmp_json_set(m, object, "measures", measures);
  return object;
}

static json_t *absent(struct cmp_json_maker *m, const struct comparison *c,
                      const struct cmp_run *run) {
  const char *what[CMP_MOST_ABSENT];
  const size_t n = cmp_absent_find(c, run, what);
  json_t *array = json_array();
  for (size_t k = 0; k < n; k++) cmp_json_add(m, array, cmp_json_text(what[k]));
  return array;
}

static json_t *provenance(struct cmp_json_maker *m, const struct comparison *c,
                          const struct cmp_run *run) {
  const struct cmp_data *d = &run->data;
  const struct result_file *f = d->file;
  json_t *object = json_object(), *statistics = json_object();
  cmp_json_set(m, object, "label", cmp_json_text(d->label));
  cmp_json_set(m, object, "run", cmp_json_text(f->run));
  cmp_json_set(m, object, "solver", cmp_json_text(f->solver));
  cmp_json_set(m, object, "file", cmp_json_text(f->path));
  cmp_json_set(m, object, "absent", absent(m, c, run));
  cmp_json_set(m, object, "complete", json_boolean(f->complete));
  cmp_json_set(m, object, "ended", cmp_json_text(f->ended));
  if (f->surfaces_found)
    cmp_json_set(m, object, "surface", cmp_json_text("found from the particles"));
  if (f->imported && *f->imported) cmp_json_set(m, object, "imported", cmp_json_text(f->imported));
  cmp_json_set(m, object, "program_version", cmp_json_text(f->version));
  cmp_json_set(m, object, "program_revision", cmp_json_text(f->revision));
  cmp_json_set(m, object, "fingerprint", cmp_json_text(f->fingerprint));
  cmp_json_set(m, object, "water", cmp_json_text(f->water_fingerprint));
  cmp_json_set(m, object, "spacing", cmp_json_number(d->dx));
  cmp_json_set(m, object, "outputs", json_integer((json_int_t)d->n));
  if (d->n) cmp_json_set(m, object, "last_output", cmp_json_number(d->t[d->n - 1]));
  if (f->n_steps) {
    const struct result_step *last = &f->steps[f->n_steps - 1];
    cmp_json_set(m, object, "evaluations", cmp_json_number(last->evaluations));
    cmp_json_set(m, object, "wall_time_s", cmp_json_number(last->wall_time));
  }
  for (size_t k = 0; k < f->n_statistics; k++)
    cmp_json_set_named(m, statistics, f->statistics[k].name, f->statistics[k].value);
  cmp_json_set(m, object, "statistics", statistics);
  cmp_json_set(m, object, "case",
               f == c->ref.data.file || strcmp(f->case_text, c->ref.data.file->case_text)
                   ? cmp_json_text(f->case_text)
                   : json_null()); /* that of the reference */
  cmp_json_set(m, object, "wall_impact", instant(m, &d->impact));
  cmp_json_set(m, object, "overturning", instant(m, &d->overturning));
  cmp_json_set(m, object, "touchdown", instant(m, &d->touchdown));
  return object;
}

/* Mean and largest of what is known of n standard errors, `stride` numbers apart. */
static json_t *error_range(struct cmp_json_maker *m, size_t n, const double *error, size_t stride,
                           double scale) {
  json_t *object = json_object();
  double most = NAN, sum = 0;
  size_t known = 0;
  for (size_t i = 0; i < n; i++) {
    if (!isfinite(error[i * stride])) continue;
    most = fmax(most, error[i * stride]);
    sum += error[i * stride];
    known++;
  }
  cmp_json_set(m, object, "mean", cmp_json_number(sum / (double)known / scale));
  cmp_json_set(m, object, "largest", cmp_json_number(most / scale));
  return object;
}

static json_t *event_errors(struct cmp_json_maker *m, const struct comparison *c,
                            const struct result_file *f) {
  json_t *array = json_array();
  for (size_t k = 0; k < f->n_events; k++) {
    const struct result_event_read *e = &f->events[k];
    json_t *object = json_object();
    cmp_json_set(m, object, "event", cmp_json_text(e->name));
    cmp_json_set(m, object, "t_star", cmp_json_number(e->time / c->scales.T));
    cmp_json_set(m, object, "t_star_error", cmp_json_number(e->error[0] / c->scales.T));
    cmp_json_set(m, object, "at",
                 cmp_json_point(m, (double[]){e->x / c->scales.H, e->y / c->scales.H}));
    cmp_json_set(
        m, object, "at_error",
        cmp_json_point(m, (double[]){e->error[1] / c->scales.H, e->error[2] / c->scales.H}));
    cmp_json_add(m, array, object);
  }
  return array;
}

static json_t *surface_errors(struct cmp_json_maker *m, const struct comparison *c,
                              const struct result_file *f) {
  json_t *array = json_array();
  for (size_t k = 0, from = 0; f->n_surface_errors && k < f->n_surfaces;
       from += f->surface[k++].points) {
    json_t *object = error_range(m, f->surface[k].points, f->surface_error + from, 1, c->scales.H);
    cmp_json_set(m, object, "t_star", cmp_json_number(f->surface_time[k] / c->scales.T));
    cmp_json_add(m, array, object);
  }
  return array;
}

/* What a run says of its own error, by a coarser one. */
static json_t *error_bars(struct cmp_json_maker *m, const struct comparison *c,
                          const struct result_file *f) {
  json_t *object = json_object(), *series = json_object();
  cmp_json_set(m, object, "spacing_ratio", cmp_json_number(f->coarser.ratio));
  cmp_json_set(m, object, "order", cmp_json_number(f->coarser.order));
  cmp_json_set(m, object, "events", event_errors(m, c, f));
  cmp_json_set(m, object, "surfaces", surface_errors(m, c, f));
  if (f->n_energy_errors)
    cmp_json_set(m, object, "total_energy",
                 error_range(m, f->n_energy_errors, &f->energy_error->total,
                             sizeof *f->energy_error / sizeof(double), c->scales.E));
  for (size_t k = 0; k < f->n_probes; k++)
    cmp_json_set(m, series, f->probes[k].name,
                 error_range(m, f->probes[k].n_errors, f->probes[k].error, 1, c->scales.p));
  for (size_t k = 0; k < f->n_gauges; k++)
    cmp_json_set(m, series, f->gauges[k].name,
                 error_range(m, f->gauges[k].n_errors, f->gauges[k].error, 1, c->scales.H));
  cmp_json_set(m, object, "series", series);
  return object;
}

/* Where the energy went, until each comparison time. */
static json_t *budget(struct cmp_json_maker *m, const struct comparison *c,
                      const struct cmp_data *d) {
  json_t *array = json_array();
  for (size_t i = 0; i < c->n_times; i++) {
    const double t = c->times[i];
    struct cmp_value lost = cmp_ledger_lost(d, t), elastic = cmp_ledger_elastic(d, t),
                     rest = cmp_ledger_rest(d, t);
    json_t *object = json_object(), *terms = json_object();
    cmp_json_set(m, object, "t_star", cmp_json_number(t));
    cmp_json_set_value(m, object, "mechanical_lost", &lost);
    cmp_json_set_value(m, object, "elastic_gained", &elastic);
    for (size_t k = 0; k < d->n_terms; k++)
      cmp_json_set_named(m, terms, d->terms[k].name, cmp_ledger_term(d, d->terms[k].name, t).value);
    cmp_json_set(m, object, "terms", terms);
    cmp_json_set_value(m, object, "unaccounted", &rest);
    cmp_json_add(m, array, object);
  }
  return array;
}

/* What each of the settings' filters makes of the run's probes, or why it cannot. */
static json_t *filters(struct cmp_json_maker *m, const struct comparison *c,
                       const struct cmp_run *run) {
  static const char *const kinds[] = {
#define X(name, help) #name,
      CASE_FILTERS(X)
#undef X
  };
  json_t *array = json_array();
  for (size_t k = 0; k < c->settings->compare.n_filters; k++) {
    const struct cmp_filtered *f = &run->filtered[k];
    const enum case_filter_kind kind = f->filter->kind;
    json_t *object = json_object();
    cmp_json_set(m, object, "probe", cmp_json_text(f->probe));
    cmp_json_set(m, object, "kind", cmp_json_text(kinds[kind]));
    if (kind == CASE_FILTER_low_pass)
      cmp_json_set(m, object, "period", cmp_json_number(f->filter->period / c->scales.T));
    if (kind == CASE_FILTER_wall)
      cmp_json_set(m, object, "length", cmp_json_number(f->filter->length / c->scales.H));
    char says[96];
    cmp_filter_say(f->filter, c->scales.T, c->scales.H, says, sizeof says);
    cmp_json_set(m, object, "says", cmp_json_text(says));
    cmp_json_set(m, object, "units", cmp_json_text(f->units));
    cmp_json_set(m, object, "raw", alone(m, &f->before));
    cmp_json_set(m, object, "filtered", alone(m, &f->after));
    cmp_json_set_value(m, object, "rms_taken_out", &f->taken);
    cmp_json_add(m, array, object);
  }
  return array;
}

static json_t *spectrum(struct cmp_json_maker *m, const struct comparison *c,
                        const struct cmp_run *run, size_t k) {
  const struct cmp_spectrum *s = &run->spectrum[k];
  const char *name = c->settings->compare.spectra[k].series;
  const struct cmp_series *series = cmp_data_series(&run->data, name);
  json_t *object = json_object(), *peaks = json_array();
  cmp_json_set(m, object, "series", cmp_json_text(name));
  cmp_json_set(m, object, "units", cmp_json_text(series && series->units ? series->units : "1"));
  cmp_json_set_value(m, object, "sampling_interval", &s->interval);
  cmp_json_set(m, object, "samples", json_integer((json_int_t)s->samples));
  cmp_json_set(m, object, "resampled", json_boolean(s->resampled));
  cmp_json_set(m, object, "from", cmp_json_number(s->n ? s->from : NAN));
  cmp_json_set(m, object, "to", cmp_json_number(s->n ? s->to : NAN));
  cmp_json_set(m, object, "bin", cmp_json_number(s->n ? s->step : NAN));
  cmp_json_set(m, object, "mean", cmp_json_number(s->n ? s->mean : NAN));
  cmp_json_set(m, object, "mean_square", cmp_json_number(s->n ? s->mean_square : NAN));
  for (size_t i = 0; i < s->n_peaks; i++) {
    json_t *peak = json_object();
    cmp_json_set(m, peak, "frequency", cmp_json_number(s->peak[i].frequency));
    cmp_json_set(m, peak, "frequency_Hz", cmp_json_number(s->peak[i].frequency / c->scales.T));
    cmp_json_set(m, peak, "amplitude", cmp_json_number(s->peak[i].amplitude));
    cmp_json_add(m, peaks, peak);
  }
  cmp_json_set(m, object, "peaks", peaks);
  return object;
}

static json_t *spectra(struct cmp_json_maker *m, const struct comparison *c,
                       const struct cmp_run *run) {
  json_t *array = json_array();
  for (size_t k = 0; k < c->settings->compare.n_spectra; k++)
    cmp_json_add(m, array, spectrum(m, c, run, k));
  return array;
}

/* Medians of what the run says of its noise and momenta. */
static json_t *diagnostics(struct cmp_json_maker *m, const struct comparison *c,
                           const struct cmp_data *d) {
  json_t *object = json_object(), *medians = json_object();
  const double from = cmp_comparison_settled(c);
  cmp_json_set(m, object, "from", cmp_json_number(from));
  for (size_t k = 0; k < d->n_diagnostics; k++) {
    const struct cmp_signal s = cmp_series_signal(&d->diagnostics[k]);
    cmp_json_set_named(m, medians, d->diagnostics[k].name, cmp_signal_median(&s, from).value);
  }
  cmp_json_set(m, object, "medians", medians);
  return object;
}

static json_t *run_object(struct cmp_json_maker *m, const struct comparison *c,
                          const struct cmp_run *run) {
  json_t *object = provenance(m, c, run), *evolution = json_object(), *jets = json_array();
  const struct cmp_evolution *e = &run->evolution;
  cmp_json_set(m, object, "health", health(m, &run->health));
  cmp_json_set(m, object, "noise_floor", cmp_json_number(run->noise));
  if (run != &c->ref) {
    cmp_json_set(m, object, "of_other_water", json_boolean(run->foreign));
    cmp_json_set_value(m, object, "within_one_spacing_until", &run->agreement);
    cmp_json_set_value(m, object, "largest_relative_distance", &run->off);
    cmp_json_set(m, evolution, "t_star", cmp_json_numbers(m, e->t, e->n));
    for (size_t k = 0; k < CMP_N_MEASURES; k++)
      if (e->value[k])
        cmp_json_set(m, evolution, cmp_measures[k].name, cmp_json_numbers(m, e->value[k], e->n));
    cmp_json_set(m, object, "against_time", evolution);
    for (size_t k = 0; k < c->n_times; k++) {
      const struct cmp_at *at = &run->at[k];
      json_t *entry = json_object();
      cmp_json_set(m, entry, "t_star_asked", cmp_json_number(c->times[k]));
      cmp_json_set(m, entry, "t_star", cmp_json_number(at->t));
      cmp_json_set(m, entry, "t_star_reference", cmp_json_number(at->ref_t));
      cmp_json_set(m, entry, "largest_distance_at", cmp_json_point(m, at->where));
      cmp_json_set(m, entry, "jet",
                   at->output == SIZE_MAX ? json_null() : jet(m, &run->data.jet[at->output]));
      cmp_json_set(m, entry, "jet_reference",
                   at->ref_output == SIZE_MAX ? json_null()
                                              : jet(m, &c->ref.data.jet[at->ref_output]));
      cmp_json_add(m, jets, entry);
    }
    cmp_json_set(m, object, "at_times", jets);
  } else {
    json_decref(evolution);
    json_decref(jets);
  }
  if (run->data.file->coarser.ratio > 0)
    cmp_json_set(m, object, "error_bars", error_bars(m, c, run->data.file));
  cmp_json_set(m, object, "energy_budget", budget(m, c, &run->data));
  cmp_json_set_value(m, object, "budget_closure", &run->closure);
  cmp_json_set_value(m, object, "budget_closure_before_impact", &run->closure_before);
  cmp_json_set_value(m, object, "volume_change", &run->volume);
  cmp_json_set(m, object, "signals", pairs(m, c, run));
  if (run->data.n_diagnostics)
    cmp_json_set(m, object, "diagnostics", diagnostics(m, c, &run->data));
  cmp_json_set(m, object, "filters", filters(m, c, run));
  cmp_json_set(m, object, "spectra", spectra(m, c, run));
  return object;
}

static json_t *row_object(struct cmp_json_maker *m, const struct comparison *c,
                          const struct cmp_row *row) {
  static const char *const outcomes[] = {"no limit", "pass", "fail"};
  json_t *object = json_object();
  cmp_json_set(m, object, "measure", cmp_json_text(row->measure->name));
  cmp_json_set(m, object, "units", cmp_json_text(row->measure->units));
  cmp_json_set(m, object, "run", cmp_json_text(c->run[row->run].data.label));
  cmp_json_set(m, object, "t_star",
               row->time == SIZE_MAX ? json_null() : cmp_json_number(c->times[row->time]));
  cmp_json_set_value(m, object, "value", &row->value);
  if (row->detail[0]) cmp_json_set(m, object, "detail", cmp_json_text(row->detail));
  if (row->left_out)
    cmp_json_set(m, object, "sensors_left_out", json_integer((json_int_t)row->left_out));
  if (isfinite(row->noise)) cmp_json_set(m, object, "noise_floor", cmp_json_number(row->noise));
  if (isfinite(row->limit)) cmp_json_set(m, object, "limit", cmp_json_number(row->limit));
  cmp_json_set(m, object, "outcome", cmp_json_text(outcomes[row->outcome]));
  return object;
}

static json_t *check_object(struct cmp_json_maker *m, const struct comparison *c,
                            const struct cmp_check *check) {
  json_t *object = json_object();
  cmp_json_set(m, object, "event", cmp_json_text(case_event_names[check->of->event]));
  cmp_json_set(m, object, "of", cmp_json_text(case_event_parts[check->of->part]));
  cmp_json_set(m, object, "units", cmp_json_text(cmp_check_units(check)));
  cmp_json_set(m, object, "run", cmp_json_text(cmp_run_or_ref(c, check->run)->data.label));
  cmp_json_set_value(m, object, "value", &check->value);
  cmp_json_set(m, object, "published", cmp_json_number(check->published));
  cmp_json_set(m, object, "within", cmp_json_number(check->within));
  cmp_json_set(m, object, "source", cmp_json_text(check->of->source));
  cmp_json_set(m, object, "outcome", cmp_json_text(check->passed ? "pass" : "fail"));
  return object;
}

static json_t *scales(struct cmp_json_maker *m, const struct comparison *c) {
  json_t *object = json_object();
  cmp_json_set(m, object, "H_m", cmp_json_number(c->scales.H));
  cmp_json_set(m, object, "time_s", cmp_json_number(c->scales.T));
  cmp_json_set(m, object, "pressure_Pa", cmp_json_number(c->scales.p));
  cmp_json_set(m, object, "E0_J_per_m", cmp_json_number(c->scales.E));
  cmp_json_set(m, object, "energy_at_rest_J_per_m", cmp_json_number(c->scales.rest));
  return object;
}

enum status cmp_json_create(const struct comparison *c, const struct cmp_rows *rows,
                            const struct cmp_convergence *convergence, const char *sentence,
                            json_t **out) {
  struct cmp_json_maker maker = {true}, *m = &maker;
  json_t *root = json_object(), *runs = json_array(), *measures = json_array();
  json_t *window = json_array(), *events = json_array();
  cmp_json_set(m, root, "format", cmp_json_text("plunge report"));
  cmp_json_set(m, root, "program_version", cmp_json_text(PLUNGE_VERSION));
  cmp_json_set(m, root, "program_revision", cmp_json_text(PLUNGE_REVISION));
  cmp_json_set(m, root, "title", cmp_json_text(c->ref.data.file->title));
  cmp_json_set(m, root, "sentence", cmp_json_text(sentence));
  cmp_json_set(m, root, "verdict",
               cmp_json_text(rows->failed   ? "fail"
                             : rows->passed ? "pass"
                                            : "no tolerances"));
  cmp_json_set(m, root, "passed", json_integer((json_int_t)rows->passed));
  cmp_json_set(m, root, "failed", json_integer((json_int_t)rows->failed));
  cmp_json_set(m, root, "scales", scales(m, c));
  cmp_json_add(m, window, cmp_json_point(m, c->window.min));
  cmp_json_add(m, window, cmp_json_point(m, c->window.max));
  cmp_json_set(m, root, "window", window);
  cmp_json_set(m, root, "front_depth", cmp_json_number(c->depth));
  cmp_json_set(m, root, "front_runs_to",
               cmp_json_text((const char *[]){"left", "right", "none"}[c->side]));
  cmp_json_set_value(m, root, "reference_surface_moves_by", &c->motion);
  cmp_json_set(m, root, "reference_believed_until", cmp_json_number(c->until));
  cmp_json_set(m, root, "times", cmp_json_numbers(m, c->times, c->n_times));
  cmp_json_set(m, root, "reference", run_object(m, c, &c->ref));
  for (size_t r = 0; r < c->n_runs; r++) cmp_json_add(m, runs, run_object(m, c, &c->run[r]));
  cmp_json_set(m, root, "runs", runs);
  for (size_t i = 0; i < rows->n; i++) cmp_json_add(m, measures, row_object(m, c, &rows->row[i]));
  cmp_json_set(m, root, "measures", measures);
  for (size_t i = 0; i < rows->checks.n; i++)
    cmp_json_add(m, events, check_object(m, c, &rows->checks.check[i]));
  cmp_json_set(m, root, "events", events);
  cmp_json_set(m, root, "convergence", cmp_convergence_json(m, c, convergence));

  cmp_json_set(m, root, "about", cmp_about_json(m, c));
  *out = root;
  if (root && m->ok) return OK;
  json_decref(root);
  *out = NULL;
  return status_raise(ERR_MEMORY, "no memory for the report");
}

enum status cmp_json_save(const json_t *report, const char *path) {
  enum status status = OK;
  struct cmp_output out = {0};
  ATTEMPT(cmp_output_open(path, &out));
  if (json_dumpf(report, out.stream, JSON_INDENT(1) | JSON_REAL_PRECISION(17)) != 0)
    status = status_raise(ERR_IO, "cannot write %s; is the disk full?", path);
  if (status == OK) {
    fputc('\n', out.stream);
    status = cmp_output_commit(&out);
  }
done:
  cmp_output_abandon(&out);
  return status;
}

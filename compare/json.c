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

static json_t *instant(struct maker *m, const struct cmp_instant *i) {
  json_t *object = json_object();
  set_value(m, object, "t_star", &i->time);
  set(m, object, "error", number(i->error));
  set(m, object, "located_by_solver", json_boolean(i->located));
  set(m, object, "at", point(m, i->at));
  return object;
}

static json_t *jet(struct maker *m, const struct cmp_jet *j) {
  if (!j->found) return json_null();
  json_t *object = json_object(), *thickness = json_array();
  set(m, object, "tip", point(m, j->tip));
  set(m, object, "cavity_end", point(m, j->root));
  set(m, object, "overhang", number(j->overhang));
  set(m, object, "gap_below_tip", number(j->gap));
  set_value(m, object, "direction_degrees", &j->direction);
  set_value(m, object, "cavity_area", &j->cavity);
  for (size_t k = 0; k < CMP_JET_STATIONS; k++) {
    json_t *at = json_object();
    set(m, at, "behind_tip", number(cmp_jet_station[k]));
    set_value(m, at, "thickness", &j->thickness[k]);
    add(m, thickness, at);
  }
  set(m, object, "thickness", thickness);
  return object;
}

static json_t *alone(struct maker *m, const struct cmp_signal_alone *s) {
  json_t *object = json_object();
  set_value(m, object, "peak", &s->peak);
  set_value(m, object, "peak_time", &s->peak_time);
  set_value(m, object, "impulse", &s->impulse);
  set_value(m, object, "onset", &s->onset);
  return object;
}

static json_t *pairs(struct maker *m, const struct comparison *c, const struct cmp_run *run) {
  static const char *const units[] = {"rho g H", "H", "H"};
  json_t *array = json_array();
  for (size_t k = 0; k < run->n_pairs; k++) {
    const struct cmp_pair *p = &run->pairs[k];
    bool experiment = p->experiment != SIZE_MAX;
    json_t *object = json_object();
    set(m, object, "signal", text(p->a->name));
    set(m, object, "against", text(experiment ? p->b->name : c->ref.data.label));
    set(m, object, "experiment", json_boolean(experiment));
    set(m, object, "units", text(units[p->quantity]));
    set(m, object, "averaged_over", number(p->a->average));
    set(m, object, "from", number(p->m.from));
    set(m, object, "to", number(p->m.to));
    set(m, object, "run", alone(m, &p->m.a));
    set(m, object, "other", alone(m, &p->m.b));
    set_value(m, object, "rms", &p->m.rms);
    set_value(m, object, "best_shift", &p->m.shift);
    set_value(m, object, "rms_if_shifted", &p->m.rms_after);
    add(m, array, object);
  }
  return array;
}

static json_t *health(struct maker *m, const struct health *h) {
  json_t *object = json_object(), *measures = json_object();
  set(m, object, "verdict", text(health_word(h)));
  set(m, object, "reasons", text(h->reasons));
  set(m, object, "not_told", text(h->missing));
  set(m, object, "facts", text(h->facts));
  for (size_t k = 0; k < HEALTH_N; k++)
    set(m, measures, health_measures[k].name, number(h->value[k]));
  set(m, object, "measures", measures);
  return object;
}

static json_t *absent(struct maker *m, const struct comparison *c, const struct cmp_run *run) {
  const char *what[CMP_MOST_ABSENT];
  const size_t n = cmp_absent_find(c, run, what);
  json_t *array = json_array();
  for (size_t k = 0; k < n; k++) add(m, array, text(what[k]));
  return array;
}

static json_t *provenance(struct maker *m, const struct comparison *c, const struct cmp_run *run) {
  const struct cmp_data *d = &run->data;
  const struct result_file *f = d->file;
  json_t *object = json_object(), *statistics = json_object();
  set(m, object, "label", text(d->label));
  set(m, object, "run", text(f->run));
  set(m, object, "solver", text(f->solver));
  set(m, object, "file", text(f->path));
  set(m, object, "absent", absent(m, c, run));
  set(m, object, "complete", json_boolean(f->complete));
  set(m, object, "ended", text(f->ended));
  if (f->surfaces_found) set(m, object, "surface", text("found from the particles"));
  if (f->imported && *f->imported) set(m, object, "imported", text(f->imported));
  set(m, object, "program_version", text(f->version));
  set(m, object, "program_revision", text(f->revision));
  set(m, object, "fingerprint", text(f->fingerprint));
  set(m, object, "water", text(f->water_fingerprint));
  set(m, object, "spacing", number(d->dx));
  set(m, object, "outputs", json_integer((json_int_t)d->n));
  if (d->n) set(m, object, "last_output", number(d->t[d->n - 1]));
  if (f->n_steps) {
    const struct result_step *last = &f->steps[f->n_steps - 1];
    set(m, object, "evaluations", number(last->evaluations));
    set(m, object, "wall_time_s", number(last->wall_time));
  }
  for (size_t k = 0; k < f->n_statistics; k++)
    set_named(m, statistics, f->statistics[k].name, f->statistics[k].value);
  set(m, object, "statistics", statistics);
  set(m, object, "case",
      f == c->ref.data.file || strcmp(f->case_text, c->ref.data.file->case_text)
          ? text(f->case_text)
          : json_null()); /* that of the reference */
  set(m, object, "wall_impact", instant(m, &d->impact));
  set(m, object, "overturning", instant(m, &d->overturning));
  set(m, object, "touchdown", instant(m, &d->touchdown));
  return object;
}

/* Mean and largest of what is known of n standard errors, `stride` numbers apart. */
static json_t *error_range(struct maker *m, size_t n, const double *error, size_t stride,
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
  set(m, object, "mean", number(sum / (double)known / scale));
  set(m, object, "largest", number(most / scale));
  return object;
}

static json_t *event_errors(struct maker *m, const struct comparison *c,
                            const struct result_file *f) {
  json_t *array = json_array();
  for (size_t k = 0; k < f->n_events; k++) {
    const struct result_event_read *e = &f->events[k];
    json_t *object = json_object();
    set(m, object, "event", text(e->name));
    set(m, object, "t_star", number(e->time / c->scales.T));
    set(m, object, "t_star_error", number(e->error[0] / c->scales.T));
    set(m, object, "at", point(m, (double[]){e->x / c->scales.H, e->y / c->scales.H}));
    set(m, object, "at_error",
        point(m, (double[]){e->error[1] / c->scales.H, e->error[2] / c->scales.H}));
    add(m, array, object);
  }
  return array;
}

static json_t *surface_errors(struct maker *m, const struct comparison *c,
                              const struct result_file *f) {
  json_t *array = json_array();
  for (size_t k = 0, from = 0; f->n_surface_errors && k < f->n_surfaces;
       from += f->surface[k++].points) {
    json_t *object = error_range(m, f->surface[k].points, f->surface_error + from, 1, c->scales.H);
    set(m, object, "t_star", number(f->surface_time[k] / c->scales.T));
    add(m, array, object);
  }
  return array;
}

/* What a run says of its own error, by a coarser one. */
static json_t *error_bars(struct maker *m, const struct comparison *c,
                          const struct result_file *f) {
  json_t *object = json_object(), *series = json_object();
  set(m, object, "spacing_ratio", number(f->coarser.ratio));
  set(m, object, "order", number(f->coarser.order));
  set(m, object, "events", event_errors(m, c, f));
  set(m, object, "surfaces", surface_errors(m, c, f));
  if (f->n_energy_errors)
    set(m, object, "total_energy",
        error_range(m, f->n_energy_errors, &f->energy_error->total,
                    sizeof *f->energy_error / sizeof(double), c->scales.E));
  for (size_t k = 0; k < f->n_probes; k++)
    set(m, series, f->probes[k].name,
        error_range(m, f->probes[k].n_errors, f->probes[k].error, 1, c->scales.p));
  for (size_t k = 0; k < f->n_gauges; k++)
    set(m, series, f->gauges[k].name,
        error_range(m, f->gauges[k].n_errors, f->gauges[k].error, 1, c->scales.H));
  set(m, object, "series", series);
  return object;
}

/* Where the energy went, until each comparison time. */
static json_t *budget(struct maker *m, const struct comparison *c, const struct cmp_data *d) {
  json_t *array = json_array();
  for (size_t i = 0; i < c->n_times; i++) {
    const double t = c->times[i];
    struct cmp_value lost = cmp_ledger_lost(d, t), elastic = cmp_ledger_elastic(d, t),
                     rest = cmp_ledger_rest(d, t);
    json_t *object = json_object(), *terms = json_object();
    set(m, object, "t_star", number(t));
    set_value(m, object, "mechanical_lost", &lost);
    set_value(m, object, "elastic_gained", &elastic);
    for (size_t k = 0; k < d->n_terms; k++)
      set_named(m, terms, d->terms[k].name, cmp_ledger_term(d, d->terms[k].name, t).value);
    set(m, object, "terms", terms);
    set_value(m, object, "unaccounted", &rest);
    add(m, array, object);
  }
  return array;
}

/* What each of the settings' filters makes of the run's probes, or why it cannot. */
static json_t *filters(struct maker *m, const struct comparison *c, const struct cmp_run *run) {
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
    set(m, object, "probe", text(f->probe));
    set(m, object, "kind", text(kinds[kind]));
    if (kind == CASE_FILTER_low_pass)
      set(m, object, "period", number(f->filter->period / c->scales.T));
    if (kind == CASE_FILTER_wall) set(m, object, "length", number(f->filter->length / c->scales.H));
    char says[96];
    cmp_filter_say(f->filter, c->scales.T, c->scales.H, says, sizeof says);
    set(m, object, "says", text(says));
    set(m, object, "units", text(f->units));
    set(m, object, "raw", alone(m, &f->before));
    set(m, object, "filtered", alone(m, &f->after));
    set_value(m, object, "rms_taken_out", &f->taken);
    add(m, array, object);
  }
  return array;
}

static json_t *spectrum(struct maker *m, const struct comparison *c, const struct cmp_run *run,
                        size_t k) {
  const struct cmp_spectrum *s = &run->spectrum[k];
  const char *name = c->settings->compare.spectra[k].series;
  const struct cmp_series *series = cmp_data_series(&run->data, name);
  json_t *object = json_object(), *peaks = json_array();
  set(m, object, "series", text(name));
  set(m, object, "units", text(series && series->units ? series->units : "1"));
  set_value(m, object, "sampling_interval", &s->interval);
  set(m, object, "samples", json_integer((json_int_t)s->samples));
  set(m, object, "resampled", json_boolean(s->resampled));
  set(m, object, "from", number(s->n ? s->from : NAN));
  set(m, object, "to", number(s->n ? s->to : NAN));
  set(m, object, "bin", number(s->n ? s->step : NAN));
  set(m, object, "mean", number(s->n ? s->mean : NAN));
  set(m, object, "mean_square", number(s->n ? s->mean_square : NAN));
  for (size_t i = 0; i < s->n_peaks; i++) {
    json_t *peak = json_object();
    set(m, peak, "frequency", number(s->peak[i].frequency));
    set(m, peak, "frequency_Hz", number(s->peak[i].frequency / c->scales.T));
    set(m, peak, "amplitude", number(s->peak[i].amplitude));
    add(m, peaks, peak);
  }
  set(m, object, "peaks", peaks);
  return object;
}

static json_t *spectra(struct maker *m, const struct comparison *c, const struct cmp_run *run) {
  json_t *array = json_array();
  for (size_t k = 0; k < c->settings->compare.n_spectra; k++) add(m, array, spectrum(m, c, run, k));
  return array;
}

/* Medians of what the run says of its noise and momenta. */
static json_t *diagnostics(struct maker *m, const struct comparison *c, const struct cmp_data *d) {
  json_t *object = json_object(), *medians = json_object();
  const double from = cmp_comparison_settled(c);
  set(m, object, "from", number(from));
  for (size_t k = 0; k < d->n_diagnostics; k++) {
    const struct cmp_signal s = cmp_series_signal(&d->diagnostics[k]);
    set_named(m, medians, d->diagnostics[k].name, cmp_signal_median(&s, from).value);
  }
  set(m, object, "medians", medians);
  return object;
}

static json_t *run_object(struct maker *m, const struct comparison *c, const struct cmp_run *run) {
  json_t *object = provenance(m, c, run), *evolution = json_object(), *jets = json_array();
  const struct cmp_evolution *e = &run->evolution;
  set(m, object, "health", health(m, &run->health));
  set(m, object, "noise_floor", number(run->noise));
  if (run != &c->ref) {
    set(m, object, "of_other_water", json_boolean(run->foreign));
    set_value(m, object, "within_one_spacing_until", &run->agreement);
    set_value(m, object, "largest_relative_distance", &run->off);
    set(m, evolution, "t_star", numbers(m, e->t, e->n));
    for (size_t k = 0; k < CMP_N_MEASURES; k++)
      if (e->value[k]) set(m, evolution, cmp_measures[k].name, numbers(m, e->value[k], e->n));
    set(m, object, "against_time", evolution);
    for (size_t k = 0; k < c->n_times; k++) {
      const struct cmp_at *at = &run->at[k];
      json_t *entry = json_object();
      set(m, entry, "t_star_asked", number(c->times[k]));
      set(m, entry, "t_star", number(at->t));
      set(m, entry, "t_star_reference", number(at->ref_t));
      set(m, entry, "largest_distance_at", point(m, at->where));
      set(m, entry, "jet",
          at->output == SIZE_MAX ? json_null() : jet(m, &run->data.jet[at->output]));
      set(m, entry, "jet_reference",
          at->ref_output == SIZE_MAX ? json_null() : jet(m, &c->ref.data.jet[at->ref_output]));
      add(m, jets, entry);
    }
    set(m, object, "at_times", jets);
  } else {
    json_decref(evolution);
    json_decref(jets);
  }
  if (run->data.file->coarser.ratio > 0)
    set(m, object, "error_bars", error_bars(m, c, run->data.file));
  set(m, object, "energy_budget", budget(m, c, &run->data));
  set_value(m, object, "budget_closure", &run->closure);
  set_value(m, object, "budget_closure_before_impact", &run->closure_before);
  set_value(m, object, "volume_change", &run->volume);
  set(m, object, "signals", pairs(m, c, run));
  if (run->data.n_diagnostics) set(m, object, "diagnostics", diagnostics(m, c, &run->data));
  set(m, object, "filters", filters(m, c, run));
  set(m, object, "spectra", spectra(m, c, run));
  return object;
}

static json_t *row_object(struct maker *m, const struct comparison *c, const struct cmp_row *row) {
  static const char *const outcomes[] = {"no limit", "pass", "fail"};
  json_t *object = json_object();
  set(m, object, "measure", text(row->measure->name));
  set(m, object, "units", text(row->measure->units));
  set(m, object, "run", text(c->run[row->run].data.label));
  set(m, object, "t_star", row->time == SIZE_MAX ? json_null() : number(c->times[row->time]));
  set_value(m, object, "value", &row->value);
  if (row->detail[0]) set(m, object, "detail", text(row->detail));
  if (row->left_out) set(m, object, "sensors_left_out", json_integer((json_int_t)row->left_out));
  if (isfinite(row->noise)) set(m, object, "noise_floor", number(row->noise));
  if (isfinite(row->limit)) set(m, object, "limit", number(row->limit));
  set(m, object, "outcome", text(outcomes[row->outcome]));
  return object;
}

static json_t *check_object(struct maker *m, const struct comparison *c,
                            const struct cmp_check *check) {
  json_t *object = json_object();
  set(m, object, "event", text(case_event_names[check->of->event]));
  set(m, object, "of", text(case_event_parts[check->of->part]));
  set(m, object, "units", text(cmp_check_units(check)));
  set(m, object, "run", text(cmp_run_or_ref(c, check->run)->data.label));
  set_value(m, object, "value", &check->value);
  set(m, object, "published", number(check->published));
  set(m, object, "within", number(check->within));
  set(m, object, "source", text(check->of->source));
  set(m, object, "outcome", text(check->passed ? "pass" : "fail"));
  return object;
}

static json_t *scales(struct maker *m, const struct comparison *c) {
  json_t *object = json_object();
  set(m, object, "H_m", number(c->scales.H));
  set(m, object, "time_s", number(c->scales.T));
  set(m, object, "pressure_Pa", number(c->scales.p));
  set(m, object, "E0_J_per_m", number(c->scales.E));
  set(m, object, "energy_at_rest_J_per_m", number(c->scales.rest));
  return object;
}

enum status cmp_json_create(const struct comparison *c, const struct cmp_rows *rows,
                            const struct cmp_convergence *convergence, const char *sentence,
                            json_t **out) {
  struct maker maker = {true}, *m = &maker;
  json_t *root = json_object(), *runs = json_array(), *measures = json_array();
  json_t *window = json_array(), *events = json_array();
  set(m, root, "format", text("plunge report"));
  set(m, root, "program_version", text(PLUNGE_VERSION));
  set(m, root, "program_revision", text(PLUNGE_REVISION));
  set(m, root, "title", text(c->ref.data.file->title));
  set(m, root, "sentence", text(sentence));
  set(m, root, "verdict", text(rows->failed ? "fail" : rows->passed ? "pass" : "no tolerances"));
  set(m, root, "passed", json_integer((json_int_t)rows->passed));
  set(m, root, "failed", json_integer((json_int_t)rows->failed));
  set(m, root, "scales", scales(m, c));
  add(m, window, point(m, c->window.min));
  add(m, window, point(m, c->window.max));
  set(m, root, "window", window);
  set(m, root, "front_depth", number(c->depth));
  set(m, root, "front_runs_to", text((const char *[]){"left", "right", "none"}[c->side]));
  set_value(m, root, "reference_surface_moves_by", &c->motion);
  set(m, root, "reference_believed_until", number(c->until));
  set(m, root, "times", numbers(m, c->times, c->n_times));
  set(m, root, "reference", run_object(m, c, &c->ref));
  for (size_t r = 0; r < c->n_runs; r++) add(m, runs, run_object(m, c, &c->run[r]));
  set(m, root, "runs", runs);
  for (size_t i = 0; i < rows->n; i++) add(m, measures, row_object(m, c, &rows->row[i]));
  set(m, root, "measures", measures);
  for (size_t i = 0; i < rows->checks.n; i++)
    add(m, events, check_object(m, c, &rows->checks.check[i]));
  set(m, root, "events", events);
  set(m, root, "convergence", cmp_convergence_json(m, c, convergence));

  set(m, root, "about", cmp_about_json(m, c));
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

#include "compare/about.h"

#include <stdint.h>

#include "compare/chart.h"
#include "compare/ledger.h"
#include "compare/measure.h"
#include "compare/outline.h"
#include "compare/text.h"

static json_t *measures(struct cmp_json_maker *m) {
  json_t *list = json_array();
  for (size_t k = 0; k < CMP_N_MEASURES; k++)
    cmp_json_add(m, list,
                 json_pack("{s:s,s:s,s:s,s:s}", "name", cmp_measures[k].name, "units",
                           cmp_measures[k].units, "help", cmp_measures[k].help, "section",
                           cmp_section_name(cmp_measure_sections[k])));
  return list;
}

static json_t *limits(struct cmp_json_maker *m) {
  json_t *list = json_array();
  for (size_t k = 0; k < HEALTH_N; k++) {
    const struct health_measure *h = &health_measures[k];
    cmp_json_add(m, list,
                 json_pack("{s:s,s:s,s:o,s:o}", "name", h->name, "help", h->help, "doubtful_above",
                           cmp_json_number(h->doubtful), "failed_above",
                           cmp_json_number(h->failed)));
  }
  return list;
}

static json_t *sources(struct cmp_json_maker *m, const struct result_file *f) {
  json_t *list = json_array();
  for (size_t k = 0; k < f->n_experiments; k++)
    cmp_json_add(m, list,
                 json_pack("{s:o,s:o,s:o}", "label", cmp_json_text(f->experiments[k].label),
                           "target", cmp_json_text(f->experiments[k].target), "source",
                           cmp_json_text(f->experiments[k].source)));
  for (size_t k = 0; k < f->n_profiles; k++)
    cmp_json_add(m, list,
                 json_pack("{s:o,s:s,s:o}", "label", cmp_json_text(f->profiles[k].label), "target",
                           "surface", "source", cmp_json_text(f->profiles[k].source)));
  return list;
}

/* The help of what a file has named itself: that of the first that has it. */
static void help_set(struct cmp_json_maker *m, json_t *helps, const char *name, const char *help) {
  char *key = cmp_text_copy(name);
  if (!key)
    m->ok = false;
  else if (!json_object_get(helps, key))
    cmp_json_set(m, helps, key, cmp_json_text(help));
  free(key);
}

static json_t *statistics(struct cmp_json_maker *m, const struct comparison *c) {
  json_t *helps = json_object();
  for (size_t i = 0; i <= c->n_runs; i++) {
    const struct result_file *f = cmp_run_or_ref(c, i ? i - 1 : SIZE_MAX)->data.file;
    for (size_t k = 0; k < f->n_statistics; k++)
      help_set(m, helps, f->statistics[k].name, f->statistics[k].help);
  }
  return helps;
}

static json_t *diagnostics(struct cmp_json_maker *m, const struct comparison *c) {
  json_t *helps = json_object();
  for (size_t i = 0; i <= c->n_runs; i++) {
    const struct result_file *f = cmp_run_or_ref(c, i ? i - 1 : SIZE_MAX)->data.file;
    for (size_t k = 0; k < f->n_diagnostics; k++)
      help_set(m, helps, f->diagnostics[k].name, f->diagnostics[k].help);
  }
  return helps;
}

static json_t *energy_terms(struct cmp_json_maker *m, const struct comparison *c) {
  struct cmp_ledger ledger;
  json_t *list = json_array();
  if (cmp_ledger_create(c, &ledger) != OK) {
    m->ok = false;
    return list;
  }
  for (size_t k = 0; k < ledger.n; k++)
    cmp_json_add(m, list,
                 json_pack("{s:o,s:o}", "name", cmp_json_text(ledger.term[k].name), "help",
                           cmp_json_text(ledger.term[k].help)));
  cmp_ledger_destroy(&ledger);
  return list;
}

static const char *energy_scale(const struct comparison *c) {
  if (!c->ref.data.file->n_energy) return "ρgH³ since the reference's file has no energies";
  return c->scales.at_rest
             ? "ρgH³ since the reference starts at rest"
             : "the reference's initial mechanical energy relative to its own water at rest";
}

static json_t *method(const struct comparison *c) {
  return json_pack("{s:s,s:f,s:f,s:f,s:f,s:b}", "E0_is", energy_scale(c), "main_surface_fraction",
                   CMP_MAIN_FRACTION, "jet_least_overhang", CMP_JET_LEAST * c->depth, "onset",
                   CMP_ONSET, "largest_shift", CMP_SHIFT_REACH, "window_is_whole", c->window_whole);
}

json_t *cmp_about_json(struct cmp_json_maker *m, const struct comparison *c) {
  json_t *about = json_object();
  cmp_json_set(m, about, "measures", measures(m));
  cmp_json_set(m, about, "health", limits(m));
  cmp_json_set(m, about, "sources", sources(m, c->ref.data.file));
  cmp_json_set(m, about, "statistics", statistics(m, c));
  cmp_json_set(m, about, "diagnostics", diagnostics(m, c));
  cmp_json_set(m, about, "energy_terms", energy_terms(m, c));
  cmp_json_set(m, about, "method", method(c));
  return about;
}

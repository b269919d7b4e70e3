/* Series against time as charts to explore: one of each name, a curve for every run that has it. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/page/packing.h"

/* Keeps of each stretch of rows the lowest and the highest value, in their order; how many. */
static size_t thin(size_t n, const double *v, size_t *kept) {
  const size_t stretch = 2 * ((n + CMP_SERIES_ROWS - 1) / CMP_SERIES_ROWS);
  size_t m = 0;
  for (size_t from = 0; from < n; from += stretch) {
    const size_t to = from + stretch < n ? from + stretch : n;
    size_t low = from, high = from;
    for (size_t i = from; i < to; i++) {
      if (v[i] < v[low]) low = i;
      if (v[i] > v[high]) high = i;
    }
    kept[m++] = low < high ? low : high;
    if (low != high) kept[m++] = low < high ? high : low;
  }
  if (n && kept[m - 1] != n - 1) kept[m++] = n - 1;
  return m;
}

static enum status curve_pack(struct pack *p, const struct cmp_series *s, const double *value,
                              const double *error, json_t *curve) {
  enum status status = OK;
  const double *all[] = {s->t, value, error};
  const size_t planes = error ? 3 : 2;
  double *column[3] = {NULL};
  size_t *kept = NULL, n = s->n;
  json_t *packed = NULL;
  ATTEMPT(array_create(&kept, s->n + 2, "a curve"));
  if (s->n > CMP_SERIES_ROWS) {
    n = thin(s->n, value, kept);
    p->rows_thinned++;
  } else {
    for (size_t i = 0; i < n; i++) kept[i] = i;
  }
  for (size_t k = 0; k < planes; k++) {
    ATTEMPT(array_create(&column[k], n, "a curve"));
    for (size_t i = 0; i < n; i++) column[k][i] = all[k][kept[i]];
  }
  ATTEMPT(cmp_planes_pack(p->packer, n, planes, (const double *const *)column, cmp_fine, &packed));
  cmp_json_set(&p->m, curve, "planes", packed);
done:
  for (size_t k = 0; k < 3; k++) free(column[k]);
  free(kept);
  return status;
}

static enum status curves_add(struct pack *p, json_t *curves, json_int_t run,
                              const char *experiment, const struct cmp_series *s) {
  if (!s || !s->n) return OK;
  json_t *curve = json_object();
  cmp_json_add(&p->m, curves, curve);
  cmp_json_set(&p->m, curve, "run", experiment ? json_null() : json_integer(run));
  cmp_json_set(&p->m, curve, "experiment", experiment ? cmp_json_text(experiment) : json_null());
  cmp_json_set(&p->m, curve, "averaged_over", cmp_json_number(s->average));
  TRY(curve_pack(p, s, s->value, s->error, curve));
  if (!s->raw) return OK;
  json_t *raw = json_object();
  cmp_json_add(&p->m, curves, raw);
  cmp_json_set(&p->m, raw, "run", experiment ? json_null() : json_integer(run));
  cmp_json_set(&p->m, raw, "experiment", experiment ? cmp_json_text(experiment) : json_null());
  cmp_json_set(&p->m, raw, "raw", json_true());
  return curve_pack(p, s, s->raw, NULL, raw);
}

/* The k-th series of a kind of a run; NULL: it has no more. */
typedef const struct cmp_series *series_at(const struct cmp_data *d, size_t k);

static const struct cmp_series *energy_at(const struct cmp_data *d, size_t k) {
  const struct cmp_series *all[] = {&d->mechanical, &d->kinetic, &d->potential,
                                    &d->internal,   &d->closure, &d->removed};
  return k < sizeof all / sizeof *all ? all[k] : NULL;
}

static const struct cmp_series *term_at(const struct cmp_data *d, size_t k) {
  return k < d->n_terms ? &d->terms[k] : NULL;
}

static const struct cmp_series *probe_at(const struct cmp_data *d, size_t k) {
  return k < d->n_probes ? &d->probes[k] : NULL;
}

static const struct cmp_series *gauge_at(const struct cmp_data *d, size_t k) {
  return k < d->n_gauges ? &d->gauges[k] : NULL;
}

static const struct cmp_series *front_at(const struct cmp_data *d, size_t k) {
  return k == 0 ? &d->front : NULL;
}

static const struct cmp_series *diagnostic_at(const struct cmp_data *d, size_t k) {
  return k < d->n_diagnostics ? &d->diagnostics[k] : NULL;
}

static const struct kind {
  const char *section, *what, *unit;
  series_at *at;
} kinds[] = {{"energy", "", "E0", energy_at},        {"energy", "taken by ", "E0", term_at},
             {"pressure", "p at ", "ρgH", probe_at}, {"gauges", "height at ", "H", gauge_at},
             {"front", "", "H", front_at},           {"diagnostics", "", "", diagnostic_at}};

static const struct cmp_series *find(const struct kind *kind, const struct cmp_data *d,
                                     const char *name) {
  const struct cmp_series *s;
  for (size_t k = 0; (s = kind->at(d, k)); k++)
    if (s->n && !strcmp(s->name, name)) return s;
  return NULL;
}

static bool is_zero(const struct cmp_series *s) {
  for (size_t i = 0; i < s->n; i++)
    if (s->value[i] != 0) return false;
  return true;
}

static bool charted(const json_t *charts, const char *title) {
  size_t i;
  const json_t *chart;
  json_array_foreach(charts, i, chart) {
    const char *own = json_string_value(json_object_get(chart, "title"));
    if (own && !strcmp(own, title)) return true;
  }
  return false;
}

static enum status experiments_add(struct pack *p, const char *target, json_t *curves) {
  const struct cmp_data *ref = &p->c->ref.data;
  for (size_t k = 0; k < ref->n_experiments; k++)
    if (!strcmp(ref->file->experiments[k].target, target))
      TRY(curves_add(p, curves, 0, ref->file->experiments[k].label, &ref->experiments[k]));
  return OK;
}

/* One series of every run that has it. */
static enum status chart_pack(struct pack *p, const struct kind *kind, const struct cmp_series *s,
                              json_t *charts) {
  char title[160];
  json_t *chart, *curves;
  snprintf(title, sizeof title, "%s%s", kind->what, s->name);
  if (charted(charts, title)) return OK;
  chart = json_object();
  curves = json_array();
  cmp_json_add(&p->m, charts, chart);
  cmp_json_set(&p->m, chart, "section", json_string(kind->section));
  cmp_json_set(&p->m, chart, "name", cmp_json_text(s->name));
  cmp_json_set(&p->m, chart, "title", cmp_json_text(title));
  cmp_json_set(&p->m, chart, "unit",
               cmp_json_text(*kind->unit ? kind->unit
                             : s->label  ? s->label
                                         : ""));
  cmp_json_set(&p->m, chart, "at",
               kind->at == probe_at || kind->at == gauge_at
                   ? cmp_json_point(&p->m, (double[]){s->x, s->y})
                   : json_null());
  cmp_json_set(&p->m, chart, "curves", curves);
  for (size_t i = 0; i <= p->c->n_runs; i++)
    TRY(curves_add(p, curves, (json_int_t)i, NULL,
                   find(kind, &cmp_packed_run(p, i)->data, s->name)));
  return experiments_add(p, s->name, curves);
}

enum status cmp_charts_pack(struct pack *p, json_t *charts) {
  for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
    for (size_t i = 0; i <= p->c->n_runs; i++) {
      const struct cmp_series *s;
      for (size_t j = 0; (s = kinds[k].at(&cmp_packed_run(p, i)->data, j)); j++)
        if (s->n && !(is_zero(s) && !strcmp(kinds[k].section, "energy")))
          TRY(chart_pack(p, &kinds[k], s, charts));
    }
  return OK;
}

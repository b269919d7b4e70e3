#include "compare/measure.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

const struct measure cmp_measures[] = {
#define X(name, units, when, noise, help) {#name, units, help},
    CMP_MEASURES(X)
#undef X
};

/* What an evaluator sees; it may say in `detail` where it found the worst. */
struct look {
  const struct comparison *c;
  const struct cmp_run *run;
  const struct cmp_at *at; /* NULL for measures of the whole run */
  double t;                /* the comparison time asked for */
  char *detail;
  size_t detail_room;
  size_t left_out;
};

/* ---- surfaces ---- */

static struct cmp_value mean_distance(struct look *l) {
  return l->at->mean;
}

static struct cmp_value relative_distance(struct look *l) {
  if (!cmp_known(&l->at->mean)) return l->at->mean;
  if (!cmp_known(&l->c->motion)) return l->c->motion;
  return cmp_number(l->at->mean.value / l->c->motion.value);
}

static struct cmp_value largest_distance(struct look *l) {
  if (cmp_known(&l->at->largest))
    snprintf(l->detail, l->detail_room, "at x = %.3g, y = %.3g", l->at->where[0], l->at->where[1]);
  return l->at->largest;
}

static struct cmp_value hausdorff(struct look *l) {
  return l->at->hausdorff;
}

static struct cmp_value frechet(struct look *l) {
  return l->at->frechet;
}

static struct cmp_value area(struct look *l) {
  return l->at->area;
}

static struct cmp_value front(struct look *l) {
  if (cmp_known(&l->run->front))
    snprintf(l->detail, l->detail_room, "at t* = %.3g", l->run->front_time.value);
  return l->run->front;
}

/* ---- the jet ---- */

static bool jets(const struct look *l, const struct cmp_jet **a, const struct cmp_jet **b,
                 struct cmp_value *why) {
  if (l->at->output == SIZE_MAX || l->at->ref_output == SIZE_MAX) {
    *why = l->at->mean;
    return false;
  }
  *a = &l->run->data.jet[l->at->output];
  *b = &l->c->ref.data.jet[l->at->ref_output];
  if ((*a)->found && (*b)->found) return true;
  const char *who = (*a)->found ? l->c->ref.data.label : l->run->data.label;
  *why = !(*a)->found && !(*b)->found
             ? cmp_unknown("neither surface overhangs by %.3g H", CMP_JET_LEAST * l->c->depth)
             : cmp_unknown("the surface of %.40s does not overhang by %.3g H", who,
                           CMP_JET_LEAST * l->c->depth);
  return false;
}

static struct cmp_value jet_tip(struct look *l) {
  const struct cmp_jet *a, *b;
  struct cmp_value v;
  if (!jets(l, &a, &b, &v)) return v;
  return cmp_number(hypot(a->tip[0] - b->tip[0], a->tip[1] - b->tip[1]));
}

static struct cmp_value jet_direction(struct look *l) {
  const struct cmp_jet *a, *b;
  struct cmp_value v;
  if (!jets(l, &a, &b, &v)) return v;
  if (!cmp_known(&a->direction)) return a->direction;
  if (!cmp_known(&b->direction)) return b->direction;
  return cmp_number(fabs(remainder(a->direction.value - b->direction.value, 360)));
}

static struct cmp_value jet_thickness(struct look *l) {
  const struct cmp_jet *a, *b;
  struct cmp_value v;
  if (!jets(l, &a, &b, &v)) return v;
  v = cmp_unknown("a jet is shorter than %g H", cmp_jet_station[0]);
  for (size_t k = 0; k < CMP_JET_STATIONS; k++) {
    if (!cmp_known(&a->thickness[k]) || !cmp_known(&b->thickness[k])) continue;
    double d = fabs(a->thickness[k].value - b->thickness[k].value);
    if (cmp_known(&v) && d <= v.value) continue;
    v = cmp_number(d);
    snprintf(l->detail, l->detail_room, "%g H behind the tip", cmp_jet_station[k]);
  }
  return v;
}

static struct cmp_value jet_cavity(struct look *l) {
  const struct cmp_jet *a, *b;
  struct cmp_value v;
  if (!jets(l, &a, &b, &v)) return v;
  if (!cmp_known(&a->cavity)) return a->cavity;
  if (!cmp_known(&b->cavity)) return b->cavity;
  return cmp_number(fabs(a->cavity.value - b->cavity.value));
}

static struct cmp_value instants(struct look *l, const struct cmp_instant *a,
                                 const struct cmp_instant *b) {
  if (!cmp_known(&a->time)) return a->time;
  if (!cmp_known(&b->time)) return b->time;
  snprintf(l->detail, l->detail_room, "%.4g against %.4g, located to +-%.2g", a->time.value,
           b->time.value, a->error + b->error);
  return cmp_number(fabs(a->time.value - b->time.value));
}

static struct cmp_value overturning_time(struct look *l) {
  return instants(l, &l->run->data.overturning, &l->c->ref.data.overturning);
}

static struct cmp_value touchdown_time(struct look *l) {
  return instants(l, &l->run->data.touchdown, &l->c->ref.data.touchdown);
}

/* ---- energy ---- */

static struct cmp_value series_at(const struct cmp_data *d, const struct cmp_series *s, double t) {
  struct cmp_signal signal = cmp_series_signal(s);
  /* the last row may precede the last output by up to a sampling interval and a step */
  double interval = s->n > 1 ? (s->t[s->n - 1] - s->t[0]) / (double)(s->n - 1) : 0;
  if (s->n && t > s->t[s->n - 1] && t <= s->t[s->n - 1] + 2 * interval + 1e-6) t = s->t[s->n - 1];
  double v = cmp_signal_at(&signal, t);
  if (isfinite(v)) return cmp_number(v);
  if (s->n && t >= s->t[0] && t <= s->t[s->n - 1])
    return cmp_unknown("an energy of %.40s at t* = %.4g is not a number", d->label, t);
  return s->n ? cmp_unknown("%.40s has no energies at t* = %.4g (its last: %.4g)", d->label, t,
                            s->t[s->n - 1])
              : cmp_unknown("%.60s has no energies", d->label);
}

static struct cmp_value difference_at(struct look *l, const struct cmp_series *a,
                                      const struct cmp_series *b) {
  struct cmp_value x = series_at(&l->run->data, a, l->t), y = series_at(&l->c->ref.data, b, l->t);
  if (!cmp_known(&x)) return x;
  if (!cmp_known(&y)) return y;
  return cmp_number(fabs(x.value - y.value));
}

static struct cmp_value kinetic(struct look *l) {
  return difference_at(l, &l->run->data.kinetic, &l->c->ref.data.kinetic);
}

static struct cmp_value potential(struct look *l) {
  return difference_at(l, &l->run->data.potential, &l->c->ref.data.potential);
}

static struct cmp_value mechanical(struct look *l) {
  return difference_at(l, &l->run->data.mechanical, &l->c->ref.data.mechanical);
}

static struct cmp_value decay(struct look *l) {
  const struct cmp_series *s = &l->run->data.mechanical;
  struct cmp_value now = series_at(&l->run->data, s, l->t);
  return cmp_known(&now) ? cmp_number(s->value[0] - now.value) : now;
}

static struct cmp_value budget(struct look *l) {
  return l->run->closure;
}

static struct cmp_value budget_before_impact(struct look *l) {
  return l->run->closure_before;
}

static struct cmp_value volume(struct look *l) {
  return l->run->volume;
}

/* ---- signals ---- */

enum number { RMS, PEAK, PEAK_TIME, ONSET, IMPULSE, SHIFT };

static struct cmp_value apart(const struct cmp_value *a, const struct cmp_value *b) {
  if (!cmp_known(a)) return *a;
  if (!cmp_known(b)) return *b;
  return cmp_number(fabs(a->value - b->value));
}

static struct cmp_value pair_number(const struct cmp_pair *p, enum number which) {
  switch (which) {
  case PEAK:
    return apart(&p->m.a.peak, &p->m.b.peak);
  case PEAK_TIME:
    return apart(&p->m.a.peak_time, &p->m.b.peak_time);
  case ONSET:
    return apart(&p->m.a.onset, &p->m.b.onset);
  case IMPULSE:
    return apart(&p->m.a.impulse, &p->m.b.impulse);
  case SHIFT: {
    struct cmp_value v = p->m.shift;
    if (cmp_known(&v)) v.value = fabs(v.value);
    return v;
  }
  default:
    return p->m.rms;
  }
}

/* "P1, mean over 0.05; without P2 (it never reaches the threshold) and 2 more" */
static void pairs_say(struct look *l, const struct cmp_pair *worst, const char *name,
                      const char *first_out, const struct cmp_value *why) {
  int n = worst->a->average > 0 ? snprintf(l->detail, l->detail_room, "%.36s, mean over %.3g", name,
                                           worst->a->average)
                                : snprintf(l->detail, l->detail_room, "%.58s", name);
  if (!first_out || n < 0 || (size_t)n >= l->detail_room) return;
  n += snprintf(l->detail + n, l->detail_room - (size_t)n, "; without %.30s (%.60s)", first_out,
                why->why);
  if (l->left_out > 1 && (size_t)n < l->detail_room)
    snprintf(l->detail + n, l->detail_room - (size_t)n, " and %zu more", l->left_out - 1);
}

/* The worst over those of the pairs wanted that have such a number; the others are named. When none
 * has, why the first has not. */
static struct cmp_value worst_pair(struct look *l, bool experiment, bool pressure,
                                   enum number which) {
  struct cmp_value worst = {NAN, ""}, why = {NAN, ""};
  const struct cmp_pair *found = NULL;
  const char *name = NULL, *first_out = NULL;
  for (size_t k = 0; k < l->run->n_pairs; k++) {
    const struct cmp_pair *p = &l->run->pairs[k];
    if ((p->experiment != SIZE_MAX) != experiment || (p->quantity == CMP_PRESSURE) != pressure)
      continue;
    struct cmp_value v = pair_number(p, which);
    const char *own = experiment ? p->b->name : p->a->name;
    if (!cmp_known(&v) && !l->left_out++) {
      first_out = own;
      why = v;
    }
    if (!cmp_known(&v) || (found && v.value <= worst.value)) continue;
    worst = v;
    found = p;
    name = own;
  }
  if (found)
    pairs_say(l, found, name, first_out, &why);
  else if (first_out)
    snprintf(l->detail, l->detail_room, "%.58s", first_out);
  else
    why =
        cmp_unknown(experiment ? "no experiment to compare with" : "no such signal in both files");
  return found ? worst : why;
}

static struct cmp_value probe_rms(struct look *l) {
  return worst_pair(l, false, true, RMS);
}

static struct cmp_value probe_peak(struct look *l) {
  return worst_pair(l, false, true, PEAK);
}

static struct cmp_value probe_peak_time(struct look *l) {
  return worst_pair(l, false, true, PEAK_TIME);
}

static struct cmp_value probe_onset(struct look *l) {
  return worst_pair(l, false, true, ONSET);
}

static struct cmp_value probe_impulse(struct look *l) {
  return worst_pair(l, false, true, IMPULSE);
}

static struct cmp_value probe_shift(struct look *l) {
  return worst_pair(l, false, true, SHIFT);
}

static struct cmp_value gauge_rms(struct look *l) {
  return worst_pair(l, false, false, RMS);
}

static struct cmp_value experiment_probe_rms(struct look *l) {
  return worst_pair(l, true, true, RMS);
}

static struct cmp_value experiment_gauge_rms(struct look *l) {
  return worst_pair(l, true, false, RMS);
}

/* ---- the table and the verdict ---- */

enum when { ONCE, AT };
enum noise { NONE, LENGTH, AREA, OVERTURNING, TOUCHDOWN };

static const struct {
  struct cmp_value (*value)(struct look *);
  enum when when;
  enum noise noise;
} evaluators[] = {
#define X(name, units, when, noise, help) {name, when, noise},
    CMP_MEASURES(X)
#undef X
};

static struct cmp_row row_make(const struct comparison *c, size_t m, size_t r, size_t time) {
  const struct cmp_run *run = &c->run[r];
  struct cmp_row row = {.measure = &cmp_measures[m], .run = r, .time = time, .limit = NAN};
  const struct cmp_at *at = time == SIZE_MAX ? NULL : &run->at[time];
  struct look look = {c, run, at, at ? c->times[time] : NAN, row.detail, sizeof row.detail, 0};
  row.value = evaluators[m].value(&look);
  row.left_out = cmp_known(&row.value) ? look.left_out : 0;
  const struct cmp_data *d = &run->data, *ref = &c->ref.data;
  row.noise = evaluators[m].noise == OVERTURNING ? d->overturning.error + ref->overturning.error
              : evaluators[m].noise == TOUCHDOWN ? d->touchdown.error + ref->touchdown.error
              : evaluators[m].noise == LENGTH    ? run->noise
              : evaluators[m].noise == AREA && at != NULL ? at->noise_area
                                                          : NAN;
  return row;
}

static bool tolerance_applies(const struct comparison *c, const struct case_tolerance *t,
                              const struct cmp_row *row) {
  if (isfinite(t->at) && row->time != SIZE_MAX &&
      fabs(t->at / c->scales.T - c->times[row->time]) > 1e-6)
    return false;
  for (size_t k = 0; k < t->n_runs; k++)
    if (!strcmp(c->settings->runs[t->runs[k]].name, c->run[row->run].data.file->run)) return true;
  return !t->n_runs;
}

static void tolerances_apply(const struct comparison *c, struct cmp_rows *rows) {
  for (size_t k = 0; k < c->settings->compare.n_tolerances; k++) {
    const struct case_tolerance *t = &c->settings->compare.tolerances[k];
    bool used = false;
    size_t m = 0;
    while (m < CMP_N_MEASURES && strcmp(t->measure, cmp_measures[m].name)) m++;
    for (size_t i = rows->first[m]; m < CMP_N_MEASURES && i < rows->first[m + 1]; i++) {
      struct cmp_row *row = &rows->row[i];
      if (!tolerance_applies(c, t, row)) continue;
      used = true;
      row->limit = isnan(row->limit) ? t->max : fmin(row->limit, t->max);
    }
    rows->unused += !used;
  }
  for (size_t i = 0; i < rows->n; i++) {
    struct cmp_row *row = &rows->row[i];
    if (isnan(row->limit)) continue;
    row->outcome = row->value.value <= row->limit ? CMP_PASS : CMP_FAIL;
    rows->passed += row->outcome == CMP_PASS;
    rows->failed += row->outcome == CMP_FAIL;
    rows->partial += row->outcome == CMP_PASS && row->left_out;
  }
}

enum status cmp_rows_create(const struct comparison *c, struct cmp_rows *rows) {
  *rows = (struct cmp_rows){0};
  rows->row = calloc(CMP_N_MEASURES * c->n_runs * (c->n_times + 1) + 1, sizeof *rows->row);
  CHECK(rows->row, ERR_MEMORY, "no memory for the table of measures");
  rows->n_times = c->n_times;
  for (size_t m = 0; m < CMP_N_MEASURES; m++) {
    rows->first[m] = rows->n;
    for (size_t r = 0; r < c->n_runs; r++) {
      if (evaluators[m].when == ONCE) {
        rows->row[rows->n++] = row_make(c, m, r, SIZE_MAX);
        continue;
      }
      for (size_t k = 0; k < c->n_times; k++) rows->row[rows->n++] = row_make(c, m, r, k);
    }
  }
  rows->first[CMP_N_MEASURES] = rows->n;
  tolerances_apply(c, rows);
  return OK;
}

void cmp_rows_destroy(struct cmp_rows *rows) {
  if (!rows) return;
  free(rows->row);
  *rows = (struct cmp_rows){0};
}

const struct cmp_row *cmp_rows_find(const struct cmp_rows *rows, const char *measure, size_t run,
                                    size_t time) {
  for (size_t m = 0; m < CMP_N_MEASURES; m++) {
    bool once = evaluators[m].when == ONCE;
    if (strcmp(cmp_measures[m].name, measure)) continue;
    if (once != (time == SIZE_MAX)) return NULL;
    size_t i = rows->first[m] + (once ? run : run * rows->n_times + time);
    return i < rows->first[m + 1] ? &rows->row[i] : NULL;
  }
  return NULL;
}

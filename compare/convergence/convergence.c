#include "compare/convergence/convergence.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/chart.h"
#include "compare/convergence/groups.h"
#include "compare/convergence/numbers.h"
#include "compare/measures/look.h"

struct filler {
  const struct comparison *c;
  const struct cmp_rows *rows;
  struct cmp_group *g;
  size_t room;
};

/* ---- rows ---- */

static void row_destroy(struct cmp_row_of_group *row) {
  free(row->value);
  free(row->known_to);
  free(row->error);
  free(row->triple);
}

/* A row to fill, behind those that there are. */
static enum status row_begin(struct filler *m, const char *name, const char *units,
                             struct cmp_row_of_group **row) {
  struct cmp_group *g = m->g;
  TRY(array_grow(&g->row, &m->room, g->n_rows + 1, "rows of a group"));
  *row = &g->row[g->n_rows];
  **row = (struct cmp_row_of_group){.name = name, .units = units, .time = SIZE_MAX};
  g->n_rows++;
  TRY(array_create(&(*row)->value, g->n, "values"));
  TRY(array_create(&(*row)->known_to, g->n, "values"));
  TRY(array_create(&(*row)->error, g->n, "errors"));
  return array_create(&(*row)->triple, g->n, "triples of values");
}

static void triples_take(const struct cmp_group *g, struct cmp_row_of_group *row) {
  size_t last[3], known = 0;
  for (size_t i = 0; i < g->n; i++) {
    if (!cmp_known(&row->value[i])) continue;
    last[0] = known > 1 ? last[1] : i;
    last[1] = known > 0 ? last[2] : i;
    last[2] = i;
    if (++known < 3) continue;
    struct cmp_neighbours *t = &row->triple[row->n_triples++];
    double h[3], f[3], known_to[3];
    for (int k = 0; k < 3; k++) {
      t->member[k] = last[k];
      h[k] = g->spacing[last[k]];
      f[k] = row->value[last[k]].value;
      known_to[k] = row->known_to[last[k]];
    }
    t->triple = cmp_triple_of(h, f, known_to);
  }
}

/* Takes the row, or forgets it when no run but the reference has a value. */
static void row_end(struct filler *m, struct cmp_row_of_group *row) {
  struct cmp_group *g = m->g;
  size_t known = 0;
  for (size_t i = 0; i < g->n; i++) known += cmp_known(&row->value[i]) && g->member[i] != SIZE_MAX;
  if (known) {
    triples_take(g, row);
    return;
  }
  row_destroy(row);
  g->n_rows--;
}

static void errors_from(const struct cmp_group *g, struct cmp_row_of_group *row,
                        const struct cmp_value *reference) {
  for (size_t i = 0; i < g->n; i++) row->error[i] = fabs(row->value[i].value - reference->value);
}

/* ---- measures ---- */

static struct cmp_value reference_measure(const struct comparison *c, size_t measure, size_t time) {
  char detail[192] = "";
  struct cmp_look look = {.c = c,
                          .run = &c->ref,
                          .t = time == SIZE_MAX ? NAN : c->times[time],
                          .detail = detail,
                          .detail_room = sizeof detail};
  switch (cmp_measure_kind(measure)) {
  case CMP_OF_DIFFERENCE:
    return cmp_number(0);
  case CMP_OF_DEFECT:
  case CMP_OF_OWN:
    return cmp_measure_take(measure, &look);
  case CMP_OF_MEASURED:
    return cmp_unknown("the reference is not measured by it");
  }
  return cmp_unknown("no such measure");
}

static enum status measure_row(struct filler *m, size_t measure, size_t time) {
  const struct cmp_group *g = m->g;
  struct cmp_row_of_group *row;
  const struct cmp_value reference = reference_measure(m->c, measure, time);
  const enum cmp_measure_kind of = cmp_measure_kind(measure);
  TRY(row_begin(m, cmp_measures[measure].name, cmp_measures[measure].units, &row));
  row->section = cmp_measure_sections[measure];
  row->time = time;
  row->is_difference = of == CMP_OF_DIFFERENCE || of == CMP_OF_DEFECT;
  for (size_t i = 0; i < g->n; i++) {
    row->value[i] = reference;
    row->known_to[i] = cmp_measure_known_to(m->c, g->member[i], measure);
    if (g->member[i] != SIZE_MAX)
      row->value[i] = cmp_rows_find(m->rows, measure, g->member[i], time)->value;
    row->error[i] = row->is_difference ? fabs(row->value[i].value) : NAN;
  }
  if (of == CMP_OF_OWN) errors_from(g, row, &reference);
  row_end(m, row);
  return OK;
}

static enum status measures_add(struct filler *m) {
  for (size_t k = 0; k < CMP_N_MEASURES; k++) {
    if (!cmp_measure_at_times(k)) {
      TRY(measure_row(m, k, SIZE_MAX));
      continue;
    }
    for (size_t t = 0; t < m->c->n_times; t++) TRY(measure_row(m, k, t));
  }
  return OK;
}

/* ---- numbers of the runs ---- */

static enum status numbers_add(struct filler *m) {
  const struct cmp_group *g = m->g;
  for (size_t k = 0; k < CMP_N_NUMBERS; k++)
    for (size_t t = 0; t < m->c->n_times; t++) {
      const struct cmp_number *n = &cmp_numbers[k];
      struct cmp_row_of_group *row;
      TRY(row_begin(m, n->name, n->units, &row));
      row->section = n->section;
      row->time = t;
      for (size_t i = 0; i < g->n; i++) row->value[i] = n->value(m->c, g->member[i], t);
      const struct cmp_value reference = n->value(m->c, SIZE_MAX, t);
      errors_from(g, row, &reference);
      row_end(m, row);
    }
  return OK;
}

static enum status events_add(struct filler *m) {
  static const char *const names[CASE_N_EVENT_PARTS] = {"event_time", "event_x", "event_y"};
  const struct cmp_group *g = m->g;
  for (int event = 0; event < CASE_N_EVENTS; event++)
    for (int part = 0; part < CASE_N_EVENT_PARTS; part++) {
      struct cmp_row_of_group *row;
      TRY(row_begin(m, names[part], part == CASE_EVENT_time ? "sqrt(H/g)" : "H", &row));
      row->of = case_event_names[event];
      row->section = CMP_SECTION_JET;
      for (size_t i = 0; i < g->n; i++) {
        row->value[i] = cmp_event_number(m->c, g->member[i], event, part);
        row->known_to[i] = cmp_event_known_to(m->c, g->member[i], event, part);
      }
      const struct cmp_value reference = cmp_event_number(m->c, SIZE_MAX, event, part);
      errors_from(g, row, &reference);
      row_end(m, row);
    }
  return OK;
}

/* ---- signals ---- */

enum signal { PROBE, GAUGE };

static const struct cmp_series *series_of(const struct comparison *c, size_t member,
                                          enum signal kind, const char *name) {
  const struct cmp_data *d = &cmp_run_or_ref(c, member)->data;
  return kind == PROBE ? cmp_series_find(d->probes, d->n_probes, name)
                       : cmp_series_find(d->gauges, d->n_gauges, name);
}

static void range_meet(const struct cmp_series *s, double *from, double *to) {
  if (!s || !s->n) return;
  *from = fmax(*from, s->t[0]);
  *to = fmin(*to, s->t[s->n - 1]);
}

static struct cmp_signal_alone signal_measure(const struct cmp_series *s, double from, double to) {
  const struct cmp_value none = cmp_unknown("the run has no such signal");
  struct cmp_signal_alone m = {none, none, none, none};
  if (!s || !s->n || !(from < to)) return m;
  const struct cmp_signal signal = cmp_series_signal(s);
  cmp_signal_measure(&signal, from, to, CMP_ONSET, &m);
  return m;
}

/* `alone` [n + 1]: of the members, then of the reference. */
static enum status signal_rows(struct filler *m, enum signal kind, const char *of,
                               const struct cmp_signal_alone *alone) {
  static const struct {
    const char *name[2], *units[2];
    size_t offset;
  } kinds[] = {{{"peak_pressure", "highest_level"},
                {"rho g H", "H"},
                offsetof(struct cmp_signal_alone, peak)},
               {{"peak_pressure_time", "highest_level_time"},
                {"sqrt(H/g)", "sqrt(H/g)"},
                offsetof(struct cmp_signal_alone, peak_time)},
               {{"pressure_arrival", "level_arrival"},
                {"sqrt(H/g)", "sqrt(H/g)"},
                offsetof(struct cmp_signal_alone, onset)},
               {{"pressure_impulse", "level_integral"},
                {"rho g H sqrt(H/g)", "H sqrt(H/g)"},
                offsetof(struct cmp_signal_alone, impulse)}};
  const struct cmp_group *g = m->g;
  for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
    struct cmp_row_of_group *row;
    TRY(row_begin(m, kinds[k].name[kind], kinds[k].units[kind], &row));
    row->of = of;
    row->section = kind == PROBE ? CMP_SECTION_PRESSURE : CMP_SECTION_GAUGE;
    const struct cmp_value *reference = NULL;
    for (size_t i = 0; i <= g->n; i++) {
      const struct cmp_value *v =
          (const struct cmp_value *)((const char *)&alone[i] + kinds[k].offset);
      if (i == g->n)
        reference = v;
      else
        row->value[i] = *v;
    }
    errors_from(g, row, reference);
    row_end(m, row);
  }
  return OK;
}

/* Of all signals over the time that the group and the reference share: a run that ends early would
 * else have another integral. */
static enum status signal_add(struct filler *m, enum signal kind, const char *of) {
  const struct cmp_group *g = m->g;
  double from = -INFINITY, to = INFINITY;
  struct cmp_signal_alone *alone;
  TRY(array_create(&alone, g->n + 1, "numbers of signals"));
  for (size_t i = 0; i <= g->n; i++)
    range_meet(series_of(m->c, i < g->n ? g->member[i] : SIZE_MAX, kind, of), &from, &to);
  for (size_t i = 0; i <= g->n; i++)
    alone[i] =
        signal_measure(series_of(m->c, i < g->n ? g->member[i] : SIZE_MAX, kind, of), from, to);
  enum status status = signal_rows(m, kind, of, alone);
  free(alone);
  return status;
}

static enum status signals_add(struct filler *m) {
  const struct cmp_data *d = &cmp_run_or_ref(m->c, m->g->member[0])->data;
  for (size_t k = 0; k < d->n_probes; k++) TRY(signal_add(m, PROBE, d->probes[k].name));
  for (size_t k = 0; k < d->n_gauges; k++) TRY(signal_add(m, GAUGE, d->gauges[k].name));
  return OK;
}

/* ---- all of it ---- */

enum status cmp_convergence_create(const struct comparison *c, const struct cmp_rows *rows,
                                   struct cmp_convergence *v) {
  enum status status;
  ATTEMPT(cmp_groups_find(c, v));
  for (size_t i = 0; i < v->n; i++) {
    struct filler m = {c, rows, &v->group[i], 0};
    ATTEMPT(measures_add(&m));
    ATTEMPT(numbers_add(&m));
    ATTEMPT(events_add(&m));
    ATTEMPT(signals_add(&m));
  }
done:
  if (status != OK) cmp_convergence_destroy(v);
  return status;
}

void cmp_convergence_destroy(struct cmp_convergence *v) {
  for (size_t i = 0; i < v->n; i++) {
    struct cmp_group *g = &v->group[i];
    for (size_t k = 0; k < g->n_rows; k++) row_destroy(&g->row[k]);
    free(g->row);
    free(g->member);
    free(g->spacing);
    free(g->left_out);
    free(g->settings);
  }
  free(v->group);
  *v = (struct cmp_convergence){0};
}

double cmp_member_seconds(const struct comparison *c, size_t member) {
  const struct result_file *f = cmp_run_or_ref(c, member)->data.file;
  return f->n_steps ? f->steps[f->n_steps - 1].wall_time : NAN;
}

double cmp_member_evaluations(const struct comparison *c, size_t member) {
  const struct result_file *f = cmp_run_or_ref(c, member)->data.file;
  return f->n_steps ? f->steps[f->n_steps - 1].evaluations : NAN;
}

/* ---- in words ---- */

const struct cmp_neighbours *cmp_row_finest(const struct cmp_row_of_group *row) {
  return row->n_triples ? &row->triple[row->n_triples - 1] : NULL;
}

/* As many digits as the error bar leaves, and one more. */
static int digits_of(double value, double bar) {
  if (!(bar > 0) || !(fabs(value) > 0)) return 6;
  const double digits = ceil(log10(fabs(value) / bar)) + 2;
  return digits < 3 ? 3 : digits > 12 ? 12 : (int)digits;
}

static int triple_say(const struct cmp_group *g, const struct cmp_row_of_group *row, char *out,
                      size_t room) {
  const struct cmp_neighbours *n = cmp_row_finest(row);
  const struct cmp_triple *t = &n->triple;
  const double finest = row->value[n->member[2]].value;
  const int digits = digits_of(finest, t->bar);
  const bool of_itself = row->is_difference && g->member[n->member[2]] == SIZE_MAX && finest == 0;
  switch (t->trend) {
  case CMP_TREND_monotone:
    return snprintf(out, room, "monotone, order %.3g, limit %.*g, finest %.*g +- %.2g%s", t->order,
                    digits, t->limit, digits, finest, t->bar,
                    of_itself ? ", if all err to one side" : "");
  case CMP_TREND_oscillating:
    return snprintf(out, room, "oscillating, so no order; finest %.*g +- %.2g, half the range",
                    digits, finest, t->bar);
  case CMP_TREND_diverging:
    return snprintf(out, room, "diverging, so neither order nor error bar; finest %.6g", finest);
  case CMP_TREND_constant:
    return snprintf(out, room, "the same for the three finest: %.6g", finest);
  case CMP_TREND_stalled:
    return snprintf(out, room, "the same for the two finest, so no order: %.6g", finest);
  case CMP_TREND_unresolved:
    return snprintf(out, room,
                    "no order: instants are known no better than they differ; finest %.*g +- %.2g",
                    digits, finest, t->bar);
  case CMP_N_TRENDS:
    break;
  }
  return 0;
}

void cmp_row_say(const struct cmp_group *g, const struct cmp_row_of_group *row, char *out,
                 size_t room) {
  size_t known = 0;
  int n;
  for (size_t i = 0; i < g->n; i++) known += cmp_known(&row->value[i]);
  if (row->n_triples)
    n = triple_say(g, row, out, room);
  else
    n = snprintf(out, room, known == 2 ? "two values: an order takes three" : "one value");
  for (size_t k = row->n_triples; k-- > 1 && n > 0 && (size_t)n < room;) {
    const struct cmp_triple *t = &row->triple[k - 1].triple;
    const char *lead = k + 1 == row->n_triples ? "; coarser ones: " : ", ";
    if (t->trend == CMP_TREND_monotone)
      n += snprintf(out + n, room - (size_t)n, "%sorder %.3g", lead, t->order);
    else
      n += snprintf(out + n, room - (size_t)n, "%s%s", lead, cmp_trend_names[t->trend]);
  }
  for (size_t i = 0; i < g->n && n > 0 && (size_t)n < room; i++)
    if (!cmp_known(&row->value[i]))
      n += snprintf(out + n, room - (size_t)n, "; without h = %.3g H (%.110s)", g->spacing[i],
                    row->value[i].why);
}

#include "compare/filters.h"

#include <stdlib.h>
#include <string.h>

#include "common/base/geometry_check.h"
#include "compare/spectrum.h"

/* ---- along a wall ---- */

/* The segment of the walls that a point is nearest to. */
struct segment {
  size_t piece, first;
  double a[2], b[2];
};

static double away_from(const double *a, const double *b, double x, double y) {
  double foot[2];
  geo_segment_foot(a, b, (double[2]){x, y}, foot);
  return hypot(x - foot[0], y - foot[1]);
}

static struct segment segment_of(const struct geo_lines *walls, double x, double y) {
  struct segment s = {0};
  double nearest = INFINITY;
  for (size_t piece = 0; piece < walls->pieces; piece++)
    for (size_t k = walls->first[piece]; k + 1 < walls->first[piece + 1]; k++) {
      const double away = away_from(walls->p[k], walls->p[k + 1], x, y);
      if (away >= nearest) continue;
      nearest = away;
      s = (struct segment){.piece = piece, .first = k};
      memcpy(s.a, walls->p[k], sizeof s.a);
      memcpy(s.b, walls->p[k + 1], sizeof s.b);
    }
  return s;
}

static double along(const struct segment *s, const struct cmp_series *p) {
  const double x = s->b[0] - s->a[0], y = s->b[1] - s->a[1];
  return ((p->x - s->a[0]) * x + (p->y - s->a[1]) * y) / hypot(x, y);
}

void cmp_wall_weights(const struct geo_lines *walls, size_t n, const struct cmp_series *probe,
                      size_t middle, double length, double *weight) {
  const struct segment s = segment_of(walls, probe[middle].x, probe[middle].y);
  const double at = along(&s, &probe[middle]), whole = hypot(s.b[0] - s.a[0], s.b[1] - s.a[1]);
  const double low = fmax(at - length / 2, 0), high = fmin(at + length / 2, whole);
  for (size_t k = 0; k < n; k++) { /* half-way to the nearest on either side that takes part */
    double mine = along(&s, &probe[k]), from = low, to = high;
    weight[k] = 0;
    if (away_from(s.a, s.b, probe[k].x, probe[k].y) > 1e-6 || mine < low - 1e-9 ||
        mine > high + 1e-9)
      continue;
    for (size_t j = 0; j < n; j++) {
      const double its = along(&s, &probe[j]);
      if (j == k || away_from(s.a, s.b, probe[j].x, probe[j].y) > 1e-6 || its < low - 1e-9 ||
          its > high + 1e-9)
        continue;
      if (its < mine) from = fmax(from, (its + mine) / 2);
      if (its > mine) to = fmin(to, (its + mine) / 2);
    }
    weight[k] = (to - from) / (high - low);
  }
}

enum { LEAST_ON_WALL = 3 }; /* less would be the probe's own pressure, or nearly */

static enum status wall_mean(const struct cmp_data *d, size_t probe, double length, double *out,
                             bool *there) {
  const struct cmp_series *mine = &d->probes[probe];
  double *weight = calloc(d->n_probes, sizeof *weight);
  CHECK(weight, ERR_MEMORY, "no memory for the mean over %zu probes", d->n_probes);
  cmp_wall_weights(&d->walls, d->n_probes, d->probes, probe, length, weight);
  size_t n = 0;
  for (size_t k = 0; k < d->n_probes; k++) n += weight[k] > 0;
  *there = n >= LEAST_ON_WALL;
  for (size_t i = 0; i < mine->n; i++) out[i] = 0;
  for (size_t k = 0; k < d->n_probes; k++) {
    const struct cmp_signal its = cmp_series_raw(&d->probes[k]);
    for (size_t i = 0; weight[k] > 0 && i < mine->n; i++)
      out[i] += weight[k] * cmp_signal_at(&its, mine->t[i]);
  }
  free(weight);
  return OK;
}

/* ---- of a probe ---- */

static enum status filter(const struct cmp_data *d, size_t probe, const struct case_filter *f,
                          double T, double H, double *out, bool *there) {
  const struct cmp_signal raw = cmp_series_raw(&d->probes[probe]);
  switch (f->kind) {
  case CASE_FILTER_low_pass:
    return cmp_signal_low_pass(&raw, f->period / T, out);
  case CASE_FILTER_wall:
    return wall_mean(d, probe, f->length / H, out, there);
  case CASE_FILTER_impulse:
    cmp_signal_integrate(&raw, out);
    return OK;
  }
  __builtin_unreachable();
}

/* rms of the difference, trapezoidal. */
static struct cmp_value rms_between(const struct cmp_series *s) {
  double sum = 0;
  for (size_t i = 1; i < s->n; i++) {
    const double a = s->value[i - 1] - s->raw[i - 1], b = s->value[i] - s->raw[i];
    sum += (s->t[i] - s->t[i - 1]) * (a * a + b * b) / 2;
  }
  return s->n > 1 ? cmp_number(sqrt(sum / (s->t[s->n - 1] - s->t[0]))) : cmp_unknown("no rows");
}

static enum status series_copy(const struct cmp_series *from, struct cmp_series *to) {
  const size_t n = from->n;
  *to = *from;
  to->average = 0;
  to->t = malloc((n + 1) * sizeof *to->t);
  to->value = malloc((n + 1) * sizeof *to->value);
  to->raw = malloc((n + 1) * sizeof *to->raw);
  CHECK(to->t && to->value && to->raw, ERR_MEMORY, "no memory for a series of %zu rows", n);
  memcpy(to->t, from->t, n * sizeof *to->t);
  memcpy(to->raw, from->raw ? from->raw : from->value, n * sizeof *to->raw);
  return OK;
}

static enum status take(const struct cmp_data *d, size_t probe, double T, double H,
                        double threshold, struct cmp_filtered *out) {
  const bool impulse = out->filter->kind == CASE_FILTER_impulse;
  struct cmp_series *s = &out->series;
  if (d->probes[probe].n < 4) return OK;
  TRY(series_copy(&d->probes[probe], s));
  bool there = true;
  TRY(filter(d, probe, out->filter, T, H, s->value, &there));
  if (!there) s->n = 0;
  if (!there) return OK;
  const struct cmp_signal after = cmp_series_signal(s), before = cmp_series_raw(s);
  cmp_signal_measure(&before, s->t[0], s->t[s->n - 1], threshold, &out->before);
  cmp_signal_measure(&after, s->t[0], s->t[s->n - 1], threshold, &out->after);
  out->taken = impulse ? cmp_unknown("an impulse is no pressure") : rms_between(s);
  if (!impulse) return OK;
  free(s->raw); /* of other units */
  s->raw = NULL;
  return OK;
}

enum status cmp_filters_take(const struct case_file *settings, const struct cmp_data *d, double T,
                             double H, double threshold, struct cmp_filtered **out) {
  const size_t n = settings->compare.n_filters;
  *out = calloc(n + 1, sizeof **out);
  CHECK(*out, ERR_MEMORY, "no memory for %zu filters", n);
  for (size_t k = 0; k < n; k++) {
    struct cmp_filtered *f = &(*out)[k];
    f->filter = &settings->compare.filters[k];
    f->units = f->filter->kind == CASE_FILTER_impulse ? "rho g H sqrt(H/g)" : "rho g H";
    const char *name = settings->probes[f->filter->probe].name;
    const struct cmp_series *probe = cmp_series_find(d->probes, d->n_probes, name);
    if (probe) TRY(take(d, (size_t)(probe - d->probes), T, H, threshold, f));
  }
  return OK;
}

void cmp_filters_destroy(size_t n, struct cmp_filtered *filtered) {
  for (size_t k = 0; filtered && k < n; k++) {
    free(filtered[k].series.t);
    free(filtered[k].series.value);
    free(filtered[k].series.raw);
  }
  free(filtered);
}

void cmp_filter_say(const struct case_filter *f, double T, double H, char *out, size_t room) {
  switch (f->kind) {
  case CASE_FILTER_low_pass:
    snprintf(out, room, "low pass at periods of %.4g √(H/g)", f->period / T);
    return;
  case CASE_FILTER_wall:
    snprintf(out, room, "mean over %.4g H of the wall", f->length / H);
    return;
  case CASE_FILTER_impulse:
    snprintf(out, room, "impulse ∫ p dt");
    return;
  }
  __builtin_unreachable();
}

#include "compare/filters.h"

#include <stdlib.h>
#include <string.h>

#include "common/base/wall_shares.h"
#include "compare/spectrum.h"

/* ---- along a wall ---- */

enum status cmp_wall_weights(const struct geo_lines *walls, size_t n,
                             const struct cmp_series *probe, size_t middle, double length,
                             double *weight, size_t *places) {
  double(*at)[2] = malloc((n + 1) * sizeof *at);
  CHECK(at, ERR_MEMORY, "no memory for the mean over %zu probes", n);
  for (size_t k = 0; k < n; k++) {
    at[k][0] = probe[k].x;
    at[k][1] = probe[k].y;
  }
  *places = geo_wall_shares(walls, n, (const double(*)[2])at, middle, length, weight);
  free(at);
  return OK;
}

static bool has_gaps(const struct cmp_series *s) {
  const struct cmp_signal raw = cmp_series_raw(s);
  for (size_t i = 0; i < raw.n; i++)
    if (!isfinite(raw.value[i])) return true;
  return false;
}

/* What each probe of the weights has at the rows of `mine`, summed up. */
static void wall_sum(const struct cmp_data *d, const struct cmp_series *mine, const double *weight,
                     double *out) {
  for (size_t i = 0; i < mine->n; i++) out[i] = 0;
  for (size_t k = 0; k < d->n_probes; k++) {
    const struct cmp_signal its = cmp_series_raw(&d->probes[k]);
    for (size_t i = 0; weight[k] > 0 && i < mine->n; i++)
      out[i] += weight[k] * cmp_signal_at(&its, mine->t[i]);
  }
}

/* Each filter puts into *why, known before, why it cannot be taken, if so. */
static enum status wall_mean(const struct cmp_data *d, size_t probe, double length, double *out,
                             struct cmp_value *why) {
  enum status status = OK;
  size_t places = 0;
  double *weight = calloc(d->n_probes, sizeof *weight);
  CHECK(weight, ERR_MEMORY, "no memory for the mean over %zu probes", d->n_probes);
  ATTEMPT(cmp_wall_weights(&d->walls, d->n_probes, d->probes, probe, length, weight, &places));
  if (places < CASE_LEAST_ON_WALL)
    *why = cmp_unknown("probes at %zu of the %d places that are needed on the wall", places,
                       CASE_LEAST_ON_WALL);
  for (size_t k = 0; k < d->n_probes; k++)
    if (weight[k] > 0 && has_gaps(&d->probes[k]))
      *why = cmp_unknown("rows of %.60s are without a value", d->probes[k].name);
  if (cmp_known(why)) wall_sum(d, &d->probes[probe], weight, out);
done:
  free(weight);
  return status;
}

/* ---- of a probe ---- */

/* Rows come at steps, near the samples: their mean interval is that of the samples to this. */
static const double NEAR_SAMPLES = 0.01;

static enum status low_pass(const struct cmp_signal *s, double period, double *out,
                            struct cmp_value *why) {
  const double least = 2 * (s->t[s->n - 1] - s->t[0]) / (double)(s->n - 1);
  if (period >= least * (1 - NEAR_SAMPLES)) return cmp_signal_low_pass(s, period, out);
  *why =
      cmp_unknown("a period of %.4g, shorter than two intervals between rows, %.4g", period, least);
  return OK;
}

static enum status filter(const struct cmp_data *d, size_t probe, const struct case_filter *f,
                          double T, double H, double *out, struct cmp_value *why) {
  const struct cmp_signal raw = cmp_series_raw(&d->probes[probe]);
  switch (f->kind) {
  case CASE_FILTER_low_pass:
    return low_pass(&raw, f->period / T, out, why);
  case CASE_FILTER_wall:
    return wall_mean(d, probe, f->length / H, out, why);
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

static struct cmp_signal_alone alone_unknown(struct cmp_value why) {
  return (struct cmp_signal_alone){why, why, why, why};
}

/* The table's numbers; a curve of impulses is no pressure, whose own impulse and arrival they were.
 */
static void measure(double threshold, struct cmp_filtered *out) {
  struct cmp_series *s = &out->series;
  const struct cmp_signal after = cmp_series_signal(s);
  cmp_signal_measure(&after, s->t[0], s->t[s->n - 1], threshold, &out->after);
  if (out->filter->kind != CASE_FILTER_impulse) {
    out->taken = rms_between(s);
    return;
  }
  out->taken = out->after.impulse = out->after.onset = cmp_unknown("an impulse is no pressure");
  free(s->raw); /* of other units */
  s->raw = NULL;
}

static enum status take(const struct cmp_data *d, size_t probe, double T, double H,
                        double threshold, struct cmp_filtered *out) {
  enum { LEAST_ROWS = 4 };
  const struct cmp_signal before = cmp_series_raw(&d->probes[probe]);
  struct cmp_series *s = &out->series;
  struct cmp_value why = cmp_number(0);
  if (before.n)
    cmp_signal_measure(&before, before.t[0], before.t[before.n - 1], threshold, &out->before);
  TRY(series_copy(&d->probes[probe], s));
  if (before.n < LEAST_ROWS)
    why = cmp_unknown("%zu rows, where at least %d are needed", before.n, LEAST_ROWS);
  else if (has_gaps(&d->probes[probe]))
    why = cmp_unknown("rows of the series are without a value");
  else
    TRY(filter(d, probe, out->filter, T, H, s->value, &why));
  if (cmp_known(&why)) {
    measure(threshold, out);
    return OK;
  }
  s->n = 0;
  out->after = alone_unknown(why);
  out->taken = why;
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
    f->probe = settings->probes[f->filter->probe].name;
    f->units = f->filter->kind == CASE_FILTER_impulse ? "rho g H sqrt(H/g)" : "rho g H";
    f->taken = cmp_unknown("the run has no such probe");
    f->before = f->after = alone_unknown(f->taken);
    const struct cmp_series *probe = cmp_series_find(d->probes, d->n_probes, f->probe);
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

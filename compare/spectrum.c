#include "compare/spectrum.h"

#include <fftw3.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

enum { LEAST_ROWS = 16 };
static const double EVEN = 1e-6;   /* intervals this close to each other, relative, are the same */
static const double SAME = 1e-9;   /* times this close, relative, are the same */
static const double LOWEST = 0.05; /* of the highest peak: a Hann window's side lobes have 0.027 */

/* ---- even samples ---- */

static bool is_even(const struct cmp_signal *s) {
  const double step = (s->t[s->n - 1] - s->t[0]) / (double)(s->n - 1);
  for (size_t i = 0; i + 1 < s->n; i++)
    if (fabs(s->t[i + 1] - s->t[i] - step) > EVEN * step) return false;
  return true;
}

/* The cubic through four rows, row - 1 to row + 2 (at an end: the four there), at t. Of a sine of w
 * it misses less than (w dt)^4/43, where a line misses (w dt)^2/8. */
static double cubic_at(const struct cmp_signal *s, size_t row, double t) {
  size_t first = row > 0 ? row - 1 : 0;
  if (first + 4 > s->n) first = s->n - 4;
  double sum = 0;
  for (size_t i = first; i < first + 4; i++) {
    double part = s->value[i];
    for (size_t j = first; j < first + 4; j++)
      if (j != i) part *= (t - s->t[j]) / (s->t[i] - s->t[j]);
    sum += part;
  }
  return sum;
}

/* The signal at n instants that are `step` apart, from t0 on. */
static void resample(const struct cmp_signal *s, double t0, double step, size_t n, double *out) {
  size_t row = 0;
  for (size_t i = 0; i < n; i++) {
    const double t = t0 + (double)i * step;
    while (row + 2 < s->n && s->t[row + 1] <= t) row++;
    out[i] = cubic_at(s, row, t);
  }
}

/* As many even samples as there are rows, between the first and the last. */
static void even_samples(const struct cmp_signal *s, double *out) {
  if (is_even(s)) {
    memcpy(out, s->value, s->n * sizeof *out);
    return;
  }
  resample(s, s->t[0], (s->t[s->n - 1] - s->t[0]) / (double)(s->n - 1), s->n, out);
  out[s->n - 1] = s->value[s->n - 1];
}

/* The longest stretch of rows within [from, to] without a gap. */
static struct cmp_signal stretch_of(const struct cmp_signal *s, double from, double to) {
  size_t best = 0, length = 0, first = 0;
  for (size_t i = 0; i <= s->n; i++) {
    const bool inside = i < s->n && s->t[i] >= from * (1 - SAME) && s->t[i] <= to * (1 + SAME) &&
                        isfinite(s->value[i]);
    if (inside) continue;
    if (i - first > length) {
      best = first;
      length = i - first;
    }
    first = i + 1;
  }
  return (struct cmp_signal){length, s->t + best, s->value + best};
}

/* ---- the spectrum ---- */

/* The window, periodic; its sum is n/2, that of its squares 3 n/8. */
static double hann(size_t i, size_t n) {
  return 0.5 - 0.5 * cos(2 * M_PI * (double)i / (double)n);
}

static double weighted_mean(const double *x, size_t n) {
  double sum = 0;
  for (size_t i = 0; i < n; i++) sum += hann(i, n) * x[i];
  return sum / (0.5 * (double)n);
}

/* |X_k| of the windowed samples, which are lost. */
static enum status transform(double *x, size_t n, double *magnitude) {
  fftw_complex *X = fftw_malloc((n / 2 + 1) * sizeof *X);
  fftw_plan plan = X ? fftw_plan_dft_r2c_1d((int)n, x, X, FFTW_ESTIMATE) : NULL;
  if (plan) fftw_execute(plan);
  for (size_t k = 0; plan && k <= n / 2; k++) magnitude[k] = hypot(X[k][0], X[k][1]);
  const bool done = plan != NULL;
  if (plan) fftw_destroy_plan(plan);
  fftw_free(X);
  CHECK(done, ERR_MEMORY, "no memory for the spectrum of %zu samples", n);
  return OK;
}

/* A real signal's waves are in two bins each, but for the constant and the one of period 2. */
static double sides(size_t k, size_t n) {
  return k == 0 || 2 * k == n ? 1 : 2;
}

static void scale_bins(struct cmp_spectrum *s, const double *magnitude) {
  const double n = (double)s->samples, dt = s->interval.value;
  for (size_t k = 0; k < s->n; k++) {
    s->amplitude[k] = sides(k, s->samples) * magnitude[k] / (0.5 * n);
    s->power[k] = sides(k, s->samples) * magnitude[k] * magnitude[k] * dt / (0.375 * n);
    s->mean_square += s->power[k] * s->step;
  }
}

/* A sine d bins off bin k has, through this window, the amplitude sinc(d)/(1 - d^2) there, and the
 * ratio of the higher neighbour's to it is (1 + d)/(2 - d) (Grandke 1983). */
static struct cmp_peak peak_at(const struct cmp_spectrum *s, size_t k) {
  const double *a = s->amplitude;
  const double side = a[k + 1] > a[k - 1] ? 1 : -1, ratio = fmax(a[k + 1], a[k - 1]) / a[k];
  const double d = fmax((2 * ratio - 1) / (ratio + 1), 0);
  const double seen = d > 1e-9 ? sin(M_PI * d) / (M_PI * d * (1 - d * d)) : 1;
  return (struct cmp_peak){((double)k + side * d) * s->step, a[k] / seen};
}

static int higher_first(const void *a, const void *b) {
  const double x = ((const struct cmp_peak *)a)->amplitude;
  const double y = ((const struct cmp_peak *)b)->amplitude;
  return x < y ? 1 : x > y ? -1 : 0;
}

/* Keeps the list sorted: what falls off its end is lower than all that stay. */
static void peak_keep(struct cmp_spectrum *s, struct cmp_peak peak, size_t most) {
  if (s->n_peaks == most && peak.amplitude <= s->peak[most - 1].amplitude) return;
  if (s->n_peaks < most) s->n_peaks++;
  s->peak[s->n_peaks - 1] = peak;
  qsort(s->peak, s->n_peaks, sizeof *s->peak, higher_first);
}

/* Of the first bins, the mean's leakage is a part. */
static void peaks_find(struct cmp_spectrum *s, size_t most) {
  const double *a = s->amplitude;
  for (size_t k = 2; k + 1 < s->n; k++)
    if (a[k] > a[k - 1] && a[k] >= a[k + 1]) peak_keep(s, peak_at(s, k), most);
  while (s->n_peaks && s->peak[s->n_peaks - 1].amplitude < LOWEST * s->peak[0].amplitude)
    s->n_peaks--;
}

static enum status analyse(const struct cmp_signal *rows, size_t peaks, double *x,
                           double *magnitude, struct cmp_spectrum *out) {
  const size_t n = rows->n;
  even_samples(rows, x);
  out->mean = weighted_mean(x, n);
  for (size_t i = 0; i < n; i++) x[i] = hann(i, n) * (x[i] - out->mean);
  TRY(transform(x, n, magnitude));
  scale_bins(out, magnitude);
  peaks_find(out, peaks);
  return OK;
}

/* Why there is no spectrum of the stretch. */
static struct cmp_value too_few(const struct cmp_signal *s, const struct cmp_signal *stretch) {
  bool any = !s->n;
  for (size_t i = 0; i < s->n; i++) any = any || isfinite(s->value[i]);
  if (!any) return cmp_unknown("the series holds no value (dry)");
  return stretch->n > INT_MAX
             ? cmp_unknown("%zu rows, where at most %d can be taken", stretch->n, INT_MAX)
             : cmp_unknown("%zu rows without a gap, where at least %d are needed", stretch->n,
                           LEAST_ROWS);
}

enum status cmp_spectrum_create(const struct cmp_signal *s, double from, double to, size_t peaks,
                                struct cmp_spectrum *out) {
  const struct cmp_signal rows = stretch_of(s, from, to);
  const size_t n = rows.n;
  *out = (struct cmp_spectrum){.samples = n};
  if (n < LEAST_ROWS || n > INT_MAX) {
    out->interval = too_few(s, &rows);
    return OK;
  }
  out->from = rows.t[0];
  out->to = rows.t[n - 1];
  out->resampled = !is_even(&rows);
  out->interval = cmp_number((out->to - out->from) / (double)(n - 1));
  out->step = 1 / ((double)n * out->interval.value);
  out->n = n / 2 + 1;
  out->amplitude = calloc(out->n, sizeof *out->amplitude);
  out->power = calloc(out->n, sizeof *out->power);
  double *x = fftw_malloc(n * sizeof *x), *magnitude = fftw_malloc(out->n * sizeof *magnitude);
  enum status status = out->amplitude && out->power && x && magnitude
                           ? analyse(&rows, peaks, x, magnitude, out)
                           : status_raise(ERR_MEMORY, "no memory for a spectrum of %zu rows", n);
  fftw_free(x);
  fftw_free(magnitude);
  return status;
}

void cmp_spectrum_destroy(struct cmp_spectrum *s) {
  free(s->amplitude);
  free(s->power);
}

/* ---- filters ---- */

/* What is left of a wave, by its frequency over that of the cut-off: a sharp edge would ring over
 * all of the signal, and before an impact too; this one's ringing is over in a few periods. */
static double left_of(double f) {
  return f <= 0.5 ? 1 : f >= 1.5 ? 0 : 0.5 - 0.5 * sin(M_PI * (f - 1));
}

/* `n` even samples, x, become what is left of them. */
static enum status cut_cosines(double *x, size_t n, double step, double period) {
  fftw_plan plan = fftw_plan_r2r_1d((int)n, x, x, FFTW_REDFT00, FFTW_ESTIMATE);
  CHECK(plan, ERR_MEMORY, "no memory for a filter of %zu samples", n);
  const double twice = 2 * (double)(n - 1); /* the k-th has the period twice step/k */
  fftw_execute(plan);
  for (size_t k = 0; k < n; k++) x[k] *= left_of((double)k * period / (twice * step)) / twice;
  fftw_execute(plan);
  fftw_destroy_plan(plan);
  return OK;
}

enum status cmp_signal_low_pass(const struct cmp_signal *s, double period, double *out) {
  const size_t n = s->n;
  CHECK(n >= 4 && n <= INT_MAX, ERR_INPUT, "a signal of %zu rows cannot be filtered", n);
  const double step = (s->t[n - 1] - s->t[0]) / (double)(n - 1);
  double *x = fftw_malloc(n * sizeof *x), *t = malloc(n * sizeof *t);
  enum status status = OK;
  if (!x || !t) {
    status = status_raise(ERR_MEMORY, "no memory for a filter of %zu rows", n);
    goto done;
  }
  even_samples(s, x);
  ATTEMPT(cut_cosines(x, n, step, period));
  for (size_t i = 0; i < n; i++) t[i] = s->t[0] + (double)i * step;
  const struct cmp_signal even = {n, t, x};
  const bool same = is_even(s);
  for (size_t i = 0, row = 0; i < n; i++) { /* back to the signal's own rows */
    while (row + 2 < n && t[row + 1] <= s->t[i]) row++;
    out[i] = same ? x[i] : cubic_at(&even, row, s->t[i]);
  }
done:
  fftw_free(x);
  free(t);
  return status;
}

void cmp_signal_integrate(const struct cmp_signal *s, double *out) {
  double sum = 0;
  for (size_t i = 0; i < s->n; i++) {
    if (i) sum += (s->t[i] - s->t[i - 1]) * (s->value[i - 1] + s->value[i]) / 2;
    out[i] = isfinite(s->value[i]) ? sum : NAN;
  }
}

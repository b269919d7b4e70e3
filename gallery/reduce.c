#include "gallery/reduce.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"

/* ---- which points ---- */

/* The next point from i on with x in [a[0], a[1]]; n at the end. A hair of the curve's length
 * beyond an end is in: times are sums of steps. */
static size_t next_in(const struct gallery_curve *c, const double *a, size_t i) {
  const double hair = c->n ? 1e-9 * fabs(c->x[c->n - 1] - c->x[0]) : 0;
  for (; i < c->n; i++)
    if (!isnan(c->y[i]) && c->x[i] >= a[0] - hair && c->x[i] <= a[1] + hair) break;
  return i;
}

#define EACH(i, c, a) size_t i = next_in(c, a, 0); i < (c)->n; i = next_in(c, a, i + 1)

static const double everywhere[2] = {-INFINITY, INFINITY};

static size_t next_number(const struct gallery_curve *c, size_t i) {
  while (i < c->n && isnan(c->y[i])) i++;
  return i;
}

/* ---- single points ---- */

double gallery_reduce_at(const struct gallery_curve *c, const double *a) {
  for (size_t i = 0; i < c->n; i++)
    if (fabs(c->x[i] - a[0]) <= 1e-12 * fmax(1, fabs(a[0]))) return c->y[i];
  for (size_t i = 1; i < c->n; i++)
    if (c->x[i - 1] < a[0] && a[0] < c->x[i])
      return c->y[i - 1] +
             (c->y[i] - c->y[i - 1]) * (a[0] - c->x[i - 1]) / (c->x[i] - c->x[i - 1]);
  return NAN;
}

double gallery_reduce_first(const struct gallery_curve *c, const double *a) {
  (void)a;
  return c->n ? c->y[0] : NAN;
}
double gallery_reduce_last(const struct gallery_curve *c, const double *a) {
  (void)a;
  return c->n ? c->y[c->n - 1] : NAN;
}
double gallery_reduce_start(const struct gallery_curve *c, const double *a) {
  (void)a;
  return c->n ? c->x[0] : NAN;
}
double gallery_reduce_end(const struct gallery_curve *c, const double *a) {
  (void)a;
  return c->n ? c->x[c->n - 1] : NAN;
}
double gallery_reduce_count(const struct gallery_curve *c, const double *a) {
  (void)a;
  return (double)c->n;
}

/* ---- extremes ---- */

static size_t extreme(const struct gallery_curve *c, const double *a, double sign) {
  size_t at = SIZE_MAX;
  for (EACH(i, c, a))
    if (at == SIZE_MAX || sign * c->y[i] > sign * c->y[at]) at = i;
  return at;
}

double gallery_reduce_least(const struct gallery_curve *c, const double *a) {
  const size_t i = extreme(c, a, -1);
  return i == SIZE_MAX ? NAN : c->y[i];
}
double gallery_reduce_most(const struct gallery_curve *c, const double *a) {
  const size_t i = extreme(c, a, 1);
  return i == SIZE_MAX ? NAN : c->y[i];
}
double gallery_reduce_where_least(const struct gallery_curve *c, const double *a) {
  const size_t i = extreme(c, a, -1);
  return i == SIZE_MAX ? NAN : c->x[i];
}
double gallery_reduce_where_most(const struct gallery_curve *c, const double *a) {
  const size_t i = extreme(c, a, 1);
  return i == SIZE_MAX ? NAN : c->x[i];
}

/* ---- means ---- */

struct sums {
  double n, x, y, xx, xy, yy;
};

static struct sums sum(const struct gallery_curve *c, const double *a) {
  struct sums s = {0};
  for (EACH(i, c, a)) {
    s.n++;
    s.x += c->x[i];
    s.y += c->y[i];
    s.yy += c->y[i] * c->y[i];
  }
  return s;
}

double gallery_reduce_mean(const struct gallery_curve *c, const double *a) {
  const struct sums s = sum(c, a);
  return s.n > 0 ? s.y / s.n : NAN;
}
double gallery_reduce_rms(const struct gallery_curve *c, const double *a) {
  const struct sums s = sum(c, a);
  return s.n > 0 ? sqrt(s.yy / s.n) : NAN;
}
double gallery_reduce_std(const struct gallery_curve *c, const double *a) {
  const double mean = gallery_reduce_mean(c, a);
  double squares = 0, n = 0;
  for (EACH(i, c, a)) {
    squares += pow(c->y[i] - mean, 2);
    n++;
  }
  return n > 0 ? sqrt(squares / n) : NAN;
}

double gallery_reduce_median(const struct gallery_curve *c, const double *a) {
  double *value = malloc((c->n + 1) * sizeof *value), median = NAN;
  size_t n = 0;
  if (!value) return NAN;
  for (EACH(i, c, a)) value[n++] = c->y[i];
  qsort(value, n, sizeof *value, array_ascending);
  if (n) median = n % 2 ? value[n / 2] : (value[n / 2 - 1] + value[n / 2]) / 2;
  free(value);
  return median;
}

double gallery_reduce_integral(const struct gallery_curve *c, const double *a) {
  double integral = 0;
  size_t last = SIZE_MAX;
  for (EACH(i, c, a)) {
    if (last != SIZE_MAX) integral += (c->y[i] + c->y[last]) / 2 * (c->x[i] - c->x[last]);
    last = i;
  }
  return last == SIZE_MAX ? NAN : integral;
}

/* ---- lines ---- */

double gallery_reduce_crosses(const struct gallery_curve *c, const double *a) {
  size_t last = SIZE_MAX;
  for (size_t i = next_number(c, 0); i < c->n; i = next_number(c, i + 1)) {
    const double now = c->y[i] - a[0], before = last == SIZE_MAX ? now : c->y[last] - a[0];
    if (now == 0) return c->x[i];
    if ((now > 0) != (before > 0))
      return c->x[last] + (c->x[i] - c->x[last]) * before / (before - now);
    last = i;
  }
  return NAN;
}

/* About the middle, so that no digits cancel. */
static double slope_of(const struct gallery_curve *c, const double *a, double (*f)(double)) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (EACH(i, c, a)) {
    n++;
    x += c->x[i];
    y += f(c->y[i]);
  }
  x /= n;
  y /= n;
  for (EACH(i, c, a)) {
    xx += pow(c->x[i] - x, 2);
    xy += (c->x[i] - x) * (f(c->y[i]) - y);
  }
  return n > 1 ? xy / xx : NAN;
}

static double as_it_is(double y) {
  return y;
}
static double log_of_size(double y) {
  return log(fabs(y));
}

double gallery_reduce_slope(const struct gallery_curve *c, const double *a) {
  return slope_of(c, a, as_it_is);
}

double gallery_reduce_growth(const struct gallery_curve *c, const double *a) {
  size_t high = next_number(c, 0);
  while (high < c->n && !(fabs(c->y[high]) > a[1])) high++;
  size_t low = high;
  if (high == c->n) return NAN; /* it never gets there */
  while (low > 0 && !isnan(c->y[low - 1]) && fabs(c->y[low - 1]) > a[0]) low--;
  if (low + 2 > high) return NAN;
  return slope_of(c, (double[]){c->x[low], c->x[high - 1]}, log_of_size);
}

double gallery_reduce_rises(const struct gallery_curve *c, const double *a) {
  double last = -INFINITY, n = 0;
  for (EACH(i, c, a)) {
    if (!(c->y[i] > last)) return 0;
    last = c->y[i];
    n++;
  }
  return n > 1 ? 1 : NAN;
}
double gallery_reduce_falls(const struct gallery_curve *c, const double *a) {
  double last = INFINITY, n = 0;
  for (EACH(i, c, a)) {
    if (!(c->y[i] < last)) return 0;
    last = c->y[i];
    n++;
  }
  return n > 1 ? 1 : NAN;
}

double gallery_reduce_signs(const struct gallery_curve *c, const double *a) {
  (void)a;
  double changes = 0, last = 0;
  if (next_number(c, 0) == c->n) return NAN;
  for (EACH(i, c, everywhere)) {
    if (c->y[i] == 0) continue;
    changes += last * c->y[i] < 0;
    last = c->y[i];
  }
  return changes;
}

double gallery_reduce_beyond(const struct gallery_curve *c, const double *a) {
  double all = 0, above = 0;
  for (EACH(i, c, everywhere)) {
    all += c->y[i] * c->y[i];
    if (c->x[i] > a[0]) above += c->y[i] * c->y[i];
  }
  return all > 0 ? above / all : NAN;
}

/* ---- waves ---- */

struct wave { /* y = a cos(w (x - x0)) + b sin(w (x - x0)) + c, x0 the middle */
  double a, b, c, x0, rms;
};

static void solve3(double m[3][4]) {
  for (int k = 0; k < 3; k++) {
    int top = k;
    for (int i = k + 1; i < 3; i++)
      if (fabs(m[i][k]) > fabs(m[top][k])) top = i;
    for (int j = 0; j < 4; j++) {
      const double swap = m[k][j];
      m[k][j] = m[top][j];
      m[top][j] = swap;
    }
    for (int i = 0; i < 3; i++) {
      const double f = i == k ? 0 : m[i][k] / m[k][k];
      for (int j = k; j < 4; j++) m[i][j] -= f * m[k][j];
    }
  }
}

static struct wave fit(const struct gallery_curve *c, double w, const double *range) {
  double m[3][4] = {{0}}, n = 0, squares = 0;
  struct wave f = {NAN, NAN, NAN, 0, NAN};
  for (EACH(i, c, range)) {
    f.x0 += c->x[i];
    n++;
  }
  if (n < 4) return f;
  f.x0 /= n;
  for (EACH(i, c, range)) {
    const double base[4] = {cos(w * (c->x[i] - f.x0)), sin(w * (c->x[i] - f.x0)), 1, c->y[i]};
    for (int p = 0; p < 3; p++)
      for (int q = 0; q < 4; q++) m[p][q] += base[p] * base[q];
  }
  solve3(m);
  f.a = m[0][3] / m[0][0];
  f.b = m[1][3] / m[1][1];
  f.c = m[2][3] / m[2][2];
  for (EACH(i, c, range)) {
    const double s = w * (c->x[i] - f.x0);
    squares += pow(c->y[i] - f.a * cos(s) - f.b * sin(s) - f.c, 2);
  }
  f.rms = sqrt(squares / n);
  return f;
}

static double wave_rms(const struct gallery_curve *c, double w, const double *range) {
  return fit(c, w, range).rms;
}

/* The same of the a cosh(w x) that fits best. */
static double cosh_rms(const struct gallery_curve *c, double w, const double *range) {
  double cc = 0, cy = 0, squares = 0, n = 0;
  for (EACH(i, c, range)) {
    cc += pow(cosh(w * c->x[i]), 2);
    cy += cosh(w * c->x[i]) * c->y[i];
    n++;
  }
  for (EACH(i, c, range)) squares += pow(c->y[i] - cy / cc * cosh(w * c->x[i]), 2);
  return n < 3 ? NAN : sqrt(squares / n);
}

/* The w of the least residual within a quarter of the guess: the best of many, then by thirds. The
 * best at an end is none: it may be better beyond. */
static double best_near(const struct gallery_curve *c, const double *a,
                        double (*rms)(const struct gallery_curve *, double, const double *)) {
  enum { TRIES = 200, STEPS = 60 };
  int best = -1;
  double least = INFINITY;
  const double step = a[0] / 2 / TRIES;
  for (int k = 0; k <= TRIES; k++) {
    const double r = rms(c, a[0] * 0.75 + k * step, a + 1);
    if (!(r < least)) continue;
    least = r;
    best = k;
  }
  if (best <= 0 || best == TRIES) return NAN;
  double low = a[0] * 0.75 + (best - 1) * step, high = low + 2 * step;
  for (int k = 0; k < STEPS; k++) {
    const double p = low + (high - low) / 3, q = high - (high - low) / 3;
    if (rms(c, p, a + 1) < rms(c, q, a + 1))
      high = q;
    else
      low = p;
  }
  return (low + high) / 2;
}

double gallery_reduce_frequency(const struct gallery_curve *c, const double *a) {
  return best_near(c, a, wave_rms);
}
double gallery_reduce_cosh_rate(const struct gallery_curve *c, const double *a) {
  return best_near(c, a, cosh_rms);
}
double gallery_reduce_amplitude(const struct gallery_curve *c, const double *a) {
  const struct wave f = fit(c, a[0], a + 1);
  return hypot(f.a, f.b);
}
double gallery_reduce_phase(const struct gallery_curve *c, const double *a) {
  const struct wave f = fit(c, a[0], a + 1);
  return remainder(atan2(f.b, f.a) + a[0] * f.x0, 2 * acos(-1.0));
}
double gallery_reduce_residual(const struct gallery_curve *c, const double *a) {
  return fit(c, a[0], a + 1).rms;
}

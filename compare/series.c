#include "compare/series.h"

#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"

/* Index i of the row with t[i] <= t < t[i + 1]; n - 1 at the very end. */
static size_t row_before(const struct cmp_signal *s, double t) {
  size_t low = 0, high = s->n;
  while (high - low > 1) {
    size_t middle = low + (high - low) / 2;
    if (s->t[middle] <= t)
      low = middle;
    else
      high = middle;
  }
  return low;
}

static double value_from(const struct cmp_signal *s, size_t row, double t) {
  if (row + 1 == s->n || s->t[row] == t) return s->value[row];
  double u = (t - s->t[row]) / (s->t[row + 1] - s->t[row]);
  return s->value[row] + u * (s->value[row + 1] - s->value[row]);
}

double cmp_signal_at(const struct cmp_signal *s, double t) {
  if (!s->n || !(t >= s->t[0]) || t > s->t[s->n - 1]) return NAN;
  return value_from(s, row_before(s, t), t);
}

/* The same at instants that increase from one to the next: `row` is the walk's own, from 0. */
static double walk_to(const struct cmp_signal *s, size_t *row, double t) {
  if (!s->n || !(t >= s->t[0]) || t > s->t[s->n - 1]) return NAN;
  while (*row + 1 < s->n && s->t[*row + 1] <= t) ++*row;
  return value_from(s, *row, t);
}

struct prefix { /* of a signal's rows up to each */
  double *area; /* integral from the first row; a gap adds nothing */
  size_t *gaps; /* before this row, [n + 1] */
};

static enum status prefix_create(const struct cmp_signal *s, struct prefix *p) {
  p->area = calloc(s->n + 1, sizeof *p->area);
  p->gaps = calloc(s->n + 1, sizeof *p->gaps);
  CHECK(p->area && p->gaps, ERR_MEMORY, "no memory for the mean of a signal of %zu rows", s->n);
  for (size_t i = 0; i < s->n; i++) {
    double piece = i ? (s->t[i] - s->t[i - 1]) * (s->value[i - 1] + s->value[i]) / 2 : 0;
    p->area[i] = (i ? p->area[i - 1] : 0) + (isfinite(piece) ? piece : 0);
    p->gaps[i + 1] = p->gaps[i] + !isfinite(s->value[i]);
  }
  return OK;
}

static double mean_between(const struct cmp_signal *s, const struct prefix *p, double from,
                           double to) {
  size_t a = row_before(s, from), b = row_before(s, to);
  size_t last = s->t[b] < to ? b + 1 : b; /* the last row that the mean depends on */
  if (p->gaps[last + 1] > p->gaps[a]) return NAN;
  double head = (from - s->t[a]) * (s->value[a] + cmp_signal_at(s, from)) / 2;
  double tail = (to - s->t[b]) * (s->value[b] + cmp_signal_at(s, to)) / 2;
  return (p->area[b] - p->area[a] + tail - head) / (to - from);
}

enum status cmp_signal_average(const struct cmp_signal *s, double over, double *mean) {
  struct prefix p = {0};
  enum status status = prefix_create(s, &p);
  for (size_t i = 0; status == OK && i < s->n; i++) {
    double from = fmax(s->t[i] - over / 2, s->t[0]), to = fmin(s->t[i] + over / 2, s->t[s->n - 1]);
    mean[i] = to > from ? mean_between(s, &p, from, to) : s->value[i];
  }
  free(p.area);
  free(p.gaps);
  return status;
}

struct cmp_value cmp_signal_median(const struct cmp_signal *s, double from) {
  double *v = malloc((s->n + 1) * sizeof *v);
  size_t n = 0;
  if (!v) return cmp_unknown("no memory for %zu rows", s->n);
  for (size_t i = 0; i < s->n; i++)
    if (s->t[i] >= from && isfinite(s->value[i])) v[n++] = s->value[i];
  qsort(v, n, sizeof *v, array_ascending);
  struct cmp_value median = n ? cmp_number((v[(n - 1) / 2] + v[n / 2]) / 2)
                              : cmp_unknown("no rows from t* = %.4g on", from);
  free(v);
  return median;
}

static void peak_find(const struct cmp_signal *s, double from, double to,
                      struct cmp_signal_alone *m) {
  double peak = -INFINITY, time = NAN;
  for (size_t i = 0; i < s->n; i++)
    if (s->t[i] >= from && s->t[i] <= to && s->value[i] > peak) {
      peak = s->value[i];
      time = s->t[i];
    }
  for (int end = 0; end < 2; end++) { /* the ends of the range lie between rows */
    double t = end ? to : from, v = cmp_signal_at(s, t);
    if (v > peak) {
      peak = v;
      time = t;
    }
  }
  m->peak = isfinite(peak) ? cmp_number(peak) : cmp_unknown("no values in the common time range");
  m->peak_time = isfinite(peak) ? cmp_number(time) : m->peak;
}

static double impulse(const struct cmp_signal *s, double from, double to) {
  double sum = 0, t = from, v = cmp_signal_at(s, from);
  for (size_t i = 0; i < s->n; i++) {
    if (s->t[i] <= from) continue;
    double next = fmin(s->t[i], to), w = cmp_signal_at(s, next);
    sum += (next - t) * (v + w) / 2;
    t = next;
    v = w;
    if (next >= to) break;
  }
  return sum;
}

static struct cmp_value onset(const struct cmp_signal *s, double threshold) {
  for (size_t i = 0; i < s->n; i++) {
    if (!(s->value[i] >= threshold)) continue;
    if (i == 0 || !(s->value[i - 1] < threshold)) return cmp_number(s->t[i]);
    double u = (threshold - s->value[i - 1]) / (s->value[i] - s->value[i - 1]);
    return cmp_number(s->t[i - 1] + u * (s->t[i] - s->t[i - 1]));
  }
  return cmp_unknown("it never reaches the threshold");
}

void cmp_signal_measure(const struct cmp_signal *s, double from, double to, double threshold,
                        struct cmp_signal_alone *m) {
  peak_find(s, from, to, m);
  double sum = impulse(s, from, to);
  m->impulse = isfinite(sum) ? cmp_number(sum) : cmp_unknown("the signal has gaps");
  m->onset = onset(s, threshold);
}

/* rms of a(t + shift) - b(t) over [from, to], trapezoidal on `points` instants at which both are
 * there (where both are not, as at a gauge that is still dry, there is nothing to compare); NaN
 * when that is less than four fifths of those at which one is. */
static double rms_shifted(const struct cmp_signal *a, const struct cmp_signal *b, double from,
                          double to, double shift, size_t points) {
  double sum = 0, both = 0, either = 0;
  size_t a_row = 0, b_row = 0;
  for (size_t i = 0; i < points; i++) {
    double t = from + (to - from) * (double)i / (double)(points - 1);
    double x = walk_to(a, &a_row, t + shift), y = walk_to(b, &b_row, t);
    double w = i == 0 || i + 1 == points ? 0.5 : 1;
    if (isfinite(x) || isfinite(y)) either += w;
    if (!isfinite(x - y)) continue;
    sum += w * (x - y) * (x - y);
    both += w;
  }
  return both > 0 && both >= 0.8 * either ? sqrt(sum / both) : NAN;
}

static void best_shift(const struct cmp_signal *a, const struct cmp_signal *b, double reach,
                       struct cmp_signal_pair *pair) {
  enum { COARSE = 100, POINTS = 800 };
  pair->shift = cmp_unknown("the signals share too little time");
  pair->rms_after = pair->shift;
  double step = reach / COARSE, best = 0, least = INFINITY;
  for (int k = -COARSE; k <= COARSE; k++) {
    double r = rms_shifted(a, b, pair->from, pair->to, k * step, POINTS);
    if (r < least || (r == least && abs(k) * step < fabs(best))) {
      least = r;
      best = k * step;
    }
  }
  if (!isfinite(least)) return;
  if (fabs(best) >= reach * (1 - 0.5 / COARSE)) {
    pair->shift = cmp_unknown("no best shift within ±%g", reach);
    pair->rms_after = pair->shift;
    return;
  }
  double low = best - step, high = best + step;
  const double golden = (sqrt(5) - 1) / 2;
  for (int k = 0; k < 25; k++) {
    double u = high - golden * (high - low), v = low + golden * (high - low);
    double fu = rms_shifted(a, b, pair->from, pair->to, u, POINTS);
    double fv = rms_shifted(a, b, pair->from, pair->to, v, POINTS);
    if (fu < fv)
      high = v;
    else
      low = u;
  }
  double refined = (low + high) / 2, r = rms_shifted(a, b, pair->from, pair->to, refined, POINTS);
  if (r < least) { /* else the coarse one, exactly zero for identical signals */
    best = refined;
    least = r;
  }
  pair->shift = cmp_number(best);
  pair->rms_after = cmp_number(least);
}

static bool has_values(const struct cmp_signal *s, double from, double to) {
  for (size_t i = 0; i < s->n; i++)
    if (s->t[i] >= from && s->t[i] <= to && isfinite(s->value[i])) return true;
  return false;
}

/* Why two signals have no rms difference. */
static struct cmp_value gaps_say(const struct cmp_signal *a, const struct cmp_signal *b,
                                 double from, double to) {
  bool mine = has_values(a, from, to), its = has_values(b, from, to);
  if (mine && its) return cmp_unknown("too many gaps in the signals");
  return mine || its ? cmp_unknown("dry in one of the two")
                     : cmp_unknown("dry in both, from first to last");
}

void cmp_signal_compare(const struct cmp_signal *a, const struct cmp_signal *b, double threshold,
                        double reach, struct cmp_signal_pair *pair) {
  memset(pair, 0, sizeof *pair);
  double from = a->n && b->n ? fmax(a->t[0], b->t[0]) : NAN;
  double to = a->n && b->n ? fmin(a->t[a->n - 1], b->t[b->n - 1]) : NAN;
  pair->from = from;
  pair->to = to;
  if (!(to > from)) {
    struct cmp_value none = cmp_unknown("no time in common");
    pair->a = pair->b = (struct cmp_signal_alone){none, none, none, none};
    pair->rms = pair->shift = pair->rms_after = none;
    return;
  }
  cmp_signal_measure(a, from, to, threshold, &pair->a);
  cmp_signal_measure(b, from, to, threshold, &pair->b);
  double r = rms_shifted(a, b, from, to, 0, 4001);
  pair->rms = isfinite(r) ? cmp_number(r) : gaps_say(a, b, from, to);
  best_shift(a, b, reach, pair);
}

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/result/result_differ.h"
#include "common/result/result_hdf.h"
#include "common/result/result_open.h"
#include "common/result/result_when.h"

enum { BLOCK = 65536 }; /* rows that are compared at a time */

hid_t result_diff_turn(struct differ *d, int k) {
  d->turn = k;
  result_blame((size_t)k);
  return d->file[k];
}

const struct tolerance *result_diff_rule(const struct differ *d, double time) {
  return result_tolerance_at(d->n_rules, d->rule, time, d->d->time_scale);
}

enum status result_diff_say(struct result_quantity *q, const char *format, ...) {
  va_list args;
  q->differs = true;
  va_start(args, format);
  const int length = vasprintf(&q->what, format, args);
  va_end(args);
  if (length < 0) q->what = NULL;
  CHECK(q->what, ERR_MEMORY, "no memory for differences");
  return OK;
}

/* ---- numbers ---- */

static double difference_of(double a, double b) {
  const double difference = a == b || (isnan(a) && isnan(b)) ? 0 : fabs(a - b);
  return isnan(difference) ? INFINITY : difference;
}

/* Rows up to `end` are held against one rule. */
struct stretch {
  size_t end;
  const struct tolerance *rule;
};

struct rows {
  size_t n, wide; /* rows that both have; numbers of each */
  struct result_when when;
  size_t n_stretches;
  struct stretch *stretch;    /* [n_stretches], owned */
  struct result_spot largest; /* difference, whatever is allowed */
};

static struct result_used *used_by(const struct differ *d, struct result_quantity *q,
                                   const struct tolerance *rule) {
  const size_t index = (size_t)(rule - d->tolerances->rule);
  size_t k = 0;
  while (k < q->n_used && q->used[k].rule != index) k++;
  if (k == q->n_used) q->used[q->n_used++] = (struct result_used){index, 0};
  return &q->used[k];
}

static double allowed_by(const struct tolerance *rule, const struct result_quantity *q) {
  return rule->absolute + (rule->relative > 0 ? rule->relative * q->scale : 0);
}

static void spot_take(struct result_spot *s, const double *a, const double *b, size_t row,
                      size_t component, double difference) {
  s->value[0] = *a;
  s->value[1] = *b;
  s->row = row;
  s->component = component;
  s->difference = difference;
}

/* n numbers from number `first` on, all of one rule: the largest magnitude and difference. */
static void measure(struct result_quantity *q, struct result_used *used,
                    struct result_spot *largest, const double *a, const double *b, size_t n,
                    size_t first, size_t wide) {
  double scale = q->scale;
  for (size_t i = 0; i < n; i++) {
    if (isfinite(a[i])) scale = fmax(scale, fabs(a[i]));
    if (isfinite(b[i])) scale = fmax(scale, fabs(b[i]));
  }
  q->scale = scale;
  for (size_t i = 0; i < n; i++) {
    if (a[i] == b[i]) continue;
    const double difference = difference_of(a[i], b[i]);
    used->worst = fmax(used->worst, difference);
    if (difference > largest->difference)
      spot_take(largest, &a[i], &b[i], (first + i) / wide, (first + i) % wide, difference);
  }
}

/* The same when it is known what is allowed. */
static void judge(struct result_quantity *q, const struct tolerance *rule, const double *a,
                  const double *b, size_t n, size_t first, size_t wide) {
  const double allowed = allowed_by(rule, q);
  for (size_t i = 0; i < n; i++) {
    if (a[i] == b[i]) continue;
    const double difference = difference_of(a[i], b[i]);
    if (!(difference > allowed)) continue;
    const size_t row = (first + i) / wide, component = (first + i) % wide;
    if (!q->beyond++) {
      spot_take(&q->first, &a[i], &b[i], row, component, difference);
      q->worst = q->first;
      q->allowed = allowed;
    } else if (difference > q->worst.difference) {
      spot_take(&q->worst, &a[i], &b[i], row, component, difference);
      q->allowed = allowed;
    }
  }
}

/* A search stops at the first difference; the others can be one. */
enum pass { SEARCH = 0, MEASURE = 1, JUDGE = 2 };

static void stretches_do(struct differ *d, struct result_quantity *q, struct rows *r, int pass,
                         size_t first, size_t n, double *const rows[2]) {
  size_t k = 0;
  while (k < r->n_stretches && r->stretch[k].end <= first) k++;
  for (size_t at = first; at < first + n && k < r->n_stretches; k++) {
    const size_t end = r->stretch[k].end < first + n ? r->stretch[k].end : first + n;
    const struct tolerance *rule = r->stretch[k].rule;
    const size_t from = (at - first) * r->wide, length = (end - at) * r->wide;
    const double *a = rows[0] + from, *b = rows[1] + from;
    if (rule->ignore) used_by(d, q, rule)->worst = -1;
    if (!rule->ignore && pass & MEASURE)
      measure(q, used_by(d, q, rule), &r->largest, a, b, length, at * r->wide, r->wide);
    if (!rule->ignore && pass & JUDGE) judge(q, rule, a, b, length, at * r->wide, r->wide);
    at = end;
  }
}

/* Whether the rows are the same bit by bit: then nothing else needs to be known of them. */
static bool rows_equal(double *const rows[2], size_t numbers) {
  return !memcmp(rows[0], rows[1], numbers * sizeof **rows);
}

/* Reads the rows of both files in blocks. */
static enum status pass_through(struct differ *d, struct result_quantity *q, struct rows *r,
                                size_t width, int pass, bool *equal) {
  *equal = true;
  for (size_t first = 0; first < r->n && (*equal || pass != SEARCH); first += BLOCK) {
    const size_t n = r->n - first < BLOCK ? r->n - first : BLOCK;
    double *rows[2] = {NULL, NULL};
    enum status status = OK;
    for (int k = 0; k < 2 && status == OK; k++)
      status = hdf_get_rows(result_diff_turn(d, k), q->name, H5T_NATIVE_DOUBLE, width, first, n,
                            &rows[k]);
    if (status == OK && pass == SEARCH) *equal = rows_equal(rows, n * r->wide);
    if (status == OK && pass != SEARCH) stretches_do(d, q, r, pass, first, n, rows);
    free(rows[0]);
    free(rows[1]);
    TRY(status);
  }
  return OK;
}

/* The spots' times and places. */
static void locate(struct differ *d, struct result_quantity *q, const struct result_when *when) {
  struct result_spot *const spot[] = {&q->first, &q->worst};
  if (!q->beyond) q->first = q->worst;
  for (int k = 0; k < 2 && q->worst.difference > 0; k++) {
    spot[k]->time = result_when_at(when, spot[k]->row);
    result_place_read(result_diff_turn(d, 0), q->name, spot[k]->row, spot[k]->place);
  }
}

static bool exceeds(const struct differ *d, const struct result_quantity *q) {
  for (size_t k = 0; k < q->n_used; k++)
    if (q->used[k].worst > 0 &&
        q->used[k].worst > allowed_by(&d->tolerances->rule[q->used[k].rule], q))
      return true;
  return false;
}

/* Whether what is allowed depends on all rows. */
static bool any_relative(const struct rows *r) {
  size_t k = 0;
  while (k < r->n_stretches && !(r->stretch[k].rule->relative > 0)) k++;
  return k < r->n_stretches;
}

static enum status compare_rows(struct differ *d, struct result_quantity *q, struct rows *r,
                                size_t width) {
  const int pass = any_relative(r) ? MEASURE : MEASURE | JUDGE;
  bool equal;
  q->n = r->n * r->wide;
  TRY(pass_through(d, q, r, width, SEARCH, &equal));
  if (equal) return OK;
  TRY(pass_through(d, q, r, width, pass, &equal));
  q->differs = exceeds(d, q) || q->differs;
  if (exceeds(d, q)) {
    if (!(pass & JUDGE)) TRY(pass_through(d, q, r, width, JUDGE, &equal));
  } else if (q->n_used) {
    q->allowed = allowed_by(&d->tolerances->rule[q->used[0].rule], q);
    q->worst = r->largest;
  }
  locate(d, q, &r->when);
  return OK;
}

/* One number of each file, of no time unless it is an event's. */
void result_diff_numbers(struct differ *d, struct result_quantity *q, const double value[2],
                         double time) {
  const struct tolerance *rule = result_diff_rule(d, time);
  q->n = 1;
  q->ignored = rule->ignore;
  if (q->ignored) return;
  measure(q, used_by(d, q, rule), &q->worst, &value[0], &value[1], 1, 0, 1);
  q->allowed = allowed_by(rule, q);
  if (q->worst.difference > 0) judge(q, rule, &value[0], &value[1], 1, 0, 1);
  q->differs = q->beyond > 0;
}

/* ---- which rows are compared with which ---- */

/* How many rows both have: as far as the parts have the same lengths. `gone`: the parts that agree.
 */
static size_t rows_common(const struct result_when w[2], const hsize_t rows[2], size_t *agree) {
  const size_t least = (size_t)(rows[0] < rows[1] ? rows[0] : rows[1]);
  size_t k = 0;
  *agree = 0;
  if (!w[0].n || !w[1].n) return least;
  for (; k < w[0].n && k < w[1].n && w[0].first[k] == w[1].first[k]; k++) {
    const size_t end[2] = {k + 1 < w[0].n ? w[0].first[k + 1] : (size_t)rows[0],
                           k + 1 < w[1].n ? w[1].first[k + 1] : (size_t)rows[1]};
    if (end[0] != end[1]) break;
  }
  *agree = k;
  if (k == w[0].n || k == w[1].n) return least;
  return w[0].first[k] < least ? w[0].first[k] : least;
}

/* The time of the first rows that only one file has and no rule ignores; false when there are none.
 */
static bool rows_left(const struct differ *d, const struct result_when w[2], const hsize_t rows[2],
                      size_t common, size_t agree, double *time) {
  bool left = false;
  *time = NAN;
  for (int k = 0; k < 2; k++) {
    if (rows[k] <= common) continue;
    for (size_t part = agree; part < w[k].n; part++) {
      const struct tolerance *rule = result_diff_rule(d, w[k].time[part]);
      if (rule->ignore) continue;
      *time = fmin(w[k].time[part], *time); /* of a number and NaN the number */
      left = true;
      break;
    }
    if (!w[k].n) left = true;
  }
  return left;
}

/* Which rule each row is held against. */
static enum status stretches_create(const struct differ *d, struct rows *r) {
  const struct result_when *w = &r->when;
  TRY(array_create(&r->stretch, w->n + 1, "rules"));
  const struct tolerance *rule = result_diff_rule(d, w->n ? w->time[0] : NAN);
  for (size_t k = 1; k < w->n; k++) {
    const struct tolerance *next = result_diff_rule(d, w->time[k]);
    if (next == rule) continue;
    r->stretch[r->n_stretches++] = (struct stretch){w->first[k], rule};
    rule = next;
  }
  r->stretch[r->n_stretches++] = (struct stretch){SIZE_MAX, rule};
  return OK;
}

/* ---- a dataset ---- */

enum status result_diff_scalars(struct differ *d, struct result_quantity *q) {
  double value[2];
  struct result_when when;
  for (int k = 0; k < 2; k++)
    TRY(hdf_get_scalar(result_diff_turn(d, k), q->name, H5T_NATIVE_DOUBLE, &value[k]));
  result_when_read(result_diff_turn(d, 0), q->name, 1, &when);
  result_diff_numbers(d, q, value, result_when_at(&when, 0));
  locate(d, q, &when);
  result_when_free(&when);
  return OK;
}

enum status result_diff_tables(struct differ *d, struct result_quantity *q, const hsize_t n[2],
                               size_t width) {
  struct result_when when[2] = {{0}, {0}};
  struct rows rows = {.wide = width ? width : 1};
  enum status status = OK;
  size_t agree;
  double time;
  for (int k = 0; k < 2; k++)
    result_when_read(result_diff_turn(d, k), q->name, (size_t)n[k], &when[k]);
  rows.n = rows_common(when, n, &agree);
  if (rows_left(d, when, n, rows.n, agree, &time)) {
    if (n[0] != n[1])
      ATTEMPT(result_diff_say(q, "%llu rows against %llu", (unsigned long long)n[0],
                              (unsigned long long)n[1]));
    else
      ATTEMPT(result_diff_say(q, "other numbers of rows in an output"));
    q->what_time = time;
  }
  rows.when = when[0];
  ATTEMPT(stretches_create(d, &rows));
  ATTEMPT(compare_rows(d, q, &rows, width));
done:
  free(rows.stretch);
  result_when_free(&when[0]);
  result_when_free(&when[1]);
  return status;
}

/* What a comparison found, on its way from the process that reads, and in the end; and the curves
 * to be shown. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/result/result_carry.h"
#include "common/result/result_differ.h"
#include "common/result/result_hdf.h"
#include "common/result/result_when.h"

/* ---- series to be shown ---- */

static int by_since(const void *a, const void *b) {
  const struct result_quantity *x = *(struct result_quantity *const *)a,
                               *y = *(struct result_quantity *const *)b;
  const double s = result_quantity_since(x), t = result_quantity_since(y);
  if (s != t) return s < t ? -1 : 1;
  return strcmp(x->name, y->name);
}

static enum status curve_read(struct differ *d, const struct result_quantity *q, int k,
                              struct result_curve *curve) {
  struct result_when when;
  double *value = NULL;
  enum status status =
      hdf_get_all(result_diff_turn(d, k), q->name, H5T_NATIVE_DOUBLE, 0, &curve->n, &value);
  curve->value = value;
  if (status != OK) return status;
  result_when_read(d->file[k], q->name, curve->n, &when);
  if (when.n < curve->n) curve->n = when.n;
  curve->t = when.time;
  when.time = NULL;
  result_when_free(&when);
  return OK;
}

enum status result_diff_curves(struct differ *d) {
  struct result_quantity **series = NULL;
  enum status status = OK;
  size_t n = 0;
  TRY(array_create(&series, d->d->n, "series"));
  for (size_t i = 0; i < d->d->n; i++) {
    struct result_quantity *q = &d->d->quantity[i];
    const char *column = strrchr(q->name, '/');
    if (q->differs && q->rank == 1 && q->n && !strncmp(q->name, "series/", 7) &&
        strcmp(column, "/time") && isfinite(result_quantity_since(q)))
      series[n++] = q;
  }
  qsort(series, n, sizeof *series, by_since);
  for (size_t i = 0; i < n && i < d->shown; i++)
    for (int k = 0; k < 2; k++) ATTEMPT(curve_read(d, series[i], k, &series[i]->curve[k]));
done:
  free(series);
  return status;
}

/* ---- from the child to its parent ---- */

static enum status carry_quantity(struct carrier *c, void *element) {
  struct result_quantity *q = element;
  TRY(carry_text(c, &q->name));
  TRY(carry_text(c, &q->units));
  TRY(carry_text(c, &q->what));
  CHECK(q->name && q->units, ERR_INPUT, "a name is missing");
  size_t flags[] = {(size_t)q->rank, q->differs, q->ignored};
  for (int k = 0; k < 3; k++) TRY(carry_number(c, &flags[k]));
  q->rank = (int)(flags[0] % 3);
  q->differs = flags[1] == 1;
  q->ignored = flags[2] == 1;
  TRY(carry_bytes(c, &q->what_time, sizeof q->what_time));
  TRY(carry_number(c, &q->n));
  TRY(carry_number(c, &q->beyond));
  TRY(carry_bytes(c, &q->scale, sizeof q->scale));
  TRY(carry_bytes(c, &q->allowed, sizeof q->allowed));
  TRY(carry_bytes(c, &q->first, sizeof q->first));
  TRY(carry_bytes(c, &q->worst, sizeof q->worst));
  TRY(carry_array(c, &q->n_used, &q->used));
  for (int k = 0; k < 2; k++) {
    struct result_curve *curve = &q->curve[k];
    size_t n = curve->n;
    TRY(carry_array(c, &curve->n, &curve->t));
    TRY(carry_array(c, &n, &curve->value));
    CHECK(n == curve->n, ERR_INPUT, "a series is inconsistent");
  }
  return OK;
}

static enum status carry_kept(struct carrier *c, const struct differ *d, int k) {
  struct result_file **f = &d->d->file[k];
  if (!c->sending) {
    *f = calloc(1, sizeof **f);
    CHECK(*f, ERR_MEMORY, "no memory to read %s", d->d->path[k]);
    (*f)->path = strdup(d->d->path[k]);
    CHECK((*f)->path, ERR_MEMORY, "no memory to read %s", d->d->path[k]);
  }
  return result_carry(c, *f);
}

enum status result_diff_carry(struct carrier *c, void *data) {
  const struct differ *d = data;
  struct result_diff *r = d->d;
  TRY(carry_bytes(c, &r->time_scale, sizeof r->time_scale));
  TRY(carry_number(c, &r->n_same));
  TRY(carry_number(c, &r->n_differ));
  TRY(carry_number(c, &r->n_ignored));
  TRY(carry_bytes(c, r->matched, r->n_rules));
  TRY(carry_each(c, &r->n, &r->quantity, carry_quantity));
  for (size_t i = 0; i < r->n; i++)
    for (size_t k = 0; k < r->quantity[i].n_used; k++)
      CHECK(r->quantity[i].used[k].rule < r->n_rules, ERR_INPUT, "there is no such rule");
  for (int k = 0; k < 2 && d->shown; k++) TRY(carry_kept(c, d, k));
  return OK;
}

/* ---- its end ---- */

void result_diff_forget(struct result_diff *d) {
  for (size_t i = 0; d->quantity && i < d->n; i++)
    for (int k = 0; k < 2; k++) {
      struct result_curve *curve = &d->quantity[i].curve[k];
      free(curve->t);
      free(curve->value);
      *curve = (struct result_curve){0};
    }
  for (int k = 0; k < 2; k++) {
    result_file_destroy(d->file[k]);
    d->file[k] = NULL;
  }
}

void result_diff_destroy(struct result_diff *d) {
  if (!d) return;
  result_diff_forget(d);
  for (size_t i = 0; d->quantity && i < d->n; i++) {
    free(d->quantity[i].name);
    free(d->quantity[i].units);
    free(d->quantity[i].what);
    free(d->quantity[i].used);
  }
  free(d->quantity);
  free(d->matched);
  for (int k = 0; k < 2; k++) free(d->path[k]);
  free(d);
}

#include "compare/measure.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "compare/measures/look.h"

const struct measure cmp_measures[] = {
#define X(name, units, when, noise, section, of, help) {#name, units, help},
    CMP_MEASURES(X)
#undef X
};

const enum cmp_section cmp_measure_sections[] = {
#define X(name, units, when, noise, section, of, help) CMP_SECTION_##section,
    CMP_MEASURES(X)
#undef X
};

enum when { ONCE, AT, ALWAYS };
enum noise { NONE, LENGTH, AREA, OVERTURNING, TOUCHDOWN };

static const struct {
  struct cmp_value (*value)(struct cmp_look *);
  enum when when;
  enum noise noise;
  enum cmp_measure_kind kind;
} evaluators[] = {
#define X(name, units, when, noise, section, of, help)                                             \
  {cmp_measure_##name, when, noise, CMP_OF_##of},
    CMP_MEASURES(X)
#undef X
};

bool cmp_measure_always(size_t measure) {
  return evaluators[measure].when == ALWAYS;
}

bool cmp_measure_at_times(size_t measure) {
  return evaluators[measure].when != ONCE;
}

enum cmp_measure_kind cmp_measure_kind(size_t measure) {
  return evaluators[measure].kind;
}

struct cmp_value cmp_measure_take(size_t measure, struct cmp_look *l) {
  return evaluators[measure].value(l);
}

static struct cmp_row row_make(const struct comparison *c, size_t m, size_t r, size_t time) {
  const struct cmp_run *run = &c->run[r];
  struct cmp_row row = {.measure = &cmp_measures[m], .run = r, .time = time, .limit = NAN};
  const struct cmp_at *at = time == SIZE_MAX ? NULL : &run->at[time];
  struct cmp_look look = {c,     run, at, at ? c->times[time] : NAN, row.detail, sizeof row.detail,
                          false, 0};
  row.value = cmp_measure_take(m, &look);
  row.absent = look.absent;
  row.left_out = cmp_known(&row.value) ? look.left_out : 0;
  const struct cmp_data *d = &run->data, *ref = &c->ref.data;
  row.noise = evaluators[m].noise == OVERTURNING ? d->overturning.error + ref->overturning.error
              : evaluators[m].noise == TOUCHDOWN ? d->touchdown.error + ref->touchdown.error
              : evaluators[m].noise == LENGTH    ? run->noise
              : evaluators[m].noise == AREA && at != NULL ? at->noise_area
                                                          : NAN;
  return row;
}

/* One for all times is not for those at which nothing can be measured, as it can at others. */
static bool tolerance_applies(const struct comparison *c, const struct case_tolerance *t,
                              const struct cmp_row *row) {
  if (!isfinite(t->at) && row->absent) return false;
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

static void count_checks(struct cmp_rows *rows) {
  for (size_t i = 0; i < rows->checks.n; i++) {
    rows->passed += rows->checks.check[i].passed;
    rows->failed += !rows->checks.check[i].passed;
  }
}

enum status cmp_rows_create(const struct comparison *c, struct cmp_rows *rows) {
  *rows = (struct cmp_rows){0};
  TRY(cmp_checks_create(c, &rows->checks));
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
  count_checks(rows);
  return OK;
}

void cmp_rows_destroy(struct cmp_rows *rows) {
  if (!rows) return;
  free(rows->row);
  cmp_checks_destroy(&rows->checks);
  *rows = (struct cmp_rows){0};
}

const struct cmp_row *cmp_rows_find(const struct cmp_rows *rows, size_t measure, size_t run,
                                    size_t time) {
  bool once = evaluators[measure].when == ONCE;
  if (once != (time == SIZE_MAX)) return NULL;
  size_t i = rows->first[measure] + (once ? run : run * rows->n_times + time);
  return i < rows->first[measure + 1] ? &rows->row[i] : NULL;
}

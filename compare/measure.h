/* What a comparison measures, held against the case's tolerances: rows, and the verdict. */
#pragma once
#include "common/solver.h"
#include "compare/comparison.h"
#include "compare/events.h"
#include "compare/measures/list.h"
#include "compare/section.h"

extern const struct measure cmp_measures[CMP_N_MEASURES];
extern const enum cmp_section cmp_measure_sections[CMP_N_MEASURES];

enum cmp_outcome { CMP_NO_LIMIT, CMP_PASS, CMP_FAIL };

struct cmp_row {
  const struct measure *measure;
  size_t run;  /* index in comparison.run */
  size_t time; /* index in comparison.times; SIZE_MAX: over the whole run */
  struct cmp_value value;
  char detail[192];         /* where the worst value was found, and without what, or "" */
  bool absent;              /* of a time at which there is nothing to compare with, as at others */
  size_t left_out;          /* sensors that have no such number, where others have */
  double noise;             /* noise floor in the measure's units; NaN: none */
  double limit;             /* the strictest tolerance that applies; NaN: none */
  enum cmp_outcome outcome; /* a value that is not available fails where there is a limit */
};

struct cmp_rows {
  size_t n, passed, failed;
  size_t partial;      /* of those passed: without every sensor */
  struct cmp_row *row; /* by measure, run and time */
  size_t first[CMP_N_MEASURES + 1], n_times;
  struct cmp_checks checks; /* of events against published numbers; among the passed and failed */
  size_t unused;            /* tolerances that applied to nothing that was compared */
};

enum status cmp_rows_create(const struct comparison *c, struct cmp_rows *rows);
void cmp_rows_destroy(struct cmp_rows *rows);
const struct cmp_row *cmp_rows_find(const struct cmp_rows *rows, size_t measure, size_t run,
                                    size_t time); /* NULL: none */

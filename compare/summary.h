/* What a reader wants first: one sentence, and the runs in order of how long they agree. */
#pragma once
#include "compare/measure.h"

/* Indices of the runs, the one that agrees longest first; [n_runs], the caller's to free. */
enum status cmp_summary_order(const struct comparison *c, size_t **order);

/* Until when a run's surface can be compared with the reference's: the last common output, t*; NaN.
 */
double cmp_summary_shared(const struct cmp_run *run);

enum status cmp_summary_sentence(const struct comparison *c, const struct cmp_rows *rows,
                                 char *sentence, size_t room);

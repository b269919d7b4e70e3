/* Line charts against time, and the jet's close-up. */
#pragma once
#include "compare/comparison.h"
#include "compare/figure.h"

/* Run r's colour ("#rrggbb"), distinct for colour-blind readers; SIZE_MAX: the reference. */
const char *cmp_colour(size_t r);

/* "run r" or, for SIZE_MAX, the reference. */
const struct cmp_run *cmp_run_or_ref(const struct comparison *c, size_t r);

enum status cmp_charts_write(const struct comparison *c, struct cmp_figures *f);

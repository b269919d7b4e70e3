/* What report.json says about its own numbers: what measures, terms, limits and scales mean, and
 * where measured values come from. */
#pragma once
#include "compare/comparison.h"
#include "compare/json_maker.h"

json_t *cmp_about_json(struct cmp_json_maker *m, const struct comparison *c);

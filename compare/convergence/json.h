/* The section `convergence` of report.json. */
#pragma once
#include "compare/convergence/convergence.h"
#include "compare/json_maker.h"

json_t *cmp_convergence_json(struct cmp_json_maker *m, const struct comparison *c,
                             const struct cmp_convergence *v);

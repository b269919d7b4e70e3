/* report.json: every number of the comparison at full precision, with reasons and provenance. */
#pragma once
#include "compare/convergence/convergence.h"

enum status cmp_json_write(const struct comparison *c, const struct cmp_rows *rows,
                           const struct cmp_convergence *convergence, const char *sentence,
                           const char *path);

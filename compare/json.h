/* report.json: every number of the comparison at full precision, with reasons and provenance. */
#pragma once
#include <jansson.h>

#include "compare/convergence/convergence.h"

/* `out` is the caller's. ERR_MEMORY. */
enum status cmp_json_create(const struct comparison *c, const struct cmp_rows *rows,
                            const struct cmp_convergence *convergence, const char *sentence,
                            json_t **out);
enum status cmp_json_save(const json_t *report, const char *path);

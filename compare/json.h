/* report.json: every number of the comparison at full precision, with reasons and provenance. */
#pragma once
#include "compare/measure.h"

enum status cmp_json_write(const struct comparison *c, const struct cmp_rows *rows,
                           const char *sentence, const char *path);

/* report.html: one page that needs nothing else. Without scripts it shows the summary, health,
 * checks and every figure; with them the reader goes through all outputs and series, and every
 * table is there. */
#pragma once
#include <jansson.h>

#include "compare/figure.h"
#include "compare/measure.h"

/* `report` is what report.json holds. */
enum status cmp_page_write(const struct comparison *c, const struct cmp_rows *rows,
                           const struct cmp_figures *figures, const char *sentence,
                           const json_t *report, const char *path);

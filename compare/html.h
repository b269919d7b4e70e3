/* report.html: one page that needs nothing else; figures inside it. */
#pragma once
#include "compare/figure.h"
#include "compare/measure.h"

enum status cmp_html_write(const struct comparison *c, const struct cmp_rows *rows,
                           const struct cmp_figures *figures, const char *sentence,
                           const char *path);

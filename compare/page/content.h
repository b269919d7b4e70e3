/* What the page is written from, and the tables in it that need no script. */
#pragma once
#include "compare/figure.h"
#include "compare/markup.h"
#include "compare/measure.h"

struct cmp_page_content {
  const struct comparison *c;
  const struct cmp_rows *rows;
  const struct cmp_figures *figures;
  const char *sentence;
  const json_t *report, *pack;
};

enum status cmp_page_summary(struct markup *m, const struct cmp_page_content *w);
/* Whether each run is to be believed, the worst first. */
enum status cmp_page_health(struct markup *m, const struct cmp_page_content *w);
/* Tolerances and published events, failures first. */
enum status cmp_page_checks(struct markup *m, const struct cmp_page_content *w);

/* The report about differences in its four forms; each writes to a stream that is the caller's. */
#pragma once
#include <jansson.h>

#include "compare/diff/diff.h"

/* Every number of it. NULL: no memory. */
json_t *cmp_diff_json(const struct cmp_diff *d, const struct cmp_figures *figures);

/* A summary for a pull request: GitHub's Markdown. ERR_MEMORY. */
enum status cmp_diff_markdown(const struct cmp_diff *d, FILE *out);

/* JUnit's XML: a suite for each run, a case for each quantity. ERR_IO. */
enum status cmp_diff_junit(const struct cmp_diff *d, FILE *out);

/* The page, with the figures in it and `json` for its script. ERR_IO, ERR_MEMORY. */
enum status cmp_diff_page(const struct cmp_diff *d, const struct cmp_figures *figures,
                          const json_t *json, FILE *out);

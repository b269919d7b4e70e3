/* Tables of the page. */
#pragma once
#include <jansson.h>
#include <stdio.h>

#include "common/base/status.h"

struct gallery_desk;

/* Of a figure of kind `table`: {"head": [text], "rows": [[text]]}, the formulas in its cells
 * evaluated and formatted; what is not a number is a dash. ERR_INPUT when one cannot be. */
enum status gallery_table_json(struct gallery_desk *desk, const void *spec, json_t **table);

/* The same as lines of CSV. */
void gallery_table_csv(const json_t *table, FILE *out);

/* What the page draws of results, small enough to stand in it: surfaces, particles and series of
 * the runs and the reference, in 16 bits, deflated, in base64. */
#pragma once
#include <jansson.h>

#include "compare/comparison.h"

/* {"runs": [reference, run, ...], "charts": [...], "walls", "thinned"}, see pack.c. What
 * there is too much of is thinned: fewer outputs, then fewer particles in each, which "thinned"
 * says. `out` is the caller's. ERR_MEMORY, ERR_IO. */
enum status cmp_pack_create(const struct comparison *c, json_t **out);

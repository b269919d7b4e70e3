/* Where one line is furthest from another: over all points of its segments, not of some alone. */
#pragma once
#include <geos_c.h>

#include "common/base/geometry.h"

struct cmp_furthest;

/* Of distances from the lines, which are copied. NULL: no memory, or no segments. */
struct cmp_furthest *cmp_furthest_create(GEOSContextHandle_t handle, const struct geo_lines *lines);
void cmp_furthest_destroy(struct cmp_furthest *f);

/* The largest distance of points of `from` that are `film` or more away from the walls, and where;
 * `*largest` holds one that is known already, and stays when none is larger. It is found to within
 * a thousandth of itself and a millionth of `spacing`. ERR_SOLVER: GEOS fails. */
enum status cmp_furthest_find(const struct cmp_furthest *f, const struct geo_lines *from,
                              const struct geo_lines *walls, double film, double spacing,
                              double *largest, double at[2]);

/* The bed of a tank, and the walls at its ends: where a front is, and what it runs to. */
#pragma once
#include "common/base/geometry.h"
#include "compare/data.h"

/* The farthest x to that side at which the water that stands on the bed, whatever its shape, is
 * deeper than `depth`; NaN if there is none. ERR_MEMORY. */
enum status cmp_bed_front(const struct geo_lines *walls, const struct geo_lines *surface,
                          enum cmp_side side, double depth, double *front);

/* The x at which the wall on that side stands on the bed: the end of the walls is as high a wall as
 * they are steeper than 45 degrees there. Where they are not the bed goes on to their end. */
double cmp_bed_foot(const struct geo_lines *walls, enum cmp_side side);

/* Whether a point is within `near` of that wall. */
bool cmp_bed_is_at_wall(const struct geo_lines *walls, enum cmp_side side, const double at[2],
                        double near);

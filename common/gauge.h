/* What vertical wires and the eye read off a free surface; used alike by every solver and by the
 * comparator. Surfaces are oriented with the water on the right (geometry.h). */
#pragma once
#include "common/geometry.h"

/* Elevation (m) of the top of the water that stands on the bed at x: the lowest crossing of the
 * vertical above `bed` where water ends. NaN when the bed is dry there. Water that hangs or flies
 * above (an overturning jet, spray) does not count. */
double gauge_elevation(const struct geo_lines *surface, double x, double bed);

/* Largest x (m) at which the water standing on the bed is still deeper than `depth`; NaN if nowhere. */
double gauge_front(const struct geo_lines *surface, double bed, double depth);

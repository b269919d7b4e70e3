/* What vertical wires and the eye read off a free surface; used alike by every solver and by the
 * comparator. Surfaces are oriented with the water on the right (geometry.h). Nothing depends on
 * how the surface is cut into pieces, only on which side of each segment the water is. */
#pragma once
#include "common/base/geometry.h"

/* Elevation (m) of the top of the water that stands on the bed at x: the lowest crossing above
 * `bed` of the vertical with the surface, when water ends there going upwards. NaN when water
 * begins there or there is no crossing: the bed is dry at x, or x is outside the surface. What
 * hangs or flies above (an overturning jet, spray, the water over a cavity) does not count. Where
 * the surface is vertical at x, the higher of the limits from the left and from the right; so x may
 * lie on a wall, on a vertex, or on the face of a column. */
double gauge_elevation(const struct geo_lines *surface, double x, double bed);

/* The supremum of the x (m) at which the water standing on the bed is deeper than `depth`: the toe
 * of a surge, or the wall once it is wet to that depth. NaN if there is no such x. */
double gauge_front(const struct geo_lines *surface, double bed, double depth);

/* The mean over a stretch of a wall, by points on it. */
#pragma once
#include "common/base/geometry.h"

/* Of the n points `at`, those on the same segment of the walls as at[middle] and within half the
 * length of it: each the part of the length (which ends with the segment) that is nearest to it,
 * points at one place equal parts of it. They sum to 1 and are 0 for the others; all are 0 where
 * there are no walls. Returns at how many places these points are. share [n] */
size_t geo_wall_shares(const struct geo_lines *walls, size_t n, const double (*at)[2],
                       size_t middle, double length, double *share);

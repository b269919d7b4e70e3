/* The water at points of a case. */
#pragma once
#include "common/case/case.h"
#include "common/result/result.h"
#include "sph/sph.h"

/* After sph_rates(s, 0, ...): sum V f W / sum V W over the particles around the point (thesis, eq.
 * (3.18)), of pressure, density, velocity and acceleration, and sum V W itself. Walls take no part.
 * NaN where sum V W < 0.1. */
void sph_point(const struct sph *s, const struct case_point *point,
               double value[CASE_POINT_FIELDS]);

/* The id of the particle that is nearest to the point. */
uint32_t sph_point_nearest(const struct sph *s, const struct case_point *point);

/* What the particle of that id has, and sum V W around it; all NaN when it has been taken out. */
void sph_point_follow(const struct sph *s, uint32_t id, double value[CASE_POINT_FIELDS]);

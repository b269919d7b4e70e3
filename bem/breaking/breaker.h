/* The shape of breakers, to either side. Walked from left to right the face of a breaker that runs
 * to the left rises, that of one that runs to the right falls, and both keep the name where they
 * hang over. */
#pragma once
#include "bem/shape/sides.h"

enum bem_face { BEM_RISING, BEM_FALLING, BEM_FACES };

/* Smallest horizontal component of the unit tangent on such faces outside films on walls: negative
 * once one has overturned; 1 when there is none. *where, in nodes with fractions, is its steepest
 * point. */
double bem_breaker_tangent(const struct bem_surface *s, const double *state, enum bem_face face,
                           double *where);

/* The middle of the stretch that is upright as node *where, in nodes with fractions. */
double bem_breaker_upright(const struct bem_surface *s, const double *state, double where);

/* Distance (H) across air of the surface from itself or a wall, least of all, and where; negative
 * once they cross; `reach` while nothing comes as near, which is dear to look for far away.
 * Scratch: *w. */
double bem_breaker_gap(const struct bem_sides *w, const struct bem_surface *s, const double *state,
                       double reach, struct bem_near *near);

/* Whether a cavity is closed but for so little. */
bool bem_breaker_touches(const struct bem_sides *w, const struct bem_surface *s,
                         const double *state, double little);

/* Whether what comes near there is water above water that faces up. */
bool bem_breaker_falls(const struct bem_surface *s, const double *state,
                       const struct bem_near *near);

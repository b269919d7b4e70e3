/* The shape of the breaker that runs back from the right wall. */
#pragma once
#include "bem/surface.h"

/* Smallest horizontal component of the unit tangent (surface walked from left to right) where the
 * breaker rises: negative once it has overturned; 1 when nothing rises. *where, in nodes with
 * fractions, is its steepest point. */
double bem_breaker_tangent(const struct bem_surface *s, const double *state, double *where);

/* The middle of the stretch that is upright as node *where, in nodes with fractions. */
double bem_breaker_upright(const struct bem_surface *s, const double *state, double where);

/* Vertical distance (H) of the jet from the surface below it, least over the jet's far half, and
 * where, in nodes with fractions; 1 while nothing hangs over. */
double bem_breaker_gap(const struct bem_surface *s, const double *state, double *where);

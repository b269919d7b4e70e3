/* The free surface of a particle cloud, as oriented polylines. */
#pragma once
#include "common/base/geometry.h"
#include "common/base/status.h"

struct sph_surface; /* the grid and other scratch memory; it grows when needed and is then kept */

enum status sph_surface_create(struct sph_surface **s);
void sph_surface_destroy(struct sph_surface *s); /* NULL is fine */

/* Finds the free surface of n particles at (x, y) [n], m, of the given volumes [n], m^2 (NULL: dx^2
 * each), where dx (m) is their mean spacing, inside `walls` (water on their left; none: no walls).
 *
 * *out gets (geometry.h) pieces with the water on their right: open ones, which start and end
 * exactly on walls (or on the straight continuation of a wall beyond its end), the longest first
 * (the main surface, from left to right), then closed ones: drops clockwise, cavities
 * counter-clockwise. Points are about dx/2 apart. Neither a drop of one or two particles nor a
 * pocket of air of less than 4 dx^2 is seen.
 *
 * Particles that are not finite, or farther out of the box of the walls than its diagonal, are left
 * out. Serial, so that the result has the same bits for any thread count.
 * ERR_MEMORY; ERR_INPUT when the particles are so scattered that no grid of spacing dx/2 fits. */
enum status sph_surface_extract(struct sph_surface *s, size_t n, const double *x, const double *y,
                                const double *volume, double dx, const struct geo_lines *walls,
                                struct geo_lines *out);

/* The free surface of a particle cloud, as oriented polylines. */
#pragma once
#include "common/base/geometry.h"
#include "common/base/status.h"
#include "common/cloud/fraction.h"

struct cloud_surface; /* the grid and other scratch memory; it grows when needed and is then kept */

enum status cloud_surface_create(struct cloud_surface **s);
void cloud_surface_destroy(struct cloud_surface *s); /* NULL is fine */

/* Finds the free surface of a cloud inside `walls` (water on their left; none: no walls), of which
 * some may be the ends of a periodic tank (fraction.h), where curves are cut likewise.
 *
 * *out gets (geometry.h) pieces with the water on their right: open ones, which start and end
 * exactly on walls (or on the straight continuation of a wall beyond its end), the longest first
 * (the main surface, from left to right), then closed ones: drops clockwise, cavities
 * counter-clockwise. Points are about dx/2 apart. Neither a drop of one or two particles nor a
 * pocket of air of less than 4 dx^2 is seen.
 *
 * It has the same bits for any number of threads. Particles that are left out, and errors: as
 * cloud_fraction_fill has it. */
enum status cloud_surface_extract(struct cloud_surface *s, const struct cloud *c,
                                  const struct geo_lines *walls, struct geo_lines *out);

/* The same with all that lies out of the strip, from x = strip[0] to strip[1] (m), taken to be dry:
 * curves that leave it are closed along its edges, half a dx inside. Away from there it has the
 * same points as the whole surface, but for drops and pockets that an edge cuts, whose size is that
 * of the part inside. */
enum status cloud_surface_strip(struct cloud_surface *s, const struct cloud *c,
                                const struct geo_lines *walls, const double strip[2],
                                struct geo_lines *out);

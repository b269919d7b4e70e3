/* Wave gauges. */
#pragma once
#include "common/case/case.h"
#include "common/cloud/surface.h"
#include "sph/sph.h"

/* Elevation (m) of the water that stands on the bed at x (m), on the free surface that was
 * extracted from the particles; NaN where the bed is dry (common/base/gauge.h).
 *
 * Beside a wall whose particles keep their place and volume where the water ends (sph_wall.layer),
 * the topmost particles are pressed down and away: in still water by half a spacing, 0.8 at worst.
 * What stands there is a meniscus, not the level. Within the layer the line through the
 * surface at one and at two layers from the wall is read instead, when it is higher, but never more
 * than one spacing above what is there: a jet that rises along the wall, water that has left it and
 * steep faces keep their own height. */
double sph_gauge(const struct sph *s, const struct geo_lines *surface, double x);

/* From where to where (x, m) the surface must be known for that: a strip of it (surface.h) reads
 * the same as the whole one. */
void sph_gauge_strip(const struct sph *s, double x, double strip[2]);

/* The gauges of a case, each of which looks only where it stands. */
struct sph_gauges;

enum status sph_gauges_create(const struct case_file *c, const struct sph *s,
                              struct sph_gauges **out);
void sph_gauges_destroy(struct sph_gauges *g); /* NULL is fine */

/* Finds all elevations, on several threads; the cloud is that of s. ERR_MEMORY, or what
 * cloud_surface_extract has. */
enum status sph_gauges_measure(struct sph_gauges *g, const struct sph *s,
                               const struct cloud *cloud);
double sph_gauges_elevation(const struct sph_gauges *g, size_t gauge); /* the last one, m */

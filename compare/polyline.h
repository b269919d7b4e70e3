/* Free surfaces as polylines: choosing, cutting and closing them (no GEOS here). */
#pragma once
#include <stdbool.h>

#include "common/base/geometry.h"

/* The longest piece; SIZE_MAX when there is none with two points. */
size_t cmp_piece_longest(const struct geo_lines *surface);

/* Copies the pieces at least `fraction` as long as the longest: the surface without spray. */
enum status cmp_lines_main(const struct geo_lines *surface, double fraction, struct geo_lines *out);

/* Cuts lines by a box; parts keep their direction, a closed piece that is cut becomes open parts.
 */
enum status cmp_lines_clip(const struct geo_lines *in, const struct geo_box *box,
                           struct geo_lines *out);

/* Points every `step` metres along every piece (both ends of open pieces included). */
enum status cmp_lines_sample(const struct geo_lines *in, double step, struct geo_lines *out);

/* From p to the nearest wall, m; infinite without walls. */
double cmp_wall_distance(const struct geo_lines *walls, const double *p);

/* The points (one open piece) that are at least `distance` away from every wall. */
enum status cmp_lines_away(const struct geo_lines *in, const struct geo_lines *walls,
                           double distance, struct geo_lines *out);

/* Closes oriented free surfaces into rings of water. From the end of an open piece the tank's wall
 * is followed with the water on the same side to where the next piece starts; the tank is taken as
 * open to the sky. Rings are clockwise around water, counter-clockwise around cavities. Ends lying
 * off the wall are joined to its nearest point; an open piece whose ends lie within `snap` metres
 * of each other the wrong way round is simply closed. */
enum status cmp_lines_close(const struct geo_lines *surface, const struct geo_lines *walls,
                            double snap, struct geo_lines *rings);

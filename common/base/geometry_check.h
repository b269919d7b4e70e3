/* Questions about polylines that need robust predicates: answered by GEOS. */
#pragma once
#include "common/base/geometry.h"

/* Distance of (x, y) from the nearest point of the lines, m, and that point; the piece it is on.
 * INFINITY when there are no lines. */
double geo_lines_distance(const struct geo_lines *l, double x, double y, double nearest[2],
                          size_t *piece);

/* Whether a piece, as it is or closed by the straight line between its ends, neither crosses nor
 * touches itself; `at` says where it does. ERR_MEMORY, ERR_SOLVER. */
enum status geo_piece_simple(const struct geo_lines *l, size_t piece, bool closed, bool *simple,
                             double at[2]);

/* Whether two pieces, as lines, cross or run along each other (touching at ends is neither). */
enum status geo_pieces_cross(const struct geo_lines *l, size_t a, size_t b, bool *cross);

/* Area that two closed pieces have in common, m^2. */
enum status geo_pieces_overlap(const struct geo_lines *l, size_t a, size_t b, double *area);

/* The open piece that, closed by the straight line between its ends, bounds the largest area: the
 * wall that makes the tank. l->pieces when there is none with an area. */
size_t geo_lines_vessel(const struct geo_lines *l);

/* Closed piece `piece` of `l` against the room of `tank`, which its vessel and its
 * counter-clockwise closed pieces bound, less its clockwise ones: the area that lies outside, m^2,
 * and a point of it. Zero when the walls bound no room. */
enum status geo_piece_outside(const struct geo_lines *l, size_t piece, const struct geo_lines *tank,
                              double *area, double at[2]);

/* Length of `walls` that runs through the inside of a closed piece of `l`, farther than `near` (m)
 * from its rim, and a point of it: corners on a sloping wall are beside it by rounding. */
enum status geo_piece_crossed(const struct geo_lines *l, size_t piece,
                              const struct geo_lines *walls, double near, double *length,
                              double at[2]);

/* The part of the room of `tank` below the horizontal y = level: its area (m^2) and centroid. */
enum status geo_area_below(const struct geo_lines *tank, double level, double *area,
                           double centroid[2]);

/* Where the union of the closed pieces is thinner than `width` (m): what an opening, shrinking by
 * half the width and growing again with mitred corners, takes away. Pointed corners are no thin
 * parts. The largest connected part, if it has more than `least` m^2 or is most of its body: its
 * area (m^2; 0: there is none), mean thickness (m) and a point of it. ERR_MEMORY, ERR_SOLVER. */
enum status geo_lines_thin(const struct geo_lines *l, double width, double least, double *area,
                           double *thickness, double at[2]);

/* The outline of the union of the closed pieces of `l`, those within `near` (m) of each other being
 * one body: closed counter-clockwise pieces, with clockwise ones around air in them. ERR_MEMORY, ERR_SOLVER. */
enum status geo_lines_outline(const struct geo_lines *l, double near, struct geo_lines *outline);

void geo_piece_reverse(struct geo_lines *l, size_t piece);

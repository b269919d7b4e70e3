/* Plane geometry: one container for everything made of polylines (tank walls, water regions, free
 * surfaces), kept as nested offsets exactly as the result file stores it. */
#pragma once
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#include "common/base/status.h"

/* A set of polylines ("pieces"). Piece k is points first[k] .. first[k+1]-1; a closed piece joins
 * its last point to its first without repeating it. Free surfaces are oriented: walking along a
 * piece, the water is on the right (so the main surface of a tank runs from left to right; a drop
 * is clockwise, a cavity counter-clockwise). */
struct geo_lines {
  size_t pieces, points;
  size_t *first;         /* [pieces + 1], first[0] = 0, owned */
  unsigned char *closed; /* [pieces], 0 or 1, owned */
  double (*p)[2];        /* x, y, m, [points], owned */
  size_t piece_room, point_room;
};

struct geo_box {
  double min[2], max[2]; /* m */
};

static inline bool geo_box_contains(const struct geo_box *b, double x, double y) {
  return x >= b->min[0] && x <= b->max[0] && y >= b->min[1] && y <= b->max[1];
}

void geo_lines_destroy(struct geo_lines *l); /* frees the arrays and zeroes *l; NULL is fine */
void geo_lines_clear(struct geo_lines *l);   /* empty again, keeps the memory */

/* Starts a new piece; geo_lines_add appends to the last one. ERR_MEMORY. */
enum status geo_lines_begin(struct geo_lines *l, bool closed);
enum status geo_lines_add(struct geo_lines *l, double x, double y);
enum status geo_lines_copy(struct geo_lines *to, const struct geo_lines *from);
/* A vertex more, before point i of its piece. */
enum status geo_lines_insert(struct geo_lines *l, size_t piece, size_t i, double x, double y);
/* Appends a piece of another set. */
enum status geo_lines_add_piece(struct geo_lines *to, const struct geo_lines *from, size_t piece);

/* Signed area of a closed piece, m^2, positive when counter-clockwise. */
double geo_piece_area(const struct geo_lines *l, size_t piece);
double geo_piece_length(const struct geo_lines *l, size_t piece); /* m */
struct geo_box geo_lines_box(const struct geo_lines *l);          /* of no points: all zero */

/* How many segments a piece has. */
static inline size_t geo_piece_segments(const struct geo_lines *l, size_t piece) {
  size_t n = l->first[piece + 1] - l->first[piece];
  return l->closed[piece] ? n : n ? n - 1 : 0;
}

/* The point at which a segment of a piece ends. */
static inline const double *geo_segment_end(const struct geo_lines *l, size_t piece,
                                            size_t segment) {
  size_t i = l->first[piece] + segment + 1;
  return l->p[i < l->first[piece + 1] ? i : l->first[piece]];
}

/* Foot of the perpendicular from (x, y) on the line through a and b, as a fraction of a to b, and
 * the distance from the line, positive on the left. */
static inline double geo_line_foot(const double a[2], const double b[2], double x, double y,
                                   double *distance) {
  double ex = b[0] - a[0], ey = b[1] - a[1], l2 = ex * ex + ey * ey;
  *distance = (ex * (y - a[1]) - ey * (x - a[0])) / sqrt(l2);
  return ((x - a[0]) * ex + (y - a[1]) * ey) / l2;
}

/* The point of the segment from a to b that is nearest to p, into foot; returns how far along it
 * is, 0 at a and 1 at b. */
static inline double geo_segment_foot(const double a[2], const double b[2], const double p[2],
                                      double foot[2]) {
  double d[2] = {b[0] - a[0], b[1] - a[1]}, square = d[0] * d[0] + d[1] * d[1];
  double u = square > 0 ? ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / square : 0;
  u = u < 0 ? 0 : u > 1 ? 1 : u;
  foot[0] = a[0] + u * d[0];
  foot[1] = a[1] + u * d[1];
  return u;
}

/* Whether (x, y) is inside the union of the closed pieces (even-odd rule per piece). */
bool geo_lines_contain(const struct geo_lines *l, double x, double y);
/* Which closed piece it is in, the first of them; false: none. */
bool geo_lines_find(const struct geo_lines *l, double x, double y, size_t *piece);

/* Where a straight line runs through the union of closed pieces: spans of the coordinate along it,
 * in order. */
struct geo_cut {
  size_t n, room;
  double (*span)[2]; /* m, from and to, [n], owned */
};

/* The line x = at (axis 0) or y = at (axis 1). Pieces that lie within `near` (m) of each other are
 * one body: their spans are joined. ERR_MEMORY. */
enum status geo_lines_cut(const struct geo_lines *l, int axis, double at, double near,
                          struct geo_cut *cut);
void geo_cut_destroy(struct geo_cut *cut); /* NULL is fine */

/* The span nearest to a coordinate along the cut; NULL when there is none. */
const double *geo_cut_span(const struct geo_cut *cut, double along);

/* How many intervals of about `spacing` a length is divided into, evenly; at least one. */
size_t geo_intervals(double length, double spacing);

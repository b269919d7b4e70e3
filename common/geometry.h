/* Plane geometry: one container for everything made of polylines (tank walls, water regions, free
 * surfaces), kept as nested offsets exactly as the result file stores it. */
#pragma once
#include <stdbool.h>
#include <stddef.h>

#include "common/status.h"

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

void geo_lines_destroy(struct geo_lines *l); /* frees the arrays and zeroes *l; NULL is fine */
void geo_lines_clear(struct geo_lines *l);   /* empty again, keeps the memory */

/* Starts a new piece; geo_lines_add appends to the last one. ERR_MEMORY. */
enum status geo_lines_begin(struct geo_lines *l, bool closed);
enum status geo_lines_add(struct geo_lines *l, double x, double y);
enum status geo_lines_copy(struct geo_lines *to, const struct geo_lines *from);

/* Signed area of a closed piece, m^2, positive when counter-clockwise. */
double geo_piece_area(const struct geo_lines *l, size_t piece);
double geo_piece_length(const struct geo_lines *l, size_t piece); /* m */
struct geo_box geo_lines_box(const struct geo_lines *l);          /* of no points: all zero */

/* Whether (x, y) is inside the union of the closed pieces (even-odd rule per piece). */
bool geo_lines_contain(const struct geo_lines *l, double x, double y);

/* The room that walls make: what is inside of them, and how far from the nearest. */
#pragma once
#include <stdbool.h>

#include "common/base/geometry.h"
#include "common/base/status.h"

enum { TANK_MOST_WALLS = 1000 };

/* Walls that go on where another ends, within `near` (m), become one, if there are not too many;
 * `item` of each is that of the wall that it begins with, [pieces]. ERR_MEMORY. */
enum status tank_join_walls(struct geo_lines *walls, double near, size_t *item);

/* Two ends of open walls that are `gap` (m) apart: farther than nothing, and nearer than any two
 * others; which walls they are of. False when there are none. */
struct tank_gap {
  double width, at[2];
  size_t wall[2];
};
bool tank_find_gap(const struct geo_lines *walls, struct tank_gap *gap);

/* Whether (x, y) is in the room: between the sides of the vessel, which go on upwards for ever, or
 * in an anticlockwise closed wall, and in no clockwise one. Where there is no such wall everything
 * is room. */
bool tank_contains(const struct geo_lines *walls, double x, double y);

/* Distance from the nearest wall, m, negative outside the room; the place on it. */
double tank_distance(const struct geo_lines *walls, double x, double y, double nearest[2]);

/* Whether walls can have periodic sides: one open wall down an upright left side, along a bed that
 * never goes back, between the sides, and up an upright right side, with both ends of the bed at
 * one height. */
bool tank_can_be_round(const struct geo_lines *walls, double near);

/* The bed of such walls: the vertices from the foot of the left side to that of the right one. */
void tank_find_bed(const struct geo_lines *walls, size_t *first, size_t *last);

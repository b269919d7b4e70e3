/* The box of the tank: upright sides up to their tops on a flat bed, open above (room.h has other
 * walls); or without walls along an axis, where what leaves through one end comes in through the
 * other. Whatever asks where a wall is asks here. */
#pragma once
#include <math.h>
#include <stdbool.h>

#include "common/base/geometry.h"
#include "common/base/status.h"

enum { TANK_LEFT, TANK_RIGHT };

struct tank {
  struct geo_box box; /* m */
  bool periodic[2];   /* along x: the sides are no walls; along y: the bed is none */
  double top[2];      /* m: y of the upper ends of the sides */
};

/* From walls that run down the left side, along the bed, up the right side. */
struct tank tank_of(const struct geo_lines *walls, const bool periodic[2]);

/* Whether the walls are such a tank: one open piece down the left side, along a flat bed, up the
 * right side. Lengths closer than `near` (m) are the same; further points along them are no matter.
 */
bool tank_is_rectangular(const struct geo_lines *walls, double near);

static inline bool tank_is_periodic(const struct tank *t) {
  return t->periodic[0] || t->periodic[1];
}

/* x of a side, m. */
static inline double tank_wall(const struct tank *t, int side) {
  return side == TANK_RIGHT ? t->box.max[0] : t->box.min[0];
}

/* Way from x to a side, m; negative beyond it. */
static inline double tank_inside(const struct tank *t, int side, double x) {
  return side == TANK_RIGHT ? t->box.max[0] - x : x - t->box.min[0];
}

/* The side that is nearer to x. */
static inline int tank_nearer(const struct tank *t, double x) {
  return x - t->box.min[0] > t->box.max[0] - x ? TANK_RIGHT : TANK_LEFT;
}

/* The tank and what lies within `reach` (m) around it, above it only where that is its bed. */
struct geo_box tank_around(const struct tank *t, double reach);

/* Where the walls are: sides or bed that are none are infinitely far. */
struct geo_box tank_walled(const struct tank *t);

/* The walls alone, for whoever continues the water behind them: `walls` where nothing is periodic,
 * else the bed, which need not be flat, on by `beyond` (m) at both ends, or nothing. ERR_MEMORY. */
enum status tank_walls(const struct tank *t, const struct geo_lines *walls, double beyond,
                       struct geo_lines *out);

/* What bounds the part of the plane that is the tank: `walls`, or a closed box where its bed is
 * periodic. ERR_MEMORY. */
enum status tank_outline(const struct tank *t, const struct geo_lines *walls,
                         struct geo_lines *out);

/* Width or height of the tank, m. */
static inline double tank_size(const struct tank *t, int axis) {
  return t->box.max[axis] - t->box.min[axis];
}

/* The place in a periodic tank of what is at this coordinate along an axis; else itself. */
static inline double tank_wrap(const struct tank *t, int axis, double at) {
  const double low = t->box.min[axis], high = t->box.max[axis];
  if (!t->periodic[axis] || (at >= low && at < high) || !isfinite(at)) return at;
  const double in = at - (high - low) * floor((at - low) / (high - low));
  return in < high ? fmax(in, low) : low; /* rounded up to the end */
}

/* The tank of the water: upright sides up to their tops on a flat bed, open above. Whatever asks
 * where a wall is asks here. */
#pragma once
#include <math.h>
#include <stdbool.h>

#include "common/base/geometry.h"

enum { TANK_LEFT, TANK_RIGHT };

struct tank {
  struct geo_box box;        /* m */
  double top[2], lowest_top; /* m: y of the upper ends of the sides; of the lower one */
};

/* From walls that run down the left side, along the bed, up the right side. */
static inline struct tank tank_of(const struct geo_lines *walls) {
  struct tank t = {geo_lines_box(walls), {walls->p[0][1], walls->p[walls->points - 1][1]}, 0};
  t.lowest_top = fmin(t.top[0], t.top[1]);
  return t;
}

/* Whether the walls are such a tank: one open piece down the left side, along a flat bed, up the
 * right side. Lengths closer than `near` (m) are the same; further points along them are no matter.
 */
bool tank_is_rectangular(const struct geo_lines *walls, double near);

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

/* The tank and what lies within `reach` (m) behind its sides and under its bed. */
static inline struct geo_box tank_around(const struct tank *t, double reach) {
  return (struct geo_box){{t->box.min[0] - reach, t->box.min[1] - reach},
                          {t->box.max[0] + reach, t->box.max[1]}};
}

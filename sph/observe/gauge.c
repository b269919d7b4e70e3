#include "sph/observe/gauge.h"

#include <math.h>

#include "common/base/gauge.h"
#include "sph/domain/wall.h"

double sph_gauge(const struct sph *s, const struct geo_lines *surface, double x) {
  const struct tank *t = &s->tank;
  double bed = t->box.min[1], there = gauge_elevation(surface, x, bed);
  int side = tank_nearer(t, x);
  double away = tank_inside(t, side, x), wall = tank_wall(t, side);
  double layer = sph_walls[s->scheme.walls]->layer * s->dx;
  if (!(away < layer)) return there;
  double inwards = side == TANK_RIGHT ? -layer : layer;
  double near = gauge_elevation(surface, wall + inwards, bed);
  double far = gauge_elevation(surface, wall + 2 * inwards, bed);
  double level = near + (near - far) * (1 - away / layer);
  return level > there ? fmin(level, there + s->dx) : there; /* where one is dry: there */
}

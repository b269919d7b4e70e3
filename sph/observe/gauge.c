#include "sph/observe/gauge.h"

#include <math.h>

#include "common/gauge.h"
#include "sph/domain/wall.h"

double sph_gauge(const struct sph *s, const struct geo_lines *surface, double x) {
  double left = s->tank.min[0], right = s->tank.max[0], bed = s->tank.min[1];
  double there = gauge_elevation(surface, x, bed);
  double layer = sph_walls[s->scheme.walls]->layer * s->dx, away = fmin(x - left, right - x);
  if (!(away < layer)) return there;
  double inwards = x - left < right - x ? layer : -layer, wall = inwards > 0 ? left : right;
  double near = gauge_elevation(surface, wall + inwards, bed);
  double far = gauge_elevation(surface, wall + 2 * inwards, bed);
  double level = near + (near - far) * (1 - away / layer);
  return level > there ? fmin(level, there + s->dx) : there; /* where one is dry: there */
}

#include "sph/observe/gauge.h"

#include <math.h>

#include "common/base/gauge.h"
#include "sph/domain/wall.h"

/* How much wider a strip is than what is read off it, on each side, particle spacings. A pocket of
 * air at the gauge that is too small to count (4 dx^2, surface.h) is then cut by an edge, which
 * makes it count, only when it is less than half a spacing thick. */
static const double beside = 8;

/* The meniscus beside the nearer wall. */
struct meniscus {
  double away;  /* of the gauge from the wall, in layers */
  double at[2]; /* one and two layers from the wall, m */
};

static struct meniscus meniscus_of(const struct sph *s, double x) {
  const struct tank *t = &s->tank;
  int side = tank_nearer(t, x);
  double layer = sph_walls[s->scheme.walls]->layer * s->dx, wall = tank_wall(t, side);
  double inwards = side == TANK_RIGHT ? -layer : layer, away = tank_inside(t, side, x);
  return (struct meniscus){layer > 0 ? away / layer : INFINITY,
                           {wall + inwards, wall + 2 * inwards}};
}

double sph_gauge(const struct sph *s, const struct geo_lines *surface, double x) {
  double bed = s->tank.box.min[1], there = gauge_elevation(surface, x, bed);
  struct meniscus m = meniscus_of(s, x);
  if (!(m.away < 1)) return there;
  double near = gauge_elevation(surface, m.at[0], bed);
  double far = gauge_elevation(surface, m.at[1], bed);
  double level = near + (near - far) * (1 - m.away);
  return level > there ? fmin(level, there + s->dx) : there; /* where one is dry: there */
}

void sph_gauge_strip(const struct sph *s, double x, double strip[2]) {
  struct meniscus m = meniscus_of(s, x);
  double reads = m.away < 1 ? m.at[1] : x;
  strip[0] = fmin(x, reads) - beside * s->dx;
  strip[1] = fmax(x, reads) + beside * s->dx;
}

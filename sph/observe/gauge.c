#include "sph/observe/gauge.h"

#include <math.h>
#include <stdlib.h>

#include "common/base/array.h"
#include "common/base/gauge.h"
#include "sph/domain/wall.h"

/* How much wider a strip is than what is read off it, on each side, particle spacings. A pocket of
 * air at the gauge that is too small to count (4 dx^2, surface.h) is then cut by an edge, which
 * makes it count, only when it is less than two thirds of a spacing thick. */
static const double beside = 6;

/* Whether a side of the tank is upright, from its top. */
static bool is_upright(const struct sph *s, int side) {
  if (s->faces.n_tops != 2) return false;
  return s->faces.face[s->faces.top[side] / 2].t[0] == 0;
}

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
  return (struct meniscus){layer > 0 && !t->periodic[0] && is_upright(s, side) ? away / layer
                                                                               : INFINITY,
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

/* ---- the gauges of a case ---- */

struct looker {
  double x, elevation;             /* m */
  struct cloud_surface *extractor; /* owned */
  struct geo_lines surface;        /* owned */
};

struct sph_gauges {
  struct geo_lines outline; /* of the tank, owned */
  size_t n;
  struct looker *gauge; /* [n], owned */
  bool crowded;         /* their strips cost more than the whole surface */
};

static bool is_crowded(const struct case_file *c, const struct sph *s) {
  double width = 0, strip[2];
  for (size_t k = 0; k < c->n_gauges; k++) {
    sph_gauge_strip(s, c->gauges[k].x, strip);
    width += strip[1] - strip[0];
  }
  return width > tank_size(&s->tank, 0);
}

enum status sph_gauges_create(const struct case_file *c, const struct sph *s,
                              struct sph_gauges **out) {
  enum status status = OK;
  struct sph_gauges *g = NULL;
  ATTEMPT(array_create(&g, 1, "gauges"));
  ATTEMPT(array_create(&g->gauge, c->n_gauges, "gauges"));
  ATTEMPT(tank_outline(&s->tank, &c->walls, &g->outline));
  g->n = c->n_gauges;
  g->crowded = is_crowded(c, s);
  for (size_t k = 0; k < g->n; k++) {
    g->gauge[k].x = c->gauges[k].x;
    if (k == 0 || !g->crowded) ATTEMPT(cloud_surface_create(&g->gauge[k].extractor));
  }
done:
  if (status != OK) {
    sph_gauges_destroy(g);
    g = NULL;
  }
  *out = g;
  return status;
}

void sph_gauges_destroy(struct sph_gauges *g) {
  if (!g) return;
  for (size_t k = 0; k < g->n; k++) {
    cloud_surface_destroy(g->gauge[k].extractor);
    geo_lines_destroy(&g->gauge[k].surface);
  }
  free(g->gauge);
  geo_lines_destroy(&g->outline);
  free(g);
}

static enum status look(struct looker *l, const struct sph *s, const struct cloud *cloud,
                        const struct geo_lines *outline) {
  double strip[2];
  sph_gauge_strip(s, l->x, strip);
  TRY(cloud_surface_strip(l->extractor, cloud, outline, strip, &l->surface));
  l->elevation = sph_gauge(s, &l->surface, l->x);
  return OK;
}

static enum status look_at_all(struct sph_gauges *g, const struct sph *s, const struct cloud *cloud,
                               const struct geo_lines *walls) {
  struct looker *first = g->gauge;
  TRY(cloud_surface_extract(first->extractor, cloud, walls, &first->surface));
  for (size_t k = 0; k < g->n; k++)
    g->gauge[k].elevation = sph_gauge(s, &first->surface, g->gauge[k].x);
  return OK;
}

enum status sph_gauges_measure(struct sph_gauges *g, const struct sph *s,
                               const struct cloud *cloud) {
  const struct geo_lines *walls = sph_sides_walls(s, &g->outline);
  if (g->crowded) return look_at_all(g, s, cloud, walls);
  int failed = 0;
#pragma omp parallel for schedule(dynamic, 1) reduction(| : failed)
  for (size_t k = 0; k < g->n; k++) failed |= look(&g->gauge[k], s, cloud, walls) != OK;
  for (size_t k = 0; k < g->n && failed; k++) /* once more, for the message on this thread */
    TRY(look(&g->gauge[k], s, cloud, walls));
  return OK;
}

double sph_gauges_elevation(const struct sph_gauges *g, size_t gauge) {
  return g->gauge[gauge].elevation;
}

#include "common/base/triangles.h"

#include <stdbool.h>
#include <stdlib.h>

#include "common/base/array.h"
#include "common/base/geos.h"

/* A point by its coordinates, which is all that GEOS gives back of it. */
struct place {
  double x, y;
  size_t point;
};

static int by_place(const void *a, const void *b) {
  const struct place *p = a, *q = b;
  return p->x != q->x ? (p->x > q->x) - (p->x < q->x) : (p->y > q->y) - (p->y < q->y);
}

static enum status sort_places(size_t n, const double (*p)[2], struct place **places) {
  TRY(array_create(places, n, "the points of triangles"));
  for (size_t i = 0; i < n; i++) (*places)[i] = (struct place){p[i][0], p[i][1], i};
  qsort(*places, n, sizeof **places, by_place);
  return OK;
}

/* All triangles as one collection; NULL: that failed. */
static GEOSGeometry *triangulate(struct geo_geos *g, size_t n, const struct place *places) {
  GEOSCoordSequence *s = g->failed ? NULL : GEOSCoordSeq_create_r(g->h, (unsigned)n, 2);
  for (size_t i = 0; s && i < n; i++)
    GEOSCoordSeq_setXY_r(g->h, s, (unsigned)i, places[i].x, places[i].y);
  GEOSGeometry *sites = s ? GEOSGeom_createLineString_r(g->h, s) : NULL;
  GEOSGeometry *all = sites ? GEOSDelaunayTriangulation_r(g->h, sites, 0, 0) : NULL;
  if (sites) GEOSGeom_destroy_r(g->h, sites);
  g->failed = !all;
  return all;
}

/* The points of one triangle. False: it has no area. */
static bool read_triangle(GEOSContextHandle_t h, const GEOSGeometry *triangle, size_t n,
                          const struct place *places, size_t corner[3]) {
  const GEOSCoordSequence *s = GEOSGeom_getCoordSeq_r(h, GEOSGetExteriorRing_r(h, triangle));
  double at[3][2];
  for (unsigned k = 0; k < 3; k++) {
    if (!GEOSCoordSeq_getXY_r(h, s, k, &at[k][0], &at[k][1])) return false;
    const struct place wanted = {at[k][0], at[k][1], 0};
    const struct place *found = bsearch(&wanted, places, n, sizeof *places, by_place);
    if (!found) return false;
    corner[k] = found->point;
  }
  const double cross = geo_triangle_cross(at[0], at[1], at[2]);
  if (cross < 0) {
    const size_t swap = corner[1];
    corner[1] = corner[2];
    corner[2] = swap;
  }
  return cross != 0;
}

static enum status read_all(GEOSContextHandle_t h, const GEOSGeometry *all, size_t n,
                            const struct place *places, size_t *triangles, size_t (**corner)[3]) {
  const int most = GEOSGetNumGeometries_r(h, all);
  TRY(array_create(corner, (size_t)most, "triangles"));
  for (int k = 0; k < most; k++)
    *triangles += read_triangle(h, GEOSGetGeometryN_r(h, all, k), n, places, (*corner)[*triangles]);
  return OK;
}

enum status geo_triangulate(size_t points, const double (*p)[2], size_t *triangles,
                            size_t (**corner)[3]) {
  struct geo_geos g;
  struct place *places;
  *triangles = 0;
  *corner = NULL;
  TRY(sort_places(points, p, &places));
  geo_geos_begin(&g);
  GEOSGeometry *all = triangulate(&g, points, places);
  const enum status status = all ? read_all(g.h, all, points, places, triangles, corner) : OK;
  if (all) GEOSGeom_destroy_r(g.h, all);
  free(places);
  const enum status ended = geo_geos_end(&g, "join points to triangles");
  return status != OK ? status : ended;
}

#include "common/base/triangles.h"

#include <geos_c.h>
#include <stdbool.h>
#include <stdlib.h>

#include "common/base/array.h"

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

static void quiet(const char *message, void *unused) {
  (void)message;
  (void)unused;
}

/* All triangles as one collection; NULL: no memory. */
static GEOSGeometry *triangulate(GEOSContextHandle_t h, size_t n, const struct place *places) {
  GEOSCoordSequence *s = GEOSCoordSeq_create_r(h, (unsigned)n, 2);
  for (size_t i = 0; s && i < n; i++)
    GEOSCoordSeq_setXY_r(h, s, (unsigned)i, places[i].x, places[i].y);
  GEOSGeometry *sites = s ? GEOSGeom_createLineString_r(h, s) : NULL;
  GEOSGeometry *all = sites ? GEOSDelaunayTriangulation_r(h, sites, 0, 0) : NULL;
  if (sites) GEOSGeom_destroy_r(h, sites);
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
  const int most = all ? GEOSGetNumGeometries_r(h, all) : -1;
  CHECK(most >= 0, ERR_MEMORY, "no memory for triangles between %zu points", n);
  TRY(array_create(corner, (size_t)most, "triangles"));
  for (int k = 0; k < most; k++)
    *triangles += read_triangle(h, GEOSGetGeometryN_r(h, all, k), n, places, (*corner)[*triangles]);
  return OK;
}

enum status geo_triangulate(size_t points, const double (*p)[2], size_t *triangles,
                            size_t (**corner)[3]) {
  enum status status = OK;
  struct place *places = NULL;
  GEOSGeometry *all = NULL;
  GEOSContextHandle_t h = GEOS_init_r();
  *triangles = 0;
  *corner = NULL;
  CHECK(h, ERR_MEMORY, "no memory for triangles between %zu points", points);
  GEOSContext_setErrorMessageHandler_r(h, quiet, NULL);
  ATTEMPT(sort_places(points, p, &places));
  all = triangulate(h, points, places);
  ATTEMPT(read_all(h, all, points, places, triangles, corner));
done:
  if (all) GEOSGeom_destroy_r(h, all);
  GEOS_finish_r(h);
  free(places);
  return status;
}

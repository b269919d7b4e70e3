#include "import/gap.h"

#include <stdlib.h>

#include "common/base/geos.h"

enum { MITRE_LIMIT = 10 };

/* A piece as GEOS has lines, one more point where it is closed. */
static GEOSGeometry *line_of(GEOSContextHandle_t h, const struct geo_lines *walls, size_t piece) {
  const size_t a = walls->first[piece], n = walls->first[piece + 1] - a;
  const size_t more = walls->closed[piece] ? 1 : 0;
  GEOSCoordSequence *s = GEOSCoordSeq_create_r(h, (unsigned)(n + more), 2);
  for (size_t i = 0; s && i < n + more; i++) {
    const double *p = walls->p[a + i % n];
    GEOSCoordSeq_setXY_r(h, s, (unsigned)i, p[0], p[1]);
  }
  return s ? GEOSGeom_createLineString_r(h, s) : NULL;
}

static enum status take(GEOSContextHandle_t h, const GEOSGeometry *line, bool closed,
                        struct geo_lines *out) {
  const GEOSCoordSequence *s = GEOSGeom_getCoordSeq_r(h, line);
  unsigned n = 0;
  if (!s || !GEOSCoordSeq_getSize_r(h, s, &n)) n = 0;
  TRY(geo_lines_begin(out, closed));
  for (unsigned i = 0; i + closed < n; i++) {
    double x = 0, y = 0;
    GEOSCoordSeq_getXY_r(h, s, i, &x, &y);
    TRY(geo_lines_add(out, x, y));
  }
  CHECK(n >= 2, ERR_INPUT, "walls have no line so far inside");
  return OK;
}

enum status import_gap(const struct geo_lines *walls, double gap, struct geo_lines *out) {
  struct geo_geos g;
  enum status status = OK;
  geo_lines_clear(out);
  if (!(gap > 0)) return geo_lines_copy(out, walls);
  geo_geos_begin(&g);
  for (size_t k = 0; k < walls->pieces && !g.failed && status == OK; k++) {
    GEOSGeometry *line = line_of(g.h, walls, k);
    GEOSGeometry *moved =
        line ? GEOSOffsetCurve_r(g.h, line, gap, 8, GEOSBUF_JOIN_MITRE, MITRE_LIMIT) : NULL;
    g.failed = !moved;
    if (moved && GEOSGeomTypeId_r(g.h, moved) != GEOS_LINESTRING)
      status = status_raise(ERR_INPUT, "wall %zu has no single line %g m inside", k, gap);
    if (moved && status == OK) status = take(g.h, moved, walls->closed[k] != 0, out);
    GEOSGeom_destroy_r(g.h, moved);
    GEOSGeom_destroy_r(g.h, line);
  }
  const enum status end = geo_geos_end(&g, "move walls inwards");
  TRY(status);
  TRY(end);
  const struct geo_box box = geo_lines_box(walls), inner = geo_lines_box(out);
  CHECK(geo_box_contains(&box, inner.min[0], inner.min[1]) &&
            geo_box_contains(&box, inner.max[0], inner.max[1]),
        ERR_INPUT, "the tank has no room %g m inside its walls", gap);
  return OK;
}

#include "common/base/geometry_check.h"

#include <math.h>
#include <stdlib.h>

#include "common/base/geos.h"

double geo_lines_distance(const struct geo_lines *l, double x, double y, double nearest[2],
                          size_t *piece) {
  double best = INFINITY;
  for (size_t k = 0; k < l->pieces; k++) {
    size_t a = l->first[k], b = l->first[k + 1];
    for (size_t i = a; i < b; i++) {
      if (i + 1 == b && !l->closed[k]) break;
      const double *p = l->p[i], *q = l->p[i + 1 < b ? i + 1 : a];
      double foot[2];
      geo_segment_foot(p, q, (double[2]){x, y}, foot);
      double d = hypot(x - foot[0], y - foot[1]);
      if (d < best) {
        best = d;
        nearest[0] = foot[0];
        nearest[1] = foot[1];
        *piece = k;
      }
    }
  }
  return best;
}

void geo_piece_reverse(struct geo_lines *l, size_t piece) {
  for (size_t i = l->first[piece], j = l->first[piece + 1]; i + 1 < j; i++) {
    j--;
    for (int k = 0; k < 2; k++) {
      double swap = l->p[i][k];
      l->p[i][k] = l->p[j][k];
      l->p[j][k] = swap;
    }
  }
}

static enum status end(struct geo_geos *g) {
  return geo_geos_end(g, "work out how walls and water lie");
}

static void drop(struct geo_geos *g, GEOSGeometry *geometry) {
  if (geometry) GEOSGeom_destroy_r(g->h, geometry);
}

static GEOSGeometry *keep(struct geo_geos *g, GEOSGeometry *geometry) {
  if (!geometry) g->failed = true;
  return geometry;
}

static GEOSCoordSequence *coordinates(struct geo_geos *g, const struct geo_lines *l, size_t piece,
                                      bool closed) {
  size_t a = l->first[piece], n = l->first[piece + 1] - a;
  if (g->failed || n < 2) return NULL;
  GEOSCoordSequence *s = GEOSCoordSeq_create_r(g->h, (unsigned)(n + closed), 2);
  for (size_t i = 0; s && i < n + closed; i++)
    GEOSCoordSeq_setXY_r(g->h, s, (unsigned)i, l->p[a + i % n][0], l->p[a + i % n][1]);
  return s;
}

static GEOSGeometry *line_of(struct geo_geos *g, const struct geo_lines *l, size_t piece,
                             bool closed) {
  GEOSCoordSequence *s = coordinates(g, l, piece, closed);
  return keep(g, s ? GEOSGeom_createLineString_r(g->h, s) : NULL);
}

static GEOSGeometry *polygon_of(struct geo_geos *g, const struct geo_lines *l, size_t piece) {
  GEOSCoordSequence *s = coordinates(g, l, piece, true);
  GEOSGeometry *ring = s ? GEOSGeom_createLinearRing_r(g->h, s) : NULL;
  return keep(g, ring ? GEOSGeom_createPolygon_r(g->h, ring, NULL, 0) : NULL);
}

size_t geo_lines_vessel(const struct geo_lines *l) {
  size_t vessel = l->pieces;
  double largest = 0;
  for (size_t k = 0; k < l->pieces; k++) {
    double area = l->closed[k] ? 0 : fabs(geo_piece_area(l, k));
    if (area > largest) {
      largest = area;
      vessel = k;
    }
  }
  return vessel;
}

/* Empty when the walls enclose nothing. */
static GEOSGeometry *tank_room(struct geo_geos *g, const struct geo_lines *tank) {
  GEOSGeometry *all = keep(g, g->failed ? NULL : GEOSGeom_createEmptyPolygon_r(g->h));
  size_t vessel = geo_lines_vessel(tank);
  for (int islands = 0; islands < 2; islands++)
    for (size_t k = 0; k < tank->pieces && !g->failed; k++) {
      double area = geo_piece_area(tank, k);
      if ((!tank->closed[k] && k != vessel) || area == 0 || (area < 0) != islands) continue;
      GEOSGeometry *part = polygon_of(g, tank, k);
      GEOSGeometry *next = keep(g, g->failed ? NULL
                                   : islands ? GEOSDifference_r(g->h, all, part)
                                             : GEOSUnion_r(g->h, all, part));
      drop(g, part);
      drop(g, all);
      all = next;
    }
  return all;
}

static void point_inside(struct geo_geos *g, const GEOSGeometry *geometry, double at[2]) {
  GEOSGeometry *point = keep(g, GEOSPointOnSurface_r(g->h, geometry));
  if (point && !GEOSisEmpty_r(g->h, point)) {
    GEOSGeomGetX_r(g->h, point, &at[0]);
    GEOSGeomGetY_r(g->h, point, &at[1]);
  }
  drop(g, point);
}

/* The first place where two segments that are not neighbours meet. */
static void find_meeting(struct geo_geos *g, const struct geo_lines *l, size_t piece, bool closed,
                         double at[2]) {
  size_t a = l->first[piece], n = l->first[piece + 1] - a;
  size_t segments = closed ? n : n - 1;
  for (size_t i = 0; i < segments; i++)
    for (size_t j = i + 1; j < segments; j++) {
      const double *p = l->p[a + i], *q = l->p[a + (i + 1) % n];
      const double *r = l->p[a + j], *s = l->p[a + (j + 1) % n];
      if (j == i + 1 ||
          (i == 0 && j == n - 1)) { /* neighbours meet when one runs back on the other */
        const double *c = j == i + 1 ? q : p, *u = j == i + 1 ? p : q, *v = j == i + 1 ? s : r;
        if ((u[0] - c[0]) * (v[1] - c[1]) == (u[1] - c[1]) * (v[0] - c[0]) &&
            (u[0] - c[0]) * (v[0] - c[0]) + (u[1] - c[1]) * (v[1] - c[1]) > 0) {
          at[0] = c[0];
          at[1] = c[1];
          return;
        }
      } else if (GEOSSegmentIntersection_r(g->h, p[0], p[1], q[0], q[1], r[0], r[1], s[0], s[1],
                                           &at[0], &at[1]) == 1)
        return;
    }
}

enum status geo_piece_simple(const struct geo_lines *l, size_t piece, bool closed, bool *simple,
                             double at[2]) {
  struct geo_geos g;
  geo_geos_begin(&g);
  GEOSGeometry *line = line_of(&g, l, piece, closed);
  *simple = true;
  if (line) {
    char answer = GEOSisSimple_r(g.h, line);
    if (answer == 2) g.failed = true;
    *simple = answer == 1;
    if (!*simple) find_meeting(&g, l, piece, closed, at);
  }
  drop(&g, line);
  return end(&g);
}

enum status geo_pieces_cross(const struct geo_lines *l, size_t a, size_t b, bool *cross) {
  struct geo_geos g;
  geo_geos_begin(&g);
  GEOSGeometry *p = line_of(&g, l, a, l->closed[a]), *q = line_of(&g, l, b, l->closed[b]);
  *cross = false;
  if (!g.failed)
    *cross = GEOSCrosses_r(g.h, p, q) == 1 || GEOSOverlaps_r(g.h, p, q) == 1 ||
             GEOSCovers_r(g.h, p, q) == 1 || GEOSCovers_r(g.h, q, p) == 1;
  drop(&g, p);
  drop(&g, q);
  return end(&g);
}

enum status geo_pieces_overlap(const struct geo_lines *l, size_t a, size_t b, double *area) {
  struct geo_geos g;
  geo_geos_begin(&g);
  GEOSGeometry *p = polygon_of(&g, l, a), *q = polygon_of(&g, l, b);
  GEOSGeometry *both = keep(&g, g.failed ? NULL : GEOSIntersection_r(g.h, p, q));
  *area = 0;
  if (both) GEOSArea_r(g.h, both, area);
  drop(&g, p);
  drop(&g, q);
  drop(&g, both);
  return end(&g);
}

enum status geo_piece_outside(const struct geo_lines *l, size_t piece, const struct geo_lines *tank,
                              double *area, double at[2]) {
  struct geo_geos g;
  geo_geos_begin(&g);
  GEOSGeometry *p = polygon_of(&g, l, piece), *room = tank_room(&g, tank);
  GEOSGeometry *outside = keep(&g, g.failed ? NULL : GEOSDifference_r(g.h, p, room));
  *area = 0;
  if (!g.failed && GEOSisEmpty_r(g.h, room) == 1) {
    drop(&g, outside);
    outside = NULL;
  }
  if (outside) GEOSArea_r(g.h, outside, area);
  if (*area > 0) point_inside(&g, outside, at);
  drop(&g, p);
  drop(&g, room);
  drop(&g, outside);
  return end(&g);
}

static GEOSGeometry *grown(struct geo_geos *g, const GEOSGeometry *from, double by) {
  enum { UNUSED = 8 };      /* segments of round corners */
  const double mitre = 100; /* corners down to an angle of 2/100 stay pointed */
  if (g->failed) return NULL;
  return keep(g, GEOSBufferWithStyle_r(g->h, from, by, UNUSED, GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_MITRE,
                                       mitre));
}

enum status geo_piece_crossed(const struct geo_lines *l, size_t piece,
                              const struct geo_lines *walls, double near, double *length,
                              double at[2]) {
  struct geo_geos g;
  geo_geos_begin(&g);
  GEOSGeometry *p = polygon_of(&g, l, piece);
  GEOSGeometry *inside = grown(&g, p, -near);
  GEOSGeometry *rim = keep(&g, g.failed ? NULL : GEOSBoundary_r(g.h, p));
  *length = 0;
  for (size_t k = 0; k < walls->pieces && !g.failed; k++) {
    GEOSGeometry *wall = line_of(&g, walls, k, walls->closed[k]);
    GEOSGeometry *deep = keep(&g, wall ? GEOSIntersection_r(g.h, wall, inside) : NULL);
    GEOSGeometry *in = keep(&g, deep ? GEOSIntersection_r(g.h, wall, p) : NULL);
    GEOSGeometry *through = keep(&g, in ? GEOSDifference_r(g.h, in, rim) : NULL);
    double part = 0;
    if (through) GEOSLength_r(g.h, deep, &part);
    if (part > *length) {
      *length = part;
      point_inside(&g, through, at);
    }
    drop(&g, wall);
    drop(&g, deep);
    drop(&g, in);
    drop(&g, through);
  }
  drop(&g, p);
  drop(&g, inside);
  drop(&g, rim);
  return end(&g);
}

enum status geo_area_below(const struct geo_lines *tank, double level, double *area,
                           double centroid[2]) {
  struct geo_geos g;
  geo_geos_begin(&g);
  struct geo_box box = geo_lines_box(tank);
  GEOSGeometry *room = tank_room(&g, tank);
  /* a half plane would do; GEOS has rectangles */
  GEOSGeometry *below =
      keep(&g, g.failed ? NULL
                        : GEOSClipByRect_r(g.h, room, box.min[0] - 1, box.min[1] - 1,
                                           box.max[0] + 1, level));
  *area = centroid[0] = centroid[1] = 0;
  if (below) GEOSArea_r(g.h, below, area);
  if (*area > 0) {
    GEOSGeometry *centre = keep(&g, GEOSGetCentroid_r(g.h, below));
    if (centre) {
      GEOSGeomGetX_r(g.h, centre, &centroid[0]);
      GEOSGeomGetY_r(g.h, centre, &centroid[1]);
    }
    drop(&g, centre);
  }
  drop(&g, room);
  drop(&g, below);
  return end(&g);
}

static GEOSGeometry *union_of(struct geo_geos *g, const struct geo_lines *l) {
  GEOSGeometry *all = keep(g, g->failed ? NULL : GEOSGeom_createEmptyPolygon_r(g->h));
  for (size_t k = 0; k < l->pieces && !g->failed; k++) {
    if (!l->closed[k]) continue;
    GEOSGeometry *part = polygon_of(g, l, k);
    GEOSGeometry *next = keep(g, part ? GEOSUnion_r(g->h, all, part) : NULL);
    drop(g, part);
    drop(g, all);
    all = next;
  }
  return all;
}

/* Shrunk and grown again: without what is thinner than `width`. NULL when it fails. */
static GEOSGeometry *opened(struct geo_geos *g, const GEOSGeometry *body, double width) {
  GEOSGeometry *shrunk = grown(g, body, -width / 2);
  GEOSGeometry *back = grown(g, shrunk, width / 2);
  drop(g, shrunk);
  return back;
}

/* What an opening takes away from one body, without the slivers that rounding leaves along the rest
 * of its rim; NULL when it fails. */
static GEOSGeometry *lost_by_opening(struct geo_geos *g, const GEOSGeometry *body, double width) {
  GEOSGeometry *rest = opened(g, body, width);
  GEOSGeometry *lost = keep(g, rest ? GEOSDifference_r(g->h, body, rest) : NULL);
  GEOSGeometry *clean = opened(g, lost, 1e-6 * width);
  drop(g, rest);
  drop(g, lost);
  return clean;
}

/* The shorter side of the rectangle with this area and rim. */
static double rectangle_thickness(double area, double rim) {
  double half = rim / 4;
  return half - sqrt(fmax(half * half - area, 0));
}

/* Keeps the largest part of what one body loses. */
static void measure_lost(struct geo_geos *g, const GEOSGeometry *body, const GEOSGeometry *lost,
                         double least, double *area, double *thickness, double at[2]) {
  double whole = 0, all = 0;
  GEOSArea_r(g->h, body, &whole);
  GEOSArea_r(g->h, lost, &all);
  for (int k = 0; k < GEOSGetNumGeometries_r(g->h, lost); k++) {
    const GEOSGeometry *part = GEOSGetGeometryN_r(g->h, lost, k);
    double size = 0, rim = 0;
    GEOSArea_r(g->h, part, &size);
    GEOSLength_r(g->h, part, &rim);
    if (size <= *area || (size <= least && all <= whole / 2)) continue;
    *area = size;
    *thickness = rectangle_thickness(size, rim);
    point_inside(g, part, at);
  }
}

enum status geo_lines_thin(const struct geo_lines *l, double width, double least, double *area,
                           double *thickness, double at[2]) {
  struct geo_geos g;
  geo_geos_begin(&g);
  GEOSGeometry *all = union_of(&g, l);
  *area = *thickness = 0;
  for (int k = 0; !g.failed && k < GEOSGetNumGeometries_r(g.h, all); k++) {
    const GEOSGeometry *body = GEOSGetGeometryN_r(g.h, all, k);
    GEOSGeometry *lost = lost_by_opening(&g, body, width);
    if (lost) measure_lost(&g, body, lost, least, area, thickness, at);
    drop(&g, lost);
  }
  drop(&g, all);
  return end(&g);
}

/* ---- the outline of a union ---- */

/* Rounding to a grid moves points a little: the vertex of `l` that one was, else where it is. */
static const double *vertex_at(const struct geo_lines *l, double near, const double at[2]) {
  for (size_t i = 0; i < l->points; i++)
    if (hypot(l->p[i][0] - at[0], l->p[i][1] - at[1]) <= near) return l->p[i];
  return at;
}

/* Whether the last piece ends, or begins, at a point: rounding may leave two of one. */
static bool is_last_point(const struct geo_lines *l, double near, const double p[2]) {
  const size_t first = l->first[l->pieces - 1], last = l->points - 1;
  if (l->points == first) return false;
  return hypot(l->p[first][0] - p[0], l->p[first][1] - p[1]) <= near ||
         hypot(l->p[last][0] - p[0], l->p[last][1] - p[1]) <= near;
}

static enum status add_ring(struct geo_geos *g, const GEOSGeometry *ring, const struct geo_lines *l,
                            double near, bool hole, struct geo_lines *out) {
  const GEOSCoordSequence *s = GEOSGeom_getCoordSeq_r(g->h, ring);
  unsigned n = 0;
  if (!s || !GEOSCoordSeq_getSize_r(g->h, s, &n)) g->failed = true;
  TRY(geo_lines_begin(out, true));
  for (unsigned i = 0; i + 1 < n; i++) { /* the last point is the first */
    double at[2];
    GEOSCoordSeq_getXY_r(g->h, s, i, &at[0], &at[1]);
    const double *p = vertex_at(l, 2 * near, at);
    if (!is_last_point(out, 4 * near, p)) TRY(geo_lines_add(out, p[0], p[1]));
  }
  if ((geo_piece_area(out, out->pieces - 1) < 0) != hole) geo_piece_reverse(out, out->pieces - 1);
  return OK;
}

static enum status add_rings(struct geo_geos *g, const GEOSGeometry *all, const struct geo_lines *l,
                             double near, struct geo_lines *out) {
  for (int k = 0; k < GEOSGetNumGeometries_r(g->h, all); k++) {
    const GEOSGeometry *body = GEOSGetGeometryN_r(g->h, all, k);
    if (GEOSGeomTypeId_r(g->h, body) != GEOS_POLYGON) continue;
    TRY(add_ring(g, GEOSGetExteriorRing_r(g->h, body), l, near, false, out));
    for (int i = 0; i < GEOSGetNumInteriorRings_r(g->h, body); i++)
      TRY(add_ring(g, GEOSGetInteriorRingN_r(g->h, body, i), l, near, true, out));
  }
  return OK;
}

enum status geo_lines_outline(const struct geo_lines *l, double near, struct geo_lines *outline) {
  struct geo_geos g;
  geo_geos_begin(&g);
  GEOSGeometry *all = keep(&g, g.failed ? NULL : GEOSGeom_createEmptyPolygon_r(g.h));
  for (size_t k = 0; k < l->pieces && !g.failed; k++) {
    GEOSGeometry *part = polygon_of(&g, l, k);
    GEOSGeometry *next = keep(&g, part ? GEOSUnionPrec_r(g.h, all, part, near) : NULL);
    drop(&g, part);
    drop(&g, all);
    all = next;
  }
  geo_lines_clear(outline);
  enum status status = all ? add_rings(&g, all, l, near, outline) : OK;
  drop(&g, all);
  const enum status ended = end(&g);
  return status != OK ? status : ended;
}

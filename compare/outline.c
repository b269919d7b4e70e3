#include "compare/outline.h"

#include <geos_c.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "compare/furthest.h"
#include "compare/polyline.h"

struct cmp_geos {
  GEOSContextHandle_t handle;
  char error[256];
};

struct cmp_outline {
  struct cmp_geos *geos;
  double spacing, film, enclosed, length;
  struct geo_lines line, walls; /* the main surface in the window; those of the tank */
  struct cmp_furthest *far;     /* from the main surface, everywhere; NULL: it is empty */
  struct geo_lines samples;     /* points of the main surface in the window, away from walls */
  GEOSGeometry *main;           /* the main surface, everywhere */
  const GEOSPreparedGeometry *prepared; /* the same, indexed */
  GEOSGeometry *all;                    /* every piece, in the window */
  GEOSGeometry *longest;                /* the longest connected part in the window; may be NULL */
  GEOSGeometry *water;                  /* the water in the window */
};

static void on_error(const char *message, void *user) {
  struct cmp_geos *g = user;
  snprintf(g->error, sizeof g->error, "%s", message);
  g->error[strcspn(g->error, "\r\n")] = 0;
}

struct cmp_geos *cmp_geos_create(void) {
  struct cmp_geos *g = calloc(1, sizeof *g);
  if (!g) return NULL;
  g->handle = GEOS_init_r();
  if (!g->handle) {
    free(g);
    return NULL;
  }
  GEOSContext_setErrorMessageHandler_r(g->handle, on_error, g);
  return g;
}

void cmp_geos_destroy(struct cmp_geos *g) {
  if (!g) return;
  GEOS_finish_r(g->handle);
  free(g);
}

static enum status geos_failed(struct cmp_geos *g, const char *what) {
  return status_raise(ERR_SOLVER, "GEOS could not %s: %s", what, g->error);
}

#define GEOS(what, result)                                                                         \
  do {                                                                                             \
    if (!(result)) {                                                                               \
      status = geos_failed(g, what);                                                               \
      goto done;                                                                                   \
    }                                                                                              \
  } while (0)

/* ---- from polylines to GEOS ---- */

static GEOSCoordSequence *coordinates(struct cmp_geos *g, const struct geo_lines *l, size_t k,
                                      bool close) {
  size_t a = l->first[k], n = l->first[k + 1] - a;
  GEOSCoordSequence *s = GEOSCoordSeq_create_r(g->handle, (unsigned)(n + close), 2);
  for (size_t i = 0; s && i < n + close; i++)
    GEOSCoordSeq_setXY_r(g->handle, s, (unsigned)i, l->p[a + i % n][0], l->p[a + i % n][1]);
  return s;
}

/* A collection of the geometries; takes them over, whatever happens. */
static GEOSGeometry *collect(struct cmp_geos *g, int type, GEOSGeometry **part, size_t n) {
  for (size_t i = 0; i < n; i++)
    if (!part[i]) {
      for (size_t j = 0; j < n; j++)
        if (part[j]) GEOSGeom_destroy_r(g->handle, part[j]);
      return NULL;
    }
  return GEOSGeom_createCollection_r(g->handle, type, part, (unsigned)n);
}

static GEOSGeometry *multi_line(struct cmp_geos *g, const struct geo_lines *l) {
  GEOSGeometry **part = calloc(l->pieces + 1, sizeof(GEOSGeometry *));
  if (!part) return NULL;
  size_t n = 0;
  for (size_t k = 0; k < l->pieces; k++) {
    size_t points = l->first[k + 1] - l->first[k];
    if (points < 2) continue;
    GEOSCoordSequence *s = coordinates(g, l, k, l->closed[k] && points > 2);
    part[n++] = s ? GEOSGeom_createLineString_r(g->handle, s) : NULL;
  }
  GEOSGeometry *all = collect(g, GEOS_MULTILINESTRING, part, n);
  free(part);
  return all;
}

/* The polygons in `any`, without the lines and points that overlays leave where things touch. Takes
 * `any` over; a geometry that is not a collection is returned as it is. */
static GEOSGeometry *polygonal(struct cmp_geos *g, GEOSGeometry *any) {
  if (!any || GEOSGeomTypeId_r(g->handle, any) != GEOS_GEOMETRYCOLLECTION) return any;
  size_t room = 0, n = 0;
  int members = GEOSGetNumGeometries_r(g->handle, any);
  for (int i = 0; i < members; i++)
    room += (size_t)GEOSGetNumGeometries_r(g->handle, GEOSGetGeometryN_r(g->handle, any, i));
  GEOSGeometry **part = calloc(room + 1, sizeof(GEOSGeometry *));
  for (int i = 0; part && i < members; i++) {
    const GEOSGeometry *member = GEOSGetGeometryN_r(g->handle, any, i);
    for (int j = 0; j < GEOSGetNumGeometries_r(g->handle, member); j++) {
      const GEOSGeometry *leaf = GEOSGetGeometryN_r(g->handle, member, j);
      if (GEOSGeomTypeId_r(g->handle, leaf) == GEOS_POLYGON)
        part[n++] = GEOSGeom_clone_r(g->handle, leaf);
    }
  }
  GEOSGeometry *kept = part ? collect(g, GEOS_MULTIPOLYGON, part, n) : NULL;
  free(part);
  GEOSGeom_destroy_r(g->handle, any);
  return kept;
}

/* A valid polygon of a ring that may touch or cross itself. */
static GEOSGeometry *polygon(struct cmp_geos *g, const struct geo_lines *l, size_t k) {
  GEOSCoordSequence *s = coordinates(g, l, k, true);
  GEOSGeometry *ring = s ? GEOSGeom_createLinearRing_r(g->handle, s) : NULL;
  GEOSGeometry *p = ring ? GEOSGeom_createPolygon_r(g->handle, ring, NULL, 0) : NULL;
  if (!p || GEOSisValid_r(g->handle, p) == 1) return p;
  GEOSGeometry *valid = polygonal(g, GEOSMakeValid_r(g->handle, p));
  GEOSGeom_destroy_r(g->handle, p);
  return valid;
}

/* Union of the rings of one sense: clockwise ones are water, counter-clockwise ones cavities. */
static GEOSGeometry *rings_union(struct cmp_geos *g, const struct geo_lines *rings,
                                 bool clockwise) {
  GEOSGeometry **part = calloc(rings->pieces + 1, sizeof(GEOSGeometry *));
  if (!part) return NULL;
  size_t n = 0;
  for (size_t k = 0; k < rings->pieces; k++) {
    if (rings->first[k + 1] - rings->first[k] < 3) continue;
    double area = geo_piece_area(rings, k);
    if (area == 0 || (area < 0) != clockwise) continue;
    part[n++] = polygon(g, rings, k);
  }
  GEOSGeometry *all = collect(g, GEOS_GEOMETRYCOLLECTION, part, n);
  free(part);
  GEOSGeometry *merged = all ? polygonal(g, GEOSUnaryUnion_r(g->handle, all)) : NULL;
  if (all) GEOSGeom_destroy_r(g->handle, all);
  return merged;
}

static GEOSGeometry *box_geometry(struct cmp_geos *g, const struct geo_box *b) {
  return GEOSGeom_createRectangle_r(g->handle, b->min[0], b->min[1], b->max[0], b->max[1]);
}

/* ---- one outline ---- */

void cmp_outline_destroy(struct cmp_outline *o) {
  if (!o) return;
  GEOSContextHandle_t h = o->geos->handle;
  if (o->prepared) GEOSPreparedGeom_destroy_r(h, o->prepared);
  GEOSGeometry *owned[] = {o->main, o->all, o->longest, o->water};
  for (size_t i = 0; i < sizeof owned / sizeof *owned; i++)
    if (owned[i]) GEOSGeom_destroy_r(h, owned[i]);
  geo_lines_destroy(&o->samples);
  geo_lines_destroy(&o->line);
  geo_lines_destroy(&o->walls);
  cmp_furthest_destroy(o->far);
  free(o);
}

static enum status water_region(struct cmp_outline *o, const struct geo_lines *surface,
                                const struct geo_lines *walls, const struct geo_box *window) {
  enum status status = OK;
  struct cmp_geos *g = o->geos;
  struct geo_lines rings = {0};
  GEOSGeometry *water = NULL, *cavities = NULL, *all = NULL, *box = NULL;
  ATTEMPT(cmp_lines_close(surface, walls, 2 * o->spacing, &rings));
  GEOS("join the water", water = rings_union(g, &rings, true));
  GEOS("join the cavities", cavities = rings_union(g, &rings, false));
  GEOS("take the cavities out", all = polygonal(g, GEOSDifference_r(g->handle, water, cavities)));
  GEOS("measure the water", GEOSArea_r(g->handle, all, &o->enclosed));
  GEOS("make the window", box = box_geometry(g, window));
  GEOS("cut the water by the window",
       o->water = polygonal(g, GEOSIntersection_r(g->handle, all, box)));
done:
  for (size_t i = 0; i < 4; i++) {
    GEOSGeometry *owned = (GEOSGeometry *[]){water, cavities, all, box}[i];
    if (owned) GEOSGeom_destroy_r(g->handle, owned);
  }
  geo_lines_destroy(&rings);
  return status;
}

enum status cmp_outline_create(struct cmp_geos *g, const struct geo_lines *surface,
                               const struct geo_lines *walls, const struct geo_box *window,
                               double spacing, double film, struct cmp_outline **out) {
  enum status status = OK;
  struct geo_lines main = {0}, cut = {0}, samples = {0};
  struct cmp_outline *o = calloc(1, sizeof *o);
  CHECK(o, ERR_MEMORY, "no memory for an outline");
  o->geos = g;
  o->spacing = spacing;
  o->film = film;
  ATTEMPT(cmp_lines_main(surface, CMP_MAIN_FRACTION, &main));
  GEOS("take the main surface", o->main = multi_line(g, &main));
  GEOS("index the main surface", o->prepared = GEOSPrepare_r(g->handle, o->main));
  ATTEMPT(cmp_lines_clip(&main, window, &cut));
  for (size_t k = 0; k < cut.pieces; k++) o->length += geo_piece_length(&cut, k);
  ATTEMPT(geo_lines_copy(&o->line, &cut));
  ATTEMPT(geo_lines_copy(&o->walls, walls));
  o->far = cmp_furthest_create(g->handle, &main);
  ATTEMPT(cmp_lines_sample(&cut, spacing, &samples));
  ATTEMPT(cmp_lines_away(&samples, walls, film, &o->samples));
  size_t longest = cmp_piece_longest(&cut);
  if (longest != SIZE_MAX) {
    GEOSCoordSequence *s = coordinates(g, &cut, longest, cut.closed[longest]);
    GEOS("take the longest part", s && (o->longest = GEOSGeom_createLineString_r(g->handle, s)));
  }
  ATTEMPT(cmp_lines_clip(surface, window, &cut));
  GEOS("take the surface", o->all = multi_line(g, &cut));
  ATTEMPT(water_region(o, surface, walls, window));
done:
  geo_lines_destroy(&main);
  geo_lines_destroy(&cut);
  geo_lines_destroy(&samples);
  if (status != OK) {
    cmp_outline_destroy(o);
    o = NULL;
  }
  *out = o;
  return status;
}

double cmp_outline_length(const struct cmp_outline *o) {
  return o->length;
}

double cmp_outline_enclosed(const struct cmp_outline *o) {
  return o->enclosed;
}

/* ---- measures ---- */

static bool either_empty(const struct cmp_outline *a, const struct cmp_outline *b,
                         struct cmp_value *v) {
  bool empty = !a->samples.points || !b->samples.points || !a->far || !b->far;
  if (empty) *v = cmp_unknown("no free surface inside the compared window, away from walls");
  return empty;
}

static enum status one_way(const struct cmp_outline *from, const struct cmp_outline *to,
                           double *mean, struct cmp_distance *d) {
  enum status status = OK;
  struct cmp_geos *g = from->geos;
  double sum = 0;
  for (size_t i = 0; i < from->samples.points; i++) {
    const double *p = from->samples.p[i];
    double distance;
    GEOSGeometry *point;
    GEOS("make a point", point = GEOSGeom_createPointFromXY_r(g->handle, p[0], p[1]));
    int ok = GEOSPreparedDistance_r(g->handle, to->prepared, point, &distance);
    GEOSGeom_destroy_r(g->handle, point);
    GEOS("measure a distance", ok);
    sum += distance;
    if (distance > d->largest) {
      d->largest = distance;
      memcpy(d->at, p, sizeof d->at);
    }
  }
  *mean = sum / (double)from->samples.points;
  ATTEMPT(cmp_furthest_find(to->far, &from->line, &from->walls, from->film, from->spacing,
                            &d->largest, d->at));
done:
  return status;
}

enum status cmp_outline_distance(const struct cmp_outline *a, const struct cmp_outline *b,
                                 struct cmp_distance *d, struct cmp_value *mean,
                                 struct cmp_value *largest) {
  *d = (struct cmp_distance){NAN, 0, {NAN, NAN}};
  if (either_empty(a, b, mean)) {
    *largest = *mean;
    d->largest = NAN;
    return OK;
  }
  double there = 0, back = 0;
  TRY(one_way(a, b, &there, d));
  TRY(one_way(b, a, &back, d));
  d->mean = (there + back) / 2;
  *mean = cmp_number(d->mean);
  *largest = cmp_number(d->largest);
  return OK;
}

typedef int distance_function(GEOSContextHandle_t, const GEOSGeometry *, const GEOSGeometry *,
                              double *);

static enum status densified_distance(const struct cmp_outline *a, const GEOSGeometry *p,
                                      const GEOSGeometry *q, distance_function *f,
                                      struct cmp_value *v) {
  enum status status = OK;
  struct cmp_geos *g = a->geos;
  GEOSGeometry *dense_p = NULL, *dense_q = NULL;
  double distance;
  GEOS("densify", dense_p = GEOSDensify_r(g->handle, p, a->spacing));
  GEOS("densify", dense_q = GEOSDensify_r(g->handle, q, a->spacing));
  GEOS("measure a distance", f(g->handle, dense_p, dense_q, &distance));
  *v = cmp_number(distance);
done:
  if (dense_p) GEOSGeom_destroy_r(g->handle, dense_p);
  if (dense_q) GEOSGeom_destroy_r(g->handle, dense_q);
  return status;
}

enum status cmp_outline_hausdorff(const struct cmp_outline *a, const struct cmp_outline *b,
                                  struct cmp_value *v) {
  if (either_empty(a, b, v)) return OK;
  return densified_distance(a, a->all, b->all, GEOSHausdorffDistance_r, v);
}

/* A closed line that begins at its point k. */
static GEOSGeometry *begun_at(GEOSContextHandle_t h, const GEOSGeometry *line, unsigned k) {
  const GEOSCoordSequence *from = GEOSGeom_getCoordSeq_r(h, line);
  unsigned n = 0;
  if (!from || !GEOSCoordSeq_getSize_r(h, from, &n) || n < 2) return NULL;
  GEOSCoordSequence *to = GEOSCoordSeq_create_r(h, n, 2);
  for (unsigned i = 0; to && i < n; i++) {
    double x = 0, y = 0;
    GEOSCoordSeq_getXY_r(h, from, (k + i) % (n - 1), &x, &y);
    GEOSCoordSeq_setXY_r(h, to, i, x, y);
  }
  return to ? GEOSGeom_createLineString_r(h, to) : NULL;
}

struct beginning {
  double away; /* from the first point of the other line */
  unsigned at;
};

static int nearer(const void *a, const void *b) {
  const struct beginning *p = a, *q = b;
  return p->away != q->away ? (p->away < q->away ? -1 : 1) : (p->at > q->at) - (p->at < q->at);
}

/* The points of a closed line, nearest first to where p begins. NULL: no memory, or no points. */
static struct beginning *beginnings(GEOSContextHandle_t h, const GEOSGeometry *p,
                                    const GEOSGeometry *q, unsigned *n) {
  const GEOSCoordSequence *a = GEOSGeom_getCoordSeq_r(h, p);
  const GEOSCoordSequence *b = GEOSGeom_getCoordSeq_r(h, q);
  double at[2] = {0};
  *n = 0;
  if (!a || !b || !GEOSCoordSeq_getSize_r(h, b, n) || *n < 2) return NULL;
  struct beginning *all = calloc(--*n, sizeof *all);
  GEOSCoordSeq_getXY_r(h, a, 0, &at[0], &at[1]);
  for (unsigned k = 0; all && k < *n; k++) {
    double x = 0, y = 0;
    GEOSCoordSeq_getXY_r(h, b, k, &x, &y);
    all[k] = (struct beginning){hypot(x - at[0], y - at[1]), k};
  }
  if (all) qsort(all, *n, sizeof *all, nearer);
  return all;
}

/* Of closed lines, which begin anywhere: the least over the points of q at which it may begin. The
 * first points are then partners, so that none farther away than the least so far does better. */
static int closed_frechet(GEOSContextHandle_t h, const GEOSGeometry *p, const GEOSGeometry *q,
                          double *distance) {
  unsigned n;
  if (GEOSisClosed_r(h, p) != 1 || GEOSisClosed_r(h, q) != 1)
    return GEOSFrechetDistance_r(h, p, q, distance);
  struct beginning *from = beginnings(h, p, q, &n);
  int fine = from != NULL;
  *distance = INFINITY;
  for (unsigned k = 0; fine && k < n && from[k].away < *distance; k++) {
    GEOSGeometry *turned = begun_at(h, q, from[k].at);
    double here = 0;
    fine = turned && GEOSFrechetDistance_r(h, p, turned, &here);
    if (turned) GEOSGeom_destroy_r(h, turned);
    if (fine) *distance = fmin(*distance, here);
  }
  free(from);
  return fine;
}

enum status cmp_outline_frechet(const struct cmp_outline *a, const struct cmp_outline *b,
                                struct cmp_value *v) {
  if (either_empty(a, b, v)) return OK;
  return densified_distance(a, a->longest, b->longest, closed_frechet, v);
}

enum status cmp_outline_area(const struct cmp_outline *a, const struct cmp_outline *b,
                             struct cmp_value *v) {
  enum status status = OK;
  struct cmp_geos *g = a->geos;
  double area = 0;
  GEOSGeometry *difference = NULL;
  GEOS("subtract two regions", difference = GEOSSymDifference_r(g->handle, a->water, b->water));
  GEOS("measure an area", GEOSArea_r(g->handle, difference, &area));
  *v = cmp_number(area);
done:
  if (difference) GEOSGeom_destroy_r(g->handle, difference);
  return status;
}

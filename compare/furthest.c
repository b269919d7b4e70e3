#include "compare/furthest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/polyline.h"

struct side { /* a segment, or a point: a = b */
  double a[2], b[2];
};

struct cmp_furthest {
  GEOSContextHandle_t handle;
  GEOSSTRtree *tree;
  size_t n;
  struct side *side; /* [n], owned */
};

static double distance_to(const struct side *s, const double *p) {
  double foot[2];
  geo_segment_foot(s->a, s->b, p, foot);
  return hypot(p[0] - foot[0], p[1] - foot[1]);
}

/* GEOS's callback: `sought` is the point, the other one a segment of the tree. */
static int side_distance(const void *one, const void *other, double *distance, void *sought) {
  const struct side *point = sought;
  *distance = distance_to(one == sought ? other : one, point->a);
  return 1;
}

static GEOSGeometry *envelope_of(GEOSContextHandle_t h, const struct side *s) {
  return GEOSGeom_createRectangle_r(h, fmin(s->a[0], s->b[0]), fmin(s->a[1], s->b[1]),
                                    fmax(s->a[0], s->b[0]), fmax(s->a[1], s->b[1]));
}

struct cmp_furthest *cmp_furthest_create(GEOSContextHandle_t h, const struct geo_lines *lines) {
  struct cmp_furthest *f = calloc(1, sizeof *f);
  if (!f) return NULL;
  f->handle = h;
  f->side = calloc(lines->points + 1, sizeof *f->side);
  f->tree = GEOSSTRtree_create_r(h, 10);
  if (!f->side || !f->tree) goto failed;
  for (size_t k = 0; k < lines->pieces; k++) {
    const size_t first = lines->first[k], n = lines->first[k + 1] - first;
    for (size_t i = 0; i < geo_piece_segments(lines, k); i++) {
      struct side *s = &f->side[f->n++];
      memcpy(s->a, lines->p[first + i], sizeof s->a);
      memcpy(s->b, lines->p[first + (i + 1) % n], sizeof s->b);
      GEOSGeometry *box = envelope_of(h, s);
      if (!box) goto failed;
      GEOSSTRtree_insert_r(h, f->tree, box, s);
      GEOSGeom_destroy_r(h, box);
    }
  }
  if (f->n) return f;
failed:
  cmp_furthest_destroy(f);
  return NULL;
}

void cmp_furthest_destroy(struct cmp_furthest *f) {
  if (!f) return;
  if (f->tree) GEOSSTRtree_destroy_r(f->handle, f->tree);
  free(f->side);
  free(f);
}

/* ---- the search ---- */

struct place { /* of the line that is looked at */
  double p[2];
  const struct side *nearest; /* of the other line */
  double distance;
};

struct search {
  const struct cmp_furthest *f;
  const struct geo_lines *walls;
  double film, spacing, *largest, *at;
};

static enum status place_at(const struct search *s, const double *p, struct place *out) {
  struct side point;
  memcpy(point.a, p, sizeof point.a);
  memcpy(point.b, p, sizeof point.b);
  memcpy(out->p, p, sizeof out->p);
  GEOSGeometry *box = envelope_of(s->f->handle, &point);
  out->nearest = box ? GEOSSTRtree_nearest_generic_r(s->f->handle, s->f->tree, &point, box,
                                                     side_distance, &point)
                     : NULL;
  if (box) GEOSGeom_destroy_r(s->f->handle, box);
  CHECK(out->nearest, ERR_SOLVER, "GEOS could not find the nearest segment of a surface");
  out->distance = distance_to(out->nearest, p);
  if (out->distance > *s->largest && cmp_wall_distance(s->walls, p) >= s->film) {
    *s->largest = out->distance;
    memcpy(s->at, p, sizeof out->p);
  }
  return OK;
}

/* No point between two is further than this. The distance from a convex set, such as a segment, is
 * largest at an end; and none changes by more than the way that is walked. */
static double bound_between(const struct place *p, const struct place *q) {
  const double way = hypot(q->p[0] - p->p[0], q->p[1] - p->p[1]);
  const double from_p = fmax(p->distance, distance_to(p->nearest, q->p));
  const double from_q = fmax(q->distance, distance_to(q->nearest, p->p));
  return fmin(0.5 * (p->distance + q->distance + way), fmin(from_p, from_q));
}

static enum status between(const struct search *s, const struct place *p, const struct place *q) {
  const double enough = *s->largest * 1.001 + 1e-6 * s->spacing;
  const double middle[2] = {0.5 * (p->p[0] + q->p[0]), 0.5 * (p->p[1] + q->p[1])};
  const double half = 0.5 * hypot(q->p[0] - p->p[0], q->p[1] - p->p[1]);
  struct place m;
  if (half <= 1e-6 * s->spacing || bound_between(p, q) <= enough) return OK;
  if (s->film > 0 && cmp_wall_distance(s->walls, middle) + half < s->film) return OK;
  TRY(place_at(s, middle, &m));
  TRY(between(s, p, &m));
  return between(s, &m, q);
}

/* Goes along a piece by stretches of about a spacing, or as long as nothing can be further there
 * than what is known, and looks closer at those that may hold something that is. */
static enum status piece_search(const struct search *s, const struct geo_lines *l, size_t k) {
  const size_t first = l->first[k], n = l->first[k + 1] - first,
               segments = geo_piece_segments(l, k);
  struct place begin, end, p, q;
  if (!segments) return OK;
  TRY(place_at(s, l->p[first], &begin));
  for (size_t i = 0, j; i < segments; i = j, begin = end) {
    const double most = fmax(s->spacing, *s->largest - begin.distance);
    double way = 0;
    for (j = i; j < segments && (j == i || way < most); j++) {
      const double *a = l->p[first + j], *b = l->p[first + (j + 1) % n];
      way += hypot(b[0] - a[0], b[1] - a[1]);
    }
    TRY(place_at(s, l->p[first + j % n], &end));
    if (0.5 * (begin.distance + end.distance + way) <= *s->largest) continue;
    for (size_t m = i; m < j; m++, p = q) {
      if (m == i) p = begin;
      TRY(place_at(s, l->p[first + (m + 1) % n], &q));
      TRY(between(s, &p, &q));
    }
  }
  return OK;
}

enum status cmp_furthest_find(const struct cmp_furthest *f, const struct geo_lines *from,
                              const struct geo_lines *walls, double film, double spacing,
                              double *largest, double at[2]) {
  const struct search s = {f, walls, film, spacing, largest, at};
  for (size_t k = 0; k < from->pieces; k++) TRY(piece_search(&s, from, k));
  return OK;
}

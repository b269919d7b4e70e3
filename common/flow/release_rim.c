#include "common/flow/release_rim.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/geometry_check.h"
#include "common/base/triangles.h"

/* Of `size`: what is nearer to a wall along its whole length lies on it, since water does not tell
 * such a gap, which rounded coordinates leave; and the smallest triangles. */
static const double BESIDE = 0.02, SMALLEST = 2e-4;

/* Of the smaller extent of the water: how far from a bend triangles are graded. */
static const double REACH = 0.25;

/* A bend by less than this, radians, is the rounding of a curve. */
static const double ROUND = 0.06 * M_PI;

/* ---- what is wall ---- */

static double distance(const struct geo_lines *walls, const double p[2]) {
  double nearest[2];
  size_t piece;
  return geo_lines_distance(walls, p[0], p[1], nearest, &piece);
}

static bool runs_along(const struct geo_lines *lines, const double a[2], const double b[2],
                       double within) {
  const double middle[2] = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
  return distance(lines, a) <= within && distance(lines, middle) <= within &&
         distance(lines, b) <= within;
}

/* Puts a point between the ends of the edge of the outline that it lies on, if it is at none. */
static enum status put_point(struct geo_lines *outline, const double at[2], double within) {
  for (size_t k = 0; k < outline->pieces; k++)
    for (size_t i = 0; i < geo_piece_segments(outline, k); i++) {
      const double *a = outline->p[outline->first[k] + i], *b = geo_segment_end(outline, k, i);
      double foot[2];
      geo_segment_foot(a, b, at, foot);
      if (hypot(at[0] - foot[0], at[1] - foot[1]) > within) continue;
      if (hypot(at[0] - a[0], at[1] - a[1]) <= within ||
          hypot(at[0] - b[0], at[1] - b[1]) <= within)
        return OK;
      return geo_lines_insert(outline, k, outline->first[k] + i + 1, at[0], at[1]);
    }
  return OK;
}

/* Where two segments cross, both between their ends. */
static bool cross(const double a[2], const double b[2], const double c[2], const double d[2],
                  double at[2]) {
  double side[4];
  geo_line_foot(c, d, a[0], a[1], &side[0]);
  geo_line_foot(c, d, b[0], b[1], &side[1]);
  geo_line_foot(a, b, c[0], c[1], &side[2]);
  geo_line_foot(a, b, d[0], d[1], &side[3]);
  if (side[0] * side[1] >= 0 || side[2] * side[3] >= 0) return false;
  const double part = side[0] / (side[0] - side[1]);
  for (int k = 0; k < 2; k++) at[k] = a[k] + part * (b[k] - a[k]);
  return true;
}

/* Plates that cut the outline where it has no point: between regions with one surface. */
static enum status put_crossings(struct geo_lines *outline, const double c[2], const double d[2],
                                 double within) {
  for (size_t k = 0; k < outline->pieces; k++)
    for (size_t i = 0; i < geo_piece_segments(outline, k); i++) {
      double at[2];
      if (cross(outline->p[outline->first[k] + i], geo_segment_end(outline, k, i), c, d, at))
        TRY(put_point(outline, at, within));
    }
  return OK;
}

static enum status put_walls(struct geo_lines *outline, const struct geo_lines *walls, double near,
                             double beside) {
  for (size_t i = 0; i < walls->points; i++) TRY(put_point(outline, walls->p[i], beside));
  for (size_t k = 0; k < walls->pieces; k++)
    for (size_t i = 0; i < geo_piece_segments(walls, k); i++)
      TRY(put_crossings(outline, walls->p[walls->first[k] + i], geo_segment_end(walls, k, i),
                        near));
  return OK;
}

/* ---- edges and bends ---- */

static enum status add_edge(struct release_rims *r, const double a[2], const double b[2],
                            enum release_kind kind) {
  TRY(array_grow(&r->edge, &r->room, r->n + 1, "the outline of the released pressure"));
  r->edge[r->n++] = (struct release_rim){{{a[0], a[1]}, {b[0], b[1]}}, kind, SIZE_MAX};
  return OK;
}

static enum status add_bend(struct release_rims *r, const double at[2], double lambda) {
  TRY(array_grow(&r->bend, &r->bend_room, r->bends + 1, "the outline of the released pressure"));
  r->bend[r->bends++] = (struct release_bend){{at[0], at[1]}, lambda};
  return OK;
}

/* The angle in the water from the second edge to the first, which ends where that begins. */
static double angle_between(const struct release_rim *in, const struct release_rim *out) {
  const double a[2] = {in->end[0][0] - in->end[1][0], in->end[0][1] - in->end[1][1]};
  const double b[2] = {out->end[1][0] - out->end[0][0], out->end[1][1] - out->end[0][1]};
  const double turn = atan2(b[0] * a[1] - b[1] * a[0], b[0] * a[0] + b[1] * a[1]);
  return turn > 0 ? turn : turn + 2 * M_PI;
}

static enum status find_bend(struct release_rims *r, size_t in, size_t out) {
  const struct release_rim *a = &r->edge[in], *b = &r->edge[out];
  const double angle = angle_between(a, b);
  const bool mixed = a->kind != b->kind;
  const double lambda = M_PI / (mixed ? 2 * angle : angle);
  const bool smooth = lambda >= 2 || (!mixed && fabs(angle - M_PI) < ROUND);
  return smooth ? OK : add_bend(r, b->end[0], lambda);
}

/* Whether the second edge, which begins where the first ends, is more of it. */
static bool goes_on(const struct release_rims *r, size_t first, size_t second, double near) {
  const struct release_rim *a = &r->edge[first], *b = &r->edge[second];
  double off;
  const double part = geo_line_foot(a->end[0], b->end[1], b->end[0][0], b->end[0][1], &off);
  if (a->kind != b->kind || part <= 0 || part >= 1 || fabs(off) > near) return false;
  for (size_t i = 0; i < r->n && r->edge[i].kind == RELEASE_SLIT; i++) /* they come first */
    for (int k = 0; k < 2; k++)
      if (hypot(r->edge[i].end[k][0] - b->end[0][0], r->edge[i].end[k][1] - b->end[0][1]) <= near)
        return false;
  return true;
}

/* Joins what goes on straight of the edges from `first` on, a ring: points along a wall or a
 * surface are no matter. */
static void join_edges(struct release_rims *r, size_t first, double near) {
  size_t last = first;
  for (size_t i = first + 1; i < r->n; i++)
    if (goes_on(r, last, i, near))
      memcpy(r->edge[last].end[1], r->edge[i].end[1], sizeof r->edge[i].end[1]);
    else
      r->edge[++last] = r->edge[i];
  if (goes_on(r, last, first, near))
    memcpy(r->edge[first].end[0], r->edge[last--].end[0], sizeof r->edge[first].end[0]);
  r->n = last + 1;
}

static enum status add_outline(struct release_rims *r, const struct geo_lines *outline,
                               const struct geo_lines *walls, double near, double beside) {
  for (size_t k = 0; k < outline->pieces; k++) {
    const size_t first = r->n;
    for (size_t i = 0; i < geo_piece_segments(outline, k); i++) {
      const double *a = outline->p[outline->first[k] + i], *b = geo_segment_end(outline, k, i);
      TRY(add_edge(r, a, b, runs_along(walls, a, b, beside) ? RELEASE_WALL : RELEASE_SURFACE));
    }
    join_edges(r, first, near);
    for (size_t i = first; i < r->n; i++) r->edge[i].ring = k;
    for (size_t i = first; i < r->n; i++) TRY(find_bend(r, i, i + 1 < r->n ? i + 1 : first));
  }
  return OK;
}

/* ---- plates in the water ---- */

static double along(const double a[2], const double b[2], const double p[2]) {
  double off;
  return geo_line_foot(a, b, p[0], p[1], &off);
}

/* The next point of the outline on the segment beyond a part of it; its end. */
static const double *next_on(const struct geo_lines *outline, const double a[2], const double b[2],
                             double from, double near) {
  const double *next = b, least = near / hypot(b[0] - a[0], b[1] - a[1]);
  for (size_t i = 0; i < outline->points; i++) {
    const double *p = outline->p[i], part = along(a, b, p);
    double foot[2];
    geo_segment_foot(a, b, p, foot);
    if (part > from + least && part < along(a, b, next) - least &&
        hypot(p[0] - foot[0], p[1] - foot[1]) <= near)
      next = p;
  }
  return next;
}

/* The parts of a wall that lie in the water and not on its outline. */
static enum status add_slits(struct release_rims *r, const struct geo_lines *outline,
                             const struct geo_lines *water, const double a[2], const double b[2],
                             double near, double beside) {
  for (const double *from = a, *to = NULL; to != b; from = to) {
    to = next_on(outline, a, b, along(a, b, from), near);
    const double middle[2] = {(from[0] + to[0]) / 2, (from[1] + to[1]) / 2};
    if (runs_along(outline, from, to, beside) || distance(water, middle) > near) continue;
    TRY(add_edge(r, from, to, RELEASE_SLIT));
    TRY(add_bend(r, from, 0.5));
    TRY(add_bend(r, to, 0.5));
  }
  return OK;
}

static enum status add_plates(struct release_rims *r, const struct geo_lines *outline,
                              const struct geo_lines *water, const struct geo_lines *walls,
                              double near, double beside) {
  for (size_t k = 0; k < walls->pieces; k++)
    for (size_t i = 0; i < geo_piece_segments(walls, k); i++)
      TRY(add_slits(r, outline, water, walls->p[walls->first[k] + i], geo_segment_end(walls, k, i),
                    near, beside));
  return OK;
}

enum status release_rims_create(const struct geo_lines *water, const struct geo_lines *walls,
                                double size, double near, struct release_rims *r) {
  const double beside = fmax(BESIDE * size, near);
  struct geo_lines outline = {0};
  enum status status = OK;
  *r = (struct release_rims){.box = geo_lines_box(water), .size = size};
  r->reach = REACH * fmin(r->box.max[0] - r->box.min[0], r->box.max[1] - r->box.min[1]);
  ATTEMPT(geo_lines_outline(water, near, &outline));
  ATTEMPT(put_walls(&outline, walls, near, beside));
  ATTEMPT(add_plates(r, &outline, water, walls, near, beside));
  ATTEMPT(add_outline(r, &outline, walls, near, beside));
done:
  geo_lines_destroy(&outline);
  return status;
}

void release_rims_destroy(struct release_rims *r) {
  free(r->edge);
  free(r->bend);
  *r = (struct release_rims){0};
}

/* Of the closed line that begins with an edge: how many there are, twice the area to their left,
 * and whether some are surface. */
static size_t measure_ring(const struct release_rims *r, size_t first, double *area,
                           bool *has_surface) {
  size_t i = first;
  *area = 0;
  for (; i < r->n && r->edge[i].ring == r->edge[first].ring; i++) {
    *area += geo_triangle_cross(r->edge[first].end[0], r->edge[i].end[0], r->edge[i].end[1]);
    *has_surface |= r->edge[i].kind == RELEASE_SURFACE;
  }
  return i - first;
}

bool release_rims_closed(const struct release_rims *r, double at[2]) {
  size_t body = r->n;
  bool has_surface = true;
  for (size_t i = 0, n; i < r->n; i += n) {
    double area;
    bool of_ring = r->edge[i].kind == RELEASE_SLIT;
    n = measure_ring(r, i, &area, &of_ring);
    if (area > 0) { /* those of its holes follow */
      if (!has_surface) break;
      has_surface = false;
      body = i;
    }
    has_surface |= of_ring;
  }
  if (!has_surface) memcpy(at, r->edge[body].end[0], sizeof r->edge[body].end[0]);
  return !has_surface;
}

double release_rims_size(const struct release_rims *r, const double at[2]) {
  double size = r->size;
  for (size_t i = 0; i < r->bends; i++) {
    const struct release_bend *b = &r->bend[i];
    const double part = hypot(at[0] - b->at[0], at[1] - b->at[1]) / r->reach;
    if (part < 1) size = fmin(size, r->size * pow(part, 1 - b->lambda / 2));
  }
  return fmax(size, SMALLEST * r->size);
}

#include "common/tank/faces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/geometry_check.h"

static const double same_angle = 1e-6;   /* rad; walls are known no better (case_near) */
static const double same_place = 1e-6;   /* of the size of the walls */
static const double edge = 5 * M_PI / 6; /* turns by so much, or more, away from the water */

void faces_destroy(struct faces *f) {
  free(f->face);
  free(f->top);
  *f = (struct faces){0};
}

uint32_t faces_unfilled(const struct faces *f) {
  for (uint32_t k = 0; k < f->n; k++) {
    const double turn = f->face[k].turn;
    if (f->face[k].end[1] != FACE_END_TOP && !(turn >= 0 && turn < M_PI / 2 + 1e-6)) return k;
  }
  return FACE_NONE;
}

static double turn_from(const double t[2], const double to[2]) {
  return atan2(t[0] * to[1] - t[1] * to[0], t[0] * to[0] + t[1] * to[1]);
}

/* ---- pieces ---- */

static void put(struct face *f, const double a[2], const double b[2]) {
  const double x = b[0] - a[0], y = b[1] - a[1];
  memcpy(f->a, a, sizeof f->a);
  memcpy(f->b, b, sizeof f->b);
  f->length = hypot(x, y);
  f->t[0] = x / f->length;
  f->t[1] = y / f->length;
}

static enum status add(struct faces *f, const double a[2], const double b[2], uint32_t at_a,
                       uint32_t at_b) {
  struct face new = {.before = FACE_NONE, .next = FACE_NONE, .point = {at_a, at_b}};
  put(&new, a, b);
  if (!(new.length > 0)) return OK;
  TRY(array_grow(&f->face, &f->room, f->n + 1, "faces of walls"));
  f->face[f->n++] = new;
  return OK;
}

/* The vertex after i at which a piece turns, or may, or its last. */
static size_t next_corner(const struct geo_lines *walls, size_t piece, size_t i,
                          const bool *bends) {
  const size_t first = walls->first[piece], n = walls->first[piece + 1] - first;
  const size_t last = walls->closed[piece] ? n : n - 1;
  for (size_t j = i + 1; j < last; j++) {
    const double *p = walls->p[first + i], *q = walls->p[first + j];
    const double *r = walls->p[first + (j + 1) % n];
    const double in[2] = {q[0] - p[0], q[1] - p[1]}, out[2] = {r[0] - q[0], r[1] - q[1]};
    if (bends && bends[first + j]) return j;
    if (fabs(turn_from(in, out)) > same_angle) return j;
  }
  return last;
}

static enum status add_piece(struct faces *f, const struct geo_lines *walls, size_t piece,
                             const bool *bends) {
  const size_t first = walls->first[piece], n = walls->first[piece + 1] - first;
  const size_t last = walls->closed[piece] ? n : n - 1;
  for (size_t i = 0, j; n > 1 && i < last; i = j) {
    j = next_corner(walls, piece, i, bends);
    const size_t a = first + i, b = first + j % n;
    TRY(add(f, walls->p[a], walls->p[b], (uint32_t)a, (uint32_t)b));
  }
  return OK;
}

/* Faces from `from` on, the other way round, too. */
static enum status add_backs(struct faces *f, size_t from) {
  for (size_t k = f->n; k > from; k--) {
    const struct face front = f->face[k - 1];
    TRY(add(f, front.b, front.a, front.point[1], front.point[0]));
  }
  return OK;
}

/* ---- what follows what ---- */

static bool is_at(const double p[2], const double q[2], double near) {
  return fabs(p[0] - q[0]) <= near && fabs(p[1] - q[1]) <= near;
}

/* Divides the faces that another one begins or ends on. */
static enum status divide(struct faces *f, double near) {
  for (size_t k = 0; k < f->n; k++)
    for (size_t j = 0; j < f->n; j++)
      for (int end = 0; end < 2; end++) {
        const double at[2] = {(end ? f->face[j].b : f->face[j].a)[0],
                              (end ? f->face[j].b : f->face[j].a)[1]};
        const struct face whole = f->face[k];
        const double s = face_along(&whole, at[0], at[1]);
        if (s <= near || s >= whole.length - near) continue;
        if (fabs(face_distance(&whole, at[0], at[1])) > near) continue;
        const size_t n = f->n;
        TRY(add(f, whole.a, at, whole.point[0], FACE_NO_POINT));
        f->face[k] = f->face[n];
        f->n = n;
        TRY(add(f, at, whole.b, FACE_NO_POINT, whole.point[1]));
      }
  return OK;
}

/* Of the faces that begin where this one ends, the first that water on its left meets; the way back
 * comes last. */
static void link(struct faces *f, uint32_t k, double near) {
  struct face *face = &f->face[k];
  face->turn = -INFINITY;
  for (uint32_t j = 0; j < f->n; j++) {
    if (j == k || !is_at(face->b, f->face[j].a, near)) continue;
    double turn = turn_from(face->t, f->face[j].t);
    if (fabs(turn) > M_PI - same_angle) turn = -M_PI;
    if (turn <= face->turn) continue;
    face->turn = turn;
    face->next = j;
  }
}

static enum face_end end_of(const struct face *f) {
  if (f->next == FACE_NONE) return FACE_END_TOP;
  if (f->turn > -same_angle) return FACE_END_CORNER;
  return f->turn > -edge + same_angle ? FACE_END_BLUNT : FACE_END_EDGE;
}

/* Whether it is the end of a thin wall: between two blunt corners that turn the wall back. */
static bool is_end(const struct faces *f, const struct face *k, double thin) {
  if (k->length > thin || k->end[0] != FACE_END_BLUNT || k->end[1] != FACE_END_BLUNT) return false;
  const struct face *before = &f->face[k->before], *next = &f->face[k->next];
  const double least = k->length * (1 - same_place);
  return before->turn + k->turn <= -edge + same_angle && before->length >= least &&
         next->length >= least && before->end[0] != FACE_END_HALF && next->end[1] != FACE_END_HALF;
}

static void middle(const double a[2], const double b[2], double m[2]) {
  for (int axis = 0; axis < 2; axis++) m[axis] = (a[axis] + b[axis]) / 2;
}

static enum status halve(struct faces *f, uint32_t k) {
  const struct face whole = f->face[k];
  const uint32_t other = (uint32_t)f->n;
  double m[2];
  middle(whole.a, whole.b, m);
  TRY(add(f, m, whole.b, FACE_NO_POINT, whole.point[1]));
  struct face *first = &f->face[k], *last = &f->face[other];
  put(first, whole.a, m);
  first->point[1] = FACE_NO_POINT;
  first->turn = 0;
  first->next = other;
  last->before = k;
  last->next = whole.next;
  last->turn = whole.turn;
  f->face[whole.next].before = other;
  first->end[1] = last->end[0] = FACE_END_HALF;
  last->end[1] = whole.end[1];
  return OK;
}

static enum status part_thin(struct faces *f, double thin) {
  for (uint32_t k = 0; k < f->n; k++)
    if (is_end(f, &f->face[k], thin)) TRY(halve(f, k));
  return OK;
}

static bool parts(enum face_end end) {
  return end == FACE_END_TOP || end == FACE_END_EDGE || end == FACE_END_HALF;
}

static void number_chain(struct faces *f, uint32_t first, uint32_t chain) {
  for (uint32_t k = first; k != FACE_NONE && f->face[k].chain == FACE_NONE;) {
    struct face *face = &f->face[k];
    face->chain = chain;
    k = parts(face->end[1]) ? FACE_NONE : face->next;
  }
}

static enum status join(struct faces *f, double near, double thin) {
  for (uint32_t k = 0; k < f->n; k++) link(f, k, near);
  for (uint32_t k = 0; k < f->n; k++) {
    f->face[k].end[1] = end_of(&f->face[k]);
    if (f->face[k].next == FACE_NONE) continue;
    f->face[f->face[k].next].before = k;
    f->face[f->face[k].next].end[0] = f->face[k].end[1];
  }
  TRY(part_thin(f, thin));
  for (uint32_t k = 0; k < f->n; k++) f->face[k].chain = FACE_NONE;
  uint32_t chain = 0;
  for (uint32_t k = 0; k < f->n; k++)
    if (parts(f->face[k].end[0])) number_chain(f, k, chain++);
  for (uint32_t k = 0; k < f->n; k++) /* those without an end */
    if (f->face[k].chain == FACE_NONE) number_chain(f, k, chain++);
  return OK;
}

static enum status list_tops(struct faces *f) {
  f->n_tops = 0;
  for (size_t k = 0; k < 2 * f->n; k++) {
    if (f->face[k / 2].end[k % 2] != FACE_END_TOP) continue;
    TRY(array_grow(&f->top, &f->top_room, f->n_tops + 1, "faces of walls"));
    f->top[f->n_tops++] = (uint32_t)k;
  }
  return OK;
}

enum status faces_set(struct faces *f, const struct geo_lines *walls, double thin,
                      const bool *bends) {
  const struct geo_box box = geo_lines_box(walls);
  const double near = same_place * hypot(box.max[0] - box.min[0], box.max[1] - box.min[1]);
  const size_t vessel = walls->pieces == 1 ? 0 : geo_lines_vessel(walls);
  f->n = 0;
  for (size_t piece = 0; piece < walls->pieces; piece++) {
    const size_t from = f->n;
    TRY(add_piece(f, walls, piece, bends));
    if (piece != vessel && !walls->closed[piece]) TRY(add_backs(f, from));
  }
  TRY(divide(f, near));
  TRY(join(f, near, thin));
  return list_tops(f);
}

/* A wall that turns back upon itself stays what it was. */
static void bend(struct faces *f, struct face *face) {
  if (face->next == FACE_NONE || fabs(face->turn) > M_PI - same_angle) return;
  struct face *next = &f->face[face->next];
  face->turn = turn_from(face->t, next->t);
  if (face->end[1] == FACE_END_CORNER || face->end[1] == FACE_END_BLUNT)
    face->end[1] = next->end[0] = face->turn > -same_angle ? FACE_END_CORNER : FACE_END_BLUNT;
}

/* The middle of a thin wall's end is no point of the walls. */
static void halve_again(struct faces *f, struct face *first) {
  struct face *last = &f->face[first->next];
  const struct face was[2] = {*first, *last};
  double m[2];
  middle(was[0].a, was[1].b, m);
  put(first, was[0].a, m);
  put(last, m, was[1].b);
}

void faces_move(struct faces *f, const double (*p)[2]) {
  for (size_t k = 0; k < f->n; k++) {
    struct face *face = &f->face[k];
    const struct face was = *face;
    put(face, was.point[0] == FACE_NO_POINT ? was.a : p[was.point[0]],
        was.point[1] == FACE_NO_POINT ? was.b : p[was.point[1]]);
  }
  for (size_t k = 0; k < f->n; k++)
    if (f->face[k].end[1] == FACE_END_HALF) halve_again(f, &f->face[k]);
  for (size_t k = 0; k < f->n; k++) bend(f, &f->face[k]);
}

bool face_stops(const struct face *f, const double p[2], const double q[2], double slack,
                double *part) {
  const double from = face_distance(f, p[0], p[1]), to = face_distance(f, q[0], q[1]);
  if (!(from >= -slack && to < 0 && to < from)) return false;
  *part = from > 0 ? from / (from - to) : 0;
  const double s = face_along(f, p[0] + *part * (q[0] - p[0]), p[1] + *part * (q[1] - p[1]));
  const double more = 1e-9 * f->length; /* no way leads between two faces */
  return s >= -more && s <= f->length + more;
}

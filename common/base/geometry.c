#include "common/base/geometry.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"

void geo_lines_destroy(struct geo_lines *l) {
  if (!l) return;
  free(l->first);
  free(l->closed);
  free(l->p);
  *l = (struct geo_lines){0};
}

void geo_lines_clear(struct geo_lines *l) {
  l->pieces = l->points = 0;
}

static enum status reserve(struct geo_lines *l, size_t pieces, size_t points) {
  size_t room = array_room(l->piece_room, pieces);
  if (!l->first || room > l->piece_room) {
    TRY(array_resize(&l->first, room + 1, "polylines"));
    TRY(array_resize(&l->closed, room, "polylines"));
    l->piece_room = room;
  }
  return array_grow(&l->p, &l->point_room, points, "points of polylines");
}

enum status geo_lines_begin(struct geo_lines *l, bool closed) {
  TRY(reserve(l, l->pieces + 1, l->points));
  l->first[0] = 0;
  l->closed[l->pieces++] = closed;
  l->first[l->pieces] = l->points;
  return OK;
}

enum status geo_lines_add(struct geo_lines *l, double x, double y) {
  TRY(reserve(l, l->pieces, l->points + 1));
  l->p[l->points][0] = x;
  l->p[l->points][1] = y;
  l->first[l->pieces] = ++l->points;
  return OK;
}

enum status geo_lines_insert(struct geo_lines *l, size_t piece, size_t i, double x, double y) {
  TRY(reserve(l, l->pieces, l->points + 1));
  memmove(l->p + i + 1, l->p + i, (l->points++ - i) * sizeof *l->p);
  l->p[i][0] = x;
  l->p[i][1] = y;
  for (size_t k = piece; k < l->pieces; k++) l->first[k + 1]++;
  return OK;
}

enum status geo_lines_copy(struct geo_lines *to, const struct geo_lines *from) {
  geo_lines_clear(to);
  TRY(reserve(to, from->pieces, from->points));
  to->pieces = from->pieces;
  to->points = from->points;
  to->first[0] = 0;
  if (from->pieces) {
    memcpy(to->first, from->first, (from->pieces + 1) * sizeof *to->first);
    memcpy(to->closed, from->closed, from->pieces);
  }
  if (from->points) memcpy(to->p, from->p, from->points * sizeof *to->p);
  return OK;
}

enum status geo_lines_add_piece(struct geo_lines *to, const struct geo_lines *from, size_t piece) {
  TRY(geo_lines_begin(to, from->closed[piece]));
  for (size_t i = from->first[piece]; i < from->first[piece + 1]; i++)
    TRY(geo_lines_add(to, from->p[i][0], from->p[i][1]));
  return OK;
}

double geo_piece_area(const struct geo_lines *l, size_t piece) {
  double area = 0;
  size_t a = l->first[piece], b = l->first[piece + 1];
  for (size_t i = a; i < b; i++) {
    const double *p = l->p[i], *q = l->p[i + 1 < b ? i + 1 : a];
    /* relative to the first point, so that a small piece far from the origin keeps its digits */
    area += (p[0] - l->p[a][0]) * (q[1] - l->p[a][1]) - (q[0] - l->p[a][0]) * (p[1] - l->p[a][1]);
  }
  return area / 2;
}

double geo_piece_length(const struct geo_lines *l, size_t piece) {
  double length = 0;
  size_t a = l->first[piece], b = l->first[piece + 1];
  for (size_t i = a; i + 1 < b; i++)
    length += hypot(l->p[i + 1][0] - l->p[i][0], l->p[i + 1][1] - l->p[i][1]);
  if (l->closed[piece] && b > a)
    length += hypot(l->p[a][0] - l->p[b - 1][0], l->p[a][1] - l->p[b - 1][1]);
  return length;
}

struct geo_box geo_lines_box(const struct geo_lines *l) {
  if (!l->points) return (struct geo_box){{0, 0}, {0, 0}};
  struct geo_box box = {{l->p[0][0], l->p[0][1]}, {l->p[0][0], l->p[0][1]}};
  for (size_t i = 1; i < l->points; i++)
    for (int k = 0; k < 2; k++) {
      box.min[k] = fmin(box.min[k], l->p[i][k]);
      box.max[k] = fmax(box.max[k], l->p[i][k]);
    }
  return box;
}

bool geo_lines_contain(const struct geo_lines *l, double x, double y) {
  size_t piece;
  return geo_lines_find(l, x, y, &piece);
}

bool geo_lines_find(const struct geo_lines *l, double x, double y, size_t *piece) {
  for (size_t k = 0; k < l->pieces; k++) {
    if (!l->closed[k]) continue;
    bool inside = false;
    size_t a = l->first[k], b = l->first[k + 1];
    for (size_t i = a, j = b - 1; i < b; j = i++) {
      const double *p = l->p[i], *q = l->p[j];
      if ((p[1] > y) != (q[1] > y) && x < (q[0] - p[0]) * (y - p[1]) / (q[1] - p[1]) + p[0])
        inside = !inside;
    }
    *piece = k;
    if (inside) return true;
  }
  return false;
}

/* ---- cuts ---- */

/* Adds the spans of one piece: its crossings with the line, in order, go in and out of it in turn.
 */
static void cut_piece(const struct geo_lines *l, size_t piece, int axis, double at,
                      struct geo_cut *cut) {
  double *crossing = cut->span[cut->n];
  size_t a = l->first[piece], b = l->first[piece + 1], n = 0;
  for (size_t i = a; i < b; i++) {
    const double *p = l->p[i], *q = l->p[i + 1 < b ? i + 1 : a];
    if ((p[axis] > at) == (q[axis] > at)) continue;
    double t = (at - p[axis]) / (q[axis] - p[axis]);
    crossing[n++] = p[!axis] + (q[!axis] - p[!axis]) * t;
  }
  qsort(crossing, n, sizeof *crossing, array_ascending);
  cut->n += n / 2;
}

enum status geo_lines_cut(const struct geo_lines *l, int axis, double at, double near,
                          struct geo_cut *cut) {
  cut->n = 0;
  /* a piece is crossed as often as it has sides */
  TRY(array_grow(&cut->span, &cut->room, l->points + 1, "spans of a cut"));
  for (size_t k = 0; k < l->pieces; k++)
    if (l->closed[k]) cut_piece(l, k, axis, at, cut);
  qsort(cut->span, cut->n, sizeof *cut->span, array_ascending);
  size_t joined = 0;
  for (size_t k = 0; k < cut->n; k++) {
    double *last = joined ? cut->span[joined - 1] : NULL;
    if (last && cut->span[k][0] <= last[1] + near)
      last[1] = fmax(last[1], cut->span[k][1]);
    else
      memmove(cut->span[joined++], cut->span[k], sizeof *cut->span);
  }
  cut->n = joined;
  return OK;
}

void geo_cut_destroy(struct geo_cut *cut) {
  if (!cut) return;
  free(cut->span);
  *cut = (struct geo_cut){0};
}

const double *geo_cut_span(const struct geo_cut *cut, double along) {
  const double *best = NULL;
  double nearest = INFINITY;
  for (size_t k = 0; k < cut->n; k++) {
    double away = fmax(cut->span[k][0] - along, along - cut->span[k][1]);
    if (away >= nearest) continue;
    nearest = away;
    best = cut->span[k];
  }
  return best;
}

size_t geo_intervals(double length, double spacing) {
  return (size_t)fmax(1, floor(length / spacing + 0.5));
}

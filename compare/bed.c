#include "compare/bed.h"

#include <math.h>

#include "common/base/gauge.h"

/* ---- the bed ---- */

/* Its height beside x, to the right of it or to the left: of the lowest wall there. */
static double height_beside(const struct geo_lines *walls, double x, bool right) {
  double lowest = INFINITY;
  for (size_t k = 0; k < walls->pieces; k++)
    for (size_t i = 0; i < geo_piece_segments(walls, k); i++) {
      const double *p = walls->p[walls->first[k] + i], *q = geo_segment_end(walls, k, i);
      const bool p_before = right ? p[0] <= x : p[0] < x, q_before = right ? q[0] <= x : q[0] < x;
      if (p_before == q_before) continue;
      lowest = fmin(lowest, p[1] + (x - p[0]) / (q[0] - p[0]) * (q[1] - p[1]));
    }
  return lowest;
}

/* Beyond its ends it goes on as there. */
static double bed_at(const struct geo_lines *walls, const struct geo_box *box, double x,
                     bool right) {
  if (x <= box->min[0]) return height_beside(walls, box->min[0], true);
  if (x >= box->max[0]) return height_beside(walls, box->max[0], false);
  return height_beside(walls, x, right);
}

/* The next corner of the walls on the way from `from` to `to`, or `to`. */
static double next_corner(const struct geo_lines *walls, double from, double to) {
  double next = to;
  for (size_t i = 0; i < walls->points; i++) {
    const double x = walls->p[i][0];
    if (to > from ? x > from && x < next : x < from && x > next) next = x;
  }
  return next;
}

static bool is_level(const struct geo_lines *walls, const struct geo_box *box) {
  double x = box->min[0];
  while (x < box->max[0]) {
    const double to = next_corner(walls, x, box->max[0]);
    if (bed_at(walls, box, x, true) != box->min[1] || bed_at(walls, box, to, false) != box->min[1])
      return false;
    x = to;
  }
  return true;
}

/* From p to q, cut at the corners of the walls, where the bed may be a step. */
static enum status add_heights(const struct geo_lines *walls, const struct geo_box *box,
                               const double p[2], const double q[2], struct geo_lines *out) {
  const bool right = q[0] > p[0];
  double x = p[0];
  if (q[0] == x) { /* before the face of a step */
    const double bed = fmin(bed_at(walls, box, x, false), bed_at(walls, box, x, true));
    TRY(geo_lines_add(out, x, p[1] - bed));
    return geo_lines_add(out, x, q[1] - bed);
  }
  TRY(geo_lines_add(out, x, p[1] - bed_at(walls, box, x, right)));
  while (x != q[0]) {
    x = next_corner(walls, x, q[0]);
    const double y = x == q[0] ? q[1] : p[1] + (x - p[0]) / (q[0] - p[0]) * (q[1] - p[1]);
    TRY(geo_lines_add(out, x, y - bed_at(walls, box, x, !right)));
    if (x != q[0]) TRY(geo_lines_add(out, x, y - bed_at(walls, box, x, right)));
  }
  return OK;
}

/* The surface over a bed that is made level at 0. */
static enum status level_out(const struct geo_lines *walls, const struct geo_box *box,
                             const struct geo_lines *surface, struct geo_lines *out) {
  for (size_t k = 0; k < surface->pieces; k++) {
    TRY(geo_lines_begin(out, surface->closed[k]));
    for (size_t i = 0; i < geo_piece_segments(surface, k); i++)
      TRY(add_heights(walls, box, surface->p[surface->first[k] + i], geo_segment_end(surface, k, i),
                      out));
  }
  return OK;
}

/* ---- the front ---- */

/* The mirror image, its pieces walked backwards: the water stays on the right. */
static enum status mirror(const struct geo_lines *from, struct geo_lines *to) {
  for (size_t k = 0; k < from->pieces; k++) {
    TRY(geo_lines_begin(to, from->closed[k]));
    for (size_t i = from->first[k + 1]; i-- > from->first[k];)
      TRY(geo_lines_add(to, -from->p[i][0], from->p[i][1]));
  }
  return OK;
}

static enum status front_of(const struct geo_lines *surface, enum cmp_side side, double bed,
                            double depth, double *front) {
  struct geo_lines mirrored = {0};
  if (side == CMP_RIGHT) {
    *front = gauge_front(surface, bed, depth);
    return OK;
  }
  enum status status = mirror(surface, &mirrored);
  *front = status == OK ? -gauge_front(&mirrored, bed, depth) : NAN;
  geo_lines_destroy(&mirrored);
  return status;
}

enum status cmp_bed_front(const struct geo_lines *walls, const struct geo_lines *surface,
                          enum cmp_side side, double depth, double *front) {
  const struct geo_box box = geo_lines_box(walls);
  struct geo_lines level = {0};
  if (is_level(walls, &box)) return front_of(surface, side, box.min[1], depth, front);
  enum status status = level_out(walls, &box, surface, &level);
  if (status == OK) status = front_of(&level, side, 0, depth, front);
  geo_lines_destroy(&level);
  return status;
}

/* ---- the wall ---- */

/* Points of the walls on the way from their end on that side. */
struct way {
  const struct geo_lines *walls;
  size_t first, n; /* points of the piece */
  size_t at;
  bool forth, closed;
};

/* Where walls end, or where a closed one is highest; farthest out. */
static struct way way_from(const struct geo_lines *walls, enum cmp_side side) {
  const double out = side == CMP_RIGHT ? 1 : -1;
  const double *best = NULL;
  struct way way = {.walls = walls, .forth = side == CMP_LEFT};
  for (size_t k = 0; k < walls->pieces; k++) {
    const size_t a = walls->first[k], n = walls->first[k + 1] - a;
    for (size_t i = 0; i < n; i++) {
      const double *p = walls->p[a + i];
      const bool end = walls->closed[k] || i == (way.forth ? 0 : n - 1);
      const bool higher = best && walls->closed[k] && p[1] > best[1];
      const bool level = best && (!walls->closed[k] || p[1] == best[1]);
      if (!end || (best && !higher && !(level && out * p[0] > out * best[0]))) continue;
      best = p;
      way = (struct way){walls, a, n, i, way.forth, walls->closed[k]};
    }
  }
  return way;
}

static bool next_point(struct way *w) {
  const bool last = w->at == (w->forth ? w->n - 1 : 0);
  if (w->n == 0 || (last && !w->closed)) return false;
  w->at = (w->at + (w->forth ? 1 : w->n - 1)) % w->n;
  return true;
}

/* The wall's next segment, from its end on; false at its foot. */
static bool next_segment(struct way *w, const double **p, const double **q) {
  *p = w->walls->p[w->first + w->at];
  if (!next_point(w)) return false;
  *q = w->walls->p[w->first + w->at];
  return fabs((*q)[1] - (*p)[1]) > fabs((*q)[0] - (*p)[0]);
}

double cmp_bed_foot(const struct geo_lines *walls, enum cmp_side side) {
  struct way w = way_from(walls, side);
  const double *p, *q;
  if (!w.n) return NAN;
  for (size_t i = 0; i < w.n; i++)
    if (!next_segment(&w, &p, &q)) break;
  return p[0];
}

bool cmp_bed_is_at_wall(const struct geo_lines *walls, enum cmp_side side, const double at[2],
                        double near) {
  struct way w = way_from(walls, side);
  const double *p, *q;
  for (size_t i = 0; i < w.n && next_segment(&w, &p, &q); i++) {
    double foot[2];
    geo_segment_foot(p, q, at, foot);
    if (hypot(at[0] - foot[0], at[1] - foot[1]) <= near) return true;
  }
  return false;
}

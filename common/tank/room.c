#include "common/tank/room.h"

#include <math.h>

#include "common/base/geometry_check.h"
#include "common/tank/motion.h"
#include "common/tank/tank.h"

/* ---- walls that meet ---- */

static const double *start_of(const struct geo_lines *l, size_t k) {
  return l->p[l->first[k]];
}

static const double *end_of(const struct geo_lines *l, size_t k) {
  return l->p[l->first[k + 1] - 1];
}

static double apart(const double *p, const double *q) {
  return hypot(p[0] - q[0], p[1] - q[1]);
}

/* The open wall, not yet taken, that begins where k ends; pieces: none. */
static size_t next_of(const struct geo_lines *l, const bool *taken, const double *end,
                      double near) {
  for (size_t k = 0; k < l->pieces; k++)
    if (!taken[k] && !l->closed[k] && apart(end, start_of(l, k)) <= near) return k;
  return l->pieces;
}

/* The first wall of the chain that k is in; of a ring, k itself. */
static size_t first_of_chain(const struct geo_lines *l, size_t k, double near) {
  size_t first = k;
  for (size_t steps = 0; steps < l->pieces; steps++) {
    size_t before = 0;
    while (before < l->pieces && (l->closed[before] || before == first ||
                                  apart(end_of(l, before), start_of(l, first)) > near))
      before++;
    if (before == l->pieces || before == k) break;
    first = before;
  }
  return first;
}

static enum status add_chain(const struct geo_lines *from, size_t k, double near, bool *taken,
                             struct geo_lines *to) {
  taken[k] = true;
  TRY(geo_lines_add_piece(to, from, k));
  while ((k = next_of(from, taken, end_of(from, k), near)) < from->pieces) {
    taken[k] = true;
    for (size_t i = from->first[k] + 1; i < from->first[k + 1]; i++)
      TRY(geo_lines_add(to, from->p[i][0], from->p[i][1]));
  }
  const size_t piece = to->pieces - 1;
  if (to->points - to->first[piece] > 3 && apart(start_of(to, piece), end_of(to, piece)) <= near) {
    to->first[to->pieces] = --to->points;
    to->closed[piece] = 1;
  }
  return OK;
}

enum status tank_join_walls(struct geo_lines *walls, double near, size_t *item) {
  bool taken[TANK_MOST_WALLS] = {false};
  struct geo_lines joined = {0};
  enum status status = OK;
  if (walls->pieces < 2 || walls->pieces > TANK_MOST_WALLS) return OK;
  for (size_t k = 0; k < walls->pieces && status == OK; k++) {
    if (taken[k]) continue;
    const size_t first = walls->closed[k] ? k : first_of_chain(walls, k, near);
    item[joined.pieces] = item[first];
    status = walls->closed[k] ? geo_lines_add_piece(&joined, walls, k)
                              : add_chain(walls, first, near, taken, &joined);
  }
  if (status == OK && joined.pieces < walls->pieces) status = geo_lines_copy(walls, &joined);
  geo_lines_destroy(&joined);
  return status;
}

bool tank_find_gap(const struct geo_lines *walls, struct tank_gap *gap) {
  gap->width = INFINITY;
  for (size_t k = 0; k < walls->pieces; k++)
    for (size_t j = 0; j < k; j++)
      for (int e = 0; e < 4; e++) {
        if (walls->closed[k] || walls->closed[j]) continue;
        const double *p = e & 1 ? end_of(walls, k) : start_of(walls, k);
        const double *q = e & 2 ? end_of(walls, j) : start_of(walls, j);
        const double width = apart(p, q);
        if (width >= gap->width || width == 0) continue;
        *gap = (struct tank_gap){width, {q[0], q[1]}, {j, k}};
      }
  return isfinite(gap->width);
}

/* ---- inside ---- */

/* Whether an edge from p to q is crossed on the way from (x, y) to the right, for ever. */
static bool crosses(const double p[2], const double q[2], double x, double y) {
  return (p[1] > y) != (q[1] > y) && x < (q[0] - p[0]) * (y - p[1]) / (q[1] - p[1]) + p[0];
}

static bool inside_piece(const struct geo_lines *l, size_t k, double x, double y) {
  bool inside = false;
  for (size_t i = 0; i < geo_piece_segments(l, k); i++)
    inside ^= crosses(l->p[l->first[k] + i], geo_segment_end(l, k, i), x, y);
  return inside;
}

/* Between the sides of an open wall, which go on upwards: with edges from far above to its start
 * and from its end to far above. */
static bool inside_vessel(const struct geo_lines *l, size_t k, double x, double y) {
  const double *a = start_of(l, k), *b = end_of(l, k);
  const bool inside = inside_piece(l, k, x, y);
  return inside ^ (y >= a[1] && x < a[0]) ^ (y >= b[1] && x < b[0]);
}

bool tank_contains(const struct geo_lines *walls, double x, double y) {
  const size_t vessel = geo_lines_vessel(walls);
  bool bounded = vessel < walls->pieces;
  bool inside = bounded && inside_vessel(walls, vessel, x, y);
  for (size_t k = 0; k < walls->pieces; k++) {
    if (!walls->closed[k]) continue;
    const bool lid = geo_piece_area(walls, k) > 0, in = inside_piece(walls, k, x, y);
    if (in && !lid) return false;
    bounded |= lid;
    inside |= in && lid;
  }
  return inside || !bounded;
}

double tank_distance(const struct geo_lines *walls, double x, double y, double nearest[2]) {
  size_t piece = 0;
  const double way = geo_lines_distance(walls, x, y, nearest, &piece);
  return tank_contains(walls, x, y) ? way : -way;
}

/* ---- periodic sides ---- */

void tank_find_bed(const struct geo_lines *walls, size_t *first, size_t *last) {
  struct tank_side left = {0}, right = {0};
  if (!tank_find_side(walls, TANK_LEFT, &left) || !tank_find_side(walls, TANK_RIGHT, &right))
    left.foot = right.foot = 0;
  *first = left.foot;
  *last = right.foot;
}

static bool upright(const struct geo_lines *walls, const struct tank_side *s, double x,
                    double near) {
  const double *top = walls->p[s->top], *foot = walls->p[s->foot];
  return fabs(top[0] - x) <= near && fabs(foot[0] - x) <= near && top[1] > foot[1];
}

bool tank_can_be_round(const struct geo_lines *walls, double near) {
  const struct geo_box box = geo_lines_box(walls);
  struct tank_side left, right;
  if (walls->pieces != 1 || walls->closed[0] || walls->points < 4 ||
      !tank_find_side(walls, TANK_LEFT, &left) || !tank_find_side(walls, TANK_RIGHT, &right))
    return false;
  if (!upright(walls, &left, box.min[0], near) || !upright(walls, &right, box.max[0], near) ||
      fabs(walls->p[left.foot][1] - walls->p[right.foot][1]) > near)
    return false;
  for (size_t i = left.foot; i < right.foot; i++)
    if (walls->p[i + 1][0] < walls->p[i][0] - near) return false;
  return left.foot < right.foot;
}

#include "common/base/gauge.h"

#include <math.h>

enum side { FROM_LEFT, FROM_RIGHT };

/* Height of the water standing on the bed, in the limit of the vertical approaching x from one
 * side. Half-open segments: each vertex belongs to exactly one of the two segments that meet there,
 * and vertical ones never count, so crossings alternate as they must. */
static double elevation(const struct geo_lines *l, double x, enum side side, double bed) {
  double lowest = INFINITY;
  bool ends = false; /* water ends (rather than begins) at the lowest crossing, going upwards */
  for (size_t k = 0; k < l->pieces; k++) {
    size_t a = l->first[k], b = l->first[k + 1];
    for (size_t i = a; i + !l->closed[k] < b; i++) {
      const double *p = l->p[i], *q = l->p[i + 1 < b ? i + 1 : a];
      bool p_left = side == FROM_LEFT ? p[0] < x : p[0] <= x;
      bool q_left = side == FROM_LEFT ? q[0] < x : q[0] <= x;
      if (p_left == q_left) continue;
      double y = p[1] + (x - p[0]) / (q[0] - p[0]) * (q[1] - p[1]);
      if (y > bed && y < lowest) {
        lowest = y;
        ends = p_left; /* the segment runs to the right: its water lies below it */
      }
    }
  }
  return ends ? lowest : NAN;
}

double gauge_elevation(const struct geo_lines *surface, double x, double bed) {
  /* A contact point may miss its wall by rounding. */
  struct geo_box box = geo_lines_box(surface);
  double slack = 1e-9 * (box.max[0] - box.min[0]);
  if (x < box.min[0] && x > box.min[0] - slack) x = box.min[0];
  if (x > box.max[0] && x < box.max[0] + slack) x = box.max[0];
  return fmax(elevation(surface, x, FROM_LEFT, bed), elevation(surface, x, FROM_RIGHT, bed));
}

/* The largest x below `limit` at which it can change whether (x, level) is in the standing water: a
 * crossing of the level, an end of an open piece, or a point where the surface turns back in x. */
static double next_change(const struct geo_lines *l, double level, double limit) {
  double x = -INFINITY;
  for (size_t k = 0; k < l->pieces; k++) {
    size_t a = l->first[k], b = l->first[k + 1];
    for (size_t i = a; i < b; i++) {
      const double *p = l->p[i], *q = l->p[i + 1 < b ? i + 1 : a], *o = l->p[i > a ? i - 1 : b - 1];
      bool is_first = !l->closed[k] && i == a, is_last = !l->closed[k] && i + 1 == b;
      if (p[0] > x && p[0] < limit && (is_first || is_last || (q[0] - p[0]) * (p[0] - o[0]) <= 0))
        x = p[0];
      if (is_last || (p[1] > level) == (q[1] > level)) continue;
      double c = p[0] + (level - p[1]) / (q[1] - p[1]) * (q[0] - p[0]);
      if (c > x && c < limit) x = c;
    }
  }
  return x;
}

double gauge_front(const struct geo_lines *surface, double bed, double depth) {
  double level = bed + depth;
  double right = next_change(surface, level, INFINITY);
  while (right > -INFINITY) {
    double left = next_change(surface, level, right);
    if (left > -INFINITY && elevation(surface, (left + right) / 2, FROM_LEFT, bed) > level)
      return right;
    right = left;
  }
  return NAN;
}

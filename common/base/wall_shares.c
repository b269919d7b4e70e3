#include "common/base/wall_shares.h"

/* Relative to the size of the tank: how far from a wall a point is still on it, and how close to
 * each other two places are the same. */
static const double ON_WALL = 1e-6, SAME = 1e-9;

struct stretch { /* of one segment, in lengths along it */
  double a[2], b[2];
  double low, high;
  double size; /* of the tank */
};

static double away_from(const struct stretch *s, const double p[2]) {
  double foot[2];
  geo_segment_foot(s->a, s->b, p, foot);
  return hypot(p[0] - foot[0], p[1] - foot[1]);
}

static double along(const struct stretch *s, const double p[2]) {
  const double x = s->b[0] - s->a[0], y = s->b[1] - s->a[1];
  return ((p[0] - s->a[0]) * x + (p[1] - s->a[1]) * y) / hypot(x, y);
}

static bool takes_part(const struct stretch *s, const double p[2]) {
  const double place = along(s, p), near = SAME * s->size;
  return away_from(s, p) <= ON_WALL * s->size && place >= s->low - near && place <= s->high + near;
}

/* Onto the segment that the point is nearest to; false where there is none. */
static bool segment_find(const struct geo_lines *walls, const double p[2], struct stretch *s) {
  double nearest = INFINITY;
  for (size_t piece = 0; piece < walls->pieces; piece++)
    for (size_t k = 0; k < geo_piece_segments(walls, piece); k++) {
      const double *a = walls->p[walls->first[piece] + k];
      const double *b = geo_segment_end(walls, piece, k);
      const struct stretch own = {{a[0], a[1]}, {b[0], b[1]}, 0, 0, s->size};
      const double away = away_from(&own, p);
      if (away >= nearest) continue;
      nearest = away;
      *s = own;
    }
  return isfinite(nearest);
}

/* The k-th's part, half-way to the nearest on either side, shared with those at its place;
 * *first: whether none of them comes before it. */
static double part_of(const struct stretch *s, size_t n, const double (*at)[2], size_t k,
                      bool *first) {
  const double mine = along(s, at[k]);
  double from = s->low, to = s->high, shared = 1;
  *first = true;
  for (size_t j = 0; j < n; j++) {
    const double its = along(s, at[j]);
    if (j == k || !takes_part(s, at[j])) continue;
    if (fabs(its - mine) <= SAME * s->size) {
      shared++;
      *first = *first && j > k;
    } else if (its < mine) {
      from = fmax(from, (its + mine) / 2);
    } else {
      to = fmin(to, (its + mine) / 2);
    }
  }
  return (to - from) / (s->high - s->low) / shared;
}

size_t geo_wall_shares(const struct geo_lines *walls, size_t n, const double (*at)[2],
                       size_t middle, double length, double *share) {
  const struct geo_box box = geo_lines_box(walls);
  struct stretch s = {.size = hypot(box.max[0] - box.min[0], box.max[1] - box.min[1])};
  size_t places = 0;
  const bool there = segment_find(walls, at[middle], &s);
  if (there) {
    const double place = along(&s, at[middle]);
    s.low = fmax(place - length / 2, 0);
    s.high = fmin(place + length / 2, hypot(s.b[0] - s.a[0], s.b[1] - s.a[1]));
  }
  for (size_t k = 0; k < n; k++) {
    bool first = false;
    share[k] = there && takes_part(&s, at[k]) ? part_of(&s, n, at, k, &first) : 0;
    places += first;
  }
  return places;
}

#include "compare/polyline.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

size_t cmp_piece_longest(const struct geo_lines *surface) {
  size_t best = SIZE_MAX;
  double longest = 0;
  for (size_t k = 0; k < surface->pieces; k++) {
    double length = geo_piece_length(surface, k);
    if (length > longest) {
      longest = length;
      best = k;
    }
  }
  return best;
}

enum status cmp_lines_main(const struct geo_lines *surface, double fraction,
                           struct geo_lines *out) {
  geo_lines_clear(out);
  size_t longest = cmp_piece_longest(surface);
  if (longest == SIZE_MAX) return OK;
  double least = fraction * geo_piece_length(surface, longest);
  for (size_t k = 0; k < surface->pieces; k++)
    if (geo_piece_length(surface, k) >= least) TRY(geo_lines_add_piece(out, surface, k));
  return OK;
}

/* Liang and Barsky: the part [*u, *v] of segment pq inside the box. */
static bool segment_clip(const double *p, const double *q, const struct geo_box *box, double *u,
                         double *v) {
  *u = 0;
  *v = 1;
  for (int k = 0; k < 2; k++) {
    double d = q[k] - p[k];
    if (d == 0) {
      if (p[k] < box->min[k] || p[k] > box->max[k]) return false;
      continue;
    }
    double a = (box->min[k] - p[k]) / d, b = (box->max[k] - p[k]) / d;
    *u = fmax(*u, fmin(a, b));
    *v = fmin(*v, fmax(a, b));
  }
  return *u < *v;
}

static bool piece_inside(const struct geo_lines *l, size_t k, const struct geo_box *box) {
  for (size_t i = l->first[k]; i < l->first[k + 1]; i++)
    if (!geo_box_contains(box, l->p[i][0], l->p[i][1])) return false;
  return true;
}

enum status cmp_lines_clip(const struct geo_lines *in, const struct geo_box *box,
                           struct geo_lines *out) {
  geo_lines_clear(out);
  for (size_t k = 0; k < in->pieces; k++) {
    if (piece_inside(in, k, box)) {
      TRY(geo_lines_add_piece(out, in, k));
      continue;
    }
    size_t a = in->first[k], n = in->first[k + 1] - a;
    size_t segments = geo_piece_segments(in, k);
    bool open = false;
    for (size_t i = 0; i < segments; i++) {
      const double *p = in->p[a + i], *q = in->p[a + (i + 1) % n];
      double u, v;
      if (!segment_clip(p, q, box, &u, &v)) {
        open = false;
        continue;
      }
      if (!open || u > 0) {
        TRY(geo_lines_begin(out, false));
        TRY(geo_lines_add(out, p[0] + u * (q[0] - p[0]), p[1] + u * (q[1] - p[1])));
      }
      TRY(geo_lines_add(out, p[0] + v * (q[0] - p[0]), p[1] + v * (q[1] - p[1])));
      open = v == 1;
    }
  }
  return OK;
}

enum status cmp_lines_sample(const struct geo_lines *in, double step, struct geo_lines *out) {
  geo_lines_clear(out);
  for (size_t k = 0; k < in->pieces; k++) {
    double length = geo_piece_length(in, k);
    size_t a = in->first[k], n = in->first[k + 1] - a;
    size_t segments = geo_piece_segments(in, k);
    if (!(length > 0)) continue;
    size_t parts = (size_t)ceil(length / step);
    double h = length / (double)parts, walked = 0;
    size_t next = 0, last = in->closed[k] ? parts - 1 : parts;
    TRY(geo_lines_begin(out, in->closed[k]));
    for (size_t i = 0; i < segments; i++) {
      const double *p = in->p[a + i], *q = in->p[a + (i + 1) % n];
      double l = hypot(q[0] - p[0], q[1] - p[1]);
      for (; next <= last && l > 0; next++) {
        double u = ((double)next * h - walked) / l;
        if (u > 1 && !(next == last && i + 1 == segments)) break;
        u = fmin(u, 1);
        TRY(geo_lines_add(out, p[0] + u * (q[0] - p[0]), p[1] + u * (q[1] - p[1])));
      }
      walked += l;
    }
  }
  return OK;
}

double cmp_wall_distance(const struct geo_lines *walls, const double *p) {
  double nearest = INFINITY;
  for (size_t k = 0; k < walls->pieces; k++) {
    size_t a = walls->first[k], n = walls->first[k + 1] - a;
    for (size_t j = 0; j < geo_piece_segments(walls, k); j++) {
      double foot[2];
      geo_segment_foot(walls->p[a + j], walls->p[a + (j + 1) % n], p, foot);
      nearest = fmin(nearest, hypot(p[0] - foot[0], p[1] - foot[1]));
    }
  }
  return nearest;
}

enum status cmp_lines_away(const struct geo_lines *in, const struct geo_lines *walls,
                           double distance, struct geo_lines *out) {
  geo_lines_clear(out);
  TRY(geo_lines_begin(out, false));
  for (size_t i = 0; i < in->points; i++)
    if (cmp_wall_distance(walls, in->p[i]) >= distance)
      TRY(geo_lines_add(out, in->p[i][0], in->p[i][1]));
  return OK;
}

/* ---- closing along the tank ---- */

struct ring { /* the tank's boundary, counter-clockwise, open to the sky */
  struct geo_lines line;
  double *at; /* arc length of each vertex, m, [points + 1]; the last is the whole length */
};

static void ring_destroy(struct ring *r) {
  geo_lines_destroy(&r->line);
  free(r->at);
}

static enum status ring_create(const struct geo_lines *walls, const struct geo_lines *surface,
                               struct ring *r) {
  *r = (struct ring){0};
  size_t wall = cmp_piece_longest(walls);
  CHECK(wall != SIZE_MAX, ERR_INPUT, "the result file has no tank walls");
  struct geo_box a = geo_lines_box(walls), b = geo_lines_box(surface);
  double sky = fmax(a.max[1], b.max[1]) + (a.max[1] - a.min[1]);
  TRY(geo_lines_begin(&r->line, true));
  size_t first = walls->first[wall], end = walls->first[wall + 1];
  if (!walls->closed[wall]) TRY(geo_lines_add(&r->line, walls->p[first][0], sky));
  for (size_t i = first; i < end; i++) TRY(geo_lines_add(&r->line, walls->p[i][0], walls->p[i][1]));
  if (!walls->closed[wall]) TRY(geo_lines_add(&r->line, walls->p[end - 1][0], sky));

  size_t n = r->line.points;
  r->at = malloc((n + 1) * sizeof *r->at);
  CHECK(r->at, ERR_MEMORY, "no memory for a tank of %zu points", n);
  r->at[0] = 0;
  for (size_t i = 0; i < n; i++) {
    const double *p = r->line.p[i], *q = r->line.p[(i + 1) % n];
    r->at[i + 1] = r->at[i] + hypot(q[0] - p[0], q[1] - p[1]);
  }
  return OK;
}

/* The arc length of the boundary's point nearest to p; that point into `foot`. */
static double ring_project(const struct ring *r, const double *p, double *foot) {
  double nearest = INFINITY, at = 0;
  size_t n = r->line.points;
  for (size_t i = 0; i < n; i++) {
    const double *a = r->line.p[i], *b = r->line.p[(i + 1) % n];
    double q[2], u = geo_segment_foot(a, b, p, q), distance = hypot(p[0] - q[0], p[1] - q[1]);
    if (distance < nearest) {
      nearest = distance;
      at = r->at[i] + u * hypot(b[0] - a[0], b[1] - a[1]);
      foot[0] = q[0];
      foot[1] = q[1];
    }
  }
  return at;
}

/* How far one walks clockwise (against the boundary's direction) from s to t. */
static double ring_gap(const struct ring *r, double s, double t) {
  double whole = r->at[r->line.points], gap = fmod(s - t, whole);
  return gap < 0 ? gap + whole : gap;
}

/* Appends the vertices met on that walk. */
static enum status ring_walk(const struct ring *r, double s, double gap, struct geo_lines *out) {
  size_t n = r->line.points, i = 0;
  while (i + 1 < n && r->at[i + 1] < s) i++; /* vertex i is the first one met */
  for (size_t met = 0; met < n; met++) {
    if (ring_gap(r, s, r->at[i]) >= gap) break;
    TRY(geo_lines_add(out, r->line.p[i][0], r->line.p[i][1]));
    i = i ? i - 1 : n - 1;
  }
  return OK;
}

struct end {             /* of an open piece */
  double start, finish;  /* on the tank's boundary, m */
  double from[2], to[2]; /* those points */
  bool used, closed;     /* closed: needs no wall to close it */
};

enum status cmp_lines_close(const struct geo_lines *surface, const struct geo_lines *walls,
                            double snap, struct geo_lines *rings) {
  enum status status = OK;
  struct ring ring;
  struct end *ends = calloc(surface->pieces + 1, sizeof *ends);
  ATTEMPT(ring_create(walls, surface, &ring));
  if (!ends) {
    status = status_raise(ERR_MEMORY, "no memory for %zu surfaces", surface->pieces);
    goto done;
  }
  geo_lines_clear(rings);
  for (size_t k = 0; k < surface->pieces; k++) {
    size_t a = surface->first[k], b = surface->first[k + 1];
    ends[k].closed = surface->closed[k] || b - a < 2;
    if (ends[k].closed) continue;
    ends[k].start = ring_project(&ring, surface->p[a], ends[k].from);
    ends[k].finish = ring_project(&ring, surface->p[b - 1], ends[k].to);
    ends[k].closed = ring_gap(&ring, ends[k].start, ends[k].finish) < snap;
  }
  for (size_t k = 0; k < surface->pieces; k++) {
    if (surface->first[k + 1] - surface->first[k] < 3 && ends[k].closed) continue;
    if (ends[k].used) continue;
    ATTEMPT(geo_lines_begin(rings, true));
    for (size_t piece = k;;) {
      struct end *e = &ends[piece];
      e->used = true;
      if (!e->closed) ATTEMPT(geo_lines_add(rings, e->from[0], e->from[1]));
      for (size_t i = surface->first[piece]; i < surface->first[piece + 1]; i++)
        ATTEMPT(geo_lines_add(rings, surface->p[i][0], surface->p[i][1]));
      if (e->closed) break;
      ATTEMPT(geo_lines_add(rings, e->to[0], e->to[1]));

      size_t next = k;
      double gap = ring_gap(&ring, e->finish, ends[k].start);
      for (size_t j = 0; j < surface->pieces; j++) {
        if (ends[j].used || ends[j].closed) continue;
        double g = ring_gap(&ring, e->finish, ends[j].start);
        if (g < gap) {
          gap = g;
          next = j;
        }
      }
      ATTEMPT(ring_walk(&ring, e->finish, gap, rings));
      if (next == k) break;
      piece = next;
    }
  }
done:
  ring_destroy(&ring);
  free(ends);
  return status;
}

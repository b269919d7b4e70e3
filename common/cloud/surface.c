/* The free surface is the contour F = 1/2 of the smoothed volume fraction (fraction.h).
 * Why this and not the detection of surface particles of Marrone, Colagrossi, Le Touze & Graziani
 * (J. Comput. Phys. 229, 2010): that one yields a set of particles, half a spacing inside the
 * water, still to be joined to curves; a level set yields closed oriented curves, whose noise can
 * be bounded.
 *
 * - On a square lattice F ripples by 4 exp(-pi^2 s^2/dx^2) = 2e-4 at most.
 * - Across a straight surface F = erfc(d/s)/2, d the distance outwards: the contour is the surface
 *   itself, dx/2 outside the outermost row of particles. On a curve of radius R it lies s^2/(4R) on
 *   the hollow side.
 * - A sheet of thickness dx has F = erf(1/2) = 0.52 in its middle: it is just seen.
 * - In between grid nodes, d = s erfc^-1(2F) is interpolated, not F: it is linear in space.
 *
 * Water goes on beyond a wall that it touches, and the curves are cut there.
 */
#include "common/cloud/surface.h"
#include "common/base/array.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* In dx^2. A smaller drop than the first is noise: the smallest cluster that F >= 1/2 shows (three
 * particles) is larger. A smaller pocket of air than the second is a void that the disorder of
 * particles opens, inside the water or on a wall: one missing particle is not seen, three or four
 * together are. */
#define SMALLEST_DROP   0.1
#define SMALLEST_POCKET 4.0
/* Points closer than this many grid spacings to the one before them are left out. */
#define SMALLEST_STEP 0.2

struct cloud_surface {
  struct cloud_fraction g;

  size_t points, point_room; /* of the contour before it is cut */
  double (*p)[2];            /* m, [points] */
  size_t *next;              /* [points], the point that follows, with the water on the right */
  size_t *top, top_room;     /* [g.nx], contour point on the top edge of each cell of a row */
  size_t *cycle;             /* [points], one closed curve */
  unsigned char *inside;     /* [points], whether a point of the curve is inside the walls */

  struct geo_lines pieces;
};

enum status cloud_surface_create(struct cloud_surface **s) {
  *s = calloc(1, sizeof **s);
  CHECK(*s, ERR_MEMORY, "no memory for the free surface");
  return OK;
}

void cloud_surface_destroy(struct cloud_surface *s) {
  if (!s) return;
  cloud_fraction_destroy(&s->g);
  free(s->p);
  free(s->next);
  free(s->top);
  free(s->cycle);
  free(s->inside);
  geo_lines_destroy(&s->pieces);
  free(s);
}

/* ---- walls ---- */

/* The segment nearest to (x, y): returns the distance from its line, positive in the water, and the
 * nearest point of the segment. Where two are equally near (in front of their common vertex) the
 * one seen more squarely tells the side. */
static double nearest_wall(const struct geo_lines *walls, double x, double y, double *nearest) {
  double best = INFINITY, side = INFINITY;
  for (size_t k = 0; k < walls->pieces; k++)
    for (size_t i = 0; i < geo_piece_segments(walls, k); i++) {
      const double *a = walls->p[walls->first[k] + i], *b = geo_segment_end(walls, k, i);
      double d, t = fmin(fmax(geo_line_foot(a, b, x, y, &d), 0), 1);
      double p[2] = {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
      double r = (x - p[0]) * (x - p[0]) + (y - p[1]) * (y - p[1]);
      bool tie = isfinite(best) && fabs(r - best) <= 1e-12 * best;
      if (tie ? fabs(d) <= fabs(side) : r > best) continue;
      best = r;
      side = d;
      nearest[0] = p[0];
      nearest[1] = p[1];
    }
  return side;
}

static bool is_inside(const struct geo_lines *walls, const double *p) {
  double nearest[2];
  return nearest_wall(walls, p[0], p[1], nearest) >= 0;
}

/* Where the step from `in` (inside) to `out` (outside) goes through a wall, exactly on it; or
 * through the straight continuation of a wall beyond its end. */
static void contact(const struct geo_lines *walls, const double *in, const double *out, double *p) {
  double a = 0, b = 1, nearest[2];
  for (int k = 0; k < 60; k++) {
    double t = (a + b) / 2;
    double q[2] = {in[0] + t * (out[0] - in[0]), in[1] + t * (out[1] - in[1])};
    if (is_inside(walls, q))
      a = t;
    else
      b = t;
  }
  for (int k = 0; k < 2; k++) p[k] = in[k] + a * (out[k] - in[k]);
  nearest_wall(walls, p[0], p[1], nearest);
  double off = hypot(nearest[0] - p[0], nearest[1] - p[1]);
  double rounding = 1e-9 * hypot(out[0] - in[0], out[1] - in[1]);
  if (off <= rounding) memcpy(p, nearest, sizeof nearest);
}

/* Whether the chord from p to q, both on walls, runs along one. */
static bool is_on_wall(const struct geo_lines *walls, const double *p, const double *q, double dx) {
  double nearest[2], x = (p[0] + q[0]) / 2, y = (p[1] + q[1]) / 2;
  nearest_wall(walls, x, y, nearest);
  return hypot(nearest[0] - x, nearest[1] - y) < 1e-6 * dx;
}

/* ---- the contour ---- */

/* Distance to the surface in units of s, positive in the water: the inverse of F = (1 + erf)/2.
 * Winitzki's closed form (relative error 2e-3) and one step of Halley's method (then 1e-8). */
static double depth_of(double f) {
  double z = fmin(fmax(2 * f - 1, -1 + 1e-6), 1 - 1e-6);
  double l = log((1 - z) * (1 + z)), c = 2 / (M_PI * 0.147) + l / 2;
  double u = copysign(sqrt(sqrt(c * c - l / 0.147) - c), z);
  double step = (erf(u) - z) * (sqrt(M_PI) / 2) * exp(u * u);
  return u - step / (1 + u * step);
}

/* Adds the contour point between the neighbouring nodes a and b. */
static enum status cross(struct cloud_surface *s, size_t a, size_t b, size_t *point) {
  size_t room = array_room(s->point_room, s->points + 1);
  if (room > s->point_room) {
    TRY(array_resize(&s->p, room, "points of the free surface"));
    TRY(array_resize(&s->next, room, "points of the free surface"));
    TRY(array_resize(&s->cycle, room, "points of the free surface"));
    TRY(array_resize(&s->inside, room, "points of the free surface"));
    s->point_room = room;
  }
  double da = depth_of(s->g.f[a]), db = depth_of(s->g.f[b]);
  double t = fmin(fmax(da / (da - db), 0), 1);
  double ax = (double)(s->g.first + a % s->g.stride), ay = (double)(a / s->g.stride);
  double bx = (double)(s->g.first + b % s->g.stride), by = (double)(b / s->g.stride);
  s->p[s->points][0] = s->g.origin[0] + (ax + t * (bx - ax)) * s->g.spacing;
  s->p[s->points][1] = s->g.origin[1] + (ay + t * (by - ay)) * s->g.spacing;
  *point = s->points++;
  return OK;
}

/* Links the contour points on the edges e = 0..3 (bottom, right, top, left) of a cell whose corners
 * c = 0..3 go round counter-clockwise, edge e joining corners e and e + 1. A curve with the water
 * on its right comes in where dry turns into wet, and goes out where wet turns into dry: at the
 * next such edge, but in a saddle whose two wet corners are joined at the previous one. */
static void link_cell(struct cloud_surface *s, unsigned wet, const double *f,
                      const size_t *on_edge) {
  bool saddle = wet == 5 || wet == 10;
  /* value of the bilinear interpolant at its saddle point, up to a positive factor */
  double a = f[0] - 0.5, b = f[1] - 0.5, c = f[2] - 0.5, d = f[3] - 0.5;
  bool joined = saddle && (a * c - b * d) * (a + c - b - d) > 0;
  for (unsigned e = 0; e < 4; e++) {
    if ((wet >> e & 1) || !(wet >> ((e + 1) & 3) & 1)) continue;
    unsigned to = joined ? e + 3 : e + 1;
    while (wet >> ((to + 1) & 3) & 1) to++;
    s->next[on_edge[e]] = on_edge[to & 3];
  }
}

/* Marching squares. The grid's border is dry, so every curve closes. */
static enum status trace(struct cloud_surface *s) {
  size_t nx = s->g.nx, up = s->g.stride;
  if (nx > s->top_room) {
    free(s->top);
    s->top = calloc(nx, sizeof *s->top);
    s->top_room = s->top ? nx : 0;
    CHECK(s->top, ERR_MEMORY, "no memory for a free-surface grid of %zu columns", nx);
  }
  s->points = 0;
  for (size_t j = 0; j + 1 < s->g.ny; j++) {
    size_t left = 0;
    if (cloud_fraction_is_dry(&s->g, j)) continue;
    for (size_t i = 0; i + 1 < nx; i++) {
      const double *g = s->g.f + j * up + i;
      unsigned wet = (unsigned)(g[0] >= 0.5) | (unsigned)(g[1] >= 0.5) << 1 |
                     (unsigned)(g[up + 1] >= 0.5) << 2 | (unsigned)(g[up] >= 0.5) << 3;
      if (wet == 0 || wet == 15) continue;
      size_t node = j * up + i;
      size_t on_edge[4] = {s->top[i], 0, 0, left};
      if ((wet >> 1 ^ wet >> 2) & 1) TRY(cross(s, node + 1, node + up + 1, &on_edge[1]));
      if ((wet >> 2 ^ wet >> 3) & 1) TRY(cross(s, node + up, node + up + 1, &on_edge[2]));
      link_cell(s, wet, (double[]){g[0], g[1], g[up + 1], g[up]}, on_edge);
      left = on_edge[1];
      s->top[i] = on_edge[2];
    }
  }
  return OK;
}

/* ---- pieces ---- */

/* Appends a point unless it is a very short step from the one before. */
static enum status add_point(struct cloud_surface *s, const double *p, bool keep) {
  struct geo_lines *l = &s->pieces;
  if (!keep && l->points > l->first[l->pieces - 1]) {
    const double *o = l->p[l->points - 1];
    if (hypot(p[0] - o[0], p[1] - o[1]) < SMALLEST_STEP * s->g.spacing) return OK;
  }
  return geo_lines_add(l, p[0], p[1]);
}

/* Takes the last piece back if what it encloses, by itself or with the chord between its ends, is
 * too little of water or of air. */
static void drop_if_small(struct cloud_surface *s) {
  struct geo_lines *l = &s->pieces;
  double area = geo_piece_area(l, l->pieces - 1) / (s->g.dx * s->g.dx);
  if (area > -SMALLEST_DROP && area < SMALLEST_POCKET) l->points = l->first[--l->pieces];
}

static void drop_last_point(struct geo_lines *l) {
  l->first[l->pieces] = --l->points;
}

static double last_step(const struct geo_lines *l, const double *p) {
  const double *o = l->p[l->points - 1];
  return hypot(p[0] - o[0], p[1] - o[1]);
}

static bool is_long_step(const struct cloud_surface *s, size_t m, size_t to) {
  const double *p = s->p[s->cycle[to % m]], *o = s->p[s->cycle[(to + m - 1) % m]];
  return hypot(p[0] - o[0], p[1] - o[1]) >= SMALLEST_STEP * s->g.spacing;
}

/* Where to begin a closed curve of m points: after two long steps, where a walk from anywhere else
 * would also keep the point. So which points are left out does not depend on where the curve was
 * found, nor on what a strip has cut off it. */
static size_t closed_start(const struct cloud_surface *s, size_t m) {
  for (size_t i = 0; i < m; i++)
    if (is_long_step(s, m, i) && is_long_step(s, m, i + m - 1)) return i;
  return 0;
}

static enum status add_closed(struct cloud_surface *s, size_t m) {
  struct geo_lines *l = &s->pieces;
  size_t start = closed_start(s, m);
  TRY(geo_lines_begin(l, true));
  for (size_t i = 0; i < m; i++) TRY(add_point(s, s->p[s->cycle[(start + i) % m]], false));
  size_t first = l->first[l->pieces - 1];
  if (l->points > first + 1 && last_step(l, l->p[first]) < SMALLEST_STEP * s->g.spacing)
    drop_last_point(l);
  drop_if_small(s);
  return OK;
}

/* The stretch that starts inside the walls at point `from` of a curve of m points and goes on until
 * it leaves them; *to is the first point outside. */
static enum status add_open(struct cloud_surface *s, const struct geo_lines *walls, size_t m,
                            size_t from, size_t *to) {
  struct geo_lines *l = &s->pieces;
  double p[2];
  TRY(geo_lines_begin(l, false));
  contact(walls, s->p[s->cycle[from % m]], s->p[s->cycle[(from + m - 1) % m]], p);
  TRY(add_point(s, p, true));
  size_t i = from;
  for (; s->inside[i % m]; i++) TRY(add_point(s, s->p[s->cycle[i % m]], false));
  contact(walls, s->p[s->cycle[(i + m - 1) % m]], s->p[s->cycle[i % m]], p);
  size_t first = l->first[l->pieces - 1];
  if (l->points > first + 1 && last_step(l, p) < SMALLEST_STEP * s->g.spacing) drop_last_point(l);
  TRY(add_point(s, p, true));
  *to = i;
  if (is_on_wall(walls, l->p[first], p, s->g.dx)) drop_if_small(s);
  return OK;
}

/* Follows every curve once and keeps what is inside the walls. */
static enum status cut(struct cloud_surface *s, const struct geo_lines *walls) {
  geo_lines_clear(&s->pieces);
  for (size_t start = 0; start < s->points; start++) {
    size_t m = 0, n_inside = 0, entry = 0;
    for (size_t i = start; s->next[i] != SIZE_MAX;) {
      s->cycle[m] = i;
      s->inside[m] = !walls->points || is_inside(walls, s->p[i]);
      n_inside += s->inside[m++];
      size_t follower = s->next[i];
      s->next[i] = SIZE_MAX;
      i = follower;
    }
    if (n_inside == 0) continue;
    if (n_inside == m) {
      TRY(add_closed(s, m));
      continue;
    }
    while (!(s->inside[entry] && !s->inside[(entry + m - 1) % m])) entry++;
    for (size_t i = entry; i < entry + m;) {
      TRY(add_open(s, walls, m, i, &i));
      while (i < entry + m && !s->inside[i % m]) i++;
    }
  }
  return OK;
}

/* Open pieces before closed ones, and the longest of them first. */
static enum status deliver(const struct geo_lines *l, struct geo_lines *out) {
  size_t main_piece = l->pieces;
  double longest = 0;
  for (size_t k = 0; k < l->pieces; k++) {
    double length = l->closed[k] ? 0 : geo_piece_length(l, k);
    if (length <= longest) continue;
    longest = length;
    main_piece = k;
  }
  geo_lines_clear(out);
  if (main_piece < l->pieces) TRY(geo_lines_add_piece(out, l, main_piece));
  for (size_t k = 0; k < l->pieces; k++)
    if (!l->closed[k] && k != main_piece) TRY(geo_lines_add_piece(out, l, k));
  for (size_t k = 0; k < l->pieces; k++)
    if (l->closed[k]) TRY(geo_lines_add_piece(out, l, k));
  return OK;
}

/* Where the strip cuts through water, curves go along its edge. */
static void dry_edges(struct cloud_fraction *g) {
  for (size_t j = 0; g->nx && j < g->ny; j++)
    g->f[j * g->stride] = g->f[j * g->stride + g->nx - 1] = 0;
}

enum status cloud_surface_strip(struct cloud_surface *s, const struct cloud *c,
                                const struct geo_lines *walls, const double strip[2],
                                struct geo_lines *out) {
  TRY(cloud_fraction_fill(&s->g, c, walls, strip));
  dry_edges(&s->g);
  TRY(trace(s));
  TRY(cut(s, walls));
  return deliver(&s->pieces, out);
}

enum status cloud_surface_extract(struct cloud_surface *s, const struct cloud *c,
                                  const struct geo_lines *walls, struct geo_lines *out) {
  return cloud_surface_strip(s, c, walls, (double[]){-INFINITY, INFINITY}, out);
}

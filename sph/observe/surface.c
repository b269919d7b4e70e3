/* The free surface is the contour F = 1/2 of the smoothed volume fraction
 *     F(x) = sum_j V_j W(x - x_j),   W(r) = exp(-r^2/s^2) / (pi s^2),   s = dx.
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
 * Water that touches a wall is continued through it by mirror particles, and the curves are cut
 * there.
 */
#include "sph/observe/surface.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* W is cut off at REACH nodes, 3.5 s: what is lost is erfc(3.5) = 7e-7. */
enum { NODES_PER_SPACING = 2, REACH = 8, STENCIL = 2 * REACH };
#define MAX_NODES ((size_t)1 << 31)

/* In dx^2. A smaller drop than the first is noise: the smallest cluster that F >= 1/2 shows (three
 * particles) is larger. A smaller pocket of air than the second is a void that the disorder of
 * particles opens, inside the water or on a wall: one missing particle is not seen, three or four
 * together are. */
#define SMALLEST_DROP   0.1
#define SMALLEST_POCKET 4.0
/* Points closer than this many grid spacings to the one before them are left out. */
#define SMALLEST_STEP 0.2

struct sph_surface {
  double dx, spacing;       /* of particles and of grid nodes, m */
  double origin[2];         /* node (0, 0), m */
  size_t nx, ny, node_room; /* nodes */
  double *f;                /* F, [ny][nx] */
  double taper[STENCIL];    /* exp(-(k spacing/s)^2), k = 1 - REACH .. REACH */

  size_t points, point_room; /* of the contour before it is cut */
  double (*p)[2];            /* m, [points] */
  size_t *next;              /* [points], the point that follows, with the water on the right */
  size_t *top, top_room;     /* [nx], contour point on the top edge of each cell of a row */
  size_t *cycle;             /* [points], one closed curve */
  unsigned char *inside;     /* [points], whether a point of the curve is inside the walls */

  struct geo_lines pieces;
};

enum status sph_surface_create(struct sph_surface **s) {
  *s = calloc(1, sizeof **s);
  CHECK(*s, ERR_MEMORY, "no memory for the free surface");
  for (int k = 0; k < STENCIL; k++) {
    double q = (double)(k + 1 - REACH) / NODES_PER_SPACING;
    (*s)->taper[k] = exp(-q * q);
  }
  return OK;
}

void sph_surface_destroy(struct sph_surface *s) {
  if (!s) return;
  free(s->f);
  free(s->p);
  free(s->next);
  free(s->top);
  free(s->cycle);
  free(s->inside);
  geo_lines_destroy(&s->pieces);
  free(s);
}

/* ---- the grid ---- */

/* Where particles count: nowhere near infinity, lest one that has escaped asks for a vast grid. */
static struct geo_box catchment(const struct geo_lines *walls) {
  if (!walls->points) return (struct geo_box){{-1e100, -1e100}, {1e100, 1e100}};
  struct geo_box box = geo_lines_box(walls);
  double diagonal = hypot(box.max[0] - box.min[0], box.max[1] - box.min[1]);
  for (int k = 0; k < 2; k++) {
    box.min[k] -= diagonal;
    box.max[k] += diagonal;
  }
  return box;
}

static bool box_has(const struct geo_box *b, double x, double y) {
  return x >= b->min[0] && x <= b->max[0] && y >= b->min[1] && y <= b->max[1];
}

/* Lays the grid around the particles and sets F = 0. Its nodes lie at whole multiples of the
 * spacing, so that it does not shift from one output to the next. */
static enum status grid_lay(struct sph_surface *s, size_t n, const double *x, const double *y,
                            const struct geo_box *catch) {
  struct geo_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
  for (size_t i = 0; i < n; i++) {
    if (!box_has(catch, x[i], y[i])) continue;
    box.min[0] = fmin(box.min[0], x[i]);
    box.max[0] = fmax(box.max[0], x[i]);
    box.min[1] = fmin(box.min[1], y[i]);
    box.max[1] = fmax(box.max[1], y[i]);
  }
  s->nx = s->ny = 0;
  if (box.min[0] > box.max[0]) return OK;
  double nodes[2];
  for (int k = 0; k < 2; k++) {
    /* room for the stencil around the mirror images too, which are up to 2 (REACH + 1) nodes off */
    const double margin = 3 * REACH + 3;
    double first = floor(box.min[k] / s->spacing) - margin;
    s->origin[k] = first * s->spacing;
    nodes[k] = ceil(box.max[k] / s->spacing) + margin + 1 - first;
  }
  CHECK(
      nodes[0] * nodes[1] < (double)MAX_NODES, ERR_INPUT,
      "the particles are scattered over %.3g m x %.3g m, too far for a free surface with dx = %g m",
      box.max[0] - box.min[0], box.max[1] - box.min[1], s->dx);
  s->nx = (size_t)nodes[0];
  s->ny = (size_t)nodes[1];
  size_t total = s->nx * s->ny;
  if (total > s->node_room) {
    free(s->f);
    s->node_room = total + total / 4;
    s->f = malloc(s->node_room * sizeof *s->f);
    if (!s->f) s->node_room = 0;
    CHECK(s->f, ERR_MEMORY, "no memory for a free-surface grid of %zu x %zu nodes", s->nx, s->ny);
  }
  if (s->nx > s->top_room) {
    free(s->top);
    s->top_room = s->nx + s->nx / 4;
    s->top = calloc(s->top_room, sizeof *s->top);
    if (!s->top) s->top_room = 0;
    CHECK(s->top, ERR_MEMORY, "no memory for a free-surface grid of %zu x %zu nodes", s->nx, s->ny);
  }
  memset(s->f, 0, total * sizeof *s->f);
  return OK;
}

/* exp(-((k - t) spacing/s)^2) for the nodes k = 1 - REACH .. REACH around a particle at t, 0 <= t <
 * 1: the Gaussian of a sum is a product, so two exponentials do for all of them. */
static inline void gaussian_row(const double *taper, double t, double *w) {
  const double q = 1.0 / (NODES_PER_SPACING * NODES_PER_SPACING);
  double up = exp(2 * q * t), down = 1 / up, power = exp(-q * t * t);
  w[REACH - 1] = power;
  for (int k = REACH; k < STENCIL; k++) w[k] = power *= up;
  power = w[REACH - 1];
  for (int k = REACH - 2; k >= 0; k--) w[k] = power *= down;
  for (int k = 0; k < STENCIL; k++) w[k] *= taper[k];
}

static void deposit(struct sph_surface *s, double x, double y, double volume) {
  double tx = (x - s->origin[0]) / s->spacing, ty = (y - s->origin[1]) / s->spacing;
  double i = floor(tx), j = floor(ty);
  double wx[STENCIL], wy[STENCIL];
  gaussian_row(s->taper, tx - i, wx);
  gaussian_row(s->taper, ty - j, wy);
  double scale = volume / (M_PI * s->dx * s->dx);
  double *f = s->f + ((size_t)j + 1 - REACH) * s->nx + ((size_t)i + 1 - REACH);
  for (int b = 0; b < STENCIL; b++, f += s->nx) {
    double w = scale * wy[b];
    for (int a = 0; a < STENCIL; a++) f[a] += w * wx[a];
  }
}

/* ---- walls ---- */

static const double *segment_end(const struct geo_lines *l, size_t piece, size_t segment) {
  size_t i = l->first[piece] + segment + 1;
  return l->p[i < l->first[piece + 1] ? i : l->first[piece]];
}

/* Foot of the perpendicular from (x, y) on the line through a and b, as a fraction of a to b, and
 * the distance from the line, positive on the left (in the water). */
static inline double foot(const double *a, const double *b, double x, double y, double *distance) {
  double ex = b[0] - a[0], ey = b[1] - a[1], l2 = ex * ex + ey * ey;
  *distance = (ex * (y - a[1]) - ey * (x - a[0])) / sqrt(l2);
  return ((x - a[0]) * ex + (y - a[1]) * ey) / l2;
}

/* Deposits the images of a particle: mirrored in every segment on which it has its foot, and
 * point-reflected in every vertex on both of whose segments it has one. At a corner of 90 to 180
 * degrees, straight ones included, water that fills the corner is thereby continued to every side
 * exactly once. */
static void deposit_images(struct sph_surface *s, const struct geo_lines *walls, double x, double y,
                           double volume) {
  double reach = (REACH + 1) * s->spacing;
  for (size_t k = 0; k < walls->pieces; k++) {
    size_t m = geo_piece_segments(walls, k);
    bool before = false, on_first = false;
    for (size_t i = 0; i < m; i++) {
      const double *a = walls->p[walls->first[k] + i], *b = segment_end(walls, k, i);
      double d, t = foot(a, b, x, y, &d);
      bool here = t >= 0 && t < 1 && fabs(d) < reach;
      if (here) {
        double fx = a[0] + t * (b[0] - a[0]), fy = a[1] + t * (b[1] - a[1]);
        deposit(s, 2 * fx - x, 2 * fy - y, volume);
        if (before) deposit(s, 2 * a[0] - x, 2 * a[1] - y, volume);
        if (i == 0) on_first = true;
        if (i + 1 == m && i > 1 && walls->closed[k] && on_first)
          deposit(s, 2 * b[0] - x, 2 * b[1] - y, volume);
      }
      before = here;
    }
  }
}

/* The segment nearest to (x, y): returns the distance from its line, positive in the water, and the
 * nearest point of the segment. Where two are equally near (in front of their common vertex) the
 * one seen more squarely tells the side. */
static double nearest_wall(const struct geo_lines *walls, double x, double y, double *nearest) {
  double best = INFINITY, side = INFINITY;
  for (size_t k = 0; k < walls->pieces; k++)
    for (size_t i = 0; i < geo_piece_segments(walls, k); i++) {
      const double *a = walls->p[walls->first[k] + i], *b = segment_end(walls, k, i);
      double d, t = fmin(fmax(foot(a, b, x, y, &d), 0), 1);
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
static enum status cross(struct sph_surface *s, size_t a, size_t b, size_t *point) {
  if (s->points == s->point_room) {
    size_t room = s->points ? 2 * s->points : 1024;
    void *p = realloc(s->p, room * sizeof *s->p);
    if (p) s->p = p;
    void *next = realloc(s->next, room * sizeof *s->next);
    if (next) s->next = next;
    void *cycle = realloc(s->cycle, room * sizeof *s->cycle);
    if (cycle) s->cycle = cycle;
    void *inside = realloc(s->inside, room);
    if (inside) s->inside = inside;
    CHECK(p && next && cycle && inside, ERR_MEMORY, "no memory for %zu free-surface points", room);
    s->point_room = room;
  }
  double da = depth_of(s->f[a]), db = depth_of(s->f[b]);
  double t = fmin(fmax(da / (da - db), 0), 1);
  double ax = (double)(a % s->nx), ay = (double)(a / s->nx), bx = (double)(b % s->nx),
         by = (double)(b / s->nx);
  s->p[s->points][0] = s->origin[0] + (ax + t * (bx - ax)) * s->spacing;
  s->p[s->points][1] = s->origin[1] + (ay + t * (by - ay)) * s->spacing;
  *point = s->points++;
  return OK;
}

/* Links the contour points on the edges e = 0..3 (bottom, right, top, left) of a cell whose corners
 * c = 0..3 go round counter-clockwise, edge e joining corners e and e + 1. A curve with the water
 * on its right comes in where dry turns into wet, and goes out where wet turns into dry: at the
 * next such edge, but in a saddle whose two wet corners are joined at the previous one. */
static void link_cell(struct sph_surface *s, unsigned wet, const double *f, const size_t *on_edge) {
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
static enum status trace(struct sph_surface *s) {
  size_t nx = s->nx;
  s->points = 0;
  for (size_t j = 0; j + 1 < s->ny; j++) {
    size_t left = 0;
    for (size_t i = 0; i + 1 < nx; i++) {
      const double *g = s->f + j * nx + i;
      unsigned wet = (unsigned)(g[0] >= 0.5) | (unsigned)(g[1] >= 0.5) << 1 |
                     (unsigned)(g[nx + 1] >= 0.5) << 2 | (unsigned)(g[nx] >= 0.5) << 3;
      if (wet == 0 || wet == 15) continue;
      size_t node = j * nx + i;
      size_t on_edge[4] = {s->top[i], 0, 0, left};
      if ((wet >> 1 ^ wet >> 2) & 1) TRY(cross(s, node + 1, node + nx + 1, &on_edge[1]));
      if ((wet >> 2 ^ wet >> 3) & 1) TRY(cross(s, node + nx, node + nx + 1, &on_edge[2]));
      link_cell(s, wet, (double[]){g[0], g[1], g[nx + 1], g[nx]}, on_edge);
      left = on_edge[1];
      s->top[i] = on_edge[2];
    }
  }
  return OK;
}

/* ---- pieces ---- */

/* Appends a point unless it is a very short step from the one before. */
static enum status add_point(struct sph_surface *s, const double *p, bool keep) {
  struct geo_lines *l = &s->pieces;
  if (!keep && l->points > l->first[l->pieces - 1]) {
    const double *o = l->p[l->points - 1];
    if (hypot(p[0] - o[0], p[1] - o[1]) < SMALLEST_STEP * s->spacing) return OK;
  }
  return geo_lines_add(l, p[0], p[1]);
}

/* Takes the last piece back if what it encloses, by itself or with the chord between its ends, is
 * too little of water or of air. */
static void drop_if_small(struct sph_surface *s) {
  struct geo_lines *l = &s->pieces;
  double area = geo_piece_area(l, l->pieces - 1) / (s->dx * s->dx);
  if (area > -SMALLEST_DROP && area < SMALLEST_POCKET) l->points = l->first[--l->pieces];
}

static void drop_last_point(struct geo_lines *l) {
  l->first[l->pieces] = --l->points;
}

static double last_step(const struct geo_lines *l, const double *p) {
  const double *o = l->p[l->points - 1];
  return hypot(p[0] - o[0], p[1] - o[1]);
}

static enum status add_closed(struct sph_surface *s, size_t m) {
  struct geo_lines *l = &s->pieces;
  TRY(geo_lines_begin(l, true));
  for (size_t i = 0; i < m; i++) TRY(add_point(s, s->p[s->cycle[i]], false));
  size_t first = l->first[l->pieces - 1];
  if (l->points > first + 1 && last_step(l, l->p[first]) < SMALLEST_STEP * s->spacing)
    drop_last_point(l);
  drop_if_small(s);
  return OK;
}

/* The stretch that starts inside the walls at point `from` of a curve of m points and goes on until
 * it leaves them; *to is the first point outside. */
static enum status add_open(struct sph_surface *s, const struct geo_lines *walls, size_t m,
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
  if (l->points > first + 1 && last_step(l, p) < SMALLEST_STEP * s->spacing) drop_last_point(l);
  TRY(add_point(s, p, true));
  *to = i;
  if (is_on_wall(walls, l->p[first], p, s->dx)) drop_if_small(s);
  return OK;
}

/* Follows every curve once and keeps what is inside the walls. */
static enum status cut(struct sph_surface *s, const struct geo_lines *walls) {
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

static enum status append_piece(struct geo_lines *to, const struct geo_lines *from, size_t piece) {
  TRY(geo_lines_begin(to, from->closed[piece]));
  for (size_t i = from->first[piece]; i < from->first[piece + 1]; i++)
    TRY(geo_lines_add(to, from->p[i][0], from->p[i][1]));
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
  if (main_piece < l->pieces) TRY(append_piece(out, l, main_piece));
  for (size_t k = 0; k < l->pieces; k++)
    if (!l->closed[k] && k != main_piece) TRY(append_piece(out, l, k));
  for (size_t k = 0; k < l->pieces; k++)
    if (l->closed[k]) TRY(append_piece(out, l, k));
  return OK;
}

enum status sph_surface_extract(struct sph_surface *s, size_t n, const double *x, const double *y,
                                const double *volume, double dx, const struct geo_lines *walls,
                                struct geo_lines *out) {
  struct geo_box catch = catchment(walls);
  s->dx = dx;
  s->spacing = dx / NODES_PER_SPACING;
  TRY(grid_lay(s, n, x, y, &catch));
  for (size_t i = 0; i < n; i++) {
    if (!box_has(&catch, x[i], y[i])) continue;
    double v = volume ? volume[i] : dx * dx;
    deposit(s, x[i], y[i], v);
    deposit_images(s, walls, x[i], y[i], v);
  }
  TRY(trace(s));
  TRY(cut(s, walls));
  return deliver(&s->pieces, out);
}

#include "sph/start/cells.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "sph/fluid/particles.h"

static const double rounding = 1e-9; /* of a cell: what clipping may add to or take from it */

enum side { DOWN, UP, LEFT, RIGHT, SIDES };

/* A lattice cell, then the particle that it has become or joined. */
struct part {
  double area, mx, my; /* m^2, first moments about the cell's own centre, m^3 */
  double face[SIDES];  /* wet length of each side, m */
  size_t into;         /* the part that it has joined; itself */
};

struct lattice {
  struct geo_box box;
  size_t nx, ny;
  double dx, dy;
  struct part *part; /* [nx * ny], column by column, owned */
};

static double centre(const struct lattice *l, int axis, size_t i) {
  return l->box.min[axis] + ((double)i + 0.5) * (axis ? l->dy : l->dx);
}

/* ---- clipping ---- */

struct polygon {
  size_t n;
  double (*p)[2]; /* m */
};

/* Keeps the side of the line where sign * (coordinate - at) <= 0 (Sutherland & Hodgman, Commun. ACM
 * 17, 1974). Parts of a polygon that is not convex stay joined along the line, to and fro, which
 * adds nothing to areas, moments and lengths with a sense. Every cut adds at most a point a side.
 */
static void clip(const struct polygon *in, int axis, double at, double sign, struct polygon *out) {
  out->n = 0;
  for (size_t i = 0; i < in->n; i++) {
    const double *p = in->p[i], *q = in->p[i + 1 < in->n ? i + 1 : 0];
    double a = sign * (p[axis] - at), b = sign * (q[axis] - at);
    if (a <= 0) memcpy(out->p[out->n++], p, sizeof *out->p);
    if ((a < 0 && b > 0) || (a > 0 && b < 0)) {
      double *cut = out->p[out->n++];
      cut[axis] = at;
      cut[!axis] = p[!axis] + (q[!axis] - p[!axis]) * (a / (a - b));
    }
  }
}

static void clip_between(const struct polygon *in, int axis, double low, double high,
                         struct polygon *scratch, struct polygon *out) {
  clip(in, axis, low, -1, scratch);
  clip(scratch, axis, high, 1, out);
}

/* Area, moments and wet sides of a counter-clockwise polygon that a cell has been clipped to. */
static void measure(const struct polygon *g, const double at[2], const struct geo_box *cell,
                    struct part *c) {
  for (size_t i = 0; i < g->n; i++) {
    const double *p = g->p[i], *q = g->p[i + 1 < g->n ? i + 1 : 0];
    double px = p[0] - at[0], py = p[1] - at[1], qx = q[0] - at[0], qy = q[1] - at[1];
    double cross = px * qy - qx * py;
    c->area += cross / 2;
    c->mx += cross * (px + qx) / 6;
    c->my += cross * (py + qy) / 6;
    if (p[1] == q[1] && p[1] == cell->min[1]) c->face[DOWN] += q[0] - p[0];
    if (p[1] == q[1] && p[1] == cell->max[1]) c->face[UP] += p[0] - q[0];
    if (p[0] == q[0] && p[0] == cell->min[0]) c->face[LEFT] += p[1] - q[1];
    if (p[0] == q[0] && p[0] == cell->max[0]) c->face[RIGHT] += q[1] - p[1];
  }
}

static void clip_column(struct lattice *l, size_t i, const struct polygon *column,
                        struct polygon *scratch, struct polygon *clipped) {
  double whole = l->dx * l->dy, x = l->box.min[0];
  for (size_t j = 0; j < l->ny; j++) {
    struct part *c = &l->part[i * l->ny + j];
    double y = l->box.min[1], at[2] = {centre(l, 0, i), centre(l, 1, j)};
    struct geo_box cell = {{x + (double)i * l->dx, y + (double)j * l->dy},
                           {x + (double)(i + 1) * l->dx, y + (double)(j + 1) * l->dy}};
    clip_between(column, 1, cell.min[1], cell.max[1], scratch, clipped);
    measure(clipped, at, &cell, c);
    if (c->area > (1 - rounding) * whole) {
      c->area = whole;
      c->mx = c->my = 0;
    } else if (c->area < rounding * whole)
      c->area = c->mx = c->my = 0;
  }
}

static enum status clip_lattice(struct lattice *l, const struct geo_lines *region) {
  struct polygon whole = {region->points, region->p};
  struct polygon scratch = {0}, column = {0}, clipped = {0};
  enum status status = OK;
  size_t most = 16 * region->points; /* four cuts, each of which may double the points */
  ATTEMPT(sph_allocate(most, sizeof *scratch.p, &scratch.p));
  ATTEMPT(sph_allocate(most, sizeof *column.p, &column.p));
  ATTEMPT(sph_allocate(most, sizeof *clipped.p, &clipped.p));
  for (size_t i = 0; i < l->nx; i++) {
    double x = l->box.min[0];
    clip_between(&whole, 0, x + (double)i * l->dx, x + (double)(i + 1) * l->dx, &scratch, &column);
    clip_column(l, i, &column, &scratch, &clipped);
  }
done:
  free(scratch.p);
  free(column.p);
  free(clipped.p);
  return status;
}

/* ---- joining ---- */

static size_t joined(const struct lattice *l, size_t k) {
  while (l->part[k].into != k) k = l->part[k].into;
  return k;
}

/* Where the part behind a side of cell k has gone; k itself where there is none. */
static size_t behind(const struct lattice *l, size_t k, enum side side) {
  size_t i = k / l->ny, j = k % l->ny;
  bool edge[SIDES] = {j == 0, j + 1 == l->ny, i == 0, i + 1 == l->nx};
  if (edge[side]) return k;
  size_t next[SIDES] = {k - 1, k + 1, k - l->ny, k + l->ny};
  return joined(l, next[side]);
}

/* The moments of one part, about its own centre, moved to another's. */
static void join(struct lattice *l, size_t k, size_t into) {
  struct part *a = &l->part[k], *b = &l->part[into];
  b->mx += a->mx + a->area * (centre(l, 0, k / l->ny) - centre(l, 0, into / l->ny));
  b->my += a->my + a->area * (centre(l, 1, k % l->ny) - centre(l, 1, into % l->ny));
  b->area += a->area;
  a->area = 0;
  a->into = into;
}

static void join_slivers(struct lattice *l) {
  const double least = (0.5 - rounding) * l->dx * l->dy;
  for (size_t k = 0; k < l->nx * l->ny; k++) l->part[k].into = k;
  for (size_t k = 0; k < l->nx * l->ny; k++) {
    const struct part *c = &l->part[k];
    if (c->area == 0 || c->area >= least) continue;
    size_t best = k;
    double longest = 0;
    for (enum side side = 0; side < SIDES; side++) {
      size_t other = behind(l, k, side);
      if (other == k || l->part[other].area == 0 || c->face[side] <= longest) continue;
      longest = c->face[side];
      best = other;
    }
    if (best != k) join(l, k, best); /* alone it stays: nothing is lost */
  }
}

static size_t collect(const struct lattice *l, struct sph_cell *cells) {
  size_t n = 0;
  for (size_t k = 0; k < l->nx * l->ny; k++) {
    const struct part *c = &l->part[k];
    if (c->area == 0) continue;
    cells[n++] = (struct sph_cell){centre(l, 0, k / l->ny) + c->mx / c->area,
                                   centre(l, 1, k % l->ny) + c->my / c->area, c->area};
  }
  return n;
}

enum status sph_cells_create(const struct geo_lines *region, double dx, double level, size_t *n,
                             struct sph_cell **cells) {
  enum status status = OK;
  struct lattice l = {.box = geo_lines_box(region)};
  double w = l.box.max[0] - l.box.min[0], h = l.box.max[1] - l.box.min[1];
  *cells = NULL;
  l.nx = geo_intervals(w, dx);
  l.dx = w / (double)l.nx;
  l.dy = level > 0 ? level / (double)geo_intervals(level, dx) : h / (double)geo_intervals(h, dx);
  l.ny = (size_t)ceil(h / l.dy * (1 - rounding));
  ATTEMPT(sph_allocate(l.nx * l.ny, sizeof *l.part, &l.part));
  ATTEMPT(clip_lattice(&l, region));
  join_slivers(&l);
  ATTEMPT(sph_allocate(l.nx * l.ny, sizeof **cells, cells));
  *n = collect(&l, *cells);
done:
  free(l.part);
  return status;
}

#include "sph/fluid/drift.h"

#include <math.h>
#include <stdlib.h>

#include "sph/hot.h"
#include "sph/sph.h"

/* A block is this much wider and higher than the support: what particles of blocks with one between
 * may move is then the rest, whatever the skin. */
static const double block_size = 1.4;

enum status sph_drift_create(struct sph_drift *d, const struct sph_grid *g, double support) {
  const double size = block_size * support;
  d->columns = (size_t)ceil(size * g->per_x);
  d->bins = (size_t)ceil(size * g->per_y);
  d->nx = (g->columns + d->columns - 1) / d->columns;
  d->ny = (g->bins + d->bins - 1) / d->bins;
  d->size = fmin((double)d->columns / g->per_x, (double)d->bins / g->per_y);
  d->box = calloc(d->nx * d->ny, sizeof *d->box);
  CHECK(d->box, ERR_MEMORY, "no memory for %zu x %zu blocks", d->nx, d->ny);
  return OK;
}

void sph_drift_destroy(struct sph_drift *d) {
  free(d->box);
  *d = (struct sph_drift){0};
}

static const struct sph_drift_box empty = {{INFINITY, INFINITY, INFINITY, INFINITY},
                                           {-INFINITY, -INFINITY, -INFINITY, -INFINITY}};

static void widen(struct sph_drift_box *b, const double low[4], const double high[4]) {
  for (int k = 0; k < 4; k++) {
    b->low[k] = smaller(low[k], b->low[k]);
    b->high[k] = larger(high[k], b->high[k]);
  }
}

/* The boxes of one column of blocks, whose particles stand together. */
static void fill_column(const struct sph *s, struct sph_drift *d, size_t bx) {
  const struct sph_grid *g = &s->grid;
  const struct sph_state *w = &s->f.w;
  const size_t last = (bx + 1) * d->columns < g->columns ? (bx + 1) * d->columns : g->columns;
  const size_t from = g->start[bx * d->columns * g->bins], to = g->start[last * g->bins];
  const double per_y = g->per_y / (double)d->bins, top = (double)(d->ny - 1);
  for (size_t k = 0; k < d->ny; k++) d->box[bx * d->ny + k] = empty;
  for (size_t i = from; i < to; i++) {
    const double x = w->x[i] - s->f.x_listed[i], y = w->y[i] - s->f.y_listed[i];
    const double moved[4] = {x, y, x + d->ahead * w->u[i], y + d->ahead * w->v[i]};
    const size_t by = (size_t)smaller(larger((s->f.y_listed[i] - g->y0) * per_y, 0), top);
    widen(&d->box[bx * d->ny + by], moved, moved);
  }
}

static double diagonal(const struct sph_drift_box *b) {
  return fmax(hypot(b->high[0] - b->low[0], b->high[1] - b->low[1]),
              hypot(b->high[2] - b->low[2], b->high[3] - b->low[3]));
}

/* The blocks from `far` before one to `far` behind it, along an axis of n. Round the ends of a
 * periodic tank they go on, by one more: the last block may be narrower than others. */
struct range {
  size_t from, count;
};

static struct range range_around(size_t at, size_t far, size_t n, bool periodic) {
  const size_t before = periodic && at < far ? far + 1 : at < far ? at : far;
  const bool last = at + far + 1 >= n;
  const size_t behind = periodic && last ? far + 1 : last ? n - 1 - at : far;
  if (before + behind >= n) return (struct range){0, n};
  return (struct range){at < before ? at + n - before : at - before, before + 1 + behind};
}

static size_t nth_of(const struct range *r, size_t k, size_t n) {
  return r->from + k < n ? r->from + k : r->from + k - n;
}

/* What particles around a block have moved against each other: in it and `far` blocks around. */
static double diagonal_around(const struct sph *s, size_t bx, size_t by, size_t far) {
  const struct sph_drift *d = &s->drift;
  struct sph_drift_box all = empty;
  const struct range x = range_around(bx, far, d->nx, s->tank.periodic[0]);
  const struct range y = range_around(by, far, d->ny, s->tank.periodic[1]);
  for (size_t k = 0; k < x.count; k++)
    for (size_t l = 0; l < y.count; l++) {
      const struct sph_drift_box *b = &d->box[nth_of(&x, k, d->nx) * d->ny + nth_of(&y, l, d->ny)];
      widen(&all, b->low, b->high);
    }
  return diagonal(&all);
}

void sph_drift_measure(struct sph *s, double ahead) {
  struct sph_drift *d = &s->drift;
  d->ahead = ahead;
#pragma omp parallel for schedule(dynamic)
  for (size_t bx = 0; bx < d->nx; bx++) fill_column(s, d, bx);
  double touching = 0, near = 0, most = 0;
#pragma omp parallel for schedule(dynamic) reduction(max : touching, near, most)
  for (size_t bx = 0; bx < d->nx; bx++)
    for (size_t by = 0; by < d->ny; by++) {
      const struct sph_drift_box *b = &d->box[bx * d->ny + by];
      if (b->low[0] > b->high[0]) continue; /* no water */
      touching = fmax(touching, diagonal_around(s, bx, by, 1));
      near = fmax(near, diagonal_around(s, bx, by, 2));
      for (int k = 0; k < 4; k += 2)
        most = fmax(most,
                    2 * hypot(fmax(b->high[k], -b->low[k]), fmax(b->high[k + 1], -b->low[k + 1])));
    }
  d->touching = touching;
  d->near = near;
  d->most = most;
}

double sph_drift_left(const struct sph *s) {
  const struct sph_drift *d = &s->drift;
  const double touching = s->skin - d->touching;
  const double near = fmax(s->skin, d->size - s->support) - d->near;
  const double most = fmax(s->skin, 2 * d->size - s->support) - d->most;
  return fmin(touching, fmin(near, most));
}

static double distance_from(const struct face *f, const double p[2], double nearest) {
  double foot[2];
  if (p[0] < smaller(f->a[0], f->b[0]) - nearest || p[0] > larger(f->a[0], f->b[0]) + nearest ||
      p[1] < smaller(f->a[1], f->b[1]) - nearest || p[1] > larger(f->a[1], f->b[1]) + nearest)
    return nearest;
  geo_segment_foot(f->a, f->b, p, foot);
  return smaller(nearest, hypot(p[0] - foot[0], p[1] - foot[1]));
}

void sph_drift_list_walls(struct sph *s) {
  const struct sph_particles *f = &s->f;
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < f->n; i++) {
    const double p[2] = {f->w.x[i], f->w.y[i]};
    double nearest = INFINITY;
    for (size_t k = 0; k < s->faces.n; k++) nearest = distance_from(&s->faces.face[k], p, nearest);
    f->x_walls[i] = p[0];
    f->y_walls[i] = p[1];
    f->off_walls[i] = nearest;
  }
}

/* A list of a wall concerns what is within the support of a wall particle, or of the node inside
 * from which a ghost takes its state: within two supports of the wall. */
double sph_drift_at_walls(const struct sph *s, double ahead) {
  const struct sph_particles *f = &s->f;
  const double far = 2 * s->support + s->wall_skin;
  double longest = 0;
#pragma omp parallel for simd schedule(static) reduction(max : longest)
  for (size_t i = 0; i < f->n; i++) {
    const double x = f->w.x[i] - f->x_walls[i], y = f->w.y[i] - f->y_walls[i];
    const double X = x + ahead * f->w.u[i], Y = y + ahead * f->w.v[i];
    const double way = sqrt(larger(x * x + y * y, X * X + Y * Y));
    longest = larger(way > f->off_walls[i] - far ? way : 0, longest);
  }
  return longest;
}

double sph_drift_since_sorted(const struct sph *s) {
  const struct sph_particles *f = &s->f;
  double longest2 = 0;
#pragma omp parallel for simd schedule(static) reduction(max : longest2)
  for (size_t i = 0; i < f->n; i++) {
    const double x = f->w.x[i] - f->x_listed[i], y = f->w.y[i] - f->y_listed[i];
    longest2 = larger(x * x + y * y, longest2);
  }
  return sqrt(longest2);
}

#include "sph/domain/layers.h"

#include <math.h>
#include <stdlib.h>

/* Columns along one direction at `first + i step`, rows along the other. */
struct strip {
  double x, dx, y, dy; /* first position and step */
  size_t nx, ny;
  bool mirror_x, mirror_y;
  double wall_x, wall_y;
};

/* Left, right, bed, and the two corners under them. */
static size_t tank_strips(const struct sph *s, struct strip strips[5]) {
  const struct tank *t = &s->tank;
  double dx = s->dx, x0 = t->box.min[0], x1 = t->box.max[0], y0 = t->box.min[1];
  size_t layers = (size_t)ceil(s->support / dx - 1e-9);
  size_t nl = geo_intervals(t->top[0] - y0, dx), nr = geo_intervals(t->top[1] - y0, dx);
  size_t nb = geo_intervals(x1 - x0, dx);
  double dl = (t->top[0] - y0) / (double)nl, dr = (t->top[1] - y0) / (double)nr;
  double db = (x1 - x0) / (double)nb;
  double out_left = x0 - dx / 2, out_right = x1 + dx / 2, under = y0 - dx / 2;
  strips[0] = (struct strip){out_left, -dx, y0 + dl / 2, dl, layers, nl, true, false, x0, 0};
  strips[1] = (struct strip){out_right, dx, y0 + dr / 2, dr, layers, nr, true, false, x1, 0};
  strips[2] = (struct strip){x0 + db / 2, db, under, -dx, nb, layers, false, true, 0, y0};
  strips[3] = (struct strip){out_left, -dx, under, -dx, layers, layers, true, true, x0, y0};
  strips[4] = (struct strip){out_right, dx, under, -dx, layers, layers, true, true, x1, y0};
  return 5;
}

/* The bed of a periodic tank, as far beyond its ends as water meets it (period.h). */
static size_t bed_strip(const struct sph *s, struct strip *strip) {
  const struct geo_box *box = &s->tank.box;
  double width = tank_size(&s->tank, 0), dx = s->dx;
  size_t layers = (size_t)ceil(s->support / dx - 1e-9), n = geo_intervals(width, dx);
  double db = width / (double)n, more = ceil((s->support + sph_period_widest(s)) / db);
  *strip = (struct strip){box->min[0] + (0.5 - more) * db,
                          db,
                          box->min[1] - dx / 2,
                          -dx,
                          n + 2 * (size_t)more,
                          layers,
                          false,
                          true,
                          0,
                          box->min[1]};
  return 1;
}

static size_t strips_of(const struct sph *s, struct strip strips[5]) {
  if (s->tank.periodic[1]) return 0;
  return s->tank.periodic[0] ? bed_strip(s, strips) : tank_strips(s, strips);
}

static enum status make_room(struct sph *s, size_t n, struct sph_layers *g) {
  g->n = s->w.n = n;
  g->room = (n + SPH_LANES - 1) / SPH_LANES * SPH_LANES;
  TRY(sph_allocate(n, sizeof(double), &s->w.x));
  TRY(sph_allocate(n, sizeof(double), &s->w.y));
  TRY(sph_allocate(g->room, sizeof(double), &g->x));
  TRY(sph_allocate(g->room, sizeof(double), &g->y));
  TRY(sph_allocate(g->room, sizeof(double), &g->rx));
  TRY(sph_allocate(g->room, sizeof(double), &g->ry));
  return sph_allocate(g->room, sizeof(double), &g->V);
}

/* As the strips have them: places, and which strip each is of. */
struct found {
  double *x, *y;
  size_t *strip;
  uint32_t *key, *order; /* of the sort */
};

static enum status find(const struct strip *strips, size_t n_strips, size_t n, struct found *f) {
  TRY(sph_allocate(n, sizeof *f->x, &f->x));
  TRY(sph_allocate(n, sizeof *f->y, &f->y));
  TRY(sph_allocate(n, sizeof *f->strip, &f->strip));
  TRY(sph_allocate(n, sizeof *f->key, &f->key));
  TRY(sph_allocate(n, sizeof *f->order, &f->order));
  size_t at = 0;
  for (size_t k = 0; k < n_strips; k++)
    for (size_t i = 0; i < strips[k].nx; i++)
      for (size_t j = 0; j < strips[k].ny; j++, at++) {
        f->x[at] = strips[k].x + (double)i * strips[k].dx;
        f->y[at] = strips[k].y + (double)j * strips[k].dy;
        f->strip[at] = k;
      }
  return OK;
}

static void forget(struct found *f) {
  free(f->x);
  free(f->y);
  free(f->strip);
  free(f->key);
  free(f->order);
}

static void place(struct sph *s, size_t i, double x, double y, const struct strip *t,
                  struct sph_layers *g) {
  g->x[i] = t->mirror_x ? 2 * t->wall_x - x : x;
  g->y[i] = t->mirror_y ? 2 * t->wall_y - y : y;
  g->rx[i] = t->mirror_x ? -1 : 1;
  g->ry[i] = t->mirror_y ? -1 : 1;
  g->V[i] = fabs(t->dx * t->dy);
  if (i >= g->n) return;
  s->w.x[i] = x;
  s->w.y[i] = y;
}

enum status sph_layers_create(struct sph *s, struct sph_layers *g) {
  struct strip strips[5];
  struct found f = {0};
  enum status status = OK;
  const size_t n_strips = strips_of(s, strips);
  const struct geo_box box = tank_around(&s->tank, s->support + s->dx);
  size_t n = 0;
  for (size_t k = 0; k < n_strips; k++) n += strips[k].nx * strips[k].ny;
  ATTEMPT(make_room(s, n, g));
  ATTEMPT(find(strips, n_strips, n, &f));
  ATTEMPT(sph_grid_create(&s->w.grid, &box, s->dx));
  sph_grid_sort(&s->w.grid, n, f.x, f.y, NULL, f.key, f.order);
  for (size_t i = 0; i < g->room; i++) {
    const size_t o = f.order[i < n ? i : n - 1];
    place(s, i, f.x[o], f.y[o], &strips[f.strip[o]], g);
  }
done:
  forget(&f);
  return status;
}

void sph_layers_destroy(struct sph_layers *g) {
  free(g->x);
  free(g->y);
  free(g->rx);
  free(g->ry);
  free(g->V);
}

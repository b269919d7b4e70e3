#include "sph/start/initial.h"

#include <math.h>
#include <stdlib.h>

#include "sph/pair/eos.h"
#include "sph/start/cells.h"
#include "sph/start/released.h"

static const double close = 1e-9; /* of H: how far apart two lengths may be and still be the same */

static void place(struct sph *s, double x, double y, const double velocity[2], double pressure,
                  double cell) {
  struct sph_particles *f = &s->f;
  size_t i = f->n++;
  f->w.x[i] = x;
  f->w.y[i] = y;
  f->w.u[i] = velocity[0];
  f->w.v[i] = velocity[1];
  f->w.rho[i] = eos_density((enum sph_eos)s->scheme.eos, s->rho0, s->c0, pressure);
  f->m[i] = f->w.rho[i] * cell;
}

/* ---- pressure ---- */

/* Where the pressure of the regions comes from. */
struct head {
  const struct case_file *c;
  double near;                   /* m: what lies closer is one body */
  bool column, left;             /* a column at one wall that is released */
  struct geo_box box;            /* of the column */
  struct sph_released *released; /* any other water that is */
  struct geo_cut cut;            /* the water above and below a point */
};

/* One rectangle that stands on the bed against just one side wall. */
static bool find_column(const struct case_file *c, double near, struct head *h) {
  if (c->water.pieces != 1) return false;
  h->box = geo_lines_box(&c->water);
  double width = h->box.max[0] - h->box.min[0], height = h->box.max[1] - h->box.min[1];
  double missing = fabs(fabs(geo_piece_area(&c->water, 0)) - width * height);
  h->left = fabs(h->box.min[0] - c->tank.min[0]) < near;
  bool right = fabs(h->box.max[0] - c->tank.max[0]) < near;
  return missing < close * width * height && fabs(h->box.min[1] - c->tank.min[1]) < near &&
         h->left != right;
}

static enum status head_create(const struct sph *s, const struct case_file *c, struct head *h) {
  *h = (struct head){.c = c, .near = close * c->H};
  if (c->pressure != CASE_PRESSURE_RELEASED) return OK;
  h->column = find_column(c, h->near, h);
  if (h->column) return OK;
  return sph_released_create(&c->water, &s->tank, s->dx, h->near, &h->released);
}

static void head_destroy(struct head *h) {
  sph_released_destroy(h->released);
  geo_cut_destroy(&h->cut);
}

static enum status hydrostatic(struct head *h, double x, double y, double *head) {
  TRY(geo_lines_cut(&h->c->water, 0, x, h->near, &h->cut));
  const double *span = geo_cut_span(&h->cut, y);
  bool stands = span && fabs(span[0] - h->c->tank.min[1]) <= h->near;
  *head = stands ? fmax(span[1] - y, 0) : 0;
  return OK;
}

/* Pressure over rho g at a point of the regions. */
static enum status head_at(struct head *h, double x, double y, double *head) {
  const struct geo_box *b = &h->box;
  if (h->column)
    *head = sph_released_head(h->left ? x - b->min[0] : b->max[0] - x, y - b->min[1],
                              b->max[0] - b->min[0], b->max[1] - b->min[1]);
  else if (h->released)
    *head = sph_released_at(h->released, x, y);
  else
    return hydrostatic(h, x, y, head);
  return OK;
}

/* ---- regions ---- */

struct cells {
  size_t n;
  struct sph_cell *cell; /* [n], owned */
};

/* One closed piece of the water, alone. */
static enum status region_of(const struct case_file *c, size_t piece, struct geo_lines *region) {
  geo_lines_clear(region);
  TRY(geo_lines_begin(region, true));
  for (size_t k = c->water.first[piece]; k < c->water.first[piece + 1]; k++)
    TRY(geo_lines_add(region, c->water.p[k][0], c->water.p[k][1]));
  return OK;
}

static enum status fill_cells(struct sph *s, const struct case_file *c, const struct cells *cells) {
  enum status status = OK;
  struct head head;
  ATTEMPT(head_create(s, c, &head));
  for (size_t r = 0; r < c->water.pieces; r++)
    for (size_t k = 0; k < cells[r].n; k++) {
      const struct sph_cell *cell = &cells[r].cell[k];
      double depth = 0;
      ATTEMPT(head_at(&head, cell->x, cell->y, &depth));
      place(s, cell->x, cell->y, c->velocity, s->rho0 * s->g * depth, cell->area);
    }
done:
  head_destroy(&head);
  return status;
}

static enum status fill_regions(struct sph *s, const struct case_file *c) {
  struct geo_lines region = {0};
  struct cells *cells = NULL;
  enum status status = OK;
  size_t room = 0;
  ATTEMPT(sph_allocate(c->water.pieces, sizeof *cells, &cells));
  for (size_t r = 0; r < c->water.pieces; r++) {
    ATTEMPT(region_of(c, r, &region));
    ATTEMPT(sph_cells_create(&region, s->dx, &cells[r].n, &cells[r].cell));
    room += cells[r].n;
  }
  ATTEMPT(sph_particles_create(&s->f, room));
  s->f.n = 0;
  ATTEMPT(fill_cells(s, c, cells));
done:
  for (size_t r = 0; cells && r < c->water.pieces; r++) free(cells[r].cell);
  free(cells);
  geo_lines_destroy(&region);
  return status;
}

/* ---- waves ---- */

/* At rest with elevation a cos(kx); the pressure of the linear wave, stretched with the column so
 * that it vanishes on the surface: p/(rho g) = depth - eta (1 - cosh(k Y)/cosh(k d)), Y the height
 * that the particle would have in still water. */
static enum status fill_standing_wave(struct sph *s, const struct case_file *c) {
  const double rest[2] = {0, 0};
  double width = s->tank.box.max[0] - s->tank.box.min[0], d = c->wave.depth, a = c->wave.amplitude;
  double k = 2 * M_PI / c->wave.wavelength;
  size_t nx = sph_intervals(width, s->dx), ny = sph_intervals(d, s->dx);
  TRY(sph_particles_create(&s->f, nx * ny));
  s->f.n = 0;
  double dx = width / (double)nx;
  for (size_t i = 0; i < nx; i++) {
    double x = ((double)i + 0.5) * dx, eta = a * cos(k * x), dy = (d + eta) / (double)ny;
    for (size_t j = 0; j < ny; j++) {
      double y = ((double)j + 0.5) * dy, Y = ((double)j + 0.5) * d / (double)ny;
      double decay = exp(k * (Y - d)) * (1 + exp(-2 * k * Y)) / (1 + exp(-2 * k * d));
      double head = d + eta - y - eta * (1 - decay);
      place(s, s->tank.box.min[0] + x, s->tank.box.min[1] + y, rest, s->rho0 * s->g * head,
            dx * dy);
    }
  }
  return OK;
}

enum status sph_initial_fill(struct sph *s, const struct case_file *c) {
  if (c->wave.kind == CASE_WAVE_STANDING)
    TRY(fill_standing_wave(s, c));
  else
    TRY(fill_regions(s, c));
  CHECK(s->f.n > 0, ERR_INPUT,
        "no particle of spacing %g m fits into the water: raise the resolution", s->dx);
  sph_particles_pad(&s->f);
  return OK;
}

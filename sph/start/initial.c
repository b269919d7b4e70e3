#include "sph/start/initial.h"

#include <stdlib.h>

#include "common/flow/flow.h"
#include "sph/domain/fitted.h"
#include "sph/pair/momentum.h"
#include "sph/start/cells.h"

/* Water being placed. */
struct filling {
  struct sph *s;
  const struct case_file *c;
  struct flow_water water;
};

/* The density that evolves, from the head of the pressure. */
static double density_of(const struct filling *w, double head, double y) {
  const struct sph *s = w->s;
  return eos_stored(&s->eos, eos_driving_of(&s->eos, s->rho0 * w->c->g * head, y), y);
}

static enum status place(struct filling *w, const struct flow_point *p, double cell) {
  struct sph *s = w->s;
  struct sph_particles *f = &s->f;
  double head = 0, velocity[2];
  TRY(flow_head(&w->water, p, &head));
  flow_velocity(&w->water, p->x, p->y, 0, velocity);
  size_t i = f->n++;
  f->w.x[i] = p->x;
  f->w.y[i] = p->y;
  f->w.u[i] = velocity[0];
  f->w.v[i] = velocity[1];
  f->w.rho[i] = density_of(w, head, p->y);
  f->m[i] = f->w.rho[i] * cell;
  return OK;
}

/* ---- regions ---- */

struct cells {
  size_t n;
  struct sph_cell *cell; /* [n], owned */
};

/* One closed piece of the water, alone. */
static enum status region_of(const struct geo_lines *water, size_t piece,
                             struct geo_lines *region) {
  geo_lines_clear(region);
  return geo_lines_add_piece(region, water, piece);
}

static enum status place_cells(struct filling *w, const struct cells *cells) {
  for (size_t k = 0; k < cells->n; k++) {
    const struct sph_cell *cell = &cells->cell[k];
    const double *down = w->c->down, x = -down[1] * cell->x - down[0] * cell->y;
    const double y = down[0] * cell->x - down[1] * cell->y;
    TRY(place(w, &(struct flow_point){x, y, y}, cell->area));
  }
  return OK;
}

/* Cells lie level as gravity has it: the water of a case that is turned as a whole is the same
 * water, turned. The level of a wave's water at rest is an edge between rows of them, so that its
 * first row stands half a row below it, as that of water in a rectangular tank does. */
static enum status fill_regions(struct filling *w) {
  struct sph *s = w->s;
  const size_t regions = w->c->water.pieces;
  struct geo_lines level = {0}, region = {0};
  struct cells *cells = NULL;
  enum status status = OK;
  size_t room = 0;
  ATTEMPT(case_turn_lines(w->c, &w->c->water, &level));
  ATTEMPT(sph_allocate(regions, sizeof *cells, &cells));
  for (size_t r = 0; r < regions; r++) {
    ATTEMPT(region_of(&level, r, &region));
    const double rows =
        flow_is_wave(w->c->flow) ? flow_level(w->c) - geo_lines_box(&region).min[1] : 0;
    ATTEMPT(sph_cells_create(&region, s->dx, rows, &cells[r].n, &cells[r].cell));
    room += cells[r].n;
  }
  ATTEMPT(sph_particles_create(&s->f, room));
  s->f.n = 0;
  for (size_t r = 0; r < regions; r++) ATTEMPT(place_cells(w, &cells[r]));
done:
  for (size_t r = 0; cells && r < regions; r++) free(cells[r].cell);
  free(cells);
  geo_lines_destroy(&region);
  geo_lines_destroy(&level);
  return status;
}

/* ---- waves ---- */

/* Rows of particles in water of this depth: the first half a spacing below the surface, or on it.
 */
struct rows {
  size_t n;
  double height; /* of a row, m; the first lies half of it above the bed */
};

static struct rows rows_in(const struct sph *s, double depth) {
  const bool below = s->scheme.free_surface == SPH_FREE_SURFACE_natural;
  const size_t n = geo_intervals(depth + (below ? 0 : s->dx / 2), s->dx);
  return (struct rows){n, depth / ((double)n - (below ? 0 : 0.5))};
}

static enum status mark_first_row(struct sph *s, const struct rows *rows) {
  if (s->scheme.free_surface != SPH_FREE_SURFACE_fitted) return OK;
  TRY(sph_allocate(s->f.n, sizeof *s->fitted, &s->fitted));
  for (size_t i = 0; i < s->f.n; i++) s->fitted[s->f.id[i]] = i % rows->n == rows->n - 1;
  return OK;
}

/* A lattice at rest from the bed to the surface, which the wave moves. */
static enum status fill_lattice(struct filling *w) {
  struct sph *s = w->s;
  const double *corner = s->tank.box.min, depth = w->c->flow->scale(w->c).depth;
  const double width = tank_size(&s->tank, 0);
  const struct rows rows = rows_in(s, depth);
  const size_t nx = geo_intervals(width, s->dx), ny = rows.n;
  const double dx = width / (double)nx, dy = rows.height;
  TRY(sph_particles_create(&s->f, nx * ny));
  for (size_t i = 0; i < nx * ny; i++) {
    struct flow_start p;
    const double X = corner[0] + ((double)(i / ny) + 0.5) * dx;
    const double Y = corner[1] + ((double)(i % ny) + 0.5) * dy;
    w->c->flow->start(&w->water, X, Y, &p);
    s->f.w.x[i] = p.x;
    s->f.w.y[i] = p.y;
    s->f.w.u[i] = p.u;
    s->f.w.v[i] = p.v;
    s->f.w.rho[i] = density_of(w, p.head, p.y);
    s->f.m[i] = density_of(w, p.rest, Y) * dx * dy;
  }
  return mark_first_row(s, &rows);
}

/* Column by column, each as many particles high, stretched from the bed to the elevation. */
static enum status fill_columns(struct filling *w) {
  struct sph *s = w->s;
  const double *corner = s->tank.box.min, depth = w->c->flow->scale(w->c).depth;
  double width = s->tank.box.max[0] - corner[0];
  const struct rows rows = rows_in(s, depth);
  size_t nx = geo_intervals(width, s->dx), ny = rows.n;
  TRY(sph_particles_create(&s->f, nx * ny));
  s->f.n = 0;
  double dx = width / (double)nx;
  for (size_t i = 0; i < nx; i++) {
    double x = corner[0] + ((double)i + 0.5) * dx;
    double dy = (flow_elevation(&w->water, x, 0) - corner[1]) / (depth / rows.height);
    for (size_t j = 0; j < ny; j++) {
      double up = (double)j + 0.5;
      const struct flow_point p = {x, corner[1] + up * dy, corner[1] + up * rows.height};
      TRY(place(w, &p, dx * dy));
    }
  }
  return mark_first_row(s, &rows);
}

enum status sph_initial_fill(struct sph *s, const struct case_file *c) {
  struct filling w = {.s = s, .c = c};
  enum status status = OK;
  const bool even =
      momentum_is_of_reference((enum sph_momentum)s->scheme.momentum); /* thesis, eq. (4.27) */
  const struct flow_use use = {.spacing = s->dx, .sound = s->c0, .even = even};
  ATTEMPT(flow_open(c, use, &w.water));
  const bool stands = flow_is_wave(c->flow) && !flow_line_of(c) && c->rectangular;
  ATTEMPT(c->flow->start ? fill_lattice(&w) : stands ? fill_columns(&w) : fill_regions(&w));
done:
  flow_close(&w.water);
  TRY(status);
  CHECK(s->f.n > 0, ERR_INPUT,
        "no particle of spacing %g m fits into the water: raise the resolution", s->dx);
  sph_fitted_set(s);
  sph_particles_pad(&s->f);
  return OK;
}

#include "bem/water/lattice.h"

#include <math.h>
#include <stdlib.h>

#include "common/base/array.h"

static const double SAME = 1e-12; /* H: pieces of the water so near are one */
static const double NEAR = 1e-9;  /* H: what is so near the water is in it */

void bem_lattice_destroy(struct bem_lattice *l) {
  free(l->x);
  bem_inside_destroy(&l->inside);
  geo_lines_destroy(&l->outline);
  geo_cut_destroy(&l->cut);
  *l = (struct bem_lattice){0};
}

/* ---- the outline of the water ---- */

static enum status add_surface(const struct bem_surface *s, const double *state, double shift,
                               struct geo_lines *out) {
  for (size_t k = 0; k < s->n; k++) TRY(geo_lines_add(out, state[k] + shift, state[s->n + k]));
  return OK;
}

/* Of water without sides so many periods that the first and the last node, below which the outline
 * goes straight down whatever hangs over there, are a period away from the tank. */
static enum status add_periods(const struct bem_surface *s, const double *state,
                               struct geo_lines *out) {
  const double length = s->period.length, first = floor(state[0] / length);
  for (int k = -2; k <= 2; k++) TRY(add_surface(s, state, (k - first) * length, out));
  return OK;
}

/* Back from the last node to the first, along the walls. */
static enum status add_walls(const struct bem_surface *s, struct geo_lines *out) {
  if (s->walls) {
    for (size_t i = s->side[1]; i > s->side[0]; i--)
      TRY(geo_lines_add(out, creal(s->walls->point[i]), cimag(s->walls->point[i])));
    return OK;
  }
  TRY(geo_lines_add(out, out->p[out->points - 1][0], 0));
  return geo_lines_add(out, out->p[0][0], 0);
}

static enum status set_outline(struct bem_lattice *l, const struct bem_surface *s,
                               const double *state) {
  geo_lines_clear(&l->outline);
  TRY(geo_lines_begin(&l->outline, true));
  TRY(bem_surface_is_closed(s) ? add_periods(s, state, &l->outline)
                               : add_surface(s, state, 0, &l->outline));
  return add_walls(s, &l->outline);
}

/* ---- its points ---- */

static enum status reserve(struct bem_lattice *l, size_t n) {
  enum { FIELDS = 6 };
  if (n <= l->room) return OK;
  double *old = l->x;
  const size_t was = l->room, room = array_room(was, n);
  double *memory = NULL;
  TRY(array_create(&memory, FIELDS * room, "points of a lattice"));
  for (size_t k = 0; k < FIELDS; k++)
    for (size_t i = 0; i < l->n; i++) memory[k * room + i] = old[k * was + i];
  free(old);
  l->room = room;
  l->x = memory, l->y = l->x + room, l->phi = l->y + room, l->pressure = l->phi + room;
  l->u = l->pressure + room, l->v = l->u + room;
  return OK;
}

static size_t nearest_node(const struct bem_surface *s, const double *state, double complex z) {
  size_t at = 0;
  double least = INFINITY;
  for (size_t k = 0; k < s->n; k++) {
    const double way = hypot(state[k] - creal(z), state[s->n + k] - cimag(z));
    if (way < least) least = way, at = k;
  }
  return at;
}

struct look {
  const struct bem_pressure *p;
  const struct bem_flow *f;
  const double *state;
};

/* Where a span begins is surface, or a wall that water is under. */
static void start_span(struct bem_lattice *l, const struct look *at, double complex top) {
  const struct bem_surface *s = &at->f->surface;
  if (s->walls && bem_conformal_is_near(s->walls, top) &&
      bem_inside_start_on_wall(&l->inside, at->p, at->f, top))
    return;
  bem_inside_start(&l->inside, at->p, at->f, nearest_node(s, at->state, top));
}

/* Down one span of a column. A point that the way is not found to is passed over. */
static enum status fill_span(struct bem_lattice *l, const struct look *at, double x,
                             const double span[2], double h) {
  start_span(l, at, CMPLX(x, span[1]));
  for (double j = ceil(span[1] / h - 0.5) - 1; (j + 0.5) * h > span[0]; j--) {
    const double complex z = CMPLX(x, (j + 0.5) * h);
    struct bem_place place;
    if (!bem_inside_at(&l->inside, at->p, at->f, at->state, z, &place)) {
      l->missing++;
      continue;
    }
    TRY(reserve(l, l->n + 1));
    const size_t i = l->n++;
    l->x[i] = creal(z);
    l->y[i] = cimag(z);
    l->phi[i] = place.phi;
    l->pressure[i] = place.pressure;
    l->u[i] = creal(place.w);
    l->v[i] = -cimag(place.w);
  }
  return OK;
}

static enum status fill_column(struct bem_lattice *l, const struct look *at, double x, double h) {
  TRY(geo_lines_cut(&l->outline, 0, x, SAME, &l->cut));
  for (size_t i = 0; i < l->cut.n; i++) TRY(fill_span(l, at, x, l->cut.span[i], h));
  return OK;
}

enum status bem_lattice_begin(struct bem_lattice *l, const struct bem_flow *f,
                              const double *state) {
  TRY(bem_inside_begin(&l->inside, f));
  return set_outline(l, &f->surface, state);
}

enum status bem_lattice_fill(struct bem_lattice *l, const struct bem_pressure *p,
                             const struct bem_flow *f, const double *state, double spacing) {
  const struct bem_surface *s = &f->surface;
  const struct look at = {p, f, state};
  const size_t columns = geo_intervals(s->tank - s->left, spacing);
  const double h = (s->tank - s->left) / (double)columns;
  l->n = 0;
  l->cell = h * h;
  TRY(bem_lattice_begin(l, f, state));
  for (size_t i = 0; i < columns; i++) TRY(fill_column(l, &at, s->left + ((double)i + 0.5) * h, h));
  return OK;
}

/* ---- one place ---- */

/* *top: where the water above z begins. Beside an upright wall a column may miss the water that
 * touches the wall. */
static enum status find_top(struct bem_lattice *l, double complex z, bool *found,
                            double complex *top) {
  const double aside[] = {0, NEAR, -NEAR}, y = cimag(z);
  *found = false;
  for (size_t k = 0; k < sizeof aside / sizeof *aside && !*found; k++) {
    TRY(geo_lines_cut(&l->outline, 0, creal(z) + aside[k], SAME, &l->cut));
    for (size_t i = 0; i < l->cut.n && !*found; i++) {
      *found = y > l->cut.span[i][0] - NEAR && y < l->cut.span[i][1] + NEAR;
      *top = CMPLX(creal(z), l->cut.span[i][1]);
    }
  }
  return OK;
}

enum status bem_lattice_at(struct bem_lattice *l, const struct bem_pressure *p,
                           const struct bem_flow *f, const double *state, double complex z,
                           bool *found, struct bem_place *out) {
  const struct bem_conformal *walls = f->surface.walls;
  const struct look at = {p, f, state};
  double complex top = z;
  TRY(find_top(l, z, found, &top));
  if (!*found) return OK;
  if (!walls || !bem_conformal_is_near(walls, z))
    start_span(l, &at, top);
  else if (!(*found = bem_inside_start_on_wall(&l->inside, p, f, z)))
    return OK;
  *found = bem_inside_at(&l->inside, p, f, state, z, out) && isfinite(out->pressure) &&
           isfinite(cabs(out->w));
  return OK;
}

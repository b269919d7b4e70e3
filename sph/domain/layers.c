#include "sph/domain/layers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"

static const double right_angle = 1e-6; /* rad, from a right one */
static const double least_part = 1e-6;  /* of a cell that is worth a particle */

/* ---- what is found ---- */

struct sph_site {
  double x, y, V; /* m, m^2 */
  double node[2]; /* the mirror point, m */
  double slide;
  uint32_t motion, chain;
};

struct sites {
  const struct sph *s;
  const struct faces *faces;
  size_t layers;
  struct sph_layers *g; /* its sites */
};

/* Half-way to the first wall between `from`, on the walls, and the mirror point. */
static void pull(const struct faces *faces, const double from[2], double node[2]) {
  double first = INFINITY, part;
  for (size_t k = 0; k < faces->n; k++)
    if (face_stops(&faces->face[k], from, node, 0, &part)) first = fmin(first, part);
  if (first > 1) return;
  for (int axis = 0; axis < 2; axis++)
    node[axis] = from[axis] + first / 2 * (node[axis] - from[axis]);
}

/* The hinge of a flap, where the walls may bend either way. */
static bool bends(const struct sph *s, const struct face *f) {
  return s->sides.move && f->next != FACE_NONE && f->point[1] != FACE_NO_POINT &&
         s->sides.bends[f->point[1]];
}

/* All of it two supports away from corners of the solid, nothing nearer than one. */
static double slide_at(const struct sites *all, double x, double y) {
  double near = INFINITY;
  for (size_t k = 0; k < all->faces->n; k++) {
    const struct face *f = &all->faces->face[k];
    if (f->end[1] == FACE_END_BLUNT && !bends(all->s, f))
      near = fmin(near, hypot(x - f->b[0], y - f->b[1]));
  }
  return fmin(fmax(near / all->s->support - 1, 0), 1);
}

/* The image of `node` by that motion, as seen from `from`. */
static enum status add(struct sites *all, const struct sph_site *site, const double from[2]) {
  struct sph_layers *g = all->g;
  TRY(array_grow(&g->site, &g->site_room, g->n_sites + 1, "wall particles"));
  struct sph_site *new = &g->site[g->n_sites++];
  *new = *site;
  new->slide = slide_at(all, site->x, site->y);
  pull(all->faces, from, new->node);
  return OK;
}

/* ---- cells that are cut ---- */

/* A half-plane: what is to the left of t, through p. */
struct side {
  double p[2], t[2];
};

struct cell {
  size_t n;
  double p[8][2]; /* m, convex */
};

static double left_of(const struct side *s, const double p[2]) {
  return s->t[0] * (p[1] - s->p[1]) - s->t[1] * (p[0] - s->p[0]);
}

static void cut(struct cell *c, const struct side *side) {
  struct cell out = {0};
  for (size_t i = 0; i < c->n; i++) {
    const double *p = c->p[i], *q = c->p[(i + 1) % c->n];
    const double a = left_of(side, p), b = left_of(side, q);
    if (a >= 0) memcpy(out.p[out.n++], p, sizeof *out.p);
    if ((a < 0) == (b < 0)) continue;
    for (int axis = 0; axis < 2; axis++)
      out.p[out.n][axis] = p[axis] + a / (a - b) * (q[axis] - p[axis]);
    out.n++;
  }
  *c = out;
}

/* Its area, and its centroid into x and y. */
static double measure(const struct cell *c, double *x, double *y) {
  double area = 0, mx = 0, my = 0;
  for (size_t i = 1; i + 1 < c->n; i++) {
    const double ux = c->p[i][0] - c->p[0][0], uy = c->p[i][1] - c->p[0][1];
    const double vx = c->p[i + 1][0] - c->p[0][0], vy = c->p[i + 1][1] - c->p[0][1];
    const double a = fabs(ux * vy - uy * vx) / 2;
    area += a;
    mx += a * (ux + vx) / 3;
    my += a * (uy + vy) / 3;
  }
  *x = c->n && area > 0 ? c->p[0][0] + mx / area : 0;
  *y = c->n && area > 0 ? c->p[0][1] + my / area : 0;
  return area;
}

/* ---- strips ---- */

/* Along the face from its lower or left end, and into the wall. */
struct strip {
  uint32_t face;
  double base[2], t[2], into[2]; /* m, 1, 1 */
  double ds, first;              /* m; where its first cell begins, in cells */
  size_t cells;
  bool upright;
};

/* Where a blunt corner of the solid is: what of the cells is on this side of its bisector. */
static bool side_at(const struct faces *faces, const struct face *f, int end, struct side *side) {
  if (f->end[end] != FACE_END_BLUNT) return false;
  const struct face *other = &faces->face[end ? f->next : f->before];
  const double x = f->t[0] + other->t[0], y = f->t[1] + other->t[1];
  memcpy(side->p, end ? f->b : f->a, sizeof side->p);
  side->t[0] = end ? -y : y;
  side->t[1] = end ? x : -x;
  return true;
}

static struct strip strip_of(const struct sites *all, uint32_t face) {
  const struct face *f = &all->faces->face[face];
  const struct sph_division *d = &all->g->division[face];
  struct strip t = {.face = face, .cells = d->cells, .upright = d->upright};
  const bool back = d->back;
  t.ds = f->length / (double)t.cells;
  for (int axis = 0; axis < 2; axis++) {
    t.base[axis] = back ? f->b[axis] : f->a[axis];
    t.t[axis] = back ? -f->t[axis] : f->t[axis];
  }
  t.into[0] = f->t[1];
  t.into[1] = -f->t[0];
  return t;
}

/* The bed of a periodic tank goes on beyond its ends, as far as water meets it (period.h). */
static struct strip strip_of_periods(const struct sites *all, uint32_t face) {
  const struct geo_box *box = &all->s->tank.box;
  struct strip t = strip_of(all, face);
  const double width = tank_size(&all->s->tank, 0);
  const size_t n = geo_intervals(width, all->s->dx);
  t.ds = width / (double)n;
  t.base[0] = box->min[0];
  const double more = ceil((all->s->support + sph_period_widest(all->s)) / t.ds);
  t.first = -more;
  t.cells = n + 2 * (size_t)more;
  return t;
}

static enum status add_to_strip(struct sites *all, const struct strip *t, struct sph_site *site) {
  const struct face *f = &all->faces->face[t->face];
  const struct rigid m = rigid_mirror(f->a, f->b);
  rigid_turn(&m, site->x, site->y, &site->node[0], &site->node[1]);
  for (int axis = 0; axis < 2; axis++) site->node[axis] += m.at[axis];
  site->motion = 2 * t->face;
  site->chain = f->chain;
  const double s = face_along(f, site->x, site->y);
  return add(all, site, (double[]){f->a[0] + s * f->t[0], f->a[1] + s * f->t[1]});
}

/* The cell `i` along the strip and `j` into the wall: its middle and its area. */
static struct sph_site middle_of(const struct sites *all, const struct strip *t, size_t i,
                                 size_t j) {
  const double dx = all->s->dx;
  double at[2];
  for (int axis = 0; axis < 2; axis++) {
    at[axis] = t->base[axis] + t->into[axis] * (dx / 2) + t->t[axis] * ((0.5 + t->first) * t->ds);
    at[axis] += (double)j * (t->into[axis] * dx) + (double)i * (t->t[axis] * t->ds);
  }
  return (struct sph_site){.x = at[0], .y = at[1], .V = fabs(dx * t->ds)};
}

static struct cell cell_around(const struct sites *all, const struct strip *t,
                               const struct sph_site *site) {
  const double s = t->ds / 2, d = all->s->dx / 2;
  struct cell c = {.n = 4};
  for (int k = 0; k < 4; k++) {
    const double along = k == 0 || k == 3 ? -s : s, in = k < 2 ? -d : d;
    c.p[k][0] = site->x + along * t->t[0] + in * t->into[0];
    c.p[k][1] = site->y + along * t->t[1] + in * t->into[1];
  }
  return c;
}

static enum status add_cell(struct sites *all, const struct strip *t, size_t i, size_t j,
                            const struct side *sides, int n_sides) {
  struct sph_site site = middle_of(all, t, i, j);
  if (n_sides) {
    struct cell c = cell_around(all, t, &site);
    for (int k = 0; k < n_sides; k++) cut(&c, &sides[k]);
    double x, y;
    const double whole = site.V, area = measure(&c, &x, &y);
    const bool any = area >= least_part * whole;
    if (!any && !all->s->sides.move) return OK; /* else it may become one */
    if (any) {
      site.x = x;
      site.y = y;
    }
    site.V = any ? area : 0;
  }
  return add_to_strip(all, t, &site);
}

/* Upright ones layer by layer, others column by column: from left to right. */
static enum status add_cells(struct sites *all, const struct strip *t, const struct side *sides,
                             int n_sides) {
  const size_t outer = t->upright ? all->layers : t->cells;
  const size_t inner = t->upright ? t->cells : all->layers;
  for (size_t p = 0; p < outer; p++)
    for (size_t q = 0; q < inner; q++)
      TRY(add_cell(all, t, t->upright ? q : p, t->upright ? p : q, sides, n_sides));
  return OK;
}

/* What is seen through a face may be beyond its edge, or half an end, as far as the support. */
static enum status add_beyond(struct sites *all, const struct strip *whole, int end,
                              const struct side *sides, int n_sides) {
  const struct face *f = &all->faces->face[whole->face];
  struct strip t = *whole;
  if (f->end[end] != FACE_END_EDGE && f->end[end] != FACE_END_HALF) return OK;
  t.cells = all->g->division[t.face].beyond;
  const bool first = t.t[0] * f->t[0] + t.t[1] * f->t[1] > 0 ? end == 0 : end == 1;
  t.first = first ? -(double)t.cells : (double)whole->cells;
  return add_cells(all, &t, sides, n_sides);
}

static enum status add_strip(struct sites *all, uint32_t face) {
  const struct face *f = &all->faces->face[face];
  if (all->s->tank.periodic[0]) {
    const struct strip t = strip_of_periods(all, face);
    return add_cells(all, &t, NULL, 0);
  }
  const struct strip t = strip_of(all, face);
  struct side sides[2];
  int n = 0;
  for (int end = 0; end < 2; end++) n += side_at(all->faces, f, end, &sides[n]);
  TRY(add_cells(all, &t, sides, n));
  for (int end = 0; end < 2; end++) TRY(add_beyond(all, &t, end, sides, n));
  return OK;
}

/* ---- corners ---- */

static enum status add_to_corner(struct sites *all, uint32_t face, struct sph_site *site) {
  const struct face *f = &all->faces->face[face];
  site->motion = 2 * f->next + 1;
  site->chain = f->chain;
  return add(all, site, f->b);
}

/* The square between the strips of two faces at a right angle, from left to right. */
static enum status add_square(struct sites *all, uint32_t face) {
  const struct face *f = &all->faces->face[face], *g = &all->faces->face[f->next];
  const double n[2][2] = {{f->t[1], -f->t[0]}, {g->t[1], -g->t[0]}}, dx = all->s->dx;
  const bool first = fabs(n[0][0]) > fabs(n[1][0]);
  const double *across = n[!first], *other = n[first];
  for (size_t i = 0; i < all->layers; i++)
    for (size_t j = 0; j < all->layers; j++) {
      double at[2];
      for (int axis = 0; axis < 2; axis++)
        at[axis] = f->b[axis] + across[axis] * (dx / 2) + other[axis] * (dx / 2) +
                   (double)i * (across[axis] * dx) + (double)j * (other[axis] * dx);
      struct sph_site site = {
          .x = at[0], .y = at[1], .V = dx * dx, .node = {2 * f->b[0] - at[0], 2 * f->b[1] - at[1]}};
      TRY(add_to_corner(all, face, &site));
    }
  return OK;
}

/* Rings about the vertex. In a corner sharper than a right angle the half turn of some particles
 * would be in no water: all look along the bisector. */
static enum status add_rings(struct sites *all, uint32_t face) {
  const struct face *f = &all->faces->face[face];
  const double dx = all->s->dx, start = atan2(-f->t[0], f->t[1]);
  for (size_t j = 0; j < all->layers; j++) {
    const double r = ((double)j + 0.5) * dx, arc = r * fmax(f->turn, 0);
    const size_t m = geo_intervals(r * all->g->division[face].turn, dx);
    for (size_t i = 0; i < m; i++) {
      const double angle = start + ((double)i + 0.5) / (double)m * f->turn;
      const double back = f->turn > M_PI / 2 ? start + f->turn / 2 : angle;
      struct sph_site site = {.x = f->b[0] + r * cos(angle),
                              .y = f->b[1] + r * sin(angle),
                              .V = arc * dx / (double)m,
                              .node = {f->b[0] - r * cos(back), f->b[1] - r * sin(back)}};
      TRY(add_to_corner(all, face, &site));
    }
  }
  return OK;
}

static enum status add_corner(struct sites *all, uint32_t face) {
  const struct face *f = &all->faces->face[face];
  if (bends(all->s, f)) return add_rings(all, face);
  if (f->end[1] != FACE_END_CORNER || f->turn < right_angle) return OK;
  return fabs(f->turn - M_PI / 2) < right_angle ? add_square(all, face) : add_rings(all, face);
}

/* ---- all ---- */

static struct sph_division division_of(const struct sph *s, const struct face *f) {
  const bool upright = fabs(f->t[1]) > fabs(f->t[0]);
  const size_t cells = geo_intervals(f->length, s->dx);
  return (struct sph_division){.cells = cells,
                               .beyond = (size_t)ceil(s->support / (f->length / (double)cells)),
                               .upright = upright,
                               .back = (upright ? f->t[1] : f->t[0]) < 0,
                               .turn = fmax(f->turn, 0)};
}

static bool fits(const struct sph *s, const struct face *f, const struct sph_division *d) {
  return fabs(f->length / ((double)d->cells * s->dx) - 1) < 0.1 + 0.5 / (double)d->cells &&
         fabs(fmax(f->turn, 0) - d->turn) < 0.2;
}

/* Anew, unless all are well divided. */
static void divide(struct sph *s, struct sph_layers *g, bool anew) {
  for (size_t k = 0; k < s->faces.n && !anew; k++)
    anew = !fits(s, &s->faces.face[k], &g->division[k]);
  for (size_t k = 0; k < s->faces.n && anew; k++)
    g->division[k] = division_of(s, &s->faces.face[k]);
}

/* Always as many, in the same order, as long as the division is the same. */
static enum status find(struct sph *s, struct sph_layers *g) {
  struct sites all = {.s = s, .faces = &s->faces, .g = g};
  all.layers = (size_t)ceil(s->support / s->dx - 1e-9);
  g->n_sites = 0;
  if (s->tank.periodic[1]) return OK;
  for (int upright = 1; upright >= 0; upright--)
    for (uint32_t k = 0; k < s->faces.n; k++)
      if (g->division[k].upright == upright) TRY(add_strip(&all, k));
  for (uint32_t k = 0; k < s->faces.n; k++) TRY(add_corner(&all, k));
  return OK;
}

static void free_particles(struct sph *s, struct sph_layers *g) {
  double **const numbers[] = {&s->w.x, &s->w.y, &g->sx, &g->sy, &g->x, &g->y, &g->V, &g->slide};
  uint32_t **const others[] = {&s->w.chain, &g->key, &g->order, &g->motion};
  for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++) {
    free(*numbers[k]);
    *numbers[k] = NULL;
  }
  for (size_t k = 0; k < sizeof others / sizeof *others; k++) {
    free(*others[k]);
    *others[k] = NULL;
  }
}

static enum status make_room(struct sph *s, size_t n, struct sph_layers *g) {
  if (g->x && n == g->n) return OK;
  free_particles(s, g);
  g->n = s->w.n = n;
  g->room = (n + SPH_LANES - 1) / SPH_LANES * SPH_LANES;
  TRY(sph_allocate(n, sizeof(double), &s->w.x));
  TRY(sph_allocate(n, sizeof(double), &s->w.y));
  TRY(sph_allocate(n, sizeof *s->w.chain, &s->w.chain));
  TRY(sph_allocate(n, sizeof *g->sx, &g->sx));
  TRY(sph_allocate(n, sizeof *g->sy, &g->sy));
  TRY(sph_allocate(n, sizeof *g->key, &g->key));
  TRY(sph_allocate(n, sizeof *g->order, &g->order));
  TRY(sph_allocate(g->room, sizeof(double), &g->x));
  TRY(sph_allocate(g->room, sizeof(double), &g->y));
  TRY(sph_allocate(g->room, sizeof *g->motion, &g->motion));
  TRY(sph_allocate(g->room, sizeof(double), &g->slide));
  return sph_allocate(g->room, sizeof(double), &g->V);
}

static void place(struct sph *s, size_t i, const struct sph_site *site, struct sph_layers *g) {
  g->x[i] = site->node[0];
  g->y[i] = site->node[1];
  g->motion[i] = site->motion;
  g->V[i] = site->V;
  g->slide[i] = site->slide;
  if (i >= g->n) return;
  s->w.x[i] = site->x;
  s->w.y[i] = site->y;
  s->w.chain[i] = site->chain;
}

static void place_all(struct sph *s, struct sph_layers *g) {
  for (size_t i = 0; i < g->room; i++) place(s, i, &g->site[g->order[i < g->n ? i : g->n - 1]], g);
  for (size_t k = 0; k < s->faces.n; k++) {
    const struct face *f = &s->faces.face[k];
    g->turn[2 * k] = rigid_mirror(f->a, f->b);
    g->turn[2 * k + 1] = rigid_half_turn(f->a);
  }
}

static enum status find_and_sort(struct sph *s, struct sph_layers *g, bool anew) {
  divide(s, g, anew);
  TRY(find(s, g));
  TRY(make_room(s, g->n_sites, g));
  for (size_t i = 0; i < g->n; i++) {
    g->sx[i] = g->site[i].x;
    g->sy[i] = g->site[i].y;
  }
  sph_grid_sort(&s->w.grid, g->n, g->sx, g->sy, NULL, g->key, g->order);
  place_all(s, g);
  return OK;
}

enum status sph_layers_create(struct sph *s, struct sph_layers *g) {
  const struct geo_box box = tank_around(&s->tank, s->support + s->dx);
  TRY(sph_allocate(s->faces.n, sizeof *g->division, &g->division));
  TRY(sph_allocate(2 * s->faces.n, sizeof *g->turn, &g->turn));
  TRY(sph_grid_create(&s->w.grid, &box, s->dx));
  return find_and_sort(s, g, true);
}

enum status sph_layers_sort(struct sph *s, struct sph_layers *g) {
  return find_and_sort(s, g, false);
}

/* There is room for what has been found before. */
void sph_layers_move(struct sph *s, struct sph_layers *g) {
  if (find(s, g) == OK) place_all(s, g);
}

void sph_layers_destroy(struct sph_layers *g) {
  free(g->x);
  free(g->y);
  free(g->motion);
  free(g->turn);
  free(g->V);
  free(g->slide);
  free(g->division);
  free(g->site);
  free(g->order);
  free(g->sx);
  free(g->sy);
  free(g->key);
}

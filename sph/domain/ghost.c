/* Fixed ghost particles with free slip (Marrone, Antuono, Colagrossi, Colicchio, Le Touze &
 * Graziani, Comput. Methods Appl. Mech. Engrg. 200, 2011), for a tank with upright sides and a flat
 * bed.
 *
 * Ghosts fill the walls to the depth of the support on a fixed lattice. Each has an interpolation
 * node, its mirror image in the wall (in a corner: mirrored in both walls, which is through the
 * corner point). At the node, p and u are fitted to the water by moving least squares (mls.h), and
 * the ghost takes u_g = u* with the normal component reversed, the tangential one kept; p_g = p* +
 * rho* f . (r_g - r*): at a fixed flat wall dp/dn = rho f.n, and r_g - r* points along the normal,
 * so below the bed at depth d the ghost gets 2 d rho g more than its node, and beside an upright
 * wall the same.
 *
 * Ghosts take part in everything: divergence, pressure force, viscosity, diffusion and the
 * renormalised gradient. In still water the density is linear in y; the ghosts' values then
 * continue it linearly through the wall, so that Antuono's psi vanishes in every pair and the
 * renormalised gradient is exact up to the wall: the hydrostatic solution is kept. For this the
 * ghosts also need a gradient: that of the fit, whose excess over the hydrostatic one is reflected
 * like a velocity. A ghost whose node is far from water is dry; no water is then near the ghost
 * either.
 *
 * Fitted values do a little work on the water, which falls with the spacing where the flow is
 * smooth. Noisy flow without viscosity and diffusion needs mirror.c. */
#include "sph/domain/wall.h"

#include <math.h>
#include <stdlib.h>

#include "sph/domain/mls.h"
#include "sph/pair/forms.h"

/* Nodes in the water are at least half a spacing inside it: d^2 < 1.15 (mls.h). Nodes in the air
 * see it from afar; without a limit the ghosts of noisy sheets on a wall amplify the noise and pump
 * energy into them (without diffusion and alpha = 0.01 the run-up explodes). */
static const double farthest2 = 1.2;

struct ghosts {
  size_t room;
  double *x, *y;          /* interpolation nodes, m, [n] padded to whole clusters */
  double *rx, *ry;        /* sign of the velocity components after reflection, [n] padded */
  struct sph_lists lists; /* water near the nodes */
};

/* A strip of ghosts: columns along one direction at `first + i step`, rows along the other. */
struct strip {
  double x, dx, y, dy; /* first position and step */
  size_t nx, ny;
  bool mirror_x, mirror_y;
  double wall_x, wall_y;
};

/* Left, right, bed, and the two corners under them. Along a wall the spacing is stretched so that
 * it divides the wall evenly. */
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

static enum status ghosts_create(struct sph *s, const struct geo_lines *walls) {
  (void)walls;
  struct strip strips[5];
  size_t n_strips = strips_of(s, strips), n = 0;
  for (size_t k = 0; k < n_strips; k++) n += strips[k].nx * strips[k].ny;
  struct ghosts *g;
  TRY(sph_allocate(1, sizeof *g, &g));
  s->w.data = g;
  s->w.n = n;
  g->room = (n + SPH_LANES - 1) / SPH_LANES * SPH_LANES;
  double *x = NULL, *y = NULL;
  uint32_t *key = NULL, *order = NULL;
  size_t *strip_of = NULL;
  enum status status = OK;
  ATTEMPT(sph_allocate(n, sizeof *x, &x));
  ATTEMPT(sph_allocate(n, sizeof *y, &y));
  ATTEMPT(sph_allocate(n, sizeof *key, &key));
  ATTEMPT(sph_allocate(n, sizeof *order, &order));
  ATTEMPT(sph_allocate(n, sizeof *strip_of, &strip_of));
  ATTEMPT(sph_allocate(n, sizeof(double), &s->w.x));
  ATTEMPT(sph_allocate(n, sizeof(double), &s->w.y));
  ATTEMPT(sph_allocate(n, sizeof *s->w.pack, &s->w.pack));
  ATTEMPT(sph_allocate(n, sizeof *s->w.G, &s->w.G));
  ATTEMPT(sph_allocate(g->room, sizeof(double), &g->x));
  ATTEMPT(sph_allocate(g->room, sizeof(double), &g->y));
  ATTEMPT(sph_allocate(g->room, sizeof(double), &g->rx));
  ATTEMPT(sph_allocate(g->room, sizeof(double), &g->ry));

  size_t at = 0;
  for (size_t k = 0; k < n_strips; k++)
    for (size_t i = 0; i < strips[k].nx; i++)
      for (size_t j = 0; j < strips[k].ny; j++, at++) {
        x[at] = strips[k].x + (double)i * strips[k].dx;
        y[at] = strips[k].y + (double)j * strips[k].dy;
        strip_of[at] = k;
      }
  double reach = s->support + s->dx;
  struct geo_box box = tank_around(&s->tank, reach);
  ATTEMPT(sph_grid_create(&s->w.grid, &box, s->dx));
  sph_grid_sort(&s->w.grid, n, x, y, NULL, key, order);
  for (size_t i = 0; i < g->room; i++) {
    size_t o = order[i < n ? i : n - 1];
    const struct strip *t = &strips[strip_of[o]];
    g->x[i] = t->mirror_x ? 2 * t->wall_x - x[o] : x[o];
    g->y[i] = t->mirror_y ? 2 * t->wall_y - y[o] : y[o];
    g->rx[i] = t->mirror_x ? -1 : 1;
    g->ry[i] = t->mirror_y ? -1 : 1;
    if (i >= n) continue;
    s->w.x[i] = x[o];
    s->w.y[i] = y[o];
    s->w.pack[i] =
        (struct sph_pack){.x = x[o], .y = y[o], .V = fabs(t->dx * t->dy), .rho = s->rho0};
  }
done:
  free(x);
  free(y);
  free(key);
  free(order);
  free(strip_of);
  return status;
}

static enum status ghosts_list(struct sph *s) {
  struct ghosts *g = s->w.data;
  const struct sph_sources water = sph_sources_of_water(s);
  return sph_lists_build(&g->lists, s->w.n, g->x, g->y, &water, s->support + s->wall_skin);
}

static void fill_cluster(struct sph *s, size_t cluster) {
  const struct ghosts *g = s->w.data;
  const struct sph_near near = sph_near_of(&g->lists, cluster, s->pack);
  if (!near.n) return; /* no water near: nobody reads these ghosts */
  const size_t at = cluster * SPH_LANES;
  struct sph_targets i = {0};
  for (size_t l = 0; l < SPH_LANES; l++) {
    i.x[l] = g->x[at + l];
    i.y[l] = g->y[at + l];
  }
  struct sph_mls f;
  sph_mls_at(s, sph_loops_of(&s->scheme), farthest2 * s->scale.inside, &i, &near, &f);
  for (size_t l = 0; l < SPH_LANES && at + l < s->w.n; l++) {
    const double rx = g->rx[at + l], ry = g->ry[at + l];
    const double gravity = -sph_weight(s, eos_stored(&s->eos, f.p[l], i.y[l]), i.y[l]);
    struct sph_pack *w = &s->w.pack[at + l];
    w->u = rx * f.u[l];
    w->v = ry * f.v[l];
    w->p = f.p[l] + gravity * (w->y - i.y[l]);
    w->rho = eos_stored(&s->eos, w->p, w->y);
    s->w.G[at + l] = (struct sph_vector){rx * f.px[l], gravity + ry * (f.py[l] - gravity)};
  }
}

static void ghosts_fill(struct sph *s) {
  const struct ghosts *g = s->w.data;
#pragma omp parallel for schedule(dynamic, 16)
  for (size_t c = 0; c < g->lists.n_clusters; c++) fill_cluster(s, c);
}

static void ghosts_destroy(struct sph *s) {
  struct ghosts *g = s->w.data;
  if (!g) return;
  free(g->x);
  free(g->y);
  free(g->rx);
  free(g->ry);
  sph_lists_destroy(&g->lists);
  free(g);
}

const struct sph_wall sph_wall_ghost = {
    .create = ghosts_create,
    .list = ghosts_list,
    .fill = ghosts_fill,
    .layer = 2,
    .destroy = ghosts_destroy,
};

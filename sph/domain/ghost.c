/* Ghost particles fixed to the walls (Marrone, Antuono, Colagrossi, Colicchio, Le Touze &
 * Graziani, Comput. Methods Appl. Mech. Engrg. 200, 2011), behind straight walls of any direction.
 *
 * Ghosts fill the walls to the depth of the support on a fixed lattice. Each has an interpolation
 * node, its mirror image in the wall (in a corner: mirrored in both walls, which is through the
 * corner point). At the node, p and u are fitted to the water by moving least squares (mls.h), and
 * the ghost takes u_g = u* with the normal component reversed, the tangential one kept (but for
 * corners of the solid, layers.h); p_g = p* +
 * rho* f . (r_g - r*): at a fixed flat wall dp/dn = rho f.n, and r_g - r* points along the normal,
 * so below a level bed at depth d the ghost gets 2 d rho g more than its node, and beside an
 * upright wall the same. What walls that move add to either is in sides.h.
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

#include "sph/domain/layers.h"
#include "sph/domain/mls.h"
#include "sph/pair/forms.h"

/* Nodes in the water are at least half a spacing inside it: d^2 < 1.15 (mls.h). Nodes in the air
 * see it from afar; without a limit the ghosts of noisy sheets on a wall amplify the noise and pump
 * energy into them (without diffusion and alpha = 0.01 the run-up explodes). */
static const double farthest2 = 1.2;

/* Water as fast as that, over c0, slides past corners of the solid (layers.h). */
static const double passing = 0.02;

struct ghosts {
  struct sph_layers layers;
  struct sph_lists lists; /* water near the nodes, which are the mirror points */
};

static enum status make_packs(struct sph *s) {
  const struct ghosts *g = s->w.data;
  TRY(sph_wall_make_packs(s, s->w.n));
  for (size_t i = 0; i < s->w.n; i++)
    s->w.pack[i] =
        (struct sph_pack){.x = s->w.x[i], .y = s->w.y[i], .V = g->layers.V[i], .rho = s->rho0};
  return OK;
}

static enum status ghosts_create(struct sph *s, const struct geo_lines *walls) {
  (void)walls;
  struct ghosts *g;
  TRY(sph_allocate(1, sizeof *g, &g));
  s->w.data = g;
  TRY(sph_layers_create(s, &g->layers));
  return make_packs(s);
}

static void ghosts_move(struct sph *s) {
  struct ghosts *g = s->w.data;
  sph_layers_move(s, &g->layers);
  for (size_t i = 0; i < s->w.n; i++) {
    s->w.pack[i].x = s->w.x[i];
    s->w.pack[i].y = s->w.y[i];
    s->w.pack[i].V = g->layers.V[i];
  }
}

static enum status ghosts_list(struct sph *s) {
  struct ghosts *g = s->w.data;
  if (s->sides.move) {
    TRY(sph_layers_sort(s, &g->layers));
    TRY(make_packs(s));
  }
  const struct sph_sources water = sph_sources_of_water(s);
  return sph_lists_build(&g->lists, s->w.n, g->layers.x, g->layers.y, &water,
                         s->support + s->wall_skin);
}

static enum status ghosts_look(struct sph *s) {
  struct ghosts *g = s->w.data;
  const struct sph_sources water = sph_sources_of_water(s);
  return sph_sight_mark(&s->sight, &g->lists, s->w.n, g->layers.x, g->layers.y, &water, NULL,
                        s->support);
}

/* The velocity u, v at the mirror point, turned; of what is along the face, half of the sum of a
 * vector and its mirror image, slow water is given as much as `slide`. */
static void set_velocity(const struct sph *s, struct sph_pack *w, const struct rigid *turn,
                         double u, double v, double slide) {
  rigid_turn(turn, u, v, &w->u, &w->v);
  if (slide == 1) return;
  const double passes = fmin(hypot(u, v) / (passing * s->c0), 1);
  const double lost = (1 - slide) * (1 - passes) / 2, x = u + w->u, y = v + w->v;
  w->u -= lost * x;
  w->v -= lost * y;
}

static void fill_cluster(struct sph *s, size_t cluster) {
  const struct ghosts *g = s->w.data;
  const struct sph_layers *node = &g->layers;
  const struct sph_near near = sph_near_of(&g->lists, cluster, s->pack);
  if (!near.n) return; /* no water near: nobody reads these ghosts */
  const size_t at = cluster * SPH_LANES;
  struct sph_targets i = {0};
  for (size_t l = 0; l < SPH_LANES; l++) {
    i.x[l] = node->x[at + l];
    i.y[l] = node->y[at + l];
  }
  struct sph_mls f;
  sph_mls_at(s, sph_loops_for(s, &i), farthest2 * s->scale.inside, &i, &near, &f);
  for (size_t l = 0; l < SPH_LANES && at + l < s->w.n; l++) {
    const struct rigid *turn = &node->turn[node->motion[at + l]];
    const struct sph_drive drive =
        sph_wall_drive(s, node->motion[at + l], i.x[l], i.y[l], f.u[l], f.v[l]);
    const struct sph_vector weight =
        sph_weight(s, eos_stored(&s->eos, f.p[l], i.y[l]), i.x[l], i.y[l], f.u[l], f.v[l], drive.A);
    struct sph_pack *w = &s->w.pack[at + l];
    set_velocity(s, w, turn, f.u[l], f.v[l], node->slide[at + l]);
    w->p = f.p[l] + weight.x * (w->x - i.x[l]) + weight.y * (w->y - i.y[l]);
    w->rho = eos_stored(&s->eos, w->p, w->y);
    sph_wall_hold(s, at + l, f.u[l], f.v[l], &drive);
    struct sph_vector *G = &s->w.G[at + l];
    rigid_turn(turn, f.px[l] - weight.x, f.py[l] - weight.y, &G->x, &G->y);
    G->x += weight.x;
    G->y += weight.y;
  }
}

static void ghosts_fill(struct sph *s) {
  const struct ghosts *g = s->w.data;
#pragma omp parallel for schedule(dynamic, 16)
  for (size_t c = 0; c < g->lists.n_clusters; c++) fill_cluster(s, c);
}

static uint32_t ghosts_motion(const struct sph *s, size_t k) {
  const struct ghosts *g = s->w.data;
  return g->layers.motion[k];
}

static void ghosts_destroy(struct sph *s) {
  struct ghosts *g = s->w.data;
  if (!g) return;
  sph_layers_destroy(&g->layers);
  sph_lists_destroy(&g->lists);
  free(g);
}

const struct sph_wall sph_wall_ghost = {
    .create = ghosts_create,
    .list = ghosts_list,
    .look = ghosts_look,
    .move = ghosts_move,
    .fill = ghosts_fill,
    .layer = 2,
    .motion = ghosts_motion,
    .destroy = ghosts_destroy,
};

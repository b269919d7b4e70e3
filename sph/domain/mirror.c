/* Moving mirror images with free slip (Colagrossi & Landrini, J. Comput. Phys. 191, 2003), for a
 * tank with upright sides and a flat bed.
 *
 * Every particle of water j near a wall has an image there (images.h), with its volume, its
 * velocity with the normal component reversed, and p_j' = p_j + rho_j f . (r_j' - r_j): beside an
 * upright wall the same pressure, below the bed 2 d rho g more. In a corner there is a third image,
 * mirrored in both walls. In still water the images continue the linear pressure through the wall,
 * and its renormalised gradient, whose excess over the hydrostatic one is reflected like a
 * velocity, as the fixed ghosts do (ghost.c).
 *
 * Upright walls do no work, whatever the noise. Particle i meets the image j' exactly when j meets
 * i', and the way from j to i' is the way from i to j' mirrored and turned round: with R the
 * reflection of vectors, in a corner the half turn, grad_j W_ji' = -R grad_i W_ij'. The power that
 * the two take out (rates.c),
 *
 *   V_i V_j ((p_j u_i + p_i R u_j) . grad_i W_ij' + (p_i u_j + p_j R u_i) . grad_j W_ji') = 0,
 *
 * vanishes term by term. At the bed only the work of the hydrostatic part is left. Values fitted to
 * the water (ghost.c) lack this symmetry between the velocity in the continuity equation and the
 * pressure in the momentum equation: where nothing damps the noise, without viscosity and
 * diffusion, ghosts pump energy into the noisy sheets on a wall, several times what the dam break
 * began with.
 *
 * The price: the first impact of a thin tip on a wall is harder than with ghosts, perhaps because
 * it meets its own thin image only. It sends out stronger sound, and diffusion takes more energy
 * out: with Antuono's, at H/dx = 50, 0.9 % of the whole in place of 0.2 %. */
#include "sph/domain/wall.h"

#include <stdlib.h>

#include "sph/domain/copies.h"
#include "sph/pair/forms.h"

struct mirror {
  struct sph_images images;
  struct sph_copies copies; /* of the water and its images beyond a periodic tank's ends, by the
                               numbers that lists of water have for them */
  size_t room;              /* of s->w.pack */
};

static enum status mirror_create(struct sph *s, const struct geo_lines *walls) {
  struct mirror *m;
  TRY(sph_allocate(1, sizeof *m, &m));
  s->w.data = m;
  TRY(sph_images_set_walls(&m->images, walls));
  double reach = s->support + s->wall_skin;
  struct geo_box box = tank_around(&s->tank, reach);
  return sph_grid_create(&s->w.grid, &box, s->dx);
}

static enum status add_images(struct mirror *m, size_t of, double x, double y) {
  const size_t n = sph_images_of(&m->images, x, y);
  return n ? sph_copies_add(&m->copies, (uint32_t)of, n, m->images.found) : OK;
}

static enum status make_room(struct sph *s) {
  struct mirror *m = s->w.data;
  if (m->copies.n <= m->room) return OK;
  m->room = m->copies.n + m->copies.n / 2;
  free(s->w.pack);
  free(s->w.G);
  s->w.pack = NULL;
  s->w.G = NULL;
  TRY(sph_allocate(m->room, sizeof *s->w.G, &s->w.G));
  return sph_allocate(m->room, sizeof *s->w.pack, &s->w.pack);
}

/* A pair of water and image is at most the support apart, so that either is at most that far from
 * the wall when the other is inside it; the skin covers the ways until the next lists, through the
 * wall and along it, such as below the top of a side. */
static enum status mirror_list(struct sph *s) {
  struct mirror *m = s->w.data;
  const struct sph_copies *beyond = &s->period.copies;
  sph_images_set_reach(&m->images, s->support + s->wall_skin, s->wall_skin);
  for (size_t i = 0; i < s->f.n; i++) TRY(add_images(m, i, s->f.w.x[i], s->f.w.y[i]));
  for (size_t k = 0; k < beyond->n; k++)
    TRY(add_images(m, s->f.room + k, beyond->x[k], beyond->y[k]));
  TRY(sph_copies_sort(&m->copies, &s->w.grid));
  s->w.n = m->copies.n;
  s->w.x = m->copies.x;
  s->w.y = m->copies.y;
  return make_room(s);
}

/* Water above the top of a side wall has no image in it; water that has passed over has none. */
static bool has_image(const struct sph *s, const struct sph_images *t, const struct sph_copy *a) {
  const struct sph_pack *j = &s->pack[a->of];
  return s->f.over[sph_period_particle(s, a->of)] == 0 &&
         sph_images_counts(t, a->motion, j->x, j->y);
}

static void mirror_fill(struct sph *s) {
  const struct mirror *m = s->w.data;
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < s->w.n; k++) {
    const struct sph_copy *a = &m->copies.copy[k];
    const struct sph_motion *motion = sph_images_motion(&m->images, a->motion);
    const struct sph_pack *j = &s->pack[a->of];
    double x, y, u, v;
    sph_motion_turn(motion, j->x, j->y, &x, &y);
    sph_motion_turn(motion, j->u, j->v, &u, &v);
    x += motion->at[0];
    y += motion->at[1];
    const double p = j->p + sph_weight(s, j->rho, j->y) * (j->y - y);
    s->w.pack[k] = (struct sph_pack){.x = x,
                                     .y = y,
                                     .u = u,
                                     .v = v,
                                     .p = p,
                                     .V = has_image(s, &m->images, a) ? j->V : 0,
                                     .rho = eos_stored(&s->eos, p, y)};
  }
}

static void mirror_fill_gradients(struct sph *s) {
  const struct mirror *m = s->w.data;
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < s->w.n; k++) {
    const struct sph_copy *a = &m->copies.copy[k];
    const struct sph_vector *G = &s->G[a->of];
    struct sph_vector *w = &s->w.G[k];
    const double weight = -sph_weight(s, s->pack[a->of].rho, s->pack[a->of].y);
    sph_motion_turn(sph_images_motion(&m->images, a->motion), G->x, G->y - weight, &w->x, &w->y);
    w->y += weight;
  }
}

static void mirror_destroy(struct sph *s) {
  if (!s->w.data) return;
  struct mirror *m = s->w.data;
  sph_copies_destroy(&m->copies);
  s->w.x = s->w.y = NULL; /* were theirs */
  sph_images_destroy(&m->images);
  free(m);
}

const struct sph_wall sph_wall_mirror = {
    .create = mirror_create,
    .list = mirror_list,
    .fill = mirror_fill,
    .fill_gradients = mirror_fill_gradients,
    .destroy = mirror_destroy,
    .moving = true,
};

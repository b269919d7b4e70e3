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

#include "sph/domain/images.h"
#include "sph/pair/eos.h"

struct image {
  uint32_t of, motion; /* particle of water; sph_images_motion */
};

struct mirror {
  struct sph_images images;
  size_t room;
  struct image *image;   /* [w.n], in the order of s->w, owned */
  struct image *found;   /* [w.n], in that of the water; scratch, owned */
  double *x, *y;         /* m, [w.n], of `found`; scratch, owned */
  uint32_t *key, *order; /* [w.n], scratch, owned */
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

static void free_arrays(struct sph *s) {
  struct mirror *m = s->w.data;
  free(m->image);
  free(m->found);
  free(m->x);
  free(m->y);
  free(m->key);
  free(m->order);
  free(s->w.x);
  free(s->w.y);
  free(s->w.pack);
  free(s->w.G);
  *m = (struct mirror){.images = m->images};
  s->w.x = s->w.y = NULL;
  s->w.pack = NULL;
  s->w.G = NULL;
}

static enum status make_room(struct sph *s, size_t n) {
  struct mirror *m = s->w.data;
  if (n <= m->room) return OK;
  n += n / 2;
  free_arrays(s);
  TRY(sph_allocate(n, sizeof *m->image, &m->image));
  TRY(sph_allocate(n, sizeof *m->found, &m->found));
  TRY(sph_allocate(n, sizeof *m->x, &m->x));
  TRY(sph_allocate(n, sizeof *m->y, &m->y));
  TRY(sph_allocate(n, sizeof *m->key, &m->key));
  TRY(sph_allocate(n, sizeof *m->order, &m->order));
  TRY(sph_allocate(n, sizeof *s->w.x, &s->w.x));
  TRY(sph_allocate(n, sizeof *s->w.y, &s->w.y));
  TRY(sph_allocate(n, sizeof *s->w.pack, &s->w.pack));
  TRY(sph_allocate(n, sizeof *s->w.G, &s->w.G));
  m->room = n;
  return OK;
}

/* Every image of the water, into m->found, m->x and m->y, for which there is room. */
static void find_images(struct mirror *m, const struct sph *s) {
  size_t at = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    size_t k = sph_images_of(&m->images, s->f.w.x[i], s->f.w.y[i]);
    for (size_t l = 0; l < k; l++, at++) {
      const struct sph_image *image = &m->images.found[l];
      m->found[at] = (struct image){(uint32_t)i, image->motion};
      m->x[at] = image->x;
      m->y[at] = image->y;
    }
  }
}

/* A pair of water and image is at most the support apart, so that either is at most that far from
 * the wall when the other is inside it; the skin covers the ways until the next lists, through the
 * wall and along it, such as below the top of a side. */
static enum status mirror_list(struct sph *s) {
  struct mirror *m = s->w.data;
  size_t n = 0;
  sph_images_set_reach(&m->images, s->support + s->wall_skin, s->wall_skin);
  for (size_t i = 0; i < s->f.n; i++) n += sph_images_of(&m->images, s->f.w.x[i], s->f.w.y[i]);
  TRY(make_room(s, n));
  find_images(m, s);
  s->w.n = sph_grid_sort(&s->w.grid, n, m->x, m->y, NULL, m->key, m->order);
  for (size_t k = 0; k < n; k++) {
    m->image[k] = m->found[m->order[k]];
    s->w.x[k] = m->x[m->order[k]];
    s->w.y[k] = m->y[m->order[k]];
  }
  return OK;
}

/* Water above the top of a side wall has no image in it; water that has passed over has none. */
static bool has_image(const struct sph *s, const struct sph_images *t, const struct image *a) {
  const struct sph_pack *j = &s->pack[a->of];
  return s->f.over[a->of] == 0 && sph_images_counts(t, a->motion, j->x, j->y);
}

static void mirror_fill(struct sph *s) {
  const struct mirror *m = s->w.data;
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < s->w.n; k++) {
    const struct image *a = &m->image[k];
    const struct sph_motion *motion = sph_images_motion(&m->images, a->motion);
    const struct sph_pack *j = &s->pack[a->of];
    double x, y, u, v;
    sph_motion_turn(motion, j->x, j->y, &x, &y);
    sph_motion_turn(motion, j->u, j->v, &u, &v);
    x += motion->at[0];
    y += motion->at[1];
    const double p = j->p + j->rho * s->g * (j->y - y);
    s->w.pack[k] =
        (struct sph_pack){.x = x,
                          .y = y,
                          .u = u,
                          .v = v,
                          .p = p,
                          .V = has_image(s, &m->images, a) ? j->V : 0,
                          .rho = eos_density((enum sph_eos)s->scheme.eos, s->rho0, s->c0, p)};
  }
}

static void mirror_fill_gradients(struct sph *s) {
  const struct mirror *m = s->w.data;
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < s->w.n; k++) {
    const struct image *a = &m->image[k];
    const struct sph_vector *G = &s->G[a->of];
    struct sph_vector *w = &s->w.G[k];
    const double weight = -s->pack[a->of].rho * s->g;
    sph_motion_turn(sph_images_motion(&m->images, a->motion), G->x, G->y - weight, &w->x, &w->y);
    w->y += weight;
  }
}

static void mirror_destroy(struct sph *s) {
  if (!s->w.data) return;
  struct mirror *m = s->w.data;
  free_arrays(s);
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

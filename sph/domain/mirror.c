/* Moving mirror images (Colagrossi & Landrini, J. Comput. Phys. 191, 2003), for a tank with upright
 * sides and a flat bed.
 *
 * Every particle of water j near a wall has an image there (images.h), with its volume and its
 * velocity with the normal component reversed: beside an upright wall with its pressure, too. In a
 * corner there is a third image, mirrored in both walls. Below the bed, at the distance d from it,
 * the pressure goes on in one of four ways:
 *
 *   mirror-plain         p_j' = p_j, with which the lowest row of still water starts to fall, until
 *                        it is near enough to its own images
 *   mirror               p_j' = p_j + 2 d rho_j g, linearly, where rho_j is rho0 in the momentum
 *                        equation `reference`: then rho' is T's (4.44), rho_j + 2 d rho0 g/c0^2
 *   mirror-reference     p_j' = p_j + 2 d rho0 g: (4.44) in any form, with which water that is
 *                        heavier at the bed than rho0 does not rest
 *   mirror-exponential   by dp/dy = -rho g and the equation of state. The same to first order in
 *                        d g/c0^2; where sound is slow, rho0 g d/c0^2 is not small, and water that
 *                        starts as rho0 exp(-g y/c0^2) rests on no other
 *
 * In still water all but the first continue the pressure through the wall, and its renormalised
 * gradient, whose excess over the hydrostatic one is reflected like a velocity, as the fixed ghosts
 * do (ghost.c); plain images reflect all of it.
 *
 * Upright walls do no work, whatever the noise. Particle i meets the image j' exactly when j meets
 * i', and the way from j to i' is the way from i to j' mirrored and turned round: with R the
 * reflection of vectors, in a corner the half turn, grad_j W_ji' = -R grad_i W_ij'. The power that
 * the two take out (rates.c),
 *
 *   V_i V_j ((p_j u_i + p_i R u_j) . grad_i W_ij' + (p_i u_j + p_j R u_i) . grad_j W_ji') = 0,
 *
 * vanishes term by term, and where the wall moves it is the work on it. At the bed only the work of
 * the hydrostatic part is left. Values fitted to
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
  struct images images;
  struct sph_copies copies; /* of the water and its images beyond a periodic tank's ends, by the
                               numbers that lists of water have for them */
  size_t room;              /* of s->w.pack */
};

static enum status mirror_create(struct sph *s, const struct geo_lines *walls) {
  struct mirror *m;
  TRY(sph_allocate(1, sizeof *m, &m));
  s->w.data = m;
  TRY(images_set_walls(&m->images, walls, 2 * s->support));
  double reach = s->support + s->wall_skin;
  struct geo_box box = tank_around(&s->tank, reach);
  return sph_grid_create(&s->w.grid, &box, s->dx);
}

static enum status add_images(struct mirror *m, size_t of, double x, double y) {
  const size_t n = images_of(&m->images, x, y);
  return n ? sph_copies_add(&m->copies, (uint32_t)of, n, m->images.found) : OK;
}

static void mirror_move(struct sph *s) {
  struct mirror *m = s->w.data;
  images_move(&m->images, &s->faces);
}

static enum status make_room(struct sph *s) {
  struct mirror *m = s->w.data;
  if (m->copies.n <= m->room) return OK;
  m->room = m->copies.n + m->copies.n / 2;
  free(s->w.chain);
  s->w.chain = NULL;
  TRY(sph_allocate(m->room, sizeof *s->w.chain, &s->w.chain));
  return sph_wall_make_packs(s, m->room);
}

/* A pair of water and image is at most the support apart, so that either is at most that far from
 * the wall when the other is inside it; the skin covers the ways until the next lists, through the
 * wall and along it, such as below the top of a side. */
static enum status mirror_list(struct sph *s) {
  struct mirror *m = s->w.data;
  const struct sph_copies *beyond = &s->period.copies;
  images_set_reach(&m->images, s->support + s->wall_skin, s->wall_skin);
  for (size_t i = 0; i < s->f.n; i++) TRY(add_images(m, i, s->f.w.x[i], s->f.w.y[i]));
  for (size_t k = 0; k < beyond->n; k++)
    TRY(add_images(m, s->f.room + k, beyond->x[k], beyond->y[k]));
  TRY(sph_copies_sort(&m->copies, &s->w.grid));
  s->w.n = m->copies.n;
  s->w.x = m->copies.x;
  s->w.y = m->copies.y;
  TRY(make_room(s));
  for (size_t k = 0; k < s->w.n; k++)
    s->w.chain[k] = m->images.faces.face[m->copies.copy[k].motion / 2].chain;
  return OK;
}

/* Water above the top of a side wall has no image in it; water that has passed over has none. */
static bool has_image(const struct sph *s, const struct images *t, const struct sph_copy *a) {
  const struct sph_pack *j = &s->pack[a->of];
  return s->f.over[sph_period_particle(s, a->of)] == 0 && images_counts(t, a->motion, j->x, j->y);
}

/* How the pressure goes on below the bed. */
enum continuation { PLAIN, LINEAR, REFERENCE, EXPONENTIAL };

static struct sph_vector weight_of(const struct sph *s, enum continuation c,
                                   const struct sph_pack *j, const struct sph_drive *d) {
  return sph_weight(s, c == REFERENCE ? s->rho0 : j->rho, j->x, j->y, j->u, j->v, d->A);
}

/* Of the image at (x, y). */
SPECIALISE double pressure_at(const struct sph *s, enum continuation c, const struct sph_pack *j,
                              const struct sph_drive *d, double x, double y) {
  switch (c) {
  case PLAIN:
    return j->p;
  case LINEAR:
  case REFERENCE: {
    const struct sph_vector weight = weight_of(s, c, j, d);
    return j->p + weight.x * (x - j->x) + weight.y * (y - j->y);
  }
  case EXPONENTIAL:
    return eos_driving_below(&s->eos, j->p, j->y - y);
  }
  __builtin_unreachable();
}

SPECIALISE void fill(struct sph *s, enum continuation c) {
  const struct mirror *m = s->w.data;
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < s->w.n; k++) {
    const struct sph_copy *a = &m->copies.copy[k];
    const struct rigid *motion = images_motion(&m->images, a->motion);
    const struct sph_pack *j = &s->pack[a->of];
    double x, y, u, v;
    rigid_turn(motion, j->x, j->y, &x, &y);
    rigid_turn(motion, j->u, j->v, &u, &v);
    x += motion->at[0];
    y += motion->at[1];
    const struct sph_drive drive = sph_wall_drive(s, a->motion, j->x, j->y, j->u, j->v);
    const double p = pressure_at(s, c, j, &drive, x, y);
    s->w.pack[k] = (struct sph_pack){.x = x,
                                     .y = y,
                                     .u = u,
                                     .v = v,
                                     .p = p,
                                     .V = has_image(s, &m->images, a) ? j->V : 0,
                                     .rho = eos_stored(&s->eos, p, y)};
    sph_wall_hold(s, k, j->u, j->v, &drive);
  }
}

/* The gradient at rest of what is reflected, and of its image, Pa/m; their excess is alike. */
SPECIALISE struct sph_vector gradient_at_rest(const struct sph *s, enum continuation c,
                                              const struct sph_pack *a, const struct sph_drive *d) {
  return c == PLAIN ? (struct sph_vector){0, 0} : weight_of(s, c, a, d);
}

SPECIALISE void fill_gradients(struct sph *s, enum continuation c) {
  const struct mirror *m = s->w.data;
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < s->w.n; k++) {
    const struct sph_copy *a = &m->copies.copy[k];
    const struct sph_vector *G = &s->G[a->of];
    struct sph_vector *w = &s->w.G[k];
    const struct sph_pack *j = &s->pack[a->of];
    const struct sph_drive drive = sph_wall_drive(s, a->motion, j->x, j->y, j->u, j->v);
    const struct sph_vector rest = gradient_at_rest(s, c, j, &drive);
    const struct sph_vector there =
        c == EXPONENTIAL ? gradient_at_rest(s, c, &s->w.pack[k], &drive) : rest;
    rigid_turn(images_motion(&m->images, a->motion), G->x - rest.x, G->y - rest.y, &w->x, &w->y);
    w->x += there.x;
    w->y += there.y;
  }
}

static uint32_t mirror_motion(const struct sph *s, size_t k) {
  const struct mirror *m = s->w.data;
  return m->copies.copy[k].motion;
}

static void mirror_destroy(struct sph *s) {
  if (!s->w.data) return;
  struct mirror *m = s->w.data;
  sph_copies_destroy(&m->copies);
  s->w.x = s->w.y = NULL; /* were theirs */
  images_destroy(&m->images);
  free(m);
}

#define MIRROR(variant, continuation)                                                              \
  static void variant##_fill(struct sph *s) {                                                      \
    fill(s, continuation);                                                                         \
  }                                                                                                \
  static void variant##_fill_gradients(struct sph *s) {                                            \
    fill_gradients(s, continuation);                                                               \
  }                                                                                                \
  const struct sph_wall sph_wall_##variant = {                                                     \
      .create = mirror_create,                                                                     \
      .list = mirror_list,                                                                         \
      .move = mirror_move,                                                                         \
      .fill = variant##_fill,                                                                      \
      .fill_gradients = variant##_fill_gradients,                                                  \
      .motion = mirror_motion,                                                                     \
      .destroy = mirror_destroy,                                                                   \
      .moving = true,                                                                              \
  };
MIRROR(mirror_plain, PLAIN)
MIRROR(mirror, LINEAR)
MIRROR(mirror_reference, REFERENCE)
MIRROR(mirror_exponential, EXPONENTIAL)

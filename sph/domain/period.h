/* Water beyond the ends of a periodic tank: its images, shifted by whole periods, which are water
 * to everyone near them. Their packs follow those of the water, from s->pack[s->f.room] on, and the
 * lists of sources hold them like any others: whoever meets sources by their packs alone needs to
 * know nothing of them. Whatever changes packs of the water fills those of the images too
 * (sph_period_fill).
 *
 * Particles come back into the tank when they are sorted. In between they go beyond its ends by the
 * `reserve` at most (sph_period_holds), so that no step, and no list, sees one jump. */
#pragma once
#include "sph/domain/copies.h"

struct sph;

struct sph_period {
  struct images images;
  struct sph_copies copies; /* of particles, in the places of the last sort */
  struct sph_grid grid;     /* of the copies */
  double reserve;           /* m */
};

/* ERR_MEMORY; ERR_INPUT as sph_grid_create. */
enum status sph_period_create(struct sph *s);
void sph_period_destroy(struct sph *s);

/* What the reserve is at most, m. */
double sph_period_widest(const struct sph *s);

/* All particles into the tank. */
void sph_period_wrap(struct sph *s);

/* Of water that has been sorted and whose drift ahead has been measured: lists the images that hold
 * for ways of at least so much (m), and makes room for their packs. ERR_MEMORY. */
enum status sph_period_list(struct sph *s, double least);

/* The images go where the water is now; their packs, and gradients s->G, become those of the water.
 */
void sph_period_move(struct sph *s);
void sph_period_fill(struct sph *s);
void sph_period_fill_gradients(struct sph *s);

/* How much farther, m, a particle may go beyond the ends than until the end of the drift's last
 * measure; infinite in a tank with walls. */
double sph_period_left(const struct sph *s);

/* The particle that the source number `of` of a list of water is, or is an image of. */
uint32_t sph_period_particle(const struct sph *s, uint32_t of);

/* The images of many points (images.h), in the order of a grid: {of whom, by which motion}. */
#pragma once
#include "common/tank/images.h"
#include "sph/fluid/neighbours.h"

struct sph_copy {
  uint32_t of, motion; /* the owner's number of the point; images_motion */
};

struct sph_copies {
  size_t n;
  struct sph_copy *copy; /* [n], owned */
  double *x, *y;         /* m, [n], where they were when they were sorted; owned */

  size_t n_found, found_room, room;
  struct sph_copy *found; /* [n_found], as they were added, owned */
  double *fx, *fy;        /* m, [n_found], owned */
  uint32_t *key, *order;  /* scratch, owned */
};

/* The images in `found` (images.h) of a point that is number `of`, added to those that are to be
 * sorted. ERR_MEMORY. */
enum status sph_copies_add(struct sph_copies *c, uint32_t of, size_t n, const struct image *found);

/* All that were added, sorted by the grid, take the place of those before. ERR_MEMORY. */
enum status sph_copies_sort(struct sph_copies *c, struct sph_grid *grid);
void sph_copies_destroy(struct sph_copies *c);

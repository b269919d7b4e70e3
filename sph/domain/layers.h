/* Fixed wall particles: a lattice that fills the walls of a tank with upright sides and a flat bed
 * to the depth of the support, its first layer half a spacing behind them. Along a wall the spacing
 * is stretched so that it divides the wall evenly. */
#pragma once
#include <stddef.h>

#include "common/base/status.h"
#include "sph/sph.h"

/* The particles in the order of the grid; arrays but those of the wall are [room], padded with the
 * last one. */
struct sph_layers {
  size_t n, room;
  double *x, *y;   /* mirror point in the wall, in a corner through it, m */
  double *rx, *ry; /* sign of the velocity components after reflection */
  double *V;       /* m^2 */
};

/* Makes s->w.grid, .n, .x and .y, too. ERR_MEMORY; ERR_INPUT as sph_grid_create. */
enum status sph_layers_create(struct sph *s, struct sph_layers *g);
void sph_layers_destroy(struct sph_layers *g);

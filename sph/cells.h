/* A polygon divided into the cells of particles: its area and its first moments are kept exactly.
 *
 * A lattice of about dx is laid over the bounding box, stretched so that it divides the box evenly.
 * Each cell is clipped by the polygon; what remains of it, if that is at least half a cell, is a
 * particle at its centroid. A smaller remainder joins the neighbour across its longest side, so
 * that no particle is lighter than half the others (a light one between heavy ones would be thrown
 * about by them). A rectangle keeps the bare lattice, to the last bit.
 */
#pragma once
#include "common/geometry.h"

struct sph_cell {
  double x, y; /* centroid, m */
  double area; /* m^2 */
};

/* The cells of the only piece of `region`; *cells is the caller's to free. ERR_MEMORY. */
enum status sph_cells_create(const struct geo_lines *region, double dx, size_t *n,
                             struct sph_cell **cells);

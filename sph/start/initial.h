/* The water at t = 0. */
#pragma once
#include "common/case/case.h"
#include "sph/sph.h"

/* Fills s->f: positions, velocities, densities, masses.
 *
 * Each region is divided into cells (cells.h): its area is kept exactly whatever its shape, and a
 * rectangle gets an even lattice, half a spacing inside. A wave is filled column by column, each
 * stretched to the elevation, so that the surface is followed to a fraction of dx.
 *
 * Hydrostatic pressure counts from the surface that stands above each point, regions that touch
 * being one water; where the water below the point ends above the bed, it falls free and has none.
 * Released pressure is released.h's: the Fourier series for one column at a wall, the sparse solve
 * for everything else.
 *
 * The density follows from the pressure; the mass is the density times the cell, so that m/rho is
 * the cell exactly and the sums over neighbours start from an even lattice (equal masses would put
 * the compression of still water, g H / c0^2, into the volumes and set the water ringing). */
enum status sph_initial_fill(struct sph *s, const struct case_file *c);

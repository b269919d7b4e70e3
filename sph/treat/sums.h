/* Sums over neighbours that treatments take means and fits from. */
#pragma once
#include "sph/pair/loops.h"

enum sph_treat_sources { SPH_TREAT_WATER = 1, SPH_TREAT_WALLS = 2 };

/* The fit's sums (loops.h) around the particles of a cluster, of pressures and velocities
 * themselves, Pa and m/s; lengths in h. */
struct sph_fit_sums sph_treat_sums(const struct sph *s, size_t cluster, unsigned sources);

/* Puts densities where pressures stand in what the loops read of water and walls, so that sums of
 * pressures are those of densities, kg m^-3. */
void sph_treat_carry_density(struct sph *s);

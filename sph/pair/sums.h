/* Sums over neighbours that means and fits are taken from: those of the fit's loops (loops.h) with
 * fields in SI, and over water and walls alike. */
#pragma once
#include "sph/pair/loops.h"

/* Adds those of one kind of neighbours around the targets, by one of the loops `fit`: of pressures
 * and velocities less those of the targets themselves, or as they are; Pa and m/s, lengths in h.
 * speed2 is not summed. */
typedef void sph_fit_loop(const struct sph *s, const struct sph_targets *i,
                          const struct sph_near *near, struct sph_fit_sums *sums);
void sph_sums_add(const struct sph *s, sph_fit_loop *fit, bool from_targets,
                  const struct sph_targets *i, const struct sph_near *near,
                  struct sph_fit_sums *sums);

enum sph_sums_of { SPH_OF_WATER = 1, SPH_OF_WALLS = 2 };

/* Around the particles of a cluster, weighted with the kernel, of fields as they are. */
struct sph_fit_sums sph_sums_around(const struct sph *s, size_t cluster, unsigned of);

/* Puts densities where pressures stand in what the loops read of water and walls, so that sums of
 * pressures are those of densities, kg m^-3. */
void sph_sums_carry_density(struct sph *s);

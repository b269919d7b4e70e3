/* What is asked of the free surface: nothing, since the pair sums impose a pressure there by
 * themselves, or that p = 0 on the particles of the first row (thesis, 2.6.5 and 4.2.3). */
#pragma once
#include <stddef.h>

#include "sph/family.h"

#define SPH_FREE_SURFACES(X, ...)                                                                  \
  X(natural, "what the sums over pairs impose by themselves", ##__VA_ARGS__)                       \
  X(fitted,                                                                                        \
    "a first row of particles on the surface, which keep p = 0 (thesis, 2.6.5, 4.2.3): waves "     \
    "that do not break",                                                                           \
    ##__VA_ARGS__)                                                                                 \
  X(level,                                                                                         \
    "the same row on the surface, of which nothing is asked: what fitted adds is seen beside it",  \
    ##__VA_ARGS__)
SPH_FAMILY(sph_free_surface, SPH_FREE_SURFACE, SPH_FREE_SURFACES);

struct sph;

/* Densities of the first row, so that there is no pressure; nothing without one. */
void sph_fitted_set(struct sph *s);

/* Rates of the densities of a cluster's particles that are in it, so that there is none later. */
void sph_fitted_rates(struct sph *s, int stage, size_t cluster);

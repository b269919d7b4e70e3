/* What was found with P's kernel, the renormalised Gaussian on a lattice with h/dx = 4/3, carried
 * over to another kernel, h/dx or derivative by what the two do on a lattice: all are 1 for P's. */
#pragma once
#include "sph/scheme.h"

struct sph_scale {
  /* c0 dt/h of the bounds (27) and (29): the largest frequency of sound and the largest decay rate
   * by the diffusion are those of P's kernel over these. */
  double acoustic, diffusive;
  double spread;       /* variance of a particle's neighbours, over h^2 */
  double inside, wall; /* sph_lattice_corner half a spacing inside that of a tank, and in it */
};

struct sph_scale sph_scale_of(const struct sph_scheme *o);

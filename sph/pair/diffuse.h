/* The diffusive term of the continuity equation by itself, P eq. (5). */
#pragma once
#include "sph/sph.h"

/* delta h c0 D_i of the packed water into D [f.room], kg m^-3 s^-1, where walls take no part and no
 * gradient is needed (diffusion.h). Returns a bound on the decay rate of any density field while
 * positions and volumes stay as they are, 1/s. */
double sph_diffuse(struct sph *s, double *D);

/* Densities that are sums over neighbours (thesis, eqs. (2.16), (3.18)): a walk of its own over the
 * lists, before that of the rates. */
#pragma once
#include "sph/sph.h"

/* Puts sum m_j W_ij, or Shepard's quotient of it, in place of the evolving density, of the packed
 * water with wall particles filled; both are to be packed and filled again. */
void sph_density_sum(struct sph *s);

/* The renormalised pressure gradient of Antuono's diffusive term (P eq. (9), after Randles &
 * Libersky). */
#pragma once
#include "sph/sph.h"

/* G_i = L_i sum_j (p_j - p_i) grad_i W V_j with L_i^-1 = sum_j (r_j - r_i) (x) grad_i W V_j, into
 * s->G; neighbours include wall particles. Exact for a linear pressure.
 *
 * Where neighbours are too few to tell a direction (the smallest eigenvalue of L^-1 falls below
 * 0.1; it is 1 inside the water and about 0.5 at a flat surface), L^-1 is shifted so that it does
 * not: G fades out continuously, and the term becomes Molteni's there. */
void sph_gradient(struct sph *s);

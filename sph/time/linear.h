/* The linear test problem of an integrator: a plane wave of small amplitude, whose state w is (x,
 * y, u, v, rho), the displacements first, and
 *
 *   dw/dt = K w,  and rho' = ... - rate rho by diffusion
 *
 * One step takes w to G w; a wave is amplified where an eigenvalue of G is beyond the unit circle.
 */
#pragma once
#include <complex.h>

#include "sph/time/integrator.h"

enum { SPH_LINEAR_X, SPH_LINEAR_Y, SPH_LINEAR_U, SPH_LINEAR_V, SPH_LINEAR_RHO, SPH_LINEAR };

struct sph_linear {
  double complex K[SPH_LINEAR][SPH_LINEAR]; /* 1/s; without diffusion */
  double rate;                              /* 1/s: of this wave's decay by diffusion */
  double fastest; /* 1/s: of any wave's, which diffusion with steps of its own counts on */
  double damping; /* 1/s: Gamma, of methods that damp */
};

/* Sound of the frequency omega (1/s) along x, in units of its own: of a density that evolves, and
 * of one that follows from positions. */
struct sph_linear sph_linear_sound(double omega);
struct sph_linear sph_linear_sound_direct(double omega);

void sph_linear_step(const struct sph_integrator *method, const struct sph_linear *p, double dt,
                     double complex G[SPH_LINEAR][SPH_LINEAR]);

/* All eigenvalues of G, and the largest magnitude among them. ERR_MEMORY when LAPACK fails. */
enum status sph_linear_factors(double complex G[SPH_LINEAR][SPH_LINEAR],
                               double complex factor[SPH_LINEAR]);
enum status sph_linear_growth(const struct sph_integrator *method, const struct sph_linear *p,
                              double dt, double *growth);

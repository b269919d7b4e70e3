/* The time step: every bound of P, eqs. (27) to (29). */
#pragma once
#include "sph/sph.h"

struct sph_bounds {
  double diffusive;    /* (27), s; infinite without diffusion */
  double viscous;      /* (28), s; infinite without viscosity */
  double acceleration; /* (28), s */
  double acoustic;     /* (29), s */
};

/* From the totals of an evaluation with `bounds`. The diffusive and the acoustic bound are scaled
 * with the integrator's region of stability and with what the kernel does on a lattice
 * (theory/scale.h); the diffusive one with the strength of the term (diffusion.h), since (27) was
 * found for Antuono's. In (29) |pi_ij| is used, so that compression
 * counts too. */
struct sph_bounds sph_timestep_bounds(const struct sph *s);

/* Whether speed or acceleration cut the bounds to less than a tenth of what sound, diffusion and
 * viscosity leave to water at rest. */
bool sph_timestep_is_cut(const struct sph *s);

/* The smallest bound, shortened so that a whole number of equal steps ends at `next` (s). */
double sph_timestep(const struct sph *s, double next);

/* The largest c0 dt/h that the bounds leave to water at rest; *bounds: each of them in h/c0. */
double sph_courant_at_rest(const struct sph_scheme *o, struct sph_bounds *bounds);

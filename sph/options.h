/* What a run of the solver may choose. */
#pragma once
#include "common/params.h"

struct sph_options {
  int kernel, diffusion, integrator, walls; /* indices into their lists */
  double h_over_dx;
  double delta; /* negative: the usual one of the diffusion */
  double alpha;
  double c0; /* m/s */
  double cfl_acoustic, cfl_diffusive, cfl_viscous, cfl_acceleration;
};

enum { SPH_N_PARAMS = 12 };
extern const struct param sph_params[SPH_N_PARAMS];

/* delta, or the default of the diffusion when it is negative. */
double sph_options_delta(const struct sph_options *o);

/* The scheme of a run: one of every family of variants, and the factors. */
#pragma once
#include "common/base/params.h"
#include "sph/treat/list.h"

struct sph_scheme {
  int preset; /* which one the others come from (presets.h) */
  int kernel, eos, derivative, momentum, continuity, viscosity, diffusion; /* pair/, enumerations */
  int free_surface, integrator, walls, slip; /* indices into their lists */
  int precision;                             /* of the sums over pairs */
  int every[SPH_TREATMENT_COUNT];            /* steps; 0: never; < 0: a word */
#define X(key, ...) int key;                 /* of treatments */
  SPH_TREATMENT_NUMBERS(X)
  SPH_TREATMENT_CHOICES(X)
#undef X
  double strength[SPH_CORRECTION_COUNT];
#define X(key, ...) double key;
  SPH_TREATMENT_REALS(X)
#undef X
  double h_over_dx;
  double derivative_radius; /* h */
  double delta;             /* negative: the usual one of the diffusion */
  double alpha;
  double c0; /* m/s */
  double dt; /* s; 0: what the factors of the bounds allow */
  double cfl_acoustic, cfl_diffusive, cfl_viscous, cfl_acceleration;
  bool diagnostics, forces;    /* written (observe/diagnose.h) */
  bool accelerations;          /* written with the particles (observe/output.h) */
  double damping, damping_end; /* 1/s, s: Gamma, until then; 0: to the end */
};

enum { SPH_PRECISION_single, SPH_PRECISION_double };

enum { SPH_N_PARAMS = 28 + SPH_TREATMENT_PARAMS };
extern const struct param sph_params[SPH_N_PARAMS];

/* The word that may stand for delta, which then is -1, and what it means. */
extern const char *const sph_delta_words[], *const sph_delta_word_helps[];

/* delta; or, when it is negative, the usual one of the diffusion with P's kernel (diffusion.h),
 * carried over to this one (theory/scale.h) so that the waves that decay fastest do so as fast
 * against the fastest sound: the bounds (27) and (29) stay in the ratio that P has them in. */
double sph_scheme_delta(const struct sph_scheme *o);

/* What a case calls the variant that row `key` of the table has chosen. */
const char *sph_scheme_name(const struct sph_scheme *o, const char *key);

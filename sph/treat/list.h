/* Treatments of the water, each a file in this folder with a struct sph_treatment (treat.h), and a
 * line in one of the first two lists; keys of its own besides are lines in the third. */
#pragma once
#include "sph/family.h"

/* Applied between steps, in this order. X(name, help) makes the key NAME of a run: the number of
 * steps after which it is applied again, 0 for never; and the term NAME of its budget of energy. */
#define SPH_TREATMENTS(X)                                                                          \
  X(shepard,                                                                                       \
    "steps between re-initialisations rho_i = sum m W / sum V W (thesis, eq. (3.60)); 0: never")   \
  X(mls_volume, "steps between re-initialisations rho_i = sum V rho W_MLS, sum V W_MLS = 1, "      \
                "which keep linear "                                                               \
                "densities (thesis, 3.4.6.2); 0: never")                                           \
  X(mls_mass,                                                                                      \
    "steps between re-initialisations rho_i = sum phi m/V0, sum phi = 1, V0 the first volumes, "   \
    "which bring first densities back (thesis, eq. (3.63)); 0: never")                             \
  X(smoothing,                                                                                     \
    "steps between smoothings u_i = sum V u W / sum V W, rho_i = sum m W / sum V W of mSPH "       \
    "(thesis, eqs. (4.51), (4.52)); 0: never")

/* What they may choose: SPH_FAMILY lists, and X(key, LIST, first, help). */
#define SPH_SMOOTHED(X, ...)                                                                       \
  X(density, "rho itself, as the thesis has it: lifts water at rest", ##__VA_ARGS__)               \
  X(excess, "rho + rho0 g y/c0^2, which is constant in water at rest", ##__VA_ARGS__)
SPH_FAMILY(sph_smoothed, SPH_SMOOTHED, SPH_SMOOTHED);

#define SPH_TREATMENT_CHOICES(X)                                                                   \
  X(smoothing_of, SPH_SMOOTHED, "density", "the density that smoothing smooths")

enum {
#define X(name, help) SPH_TREATMENT_##name,
  SPH_TREATMENTS(X)
#undef X
      SPH_TREATMENT_COUNT
};
#define SPH_ONE(...) +1
enum { SPH_TREATMENT_PARAMS = SPH_TREATMENT_COUNT SPH_TREATMENT_CHOICES(SPH_ONE) };
#undef SPH_ONE

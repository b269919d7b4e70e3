/* Treatments of the water, each a file in this folder with a struct sph_treatment (treat.h), and a
 * line in one of the lists here; every key of its own besides is a line in another. The name of a
 * treatment is a key of a run and a term of its budget of energy. */
#pragma once
#include "sph/family.h"

/* Words that may stand for a number of steps: SPH_FAMILY lists. */
#define SPH_NO_WORDS(X, ...)
#define SPH_SMOOTHING_WORDS(X, ...)                                                                \
  X(auto,                                                                                          \
    "so often that it diffuses 0.049 c0 dx, as the thesis' best does, n c0 dt/h = 4.25 with the "  \
    "cubic spline at dx = 0.75h",                                                                  \
    ##__VA_ARGS__)
SPH_FAMILY(sph_smoothing_word, SPH_SMOOTHING, SPH_SMOOTHING_WORDS);

/* Applied between steps, in this order. X(name, WORDS, help): the key's value is the number of
 * steps after which it is applied again, 0 for never, or a word. */
#define SPH_TREATMENTS(X)                                                                          \
  X(shepard, SPH_NO_WORDS,                                                                         \
    "steps between re-initialisations rho_i = sum m W / sum V W (thesis, eq. (3.60)); 0: never")   \
  X(mls_volume, SPH_NO_WORDS,                                                                      \
    "steps between re-initialisations rho_i = sum V rho W_MLS, sum V W_MLS = 1, which keep "       \
    "linear densities (thesis, 3.4.6.2); 0: never")                                                \
  X(mls_mass, SPH_NO_WORDS,                                                                        \
    "steps between re-initialisations rho_i = sum phi m/V0, sum phi = 1, V0 the first volumes, "   \
    "which bring first densities back (thesis, eq. (3.63)); 0: never")                             \
  X(smoothing, SPH_SMOOTHING_WORDS,                                                                \
    "steps between smoothings u_i = sum V u W / sum V W, rho_i = sum m W / sum V W of mSPH "       \
    "(thesis, eqs. (4.51), (4.52)); 0: never")                                                     \
  X(shifting, SPH_NO_WORDS,                                                                        \
    "steps between shifts of particles by -(U dt/h) (2h)^2 sum (1 + 0.2 (W/W(dx))^4) grad W "      \
    "m_j/(rho_i + rho_j), along the surface only beside it (Sun et al. 2017); 0: never")

/* What adds to the rates in every stage. X(name, most, help): the key's value is its strength, from
 * 0, without, to `most`. */
#define SPH_CORRECTIONS(X)                                                                         \
  X(xsph, 1,                                                                                       \
    "strength of XSPH, dr_i/dt = u_i + xsph sum (u_j - u_i) 2 m_j/(rho_i + rho_j) W (thesis, "     \
    "3.4.1); 0: without")                                                                          \
  X(tensile, 0.99,                                                                                 \
    "strength of the tensile correction: pairs with two negative pressures push 1 - tensile f^n "  \
    "times as much, f = W/W(dx) (thesis, eq. (3.57): 0.1); 0: without")

/* Numbers that they need: X(key, least, most, first, help). */
#define SPH_TREATMENT_NUMBERS(X)                                                                   \
  X(tensile_power, 1, 10, "4", "n of the tensile correction, a whole number")

/* What they may choose: SPH_FAMILY lists, and X(key, LIST, first, help). */
#define SPH_SMOOTHED(X, ...)                                                                       \
  X(density, "rho itself, as the thesis has it: lifts water at rest", ##__VA_ARGS__)               \
  X(excess, "rho + rho0 g y/c0^2, which is constant in water at rest", ##__VA_ARGS__)
SPH_FAMILY(sph_smoothed, SPH_SMOOTHED, SPH_SMOOTHED);

#define SPH_TREATMENT_CHOICES(X)                                                                   \
  X(smoothing_of, SPH_SMOOTHED, "density", "the density that smoothing smooths")

enum {
#define X(name, ...) SPH_TREATMENT_##name,
  SPH_TREATMENTS(X)
#undef X
      SPH_TREATMENT_COUNT
};
enum {
#define X(name, ...) SPH_CORRECTION_##name,
  SPH_CORRECTIONS(X)
#undef X
      SPH_CORRECTION_COUNT
};
#define SPH_ONE(...) +1
enum {
  SPH_TREATMENT_PARAMS = SPH_TREATMENT_COUNT + SPH_CORRECTION_COUNT SPH_TREATMENT_NUMBERS(SPH_ONE)
                                                   SPH_TREATMENT_CHOICES(SPH_ONE)
};
#undef SPH_ONE

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
#define SPH_GROWTH_WORDS(X, ...)                                                                   \
  X(growth, "when |sum V v| has grown to growth_limit L^2 sqrt(gL), L the length of the tank",     \
    ##__VA_ARGS__)
SPH_FAMILY(sph_growth_word, SPH_GROWTH, SPH_GROWTH_WORDS);

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
    "m_j/(rho_i + rho_j), along the surface only beside it (Sun et al. 2017); 0: never")           \
  X(removal, SPH_GROWTH_WORDS,                                                                     \
    "in a periodic tank, steps between removals of the horizontal means of velocity and dynamic "  \
    "pressure at each depth (thesis, 4.2.3); 0: never")                                            \
  X(projection, SPH_GROWTH_WORDS,                                                                  \
    "in a periodic tank, steps between projections on waves, u = grad sum_m (a_m sin k_m x + "     \
    "b_m cos k_m x) Y_m(y), m >= 1 (thesis, eqs. (2.94) to (2.103)), and of a fitted surface's "   \
    "heights on these harmonics; 0: never")

/* What adds to the rates in every stage. X(name, most, help): the key's value is its strength, from
 * 0, without, to `most`. */
#define SPH_CORRECTIONS(X)                                                                         \
  X(xsph, 1,                                                                                       \
    "strength of XSPH, dr_i/dt = u_i + xsph sum (u_j - u_i) 2 m_j/(rho_i + rho_j) W (thesis, "     \
    "3.4.1); 0: without")                                                                          \
  X(tensile, 0.99,                                                                                 \
    "strength of the tensile correction: pairs with two negative pressures push 1 - tensile f^n "  \
    "times as much, f = W/W(dx) (thesis, eq. (3.57): 0.1); 0: without")

/* Numbers that they need, whole or not: X(key, least, most, first, help). */
enum { SPH_MOST_MODES = 32 };
#define SPH_TREATMENT_NUMBERS(X)                                                                   \
  X(tensile_power, 1, 10, "4", "n of the tensile correction")                                      \
  X(projection_modes, 1, SPH_MOST_MODES, "5", "waves of a projection, the longest as the tank")

#define SPH_TREATMENT_REALS(X)                                                                     \
  X(growth_limit, 1e-12, 1, "1e-4",                                                                \
    "where a removal or projection is due by growth: thesis, a tenth of a wave's amplitude over "  \
    "the tank's length")

/* What they may choose: SPH_FAMILY lists, and X(key, LIST, first, help). */
#define SPH_SMOOTHED(X, ...)                                                                       \
  X(density, "rho itself, as the thesis has it: lifts water at rest", ##__VA_ARGS__)               \
  X(excess, "rho + rho0 g y/c0^2, which is constant in water at rest", ##__VA_ARGS__)
SPH_FAMILY(sph_smoothed, SPH_SMOOTHED, SPH_SMOOTHED);

#define SPH_PROFILES(X, ...)                                                                       \
  X(deep, "e^{ky}, by least squares (thesis, eq. (2.95), F0)", ##__VA_ARGS__)                      \
  X(weighted, "e^{ky}, weighted with e^{-g y/c0^2} (thesis, eq. (2.94) corrected, F1)",            \
    ##__VA_ARGS__)                                                                                 \
  X(finite, "cosh k(y + H), which no flow through the bed belongs to", ##__VA_ARGS__)
SPH_FAMILY(sph_profile, SPH_PROFILE, SPH_PROFILES);

#define SPH_TREATMENT_CHOICES(X)                                                                   \
  X(projection_profile, SPH_PROFILES, "deep", "the waves' Y(y), y from the surface at rest")       \
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
                                                   SPH_TREATMENT_REALS(SPH_ONE)
                                                       SPH_TREATMENT_CHOICES(SPH_ONE)
};
#undef SPH_ONE

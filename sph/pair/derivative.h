/* How the gradient of the pressure and the divergence of the velocity are taken from neighbours:
 * the kernel's sums in the forms of momentum.h and continuity.h, or one of three fits, each the
 * solution g of M g = b with sums over neighbours of differences (x, f) from the particle:
 *
 *   renormalised  M = sum x x F V, b = sum x f F V, F V the weights of the kernel's gradient
 *   mueller       M = sum x x,     b = sum x f      within a radius
 *   mls           the same less the means, M = sum x x - X X/N, b = sum x f - X f/N: the slope of
 * the plane fitted to all values, the particle's own included
 *
 * All are exact for linear fields, with any neighbours, at the surface too; none knows that the
 * pressure vanishes there. Where neighbours do not span the plane M is kept from being singular as
 * that of other fits (moments.h), and the slope fades out. */
#pragma once
#include <stdbool.h>

#include "sph/family.h"
#include "sph/fluid/particles.h"

#define SPH_DERIVATIVES(X, ...)                                                                    \
  X(kernel, "sums over pairs with the kernel's gradient, in the forms chosen", ##__VA_ARGS__)      \
  X(renormalised,                                                                                  \
    "[sum r_ji grad W V]^-1 sum (f_j - f_i) grad W V (P eq. (9)); with momentum minus or "         \
    "reference",                                                                                   \
    ##__VA_ARGS__)                                                                                 \
  X(mls,                                                                                           \
    "slope of the plane fitted to f within derivative_radius, unit weights (thesis, eqs. (4.13), " \
    "(4.14)); with momentum minus or reference",                                                   \
    ##__VA_ARGS__)                                                                                 \
  X(mueller,                                                                                       \
    "[sum r_ji r_ji]^-1 sum (f_j - f_i) r_ji within derivative_radius, unit weights (thesis, "     \
    "eqs. (3.13), (3.14)); with momentum minus or reference",                                      \
    ##__VA_ARGS__)
SPH_FAMILY(sph_derivative, SPH_DERIVATIVE, SPH_DERIVATIVES);

SPECIALISE bool derivative_is_fit(enum sph_derivative d) {
  switch (d) {
  case SPH_DERIVATIVE_kernel:
    return false;
  case SPH_DERIVATIVE_renormalised:
  case SPH_DERIVATIVE_mls:
  case SPH_DERIVATIVE_mueller:
    return true;
  }
  __builtin_unreachable();
}

/* Whether neighbours within derivative_radius count alike; else they have the kernel's weights. */
SPECIALISE bool derivative_has_radius(enum sph_derivative d) {
  switch (d) {
  case SPH_DERIVATIVE_kernel:
  case SPH_DERIVATIVE_renormalised:
    return false;
  case SPH_DERIVATIVE_mls:
  case SPH_DERIVATIVE_mueller:
    return true;
  }
  __builtin_unreachable();
}

/* Whether it fits a mean, too, instead of going through the particle's own value. */
SPECIALISE bool derivative_takes_means(enum sph_derivative d) {
  switch (d) {
  case SPH_DERIVATIVE_kernel:
  case SPH_DERIVATIVE_renormalised:
  case SPH_DERIVATIVE_mueller:
    return false;
  case SPH_DERIVATIVE_mls:
    return true;
  }
  __builtin_unreachable();
}

struct sph;
struct sph_near;
struct sph_targets;

/* Of a cluster's particles: Pa/m and 1/s. */
struct sph_slopes {
  double px[SPH_LANES], py[SPH_LANES], div[SPH_LANES];
};

/* By a fit, from water and wall particles. */
struct sph_slopes sph_slopes_of(const struct sph *s, const struct sph_targets *i,
                                const struct sph_near *water, const struct sph_near *walls);

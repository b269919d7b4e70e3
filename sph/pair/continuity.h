/* The forms of the continuity equation: what a pair adds to
 *
 *   D rho_i/Dt = -continuity_density sum_j continuity_flux + diffusion
 *
 * where `flow` is (u_j - u_i) . grad_i W_ij V_j, and `own` u_i . grad_i W_ij V_j. The densities
 * that are sums over neighbours (density.h) have the rate of `mass` between evaluations, which is
 * the time derivative of sum m_j W_ij. */
#pragma once
#include "sph/family.h"
#include "sph/pair/vec.h"

#define SPH_CONTINUITIES(X, ...)                                                                   \
  X(divergence, "-rho_i sum (u_j - u_i) . grad W V_j (P eq. (1); thesis, eq. (3.19))",             \
    ##__VA_ARGS__)                                                                                 \
  X(absolute,                                                                                      \
    "-rho_i sum u_j . grad W V_j (thesis, eq. (2.13)); depends on the frame where the kernel is "  \
    "cut",                                                                                         \
    ##__VA_ARGS__)                                                                                 \
  X(mass, "-sum m_j (u_j - u_i) . grad W (thesis, eqs. (2.134), (3.20))", ##__VA_ARGS__)           \
  X(reference, "-rho0 sum (u_j - u_i) . grad W V_j: dp/dt = -rho0 c0^2 div u (thesis, eq. (4.2))", \
    ##__VA_ARGS__)                                                                                 \
  X(summation,                                                                                     \
    "rho_i = sum m_j W, the particle itself and walls included (thesis, eq. (2.16)); beside a "    \
    "free surface it is too low",                                                                  \
    ##__VA_ARGS__)                                                                                 \
  X(shepard,                                                                                       \
    "rho_i = sum m_j W / sum (m_j/rho_j) W with rho_j = sum m W (thesis, eq. (3.18)); beside a "   \
    "free surface it is too low",                                                                  \
    ##__VA_ARGS__)
SPH_FAMILY(sph_continuity, SPH_CONTINUITY, SPH_CONTINUITIES);

/* (ri, rj): densities over rho0. */
SPECIALISE vec continuity_flux(enum sph_continuity c, vec flow, vec own, vec ri, vec rj) {
  switch (c) {
  case SPH_CONTINUITY_divergence:
  case SPH_CONTINUITY_reference:
    return flow;
  case SPH_CONTINUITY_absolute:
    return flow + own;
  case SPH_CONTINUITY_mass:
  case SPH_CONTINUITY_summation:
  case SPH_CONTINUITY_shepard:
    return flow * rj / ri;
  }
  __builtin_unreachable();
}

/* Whether rho0 multiplies the divergence, and not the particle's density. */
SPECIALISE bool continuity_is_of_reference(enum sph_continuity c) {
  switch (c) {
  case SPH_CONTINUITY_divergence:
  case SPH_CONTINUITY_absolute:
  case SPH_CONTINUITY_mass:
  case SPH_CONTINUITY_summation:
  case SPH_CONTINUITY_shepard:
    return false;
  case SPH_CONTINUITY_reference:
    return true;
  }
  __builtin_unreachable();
}

SPECIALISE double continuity_density(enum sph_continuity c, double rho0, double rho) {
  return continuity_is_of_reference(c) ? rho0 : rho;
}

/* Whether the density is a sum over neighbours. */
SPECIALISE bool continuity_sums(enum sph_continuity c) {
  switch (c) {
  case SPH_CONTINUITY_divergence:
  case SPH_CONTINUITY_absolute:
  case SPH_CONTINUITY_mass:
  case SPH_CONTINUITY_reference:
    return false;
  case SPH_CONTINUITY_summation:
  case SPH_CONTINUITY_shepard:
    return true;
  }
  __builtin_unreachable();
}

/* Whether that sum is over one of volumes. */
SPECIALISE bool continuity_divides(enum sph_continuity c) {
  switch (c) {
  case SPH_CONTINUITY_divergence:
  case SPH_CONTINUITY_absolute:
  case SPH_CONTINUITY_mass:
  case SPH_CONTINUITY_reference:
  case SPH_CONTINUITY_summation:
    return false;
  case SPH_CONTINUITY_shepard:
    return true;
  }
  __builtin_unreachable();
}

/* The forms of the continuity equation: what a pair adds to sum_j continuity_flux, in
 *
 *   D rho_i/Dt = -rho_i sum_j continuity_flux + diffusion
 *
 * where `flow` is (u_j - u_i) . grad_i W_ij V_j. */
#pragma once
#include "sph/family.h"
#include "sph/pair/vec.h"

#define SPH_CONTINUITIES(X, ...) X(divergence, "divergence of u_j - u_i (P eq. (1))", ##__VA_ARGS__)
SPH_FAMILY(sph_continuity, SPH_CONTINUITY, SPH_CONTINUITIES);

SPECIALISE vec continuity_flux(enum sph_continuity c, vec flow) {
  switch (c) {
  case SPH_CONTINUITY_divergence:
    return flow;
  }
  __builtin_unreachable();
}

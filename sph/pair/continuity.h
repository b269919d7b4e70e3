/* The forms of the continuity equation: what a pair adds to sum_j (...) V_j slope, in
 *
 *   D rho_i/Dt = -rho_i sum_j continuity_flux V_j slope_ij + diffusion
 *
 * where `approach` is (u_j - u_i) . (r_j - r_i). */
#pragma once
#include "sph/family.h"
#include "sph/pair/vec.h"

#define SPH_CONTINUITIES(X, ...) X(divergence, "divergence of u_j - u_i (P eq. (1))", ##__VA_ARGS__)
SPH_FAMILY(sph_continuity, SPH_CONTINUITY, SPH_CONTINUITIES);

SPECIALISE vec continuity_flux(enum sph_continuity c, vec approach) {
  switch (c) {
  case SPH_CONTINUITY_divergence:
    return approach;
  }
  __builtin_unreachable();
}

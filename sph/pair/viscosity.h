/* The forms of the viscous force: what a pair adds to sum_j (...) V_j grad_i W_ij, and the factor
 * of that sum over rho_i. `pi` is (u_j - u_i) . (r_j - r_i) / |r_j - r_i|^2. */
#pragma once
#include "sph/family.h"
#include "sph/pair/vec.h"

#define SPH_VISCOSITIES(X, ...)                                                                    \
  X(artificial, "alpha h c0 rho0 pi_ij (P eqs. (1), (2); Monaghan)", ##__VA_ARGS__)
SPH_FAMILY(sph_viscosity, SPH_VISCOSITY, SPH_VISCOSITIES);

SPECIALISE vec viscosity_drag(enum sph_viscosity v, vec pi) {
  switch (v) {
  case SPH_VISCOSITY_artificial:
    return pi;
  }
  __builtin_unreachable();
}

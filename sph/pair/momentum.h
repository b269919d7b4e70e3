/* The forms of the pressure force: what a pair adds to sum_j (...) V_j grad_i W_ij, in
 *
 *   D u_i/Dt = -(1/rho_i) sum_j momentum_pressure V_j grad_i W_ij + f + viscosity */
#pragma once
#include "sph/family.h"
#include "sph/pair/vec.h"

#define SPH_MOMENTUMS(X, ...)                                                                      \
  X(plus, "p_i + p_j, which conserves momentum and, with divergence, energy (P eq. (1))",          \
    ##__VA_ARGS__)
SPH_FAMILY(sph_momentum, SPH_MOMENTUM, SPH_MOMENTUMS);

SPECIALISE vec momentum_pressure(enum sph_momentum m, vec pi, vec pj) {
  switch (m) {
  case SPH_MOMENTUM_plus:
    return pj + pi;
  }
  __builtin_unreachable();
}

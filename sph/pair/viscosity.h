/* The forms of the viscous force: what a pair adds to sum_j (...) V_j grad_i W_ij, and alpha h c0
 * rho0/rho_i is the factor of that sum. `approach` is (u_j - u_i) . (r_j - r_i) in units of h and
 * c0. */
#pragma once
#include "sph/family.h"
#include "sph/pair/vec.h"

#define SPH_VISCOSITIES(X, ...)                                                                    \
  X(artificial, "alpha h c0 rho0 pi_ij, pi_ij = (u_j - u_i).r_ji/r^2 (P eqs. (1), (2))",           \
    ##__VA_ARGS__)                                                                                 \
  X(monaghan,                                                                                      \
    "alpha h c0 2 rho_i rho_j/(rho_i + rho_j) (u_j - u_i).r_ji/(r^2 + 0.01 h^2) where particles "  \
    "approach, else 0 (thesis, eq. (3.46))",                                                       \
    ##__VA_ARGS__)
SPH_FAMILY(sph_viscosity, SPH_VISCOSITY, SPH_VISCOSITIES);

/* (ri, rj): densities over rho0. */
SPECIALISE vec viscosity_drag(enum sph_viscosity v, vec approach, vec q2, vec ri, vec rj) {
  const real tiny2 = (real)1e-24; /* the particle itself gives 0/tiny */
  switch (v) {
  case SPH_VISCOSITY_artificial:
    return approach / (q2 + tiny2);
  case SPH_VISCOSITY_monaghan:
    return vec_where_less(approach, approach, (vec){0}) / (q2 + (real)0.01) * (ri * rj) * (real)2 /
           (ri + rj);
  }
  __builtin_unreachable();
}

/* The forms of the pressure force: what a pair adds to sum_j (...) V_j grad_i W_ij, in
 *
 *   D u_i/Dt = -(1/rho_i) sum_j momentum_pressure V_j grad_i W_ij + f + viscosity
 *
 * Momentum is conserved by those whose force on i by j, times m_i, is the other way round that on j
 * by i: plus and mass. */
#pragma once
#include "sph/family.h"
#include "sph/pair/vec.h"

#define SPH_MOMENTUMS(X, ...)                                                                      \
  X(plus,                                                                                          \
    "-(1/rho_i) sum (p_j + p_i) V_j grad W, which conserves momentum and, with continuity "        \
    "divergence, energy (P eq. (1); thesis, eq. (3.16))",                                          \
    ##__VA_ARGS__)                                                                                 \
  X(minus, "-(1/rho_i) sum (p_j - p_i) V_j grad W (thesis, eq. (3.16))", ##__VA_ARGS__)            \
  X(neighbour,                                                                                     \
    "-(1/rho_i) sum p_j V_j grad W, which with continuity absolute conserves energy (thesis, eq. " \
    "(2.12))",                                                                                     \
    ##__VA_ARGS__)                                                                                 \
  X(mass,                                                                                          \
    "-sum m_j (p_i/rho_i^2 + p_j/rho_j^2) grad W, which conserves momentum and, with continuity "  \
    "mass, energy (thesis, eq. (2.15))",                                                           \
    ##__VA_ARGS__)                                                                                 \
  X(reference,                                                                                     \
    "-(1/rho0) sum (p_j + p_i) V_j grad W, or -(1/rho0) grad p with other derivatives (thesis, "   \
    "eqs. (4.1), (4.40))",                                                                         \
    ##__VA_ARGS__)
SPH_FAMILY(sph_momentum, SPH_MOMENTUM, SPH_MOMENTUMS);

/* (ri, rj): densities over rho0. */
SPECIALISE vec momentum_pressure(enum sph_momentum m, vec pi, vec pj, vec ri, vec rj) {
  switch (m) {
  case SPH_MOMENTUM_plus:
    return pj + pi;
  case SPH_MOMENTUM_minus:
    return pj - pi;
  case SPH_MOMENTUM_neighbour:
    return pj;
  case SPH_MOMENTUM_mass:
    return pi * rj / ri + pj * ri / rj;
  case SPH_MOMENTUM_reference:
    return (pj + pi) * ri;
  }
  __builtin_unreachable();
}

/* Whether rho0 divides the gradient of the pressure, and not the particle's density. */
SPECIALISE bool momentum_is_of_reference(enum sph_momentum m) {
  switch (m) {
  case SPH_MOMENTUM_plus:
  case SPH_MOMENTUM_minus:
  case SPH_MOMENTUM_neighbour:
  case SPH_MOMENTUM_mass:
    return false;
  case SPH_MOMENTUM_reference:
    return true;
  }
  __builtin_unreachable();
}

/* The density that does: at rest the gradient is this times gravity. */
SPECIALISE double momentum_density(enum sph_momentum m, double rho0, double rho) {
  return momentum_is_of_reference(m) ? rho0 : rho;
}

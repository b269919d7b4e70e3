/* The equations of state: pressure from density, the density back, and the elastic energy per mass
 * e with d e = p / rho^2 d rho, e(rho0) = 0, with which the discrete momentum and continuity
 * equations exchange kinetic and elastic energy without loss (rates.c). */
#pragma once
#include <math.h>

#include "sph/family.h"

#define SPH_EOS(X, ...) X(linear, "p = c0^2 (rho - rho0) (P eq. (1))", ##__VA_ARGS__)
SPH_FAMILY(sph_eos, SPH_EOS, SPH_EOS);

SPECIALISE double eos_pressure(enum sph_eos e, double rho0, double c0, double rho) {
  switch (e) {
  case SPH_EOS_linear:
    return c0 * c0 * (rho - rho0);
  }
  __builtin_unreachable();
}

SPECIALISE double eos_density(enum sph_eos e, double rho0, double c0, double p) {
  switch (e) {
  case SPH_EOS_linear:
    return rho0 + p / (c0 * c0);
  }
  __builtin_unreachable();
}

/* e = c0^2 (ln(rho/rho0) + rho0/rho - 1). */
SPECIALISE double eos_energy(enum sph_eos e, double rho0, double c0, double rho) {
  double x = rho / rho0 - 1;
  switch (e) {
  case SPH_EOS_linear:
    return c0 * c0 * (log1p(x) - x / (1 + x));
  }
  __builtin_unreachable();
}

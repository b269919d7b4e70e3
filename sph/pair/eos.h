/* The equations of state: pressure from density and height, the density back, and the elastic
 * energy per mass e with d e = p / rho^2 d rho, e(rho0) = 0, with which adjoint momentum and
 * continuity equations exchange kinetic and elastic energy without loss (rates.c).
 *
 * Two of them share the work of gravity differently. `dynamic` drives the water by the pressure
 * above the hydrostatic one, in place of p and g. `split` keeps a density that water at rest has
 * the same of everywhere, for the sums over pairs, and adds the hydrostatic part where the pressure
 * is taken. So there are a density that is stored and evolves, and the density; a pressure that
 * drives, of which the pair loops take differences, and the pressure; for `linear` and `tait` they
 * are the same. Heights count from the level of water at rest, where the pressure is zero. */
#pragma once
#include <math.h>

#include "sph/family.h"

#define SPH_EOS(X, ...)                                                                            \
  X(linear, "p = c0^2 (rho - rho0) (P eq. (1))", ##__VA_ARGS__)                                    \
  X(tait, "p = (rho0 c0^2/7) ((rho/rho0)^7 - 1) (thesis, eq. (2.3), which has lost the 1/7)",      \
    ##__VA_ARGS__)                                                                                 \
  X(dynamic,                                                                                       \
    "p_d = c0^2 (rho - rho0) + rho0 g y drives the water, y from the level of rest, in place of "  \
    "p and g (thesis, eqs. (4.32) to (4.36)); with momentum: reference. A free surface has "       \
    "p_d = 0 instead of p = 0: for water that keeps its level",                                    \
    ##__VA_ARGS__)                                                                                 \
  X(split,                                                                                         \
    "p = c0^2 (rho - rho0) of rho = rho_s - rho0 g y/c0^2, where rho_s starts as rho0, evolves "   \
    "and gives the volumes (thesis, eqs. (4.57) to (4.60)); with momentum: reference",             \
    ##__VA_ARGS__)
SPH_FAMILY(sph_eos, SPH_EOS, SPH_EOS);

struct eos {
  enum sph_eos law;
  double rho0, c0, g, level; /* kg m^-3, m/s, m s^-2, m */
};

/* The hydrostatic part of a linear pressure above the level, Pa: negative. */
SPECIALISE double eos_weight(const struct eos *e, double y) {
  return -e->rho0 * e->g * (y - e->level);
}

SPECIALISE double eos_density(const struct eos *e, double stored, double y) {
  switch (e->law) {
  case SPH_EOS_linear:
  case SPH_EOS_tait:
  case SPH_EOS_dynamic:
    return stored;
  case SPH_EOS_split:
    return stored + eos_weight(e, y) / (e->c0 * e->c0);
  }
  __builtin_unreachable();
}

/* The pressure that drives, from the stored density; and back. */
SPECIALISE double eos_driving(const struct eos *e, double stored, double y) {
  const double c2 = e->c0 * e->c0;
  switch (e->law) {
  case SPH_EOS_linear:
    return c2 * (stored - e->rho0);
  case SPH_EOS_tait:
    return e->rho0 * c2 / 7 * expm1(7 * log1p((stored - e->rho0) / e->rho0));
  case SPH_EOS_dynamic:
    return c2 * (stored - e->rho0) - eos_weight(e, y);
  case SPH_EOS_split:
    return c2 * (stored - e->rho0) + eos_weight(e, y);
  }
  __builtin_unreachable();
}

SPECIALISE double eos_stored(const struct eos *e, double driving, double y) {
  const double c2 = e->c0 * e->c0;
  switch (e->law) {
  case SPH_EOS_linear:
    return e->rho0 + driving / c2;
  case SPH_EOS_tait:
    /* no density has less than the pressure of nothing, which wall particles may be given */
    return e->rho0 * exp(log1p(larger(7 * driving / (e->rho0 * c2), 1e-7 - 1)) / 7);
  case SPH_EOS_dynamic:
    return e->rho0 + (driving + eos_weight(e, y)) / c2;
  case SPH_EOS_split:
    return e->rho0 + (driving - eos_weight(e, y)) / c2;
  }
  __builtin_unreachable();
}

/* Whether the pressure that drives is what exceeds the hydrostatic one, and takes gravity's place.
 */
SPECIALISE bool eos_drives_by_excess(enum sph_eos law) {
  switch (law) {
  case SPH_EOS_linear:
  case SPH_EOS_tait:
  case SPH_EOS_split:
    return false;
  case SPH_EOS_dynamic:
    return true;
  }
  __builtin_unreachable();
}

/* The pressure, from the one that drives; and back. */
SPECIALISE double eos_pressure(const struct eos *e, double driving, double y) {
  return eos_drives_by_excess(e->law) ? driving + eos_weight(e, y) : driving;
}

SPECIALISE double eos_driving_of(const struct eos *e, double pressure, double y) {
  return eos_drives_by_excess(e->law) ? pressure - eos_weight(e, y) : pressure;
}

/* The pressure that drives, `drop` (m) below where it is `driving`, in water at rest: from dp/dy =
 * -rho g, as far as gravity is left beside it. */
SPECIALISE double eos_driving_below(const struct eos *e, double driving, double drop) {
  const double c2 = e->c0 * e->c0, q = e->g * drop / c2;
  switch (e->law) {
  case SPH_EOS_linear:
  case SPH_EOS_split:
    return driving + (e->rho0 * c2 + driving) * expm1(q);
  case SPH_EOS_tait: { /* (rho/rho0)^6 grows by 6 q */
    const double r = exp(log1p(larger(7 * driving / (e->rho0 * c2), 1e-7 - 1)) / 7);
    const double below = larger(pow(r, 6) + 6 * q, 1e-7);
    return e->rho0 * c2 / 7 * expm1(7. / 6 * log(below));
  }
  case SPH_EOS_dynamic:
    return driving;
  }
  __builtin_unreachable();
}

/* What is left of gravity beside the pressure that drives, m s^-2. */
SPECIALISE double eos_gravity(const struct eos *e) {
  return eos_drives_by_excess(e->law) ? 0 : e->g;
}

/* How the density changes with height alone, kg m^-4. */
SPECIALISE double eos_density_rises(const struct eos *e) {
  switch (e->law) {
  case SPH_EOS_linear:
  case SPH_EOS_tait:
  case SPH_EOS_dynamic:
    return 0;
  case SPH_EOS_split:
    return -e->rho0 * e->g / (e->c0 * e->c0);
  }
  __builtin_unreachable();
}

/* What lifting takes of elastic energy, p/rho^2 drho/dy, J per kg and m. */
SPECIALISE double eos_lift(const struct eos *e, double driving, double stored, double y) {
  const double rho = eos_density(e, stored, y);
  return eos_pressure(e, driving, y) / (rho * rho) * eos_density_rises(e);
}

/* Whether the density that evolves is the density, and the pressure that drives the pressure: if
 * not, gravity has gone into one of them. */
SPECIALISE bool eos_is_plain(enum sph_eos law) {
  switch (law) {
  case SPH_EOS_linear:
  case SPH_EOS_tait:
    return true;
  case SPH_EOS_dynamic:
  case SPH_EOS_split:
    return false;
  }
  __builtin_unreachable();
}

/* Whether the pressure that drives is c0^2 times the stored density, but for a constant. */
SPECIALISE bool eos_is_linear(enum sph_eos law) {
  switch (law) {
  case SPH_EOS_linear:
  case SPH_EOS_dynamic:
  case SPH_EOS_split:
    return true;
  case SPH_EOS_tait:
    return false;
  }
  __builtin_unreachable();
}

/* e = c0^2 (ln(rho/rho0) + rho0/rho - 1); Tait's is (c0^2/7) ((r^6 - 1)/6 + 1/r - 1), r =
 * rho/rho0. */
SPECIALISE double eos_energy(const struct eos *e, double stored, double y) {
  const double x = eos_density(e, stored, y) / e->rho0 - 1, c2 = e->c0 * e->c0;
  switch (e->law) {
  case SPH_EOS_linear:
  case SPH_EOS_dynamic:
  case SPH_EOS_split:
    return c2 * (log1p(x) - x / (1 + x));
  case SPH_EOS_tait:
    return c2 / 7 * (expm1(6 * log1p(x)) / 6 - x / (1 + x));
  }
  __builtin_unreachable();
}

/* Depth of water at rest whose stored densities add up to rho0 A, m: from p = rho0 g (D - y), the
 * start's. */
SPECIALISE double eos_depth(const struct eos *e, double A) {
  const double q = e->g / (2 * e->c0 * e->c0);
  switch (e->law) {
  case SPH_EOS_linear:
  case SPH_EOS_dynamic:
    return 2 * A / (1 + sqrt(1 + 4 * q * A)); /* A = D + q D^2 */
  case SPH_EOS_tait:
    return q > 0 ? expm1(log1p(16 * q * A) * 7 / 8) / (14 * q) : A;
  case SPH_EOS_split:
    return A;
  }
  __builtin_unreachable();
}

/* Wave modes of a tank as T's sections 2.4.1.5 and 2.4.2 take them. Units: g = H = 1. */
#pragma once
#include "common/base/status.h"
#include "common/flow/modes.h"

enum theory_profile {
  THEORY_EXACT, /* roots and profiles of the stratified tank */
  THEORY_DEEP,  /* the decaying mode e^(kappa y) of incompressible deep water, acoustic modes exact
                 */
  THEORY_LEADING, /* the same, and nu_n = (2 n + 1) pi/2 */
  THEORY_PRINTED  /* e^((kappa - delta) y), acoustic modes without e^(delta y): T, eq. (2.85) */
};
extern const char *const theory_profile_names[], *const theory_profile_helps[];

struct theory_mode {
  struct wave_mode exact;
  bool deep;     /* e^(kappa y) instead */
  double lacked; /* psi without a factor e^(lacked y) */
};

/* A tank of depth 1 with g = 1 and c^2 = beta. ERR_USAGE where sound is so slow that there are two
 * decaying modes and no acoustic mode 0: eps >= eps_o (roots.c). */
enum status theory_tank(double beta, double kappa, struct wave_column *tank);

/* Mode n, -1: the decaying one. ERR_USAGE. */
enum status theory_mode_find(double beta, double kappa, int n, enum theory_profile profile,
                             struct theory_mode *mode);
double theory_mode_psi(const struct theory_mode *m, double y);
double theory_mode_slope(const struct theory_mode *m, double y);

/* int_{-1}^0 f(z, with) dz, f smooth with at most about a hundred waves: composite Gauss-Legendre
 * quadrature, to rounding. */
double theory_integral(double (*f)(double z, const void *with), const void *with);

/* int e^(-2 delta z) (psi_m' psi_n' + kappa^2 psi_m psi_n) dz (T, eq. 2.91), zero for exact modes
 * that differ. */
double theory_inner_product(const struct theory_mode *m, const struct theory_mode *n);

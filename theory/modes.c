#include "theory/modes.h"

#include <math.h>
#include <stddef.h>

const char *const theory_profile_names[] = {"exact", "deep", "leading", "printed", NULL};
const char *const theory_profile_helps[] = {
    "roots and profiles of the stratified tank",
    "the decaying mode is e^(kappa y), the others are exact",
    "the decaying mode is e^(kappa y), nu_n = (2 n + 1) pi/2",
    "without a factor e^(delta y), as (2.85) prints them; nu_n exact"};

enum status theory_tank(double beta, double kappa, struct wave_column *tank) {
  double delta = 1 / (2 * beta), k2 = kappa * kappa, d2 = delta * delta;
  CHECK(
      delta * (k2 - d2) < k2 + d2, ERR_USAGE,
      "c^2/(g H): found %.10g; allowed: with kappa H = %.10g at least %.4g, below which two modes "
      "decay",
      beta, kappa, (k2 - d2) / (2 * (k2 + d2)));
  *tank = (struct wave_column){.gravity = 1, .sound = sqrt(beta), .depth = 1, .wavenumber = kappa};
  return OK;
}

enum status theory_mode_find(double beta, double kappa, int n, enum theory_profile profile,
                             struct theory_mode *mode) {
  struct wave_column tank;
  TRY(theory_tank(beta, kappa, &tank));
  struct wave_mode *m = &mode->exact;
  mode->deep = n < 0 && profile != THEORY_EXACT;
  *m = n < 0 ? wave_mode_gravity(&tank) : wave_mode_acoustic(&tank, n);
  mode->lacked = profile == THEORY_PRINTED ? m->delta : 0;
  if (n < 0) {
    if (mode->deep) m->omega = sqrt(kappa);
    return OK;
  }
  if (profile != THEORY_LEADING) return OK;
  double nu = (2 * n + 1) * M_PI / 2;
  m->root = nu;
  m->s = 2 * m->delta * nu / (kappa * kappa + nu * nu - m->delta * m->delta);
  m->omega = tank.sound * sqrt(kappa * kappa + m->delta * m->delta + nu * nu);
  return OK;
}

static double whole_psi(const struct theory_mode *m, double y) {
  return m->deep ? exp(m->exact.in.wavenumber * y) : wave_mode_psi(&m->exact, y);
}

double theory_mode_psi(const struct theory_mode *m, double y) {
  return whole_psi(m, y) * exp(-m->lacked * y);
}

double theory_mode_slope(const struct theory_mode *m, double y) {
  double kappa = m->exact.in.wavenumber;
  double slope = m->deep ? kappa * exp(kappa * y) : wave_mode_slope(&m->exact, y);
  return (slope - m->lacked * whole_psi(m, y)) * exp(-m->lacked * y);
}

double theory_integral(double (*f)(double z, const void *with), const void *with) {
  /* Abramowitz & Stegun, table 25.4, n = 8: exact for polynomials of degree 15 */
  static const double place[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                 0.9602898564975363};
  static const double weight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                  0.1012285362903763};
  enum { PIECES = 400 };
  double sum = 0, half = 0.5 / PIECES;
  for (int i = 0; i < PIECES; i++)
    for (int k = 0; k < 4; k++) {
      double middle = -1 + (2 * i + 1) * half;
      sum += weight[k] * (f(middle - half * place[k], with) + f(middle + half * place[k], with));
    }
  return half * sum;
}

struct pair {
  const struct theory_mode *m, *n;
};

static double product(double z, const void *with) {
  const struct pair *p = with;
  double kappa = p->m->exact.in.wavenumber;
  double psi = theory_mode_psi(p->m, z) * theory_mode_psi(p->n, z);
  double slope = theory_mode_slope(p->m, z) * theory_mode_slope(p->n, z);
  return exp(-2 * p->m->exact.delta * z) * (slope + kappa * kappa * psi);
}

double theory_inner_product(const struct theory_mode *m, const struct theory_mode *n) {
  return theory_integral(product, &(struct pair){m, n});
}

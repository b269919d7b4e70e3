#include "sph/treat/waves.h"

#include <math.h>

#include "sph/fluid/energy.h"
#include "sph/pair/eos.h"
#include "sph/pair/momentum.h"

double sph_treat_level(const struct sph *s) {
  if (s->fitted) return s->eos.level; /* the first row's volumes reach above it */
  return s->tank.box.min[1] + sph_volume(s) / tank_size(&s->tank, 0);
}

double sph_treat_volume(const struct sph *s, size_t i) {
  const bool half = s->fitted && s->fitted[s->f.id[i]];
  return (half ? 0.5 : 1) * (s->f.m[i] / s->f.w.rho[i]);
}

/* Of water at rest by its momentum equation: where that divides by the density, the water weighs
 * what it is compressed to. */
static double hydrostatic(const struct sph *s, size_t i, double level) {
  const double head = s->g * (level - s->f.w.y[i]), c2 = s->c0 * s->c0;
  const bool even = s->scheme.momentum == SPH_MOMENTUM_reference; /* thesis, eq. (4.27) */
  return s->rho0 * (even ? head : c2 * expm1(head / c2));
}

double sph_treat_dynamic(const struct sph *s, size_t i, double level) {
  const double y = s->f.w.y[i];
  return eos_pressure(&s->eos, eos_driving(&s->eos, s->f.w.rho[i], y), y) -
         hydrostatic(s, i, level);
}

void sph_treat_set_dynamic(struct sph *s, size_t i, double level, double p) {
  const double y = s->f.w.y[i], pressure = hydrostatic(s, i, level) + p;
  s->f.w.rho[i] = eos_stored(&s->eos, eos_driving_of(&s->eos, pressure, y), y);
}

bool sph_treat_has_grown(const struct sph *s) {
  const double L = tank_size(&s->tank, 0);
  double sum = 0;
  for (size_t i = 0; i < s->f.n; i++) sum += sph_treat_volume(s, i) * s->f.w.v[i];
  return fabs(sum) >= s->scheme.growth_limit * L * L * sqrt(s->g * L);
}

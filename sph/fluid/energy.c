#include "sph/fluid/energy.h"

#include <math.h>

#include "sph/pair/eos.h"

static void add(const struct sph *s, size_t i, struct result_energy *e) {
  const struct sph_state *w = &s->f.w;
  double m = s->f.m[i];
  e->kinetic += 0.5 * m * (w->u[i] * w->u[i] + w->v[i] * w->v[i]);
  e->potential += m * s->g * w->y[i];
  e->internal += m * eos_energy((enum sph_eos)s->scheme.eos, s->rho0, s->c0, w->rho[i]);
}

struct result_energy sph_energy(const struct sph *s) {
  struct result_energy e = {.time = s->t,
                            .viscosity = s->budget.viscosity,
                            .diffusion = s->budget.diffusion,
                            .walls = s->budget.walls,
                            .removed = s->budget.removed};
  for (size_t i = 0; i < s->f.n; i++) add(s, i, &e);
  e.total = e.kinetic + e.potential + e.internal;
  return e;
}

double sph_energy_of(const struct sph *s, size_t i) {
  struct result_energy e = {0};
  add(s, i, &e);
  return e.kinetic + e.potential + e.internal;
}

double sph_rest_potential(const struct sph *s) {
  double mass = 0, width = s->tank.box.max[0] - s->tank.box.min[0], potential = 0;
  for (size_t i = 0; i < s->f.n; i++) mass += s->f.m[i];
  /* with p = rho0 g (D - y), the mass is rho0 (D + q D^2) times the width, q = g/2c0^2 */
  double q = s->g / (2 * s->c0 * s->c0), A = mass / (s->rho0 * width);
  double D = 2 * A / (1 + sqrt(1 + 4 * q * A));
  size_t n = geo_intervals(D, s->dx);
  double dy = D / (double)n;
  for (size_t j = 0; j < n; j++) {
    double Y = ((double)j + 0.5) * dy, rho = s->rho0 * (1 + 2 * q * (D - Y));
    potential += rho * dy * width * s->g * (s->tank.box.min[1] + Y);
  }
  return potential;
}

double sph_volume(const struct sph *s) {
  double volume = 0;
  for (size_t i = 0; i < s->f.n; i++) volume += s->f.m[i] / s->f.w.rho[i];
  return volume;
}

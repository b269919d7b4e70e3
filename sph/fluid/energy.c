#include "sph/fluid/energy.h"

#include <math.h>

#include "sph/pair/eos.h"

const struct solver_term sph_terms[SPH_TERM_COUNT] = {
#define X(name, help) [SPH_TERM_##name] = {#name, help, false},
    SPH_PAIR_POWERS(X) SPH_STEP_TERMS(X)
#undef X
#define X(name, help) [SPH_TERM_##name] = {#name, help, true},
        SPH_TANK_POWERS(X)
#undef X
#define X(name, ...)                                                                               \
  [SPH_TERM_##name] = {#name, "energy taken out so far by the treatment " #name, false},
            SPH_CORRECTIONS(X) SPH_TREATMENTS(X)
#undef X
};

/* Particles whose energies one thread sums: the same for any number of threads, as are the bits. */
enum { BLOCK = 512 };

static void add(const struct sph *s, size_t i, struct result_energy *e) {
  const struct sph_state *w = &s->f.w;
  double m = s->f.m[i];
  e->kinetic += 0.5 * m * (w->u[i] * w->u[i] + w->v[i] * w->v[i]);
  e->potential += m * s->g * sph_height(&s->force, w->x[i], w->y[i]);
  if (s->pull.rate > 0) e->potential += m * flow_pull_energy(&s->pull, w->x[i], w->y[i]);
  e->internal += m * eos_energy(&s->eos, w->rho[i], w->y[i]);
}

struct result_energy sph_energy(const struct sph *s) {
  struct result_energy e = {.time = s->t,
                            .removed = s->budget.removed,
                            .term = {
#define X(name, ...) [SPH_TERM_##name] = s->budget.name,
                                SPH_TERMS(X)
#undef X
                            }};
  size_t blocks = (s->f.n + BLOCK - 1) / BLOCK;
  double(*part)[3] = (double(*)[3])s->f.scratch; /* [blocks] */
#pragma omp parallel for schedule(static)
  for (size_t b = 0; b < blocks; b++) {
    struct result_energy sum = {0};
    for (size_t i = b * BLOCK; i < s->f.n && i < (b + 1) * BLOCK; i++) add(s, i, &sum);
    part[b][0] = sum.kinetic;
    part[b][1] = sum.potential;
    part[b][2] = sum.internal;
  }
  for (size_t b = 0; b < blocks; b++) {
    e.kinetic += part[b][0];
    e.potential += part[b][1];
    e.internal += part[b][2];
  }
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
  if (s->pull.rate > 0) return s->rho0 * flow_pull_rest(s->pull, mass / s->rho0);
  double D = eos_depth(&s->eos, mass / (s->rho0 * width));
  struct eos at_rest = s->eos;
  at_rest.level = D; /* counted from the bed */
  size_t n = geo_intervals(D, s->dx);
  double dy = D / (double)n;
  for (size_t j = 0; j < n; j++) {
    double Y = ((double)j + 0.5) * dy, p = s->rho0 * s->g * (D - Y);
    double rho = eos_stored(&at_rest, eos_driving_of(&at_rest, p, Y), Y);
    potential += rho * dy * width * s->g * (s->tank.box.min[1] + Y);
  }
  return potential;
}

double sph_volume(const struct sph *s) {
  double volume = 0;
  for (size_t i = 0; i < s->f.n; i++) volume += s->f.m[i] / s->f.w.rho[i];
  return volume;
}

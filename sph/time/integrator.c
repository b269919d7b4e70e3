#include "sph/time/integrator.h"

#include "sph/domain/wall.h"
#include "sph/pair/diffusion.h"
#include "sph/pair/rates.h"
#include "sph/pair/vec.h"

const struct sph_integrator sph_integrators[SPH_N_INTEGRATORS] = {
    {.name = "rk4",
     .stages = 4,
     .order = 4,
     .a = {{0}, {1. / 2}, {0, 1. / 2}, {0, 0, 1}},
     .b = {1. / 6, 1. / 3, 1. / 3, 1. / 6},
     .acoustic = 1,
     .diffusive = 1},
    /* Every stage of eq. (25) adds D(w0) with the weights of the classic method: it is that method
     * applied to dw/dt = Q(w) + D(w0). The error of freezing D is first order, times delta. */
    {.name = "rk4-frozen",
     .stages = 4,
     .order = 1,
     .frozen = true,
     .a = {{0}, {1. / 2}, {0, 1. / 2}, {0, 0, 1}},
     .b = {1. / 6, 1. / 3, 1. / 3, 1. / 6},
     .acoustic = 1,
     .diffusive = 1},
    {.name = "tvd-rk3",
     .stages = 3,
     .order = 3,
     .a = {{0}, {1}, {1. / 4, 1. / 4}},
     .b = {1. / 6, 1. / 6, 2. / 3},
     .acoustic = 1.732 / 2.828,
     .diffusive = 2.513 / 2.785},
};

const char *const sph_integrator_helps[] = {
    "classic Runge-Kutta of order 4",
    "classic Runge-Kutta, diffusion evaluated once a step (paper, eq. 25)",
    "total-variation diminishing Runge-Kutta of order 3 (Gottlieb & Shu 1998)",
    "rk4 with molteni or ferrari, which frozen need shorter steps, else rk4-frozen"};
const char *const sph_integrator_names[] = {"rk4", "rk4-frozen", "tvd-rk3", "auto", NULL};

int sph_integrator_chosen(const struct sph_scheme *o) {
  if (o->integrator != SPH_INTEGRATOR_AUTO) return o->integrator;
  return diffusion_frozen((enum sph_diffusion)o->diffusion) < 1 ? 0 : 1;
}

_Static_assert(SPH_MAX_STAGES == 4, "combine adds four terms at most");

/* w = w0 + sum c_r k_r over the stages with a weight. */
static void combine(size_t n, double *w, const double *w0, int n_terms, const double *c,
                    const double *const *k) {
  switch (n_terms) {
  case 1: {
    const double *k0 = k[0];
#pragma omp for simd schedule(static) nowait
    for (size_t i = 0; i < n; i++) w[i] = w0[i] + c[0] * k0[i];
    break;
  }
  case 2: {
    const double *k0 = k[0], *k1 = k[1];
#pragma omp for simd schedule(static) nowait
    for (size_t i = 0; i < n; i++) w[i] = w0[i] + (c[0] * k0[i] + c[1] * k1[i]);
    break;
  }
  default: {
    const double *k0 = k[0], *k1 = k[1], *k2 = k[2], *k3 = k[n_terms > 3 ? 3 : 2];
    double c3 = n_terms > 3 ? c[3] : 0;
#pragma omp for simd schedule(static) nowait
    for (size_t i = 0; i < n; i++)
      w[i] = w0[i] + ((c[0] * k0[i] + c[1] * k1[i]) + (c[2] * k2[i] + c3 * k3[i]));
  }
  }
}

static void set_state(struct sph *s, const double *weights, int stages, double dt) {
  struct sph_particles *f = &s->f;
  int n_terms = 0, term[SPH_MAX_STAGES];
  double c[SPH_MAX_STAGES];
  for (int r = 0; r < stages; r++)
    if (weights[r] != 0) {
      c[n_terms] = weights[r] * dt;
      term[n_terms++] = r;
    }
#pragma omp parallel
  {
    const double *k[SPH_MAX_STAGES] = {0};
#define X(q)                                                                                       \
  for (int t = 0; t < n_terms; t++) k[t] = f->k[term[t]].q;                                        \
  combine(f->n, f->w.q, f->w0.q, n_terms, c, k);
    SPH_STATE(X)
#undef X
  }
  sph_particles_pad(f);
}

static void keep_start(struct sph_particles *f) {
#pragma omp parallel for simd schedule(static)
  for (size_t i = 0; i < f->n; i++) {
#define X(q) f->w0.q[i] = f->w.q[i];
    SPH_STATE(X)
#undef X
  }
}

static void dissipate(struct sph *s, double weight) {
  s->budget.viscosity += weight * s->totals.viscosity;
  s->budget.diffusion += weight * s->totals.diffusion;
  s->budget.walls += weight * s->totals.walls;
}

enum status sph_step(struct sph *s, double dt) {
  const struct sph_integrator *method = &sph_integrators[s->scheme.integrator];
  keep_start(&s->f);
  dissipate(s, method->b[0] * dt);
  for (int r = 1; r < method->stages; r++) {
    set_state(s, method->a[r], r, dt);
    TRY(sph_rates(s, r, !method->frozen, false));
    dissipate(s, method->b[r] * dt);
  }
  set_state(s, method->b, method->stages, dt);
  sph_wall_confine(s);
  s->t += dt;
  s->steps++;
  return OK;
}

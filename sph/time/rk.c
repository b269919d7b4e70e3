#include "sph/time/rk.h"

#include "sph/domain/wall.h"
#include "sph/pair/rates.h"

_Static_assert(SPH_MAX_STAGES == 4, "combine adds four terms at most");

/* w = w0 + sum c_r k_r over the stages with a weight. */
static void combine(size_t n, double *w, const double *w0, int n_terms, const double *c,
                    const double *const *k) {
  switch (n_terms) {
  case 0:
#pragma omp for simd schedule(static) nowait
    for (size_t i = 0; i < n; i++) w[i] = w0[i];
    break;
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
  case 3:
  case 4: {
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
#define X(q, unit, help)                                                                           \
  for (int t = 0; t < n_terms; t++) k[t] = f->k[term[t]].q;                                        \
  combine(f->n, f->w.q, f->w0.q, n_terms, c, k);
    SPH_EVOLVING(X)
#undef X
  }
  sph_particles_pad(f);
  sph_wall_advance(s, weights, stages, dt);
}

static void spend(struct sph_totals *spent, double weight, const struct sph_totals *t) {
#define X(name, ...) spent->name += weight * t->name;
  SPH_POWERS(X)
#undef X
}

enum status sph_rk_step(struct sph *s, const struct sph_integrator *method, double dt,
                        struct sph_totals *spent, bool *held) {
  const struct rk_table *table = method->table;
  spend(spent, table->b[0] * dt, &s->totals);
  for (int r = 1; r < table->stages; r++) {
    set_state(s, table->a[r], r, dt);
    double elapsed = 0; /* of the stage, over dt */
    for (int l = 0; l < r; l++) elapsed += table->a[r][l];
    *held = sph_lists_hold(s, elapsed * dt);
    if (!*held) return OK;
    sph_tank_set(s, s->t + elapsed * dt);
    TRY(sph_rates(s, r, !method->frozen, false));
    spend(spent, table->b[r] * dt, &s->totals);
  }
  set_state(s, table->b, table->stages, dt);
  return OK;
}

const struct rk_table sph_rk_classic = {.stages = 4,
                                        .a = {{0}, {1. / 2}, {0, 1. / 2}, {0, 0, 1}},
                                        .b = {1. / 6, 1. / 3, 1. / 3, 1. / 6}};
const struct sph_integrator sph_rk4 = {.order = 4,
                                       .evaluations = 4,
                                       .acoustic = 1,
                                       .diffusive = 1,
                                       .table = &sph_rk_classic,
                                       .step = sph_rk_step};

/* Every stage of eq. (25) adds D(w0) with the weights of the classic method: it is that method
 * applied to dw/dt = Q(w) + D(w0). The error of freezing D is first order, times delta. */
const struct sph_integrator sph_rk4_frozen = {.order = 1,
                                              .evaluations = 4,
                                              .frozen = true,
                                              .acoustic = 1,
                                              .diffusive = 1,
                                              .table = &sph_rk_classic,
                                              .step = sph_rk_step};

static const struct rk_table shu_osher = {
    .stages = 3, .a = {{0}, {1}, {1. / 4, 1. / 4}}, .b = {1. / 6, 1. / 6, 2. / 3}};
const struct sph_integrator sph_tvd_rk3 = {.order = 3,
                                           .evaluations = 3,
                                           .acoustic = 1.732 / 2.828,
                                           .diffusive = 2.513 / 2.785,
                                           .table = &shu_osher,
                                           .step = sph_rk_step};

static const struct rk_table forward = {.stages = 1, .b = {1}};
const struct sph_integrator sph_euler = {
    .order = 1, .evaluations = 1, .diffusive = 2 / 2.785, .table = &forward, .step = sph_rk_step};

static const struct rk_table heun = {.stages = 2, .a = {{0}, {1}}, .b = {1. / 2, 1. / 2}};
const struct sph_integrator sph_predictor_corrector = {
    .order = 2, .evaluations = 2, .diffusive = 2 / 2.785, .table = &heun, .step = sph_rk_step};

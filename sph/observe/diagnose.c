#include "sph/observe/diagnose.h"

#include <math.h>

#include "common/case/case.h"
#include "sph/fluid/clusters.h"
#include "sph/observe/forces.h"
#include "sph/pair/kernel.h"
#include "sph/pair/rates.h"
#include "sph/pair/sums.h"

const struct solver_diagnostic sph_diagnostics[SPH_DIAGNOSTIC_COUNT] = {
#define X(name, unit, help) {#name, unit, help},
    SPH_DIAGNOSTICS(X)
#undef X
};

static const double INNER = 0.9; /* of sum V W */

/* Squares of what fields are off their means, summed over the inner particles of a cluster. */
struct noise {
  double n, u, v, p;
};

static void cluster_noise(struct sph *s, size_t cluster, const void *wanted) {
  struct noise *part = *(struct noise *const *)wanted;
  const struct sph_fit_sums a = sph_sums_around(s, cluster, SPH_OF_WATER);
  const double scale = kernel_value_scale((enum sph_kernel)s->scheme.kernel);
  struct noise sum = {0};
  for (size_t l = 0; l < SPH_LANES && cluster * SPH_LANES + l < s->f.n; l++) {
    const struct sph_pack *i = &s->pack[cluster * SPH_LANES + l];
    if (!(scale * a.w[l] > INNER)) continue;
    const double u = i->u - a.u[l] / a.w[l], v = i->v - a.v[l] / a.w[l];
    const double p = i->p - a.p[l] / a.w[l];
    sum.n++;
    sum.u += u * u;
    sum.v += v * v;
    sum.p += p * p;
  }
  part[cluster] = sum;
}

/* Of what stands in the packs; added up in the order of the clusters. */
static struct noise noise_of(struct sph *s) {
  struct noise *part = (struct noise *)s->f.scratch; /* half as many numbers as particles */
  const size_t n = s->water_water.n_clusters;
  _Static_assert(sizeof *part <= SPH_LANES * sizeof(double), "scratch holds one for a cluster");
  struct noise sum = {0};
  sph_each_cluster(s, cluster_noise, &part);
  for (size_t c = 0; c < n; c++) {
    sum.n += part[c].n;
    sum.u += part[c].u;
    sum.v += part[c].v;
    sum.p += part[c].p;
  }
  return sum;
}

static double rms(double squares, double n, double unit) {
  return n > 0 ? sqrt(squares / n) / unit : 0;
}

static void put_accelerations(struct sph *s) {
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < s->f.n; i++) {
    s->pack[i].u = s->f.k[0].u[i];
    s->pack[i].v = s->f.k[0].v[i];
  }
  sph_period_fill(s);
}

static void sum_momenta(const struct sph *s, double *value) {
  const struct sph_state *w = &s->f.w;
  for (size_t i = 0; i < s->f.n; i++) {
    const double m = s->f.m[i];
    value[SPH_DIAGNOSTIC_momentum_x] += m * w->u[i];
    value[SPH_DIAGNOSTIC_momentum_y] += m * w->v[i];
    value[SPH_DIAGNOSTIC_angular_momentum] += m * (w->x[i] * w->v[i] - w->y[i] * w->u[i]);
  }
}

static void sum_over_particles(const struct sph *s, double *value) {
  const struct sph_state *w = &s->f.w, *k = &s->f.k[0];
  for (size_t i = 0; i < s->f.n; i++) {
    value[SPH_DIAGNOSTIC_shaking] += k->u[i] * k->u[i] + k->v[i] * k->v[i];
    const double rho = eos_density(&s->eos, w->rho[i], w->y[i]);
    value[SPH_DIAGNOSTIC_compressed] += fabs(rho / s->rho0 - 1) > 0.01;
  }
  value[SPH_DIAGNOSTIC_compressed] /= (double)s->f.n;
}

static void find_noise(struct sph *s, double H, double g, double *value) {
  sum_over_particles(s, value);
  sph_pack_water(s);
  const struct noise state = noise_of(s);
  put_accelerations(s);
  const struct noise rates = noise_of(s);
  sph_pack_water(s);
  const double speed = sqrt(g * H), pressure = s->rho0 * g * H;
  value[SPH_DIAGNOSTIC_shaking] /= (double)s->f.n * g * g;
  value[SPH_DIAGNOSTIC_inner] = state.n / (double)s->f.n;
  value[SPH_DIAGNOSTIC_noise_u] = rms(state.u, state.n, speed);
  value[SPH_DIAGNOSTIC_noise_v] = rms(state.v, state.n, speed);
  value[SPH_DIAGNOSTIC_noise_p] = rms(state.p, state.n, pressure);
  value[SPH_DIAGNOSTIC_noise_ax] = rms(rates.u, rates.n, g);
  value[SPH_DIAGNOSTIC_noise_ay] = rms(rates.v, rates.n, g);
}

enum status sph_diagnose(struct sph *s, double H, double g, double value[SPH_DIAGNOSTIC_COUNT]) {
  for (int k = 0; k < SPH_DIAGNOSTIC_COUNT; k++) value[k] = 0;
  sum_momenta(s, value);
  if (s->scheme.diagnostics) find_noise(s, H, g, value);
  if (!s->scheme.forces) return OK;
  struct sph_forces f;
  TRY(sph_forces_find(s, &f));
  value[SPH_DIAGNOSTIC_force_x] = f.x;
  value[SPH_DIAGNOSTIC_force_y] = f.y;
  value[SPH_DIAGNOSTIC_moment] = f.moment;
  value[SPH_DIAGNOSTIC_force_left] = f.left;
  value[SPH_DIAGNOSTIC_force_right] = f.right;
  return OK;
}

enum status sph_diagnose_write(struct sph *s, const struct case_file *c, struct result *result) {
  const struct sph_scheme *o = &s->scheme;
  const size_t first = o->diagnostics ? 0 : SPH_DIAGNOSTIC_momentum_x;
  const size_t end = o->forces ? SPH_DIAGNOSTIC_COUNT : SPH_DIAGNOSTIC_force_x;
  double value[SPH_DIAGNOSTIC_COUNT];
  if (!o->diagnostics && !o->forces) return OK;
  TRY(sph_diagnose(s, c->H, c->g, value));
  return result_diagnostics(result, s->t, end - first, sph_diagnostics + first, value + first);
}

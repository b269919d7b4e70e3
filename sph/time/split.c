/* Sound by classic Runge-Kutta, then diffusion by its exponential: no bound on the time step from
 * diffusion.
 *
 * Stability. Let q be the vector of sqrt(m) u and sqrt(V) c0 (rho - rho0)/rho0, whose square is
 * twice the energy of sound. About a state of rest the pair of momentum `plus` and continuity
 * `divergence` is dq/dt = S q with S antisymmetric (rates.c), so that the classic method does not
 * increase |q| within its bound on the imaginary axis, the acoustic one. Diffusion with positions
 * and volumes as they are is dq/dt = -A q with A symmetric and, since its weights are positive, not
 * negative: its exponential, and the polynomial that stands for it (chebyshev.h), do not increase
 * |q|. So their product does not either, whatever the diffusion's strength.
 *
 * Accuracy. exp(dt S) exp(-dt A) is exp(-dt A/2) exp(dt S) exp(-dt A/2), which is of second order
 * (Strang), in other coordinates: the density at the end of a step differs from its by half a step
 * of diffusion, an error of first order that does not add up; frequencies and damping are right to
 * second order. */
#include <math.h>

#include "sph/pair/diffuse.h"
#include "sph/pair/diffusion.h"
#include "sph/pair/eos.h"
#include "sph/pair/rates.h"
#include "sph/time/chebyshev.h"
#include "sph/time/rk.h"

/* Densities less those at the start, by the Chebyshev recurrence; all [n]. */
struct terms {
  double *before, *now; /* of T_(k-1), T_k */
  double *sum;          /* of c T so far */
  double *rate;         /* of the density that T_k is */
};

static void advance(size_t n, double twice, double c, const struct terms *a) {
#pragma omp parallel for simd schedule(static)
  for (size_t i = 0; i < n; i++) {
    const double next = 2 * a->now[i] - a->before[i] + twice * a->rate[i];
    a->before[i] = a->now[i];
    a->now[i] = next;
    a->sum[i] += c * next;
  }
}

static void set_density(struct sph *s, const double *from, const double *more) {
#pragma omp parallel for simd schedule(static)
  for (size_t i = 0; i < s->f.n; i++) s->f.w.rho[i] = from[i] + more[i];
}

/* Elastic energy that the water has lost from the densities before, J/m: m p/rho^2 in the middle
 * times the change, an error of third order in a change that is some 1e-4. Added up in the order of
 * the clusters. */
static double energy_lost(struct sph *s, const double *before) {
  const struct eos *e = &s->eos;
  const size_t n_clusters = s->water_water.n_clusters;
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < n_clusters; c++) {
    double sum = 0;
    for (size_t i = c * SPH_LANES; i < (c + 1) * SPH_LANES && i < s->f.n; i++) {
      const double stored = (before[i] + s->f.w.rho[i]) / 2, y = s->f.w.y[i];
      const double rho = eos_density(e, stored, y);
      sum += s->f.m[i] * eos_pressure(e, eos_driving(e, stored, y), y) / (rho * rho) *
             (before[i] - s->f.w.rho[i]);
    }
    s->cluster_totals[c].diffusion = sum;
  }
  double lost = 0;
  for (size_t c = 0; c < n_clusters; c++) lost += s->cluster_totals[c].diffusion;
  return lost;
}

static enum status diffuse(struct sph *s, double dt, double *lost) {
  struct sph_particles *f = &s->f;
  double *start = f->w0.rho; /* of this step no more use */
  const struct terms a = {f->k[0].rho, f->k[1].rho, f->k[2].rho, f->k[3].rho};
  sph_pack_water(s);
  const double Z = dt * sph_diffuse(s, a.rate);
  const struct sph_chebyshev p = sph_chebyshev_of(Z);
  CHECK(p.degree <= SPH_CHEBYSHEV_MOST, ERR_DIVERGED,
        "a step of %g s at t = %g s is %.3g times as long as the fastest decay by diffusion, more "
        "than can be followed: lower delta",
        dt, s->t, Z);
  const double step = 2 * dt / p.Z;
#pragma omp parallel for simd schedule(static)
  for (size_t i = 0; i < f->n; i++) {
    start[i] = f->w.rho[i];
    a.before[i] = 0;
    a.now[i] = step * a.rate[i];
    a.sum[i] = p.c[1] * a.now[i];
  }
  for (int k = 2; k <= p.degree; k++) {
    set_density(s, start, a.now);
    sph_pack_pressure(s);
    sph_diffuse(s, a.rate);
    advance(f->n, 2 * step, p.c[k], &a);
  }
  set_density(s, start, a.sum);
  sph_particles_pad(f);
  *lost = energy_lost(s, start);
  return OK;
}

static enum status split_step(struct sph *s, const struct sph_integrator *method, double dt,
                              struct sph_totals *spent, bool *held) {
  double lost = 0;
  TRY(sph_rk_step(s, method, dt, spent, held));
  if (!*held || s->scheme.delta == 0 || s->scheme.diffusion == SPH_DIFFUSION_none) return OK;
  *held = sph_lists_hold(s, dt);
  if (*held) TRY(diffuse(s, dt, &lost));
  spent->diffusion += lost;
  return OK;
}

const struct sph_integrator sph_rk4_split = {.order = 1,
                                             .evaluations = 4,
                                             .split = true,
                                             .acoustic = 1,
                                             .diffusive = INFINITY,
                                             .table = &sph_rk_classic,
                                             .step = split_step};

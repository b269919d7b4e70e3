/* Sound by classic Runge-Kutta, then diffusion by a stabilised method: no bound on the time step
 * from diffusion.
 *
 * Stability. Let q be the vector of sqrt(m) u and sqrt(V) c0 (rho - rho0)/rho0, whose square is
 * twice the energy of sound. About a state of rest the pair of momentum `plus` and continuity
 * `divergence` is dq/dt = S q with S antisymmetric (rates.h), so that the classic method does not
 * increase |q| within its bound on the imaginary axis, the acoustic one. Diffusion with positions
 * and volumes as they are is dq/dt = -A q with A symmetric and, since its weights are positive, not
 * negative: the Chebyshev method does not increase |q| with enough stages. So their product does
 * not either, whatever the diffusion's strength.
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

/* The densities of a stage, from those and the rates of the stages before; all [n]. */
struct stage {
  double *y0, *before, *now; /* y_0, y_(j-2), y_(j-1) */
  const double *f0, *f;      /* rates of y_0 and y_(j-1) */
};

static void advance(size_t n, const struct sph_chebyshev *c, int j, double dt,
                    const struct stage *a) {
  const double mu = c->mu[j], nu = c->nu[j], mu1 = dt * c->mu1[j], gamma1 = dt * c->gamma1[j];
#pragma omp parallel for simd schedule(static)
  for (size_t i = 0; i < n; i++) {
    const double y0 = a->y0[i], now = a->now[i]; /* differences from y_0: less rounding */
    const double next =
        mu * (now - y0) + nu * (a->before[i] - y0) + mu1 * a->f[i] + gamma1 * a->f0[i];
    a->before[i] = now;
    a->now[i] = y0 + next;
  }
}

/* Elastic energy that the water has lost from the densities before, J/m: m p/rho^2 in the middle
 * times the change, an error of third order in a change that is some 1e-4. Added up in the order of
 * the clusters. */
static double energy_lost(struct sph *s, const double *before) {
  const enum sph_eos eos = (enum sph_eos)s->scheme.eos;
  const size_t n_clusters = s->water_water.n_clusters;
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < n_clusters; c++) {
    double sum = 0;
    for (size_t i = c * SPH_LANES; i < (c + 1) * SPH_LANES && i < s->f.n; i++) {
      const double rho = (before[i] + s->f.w.rho[i]) / 2;
      sum += s->f.m[i] * eos_pressure(eos, s->rho0, s->c0, rho) / (rho * rho) *
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
  const struct stage a = {f->k[0].rho, f->k[3].rho, f->w.rho, f->k[1].rho, f->k[2].rho};
  sph_pack_water(s);
  const int stages = sph_chebyshev_stages(dt * sph_diffuse(s, f->k[1].rho));
  CHECK(stages <= SPH_CHEBYSHEV_MOST, ERR_DIVERGED,
        "diffusion would need %d stages in a step of %g s at t = %g s: lower delta", stages, dt,
        s->t);
  const struct sph_chebyshev c = sph_chebyshev_of(stages);
#pragma omp parallel for simd schedule(static)
  for (size_t i = 0; i < f->n; i++) {
    a.y0[i] = a.before[i] = a.now[i];
    a.now[i] += c.mu1[1] * dt * a.f0[i];
  }
  for (int j = 2; j <= c.stages; j++) {
    sph_pack_pressure(s);
    sph_diffuse(s, f->k[2].rho);
    advance(f->n, &c, j, dt, &a);
  }
  sph_particles_pad(f);
  *lost = energy_lost(s, a.y0);
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

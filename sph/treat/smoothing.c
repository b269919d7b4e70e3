/* The smoothing of mSPH (thesis, eqs. (4.51) to (4.55)): velocities and density become their
 * Shepard means over water and walls, all at once (Jacobi), and positions stay.
 *
 * A wave keeps S(k) of its amplitude, exp(-(kh)^2/4) with the Gaussian kernel: the same as a
 * viscosity, and diffusion, of (h^2/4) c0/(n mu h), mu = c0 dt/h, for n steps between. Waves of
 * potential flow keep theirs in the interior, since harmonic functions are their own means; beside
 * a free surface the mean is that of the deeper water, which lifts water at rest; the excess over
 * the hydrostatic density does not. */
#include <math.h>
#include <stdlib.h>

#include "sph/fluid/clusters.h"
#include "sph/pair/sums.h"
#include "sph/theory/lattice.h"
#include "sph/treat/treat.h"

/* What a smoothing diffuses, over the time since the last one, in c0 dx, where noise of the thesis'
 * dam break is least: its symbol is 1 - 0.158 (kh)^2, h = dx/0.75, and the least is at n = 5 for
 * c0 dt/h = 0.8, at n = 9 for 0.5. */
static const double best_diffusivity = 0.158 / 4.25 / 0.75;

/* The time between smoothings, s: half the kernel's second moment over the diffusivity. */
static enum status smooth_create(struct sph *s, void **own) {
  double *interval;
  TRY(sph_allocate(1, sizeof *interval, &interval));
  const double moment = sph_kernel_moment((enum sph_kernel)s->scheme.kernel, 2, 0) * s->h * s->h;
  *interval = moment / 2 / (best_diffusivity * s->c0 * s->dx);
  *own = interval;
  return OK;
}

/* When a multiple of the time has passed in the last step: often enough whatever the step. */
static bool smooth_due(const struct sph *s) {
  const double *interval = s->treated[SPH_TREATMENT_smoothing];
  return floor(s->t / *interval) > floor((s->t - s->dt) / *interval);
}

/* What is added to densities before they are smoothed, per metre of height, kg m^-4: those of water
 * at rest are then the same everywhere, as `split` has them. */
static double gradient_added(const struct sph *s) {
  switch ((enum sph_smoothed)s->scheme.smoothing_of) {
  case SPH_SMOOTHED_density:
    return 0;
  case SPH_SMOOTHED_excess:
    return s->rho0 * s->g / (s->c0 * s->c0) + eos_density_rises(&s->eos);
  }
  __builtin_unreachable();
}

static void cluster_smooth(struct sph *s, size_t cluster, const void *wanted) {
  const double gradient = *(const double *)wanted;
  const struct sph_fit_sums a = sph_sums_around(s, cluster, SPH_OF_WATER | SPH_OF_WALLS);
  const struct sph_state *w = &s->f.w;
  for (size_t l = 0; l < SPH_LANES; l++) {
    const double per_w = 1 / a.w[l];
    const size_t i = cluster * SPH_LANES + l;
    w->u[i] = a.u[l] * per_w;
    w->v[i] = a.v[l] * per_w;
    /* y counted from the particle, in h */
    w->rho[i] = (a.p[l] + gradient * s->h * a.y[l]) * per_w;
  }
}

static enum status smooth(struct sph *s) {
  const double gradient = gradient_added(s);
  sph_sums_carry_density(s);
  sph_each_cluster(s, cluster_smooth, &gradient);
  return OK;
}

const struct sph_treatment sph_treatment_smoothing = {
    .create = smooth_create, .destroy = free, .due = smooth_due, .apply = smooth};

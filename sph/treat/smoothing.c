/* The smoothing of mSPH (thesis, eqs. (4.51) to (4.55)): velocities and density become their
 * Shepard means over water and walls, all at once (Jacobi), and positions stay.
 *
 * A wave keeps S(k) of its amplitude, exp(-(kh)^2/4) with the Gaussian kernel: the same as a
 * viscosity, and diffusion, of (h^2/4) c0/(n mu h), mu = c0 dt/h, for n steps between. Waves of
 * potential flow keep theirs in the interior, since harmonic functions are their own means; beside
 * a free surface the mean is that of the deeper water, which lifts water at rest; the excess over
 * the hydrostatic density does not. */
#include "sph/treat/sums.h"
#include "sph/treat/treat.h"

/* What is added to densities before they are smoothed, per metre of height, kg m^-4. */
static double gradient_added(const struct sph *s) {
  switch ((enum sph_smoothed)s->scheme.smoothing_of) {
  case SPH_SMOOTHED_density:
    return 0;
  case SPH_SMOOTHED_excess:
    return s->rho0 * s->g / (s->c0 * s->c0);
  }
  __builtin_unreachable();
}

static void cluster_smooth(struct sph *s, size_t cluster, double gradient) {
  const struct sph_fit_sums a = sph_treat_sums(s, cluster, SPH_TREAT_WATER | SPH_TREAT_WALLS);
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

static void smooth(struct sph *s) {
  const double gradient = gradient_added(s);
  sph_treat_carry_density(s);
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < s->water_water.n_clusters; c++) cluster_smooth(s, c, gradient);
}

const struct sph_treatment sph_treatment_smoothing = {.apply = smooth};

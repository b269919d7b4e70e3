/* Re-initialisations of the density by moving least squares of first order: the value, at each
 * particle, of the plane fitted to its neighbours, itself included. Two operators, which the thesis
 * does not tell apart (3.4.6.2):
 *
 *   mls_volume (Colagrossi & Landrini, J. Comput. Phys. 191, 2003): the plane through the
 *     densities, weighted with V W. Any linear density stays, with any neighbours; a wave loses the
 *     same as by Shepard's mean.
 *   mls_mass (the thesis' analysis, eq. (3.63)): masses weighted with W alone, over the volume that
 *     each had at first; that is the plane through the densities that the neighbours started with,
 *     so that what compression and expansion did since is forgotten, gradients included.
 *
 * Where neighbours do not span the plane (spray) the fit fades into the mean, as that of the ghosts
 * does (domain/mls.h). */
#include <stdlib.h>

#include "sph/fluid/clusters.h"
#include "sph/pair/moments.h"
#include "sph/pair/sums.h"
#include "sph/treat/treat.h"

static const double smallest_spread = 0.05; /* h^2 */

/* Of the pressures, at the particle itself. */
static double plane_at_origin(const struct sph_fit_sums *a, int l) {
  const double per_w = 1 / a->w[l];
  const double x = a->x[l] * per_w, y = a->y[l] * per_w, p = a->p[l] * per_w;
  double px, py;
  moments_solve(a->xx[l] * per_w - x * x, a->xy[l] * per_w - x * y, a->yy[l] * per_w - y * y,
                smallest_spread, a->px[l] * per_w - p * x, a->py[l] * per_w - p * y, &px, &py);
  return p - (px * x + py * y);
}

static void cluster_fit(struct sph *s, size_t cluster, const void *wanted) {
  const struct sph_fit_sums a = sph_sums_around(s, cluster, *(const unsigned *)wanted);
  for (int l = 0; l < SPH_LANES; l++)
    s->f.w.rho[cluster * SPH_LANES + (size_t)l] = plane_at_origin(&a, l);
}

static void fit_densities(struct sph *s, unsigned sources) {
  sph_each_cluster(s, cluster_fit, &sources);
}

static enum status volume_apply(struct sph *s) {
  sph_sums_carry_density(s);
  fit_densities(s, SPH_OF_WATER | SPH_OF_WALLS);
  return OK;
}

/* The densities at the start, kg m^-3, by the particles' numbers. */
static enum status mass_create(struct sph *s, void **own) {
  double *rho;
  TRY(sph_allocate(s->f.n, sizeof *rho, &rho));
  for (size_t i = 0; i < s->f.n; i++) rho[s->f.id[i]] = s->f.w.rho[i];
  *own = rho;
  return OK;
}

/* Wall particles have no first density, and a plane needs none of them. */
static enum status mass_apply(struct sph *s) {
  const double *rho = s->treated[SPH_TREATMENT_mls_mass];
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < s->f.n; i++) {
    s->pack[i].V = s->dx * s->dx;
    s->pack[i].p = rho[s->f.id[i]];
  }
  sph_period_fill(s);
  fit_densities(s, SPH_OF_WATER);
  return OK;
}

const struct sph_treatment sph_treatment_mls_volume = {.apply = volume_apply, .redensify = true};
const struct sph_treatment sph_treatment_mls_mass = {
    .create = mass_create, .destroy = free, .apply = mass_apply, .redensify = true};

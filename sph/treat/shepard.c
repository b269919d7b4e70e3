/* Re-initialisation of the density by Shepard's mean, sum m W / sum V W (thesis, eq. (3.60)): that
 * of rho, weighted by V W. A wave loses the part 1 - exp(-(kh)^2/4) of its amplitude each time with
 * the Gaussian kernel; beside a free surface the mean is that of the deeper water, so that water at
 * rest is lifted each time. */
#include "sph/fluid/clusters.h"
#include "sph/pair/sums.h"
#include "sph/treat/treat.h"

static void cluster_mean(struct sph *s, size_t cluster, const void *wanted) {
  (void)wanted;
  const struct sph_fit_sums a = sph_sums_around(s, cluster, SPH_OF_WATER | SPH_OF_WALLS);
  for (int l = 0; l < SPH_LANES; l++) s->f.w.rho[cluster * SPH_LANES + (size_t)l] = a.p[l] / a.w[l];
}

static enum status shepard(struct sph *s) {
  sph_sums_carry_density(s);
  sph_each_cluster(s, cluster_mean, NULL);
  return OK;
}

const struct sph_treatment sph_treatment_shepard = {.apply = shepard, .redensify = true};

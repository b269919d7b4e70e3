#include "sph/pair/diffuse.h"

#include <math.h>

#include "sph/hot.h"
#include "sph/pair/loops.h"

/* What the cut at the edge of a support may add to the bound (diffusion_weight): the Gaussian's
 * leaves a transform of -1e-5 of its largest value. */
static const double margin = 1.01;

static double cluster_diffusion(struct sph *s, size_t cluster, double *D) {
  const size_t at = cluster * SPH_LANES;
  const struct sph_targets i = sph_targets_of(s, cluster);
  const struct sph_near water = sph_near_of(&s->water_water, cluster, s->pack);
  struct sph_diffusion_sums a;
  sph_loops_of(&s->scheme)->diffusion(s, &i, &water, &a);
  const double per_time =
      2 * s->scheme.delta * s->c0 / s->h * kernel_slope_scale((enum sph_kernel)s->scheme.kernel);
  double most = 0;
  for (size_t l = 0; l < SPH_LANES; l++) {
    D[at + l] = per_time * s->rho0 * a.D[l];
    most = larger(per_time * a.weight[l], most);
  }
  return most;
}

double sph_diffuse(struct sph *s, double *D) {
  if (s->stand_in) return s->stand_in->diffuse(s, D);
  double most = 0;
#pragma omp parallel for schedule(static) reduction(max : most)
  for (size_t c = 0; c < s->water_water.n_clusters; c++)
    most = larger(cluster_diffusion(s, c, D), most);
  return margin * most;
}

#include "sph/pair/diffuse.h"

#include <math.h>

#include "sph/fluid/clusters.h"
#include "sph/hot.h"
#include "sph/pair/loops.h"

/* What the cut at the edge of a support may add to the bound (diffusion_weight): the Gaussian's
 * leaves a transform of -1e-5 of its largest value. */
static const double margin = 1.01;

/* What is asked for: D (kg m^-3 s^-1), and for every cluster the most that it decays by, 1/s. */
struct diffusion {
  double *D, *most;
};

static void cluster_diffusion(struct sph *s, size_t cluster, const void *wanted) {
  const struct diffusion *into = wanted;
  const size_t at = cluster * SPH_LANES;
  const struct sph_targets i = sph_targets_of(s, cluster);
  const struct sph_near water = sph_near_of(&s->water_water, cluster, s->pack);
  struct sph_diffusion_sums a;
  sph_loops_for(s, &i)->diffusion(s, &i, &water, &a);
  const double per_time =
      2 * s->scheme.delta * s->c0 / s->h * kernel_slope_scale((enum sph_kernel)s->scheme.kernel);
  double most = 0;
  for (size_t l = 0; l < SPH_LANES; l++) {
    into->D[at + l] = per_time * s->rho0 * a.D[l];
    most = larger(per_time * a.weight[l], most);
  }
  into->most[cluster] = most;
}

double sph_diffuse(struct sph *s, double *D) {
  if (s->stand_in) return s->stand_in->diffuse(s, D);
  const struct diffusion into = {D, s->f.scratch};
  sph_each_cluster(s, cluster_diffusion, &into);
  double most = 0;
  for (size_t c = 0; c < s->water_water.n_clusters; c++) most = larger(into.most[c], most);
  return margin * most;
}

#include "sph/pair/gradient.h"

#include "sph/fluid/clusters.h"
#include "sph/pair/loops.h"
#include "sph/pair/moments.h"

static const double smallest_eigenvalue = 0.1;

static void cluster_gradient(struct sph *s, size_t cluster, const void *wanted) {
  (void)wanted;
  const struct sph_targets i = sph_targets_of(s, cluster);
  const struct sph_loops *loops = sph_loops_for(s, &i);
  const struct sph_near water = sph_near_of(&s->water_water, cluster, s->pack);
  struct sph_gradient_sums a, b = {0};
  loops->gradient(s, &i, &water, &a);
  const struct sph_near walls = sph_near_walls(s, cluster);
  if (walls.n) loops->gradient(s, &i, &walls, &b);

  const double F = kernel_slope_scale((enum sph_kernel)s->scheme.kernel);
  const double pressure = F * s->rho0 * s->c0 * s->c0 / s->h;
  struct sph_vector *G = s->G + cluster * SPH_LANES;
  for (int l = 0; l < SPH_LANES; l++)
    moments_solve(F * (a.xx[l] + b.xx[l]), F * (a.xy[l] + b.xy[l]), F * (a.yy[l] + b.yy[l]),
                  smallest_eigenvalue, pressure * (a.x[l] + b.x[l]), pressure * (a.y[l] + b.y[l]),
                  &G[l].x, &G[l].y);
}

void sph_gradient(struct sph *s) {
  sph_each_cluster(s, cluster_gradient, NULL);
  sph_period_fill_gradients(s);
}

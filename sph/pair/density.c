#include "sph/pair/density.h"
#include "sph/domain/wall.h"

#include "sph/fluid/clusters.h"
#include "sph/pair/continuity.h"
#include "sph/pair/rates.h"
#include "sph/pair/sums.h"

static void cluster_density(struct sph *s, size_t cluster, const void *wanted) {
  const bool over_volumes = *(const bool *)wanted;
  const double scale = kernel_value_scale((enum sph_kernel)s->scheme.kernel);
  const struct sph_fit_sums a = sph_sums_around(s, cluster, SPH_OF_WATER | SPH_OF_WALLS);
  for (size_t l = 0; l < SPH_LANES; l++)
    s->f.w.rho[cluster * SPH_LANES + l] = over_volumes ? a.p[l] / a.w[l] : scale * a.p[l];
}

/* sum m_j W_ij, or that over sum V_j W_ij. */
static void sum_masses(struct sph *s, bool over_volumes) {
  sph_sums_carry_density(s);
  sph_each_cluster(s, cluster_density, &over_volumes);
}

/* Shepard's quotient takes its volumes from the sums: with those of a quotient before, it would be
 * one whatever the compression. */
void sph_density_sum(struct sph *s) {
  sum_masses(s, false);
  if (!continuity_divides((enum sph_continuity)s->scheme.continuity)) return;
  sph_pack_water(s);
  sph_wall_fill(s);
  sum_masses(s, true);
}

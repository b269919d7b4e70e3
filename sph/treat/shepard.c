/* Re-initialisation of the pressure by Shepard's mean (thesis, eq. (3.60), where it is that of the
 * density: the two are one while the equation of state is linear). A wave loses the part 1 -
 * exp(-(kh)^2/4) of its amplitude each time with the Gaussian kernel; beside a free surface the
 * mean is that of the deeper water, so that water at rest is lifted each time. */
#include "sph/pair/eos.h"
#include "sph/pair/loops.h"
#include "sph/treat/treat.h"

/* The sums of one kind of neighbours: the fit's pressures are counted from the first (loops.h). */
static void add(const struct sph *s, const struct sph_targets *i, const struct sph_near *near,
                double w[SPH_LANES], double wp[SPH_LANES]) {
  if (!near->n) return;
  struct sph_fit_sums a;
  sph_loops_of(&s->scheme)->fit(s, i, near, &a);
  const double unit = s->rho0 * s->c0 * s->c0, first = near->pack[near->list[0]].p;
  for (int l = 0; l < SPH_LANES; l++) {
    w[l] += a.w[l];
    wp[l] += a.w[l] * first + a.p[l] * unit;
  }
}

static void cluster_mean(struct sph *s, size_t cluster) {
  const struct sph_targets i = sph_targets_of(s, cluster);
  const struct sph_near water = sph_near_of(&s->water_water, cluster, s->pack);
  struct sph_lip lip;
  const struct sph_near walls = sph_near_walls(s, cluster, &lip);
  double w[SPH_LANES] = {0}, wp[SPH_LANES] = {0};
  add(s, &i, &water, w, wp);
  add(s, &i, &walls, w, wp);
  const enum sph_eos eos = (enum sph_eos)s->scheme.eos;
  for (int l = 0; l < SPH_LANES; l++)
    s->f.w.rho[cluster * SPH_LANES + (size_t)l] = eos_density(eos, s->rho0, s->c0, wp[l] / w[l]);
}

void sph_treat_shepard(struct sph *s) {
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < s->water_water.n_clusters; c++) cluster_mean(s, c);
}

#include "sph/treat/sums.h"

/* The sums of one kind of neighbours: the loop counts velocities and pressures from the first. */
static void add(const struct sph *s, const struct sph_targets *i, const struct sph_near *near,
                struct sph_fit_sums *sums) {
  if (!near->n) return;
  struct sph_fit_sums a;
  sph_loops_of(&s->scheme)->fit(s, i, near, &a);
  const struct sph_pack *first = &near->pack[near->list[0]];
  const double pressure = s->rho0 * s->c0 * s->c0;
  for (int l = 0; l < SPH_LANES; l++) {
    sums->w[l] += a.w[l];
    sums->x[l] += a.x[l];
    sums->y[l] += a.y[l];
    sums->xx[l] += a.xx[l];
    sums->xy[l] += a.xy[l];
    sums->yy[l] += a.yy[l];
    sums->p[l] += a.w[l] * first->p + a.p[l] * pressure;
    sums->px[l] += a.x[l] * first->p + a.px[l] * pressure;
    sums->py[l] += a.y[l] * first->p + a.py[l] * pressure;
    sums->u[l] += a.w[l] * first->u + a.u[l] * s->c0;
    sums->v[l] += a.w[l] * first->v + a.v[l] * s->c0;
  }
}

struct sph_fit_sums sph_treat_sums(const struct sph *s, size_t cluster, unsigned sources) {
  const struct sph_targets i = sph_targets_of(s, cluster);
  const struct sph_near water = sph_near_of(&s->water_water, cluster, s->pack);
  struct sph_lip lip;
  const struct sph_near walls = sph_near_walls(s, cluster, &lip);
  struct sph_fit_sums sums = {0};
  if (sources & SPH_TREAT_WATER) add(s, &i, &water, &sums);
  if (sources & SPH_TREAT_WALLS) add(s, &i, &walls, &sums);
  return sums;
}

void sph_treat_carry_density(struct sph *s) {
#pragma omp parallel
  {
#pragma omp for schedule(static) nowait
    for (size_t i = 0; i < s->f.n; i++) s->pack[i].p = s->f.w.rho[i];
#pragma omp for schedule(static)
    for (size_t k = 0; k < s->w.n; k++) s->w.pack[k].p = s->w.pack[k].rho;
  }
  sph_period_fill(s);
}

#include "sph/pair/sums.h"

/* The loop counts velocities and pressures from the first source. */
void sph_sums_add(const struct sph *s, sph_fit_loop *fit, bool from_targets,
                  const struct sph_targets *i, const struct sph_near *near,
                  struct sph_fit_sums *sums) {
  if (!near->n) return;
  struct sph_fit_sums a;
  fit(s, i, near, &a);
  const struct sph_pack *first = &near->pack[near->list[0]];
  const double pressure = s->rho0 * s->c0 * s->c0;
  for (int l = 0; l < SPH_LANES; l++) {
    const double p = first->p - (from_targets ? i->p[l] : 0);
    const double u = first->u - (from_targets ? i->u[l] : 0);
    const double v = first->v - (from_targets ? i->v[l] : 0);
    sums->w[l] += a.w[l];
    sums->x[l] += a.x[l];
    sums->y[l] += a.y[l];
    sums->xx[l] += a.xx[l];
    sums->xy[l] += a.xy[l];
    sums->yy[l] += a.yy[l];
    sums->p[l] += a.w[l] * p + a.p[l] * pressure;
    sums->px[l] += a.x[l] * p + a.px[l] * pressure;
    sums->py[l] += a.y[l] * p + a.py[l] * pressure;
    sums->u[l] += a.w[l] * u + a.u[l] * s->c0;
    sums->ux[l] += a.x[l] * u + a.ux[l] * s->c0;
    sums->uy[l] += a.y[l] * u + a.uy[l] * s->c0;
    sums->v[l] += a.w[l] * v + a.v[l] * s->c0;
    sums->vx[l] += a.x[l] * v + a.vx[l] * s->c0;
    sums->vy[l] += a.y[l] * v + a.vy[l] * s->c0;
  }
}

struct sph_fit_sums sph_sums_around(const struct sph *s, size_t cluster, unsigned of) {
  const struct sph_targets i = sph_targets_of(s, cluster);
  sph_fit_loop *fit = sph_loops_for(s, &i)->fit;
  const struct sph_near water = sph_near_of(&s->water_water, cluster, s->pack);
  const struct sph_near walls = sph_near_walls(s, cluster);
  struct sph_fit_sums sums = {0};
  if (of & SPH_OF_WATER) sph_sums_add(s, fit, false, &i, &water, &sums);
  if (of & SPH_OF_WALLS) sph_sums_add(s, fit, false, &i, &walls, &sums);
  return sums;
}

void sph_sums_carry_density(struct sph *s) {
#pragma omp parallel
  {
#pragma omp for schedule(static) nowait
    for (size_t i = 0; i < s->f.n; i++) s->pack[i].p = s->f.w.rho[i];
#pragma omp for schedule(static)
    for (size_t k = 0; k < s->w.n; k++) s->w.pack[k].p = s->w.pack[k].rho;
  }
  sph_period_fill(s);
}

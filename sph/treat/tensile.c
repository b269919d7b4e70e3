/* Correction of the tensile instability (Monaghan, J. Comput. Phys. 159, 2000; thesis, eq. (3.57)):
 * the pressure force of two particles under tension is 1 - tensile f^n of itself, f = W_ij/W(dx),
 * n = tensile_power. Sound in water under tension is then slower: in one dimension with h = dx by
 * sqrt(1 - tensile). The thesis has W(h) for W(dx), which is the same there only.
 *
 * Like the pressure force it acts along pairs, or as it does, with the same on both; all its power
 * is booked, since the continuity equation does not have it. */
#include "sph/pair/kernel.h"
#include "sph/treat/loops.h"
#include "sph/treat/treat.h"

static void relax(struct sph *s, int stage, size_t cluster, struct sph_totals *totals) {
  const struct sph_targets i = sph_targets_of(s, cluster);
  const struct sph_treat_loops *loops = sph_treat_loops_for(s, &i);
  const struct sph_near water = sph_near_of(&s->water_water, cluster, s->pack);
  const struct sph_near walls = sph_near_walls(s, cluster);
  struct sph_vector_sums a, b = {0};
  loops->tension(s, &i, &water, &a);
  if (walls.n) loops->tension(s, &i, &walls, &b);

  const struct sph_state *k = &s->f.k[stage];
  const double F = kernel_slope_scale((enum sph_kernel)s->scheme.kernel);
  const double force =
      s->scheme.strength[SPH_CORRECTION_tensile] * F * s->rho0 * s->c0 * s->c0 / s->h;
  for (size_t l = 0, at = cluster * SPH_LANES; l < SPH_LANES; l++, at++) {
    const double ax = force / s->f.w.rho[at] * (a.x[l] + b.x[l]);
    const double ay = force / s->f.w.rho[at] * (a.y[l] + b.y[l]);
    k->u[at] += ax;
    k->v[at] += ay;
    totals->tensile -= s->f.m[at] * (i.u[l] * ax + i.v[l] * ay);
  }
}

const struct sph_correction sph_correction_tensile = {.rates = relax};

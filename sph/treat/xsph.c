/* XSPH (Monaghan, J. Comput. Phys. 82, 1989; thesis, 3.4.1): particles move with the velocity
 *
 *   dr_i/dt = u_i + xsph sum_j (u_j - u_i) 2 m_j/(rho_i + rho_j) W_ij
 *
 * while momentum and continuity keep u. A wave of velocity moves particles 1 + xsph (S - 1) times
 * as much, S(k) the kernel's symbol: waves of sound with the density of positions go slower by the
 * root of that, which is positive for any S >= 0 while xsph <= 1.
 *
 * The sum has no mean over the water, and takes energy only where it lifts or lowers particles,
 * whose density, too, depends on their height with `eos: split`. */
#include "sph/pair/kernel.h"
#include "sph/treat/loops.h"
#include "sph/treat/treat.h"

/* Of what is moved with (u, v), W/kg. */
static double work_of_pull(const struct flow_pull *p, double x, double y, double u, double v) {
  return p->rate * p->rate * (u * (x - p->x) + v * (y - p->y));
}

static void mix(struct sph *s, int stage, size_t cluster, struct sph_totals *totals) {
  const struct sph_targets i = sph_targets_of(s, cluster);
  const struct sph_treat_loops *loops = sph_treat_loops_for(s, &i);
  const struct sph_near water = sph_near_of(&s->water_water, cluster, s->pack);
  const struct sph_near walls = sph_near_walls(s, cluster);
  struct sph_vector_sums a, b = {0};
  loops->mix(s, &i, &water, &a);
  if (walls.n) loops->mix(s, &i, &walls, &b);

  const double W = s->scheme.strength[SPH_CORRECTION_xsph] *
                   kernel_value_scale((enum sph_kernel)s->scheme.kernel) * s->c0;
  const struct sph_state *k = &s->f.k[stage];
  for (size_t l = 0, at = cluster * SPH_LANES; l < SPH_LANES; l++, at++) {
    const double u = W * (a.x[l] + b.x[l]), v = W * (a.y[l] + b.y[l]);
    k->x[at] += u;
    k->y[at] += v;
    const double lift = eos_lift(&s->eos, s->f.p[at], s->f.w.rho[at], s->f.w.y[at]);
    totals->xsph -= s->f.m[at] * ((lift - s->force.g[1]) * v - s->force.g[0] * u);
    if (s->pull.rate > 0) totals->xsph -= s->f.m[at] * work_of_pull(&s->pull, i.x[l], i.y[l], u, v);
  }
}

const struct sph_correction sph_correction_xsph = {.rates = mix};

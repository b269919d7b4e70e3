/* Particle shifting of delta-plus-SPH (Sun, Colagrossi, Marrone & Zhang, Comput. Methods Appl.
 * Mech. Engrg. 315, 2017): particles move by
 *
 *   dr_i = -(U dt/h) (2h)^2 sum_j (1 + 0.2 (W_ij/W(dx))^4) grad_i W_ij m_j/(rho_i + rho_j)
 *
 * from where they crowd to where they miss; velocities and densities stay. U dt/h, U the largest
 * speed in the water now, is the paper's CFL Ma, whose U is the largest that is expected. Pairs
 * move their centre of mass nowhere.
 *
 * Near the surface the sum would throw particles out. There it is known by the smallest eigenvalue
 * lambda of sum_j r_ji (x) grad_i W_ij V_j, which is 1 in full supports: from 0.4 to 0.75 particles
 * move along the surface only, its normal being grad lambda; below, in spray, not at all. Walls are
 * as full as the water, and left out of the normal, which needs no full support. */
#include <math.h>

#include "sph/domain/wall.h"
#include "sph/fluid/clusters.h"
#include "sph/pair/kernel.h"
#include "sph/pair/moments.h"
#include "sph/treat/loops.h"
#include "sph/treat/treat.h"

static const double crowding = 0.2, spray = 0.4, inside = 0.75;
static const double smallest_eigenvalue = 0.1; /* of the moments that the normal is found with */

/* A cluster's sums of one loop: over the water and, of the moments alone, the walls. */
static struct sph_gradient_sums moments_of(const struct sph *s, const struct sph_targets *i,
                                           size_t cluster, bool walls_too) {
  const struct sph_loops *loops = sph_loops_for(s, i);
  const struct sph_near water = sph_near_of(&s->water_water, cluster, s->pack);
  struct sph_gradient_sums a, b;
  loops->gradient(s, i, &water, &a);
  const struct sph_near walls = sph_near_walls(s, cluster);
  if (!walls_too || !walls.n) return a;
  loops->gradient(s, i, &walls, &b);
  for (int l = 0; l < SPH_LANES; l++) {
    a.xx[l] += b.xx[l];
    a.xy[l] += b.xy[l];
    a.yy[l] += b.yy[l];
  }
  return a;
}

/* The eigenvalues, into the place of the pressures. */
static void cluster_eigenvalues(struct sph *s, size_t cluster, const void *wanted) {
  (void)wanted;
  const double F = kernel_slope_scale((enum sph_kernel)s->scheme.kernel);
  const struct sph_targets i = sph_targets_of(s, cluster);
  const struct sph_gradient_sums a = moments_of(s, &i, cluster, true);
  for (size_t l = 0; l < SPH_LANES; l++) {
    const double half = 0.5 * (a.xx[l] + a.yy[l]), d = 0.5 * (a.xx[l] - a.yy[l]);
    s->f.p[cluster * SPH_LANES + l] = F * (half - sqrt(d * d + a.xy[l] * a.xy[l]));
  }
}

/* Gradients of the eigenvalues; any length. */
static void normals_of(const struct sph *s, size_t cluster, double nx[SPH_LANES],
                       double ny[SPH_LANES]) {
  const double F = kernel_slope_scale((enum sph_kernel)s->scheme.kernel);
  const struct sph_targets i = sph_targets_of(s, cluster);
  const struct sph_gradient_sums a = moments_of(s, &i, cluster, false);
  for (size_t l = 0; l < SPH_LANES; l++)
    moments_solve(F * a.xx[l], F * a.xy[l], F * a.yy[l], smallest_eigenvalue, a.x[l], a.y[l],
                  &nx[l], &ny[l]);
}

/* The part of (x, y) along a surface with the normal n. */
static void keep_along(double nx, double ny, double *x, double *y) {
  const double n2 = nx * nx + ny * ny;
  if (!(n2 > 0)) return;
  const double out = (*x * nx + *y * ny) / n2;
  *x -= out * nx;
  *y -= out * ny;
}

static void shift_cluster(struct sph *s, size_t cluster, const void *wanted) {
  const double factor = *(const double *)wanted;
  const struct sph_targets i = sph_targets_of(s, cluster);
  const struct sph_treat_loops *loops = sph_treat_loops_for(s, &i);
  const struct sph_near water = sph_near_of(&s->water_water, cluster, s->pack);
  const struct sph_near walls = sph_near_walls(s, cluster);
  struct sph_vector_sums a, b = {0};
  loops->crowd(s, crowding, &i, &water, &a);
  if (walls.n) loops->crowd(s, crowding, &i, &walls, &b);
  double nx[SPH_LANES], ny[SPH_LANES];
  normals_of(s, cluster, nx, ny);

  for (size_t l = 0, at = cluster * SPH_LANES; l < SPH_LANES; l++, at++) {
    double x = -factor * (a.x[l] + b.x[l]), y = -factor * (a.y[l] + b.y[l]);
    if (s->f.p[at] < spray) continue;
    if (s->f.p[at] <= inside) keep_along(nx[l], ny[l], &x, &y);
    const double X = i.x[l] + x, Y = i.y[l] + y;
    if (sph_wall_stops(s, at, X, Y)) continue;
    s->f.w.x[at] = X;
    s->f.w.y[at] = Y;
  }
}

static double largest_speed(const struct sph *s) {
  double most2 = 0;
#pragma omp parallel for simd schedule(static) reduction(max : most2)
  for (size_t i = 0; i < s->f.n; i++) {
    const double u = s->f.w.u[i], v = s->f.w.v[i], speed2 = u * u + v * v;
    most2 = speed2 > most2 ? speed2 : most2;
  }
  return sqrt(most2);
}

/* In the sums grad_i W V is slope (r_j - r_i) V/h, and V_ij twice m_j/(rho_i + rho_j). */
static enum status shift(struct sph *s) {
  const double F = kernel_slope_scale((enum sph_kernel)s->scheme.kernel);
  const double factor = largest_speed(s) * s->dt / s->h * 4 * s->h * F / 2;
  sph_each_cluster(s, cluster_eigenvalues, NULL);
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < s->f.n; i++) s->pack[i].p = s->f.p[i];
  sph_period_fill(s);
  sph_each_cluster(s, shift_cluster, &factor);
  return OK;
}

const struct sph_treatment sph_treatment_shifting = {.apply = shift};

/* Values of the water at points where no particle is: moving least squares of first order, that is
 * the fit of a plane weighted by W V, exact for linear fields (Marrone et al. 2011).
 *
 * Written as weighted mean plus gradient times the way from the neighbours' centre: the gradient
 * solves the 2 x 2 system of the weighted covariance. Where neighbours do not span the plane
 * (spray, the tip of a thin layer) the covariance is kept above 0.05 h^2, and the fit fades
 * continuously into the plain mean (Shepard); 0.18 h^2 is that of a half-filled support. Both are
 * the Gaussian's, and scaled for other kernels by the variance of their neighbours.
 *
 * Extrapolation amplifies noise: the variance of the fit is 1 + d^2 times that of the mean, where d
 * is the (Mahalanobis) distance of the point from the neighbours' centre. On a lattice with h/dx =
 * 4/3, d^2 is 0.57 half a spacing inside flat water, 1.14 in its corner, 2.4 and 4.8 on the edge
 * and corner themselves, and 9 half a spacing outside. The pressure is taken no farther out than
 * the caller's farthest2; these numbers, too, are scaled for other kernels (theory/scale.h). For
 * the velocity that limit counts only as much as there is noise: with R^2 the part of the
 * neighbours' variance that the plane explains, it is farthest2 / (1 - R^2). A smooth wave at a
 * wall is thus continued as far as its ghosts need (with a fixed limit it lost 9 to 11 % more
 * amplitude than the viscosity takes), and the ghosts of a torn sheet stay at the mean. */
#pragma once
#include "sph/pair/loops.h"

/* Pa, m/s and Pa/m, [SPH_LANES]; all 0 where there is no water near. */
struct sph_mls {
  double p[SPH_LANES], u[SPH_LANES], v[SPH_LANES], px[SPH_LANES], py[SPH_LANES];
};

/* At the points of i, whose x and y are enough, with sums by these loops. */
void sph_mls_at(const struct sph *s, const struct sph_loops *loops, double farthest2,
                const struct sph_targets *i, const struct sph_near *near, struct sph_mls *fit);

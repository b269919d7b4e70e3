/* Values of the water at points where no particle is: moving least squares of first order, that is
 * the fit of a plane weighted by W V, exact for linear fields (Marrone et al. 2011).
 *
 * Written as weighted mean plus gradient times the way from the neighbours' centre: the gradient
 * solves the 2 x 2 system of the weighted covariance. Where neighbours do not span the plane
 * (spray, the tip of a thin layer) the covariance is kept above 0.05 h^2, and the fit fades
 * continuously into the plain mean (Shepard); 0.18 h^2 is that of a half-filled support.
 *
 * Extrapolation amplifies noise: the variance of the fit is 1 + d^2 times that of the mean, where d
 * is the (Mahalanobis) distance of the point from the neighbours' centre. On a lattice with h/dx =
 * 4/3, d^2 is 0.57 half a spacing inside flat water, 1.14 in its corner, 2.4 and 4.8 on the edge
 * and corner themselves, and 9 half a spacing outside. The pressure is taken no farther out than
 * the caller's farthest2. For the velocity that limit counts only as much as there is noise: with
 * R^2 the part of the neighbours' variance that the plane explains, it is farthest2 / (1 - R^2). A
 * smooth wave at a wall is thus continued as far as its ghosts need (with a fixed limit it lost 9
 * to 11 % more amplitude than the viscosity takes), and the ghosts of a torn sheet stay at the
 * mean. */
#pragma once
#include "sph/pair/kernel.h"
#include "sph/pair/moments.h"
#include "sph/sph.h"

#define SPH_MLS_SPREAD 0.05

struct mls_fit {
  vec weight; /* sum W V: 1 inside the water, 0 far from it (the others are 0 there) */
  vec p, u, v;
  vec px, py; /* pressure gradient */
};

SPECIALISE struct mls_fit mls_at(enum sph_kernel kernel, double h, double farthest2, vec xi, vec yi,
                                 size_t n, const uint32_t *list, const struct sph_pack *pack) {
  const double per_h2 = 1 / (h * h);
  const vec cutoff2 = (vec){0} + kernel_cutoff2(kernel, h);
  vec S = {0}, X = {0}, Y = {0}, XX = {0}, XY = {0}, YY = {0};
  vec P = {0}, PX = {0}, PY = {0}, U = {0}, UX = {0}, UY = {0}, V = {0}, VX = {0}, VY = {0},
      UV2 = {0};
  for (size_t k = 0; k < n; k++) {
    const struct sph_pack *j = &pack[list[k]];
    vec x = j->x - xi, y = j->y - yi, r2 = x * x + y * y;
    vec w = vec_where_less(kernel_value(kernel, r2 * per_h2) * j->V, r2, cutoff2);
    vec wx = w * x, wy = w * y;
    S += w;
    X += wx;
    Y += wy;
    XX += wx * x;
    XY += wx * y;
    YY += wy * y;
    P += w * j->p;
    PX += wx * j->p;
    PY += wy * j->p;
    U += w * j->u;
    UX += wx * j->u;
    UY += wy * j->u;
    V += w * j->v;
    VX += wx * j->v;
    VY += wy * j->v;
    UV2 += w * (j->u * j->u + j->v * j->v);
  }
  struct mls_fit f = {.weight = kernel_value_scale(kernel, h) * S};
  vec per_S = 1 / vec_max(S, (vec){0} + 1e-30);
  X *= per_S;
  Y *= per_S;
  vec xx = XX * per_S - X * X, xy = XY * per_S - X * Y, yy = YY * per_S - Y * Y;
  const double spread = SPH_MLS_SPREAD * h * h;
#define CENTRE(Q, QX, QY)                                                                          \
  Q *= per_S;                                                                                      \
  QX = QX * per_S - Q * X;                                                                         \
  QY = QY * per_S - Q * Y
  CENTRE(U, UX, UY);
  CENTRE(V, VX, VY);
  CENTRE(P, PX, PY);
#undef CENTRE
  vec qx, qy, ux, uy, vx, vy;
  moments_solve(xx, xy, yy, spread, X, Y, &qx, &qy);
  moments_solve(xx, xy, yy, spread, UX, UY, &ux, &uy);
  moments_solve(xx, xy, yy, spread, VX, VY, &vx, &vy);
  moments_solve(xx, xy, yy, spread, PX, PY, &f.px, &f.py);
  const vec one = (vec){0} + 1;
  vec d2 = (qx * X + qy * Y) * (1 / farthest2);
  vec variance = vec_max(UV2 * per_S - U * U - V * V, (vec){0} + 1e-30);
  vec explained = ux * UX + uy * UY + vx * VX + vy * VY;
  vec noise = vec_max(one - explained / variance, (vec){0}); /* 1 - R^2 */
  vec reach = 1 / vec_sqrt(vec_max(d2 * noise, one));
  f.u = U - reach * (ux * X + uy * Y);
  f.v = V - reach * (vx * X + vy * Y);
  f.p = P - (f.px * X + f.py * Y) / vec_sqrt(vec_max(d2, one));
  return f;
}

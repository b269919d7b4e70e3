#include "sph/domain/mls.h"

#include <math.h>

#include "sph/pair/moments.h"

static const double smallest_spread = 0.05; /* h^2, with P's kernel */

/* A quantity's sums over the neighbours become its mean and covariance with their places. */
static void centre(double per_w, double x, double y, double *q, double *qx, double *qy) {
  *q *= per_w;
  *qx = *qx * per_w - *q * x;
  *qy = *qy * per_w - *q * y;
}

/* At one point, in units of h, c0 and rho0, less the velocity and pressure of the first source. */
static void fit_plane(struct sph_fit_sums *a, int l, double spread, double farthest2,
                      struct sph_mls *fit) {
  const double per_w = 1 / larger(a->w[l], 1e-30);
  const double x = a->x[l] * per_w, y = a->y[l] * per_w;
  const double xx = a->xx[l] * per_w - x * x, xy = a->xy[l] * per_w - x * y;
  const double yy = a->yy[l] * per_w - y * y;
  centre(per_w, x, y, &a->u[l], &a->ux[l], &a->uy[l]);
  centre(per_w, x, y, &a->v[l], &a->vx[l], &a->vy[l]);
  centre(per_w, x, y, &a->p[l], &a->px[l], &a->py[l]);
  double qx, qy, ux, uy, vx, vy, px, py;
  moments_solve(xx, xy, yy, spread, x, y, &qx, &qy);
  moments_solve(xx, xy, yy, spread, a->ux[l], a->uy[l], &ux, &uy);
  moments_solve(xx, xy, yy, spread, a->vx[l], a->vy[l], &vx, &vy);
  moments_solve(xx, xy, yy, spread, a->px[l], a->py[l], &px, &py);
  const double d2 = (qx * x + qy * y) / farthest2, u = a->u[l], v = a->v[l];
  const double variance = larger(a->speed2[l] * per_w - u * u - v * v, 1e-30);
  const double explained = ux * a->ux[l] + uy * a->uy[l] + vx * a->vx[l] + vy * a->vy[l];
  const double noise = larger(1 - explained / variance, 0); /* 1 - R^2 */
  const double reach = 1 / sqrt(larger(d2 * noise, 1));
  fit->u[l] = u - reach * (ux * x + uy * y);
  fit->v[l] = v - reach * (vx * x + vy * y);
  fit->p[l] = a->p[l] - (px * x + py * y) / sqrt(larger(d2, 1));
  fit->px[l] = px;
  fit->py[l] = py;
}

void sph_mls_at(const struct sph *s, const struct sph_loops *loops, double farthest2,
                const struct sph_targets *i, const struct sph_near *near, struct sph_mls *fit) {
  struct sph_fit_sums a;
  loops->fit(s, i, near, &a);
  const struct sph_pack none = {0}, *first = near->n ? &near->pack[near->list[0]] : &none;
  const double pressure = s->rho0 * s->c0 * s->c0;
  *fit = (struct sph_mls){0};
  for (int l = 0; l < SPH_LANES; l++) {
    if (!(a.w[l] > 0)) continue;
    fit_plane(&a, l, smallest_spread * s->scale.spread, farthest2, fit);
    fit->u[l] = first->u + s->c0 * fit->u[l];
    fit->v[l] = first->v + s->c0 * fit->v[l];
    fit->p[l] = first->p + pressure * fit->p[l];
    fit->px[l] *= pressure / s->h;
    fit->py[l] *= pressure / s->h;
  }
}

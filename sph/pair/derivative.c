#include "sph/pair/derivative.h"

#include "sph/pair/loops.h"
#include "sph/pair/moments.h"

/* Of M: in the kernel's measure, in which it is 1 inside the water and about 0.5 at a surface
 * (gradient.h), and per neighbour, h^2 (mls.h). */
static const double smallest_eigenvalue = 0.1, smallest_spread = 0.05;

/* Adds the sums over one kind of neighbours, of differences from the particle: the loop counts from
 * the first source. Lengths in h. */
static void add(const struct sph *s, const struct sph_targets *i, const struct sph_near *near,
                struct sph_fit_sums *sums) {
  if (!near->n) return;
  const struct sph_loops *loops = sph_loops_of(&s->scheme);
  struct sph_fit_sums a;
  if (s->scheme.derivative == SPH_DERIVATIVE_renormalised)
    loops->slope_fit(s, i, near, &a);
  else
    loops->hat_fit(s, i, near, &a);
  const struct sph_pack *first = &near->pack[near->list[0]];
  const double pressure = s->rho0 * s->c0 * s->c0;
  for (int l = 0; l < SPH_LANES; l++) {
    const double p = first->p - i->p[l], u = first->u - i->u[l], v = first->v - i->v[l];
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

/* Takes the means out of what is summed. */
static void centre(struct sph_fit_sums *a, int l) {
  const double x = a->x[l] / a->w[l], y = a->y[l] / a->w[l];
  a->xx[l] -= x * a->x[l];
  a->xy[l] -= x * a->y[l];
  a->yy[l] -= y * a->y[l];
  a->px[l] -= x * a->p[l];
  a->py[l] -= y * a->p[l];
  a->ux[l] -= x * a->u[l];
  a->uy[l] -= y * a->u[l];
  a->vx[l] -= x * a->v[l];
  a->vy[l] -= y * a->v[l];
}

struct sph_slopes sph_slopes_of(const struct sph *s, const struct sph_targets *i,
                                const struct sph_near *water, const struct sph_near *walls) {
  const enum sph_derivative d = (enum sph_derivative)s->scheme.derivative;
  const double F = kernel_slope_scale((enum sph_kernel)s->scheme.kernel);
  struct sph_fit_sums a = {0};
  add(s, i, water, &a);
  add(s, i, walls, &a);
  struct sph_slopes g;
  for (int l = 0; l < SPH_LANES; l++) {
    if (d == SPH_DERIVATIVE_mls) centre(&a, l);
    const double floor =
        d == SPH_DERIVATIVE_renormalised ? smallest_eigenvalue / F : smallest_spread * a.w[l];
    double ux, uy, vx, vy;
    moments_solve(a.xx[l], a.xy[l], a.yy[l], floor, a.px[l], a.py[l], &g.px[l], &g.py[l]);
    moments_solve(a.xx[l], a.xy[l], a.yy[l], floor, a.ux[l], a.uy[l], &ux, &uy);
    moments_solve(a.xx[l], a.xy[l], a.yy[l], floor, a.vx[l], a.vy[l], &vx, &vy);
    g.px[l] /= s->h;
    g.py[l] /= s->h;
    g.div[l] = (ux + vy) / s->h;
  }
  return g;
}

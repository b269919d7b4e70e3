#include "sph/pair/derivative.h"

#include "sph/pair/moments.h"
#include "sph/pair/sums.h"

/* Of M: in the kernel's measure, in which it is 1 inside the water and about 0.5 at a surface
 * (gradient.h), and per neighbour, h^2 (mls.h). */
static const double smallest_eigenvalue = 0.1, smallest_spread = 0.05;

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
  const bool within = derivative_has_radius(d);
  const struct sph_loops *loops = sph_loops_for(s, i);
  sph_fit_loop *fit = within ? loops->hat_fit : loops->slope_fit;
  struct sph_fit_sums a = {0};
  sph_sums_add(s, fit, true, i, water, &a);
  sph_sums_add(s, fit, true, i, walls, &a);
  struct sph_slopes g;
  for (int l = 0; l < SPH_LANES; l++) {
    if (derivative_takes_means(d)) centre(&a, l);
    const double floor = within ? smallest_spread * a.w[l] : smallest_eigenvalue / F;
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

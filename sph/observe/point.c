#include "sph/observe/point.h"

#include <math.h>

#include "sph/pair/eos.h"
#include "sph/pair/kernel.h"

/* Less water than this around a point is spray: a mean over a particle or two. */
static const double LEAST_COVER = 0.1;

/* From the point to the nearest image of a particle along an axis, m. */
static double way(const struct tank *t, int axis, double at, double to) {
  const double d = to - at, length = tank_size(t, axis);
  return t->periodic[axis] ? d - length * round(d / length) : d;
}

/* W, m^-2, at (x, y) in h; 0 outside the support. The loops' vectors hold it in each element. */
static double weight(const struct sph *s, double x, double y) {
  const enum sph_kernel k = (enum sph_kernel)s->scheme.kernel;
  const vec X = vec_of(x), Y = vec_of(y), q2 = X * X + Y * Y;
  if (!(kernel_reach2(k, X, Y, q2)[0] < kernel_cutoff2(k))) return 0;
  return kernel_value_scale(k) * kernel_value(k, X, Y, q2)[0] / (s->h * s->h);
}

static void add_particle(const struct sph *s, size_t i, double VW, double *sum) {
  const double y = s->f.w.y[i], stored = s->f.w.rho[i];
  sum[CASE_POINT_p] += VW * eos_pressure(&s->eos, eos_driving(&s->eos, stored, y), y);
  sum[CASE_POINT_rho] += VW * eos_density(&s->eos, stored, y);
  sum[CASE_POINT_u] += VW * s->f.w.u[i];
  sum[CASE_POINT_v] += VW * s->f.w.v[i];
  sum[CASE_POINT_a_x] += VW * s->f.k[0].u[i];
  sum[CASE_POINT_a_y] += VW * s->f.k[0].v[i];
  sum[CASE_POINT_cover] += VW;
}

static void sum_around(const struct sph *s, const struct case_point *point,
                       double value[CASE_POINT_FIELDS]) {
  const double reach = s->support * (1 + 1e-9);
  for (int k = 0; k < CASE_POINT_FIELDS; k++) value[k] = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    const double x = way(&s->tank, 0, point->x, s->f.w.x[i]);
    const double y = way(&s->tank, 1, point->y, s->f.w.y[i]);
    if (fabs(x) > reach || fabs(y) > reach) continue;
    const double VW = s->f.m[i] / s->f.w.rho[i] * weight(s, x / s->h, y / s->h);
    if (VW > 0) add_particle(s, i, VW, value);
  }
}

void sph_point(const struct sph *s, const struct case_point *point,
               double value[CASE_POINT_FIELDS]) {
  sum_around(s, point, value);
  const double cover = value[CASE_POINT_cover];
  for (int k = 0; k < CASE_POINT_FIELDS; k++)
    if (k != CASE_POINT_cover) value[k] = cover >= LEAST_COVER ? value[k] / cover : NAN;
  value[CASE_POINT_x] = point->x;
  value[CASE_POINT_y] = point->y;
}

uint32_t sph_point_nearest(const struct sph *s, const struct case_point *point) {
  double least = INFINITY;
  uint32_t id = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    const double d =
        hypot(way(&s->tank, 0, point->x, s->f.w.x[i]), way(&s->tank, 1, point->y, s->f.w.y[i]));
    /* of those that are as near up to rounding, the first: particles are sorted at any time */
    if (d > least + 1e-9 * s->dx || (d > least - 1e-9 * s->dx && s->f.id[i] > id)) continue;
    least = fmin(d, least);
    id = s->f.id[i];
  }
  return id;
}

void sph_point_follow(const struct sph *s, uint32_t id, double value[CASE_POINT_FIELDS]) {
  size_t i = 0;
  while (i < s->f.n && s->f.id[i] != id) i++;
  for (int k = 0; k < CASE_POINT_FIELDS; k++) value[k] = i < s->f.n ? 0 : NAN;
  if (i == s->f.n) return;
  const struct case_point there = {.x = tank_wrap(&s->tank, 0, s->f.w.x[i]),
                                   .y = tank_wrap(&s->tank, 1, s->f.w.y[i])};
  double around[CASE_POINT_FIELDS];
  add_particle(s, i, 1, value);
  sum_around(s, &there, around);
  value[CASE_POINT_cover] = around[CASE_POINT_cover];
  value[CASE_POINT_x] = there.x;
  value[CASE_POINT_y] = there.y;
}

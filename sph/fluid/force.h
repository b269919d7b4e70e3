/* The body force on the water, in the frame of the tank: gravity, along whatever direction, and
 * what a tank that moves adds to it (tank_frame_force): that of a vertex of the tank, of its
 * turning, the centrifugal and Coriolis's,
 *
 *   f = R^T (g - a) - alpha x r - omega x (omega x r) - 2 omega x u.
 *
 * Gravity as it is at t = 0 has a potential; the power of all else is a term of the budget (frame).
 * Whoever asks for a force or a height asks here. */
#pragma once
#include <stdbool.h>

#include "common/tank/motion.h"
#include "sph/family.h"

struct case_file;
struct sph;

struct sph_force {
  double g[2];                      /* m s^-2, of gravity */
  double up[2];                     /* against it, of length 1; (0, 1) without any */
  size_t n;                         /* motions of tank and walls; 0: at rest */
  const struct tank_motion *motion; /* [n], the case's */
  bool shakes;                      /* any is of the whole tank */
  /* of the time that was set: */
  double drive[2];      /* R^T (g - a) less gravity that the pressure stands for, m s^-2 */
  double excess[2];     /* R^T (g - a) - g, m s^-2 */
  double turning, rate; /* alpha, s^-2; omega, s^-1 */
};

void sph_force_create(struct sph *s, const struct case_file *c);

/* The force is that of time t, s. */
void sph_force_set(struct sph *s, double t);

/* How high a point is, m: y where gravity is downwards. */
SPECIALISE double sph_height(const struct sph_force *f, double x, double y) {
  return f->up[0] * x + f->up[1] * y;
}

/* What turning adds for water at (x, y) with velocity (u, v), m s^-2. */
SPECIALISE void sph_force_turn(const struct sph_force *f, double x, double y, double u, double v,
                               double out[2]) {
  const double w = f->rate;
  out[0] = f->turning * y + w * (w * x + 2 * v);
  out[1] = -f->turning * x + w * (w * y - 2 * u);
}

/* Beside the pressure that drives (eos.h), m s^-2. */
SPECIALISE void sph_force_at(const struct sph_force *f, double x, double y, double u, double v,
                             double out[2]) {
  double turn[2] = {0, 0};
  if (f->shakes) sph_force_turn(f, x, y, u, v, turn);
  for (int d = 0; d < 2; d++) out[d] = f->drive[d] + turn[d];
}

/* What is not gravity's, m s^-2. */
SPECIALISE void sph_force_excess(const struct sph_force *f, double x, double y, double u, double v,
                                 double out[2]) {
  sph_force_turn(f, x, y, u, v, out);
  for (int d = 0; d < 2; d++) out[d] += f->excess[d];
}

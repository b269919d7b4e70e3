#include "common/flow/round.h"

#include <math.h>
#include <stdio.h>

void wave_round_check(const struct case_file *c, struct case_draft *d, double wavelength) {
  const double parts = (c->tank.max[0] - c->tank.min[0]) / wavelength;
  char found[96];
  if (!c->rectangular || !c->periodic[0] ||
      (fabs(parts - round(parts)) <= 1e-6 * parts && parts > 0.5))
    return;
  snprintf(found, sizeof found, "%.6g wavelengths between the periodic sides", parts);
  case_flow_problem(d, "wavelength", found, "a whole number of them",
                    "change the wavelength or the tank's length");
}

/* rho/rho0 - 1 over g/c^2. */
double wave_round_head(const struct flow_water *w, double depth, double push) {
  const double gravity = w->c->gravity, sound = w->use.sound;
  if (w->use.even) return depth + push / gravity;
  const double per_length = gravity / (sound * sound), at_rest = expm1(per_length * depth);
  return (at_rest + (1 + at_rest) * push / (sound * sound)) / per_length;
}

static double surface(const struct flow_water *w, const struct wave_mode *m) {
  return w->c->tank.min[1] + m->in.depth;
}

struct wave_motion wave_round_motion(const struct flow_water *w, const struct wave_mode *m,
                                     double amplitude, double x, double y, double t) {
  return wave_mode_motion(m, amplitude, x - w->c->tank.min[0], y - surface(w, m), t);
}

/* First order in the amplitude: all of the wave is taken where the particle rests, but the weight
 * of the water, which is large, where it is. */
void wave_round_start(const struct flow_water *w, const struct wave_mode *m, double amplitude,
                      double X, double Y, struct flow_start *start) {
  const double top = surface(w, m);
  const struct wave_motion motion = wave_round_motion(w, m, amplitude, X, Y, 0);
  *start = (struct flow_start){.x = X + motion.xi,
                               .y = Y + motion.zeta,
                               .u = motion.u,
                               .v = motion.v,
                               .head = wave_round_head(w, top - Y - motion.zeta, motion.push),
                               .rest = wave_round_head(w, top - Y, 0)};
}

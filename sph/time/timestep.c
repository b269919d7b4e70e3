#include "sph/time/timestep.h"

#include <math.h>

#include "sph/pair/diffusion.h"
#include "sph/time/integrator.h"

static double over(double a, double b) {
  return b > 0 ? a / b : INFINITY;
}

struct sph_bounds sph_timestep_bounds(const struct sph *s) {
  const struct sph_integrator *method = sph_integrators[s->scheme.integrator];
  const struct sph_scheme *o = &s->scheme;
  const enum sph_diffusion d = (enum sph_diffusion)o->diffusion;
  double nu = o->alpha * s->h * s->c0 / 8; /* alpha h c0 / (2n + 4), n = 2 */
  return (struct sph_bounds){
      .diffusive = over(o->cfl_diffusive * s->scale.diffusive * method->diffusive *
                            (method->frozen ? diffusion_frozen(d) : 1) * s->h,
                        o->delta * diffusion_strength(d) * s->c0),
      .viscous = over(o->cfl_viscous * s->h * s->h, nu),
      .acceleration = o->cfl_acceleration * sqrt(over(s->h, sqrt(s->totals.acceleration2))),
      .acoustic =
          o->cfl_acoustic * s->scale.acoustic * method->acoustic * s->h / (s->c0 + s->totals.speed),
  };
}

bool sph_timestep_is_cut(const struct sph *s) {
  if (s->scheme.dt > 0) return false;
  struct sph_bounds b = sph_timestep_bounds(s);
  double at_rest = b.acoustic * (1 + s->totals.speed / s->c0);
  return fmin(b.acceleration, b.acoustic) < 0.1 * fmin(fmin(b.diffusive, b.viscous), at_rest);
}

static double largest(const struct sph *s) {
  struct sph_bounds b = sph_timestep_bounds(s);
  return fmin(fmin(b.diffusive, b.viscous), fmin(b.acceleration, b.acoustic));
}

double sph_timestep(const struct sph *s, double next) {
  double dt = s->scheme.dt > 0 ? s->scheme.dt : largest(s);
  double left = next - s->t;
  return left / fmax(1, ceil(left / dt * (1 - 1e-12)));
}

double sph_courant_at_rest(const struct sph_scheme *o, struct sph_bounds *bounds) {
  struct sph s = {.scheme = *o, .scale = sph_scale_of(o), .h = 1, .c0 = 1};
  s.scheme.delta = sph_scheme_delta(o);
  s.scheme.integrator = sph_integrator_chosen(o);
  *bounds = sph_timestep_bounds(&s);
  return fmin(fmin(bounds->diffusive, bounds->viscous), bounds->acoustic);
}

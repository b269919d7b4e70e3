/* Explicit Runge-Kutta methods as tables that share one step (P, section IV). */
#pragma once
#include <stdbool.h>

#include "sph/sph.h"

struct sph_integrator {
  const char *name;
  int stages, order;
  bool frozen; /* the diffusive term of the first stage serves all (P eq. (25)) */
  double a[SPH_MAX_STAGES][SPH_MAX_STAGES], b[SPH_MAX_STAGES];
  /* Limits of stability on the imaginary and the negative real axis, relative to those of classic
   * RK4 (2.828 and 2.785), for which P found its time step factors. Frozen, diffusion alone is an
   * Euler step with the limit 2; P's factor 0.44 is for that: the fastest decay rate is 4 delta
   * c0/h, and 4 * 0.44 = 1.76. */
  double acoustic, diffusive;
};

extern const struct sph_integrator sph_integrators[];
extern const char *const sph_integrator_names[]; /* NULL-terminated */
extern const char *const sph_integrator_helps[]; /* what each is */

/* Completes a step of length dt (s) whose first stage sph_rates(s, 0, true, ...) has evaluated.
 * Advances the state, s->t, s->steps, and the dissipated energies at the method's own order. */
enum status sph_step(struct sph *s, double dt);

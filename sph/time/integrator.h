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
   * RK4 (2.828 and 2.785), for which P found its time step factors. What freezing the diffusion
   * costs depends on the term (diffusion.h). */
  double acoustic, diffusive;
};

enum { SPH_N_INTEGRATORS = 3, SPH_INTEGRATOR_AUTO = SPH_N_INTEGRATORS };
extern const struct sph_integrator sph_integrators[SPH_N_INTEGRATORS];
extern const char *const sph_integrator_names[]; /* those, "auto", NULL */
extern const char *const sph_integrator_helps[]; /* what each is */

/* The index of the one that is asked for. "auto" is the frozen method where freezing the diffusion
 * leaves the time step as it is, the classic one where it would shorten it. */
int sph_integrator_chosen(const struct sph_scheme *o);

/* Completes a step of length dt (s) whose first stage sph_rates(s, 0, true, ...) has evaluated.
 * Advances the state, s->t, s->steps, and the dissipated energies at the method's own order. */
enum status sph_step(struct sph *s, double dt);

/* Time integration. A variant is a struct sph_integrator in a file of its own, or a table in rk.c
 * or partitioned.c, and a line in SPH_INTEGRATORS. */
#pragma once
#include <stdbool.h>

#include "sph/sph.h"

struct rk_table;
struct sph_stages;

struct sph_integrator {
  int order, evaluations; /* of the right-hand side, in a step */
  bool frozen;            /* the diffusive term of the first evaluation serves all (P eq. (25)) */
  bool split;             /* the diffusive term has steps of its own */
  bool damps;             /* velocities decay at the rate sph_damping (1/s) */
  /* Limits of stability on the imaginary and the negative real axis, relative to those of classic
   * RK4 (2.828 and 2.785), for which P found its time step factors. What freezing the diffusion
   * costs depends on the term (diffusion.h). 0: sound grows in steps of any size, so that a run
   * must give one. linear.h finds them from the stages. */
  double acoustic, diffusive;
  const struct rk_table *table; /* of a Runge-Kutta method, else NULL */
  /* Of others (stages.h), for `damping` = Gamma dt. */
  struct sph_stages (*stages)(double damping);
  /* From the state s->f.w0 and the rates of stage 0: the state after dt into s->f.w, what the step
   * dissipates into *spent. *held becomes false, and all else is void, when the neighbour lists do
   * not hold for a state in between. Of the state after dt nobody asks: no sum over pairs is taken
   * of it before the next step has brought the lists up to date (sph_neighbours_update, with which
   * stage 0 begins); what outputs sum in between has lists of its own (observe/). */
  enum status (*step)(struct sph *s, const struct sph_integrator *method, double dt,
                      struct sph_totals *spent, bool *held);
};

/* X(variant, what a case calls it, help). */
#define SPH_INTEGRATORS(X)                                                                         \
  X(rk4, "rk4", "classic Runge-Kutta of order 4")                                                  \
  X(rk4_frozen, "rk4-frozen",                                                                      \
    "classic Runge-Kutta, diffusion evaluated once a step (paper, eq. 25)")                        \
  X(rk4_split, "rk4-split",                                                                        \
    "classic Runge-Kutta, then diffusion by its exponential: no bound from it")                    \
  X(tvd_rk3, "tvd-rk3",                                                                            \
    "total-variation diminishing Runge-Kutta of order 3 (Gottlieb & Shu 1998)")                    \
  X(euler, "euler",                                                                                \
    "forward Euler; sound grows, |lambda|^2 = 1 + z^2, z = omega dt: give dt (thesis, eq. 2.249)") \
  X(predictor_corrector, "predictor-corrector",                                                    \
    "predictor-corrector (Heun); sound grows, 1 + z^4/4: give dt (thesis, eq. 2.255)")             \
  X(modified_pc, "modified-pc",                                                                    \
    "predictor-corrector with x + dt u + dt^2/2 a; neutral to z = 2 where the density is summed, " \
    "else 1 + z^4/4: give dt (thesis, eqs. 2.256 to 2.258, 2.267)")                                \
  X(damped_pc, "damped-pc",                                                                        \
    "midpoint predictor-corrector with initial damping: stable to z^2 = 2 sqrt(2 zeta (zeta - "    \
    "1)), zeta = 1 + damping dt/2: give dt (thesis, eqs. 3.36 to 3.45)")                           \
  X(stoermer_verlet, "stoermer-verlet",                                                            \
    "kick, drift of positions and densities, kick: sound is neutral to z = 2, and the energy of "  \
    "water without losses does not drift")

enum {
#define X(variant, name, help) SPH_INTEGRATOR_##variant,
  SPH_INTEGRATORS(X)
#undef X
      SPH_INTEGRATOR_COUNT,
  SPH_INTEGRATOR_AUTO = SPH_INTEGRATOR_COUNT
};
#define X(variant, name, help) extern const struct sph_integrator sph_##variant;
SPH_INTEGRATORS(X)
#undef X

extern const struct sph_integrator *const sph_integrators[SPH_INTEGRATOR_COUNT];
extern const char *const sph_integrator_names[]; /* those, "auto", NULL */
extern const char *const sph_integrator_helps[]; /* what each is */

/* The index of the one that is asked for. "auto" is the frozen method where freezing the diffusion
 * leaves the time step as it is, the split one where it would shorten it. */
int sph_integrator_chosen(const struct sph_scheme *o);

/* Gamma (1/s) now, of methods that damp. */
double sph_damping(const struct sph *s);

/* Advances the state and s->t by dt (s), from rates and totals that sph_rates(s, 0, true, ...) has
 * left, and the dissipated energies at the method's own order; water that has crossed a wall is
 * brought back. The places of particles do not change, unless some move so far within the step that
 * the neighbour lists do not hold: then the lists are made anew for faster water and the step is
 * done again. ERR_DIVERGED when that does not help. */
enum status sph_step(struct sph *s, double dt);

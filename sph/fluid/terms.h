/* The terms of the budget of energy: what has left the water so far, J per metre of width, each a
 * column of the result file. Kinetic + potential + elastic energy, what was taken out with water
 * that left (removed) and all terms keep their sum; what they do not keep is the error of the time
 * integration. */
#pragma once
#include "sph/treat/list.h"

/* Those of the pairs' forces and fluxes: X(name, help). */
#define SPH_PAIR_POWERS(X)                                                                         \
  X(viscosity, "energy taken out so far by viscosity")                                             \
  X(diffusion, "energy taken out so far by density diffusion")                                     \
  X(walls, "energy given to walls so far (zero in exact arithmetic)")                              \
  X(pairs, "energy taken out so far by forms of momentum and continuity that are not adjoint")

/* Those to and from what moves the tank. */
#define SPH_TANK_POWERS(X)                                                                         \
  X(frame, "energy given so far to a tank that moves, by the force on water in its frame")         \
  X(sides, "energy given so far to sides that move, by the forces of the water on them")

/* All that an evaluation of the rates finds as powers, W/m, and the integrator adds up. */
#define SPH_POWERS(X) SPH_PAIR_POWERS(X) SPH_TANK_POWERS(X) SPH_CORRECTIONS(X)

/* Those that an integrator takes by itself. */
#define SPH_STEP_TERMS(X) X(damping, "energy taken out so far by the damping of the integrator")

/* What a step takes out of the water. */
#define SPH_SPENT(X) SPH_POWERS(X) SPH_STEP_TERMS(X)

/* And one for each treatment between steps, which is what the energy fell by while it was applied.
 */
#define SPH_TERMS(X) SPH_SPENT(X) SPH_TREATMENTS(X)

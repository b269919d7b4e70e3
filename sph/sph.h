/* The state of a weakly compressible SPH computation and the symbols of the paper P (Antuono,
 * Colagrossi & Marrone, "On the use of numerical diffusive terms in weakly-compressible SPH
 * schemes"). SI units; energies per metre of width.
 *
 *   V = m / rho,  r_ji = r_j - r_i,  body force f (force.h), and what pulls the flow together */
#pragma once
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "common/base/geometry.h"
#include "common/base/status.h"
#include "common/flow/flow.h"
#include "common/tank/tank.h"
#include "sph/domain/period.h"
#include "sph/domain/sides.h"
#include "sph/domain/sight.h"
#include "sph/fluid/drift.h"
#include "sph/fluid/force.h"
#include "sph/fluid/neighbours.h"
#include "sph/fluid/particles.h"
#include "sph/fluid/terms.h"
#include "sph/pair/eos.h"
#include "sph/phase.h"
#include "sph/scheme.h"
#include "sph/theory/scale.h"

struct case_file;
struct sph;
struct sph_wall;

/* What a pair loop reads of a neighbour: one cache line. */
struct sph_pack {
  double x, y, u, v, p, V; /* m, m/s, Pa, m^2 */
  double rho;              /* kg m^-3 */
  double spare;            /* 0: the line is read whole */
} __attribute__((aligned(64)));

/* Of a particle, for those who need it beside the pack. */
struct sph_vector {
  double x, y;
} __attribute__((aligned(16)));

/* Wall particles: however a treatment fills them, the pair loops see only this. */
struct sph_wall_particles {
  size_t n;
  double *x, *y;         /* m, [n], sorted by grid cell, owned */
  uint32_t *chain;       /* [n], of faces that each continues the water behind (sight.h), owned */
  struct sph_pack *pack; /* [n], owned */
  struct sph_pack *drag; /* [n], as viscosity has them at walls without slip, else NULL; owned */
  struct sph_vector *V;  /* [n], velocity of the wall along its normal, m/s, where any moves, else
                            NULL; owned */
  struct sph_pack *part[2][2]; /* of pack, and of drag if there is: along x and y, with volumes
                                  times V there, where V is, [n] each, owned */
  struct sph_vector *G;        /* [n], as the water's, owned */
  struct sph_grid grid;
  void *data; /* of the treatment */
};

/* Energy that has left the water since t = 0, J/m, and water taken out of the computation, m^2: all
 * of it, and what has passed over the top of a wall. */
struct sph_budget {
#define X(name, ...) double name;
  SPH_TERMS(X)
#undef X
  double removed;
  double removed_volume, spilled_volume;
};

/* What one evaluation leaves besides the rates: powers (W/m) taken out of the water, and the
 * largest values that bound the time step. */
struct sph_totals {
#define X(name, ...) double name;
  SPH_SPENT(X)
#undef X
  double acceleration2; /* max |a|^2, m^2 s^-4 */
  double speed;         /* max (|u_i| + h max_j |pi_ij|), m/s */
};

/* The largest of any step so far, how many steps were cut short, and of the last state that was
 * finite the kinetic energy (J/m) and the budget (watch.h). */
struct sph_seen {
  double speed, lightest, heaviest; /* m/s, kg m^-3 */
  size_t cut;
  double kinetic;
  struct sph_budget budget;
};

/* What stands for the sums over pairs where the state is no water but the numbers of a linear
 * problem (theory/stability.c): rates of u, v and rho and the diffusion, as sph_rates and
 * sph_diffuse have them. */
struct sph_stand_in {
  void (*rates)(struct sph *s, int stage, bool diffuse);
  double (*diffuse)(struct sph *s, double *D);
};

struct sph {
  struct sph_scheme scheme;
  struct sph_scale scale;    /* of its kernel */
  double rho0, c0, g, dx, h; /* kg m^-3, m/s, m s^-2, m, m */
  struct sph_force force;
  struct flow_pull pull;
  struct eos eos;
  bool adjoint;   /* momentum and continuity exchange energy exactly (forms.h) */
  double support; /* m, radius of the kernel */
  struct tank tank;

  double t, dt; /* s; of the last step */
  size_t steps, evaluations, rebuilds, wall_rebuilds, reflections;
  struct sph_budget budget;
  struct sph_totals totals; /* of the last evaluation */
  struct sph_seen seen;
  struct sph_clock clock;

  struct sph_particles f; /* the water */
  struct sph_pack *pack;  /* of the water; from f.room on of its images (period.h);
                             [pack_room], owned */
  struct sph_vector *G;   /* Pa/m, renormalised pressure gradient where the diffusion needs it, of
                             the same, [pack_room], owned */
  size_t pack_room;
  struct sph_totals *cluster_totals; /* [f.room / SPH_LANES], owned */

  void *treated[SPH_TREATMENT_COUNT];  /* what treatments keep (treat.h), owned */
  size_t applied[SPH_TREATMENT_COUNT]; /* how often */

  bool split;                          /* the diffusive term has steps of its own (time/split.c) */
  const struct sph_stand_in *stand_in; /* NULL for water */

  struct sph_period period;
  unsigned char
      *fitted; /* [f.n at t = 0], by id: whether in the first row (fitted.h), or NULL; owned */

  struct faces faces; /* of the walls */
  struct sph_sides sides;
  struct sph_sight sight;
  const struct sph_wall *wall;
  struct sph_wall_particles w;

  struct sph_grid grid; /* of the water */
  struct sph_lists water_water, water_wall;
  /* m: lists reach so much farther than the support (drift.h). Both are wider where the water goes
   * farther in a step. */
  double skin, wall_skin;
  bool again; /* a step has started again: the lists are to stay as wide as they are */
  struct sph_drift drift;
};

/* Makes the state of the case's water at t = 0, walls and neighbour lists included. */
enum status sph_create(const struct case_file *c, double resolution, const struct sph_scheme *o,
                       struct sph **out);
void sph_destroy(struct sph *s); /* NULL is fine */

/* The tank and the force on its water are those of time t (s), which is that of the state that is
 * asked about next. */
void sph_tank_set(struct sph *s, double t);

/* Between steps: builds the neighbour lists anew that may not hold for another step like the last.
 * When those of the water are, the particles are sorted, so that their places change. */
enum status sph_neighbours_update(struct sph *s);

/* The water, as lists of sources have it, near whatever: its packs are then s->pack. */
struct sph_sources sph_sources_of_water(const struct sph *s);

/* Within a step, `elapsed` (s) after the state s->f.w0: whether the lists still hold. */
bool sph_lists_hold(const struct sph *s, double elapsed);

/* Sorts, and builds lists that hold for ways twice as long as the last ones. */
enum status sph_neighbours_widen(struct sph *s);

/* Takes particles that cannot come back out of the computation, into the budget: those that have
 * passed over a wall and fallen below its top, and those more than the support outside the tank.
 * Between steps only. ERR_DIVERGED when none is left. */
enum status sph_remove_outside(struct sph *s);

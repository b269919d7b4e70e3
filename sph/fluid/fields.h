/* Every array of numbers that the water's particles have, once: storage, sorting, padding,
 * integrators and tests expand these lists. X(name, unit, what it is), all [n] and in the order of
 * the particles.
 */
#pragma once

/* What integrators advance, from rates with names of their own. */
#define SPH_EVOLVING(X)                                                                            \
  X(x, "m", "position")                                                                            \
  X(y, "m", "position")                                                                            \
  X(u, "m/s", "velocity")                                                                          \
  X(v, "m/s", "velocity")                                                                          \
  X(rho, "kg/m^3", "density")

/* What else a particle carries from step to step. */
#define SPH_KEPT(X)                                                                                \
  X(m, "kg/m", "mass")                                                                             \
  X(over, "1", "which top of a wall the water has passed over (wall.c), or 0")

/* What is made anew, and forgotten when the particles are sorted. */
#define SPH_MADE(X)                                                                                \
  X(p, "Pa", "pressure of an evaluation (sph_pack_water)")                                         \
  X(D, "kg/m^3/s", "delta h c0 D_i: kept where an integrator freezes it")                          \
  X(x_listed, "m", "where the particle was when they were sorted")                                 \
  X(y_listed, "m", "where the particle was when they were sorted")                                 \
  X(x_walls, "m", "where the particle was when the walls were listed")                             \
  X(y_walls, "m", "where the particle was when the walls were listed")                             \
  X(off_walls, "m", "how far from the nearest wall that was")                                      \
  X(scratch, "", "of the sort")

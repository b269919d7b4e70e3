/* Forces of the water on the walls of its tank, and its momentum: what the walls and its weight
 * change. All in the frame of the tank. */
#pragma once
#include "bem/water/pressure.h"
#include "common/solver.h"

/* X(name, unit in SI, help) */
#define BEM_FORCES(X)                                                                              \
  X(force_x, "N/m", "force of the water on all walls along x, by its pressure")                    \
  X(force_y, "N/m", "the same along y")                                                            \
  X(moment, "N",                                                                                   \
    "its moment about the middle of the lower side of the box round the tank, anticlockwise")      \
  X(force_left, "N/m",                                                                             \
    "force along x on the straight piece of wall that the left edge of the water is on")           \
  X(force_right, "N/m", "the same of the right edge")                                              \
  X(momentum_x, "kg/s", "momentum of the water in the frame of the tank, along x")                 \
  X(momentum_y, "kg/s", "the same along y")

struct bem_forces { /* rho g H^2, rho g H^3, and rho H^2 sqrt(gH) */
#define X(name, units, help) double name;
  BEM_FORCES(X)
#undef X
};
enum { BEM_FORCE_COUNT = sizeof(struct bem_forces) / sizeof(double) };

/* Along x on the left and the right side alone, rho g H^2. Call after bem_pressure_solve.
 * ERR_SOLVER.
 */
enum status bem_forces_on_sides(struct bem_pressure *p, const struct bem_flow *f,
                                const double *state, double force[2]);

/* All of them. */
enum status bem_forces_find(struct bem_pressure *p, const struct bem_flow *f, const double *state,
                            const double momentum[2], struct bem_forces *out);

/* As they are seen in an upright mirror through the middle of the tank. */
void bem_forces_turn(struct bem_forces *f);

/* Power on sides that move, of walls of any shape, rho g H^2 sqrt(gH). Call after
 * bem_pressure_solve. ERR_MEMORY. */
enum status bem_forces_power(struct bem_pressure *p, const struct bem_flow *f, const double *state,
                             double *power);

/* What walls of any shape whose sides move add to surface integrals, by psi on them and the known
 * part of beta: to the kinetic energy, that of the known part; to the momentum. */
void bem_forces_of_known(const struct bem_flow *f, const struct bem_rule *wet, double *kinetic,
                         double momentum[2]);

/* Integral of the velocity in the frame of a tank that does not turn over the water, H^2 sqrt(gH).
 */
void bem_forces_momentum(const struct bem_flow *f, const double *state, double momentum[2]);

/* Names, units and helps of the columns, and their values in SI. */
extern const struct solver_diagnostic bem_force_columns[BEM_FORCE_COUNT];
void bem_forces_in_si(const struct case_file *c, const struct bem_forces *f,
                      double value[BEM_FORCE_COUNT]);

/* CVODE (Adams, fixed-point iteration) behind the few calls that the solver needs. */
#pragma once
#include "bem/water/flow.h"

/* Functions of time and state of which the stepper finds the falls through zero. */
struct bem_roots {
  int n;
  void (*find)(void *data, double time, const double *state, double *root /* [n], output */);
};

struct bem_stepper; /* opaque: handles of SUNDIALS */

struct bem_stepper_counts {
  double steps, evaluations, initialisations;
};

/* The stepper advances flow->surface.state. tolerance: absolute, of x, y (H) and phi (H sqrt(gH)).
 */
enum status bem_stepper_create(struct bem_flow *flow, double tolerance,
                               const struct bem_roots *roots, void *data, struct bem_stepper **s);
void bem_stepper_destroy(struct bem_stepper *s);

/* Starts afresh from flow->surface, whatever its number of nodes. */
enum status bem_stepper_restart(struct bem_stepper *s, double time);

/* One internal step, or less if a root stops it: flow->surface.state is then the state at *time and
 * *found, of the stepper's own memory, tells which, [roots->n]. */
enum status bem_stepper_step(struct bem_stepper *s, double *time, double *dt, const int **found);

/* The state at a time within the last step, [3n]. */
enum status bem_stepper_interpolate(struct bem_stepper *s, double time, double *state);

struct bem_stepper_counts bem_stepper_count(const struct bem_stepper *s);

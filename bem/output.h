/* From the solver's units to the result file. */
#pragma once
#include "bem/flow.h"
#include "bem/pressure.h"
#include "bem/stepper.h"
#include "common/case.h"
#include "common/progress.h"
#include "common/result.h"

struct bem_output {
  const struct case_file *c;
  struct result *file;
  double start;      /* of the run on the wall clock, s */
  double time_scale; /* sqrt(H/g), s */
  size_t next_output, next_sample;
  double removed_volume, removed_energy; /* H^2, rho g H^3 */
  double drift;                          /* of the energy, relative to the initial one */
  double first_energy;
  size_t most_nodes;
  struct bem_pressure pressure;
  struct geo_lines line;
  size_t room;
  double *state, *field; /* an interpolated state, and its fields in SI, [3n], [5n], owned */
};

void bem_output_destroy(struct bem_output *o);

/* Writes the surfaces due up to `time` (sqrt(H/g)), which the last step has passed; stepper NULL:
 * the state at t = 0. */
enum status bem_output_surfaces(struct bem_output *o, struct bem_flow *f,
                                struct bem_stepper *stepper, double time);

/* Writes a row of every series if `time` has passed the next multiple of time.sample. */
enum status bem_output_series(struct bem_output *o, struct bem_flow *f,
                              const struct bem_stepper *stepper, double time, double dt);

enum status bem_output_event(struct bem_output *o, const char *name, double time, double x,
                             double y);
enum status bem_output_statistics(struct bem_output *o, const struct bem_flow *f,
                                  const struct bem_stepper *stepper);

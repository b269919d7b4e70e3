/* From the solver's units to the result file. */
#pragma once
#include "bem/run/budget.h"
#include "bem/run/view.h"
#include "bem/shape/sides.h"
#include "bem/water/lattice.h"
#include "common/base/progress.h"
#include "common/case/case.h"
#include "common/result/result.h"

enum { BEM_OUTPUT_FIELDS = 7 };

struct bem_output {
  const struct case_file *c;
  const char *name; /* of the run */
  struct result *file;
  struct progress *progress;
  bool mirrored;     /* `c` is what a mirror shows of the case that is written (mirror.h) */
  bool forces;       /* on the walls are written */
  double spacing;    /* of the lattice that is written, H; 0: none is */
  double start;      /* of the run on the wall clock, s */
  double time_scale; /* sqrt(H/g), s */
  size_t next_output, next_sample;
  double spilled_volume; /* of what was removed, over the top of a wall, H^2 */
  struct bem_budget budget;
  size_t most_nodes;
  size_t left_out; /* rows, surfaces, pressures and powers that could not be found */
  struct bem_view view;
  struct bem_sides sides; /* scratch */
  struct geo_lines line;
  struct bem_lattice lattice;
  size_t room;
  double *field; /* values at nodes and lattice points in SI, [BEM_OUTPUT_FIELDS][n], owned */
};

enum status bem_output_create(struct bem_output *o, const struct bem_solve_options *options);
void bem_output_destroy(struct bem_output *o);

/* Writes what is due up to `time` (sqrt(H/g)), which the last step has passed: surfaces at the
 * multiples of time.every, a row of every series at those of time.sample, both interpolated by
 * CVODE. stepper NULL: the state at t = 0, which must be found. Just before the surface meets
 * itself there is no row. What else cannot be found is left out, counted, and said once: the flow
 * goes on in the same way. */
enum status bem_output_due(struct bem_output *o, const struct bem_flow *f,
                           struct bem_stepper *stepper, double time, double dt);

/* Whether the surface is so near a contact that psi is wrong. w: scratch, with room for it. */
bool bem_output_touches(struct bem_sides *w, const struct bem_surface *s);

/* Counts what the water gives to a tank and to sides that move during the step that ended at
 * `time`; a power that cannot be found is left out likewise, and the one before it holds on. */
enum status bem_output_given(struct bem_output *o, const struct bem_flow *f,
                             struct bem_stepper *stepper, double time, double dt);

/* Where a place of the solver (H) is in the case, m. */
void bem_output_place(const struct bem_output *o, double x, double y, double at[2]);

/* What the case calls the solver's left or right side. */
const char *bem_output_side(const struct bem_output *o, bool right);

enum status bem_output_event(struct bem_output *o, const char *name, double time, double x,
                             double y);
enum status bem_output_statistics(struct bem_output *o, const struct bem_flow *f,
                                  const struct bem_stepper *stepper, double steps_cut);

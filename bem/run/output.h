/* From the solver's units to the result file. */
#pragma once
#include "bem/run/stepper.h"
#include "bem/shape/sides.h"
#include "bem/water/flow.h"
#include "bem/water/lattice.h"
#include "bem/water/pressure.h"
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
  double removed_volume, removed_energy; /* H^2, rho g H^3 */
  double spilled_volume;                 /* of that, over the top of a wall, H^2 */
  struct {                               /* energy taken out by filter and smoothing, rho g H^3 */
    double start;                        /* of the last step, sqrt(H/g) */
    double until;                        /* what it was until then */
    double rate, last;                   /* mean during the step; at its end */
    bool changed;                        /* the water, since: `last` is of another shape */
  } damped;
  struct {              /* energy given to the moving tank, and to sides that move, rho g H^3 */
    double start, dt;   /* of the last step, sqrt(H/g) */
    double until[2];    /* what it was at its start */
    double power[2][2]; /* at its two points of Gauss's formula */
  } given;
  double drift; /* of the energy, relative to the initial one */
  double first_energy;
  size_t most_nodes;
  size_t left_out;        /* rows, surfaces, pressures and powers that could not be found */
  struct bem_flow view;   /* an interpolated state and its velocities; the run never sees it */
  struct bem_sides sides; /* scratch */
  struct bem_pressure pressure;
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

/* Counts what filter and smoothing take out of the energy during the step that ended at `time`. */
void bem_output_damped(struct bem_output *o, const struct bem_flow *f, double time, double dt);

/* The water has another shape from now on. */
void bem_output_changed(struct bem_output *o);

/* The energy and all that was taken out of it until the end of the last step, with psi of it. */
double bem_output_budget(const struct bem_output *o, const struct bem_flow *f, double time);

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

/* The state of a run, and what changes it other than the flow. Lengths are in H, times in
 * sqrt(H/g), rho = 1. */
#pragma once
#include "bem/breaking/breaker.h"
#include "bem/breaking/cuts.h"
#include "bem/breaking/runup.h"
#include "bem/run/output.h"
#include "bem/run/pace.h"
#include "bem/run/stepper.h"
#include "bem/shape/sides.h"
#include "bem/water/flow.h"
#include "bem/water/shore.h"

struct bem_run {
  const struct case_file *c;
  struct bem_shore *shore; /* of a tank that is not rectangular, else NULL; owned */
  struct bem_flow flow;
  struct bem_output output;
  struct bem_stepper *stepper;
  struct bem_pace pace;
  double top[2]; /* heights of the tops of the left and the right wall above the bed */
  double time, dt;
  struct bem_sides sides; /* of the surface, scratch */
  struct {
    bool leaned, overturned; /* has not been upright all the time; its tangent became vertical */
    double time, x, y;       /* when and where that was for the last time */
  } breaker[BEM_FACES];
  struct bem_runup runup[2]; /* of the left and the right edge */
  bool beach[2];             /* they have been on a side that is not upright */
  double start[2];           /* their heights at t = 0 */
  int rescues;               /* since the run last got on */
  double rescued;            /* when the last one was */
  bool overflowed, ended;
  bool lost; /* ended since it could not be followed */
};

enum bem_cut_kind {
  BEM_CUT_AT_WALL,
  BEM_CUT_THIN_FILM,
  BEM_CUT_TONGUE,
  BEM_CUT_TOP,
  BEM_CUT_SHEET,
  BEM_CUT_LOOP,
  BEM_CUT_WRINKLE
};

struct bem_cut {
  enum bem_cut_kind kind;
  struct bem_piece piece; /* of the last three */
  bool right;             /* of a thin film or a tongue: which end of the surface it has */
  double coarse;          /* of a film: so many times as thick as usual */
};

/* Starts the integrator afresh from the flow's surface. */
enum status bem_run_restart(struct bem_run *r);

/* Takes water away, books it, and starts afresh. */
enum status bem_run_cut(struct bem_run *r, const struct bem_cut *cut);

/* Cuts what has become too thin: films on walls, sheets, drops and bubbles. */
enum status bem_run_trim(struct bem_run *r);

/* Where a run does not get on: cuts what is not quite as thin, or smooths the wrinkle that stops
 * it. After some trials it ends the run in a sentence that says what cannot be followed. */
enum status bem_run_rescue(struct bem_run *r);

/* Lets edges of the water that have come to a bend of the walls pass it. */
enum status bem_run_pass_bends(struct bem_run *r);

/* The run goes no further than an event at (x, y). */
enum status bem_run_end(struct bem_run *r, double x, double y, const char *what, const char *then);

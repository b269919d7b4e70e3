/* The state of a run, and what changes it other than the flow. Lengths are in H, times in
 * sqrt(H/g), rho = 1. */
#pragma once
#include "bem/breaker.h"
#include "bem/flow.h"
#include "bem/output.h"
#include "bem/pace.h"
#include "bem/sides.h"
#include "bem/stepper.h"

struct bem_run {
  const struct case_file *c;
  struct bem_conformal *walls; /* of a tank that is not rectangular, else NULL; owned */
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
  bool overflowed, ended;
};

enum bem_cut { BEM_CUT_AT_WALL, BEM_CUT_THIN_FILM, BEM_CUT_TOP };

/* Starts the integrator afresh from the flow's surface. */
enum status bem_run_restart(struct bem_run *r);

/* Takes water away, books it, and starts afresh. */
enum status bem_run_cut(struct bem_run *r, enum bem_cut cut);

/* Cuts the film on the right wall where it has gone through it or has become too thin. */
enum status bem_run_trim_film(struct bem_run *r);

/* The run goes no further than an event at (x, y). */
enum status bem_run_end(struct bem_run *r, double x, double y, const char *what, const char *then);

/* Named instants as zeros of continuous functions, which CVODE's root finding locates. */
#pragma once
#include "bem/flow.h"
#include "bem/stepper.h"

enum bem_event {
  BEM_EVENT_IMPACT,    /* the thin tip reaches x = tank */
  BEM_EVENT_WALL,      /* the film there is thick enough: the surface is cut at the wall */
  BEM_EVENT_OVERTURN,  /* first vertical tangent of the main breaker */
  BEM_EVENT_TOUCHDOWN, /* the jet meets the surface below it */
  BEM_EVENT_OVER_LEFT, /* the surface on a wall passes its top */
  BEM_EVENT_OVER_RIGHT
};

struct bem_events {
  const struct bem_surface *surface;
  double thickness; /* H, of the film when BEM_EVENT_WALL happens */
  double top[2];    /* H, of the left and the right wall */
  bool overturned;
};

/* A bem_root_function (data: struct bem_events): every function falls through zero at its event. */
void bem_events_roots(void *events, double time, const double *state, double root[BEM_ROOTS]);

/* Distance of the jet from the water below, H; 1 while there is no jet. */
double bem_events_gap(const struct bem_events *e, const double *state);

/* Where event e, found at this state, happens. */
void bem_events_place(const struct bem_events *e, enum bem_event event, const double *state,
                      double *x, double *y);

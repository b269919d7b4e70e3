/* Named instants of a run as zeros of continuous functions, which CVODE's root finding locates, and
 * what is done then: one list, in events.c. */
#pragma once
#include "bem/run/run.h"

struct bem_event {
  const char *name;                                              /* in the result file */
  bool (*armed)(const struct bem_run *r);                        /* whether it can happen now */
  double (*value)(const struct bem_run *r, const double *state); /* falls through zero then */
  void (*where)(const struct bem_run *r, double at[2]);          /* place, H */
  /* (x, y): the place where it happened, H */
  enum status (*act)(struct bem_run *r, const struct bem_event *e, double x, double y);
};

/* The roots of all events; data: struct bem_run. */
extern const struct bem_roots bem_events_roots;

/* Acts on those that were found at the state of r->flow.surface until one ends the run. */
enum status bem_events_act(struct bem_run *r, const int *found);

/* Writes what is known only at the end of the run: how far the edges ran up, and the last vertical
 * tangent of either face, which is the breaker's. */
enum status bem_events_conclude(struct bem_run *r);

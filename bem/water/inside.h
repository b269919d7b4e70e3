/* What the water does at any point inside it, by Cauchy's integral over the surface. The velocity
 * is the mean of its own values there, not the derivative of the potential's mean, so that it is as
 * exact beside the surface as far from it. */
#pragma once
#include "bem/water/pressure.h"

struct bem_inside {
  size_t room;
  double *re,
      *im; /* at the nodes: what gives the velocity, analytic and real on the walls; owned */
  struct bem_chart chart;    /* of the map where it was last asked for; not for rectangles */
  double complex tau, sweep; /* a point of its plane, and the sweep there; of walls that move */
};

struct bem_place {
  double phi, pressure; /* H sqrt(gH), rho g H */
  double complex w;     /* u - i v, sqrt(gH) */
};

/* For the state that was solved last, by bem_flow_solve with keep = 1 and bem_pressure_solve.
 * ERR_MEMORY; ERR_SOLVER where a node is on a bend of the walls. */
enum status bem_inside_begin(struct bem_inside *b, const struct bem_flow *f);
void bem_inside_destroy(struct bem_inside *b);

/* The next point is near this node of the surface. */
void bem_inside_start(struct bem_inside *b, const struct bem_pressure *p, const struct bem_flow *f,
                      size_t node);

/* The next point is near this one of the walls of a tank that is not rectangular. False: it is a
 * bend of them, or the map was not found there. */
bool bem_inside_start_on_wall(struct bem_inside *b, const struct bem_pressure *p,
                              const struct bem_flow *f, double complex z);

/* At a point of the water, to which a straight line inside it leads from the last one. False: the
 * map was not found there. */
bool bem_inside_at(struct bem_inside *b, const struct bem_pressure *p, const struct bem_flow *f,
                   const double *state, double complex z, struct bem_place *out);

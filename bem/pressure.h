/* Pressure on the walls: the rate of change of the potential is harmonic too and known on the
 * surface by Bernoulli's equation, so the system just solved for psi gives it with another
 * right-hand side. */
#pragma once
#include "bem/flow.h"

struct bem_pressure {
  size_t room;
  double *phi_t, *psi_t; /* rate of change of phi and psi at the nodes, g H, [n], owned */
  struct bem_rule wet;   /* the walls under water, owned */
};

void bem_pressure_destroy(struct bem_pressure *p);

/* Call after bem_flow_solve(f, state, keep = 1). */
enum status bem_pressure_solve(struct bem_pressure *p, struct bem_flow *f, const double *state);

/* Pressure (rho g H) at a point of a wall of the same state, which is named by where the wall is at
 * rest; 0 where it is dry. ERR_SOLVER. */
enum status bem_pressure_at(const struct bem_pressure *p, const struct bem_flow *f,
                            const double *state, double x, double y, double *pressure);

/* The same at a point of a wall under water whose image and d zeta / dz are known. */
void bem_pressure_seen(const struct bem_pressure *p, const struct bem_flow *f, const double *state,
                       double complex z, double complex zeta, double complex slope,
                       double *pressure);

/* Lays p->wet along the walls under water, densely enough for the pressure on them. ERR_MEMORY. */
enum status bem_pressure_wet(struct bem_pressure *p, const struct bem_flow *f);

/* The same at a point z of a wall where it is. */
enum status bem_pressure_on(const struct bem_pressure *p, const struct bem_flow *f,
                            const double *state, double complex z, double *pressure);

/* Where sides move or the tank turns, what the rate of change of phi, at z with the velocity w and
 * this known part, has besides what phi_t and psi_t give; at a place that turns with the tank, less
 * what is due to that. */
double bem_pressure_swept(const struct bem_flow *f, const struct bem_part *part, double complex z,
                          double complex w);

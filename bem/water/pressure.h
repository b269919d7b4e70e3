/* Pressure on the walls: the rate of change of the potential is harmonic too and known on the
 * surface by Bernoulli's equation, so the system just solved for psi gives it with another
 * right-hand side. */
#pragma once
#include "bem/motion/sweep.h"
#include "bem/water/flow.h"

struct bem_pressure {
  size_t room;
  double *phi_t, *psi_t; /* rate of change of phi and psi at the nodes, g H, [n], owned */
  struct bem_rule wet;   /* the walls under water, owned */
  struct bem_flux unit;  /* of a tank that turns at the rate of one; of use to spin.h */
  struct {               /* of walls of any shape whose sides move: */
    struct bem_map_rate rate;
    struct bem_flux flux;  /* the rate of change of the known part at a fixed zeta */
    double complex *nodes; /* rates of change of z at a fixed zeta, [n], owned */
    double complex *wet;   /* the same at the points of `wet`, [wet_room], owned */
    size_t wet_room;
    struct bem_rule rule; /* scratch */
  } sweep;
};

/* Whether the map of the walls changes. */
static inline bool bem_pressure_is_swept(const struct bem_flow *f) {
  return f->motion.sides && f->surface.walls;
}

void bem_pressure_destroy(struct bem_pressure *p);

/* Call after bem_flow_solve(f, state, keep = 1). */
enum status bem_pressure_solve(struct bem_pressure *p, struct bem_flow *f, const double *state);

/* Pressure (rho g H) at a point of a wall of the same state, which is named by where the wall is at
 * rest; 0 where it is dry, as it was where that fails. ERR_SOLVER. */
enum status bem_pressure_at(struct bem_pressure *p, const struct bem_flow *f, const double *state,
                            double x, double y, double *pressure);

/* A point of a wall under water: its image, d zeta / dz, and, where sides of walls of any shape
 * move, dz/dt at a fixed zeta. Water at a bend goes with it: on the inside of one it must stay on
 * both sides. There the slope is given as 0, and the sweep is dz/dt at the bend, whose image may
 * move. */
struct bem_seen {
  double complex z, zeta, slope, sweep;
  size_t bend; /* of the map's points, that it is; 0: none */
};

/* The same there. */
double bem_pressure_seen(const struct bem_pressure *p, const struct bem_flow *f,
                         const double *state, const struct bem_seen *at);

/* Point j of p->wet. */
struct bem_seen bem_pressure_wet_point(const struct bem_pressure *p, const struct bem_flow *f,
                                       size_t j);

/* Lays p->wet along the walls under water, densely enough for the pressure on them. ERR_MEMORY. */
enum status bem_pressure_wet(struct bem_pressure *p, const struct bem_flow *f);

/* What bem_pressure_wet_point needs besides, after bem_pressure_solve. ERR_MEMORY. */
enum status bem_pressure_wet_sweep(struct bem_pressure *p, const struct bem_flow *f);

/* The same at a point z of a wall where it is. */
enum status bem_pressure_on(struct bem_pressure *p, const struct bem_flow *f, const double *state,
                            double complex z, double *pressure);

/* Where sides move or the tank turns, what the rate of change of phi, at z with the velocity w and
 * this known part, has besides what phi_t and psi_t give; at a place that turns with the tank, less
 * what is due to that. */
double bem_pressure_swept(const struct bem_flow *f, const struct bem_part *part, double complex z,
                          double complex w);

/* Tanks that move, and sides that do. The water is followed in the frame of the tank: what moves
 * all of it to and fro is a force on the water there. Where the tank rolls as well, the potential
 * is that of the velocity in a frame that goes with the tank's origin and does not turn, whose
 * components along the tank's axes are taken: its walls have the flux of a body that turns
 * (flux.h). A piston changes the length of a rectangular tank, and with it the map; its flux is
 * carried by a part of beta that is known, beta = -u_l (x_r
 * - z)^2/(2 l) + u_r (z - x_l)^2/(2 l),   l = x_r - x_l, whose velocity is u_l at the left side,
 * u_r at the right one, and along the bed at the bed. What is left has psi = 0 on all walls. */
#pragma once
#include <complex.h>

#include "bem/motion/flux.h"
#include "common/case/case.h"

struct bem_motion {
  const struct case_file *c;
  double scale;      /* of time, sqrt(H/g), s */
  bool frame;        /* the tank moves */
  bool rolls;        /* and turns */
  bool sides;        /* a side does */
  double rest;       /* x of the right side where the case draws it, H */
  double side[2][3]; /* x, velocity and acceleration of the sides of a rectangular tank at the time
                        that was asked for last, H and sqrt(H/g) */
  double push[2];    /* the force on water then, besides a weight that points down the tank, g */
  double complex origin; /* where the solver's x = y = 0 is in the tank, H */
  double turn, turning;  /* rate of turning and its rate of change, sqrt(g/H), g/H */
  double top;            /* height that the sides of a tank that turns are taken to have, H */
};

/* What of beta is known: its value, derivative by z, and by t at a fixed z, H and sqrt(H/g); of a
 * tank that turns also what it is at a rate of one. */
struct bem_part {
  double complex beta, w, rate, unit;
};

struct bem_motion bem_motion_create(const struct case_file *c);

/* Fills `side` and `push`. time: sqrt(H/g). */
void bem_motion_at(struct bem_motion *m, double time);

/* What of the velocity of a point is that of the frame, sqrt(gH). */
static inline struct bem_rigid bem_motion_turn(const struct bem_motion *m, double turn) {
  return (struct bem_rigid){I * turn * m->origin, turn};
}
static inline double complex bem_motion_carries(const struct bem_motion *m, double complex z) {
  return I * m->turn * (z + m->origin);
}

/* Water that ends on the bed knows nothing of the right side: the map's is another, at rest, as far
 * beyond it as the tank is long at rest. */
void bem_motion_stop_short(struct bem_motion *m);

/* Velocity of the tank's origin along the tank's axes, sqrt(gH). */
void bem_motion_velocity(const struct bem_motion *m, double time, double velocity[2]);

struct bem_part bem_motion_part(const struct bem_motion *m, double complex z);

/* Kinetic energy of the known part in the water that reaches to these heights at the sides, as far
 * as it is an integral along them: 1/2 integral of phi dphi/dn. rho g H^3 */
double bem_motion_kinetic(const struct bem_motion *m, const double height[2]);

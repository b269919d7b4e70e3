/* One evaluation of the flow: from the surface and the potential on it to the velocity of every
 * node and the rate of change of its potential. */
#pragma once
#include <complex.h>

#include "bem/kernel/guess.h"
#include "bem/kernel/panels.h"
#include "bem/kernel/solve.h"
#include "bem/motion/motion.h"
#include "bem/motion/moving.h"
#include "bem/shape/mesh.h"
#include "bem/shape/surface.h"

struct bem_flow {
  struct bem_panels panels;
  struct bem_guess guess; /* of psi, in rates */
  struct bem_solve *solve;
  struct bem_mesh mesh;
  struct bem_surface surface; /* at the start of the step; its shape's facts hold during the step */
  struct bem_motion motion;   /* of the tank and its sides */
  struct bem_moving moving;   /* walls of any shape whose sides move; owned */
  double time;                /* of the next evaluation, if anything moves, sqrt(H/g) */
  double level;               /* y where the Bernoulli constant makes p = 0 in water at rest, H */
  double smoothing;           /* rate of the five-point formula at the thin tip, sqrt(g/H) */
  double filter;              /* rate of the sixth-difference filter everywhere, sqrt(g/H) */
  size_t room;
  double *psi, *u, *v, *tx, *ty, *q; /* nodal values of the last evaluation, [n], owned */
  double *phi_own, *psi_own;         /* phi and psi less what is known, where a part is, in psi's */
  struct bem_part *known;            /* what is known at the nodes, [n], owned */
  struct bem_flux through; /* of these walls: of a tank that turns and has no sides that move, at
                              the rate of one */
  double *damping;         /* part of the last rates that removes noise, [3n], in psi's */
  double *back;            /* scratch of that, [2n], in psi's */
  double complex *w;       /* u - i v, [n], owned */
  enum status status;      /* why an evaluation failed */
};

enum status bem_flow_reserve(struct bem_flow *f, size_t n);
void bem_flow_destroy(struct bem_flow *f);

/* Gives `view`, which shares no memory with f, the shape of f's surface (not its state) and f's psi
 * as the first guess: whoever looks at the flow solves there and cannot touch the run. */
enum status bem_flow_follow(struct bem_flow *view, const struct bem_flow *f);

/* Whether walls drive the water, which then has a known part of beta with a rate of its own. */
static inline bool bem_flow_is_driven(const struct bem_flow *f) {
  return f->motion.sides || f->motion.rolls;
}

/* What the velocity of the potential is on a side of walls of any shape, and its rate of change at
 * a fixed place, of which the part along the wall is of no meaning. */
static inline struct bem_rigid bem_flow_body(const struct bem_flow *f, size_t side) {
  const struct bem_rigid own = f->moving.body[side],
                         frame = bem_motion_turn(&f->motion, f->motion.turn);
  return (struct bem_rigid){own.velocity + frame.velocity, own.turn + frame.turn};
}
static inline struct bem_rigid bem_flow_body_rate(const struct bem_flow *f, size_t side) {
  const struct bem_rigid own = f->moving.rate[side],
                         frame = bem_motion_turn(&f->motion, f->motion.turning);
  return (struct bem_rigid){own.velocity + frame.velocity, own.turn + frame.turn};
}

/* Whether a part of beta is known, and what it is in this state at z, whose image is zeta with
 * slope d zeta / dz. */
static inline bool bem_flow_has_part(const struct bem_flow *f) {
  return bem_surface_is_closed(&f->surface) || bem_flow_is_driven(f);
}
struct bem_part bem_flow_part(const struct bem_flow *f, const double *state, double complex z,
                              double complex zeta, double complex slope);

/* What pressure is without motion in the frame of the tank, less its sign, H. */
double bem_flow_head(const struct bem_flow *f, double x, double y);

/* Moves the walls to where they are at a time. ERR_MEMORY, ERR_SOLVER. */
enum status bem_flow_move(struct bem_flow *f, double time);

/* psi, w, u, v of the surface `state` (x[n], y[n], phi[n]). keep: see bem_solve_first. */
enum status bem_flow_solve(struct bem_flow *f, const double *state, int keep);

/* d state / dt, [3n], of the state at a time. */
enum status bem_flow_rates(struct bem_flow *f, double time, const double *state, double *rate);

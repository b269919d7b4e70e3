/* What is known of beta where walls move: an analytic function with the flux through them, which is
 * that of sides that move as rigid bodies,
 *     F = -1/pi integral of q log(xi - zeta) d xi,   q = d psi / d xi on the walls.
 * The sides are taken to go on far above the water, so that F is smooth at its edges. */
#pragma once
#include <stdbool.h>

#include "bem/map/rule.h"

/* A rigid body in the frame of the tank: z moves with velocity + i turn z. H and sqrt(H/g). */
struct bem_rigid {
  double complex velocity;
  double turn;
};

static inline double complex bem_rigid_at(struct bem_rigid r, double complex z) {
  return r.velocity + I * r.turn * z;
}

static inline bool bem_rigid_moves(struct bem_rigid r) {
  return r.velocity != 0 || r.turn != 0;
}

/* A stream function of that, along any wall of which the water passes to the right of it. */
static inline double bem_rigid_stream(struct bem_rigid r, double complex z) {
  return cimag(conj(r.velocity) * z) - 0.5 * r.turn * creal(z * conj(z));
}

struct bem_flux {
  struct bem_rule rule;
  size_t room;
  double *q, *g; /* q, and psi from where its side begins; [BEM_RULE rule.panels], owned */
  double *q_weight, *g_weight; /* the same times the weights */
  double complex top;          /* where the first side begins */
  size_t ends;                 /* sides with flux: which they are, where they end, and psi there */
  size_t side[BEM_MOST_BENDS + 1];
  double end[BEM_MOST_BENDS + 1], jump[BEM_MOST_BENDS + 1];
};

void bem_flux_destroy(struct bem_flux *f);

/* Zero *f before the first call. For the walls m, whose side i moves like body[i], [m->n + 1]; the
 * first and the last of them end at the height `top`, H. ERR_MEMORY, ERR_SOLVER. */
enum status bem_flux_set(struct bem_flux *f, const struct bem_conformal *m,
                         const struct bem_rigid *body, double top);

/* The parts of that: lays the points on the sides that are to have a flux, [m->n + 1]; then takes
 * q and g at them, of which g may have any constant on every side. before: g where each of these
 * sides begins. */
enum status bem_flux_lay(struct bem_flux *f, const struct bem_conformal *m, const bool *driven,
                         double top);
void bem_flux_fill(struct bem_flux *f, const double *before);

/* F and dF/dzeta on the real axis or above it. The slope is of no meaning at a bend beside a side
 * with flux, where it may be infinite. */
void bem_flux_at(const struct bem_flux *f, double complex zeta, double complex *value,
                 double complex *slope);

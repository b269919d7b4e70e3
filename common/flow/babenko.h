/* Steady waves under gravity 1 on a conformal strip of thickness 1: the level eta of their surface
 * above 0, the bed being at -1, at the points xi of half a wave from its crest.
 *
 * Babenko's equation, F^2 C eta - eta = C(eta^2)/2 + eta C eta, C = k coth k: D. Clamond & D.
 * Dutykh, Comput. Fluids 84 (2013) 35-38, for solitary waves; J. Fluid Mech. 844 (2018) 491-518,
 * for periodic ones. Petviashvili's iteration, which they use, ends where the speed has its maximum
 * (A/h = 0.796). Here KINSOL (Newton with GMRES) finds eta, F^2 and half the wave together, for a
 * height, step by step from a low wave; solved is what C^-1 makes of the equation, whose derivative
 * is F^2 - 2 eta but for what is compact, with as many points as the cosine series wants. */
#pragma once
#include <stddef.h>

#include "common/base/status.h"

struct babenko_wanted {
  double height; /* of the crest: above the trough, over the mean depth; solitary: above 0 */
  double length; /* over the mean depth; 0: solitary */
  double limit;  /* height of the highest of this length */
};

struct babenko {
  double f2, half; /* F^2; of the period in xi */
  size_t n;        /* intervals of half a wave */
  double *eta;     /* [n + 1], from the crest on, owned */
};

/* F^2 of a solitary wave by a series in A (J. Fenton, J. Fluid Mech. 53, 1972), to 1.1 %; and the
 * decay kappa of its tail, tan kappa = F^2 kappa. */
double wave_babenko_solitary_about(double amplitude);
double wave_babenko_decay(double f2);

/* ERR_MEMORY, ERR_SOLVER; destroy *b even then. */
enum status wave_babenko_solve(const struct babenko_wanted *wanted, struct babenko *b);
void wave_babenko_destroy(struct babenko *b);

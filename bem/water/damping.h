/* What keeps noise of the size of the spacing away. */
#pragma once
#include "bem/water/flow.h"

/* Adds to the rate of change of every node, [3n], what the filter everywhere and the smoothing at
 * the thin end of a sheet do, which is kept in f->damping. Call with u, v of this state. */
void bem_damping_add(struct bem_flow *f, const double *state, double *rate);

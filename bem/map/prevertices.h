/* The parameter problem of the Schwarz-Christoffel map: prevertices for which the sides between the
 * bends have the lengths that they have. */
#pragma once
#include "bem/map/conformal.h"

/* Finds m->xi and m->factor for m->point and m->power. ERR_MEMORY, ERR_SOLVER. */
enum status bem_prevertices_find(struct bem_conformal *m);

/* The same from what they were for walls that were nearly there. */
enum status bem_prevertices_follow(struct bem_conformal *m);

/* Length of the image of the side from bend k to the next, for |C| as it is. */
double bem_conformal_length(const struct bem_conformal *m, size_t k);

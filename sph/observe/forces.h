/* Forces of the water on the walls of its tank: what the pair loops let wall particles give to the
 * water, the other way round, so that they change its momentum by exactly that, weight and the
 * force of a tank that moves. What a particle that has crossed a wall and is reflected gives
 * (wall.h) is not in them.
 *
 * Of a single straight piece of wall it is what its normal has of the forces of the wall particles
 * behind it, and of those about its corners, whose force is one along the normals of both their
 * faces. Then still water presses on it as it should, rho g h^2/2 on a side; without the corner it
 * would lack a third of a spacing of it, since no water is there where the bed is. What the
 * particles behind the other face give along that is left out: it takes from the momentum as much
 * as those about the corner give. */
#pragma once
#include "sph/sph.h"

/* N/m, N (diagnose.h). */
struct sph_forces {
  double x, y, moment, left, right;
};

/* After sph_rates(s, 0, ...) with the derivative of the kernel. The same bits for any number of
 * threads. ERR_MEMORY. */
enum status sph_forces_find(struct sph *s, struct sph_forces *out);

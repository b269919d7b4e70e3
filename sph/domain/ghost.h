/* Fixed ghost particles with free slip (Marrone, Antuono, Colagrossi, Colicchio, Le Touze &
 * Graziani, Comput. Methods Appl. Mech. Engrg. 200, 2011), for a tank with upright sides and a flat
 * bed.
 *
 * Ghosts fill the walls to the depth of the support on a fixed lattice. Each has an interpolation node, its
 * mirror image in the wall (in a corner: mirrored in both walls, which is through the corner
 * point). At the node, p and u are fitted to the water by moving least squares (mls.h), and the
 * ghost takes u_g = u* with the normal component reversed, the tangential one kept; p_g = p* + rho*
 * f . (r_g - r*): at a fixed flat wall dp/dn = rho f.n, and r_g - r* points along the normal, so
 * below the bed at depth d the ghost gets 2 d rho g more than its node, and beside an upright wall
 * the same.
 *
 * Ghosts take part in everything: divergence, pressure force, viscosity, diffusion and the
 * renormalised gradient. In still water the density is linear in y; the ghosts' values then
 * continue it linearly through the wall, so that Antuono's psi vanishes in every pair and the
 * renormalised gradient is exact up to the wall: the hydrostatic solution is kept. For this the
 * ghosts also need a gradient: that of the fit, whose excess over the hydrostatic one is reflected
 * like a velocity. A ghost whose node is far from water is dry; no water is then near the ghost
 * either.
 *
 * Fitted values do a little work on the water, which falls with the spacing where the flow is
 * smooth. Noisy flow without viscosity and diffusion needs mirror.h. */
#pragma once
#include "sph/domain/wall.h"

extern const struct sph_wall sph_wall_ghost;

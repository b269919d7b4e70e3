/* Moving mirror images with free slip (Colagrossi & Landrini, J. Comput. Phys. 191, 2003), for a
 * tank with upright sides and a flat bed.
 *
 * Every particle of water j near a wall has an image there, with its volume, its velocity with the
 * normal component reversed, and p_j' = p_j + rho_j f . (r_j' - r_j): beside an upright wall the
 * same pressure, below the bed 2 d rho g more. In a corner there is a third image, mirrored in both
 * walls. In still water the images continue the linear pressure through the wall, and its
 * renormalised gradient, whose excess over the hydrostatic one is reflected like a velocity, as the
 * fixed ghosts do (ghost.h).
 *
 * Upright walls do no work, whatever the noise. Particle i meets the image j' exactly when j meets
 * i', and the way from j to i' is the way from i to j' mirrored and turned round: with R the
 * reflection of vectors, grad_j W_ji' = -R grad_i W_ij'. The power that the two take out (rates.h),
 *
 *   V_i V_j ((p_j u_i + p_i R u_j) . grad_i W_ij' + (p_i u_j + p_j R u_i) . grad_j W_ji') = 0,
 *
 * vanishes term by term. At the bed only the work of the hydrostatic part is left. Values fitted to
 * the water (ghost.h) lack this symmetry between the velocity in the continuity equation and the
 * pressure in the momentum equation: where nothing damps the noise, without viscosity and
 * diffusion, ghosts pump energy into the noisy sheets on a wall, several times what the dam break
 * began with.
 *
 * The price: the first impact of a thin tip on a wall is harder than with ghosts, perhaps because
 * it meets its own thin image only. It sends out stronger sound, and diffusion takes more energy
 * out: with Antuono's, at H/dx = 50, 0.9 % of the whole in place of 0.2 %. */
#pragma once
#include "sph/domain/wall.h"

extern const struct sph_wall sph_wall_mirror;

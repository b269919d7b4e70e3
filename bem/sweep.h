/* How the map of walls that move moves the points that have the same zeta, z = f(zeta, t): f_t is
 * an integral of d f_t / dzeta = f' (d log C/dt + sum d alpha_k/dt log(zeta - xi_k) - sum power_k d
 * xi_k/dt / (zeta - xi_k)) from a bend, beside which it is followed at a fixed way from the bend.
 */
#pragma once
#include "bem/moving.h"

/* f_t and its derivative at the points of a rule, [BEM_RULE r->panels]. */
void bem_sweep_rule(const struct bem_moving *m, const struct bem_map_rate *rate,
                    const struct bem_rule *r, double complex *sweep, double complex *slope);

/* f_t at a point of a side of the map, where dz/dzeta is `slope`. r: scratch. ERR_MEMORY. */
enum status bem_sweep_wall(const struct bem_moving *m, const struct bem_map_rate *rate,
                           struct bem_rule *r, size_t side, double xi, double complex slope,
                           double complex *sweep);

/* f_t at n points of the plane of the map, which follow each other closely; sweep[0] is known. */
void bem_sweep_along(const struct bem_moving *m, const struct bem_map_rate *rate,
                     const struct bem_gauss *g, size_t n, const double complex *zeta,
                     double complex *sweep);

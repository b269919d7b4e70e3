/* How the map of walls that move moves the points that have the same zeta, z = f(zeta, t): f_t is
 * an integral of d f_t / dzeta = f' (d log C/dt + sum d alpha_k/dt log(zeta - xi_k) - sum power_k d
 * xi_k/dt / (zeta - xi_k)) from a bend, beside which it is followed at a fixed way from the bend.
 * Where the image of a bend moves beside which there is a flux, that of a point at a fixed zeta has
 * no finite rate of change there; then zeta drifts with V(zeta), the real polynomial that is d
 * xi_k/dt at all bends: what is harmonic stays so, and f_t + V f', the sweep, is the velocity of
 * the bend there. */
#pragma once
#include "bem/motion/moving.h"

/* d zeta/dt of what is followed, V, and its derivative; 0 where nothing drifts. */
double complex bem_sweep_drift(const struct bem_moving *m, const struct bem_map_rate *rate,
                               double complex zeta, double complex *slope);

/* The sweep and its derivative at the points of a rule, [BEM_RULE r->panels]. */
void bem_sweep_rule(const struct bem_moving *m, const struct bem_map_rate *rate,
                    const struct bem_rule *r, double complex *sweep, double complex *slope);

/* The sweep at a point of a side of the map, where dz/dzeta is `slope`. r: scratch. ERR_MEMORY. */
enum status bem_sweep_wall(const struct bem_moving *m, const struct bem_map_rate *rate,
                           struct bem_rule *r, size_t side, double xi, double complex slope,
                           double complex *sweep);

/* The sweep at a point of the plane of the map, from what it is at another. */
double complex bem_sweep_on(const struct bem_moving *m, const struct bem_map_rate *rate,
                            const struct bem_gauss *g, double complex from, double complex to,
                            double complex sweep);

/* The sweep at n points of the plane of the map, which follow each other closely; sweep[0] is
 * known. */
void bem_sweep_along(const struct bem_moving *m, const struct bem_map_rate *rate,
                     const struct bem_gauss *g, size_t n, const double complex *zeta,
                     double complex *sweep);

/* What an integrator makes of a state within a step, as rows of coefficients, from which a step of
 * the water (partitioned.c, rk.c) and one of a linear test problem (linear.h) follow alike.
 *
 * With the state (x0, u0, rho0) at the start of a step and the rates X_l, A_l, R_l that stage l has
 * found for positions, velocities and densities, row r is the state
 *
 *   u_r   = keep u0 + dt sum_l u[l] A_l
 *   x_r   = x0 + dt (sum_l x[l] X_l + own u_r)
 *   rho_r = rho0 + dt sum_l rho[l] R_l                        l < r
 *
 * Row 0 is the start, row n the end; stage r < n evaluates the rates of row r. */
#pragma once
#include "sph/fluid/particles.h"

struct sph_integrator;

struct sph_row {
  double keep, own;
  double x[SPH_MAX_STAGES], u[SPH_MAX_STAGES], rho[SPH_MAX_STAGES];
};

struct sph_stages {
  int n;
  struct sph_row row[SPH_MAX_STAGES + 1];
};

/* `damping`: Gamma dt, of methods that damp. */
struct sph_stages sph_stages_of(const struct sph_integrator *method, double damping);

/* Up to what time step a scheme is stable in water at rest: its own integrator, applied to every
 * plane wave that a square lattice carries.
 *
 * About rest each wave is a linear problem by itself. With u = i w, in units of h, c0 and rho0, it
 * is real (symbols: lattice.h),
 *
 *   rho' = G . w - delta D rho,   w' = -G rho - alpha [xx xy; xy yy] w
 *
 * and a step multiplies (rho, w) by a matrix of 3 x 3. Where the density is a sum over neighbours
 * it follows from displacements i X, X' = w: rho = G . X, and the matrix is that of (X along G, w).
 * It is found by giving the integrator, in place of particles, the three columns of the unit matrix
 * for each wave, and in place of the pair loops the right-hand side above (struct sph_stand_in): an
 * integrator needs nothing more than its step. */
#pragma once
#include "common/base/status.h"
#include "sph/scheme.h"

/* Waves by `n` steps from 0 to pi/dx along each axis; those that symmetry repeats are left out. */
struct sph_modes;
enum status sph_modes_create(const struct sph_scheme *o, int n, struct sph_modes **m);
void sph_modes_destroy(struct sph_modes *m); /* NULL is fine */

/* The largest factor by which a step of c0 dt/h = `courant` multiplies any wave, and its wave
 * number k h in wave[2] (or NULL). */
enum status sph_modes_growth(struct sph_modes *m, double courant, double *growth, double *wave);

/* The largest c0 dt/h up to which no wave grows at more than `rate` (c0/h), to 1e-4 of it. What
 * methods of low order let grow slowly is harmless in runs that are short against 1/rate. */
enum status sph_modes_limit(struct sph_modes *m, double rate, double *courant);

/* That of a scheme, by 32 steps along each axis: the worst wave may lie between two, which makes
 * the limit up to 3e-3 too long. */
enum status sph_stable_courant(const struct sph_scheme *o, double rate, double *courant);

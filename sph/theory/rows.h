/* hSPH (thesis, 4.2) linearised about rows of particles at rest, y = -j h from the surface down,
 * the last half a spacing above the bed, whose images lie below it. A perturbation in proportion to
 * e^(i k x) stays one, row by row: velocity and pressure drive each other through the slopes of the
 * plane fitted to all particles within `radius`, with unit weights, and p = 0 is kept on the first
 * row or is not. Density 1; the rows fill a unit of length, L, and times have a unit of the
 * caller's, T. */
#pragma once
#include <complex.h>
#include <stdbool.h>

#include "common/base/status.h"

enum { SPH_ROWS_MOST = 128, SPH_ROWS_REACH = 4 };

/* By rows: displacements, velocities, and the pressure that a particle has gained. */
struct sph_rows_state {
  double complex x[SPH_ROWS_MOST], y[SPH_ROWS_MOST], u[SPH_ROWS_MOST], v[SPH_ROWS_MOST],
      p[SPH_ROWS_MOST];
};

struct sph_rows {
  int n;
  bool keep;    /* p = 0 on the first row */
  double h, k;  /* spacing, L; wavenumber, 1/L */
  double g, c2; /* gravity, L/T^2; sound speed squared, L^2/T^2 */
  /* d/dx f = i sum along f, d/dy f = sum up f, of the rows up to SPH_ROWS_REACH below ([REACH + 1],
   * ...) and above ([REACH - 1], ...) each. */
  double along[SPH_ROWS_MOST][2 * SPH_ROWS_REACH + 1], up[SPH_ROWS_MOST][2 * SPH_ROWS_REACH + 1];
  struct sph_rows_state w;
};

/* n rows, SPH_ROWS_REACH to SPH_ROWS_MOST, 1/n apart; k (1/L), g (L/T^2), c2 (L^2/T^2); `radius` in
 * h, at most SPH_ROWS_REACH. By value: there is nothing to destroy. */
struct sph_rows sph_rows_at_rest(int n, double k, double g, double c2, double radius, bool keep);
/* A deep wave of amplitude 1 that travels to the right, in its displaced particles. */
void sph_rows_airy(struct sph_rows *l);

void sph_rows_rates(const struct sph_rows *l, const struct sph_rows_state *w,
                    struct sph_rows_state *r);
/* By dt (T), as sph_rk4. */
void sph_rows_step(struct sph_rows *l, double dt);
/* On the wave e^(k y) if that is `kept`, else on nothing: velocities, the pressures of a wave to
 * the right, and, if asked, the first row's height (treat/projection.c). The first row lies on the
 * surface, and half of it is water. */
void sph_rows_project(struct sph_rows *l, bool kept, bool first_row);

/* How far the row is off the Airy wave of amplitude 1 at t, over its amplitude there, in u, v,
 * dynamic pressure and the acceleration's components, and the rate of the dynamic pressure: at x by
 * e^(i k x) times it, so that its magnitude is what the worst particle has. */
enum {
  SPH_ROWS_U,
  SPH_ROWS_V,
  SPH_ROWS_P,
  SPH_ROWS_AX,
  SPH_ROWS_AY,
  SPH_ROWS_RATE,
  SPH_ROWS_QUANTITIES
};
void sph_rows_off(const struct sph_rows *l, const struct sph_rows_state *rates, double t, int row,
                  double complex off[SPH_ROWS_QUANTITIES]);
/* The wave in the velocities of all rows, weighted by e^(k y); it turns with -omega. */
double complex sph_rows_wave(const struct sph_rows *l);

/* The fastest growth of any of its modes, 1/T, by their eigenvalues. ERR_MEMORY, ERR_SOLVER. */
enum status sph_rows_growth(const struct sph_rows *l, double *growth);

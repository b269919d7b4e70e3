/* Small complex matrices, rows one after the other. */
#pragma once
#include <complex.h>

#include "common/base/status.h"
#include "sph/time/integrator.h"

enum { THEORY_LARGEST = 4 };

struct theory_matrix {
  int n; /* at most THEORY_LARGEST */
  double complex a[THEORY_LARGEST][THEORY_LARGEST];
};

/* Its eigenvalues, by LAPACK. ERR_SOLVER. */
enum status theory_eigenvalues(const struct theory_matrix *m, double complex *lambda);
/* The largest magnitude of them. */
enum status theory_radius(const struct theory_matrix *m, double *radius);

/* The largest |lambda|^2 - 1 of the matrix 1 + d, 2 x 2, to rounding of d's entries: growth that is
 * too slow to be seen beside 1. */
double theory_excess(const struct theory_matrix *d);

/* What a step of the particle solver's integrator does to w, where dw/dt = Z w in a unit of time
 * and w is position, velocity and density, or the first two. `damping` is Gamma, of methods that
 * damp. */
struct theory_matrix theory_step(const struct sph_integrator *method, const struct theory_matrix *z,
                                 double damping);

/* Of n variables from the first on, which no other changes. */
struct theory_matrix theory_block(const struct theory_matrix *m, int first, int n);

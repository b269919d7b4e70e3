/* Small complex matrices, rows one after the other. */
#pragma once
#include <complex.h>
#include <stdbool.h>

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

/* The largest number up to `high` below which nothing grows, by halving, to 1e-10. 0: there is
 * none; what is found then is below 1e-7, where rounding decides. */
double theory_limit(bool (*grows)(double courant, const void *with), const void *with, double high);

/* Waves k h = pi i/THEORY_WAVES, i = 1, 2, ..., among which the one that grows fastest is looked
 * for; those of k h = 0 neither move nor grow. */
enum { THEORY_WAVES = 720 };

/* What a step of the particle solver's integrator does to w, where dw/dt = Z w in a unit of time
 * and w is position, velocity and density, or the first two. `damping` is Gamma, of methods that
 * damp. */
struct theory_matrix theory_step(const struct sph_integrator *method, const struct theory_matrix *z,
                                 double damping);

/* Of n variables from the first on, which no other changes. */
struct theory_matrix theory_block(const struct theory_matrix *m, int first, int n);

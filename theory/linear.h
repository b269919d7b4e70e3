/* Small complex matrices, rows one after the other. */
#pragma once
#include <complex.h>

#include "common/base/status.h"

enum { THEORY_LARGEST = 4 };

struct theory_matrix {
  int n; /* at most THEORY_LARGEST */
  double complex a[THEORY_LARGEST][THEORY_LARGEST];
};

/* Its eigenvalues, by LAPACK. ERR_SOLVER. */
enum status theory_eigenvalues(const struct theory_matrix *m, double complex *lambda);
/* The largest magnitude of them. */
enum status theory_radius(const struct theory_matrix *m, double *radius);

/* sum_k c[k] Z^k, k = 0 ... degree: the step of a Runge-Kutta method for dw/dt = G w, Z = G dt. */
struct theory_matrix theory_polynomial(const struct theory_matrix *z, int degree, const double *c);
/* That of the classic method of order 4. */
struct theory_matrix theory_rk4(const struct theory_matrix *z);

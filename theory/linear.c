#include "theory/linear.h"

#include <lapack.h>
#include <math.h>

enum status theory_eigenvalues(const struct theory_matrix *m, double complex *lambda) {
  enum { WORK = 8 * THEORY_LARGEST };
  double complex by_columns[THEORY_LARGEST * THEORY_LARGEST], work[WORK];
  double real_work[2 * THEORY_LARGEST];
  lapack_int n = m->n, one = 1, size = WORK, info;
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) {
      CHECK(isfinite(creal(m->a[i][j])) && isfinite(cimag(m->a[i][j])), ERR_SOLVER,
            "numbers that are too large to compute with; choose a smaller range");
      by_columns[i + j * n] = m->a[i][j];
    }
  LAPACK_zgeev("N", "N", &n, by_columns, &n, lambda, NULL, &one, NULL, &one, work, &size, real_work,
               &info);
  CHECK(!info, ERR_SOLVER, "the eigenvalues of a matrix did not converge");
  return OK;
}

enum status theory_radius(const struct theory_matrix *m, double *radius) {
  double complex lambda[THEORY_LARGEST];
  TRY(theory_eigenvalues(m, lambda));
  *radius = 0;
  for (int i = 0; i < m->n; i++) *radius = fmax(*radius, cabs(lambda[i]));
  return OK;
}

static struct theory_matrix product(const struct theory_matrix *a, const struct theory_matrix *b) {
  struct theory_matrix c = {.n = a->n};
  for (int i = 0; i < c.n; i++)
    for (int j = 0; j < c.n; j++)
      for (int k = 0; k < c.n; k++) c.a[i][j] += a->a[i][k] * b->a[k][j];
  return c;
}

struct theory_matrix theory_polynomial(const struct theory_matrix *z, int degree, const double *c) {
  struct theory_matrix sum = {.n = z->n};
  for (int k = degree; k >= 0; k--) { /* Horner */
    sum = product(&sum, z);
    for (int i = 0; i < sum.n; i++) sum.a[i][i] += c[k];
  }
  return sum;
}

struct theory_matrix theory_rk4(const struct theory_matrix *z) {
  static const double c[] = {1, 1, 1. / 2, 1. / 6, 1. / 24};
  return theory_polynomial(z, 4, c);
}

#include "theory/linear.h"

#include <lapack.h>
#include <math.h>

#include "sph/time/linear.h"

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

double theory_excess(const struct theory_matrix *d) {
  const double complex half = (d->a[0][0] + d->a[1][1]) / 2;
  const double complex product = d->a[0][0] * d->a[1][1] - d->a[0][1] * d->a[1][0];
  double complex root = csqrt(half * half - product);
  if (creal(root * conj(half)) < 0) root = -root; /* nothing cancels */
  const double complex far = half + root, near = far == 0 ? 0 : product / far;
  const double complex less[] = {far, near}; /* lambda - 1 */
  double most = -INFINITY;
  for (int i = 0; i < 2; i++)
    most = fmax(most, 2 * creal(less[i]) + creal(less[i]) * creal(less[i]) +
                          cimag(less[i]) * cimag(less[i]));
  return most;
}

double theory_limit(bool (*grows)(double courant, const void *with), const void *with,
                    double high) {
  double low = 0;
  while (high - low > 1e-10) {
    const double middle = (low + high) / 2;
    *(grows(middle, with) ? &high : &low) = middle;
  }
  return low < 1e-7 ? 0 : low;
}

struct theory_matrix theory_step(const struct sph_integrator *method, const struct theory_matrix *z,
                                 double damping) {
  static const int at[] = {SPH_LINEAR_X, SPH_LINEAR_U, SPH_LINEAR_RHO};
  struct sph_linear p = {.damping = damping};
  struct theory_matrix m = {.n = z->n};
  double complex G[SPH_LINEAR][SPH_LINEAR];
  for (int i = 0; i < z->n; i++)
    for (int j = 0; j < z->n; j++) p.K[at[i]][at[j]] = z->a[i][j];
  sph_linear_step(method, &p, 1, G);
  for (int i = 0; i < m.n; i++)
    for (int j = 0; j < m.n; j++) m.a[i][j] = G[at[i]][at[j]];
  return m;
}

struct theory_matrix theory_block(const struct theory_matrix *m, int first, int n) {
  struct theory_matrix part = {.n = n};
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) part.a[i][j] = m->a[first + i][first + j];
  return part;
}

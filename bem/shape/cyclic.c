#include "bem/shape/cyclic.h"

#include <lapack.h>
#include <string.h>

/* Sherman & Morrison: the matrix is one without the two corners, which is positive definite as
 * well, plus u v^T with u = (-d, 0, ..., c), v = (1, 0, ..., -c/d), d = diagonal[0], c the corner.
 */
enum status bem_cyclic_solve(size_t n, double *diagonal, double *beside, size_t n_f, size_t stride,
                             double *f, double *scratch) {
  const double d = diagonal[0], c = beside[n - 1];
  double *z = scratch;
  lapack_int rows = (lapack_int)n, columns = (lapack_int)n_f, long_ = (lapack_int)stride, one = 1,
             failed;
  memset(z, 0, n * sizeof *z);
  z[0] = -d;
  z[n - 1] = c;
  diagonal[0] += d;
  diagonal[n - 1] += c * c / d;
  LAPACK_dpttrf(&rows, diagonal, beside, &failed);
  CHECK(failed == 0, ERR_SOLVER, "a tridiagonal system of %zu unknowns has no solution", n);
  LAPACK_dpttrs(&rows, &columns, diagonal, beside, f, &long_, &failed);
  LAPACK_dpttrs(&rows, &one, diagonal, beside, z, &rows, &failed);
  for (size_t k = 0; k < n_f; k++, f += stride) {
    const double part = (f[0] - c / d * f[n - 1]) / (1 + z[0] - c / d * z[n - 1]);
    for (size_t i = 0; i < n; i++) f[i] -= part * z[i];
  }
  return OK;
}

#include "bem/shape/spline.h"

#include <lapack.h>

#include "bem/shape/cyclic.h"

/* Second derivative at an end from those at the two nodes next to it: the third derivative does not
 * jump at the first of them. r: length of the outer interval over that of the inner. */
static double outer(double r, double first, double second) {
  return first * (1 + r) - second * r;
}

/* The tridiagonal system of the inner second derivatives, the outer ones eliminated by `outer`. */
enum status bem_spline_fit(size_t n, const double *s, size_t n_f, const double *const *f,
                           double *second, double *scratch) {
  const size_t m = n - 2, last = n - 1;
  double *lower = scratch, *diagonal = lower + m, *upper = diagonal + m;
  for (size_t i = 0; i < m; i++) { /* of node i + 1 */
    double h = s[i + 1] - s[i], next = s[i + 2] - s[i + 1];
    diagonal[i] = 2 * (h + next);
    upper[i] = next;
    if (i > 0) lower[i - 1] = h;
    for (size_t k = 0; k < n_f; k++)
      second[k * n + i + 1] =
          6 * ((f[k][i + 2] - f[k][i + 1]) / next - (f[k][i + 1] - f[k][i]) / h);
  }
  double first = s[1] - s[0], r = first / (s[2] - s[1]);
  diagonal[0] += first * (1 + r);
  upper[0] -= first * r;
  double end = s[last] - s[last - 1], q = end / (s[last - 1] - s[last - 2]);
  diagonal[m - 1] += end * (1 + q);
  lower[m - 2] -= end * q;

  lapack_int rows = (lapack_int)m, columns = (lapack_int)n_f, stride = (lapack_int)n, failed;
  LAPACK_dgtsv(&rows, &columns, lower, diagonal, upper, second + 1, &stride, &failed);
  CHECK(failed == 0, ERR_SOLVER, "the spline through %zu nodes has no solution", n);
  for (double *d = second; d < second + n_f * n; d += n) {
    d[0] = outer(r, d[1], d[2]);
    d[last] = outer(q, d[last - 1], d[last - 2]);
  }
  return OK;
}

/* The last node is the first again. */
enum status bem_spline_fit_round(size_t n, const double *s, size_t n_f, const double *const *f,
                                 double *second, double *scratch) {
  const size_t m = n - 1;
  double *diagonal = scratch, *beside = diagonal + m;
  for (size_t i = 0; i < m; i++) {
    const size_t b = i > 0 ? i - 1 : m - 1;
    const double before = s[b + 1] - s[b], after = s[i + 1] - s[i];
    diagonal[i] = 2 * (before + after);
    beside[i] = after;
    for (size_t k = 0; k < n_f; k++)
      second[k * n + i] = 6 * ((f[k][i + 1] - f[k][i]) / after - (f[k][b + 1] - f[k][b]) / before);
  }
  TRY(bem_cyclic_solve(m, diagonal, beside, n_f, n, second, beside + m));
  for (double *d = second; d < second + n_f * n; d += n) d[m] = d[0];
  return OK;
}

double bem_spline_value(size_t n, const double *s, const double *f, const double *second, double at,
                        size_t *from) {
  size_t k = *from;
  while (k > 0 && at < s[k]) k--;
  while (k + 2 < n && at > s[k + 1]) k++;
  *from = k;
  double h = s[k + 1] - s[k], a = (s[k + 1] - at) / h, b = 1 - a;
  return a * f[k] + b * f[k + 1] +
         ((a * a * a - a) * second[k] + (b * b * b - b) * second[k + 1]) * h * h / 6;
}

#include "bem/spline.h"

/* The tridiagonal system of the inner second derivatives; continuity of the third derivative at the
 * last but one node on either side gives the outer ones from them. */
void bem_spline_fit(size_t n, const double *s, const double *f, double *second, double *scratch) {
  const size_t last = n - 1;
  double *upper = scratch;
  double before = 0;
  for (size_t k = 1; k < last; k++) {
    double h = s[k] - s[k - 1], next = s[k + 1] - s[k];
    double lower = h, diagonal = 2 * (h + next), right = next;
    double rhs = 6 * ((f[k + 1] - f[k]) / next - (f[k] - f[k - 1]) / h);
    if (k == 1) { /* second[0] = second[1] (1 + h/next) - second[2] h/next */
      diagonal += h * (1 + h / next);
      right -= h * h / next;
      lower = 0;
    }
    if (k + 1 == last) {
      diagonal += next * (1 + next / h);
      lower -= next * next / h;
      right = 0;
    }
    double pivot = diagonal - (k > 1 ? lower * upper[k - 1] : 0);
    upper[k] = right / pivot;
    second[k] = (rhs - (k > 1 ? lower * before : 0)) / pivot;
    before = second[k];
  }
  for (size_t k = last - 1; k-- > 1;) second[k] -= upper[k] * second[k + 1];
  double r = (s[1] - s[0]) / (s[2] - s[1]);
  second[0] = second[1] * (1 + r) - second[2] * r;
  r = (s[last] - s[last - 1]) / (s[last - 1] - s[last - 2]);
  second[last] = second[last - 1] * (1 + r) - second[last - 2] * r;
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

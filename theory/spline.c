#include "theory/spline.h"

#include <math.h>

double theory_spline(double q) {
  q = fabs(q);
  if (q < 1) return 2. / 3 - q * q + q * q * q / 2;
  return q < 2 ? pow(2 - q, 3) / 6 : 0;
}

double theory_spline_slope(double q) {
  double a = fabs(q);
  double slope = a < 1 ? a * (1.5 * a - 2) : a < 2 ? -(2 - a) * (2 - a) / 2 : 0;
  return q < 0 ? -slope : slope;
}

double complex theory_spline_symbol(double complex wave, double ratio) {
  double complex sum = 0;
  for (int b = -(int)(2 * ratio); b <= (int)(2 * ratio); b++)
    sum += theory_spline(b / ratio) * cexp(wave * b / ratio) / ratio;
  return sum;
}

double complex theory_spline_slope_symbol(double complex wave, double ratio) {
  double complex sum = 0;
  for (int b = -(int)(2 * ratio); b <= (int)(2 * ratio); b++)
    sum += theory_spline_slope(-b / ratio) * cexp(wave * b / ratio) / ratio;
  return sum;
}

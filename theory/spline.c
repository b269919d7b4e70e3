#include "theory/spline.h"

#include <math.h>

double complex theory_spline_at(double complex q) {
  if (creal(q) < 0) q = -q;
  if (creal(q) < 1) return 2. / 3 - q * q + q * q * q / 2;
  return creal(q) < 2 ? (2 - q) * (2 - q) * (2 - q) / 6 : 0;
}

double complex theory_spline_slope_at(double complex q) {
  const double complex a = creal(q) < 0 ? -q : q;
  const double complex slope = creal(a) < 1   ? a * (1.5 * a - 2)
                               : creal(a) < 2 ? -(2 - a) * (2 - a) / 2
                                              : 0;
  return creal(q) < 0 ? -slope : slope;
}

double theory_spline(double q) {
  return creal(theory_spline_at(q));
}

double theory_spline_slope(double q) {
  return creal(theory_spline_slope_at(q));
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

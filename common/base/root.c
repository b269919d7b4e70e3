#include "common/base/root.h"

#include <math.h>

double root_between(double (*f)(double x, const void *with), const void *with, double low,
                    double high) {
  double at_low = f(low, with), at_high = f(high, with);
  if (at_low == 0) return low;
  if (at_high == 0) return high;
  if (!((at_low < 0) != (at_high < 0))) return NAN;
  for (double middle = low + (high - low) / 2; middle != low && middle != high;
       middle = low + (high - low) / 2) {
    double value = f(middle, with);
    if (value == 0) return middle;
    if ((value < 0) == (at_low < 0))
      low = middle;
    else
      high = middle;
  }
  return low;
}

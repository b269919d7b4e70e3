#include "sph/time/chebyshev.h"

#include <math.h>

static const double tolerance = 2e-3; /* the largest decay is off by less; slow ones by far less */

/* c_k, by the trapezoidal rule on the circle, which is exact to rounding for so many points. */
static double coefficient(int k, double Z) {
  const int points = 4 * SPH_CHEBYSHEV_MOST;
  double sum = 0;
  for (int n = 0; n < points; n++) {
    const double angle = 2 * M_PI * n / points;
    sum += exp(Z / 2 * (cos(angle) - 1)) * cos(k * angle);
  }
  return (k ? 2 : 1) * sum / points;
}

struct sph_chebyshev sph_chebyshev_of(double Z) {
  struct sph_chebyshev p = {.Z = fmax(Z, 1e-6)};
  double sum = coefficient(0, p.Z), slope = 0; /* of the terms so far, at z = 0 */
  while ((p.degree < 2 || 1 - sum > tolerance) && p.degree < SPH_CHEBYSHEV_MOST) {
    const int k = ++p.degree;
    p.c[k] = coefficient(k, p.Z);
    sum += p.c[k];
    slope += 2 / p.Z * k * k * p.c[k];
  }
  if (1 - sum > tolerance) p.degree = SPH_CHEBYSHEV_MOST + 1;
  for (int k = 1; k <= p.degree && k <= SPH_CHEBYSHEV_MOST; k++) p.c[k] /= slope;
  return p;
}

double sph_chebyshev_value(const struct sph_chebyshev *p, double z) {
  double before = 0, now = 2 * z / p->Z, sum = p->c[1] * now;
  for (int k = 2; k <= p->degree; k++) {
    double next = 2 * now - before + 4 * z / p->Z * (1 + now);
    before = now;
    now = next;
    sum += p->c[k] * now;
  }
  return 1 + sum;
}

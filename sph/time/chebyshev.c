#include "sph/time/chebyshev.h"

#include <math.h>

int sph_chebyshev_stages(double z) {
  const double stages = 1 + floor(sqrt(1 + 1.54 * z)); /* the paper's, after its eq. (2.7) */
  return stages > SPH_CHEBYSHEV_MOST ? SPH_CHEBYSHEV_MOST + 1 : (int)fmax(2, stages);
}

struct sph_chebyshev sph_chebyshev_of(int s) {
  struct sph_chebyshev c = {.stages = s};
  double T[SPH_CHEBYSHEV_MOST + 1], d[SPH_CHEBYSHEV_MOST + 1],
      dd[SPH_CHEBYSHEV_MOST + 1]; /* T_j(w0), T_j', T_j'' */
  double a[SPH_CHEBYSHEV_MOST + 1], b[SPH_CHEBYSHEV_MOST + 1] = {0};
  const double w0 = 1 + 2. / 13 / (s * s);
  T[0] = 1, d[0] = 0, dd[0] = 0;
  T[1] = w0, d[1] = 1, dd[1] = 0;
  for (int j = 2; j <= s; j++) {
    T[j] = 2 * w0 * T[j - 1] - T[j - 2];
    d[j] = 2 * T[j - 1] + 2 * w0 * d[j - 1] - d[j - 2];
    dd[j] = 4 * d[j - 1] + 2 * w0 * dd[j - 1] - dd[j - 2];
  }
  const double w1 = d[s] / dd[s];
  for (int j = 2; j <= s; j++) b[j] = dd[j] / (d[j] * d[j]);
  b[0] = b[1] = b[2];
  for (int j = 0; j <= s; j++) a[j] = 1 - b[j] * T[j];
  c.mu1[1] = b[1] * w1;
  for (int j = 2; j <= s; j++) {
    c.mu[j] = 2 * b[j] * w0 / b[j - 1];
    c.nu[j] = -b[j] / b[j - 2];
    c.mu1[j] = 2 * b[j] * w1 / b[j - 1];
    c.gamma1[j] = -a[j - 1] * c.mu1[j];
  }
  return c;
}

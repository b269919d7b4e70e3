/* The exact solitary wave on water of depth 1 under gravity 1, with its crest at x = 0.
 *
 * In the frame of the crest the water flows steadily to the left below a strip mapped conformally:
 * z(zeta) = zeta + a0 (zeta + i) + sum a_j sin(k_j (zeta + i))/sinh k_j, -1 <= Im zeta <= 0, k_j =
 * j pi/half, with the bed at Im z = -1 and the water at rest at 0. Its surface obeys Babenko's
 * equation, F^2 C eta - eta = C(eta^2)/2 + eta C eta, C = k coth k, which Petviashvili's iteration
 * solves: D. Clamond & D. Dutykh, Comput. Fluids 84 (2013) 35-38. It has one wave for each Froude
 * number F; the amplitude is met by secants. */
#pragma once
#include <stddef.h>

#include "common/base/status.h"

/* Near A = 0.796 the speed has its maximum, and the wave of a speed is no longer one. */
#define CREST_HIGHEST 0.7

struct crest {
  double amplitude, froude; /* A/h, c/sqrt(gh) */
  double decay;             /* kappa, 1/h: eta falls like exp(-kappa |x|), tan kappa = F^2 kappa */
  double half;              /* of the period, which the wave does not feel, h */
  double mean;              /* a0 */
  size_t n;
  double *wave;              /* [n] a_j/(1 - exp(-2 k_j)), j = 1 to n */
  double mass;               /* of eta dx, h^2 */
  double kinetic, potential; /* rho g h^3 */
};

/* ERR_MEMORY, ERR_SOLVER. */
enum status wave_crest_create(double amplitude, struct crest *w);
void wave_crest_destroy(struct crest *w);

/* By the theory of small waves far away, and by a series in A (J. Fenton, J. Fluid Mech. 53, 1972)
 * to 1.1 %: to place and to scale the wave before it is known. */
double wave_crest_decay_about(double amplitude);

/* In the water at rest's frame, (x, y) from the crest and from the level at rest. */
struct crest_point {
  double potential, u, v; /* sqrt(g h^3), sqrt(gh) */
};
double wave_crest_elevation(const struct crest *w, double x);
struct crest_point wave_crest_at(const struct crest *w, double x, double y);

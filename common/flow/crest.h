/* The exact steady waves that run over a flat bed, solitary or periodic, on water of mean depth 1
 * under gravity 1, to the right, with a crest at x = 0.
 *
 * In the frame of the crest the water flows steadily to the left below a strip mapped conformally:
 * z(zeta) = stretch (zeta + i) - i + sum a_j sin(k_j (zeta + i))/sinh k_j, -1 <= Im zeta <= 0, k_j
 * = j pi/half, with the bed at Im z = -1 and the mean level at 0; dw/dzeta = -flow. Its surface
 * obeys Babenko's equation (babenko.h). Water far from a solitary wave is at rest; the mean
 * velocity at any level below the troughs of periodic waves is 0. */
#pragma once
#include <stddef.h>

#include "common/base/status.h"

/* Of the height of the highest wave: A/h = 0.8 of 0.8332, and 98 %. */
#define CREST_HIGHEST  0.8
#define CREST_STEEPEST 0.98
#define CREST_LONGEST  50 /* periodic waves, over the depth: beyond, crests are solitary */

struct crest {
  double height, length; /* crest above trough; of the wave, 0: solitary */
  double speed;          /* c/sqrt(gh), h the mean depth */
  double decay; /* solitary: kappa, 1/h: eta falls like exp(-kappa |x|), tan kappa = F^2 kappa */
  double half;  /* of the period in xi, which a solitary wave does not feel */
  double stretch, flow;
  double bernoulli; /* velocity^2/2 + p + y beside the crest */
  size_t n;
  double *wave;              /* [n] a_j/(1 - exp(-2 k_j)), j = 1 to n */
  size_t points;             /* intervals of half a wave */
  double *x, *y;             /* [points + 1] of the surface, evenly in xi from the crest on */
  double mass;               /* of a solitary wave: eta dx, h^2 */
  double impulse;            /* of a wave: int u dA, sqrt(g h^5) */
  double kinetic, potential; /* of a wave, rho g h^3 */
};

/* Height of the highest wave of a length, over the depth: J. D. Fenton (in The Sea 9, 1990, 3-25),
 * after Williams' (Phil. Trans. R. Soc. A 302, 1981) numbers; 0.8332 for solitary ones, length 0.
 */
double wave_crest_limit(double length);

/* Of height A at most CREST_HIGHEST, and of height up to CREST_STEEPEST of the limit. ERR_MEMORY,
 * ERR_SOLVER; destroy *w even then. */
enum status wave_crest_create(double amplitude, struct crest *w);
enum status wave_crest_create_periodic(double height, double length, struct crest *w);
void wave_crest_destroy(struct crest *w);

/* By the theory of small waves far away, and by a series in A: to place and to scale the wave
 * before it is known. */
double wave_crest_decay_about(double amplitude);

/* In the water, (x, y) from a crest and from the mean level. */
struct crest_point {
  double potential, u, v, head; /* sqrt(g h^3), sqrt(gh), h: p/(rho g) */
};
double wave_crest_elevation(const struct crest *w, double x);
struct crest_point wave_crest_at(const struct crest *w, double x, double y);

/* How much diffusion keeps all waves travelling (P, section III): with mu = k h up to mu0 = pi h/dx
 *     (alpha/6)^3/B <= delta <= (1/(B mu0^2)) (alpha/2 + 2/mu0)                           (23)
 * is enough for F >= 0 at every wavenumber. The lower bound is the maximum, at mu = 6/alpha, of
 * that of (22); the two meet at alpha = 12/mu0, since (x - 12) (x + 6)^2 = 0 for x = alpha mu0. */
#include <math.h>

#include "theory/theory.h"

struct diffusion {
  double moment, ratio, to;
  int points;
};

static const struct param params[] = {
    THEORY_REAL(diffusion, moment, PARAM_ABOVE_0, 1, "0.125",
                "B of the kernel: 1/8 of the Gaussian"),
    THEORY_REAL(diffusion, ratio, 0.5, 10, "1.3333333333333333", "h/dx"),
    THEORY_REAL(diffusion, to, PARAM_ABOVE_0, 1000, "3", "largest alpha"),
    THEORY_POINTS(diffusion),
};
static const struct theory_column columns[] = {
    {.key = "alpha", .unit = "1", .label = "α", .help = "artificial viscosity"},
    {.key = "least", .unit = "1", .label = "least δ", .axis = "δ", .help = "lower bound of (23)"},
    {.key = "most", .unit = "1", .label = "most δ", .help = "upper bound of (23)"},
};
enum { MU0, MOST_ALONE, MOST_ALPHA, MEETING };
static const struct theory_value values[] = {
    [MU0] = {"mu0", "1", "k h of the shortest wave, pi h/dx"},
    [MOST_ALONE] = {"delta_most", "1",
                    "largest delta without viscosity, 2/(B mu0^3); P rounds 0.2177 to 0.21"},
    [MOST_ALPHA] = {"alpha_most", "1", "largest alpha without diffusion, 4/mu0 (24)"},
    [MEETING] = {"alpha_meet", "1", "alpha at which the bounds meet, 12/mu0"},
};

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct diffusion *p = with;
  double mu0 = M_PI * p->ratio;
  for (int i = 0; i < p->points; i++) {
    double alpha = theory_between(0, p->to, i, p->points);
    TRY(THEORY_ROW(curve, alpha, pow(alpha / 6, 3) / p->moment,
                   (alpha / 2 + 2 / mu0) / (p->moment * mu0 * mu0)));
  }
  curve->value[MU0] = mu0;
  curve->value[MOST_ALONE] = 2 / (p->moment * pow(mu0, 3));
  curve->value[MOST_ALPHA] = 4 / mu0;
  curve->value[MEETING] = 12 / mu0;
  return OK;
}

const struct theory_topic theory_diffusion = {
    .name = "diffusion",
    .help = "bounds of delta against alpha within which all waves travel (P, eqs 22-24)",
    .params_size = sizeof(struct diffusion),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

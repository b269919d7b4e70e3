/* The bounds of delta at one wavenumber, mu = k h (P, eq. 22):
 *     (1/(B mu^2)) (alpha/2 - 2/mu) <= delta <= (1/(B mu^2)) (alpha/2 + 2/mu). */
#include <math.h>

#include "theory/theory.h"

struct regime {
  double alpha, moment, from, to;
  int points;
};

static const struct param params[] = {
    THEORY_REAL(regime, alpha, 0, 100, "0, 1, 2", "artificial viscosity"),
    THEORY_REAL(regime, moment, PARAM_ABOVE_0, 1, "0.125", "B of the kernel: 1/8 of the Gaussian"),
    THEORY_REAL(regime, from, PARAM_ABOVE_0, 1000, "2", "least k h"),
    THEORY_REAL(regime, to, PARAM_ABOVE_0, 1000, "4.1887902047863905", "largest k h"),
    THEORY_POINTS(regime),
};
static const struct theory_column columns[] = {
    {.key = "mu", .unit = "1", .label = "μ = k h", .help = "wavenumber times h"},
    {.key = "least",
     .unit = "1",
     .label = "least δ",
     .axis = "δ",
     .help = "lower bound; none below zero"},
    {.key = "most", .unit = "1", .label = "most δ", .help = "upper bound"},
};

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct regime *p = with;
  CHECK(p->from < p->to, ERR_USAGE, "from: found %g; allowed: less than to = %g", p->from, p->to);
  for (int i = 0; i < p->points; i++) {
    double mu = theory_between(p->from, p->to, i, p->points), per = 1 / (p->moment * mu * mu);
    double least = per * (p->alpha / 2 - 2 / mu);
    TRY(THEORY_ROW(curve, mu, least < 0 ? NAN : least, per * (p->alpha / 2 + 2 / mu)));
  }
  return OK;
}

const struct theory_topic theory_regime = {
    .name = "regime",
    .help = "bounds of delta at each wavenumber between which waves travel (P, eq. 22)",
    .params_size = sizeof(struct regime),
    THEORY_TABLES,
    .evaluate = evaluate,
};

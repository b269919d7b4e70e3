/* What treatments do to waves and to decaying modes on a line of particles, dx = h, cubic B-spline
 * (T, section 3.4):
 *     xsph      rates times sqrt(1 + strength X), X = sum h W (e^(kappa x) - 1): -(2/3) sin^2(kh/2)
 *               of waves, +(2/3) sinh^2(mu h/2) of decaying modes, which it makes grow faster
 *               (T, eq. 3.35; direct density)
 *     tensile   rates times sqrt(1 - strength) (T, eq. 3.57)
 *     shepard   one application multiplies by 1 + X (T, eqs 3.60 and 4.51-4.54)
 *     mls       one application of the value fitted to three particles with a hat: 1 -+ (4/3)
 * sin^2, negative beyond kh = 2 pi/3 (T, eqs 3.3-3.8) */
#include <math.h>

#include "theory/spline.h"
#include "theory/theory.h"

static const char *const treatment_names[] = {"xsph", "tensile", "shepard", "mls", NULL};
static const char *const treatment_helps[] = {
    "positions follow a smoothed velocity: factor of a rate",
    "tensile correction: factor of a rate",
    "Shepard interpolation of density or velocity: factor of an application",
    "value fitted to three particles: factor of an application"};
enum { XSPH, TENSILE, SHEPARD, MLS };

struct treatments {
  int treatment, points;
  double strength, to;
};

static const struct param params[] = {
    THEORY_CHOICE(treatments, treatment, treatment_names, treatment_helps,
                  "xsph, tensile, shepard, mls", "what is applied"),
    THEORY_REAL(treatments, strength, 0, 1.5, "0.1",
                "of xsph, neutral up to 3/2; and of the tensile correction, below 1"),
    THEORY_REAL(treatments, to, PARAM_ABOVE_0, 20, "3.141592653589793", "largest kh and mu h"),
    THEORY_POINTS(treatments),
};
static const struct theory_column columns[] = {
    {.key = "kh", .unit = "1", .label = "k h or μ h", .help = "wavenumber times h"},
    {.key = "oscillating",
     .unit = "1",
     .label = "factor, waves",
     .level = "1",
     .help = "factor of waves"},
    {.key = "decaying",
     .unit = "1",
     .label = "factor, decaying modes",
     .level = "1",
     .help = "factor of decaying modes",
     .panel = 1},
};
enum { SECOND };
static const struct theory_value values[] = {
    [SECOND] = {"second", "h^2", "factor = 1 + this times f''/f for long waves"},
};

/* `spread` is X: twice the second moment's share, of waves negative. */
static double factor(const struct treatments *p, double spread) {
  switch (p->treatment) {
  case XSPH:
    return sqrt(fmax(1 + p->strength * spread, 0));
  case TENSILE:
    return sqrt(1 - p->strength);
  case SHEPARD:
    return 1 + spread;
  default:
    return 1 + 2 * spread; /* weights of 1/3 in place of 1/6 */
  }
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct treatments *p = with;
  static const double second[] = {
      [XSPH] = 1. / 12, [TENSILE] = 0, [SHEPARD] = 1. / 6, [MLS] = 1. / 3};
  CHECK(p->treatment != TENSILE || p->strength < 1, ERR_USAGE,
        "strength: found %g; allowed: less than 1 with tensile", p->strength);
  for (int i = 0; i < p->points; i++) {
    double k = theory_between(0, p->to, i, p->points);
    double waves = creal(theory_spline_symbol(I * k, 1)) - 1;
    double decaying = creal(theory_spline_symbol(k, 1)) - 1;
    TRY(THEORY_ROW(curve, k, factor(p, waves), factor(p, decaying)));
  }
  curve->value[SECOND] = second[p->treatment] * (p->treatment == XSPH ? p->strength : 1);
  return OK;
}

const struct theory_topic theory_treatments = {
    .name = "treatments",
    .help = "what XSPH, tensile correction, Shepard and MLS values do to waves (T, section 3.4)",
    .params_size = sizeof(struct treatments),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

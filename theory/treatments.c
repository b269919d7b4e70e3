/* What treatments do to waves and to decaying modes on a line of particles, dx = h, cubic B-spline
 * (T, section 3.4):
 *     xsph, tensile  rates with the treatment over those without it, by the eigenvalues of the
 *               particles' equations (theory/chain.h); of the tensile correction, under a tension
 *               of 1e-12 rho c^2. T has sqrt(1 + strength X), X = sum h W (e^(kappa x) - 1) =
 *               -(2/3) sin^2(kh/2) of waves, +(2/3) sinh^2(mu h/2) of decaying modes, which XSPH
 *               makes grow faster (3.35), with direct density; with an advanced one XSPH does
 *               nothing; and sqrt(1 - strength) (3.57)
 *     shepard   one application multiplies by 1 + X (T, eqs 3.60 and 4.51-4.54)
 *     mls       one application of the value fitted to three particles with a hat: 1 -+ (4/3)
 * sin^2, negative beyond kh = 2 pi/3 (T, eqs 3.3-3.8) */
#include <math.h>

#include "theory/chain.h"
#include "theory/spline.h"
#include "theory/theory.h"

static const char *const treatment_names[] = {"xsph", "tensile", "shepard", "mls", NULL};
static const char *const treatment_helps[] = {
    "positions follow a smoothed velocity: factor of a rate",
    "tensile correction: factor of a rate",
    "Shepard interpolation of density or velocity: factor of an application",
    "value fitted to three particles: factor of an application"};
enum { XSPH, TENSILE, SHEPARD, MLS };

static const char *const density_names[] = {"direct", "advanced", NULL};
static const char *const density_helps[] = {"rho = sum m W", "its rate is integrated"};

struct treatments {
  int treatment, density, points;
  double strength, to;
};

static const struct param params[] = {
    THEORY_CHOICE(treatments, treatment, treatment_names, treatment_helps,
                  "xsph, tensile, shepard, mls", "what is applied"),
    THEORY_REAL(treatments, strength, 0, 3, "0.1",
                "of xsph, neutral up to 3/2; and of the tensile correction, below 1"),
    THEORY_CHOICE(
        treatments, density, density_names, density_helps, "direct",
        "how the density is found, with xsph and tensile; shepard and mls do not depend on it"),
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
enum { SECOND, GROWTH };
static const struct theory_value values[] = {
    [GROWTH] =
        {"growth_most", "c/h",
         "fastest growth of any wave with xsph or tensile; up to 2.83e-6 of tensile is that of its "
         "tension, sqrt(8e-12)"},
    [SECOND] = {"second", "h^2", "factor = 1 + this times f''/f for long waves"},
};

static bool is_of_rates(const struct treatments *p) {
  return p->treatment == XSPH || p->treatment == TENSILE;
}

/* The fastest of all: its frequency, and growth. */
struct rates {
  double frequency, growth;
};

static enum status rates_of(const struct theory_chain *c, double complex wave, struct rates *r) {
  const struct theory_matrix z = theory_chain_rates(c, wave);
  double complex rate[THEORY_LARGEST];
  TRY(theory_eigenvalues(&z, rate));
  *r = (struct rates){0, 0};
  for (int i = 0; i < z.n; i++) {
    r->frequency = fmax(r->frequency, cimag(rate[i]));
    r->growth = fmax(r->growth, creal(rate[i]));
  }
  return OK;
}

/* With the treatment and without it. */
static struct theory_chain chain_of(const struct treatments *p, bool treated) {
  const double strength = treated ? p->strength : 0;
  return (struct theory_chain){.advanced = p->density,
                               .xsph = p->treatment == XSPH ? strength : 0,
                               .tensile = p->treatment == TENSILE ? strength : 0,
                               .tension = p->treatment == TENSILE ? 1e-12 : 0};
}

/* NaN where there is no rate: at k = 0, and at kh = pi. */
static double quotient(double with, double without) {
  return without > 1e-7 ? with / without : NAN;
}

static enum status factors_of_rates(const struct treatments *p, double k, double *waves,
                                    double *decaying) {
  const struct theory_chain with = chain_of(p, true), without = chain_of(p, false);
  struct rates a, b;
  TRY(rates_of(&with, I * k, &a));
  TRY(rates_of(&without, I * k, &b));
  *waves = quotient(a.frequency, b.frequency);
  TRY(rates_of(&with, k, &a));
  TRY(rates_of(&without, k, &b));
  *decaying = quotient(a.growth, b.growth);
  return OK;
}

/* Of waves up to k h = pi, whatever is drawn. */
static enum status fastest(const struct treatments *p, double *most) {
  const struct theory_chain with = chain_of(p, true);
  struct rates r;
  *most = 0;
  for (int i = 1; i <= THEORY_WAVES; i++) {
    TRY(rates_of(&with, I * M_PI * i / THEORY_WAVES, &r));
    *most = fmax(*most, r.growth);
  }
  return OK;
}

/* X is twice the second moment's share, of waves negative. */
static double factor_of_values(const struct treatments *p, double X) {
  return p->treatment == SHEPARD ? 1 + X : 1 + 2 * X; /* weights of 1/3 in place of 1/6 */
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct treatments *p = with;
  static const double second[] = {
      [XSPH] = 1. / 12, [TENSILE] = 0, [SHEPARD] = 1. / 6, [MLS] = 1. / 3};
  double waves, decaying;
  CHECK(p->treatment != TENSILE || p->strength < 1, ERR_USAGE,
        "strength: found %g; allowed: less than 1 with tensile", p->strength);
  if (is_of_rates(p)) TRY(fastest(p, &curve->value[GROWTH]));
  for (int i = 0; i < p->points; i++) {
    double k = theory_between(0, p->to, i, p->points);
    if (is_of_rates(p)) {
      TRY(factors_of_rates(p, k, &waves, &decaying));
    } else {
      waves = factor_of_values(p, creal(theory_spline_symbol(I * k, 1)) - 1);
      decaying = factor_of_values(p, creal(theory_spline_symbol(k, 1)) - 1);
    }
    TRY(THEORY_ROW(curve, k, waves, decaying));
  }
  const bool none = p->treatment == XSPH && p->density;
  curve->value[SECOND] = none ? 0 : second[p->treatment] * (p->treatment == XSPH ? p->strength : 1);
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

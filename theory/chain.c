#include "theory/chain.h"

#include "theory/spline.h"

enum { NEAR = 2, REACH = 2 * NEAR, PARTICLES = 2 * REACH + 1, MIDDLE = REACH };
enum { X, U, RHO, VARIABLES };

/* Neighbours of the middle one and theirs. */
struct particles {
  double complex w[VARIABLES][PARTICLES];
};

static double complex density(const struct theory_chain *c, const struct particles *p, int a) {
  if (c->advanced) return p->w[RHO][a];
  double complex sum = 0;
  for (int b = a - NEAR; b <= a + NEAR; b++)
    sum += (1 - c->tension) * theory_spline_at(p->w[X][a] - p->w[X][b]);
  return sum;
}

static void rates(const struct theory_chain *c, const struct particles *p,
                  double complex rate[VARIABLES]) {
  const double m = 1 - c->tension;
  const int a = MIDDLE;
  const double complex rho_a = density(c, p, a), P_a = rho_a - 1;
  for (int k = 0; k < VARIABLES; k++) rate[k] = 0;
  rate[X] = p->w[U][a];
  for (int b = a - NEAR; b <= a + NEAR; b++) {
    if (b == a) continue;
    const double complex rho_b = density(c, p, b), P_b = rho_b - 1;
    const double complex away = p->w[X][a] - p->w[X][b], W = theory_spline_at(away);
    const double complex slope = theory_spline_slope_at(away), f = W / theory_spline(1);
    const bool tense = creal(P_a) < 0 && creal(P_b) < 0;
    const double complex left = tense ? 1 - c->tensile * f * f * f * f : 1;
    rate[X] += c->xsph * (p->w[U][b] - p->w[U][a]) * 2 * m / (rho_a + rho_b) * W;
    rate[U] -= m * (P_a / (rho_a * rho_a) + P_b / (rho_b * rho_b)) * left * slope;
    rate[RHO] += m * (p->w[U][a] - p->w[U][b]) * slope;
  }
}

/* Of the rates of the middle one, by a perturbation of one variable. */
static void derivatives(const struct theory_chain *c, int variable, const double *shape,
                        double out[VARIABLES]) {
  static const double step = 1e-40;
  struct particles p;
  double complex rate[VARIABLES];
  for (int a = 0; a < PARTICLES; a++) {
    p.w[X][a] = a - MIDDLE;
    p.w[U][a] = 0;
    p.w[RHO][a] = 1 - c->tension;
    p.w[variable][a] += I * step * shape[a];
  }
  rates(c, &p, rate);
  for (int k = 0; k < VARIABLES; k++) out[k] = cimag(rate[k]) / step;
}

struct theory_matrix theory_chain_rates(const struct theory_chain *c, double complex wave) {
  struct theory_matrix z = {.n = c->advanced ? VARIABLES : RHO};
  double cosine[PARTICLES], sine[PARTICLES], by_cosine[VARIABLES], by_sine[VARIABLES];
  for (int a = 0; a < PARTICLES; a++) {
    const double complex e = cexp(wave * (a - MIDDLE));
    cosine[a] = creal(e);
    sine[a] = cimag(e);
  }
  for (int from = 0; from < z.n; from++) {
    derivatives(c, from, cosine, by_cosine);
    derivatives(c, from, sine, by_sine);
    for (int to = 0; to < z.n; to++) z.a[to][from] = by_cosine[to] + I * by_sine[to];
  }
  return z;
}

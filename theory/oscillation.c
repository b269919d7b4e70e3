/* Modes e^(i nu y) cos(kappa x) of a column at rest that do not satisfy the surface condition (T,
 * section 2.6.2, second row of table 2.4): how fast their amplitude grows in stratified water,
 *
 *     continuum  w = sqrt{[-a + sqrt(a^2 + g^2 nu^2)]/2}, a = c^2 (nu^2 + kappa^2)    (2.179)
 *     leading    g nu/(2 c sqrt(nu^2 + kappa^2)), c delta = g/(2 c) for kappa = 0
 *     printed    delta nu/(nu^2 + kappa^2) (2.180, 2.197), which is no rate: a factor c nu is lost
 *     lattice    (c/2) |theta'| [2 + (gamma - 2) cos nu h], theta' = -2 delta, with the masses that
 *                rest needs; the printed (2.243) has equal masses and gamma - 3 in place of gamma
 *     discrete   ln |lambda|/dt with RK4, gamma = 1, theta = 0
 *
 * all without growth where the water is uniform. Units: g = H = 1. */
#include <math.h>

#include "theory/column.h"
#include "theory/theory.h"

struct oscillation {
  double beta, kappa, spacing, gamma, courant, to;
  int points;
};

static const struct param params[] = {
    THEORY_REAL(oscillation, beta, PARAM_ABOVE_0, 1e6, "10", "c^2/(g H)"),
    THEORY_REAL(oscillation, kappa, 0, 1e4, "0", "horizontal wavenumber times H"),
    THEORY_REAL(oscillation, spacing, PARAM_ABOVE_0, 1, "0.02", "dx = h over H"),
    THEORY_REAL(oscillation, gamma, 1, 100, "1", "exponent of the equation of state; 1: linear"),
    THEORY_REAL(oscillation, courant, PARAM_ABOVE_0, 2.8, "0.1", "c dt/h of the discrete rate"),
    THEORY_REAL(oscillation, to, PARAM_ABOVE_0, 1e6, "150", "largest nu H"),
    THEORY_POINTS(oscillation),
};
static const struct theory_column columns[] = {
    {.key = "nu", .unit = "1/H", .label = "ν H", .help = "vertical wavenumber"},
    {.key = "continuum",
     .unit = "sqrt(g/H)",
     .label = "continuum",
     .axis = "growth w √(H/g)",
     .help = "growth by (2.179)"},
    {.key = "leading",
     .unit = "sqrt(g/H)",
     .label = "leading order",
     .help = "its leading order in delta/nu"},
    {.key = "printed",
     .unit = "1",
     .label = "as printed (2.180)",
     .help = "the number that (2.180) and (2.197) print"},
    {.key = "lattice",
     .unit = "sqrt(g/H)",
     .label = "lattice",
     .help = "on a line of particles; beyond nu h = pi there are no others"},
    {.key = "discrete",
     .unit = "sqrt(g/H)",
     .label = "lattice, RK4",
     .help = "with RK4 in time, gamma = 1"},
};

static enum status row_of(const struct oscillation *p, double nu, double row[6]) {
  double c = sqrt(p->beta), delta = 1 / (2 * p->beta), h = p->spacing, dt = p->courant * h / c;
  double square = nu * nu + p->kappa * p->kappa, a = p->beta * square, radius;
  struct theory_matrix m = theory_column_stratified(p->courant, nu * h, 0, delta * h);
  TRY(theory_radius(&m, &radius));
  bool there = nu * h <= M_PI && p->kappa == 0;
  row[0] = nu;
  row[1] = nu / sqrt(2 * (a + hypot(a, nu)));
  row[2] = nu / (2 * c * sqrt(square));
  row[3] = delta * nu / square;
  row[4] = there ? c * delta * (2 + (p->gamma - 2) * cos(nu * h)) : NAN;
  row[5] = there && p->gamma == 1 ? log(radius) / dt : NAN;
  return OK;
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct oscillation *p = with;
  double row[6];
  for (int i = 1; i <= p->points; i++) {
    TRY(row_of(p, p->to * i / p->points, row));
    TRY(theory_row_add(curve, 6, row));
  }
  return OK;
}

const struct theory_topic theory_oscillation = {
    .name = "oscillation",
    .help = "growth of modes that oscillate over a stratified column (T, eqs 2.177-2.197, 2.243, "
            "table 2.4)",
    .params_size = sizeof(struct oscillation),
    THEORY_TABLES,
    .evaluate = evaluate,
};

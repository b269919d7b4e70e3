/* Acoustic modes of a stratified tank (T, eqs 2.57-2.63, figures 2-14 to 2-18): wavenumbers nu_n,
 *
 *     exact        nu H cot nu H = delta H (kappa^2 - delta^2 - nu^2)/(kappa^2 + delta^2 + nu^2)
 *     leading      a_n = (2 n + 1) pi/2                                       (2.58)
 *     first order  a_n - (delta H/a_n) (1 - k^2)/(1 + k^2), k = a_n/(kappa H)
 *                                                                 (2.59, 2.60, corrected)
 *
 * and frequencies c sqrt(kappa^2 + delta^2 + nu^2); or on a square lattice, dx = h, with the tensor
 * product of cubic B-splines and the mean theta = delta H, with either the leading or the exact nu,
 *
 *     omega^2 = (c/h)^2 {[sin(nu h) Wx]^2 + [sin(kappa h) Wy]^2 + 8 theta sin^4(nu h/2)}
 *     Wx = 1 - (2/3) sin^2(kappa h/2),  Wy = 1 - (2/3) sin^2(nu h/2)
 *
 * Units: g = H = 1. */
#include <math.h>

#include "theory/modes.h"
#include "theory/theory.h"

struct acoustic {
  double beta, kappa, spacing;
  int first, last;
};

static const struct param params[] = {
    THEORY_REAL(acoustic, beta, PARAM_ABOVE_0, 1e6, "10", "c^2/(g H)"),
    THEORY_REAL(acoustic, kappa, PARAM_ABOVE_0, 1e4, "6.283185307179586",
                "horizontal wavenumber times H"),
    THEORY_REAL(acoustic, spacing, PARAM_ABOVE_0, 1, "0.01", "dx = h over H"),
    THEORY_INT(acoustic, first, 0, 10000, "0", "n of the first mode"),
    THEORY_INT(acoustic, last, 0, 10000, "40", "n of the last mode"),
};
static const struct theory_column columns[] = {
    {.key = "n", .unit = "1", .label = "mode n", .help = "number of the mode"},
    {.key = "nu", .unit = "1/H", .label = "ν H", .help = "exact root", .undrawn = true},
    {.key = "nu_leading",
     .unit = "1/H",
     .label = "(2 n + 1) π/2",
     .help = "leading order",
     .undrawn = true},
    {.key = "nu_first",
     .unit = "1/H",
     .label = "first order",
     .help = "to first order in delta H",
     .undrawn = true},
    {.key = "omega",
     .unit = "sqrt(g/H)",
     .label = "continuum",
     .axis = "ω √(H/g)",
     .points = true,
     .help = "frequency with the exact root"},
    {.key = "omega_leading",
     .unit = "sqrt(g/H)",
     .label = "continuum, leading order",
     .help = "frequency with the root to leading order",
     .undrawn = true},
    {.key = "omega_lattice",
     .unit = "sqrt(g/H)",
     .label = "lattice",
     .points = true,
     .help = "frequency on a lattice, root to leading order; none where it is too coarse for the "
             "mode"},
    {.key = "omega_lattice_exact",
     .unit = "sqrt(g/H)",
     .label = "lattice, exact root",
     .help = "the same with the exact root",
     .undrawn = true},
    {.key = "period",
     .unit = "sqrt(H/g)",
     .label = "continuum",
     .axis = "T √(g/H)",
     .panel = 1,
     .log = true,
     .points = true,
     .help = "period with the root to leading order"},
    {.key = "period_lattice",
     .unit = "sqrt(H/g)",
     .label = "lattice",
     .panel = 1,
     .points = true,
     .help = "period on the lattice"},
};

static double lattice(const struct acoustic *p, double nu) {
  double h = p->spacing, c = sqrt(p->beta), theta = 1 / (2 * p->beta), k = p->kappa;
  if (nu * h > M_PI) return NAN;
  double down = sin(nu * h) * (1 - 2. / 3 * pow(sin(k * h / 2), 2));
  double along = sin(k * h) * (1 - 2. / 3 * pow(sin(nu * h / 2), 2));
  return c / h * sqrt(down * down + along * along + 8 * theta * pow(sin(nu * h / 2), 4));
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct acoustic *p = with;
  struct wave_column tank;
  TRY(theory_tank(p->beta, p->kappa, &tank));
  CHECK(p->first <= p->last, ERR_USAGE, "first: found %d; allowed: at most last = %d", p->first,
        p->last);
  for (int n = p->first; n <= p->last; n++) {
    struct wave_mode m = wave_mode_acoustic(&tank, n);
    double a = (2 * n + 1) * M_PI / 2, square = pow(a / p->kappa, 2);
    double first = a - m.delta / a * (1 - square) / (1 + square);
    double leading = tank.sound * sqrt(p->kappa * p->kappa + m.delta * m.delta + a * a);
    double on_lattice = lattice(p, a);
    TRY(THEORY_ROW(curve, n, m.root, a, first, m.omega, leading, on_lattice, lattice(p, m.root),
                   2 * M_PI / leading, 2 * M_PI / on_lattice));
  }
  return OK;
}

const struct theory_topic theory_acoustic = {
    .name = "acoustic",
    .help = "acoustic modes of a tank, and what a lattice of particles makes of their frequencies "
            "(T, eqs 2.57-2.63, figures 2-14 to 2-18)",
    .params_size = sizeof(struct acoustic),
    THEORY_TABLES,
    .evaluate = evaluate,
};

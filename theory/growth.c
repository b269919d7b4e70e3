/* Modes that decay with depth, e^(mu y) cos(kappa x) e^(w t), and do not satisfy the surface
 * condition (T, section 2.6.2, table 2.4, figures 2-28 and 2-29):
 *
 *     potential  w^2 = c^2 (mu^2 - kappa^2) - g mu, if the velocity potential has this form (2.176)
 *     pressure   w^2 = c^2 (mu^2 - kappa^2) + g mu, if pressure and density have it (2.195)
 *     lattice    w^2 = c^2 {[sinh(mu h)/h (1 - (2/3) sin^2(kappa h/2))]^2
 *                           - [sin(kappa h)/h (1 + (2/3) sinh^2(mu h/2))]^2} + g sinh(mu h)/h
 *                on a square lattice, dx = h, tensor product of cubic B-splines
 *     discrete   ln R(w dt)/dt of the lattice's w, R = 1 + z + z^2/2 + z^3/6 + z^4/24 that of RK4
 *
 * The first two are the same modes: a pressure e^(mu y) has the potential e^((mu + 2 delta) y).
 * Their growth is the travel of the large values at the surface downwards, and ends at t = |y|/c.
 * T's table 2.4 calls the first one of no stratification and the second one hydrostatic; without
 * gravity both are c mu. Units: g = H = 1. */
#include <math.h>

#include "theory/theory.h"

struct growth {
  double beta, spacing, kappa, courant, cells, to;
  int points;
};

static const struct param params[] = {
    THEORY_REAL(growth, beta, PARAM_ABOVE_0, 1e6, "20",
                "c^2/(g H); T's figures 2-28 and 2-29 call it c"),
    THEORY_REAL(growth, spacing, PARAM_ABOVE_0, 1, "0.02, 0.01", "dx = h over H"),
    THEORY_REAL(growth, kappa, 0, 1e4, "6.283185307179586", "horizontal wavenumber times H"),
    THEORY_REAL(growth, courant, PARAM_ABOVE_0, 2.8, "0.25", "c dt/h of the discrete rate"),
    THEORY_REAL(growth, cells, PARAM_ABOVE_0, 1e6, "25", "2 pi/(mu h) of the mode of the values"),
    THEORY_REAL(growth, to, PARAM_ABOVE_0, 20, "1", "largest mu h"),
    THEORY_POINTS(growth),
};
static const struct theory_column columns[] = {
    {.key = "mu", .unit = "1/H", .label = "μ H", .help = "rate of decay with depth"},
    {.key = "potential",
     .unit = "sqrt(g/H)",
     .label = "potential (2.176)",
     .axis = "growth w √(H/g)",
     .help = "growth if the potential has this form; 0: none"},
    {.key = "pressure",
     .unit = "sqrt(g/H)",
     .label = "pressure (2.195)",
     .help = "growth if the pressure has it"},
    {.key = "lattice",
     .unit = "sqrt(g/H)",
     .label = "lattice",
     .help = "on a lattice of particles"},
    {.key = "discrete", .unit = "sqrt(g/H)", .label = "lattice, RK4", .help = "with RK4 in time"},
};
enum { MU, POTENTIAL, PRESSURE, LATTICE, DISCRETE };
static const struct theory_value values[] = {
    [MU] = {"mu", "1/H", "the mode of 2 pi/(mu h) = cells"},
    [POTENTIAL] = {"potential", "sqrt(g/H)", "its growth by (2.176)"},
    [PRESSURE] = {"pressure", "sqrt(g/H)", "by (2.195)"},
    [LATTICE] = {"lattice", "sqrt(g/H)", "on the lattice"},
    [DISCRETE] = {"discrete", "sqrt(g/H)", "with RK4 in time"},
};

static double root_or_zero(double square) {
  return square > 0 ? sqrt(square) : 0;
}

/* mu and the four rates. */
static void rates(const struct growth *p, double mu, double out[5]) {
  double beta = p->beta, k = p->kappa, h = p->spacing, dt = p->courant * h / sqrt(beta);
  double square = beta * (mu * mu - k * k);
  double down = sinh(mu * h) / h * (1 - 2. / 3 * pow(sin(k * h / 2), 2));
  double along = sin(k * h) / h * (1 + 2. / 3 * pow(sinh(mu * h / 2), 2));
  double w = root_or_zero(beta * (down * down - along * along) + sinh(mu * h) / h), z = w * dt;
  out[MU] = mu;
  out[POTENTIAL] = root_or_zero(square - mu);
  out[PRESSURE] = root_or_zero(square + mu);
  out[LATTICE] = w;
  out[DISCRETE] = log1p(z + z * z / 2 + z * z * z / 6 + z * z * z * z / 24) / dt;
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct growth *p = with;
  double row[5];
  for (int i = 0; i < p->points; i++) {
    rates(p, theory_between(0, p->to / p->spacing, i, p->points), row);
    TRY(theory_row_add(curve, 5, row));
  }
  rates(p, 2 * M_PI / (p->cells * p->spacing), curve->value);
  return OK;
}

const struct theory_topic theory_growth = {
    .name = "growth",
    .help = "growth of modes that decay with depth, in the continuum, on a lattice and with RK4 "
            "(T, eqs 2.173-2.195, table 2.4, figures 2-28 and 2-29)",
    .params_size = sizeof(struct growth),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

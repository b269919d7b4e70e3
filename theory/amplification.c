/* What a step of an integrator does to linear waves of the discrete scheme (T, section 2.6.4). On
 * an undisturbed line of particles, dx = h, with the cubic B-spline, perturbations of position,
 * velocity and density over rho_f, times e^(kappa x), obey (T, table 3.1) direct density    y' = v,
 * v' = (c F)^2 y advanced density  v' = -c^2 F r,  r' = -F v   (y' = v only adds an eigenvalue 1)
 * where F = i sin(kh)/h for waves and sinh(mu h)/h for modes that decay. So it all depends on
 * z = mu_c |sin kh| or mu_c sinh(mu h), mu_c = c dt/h. */
#include <complex.h>
#include <math.h>

#include "theory/linear.h"
#include "theory/theory.h"

/* X(variant, name, help, coefficients of its polynomial of G dt). */
#define INTEGRATORS(X)                                                                             \
  X(euler, "euler", "forward Euler (T, eqs 2.246-2.249)", 1, 1)                                    \
  X(heun, "predictor-corrector", "Heun's method (T, eqs 2.250-2.255)", 1, 1, 1. / 2)               \
  X(midpoint, "midpoint",                                                                          \
    "half a step, then the step: the damped method at zeta = 1 "                                   \
    "(T, eqs 3.36-3.45)",                                                                          \
    1, 1, 1. / 2)                                                                                  \
  X(rk3, "tvd-rk3", "Runge-Kutta of order 3 in three stages", 1, 1, 1. / 2, 1. / 6)                \
  X(rk4, "rk4", "classic Runge-Kutta (T, eqs 2.260-2.269)", 1, 1, 1. / 2, 1. / 6, 1. / 24)

enum {
#define X(variant, name, help, ...) POLYNOMIAL_##variant,
  INTEGRATORS(X)
#undef X
      MODIFIED,
  SYMPLECTIC
};
static const char *const integrator_names[] = {
#define X(variant, name, help, ...) name,
    INTEGRATORS(X)
#undef X
        "modified-predictor-corrector",
    "symplectic", NULL};
static const char *const integrator_helps[] = {
#define X(variant, name, help, ...) help,
    INTEGRATORS(X)
#undef X
        "y to second order, v by the mean of both accelerations (T, eqs 2.256-2.259); with "
        "advanced density it is Heun's (2.267)",
    "kick, drift, kick: density and position by the velocity of the middle"};
static const double polynomials[][5] = {
#define X(variant, name, help, ...) {__VA_ARGS__},
    INTEGRATORS(X)
#undef X
};
static const char *const density_names[] = {"direct", "advanced", NULL};
static const char *const density_helps[] = {"rho = sum m W (T, eq. 2.16)",
                                            "its rate is integrated (T, eq. 2.201)"};
static const char *const mode_names[] = {"oscillating", "decaying", NULL};
static const char *const mode_helps[] = {"e^(i k x)", "e^(mu y)"};

struct amplification {
  int integrator, density, mode, points;
  double to;
};

/* G dt for (y, v dt) or (v/c, r): both have eigenvalues +- z or +- i z. */
static struct theory_matrix generator(const struct amplification *p, double z) {
  double complex f = p->mode ? z : I * z;
  if (p->density) return (struct theory_matrix){2, {{0, -f}, {-f, 0}}};
  return (struct theory_matrix){2, {{0, 1}, {f * f, 0}}};
}

/* Velocity Verlet: with direct density the acceleration depends on the position alone. */
static struct theory_matrix verlet(double complex square) {
  return (struct theory_matrix){2,
                                {{1 + square / 2, 1}, {square * (1 + square / 4), 1 + square / 2}}};
}

/* Half a kick, a drift of density, half a kick: Verlet's for (r, v). */
static struct theory_matrix step_of(const struct amplification *p, double z) {
  struct theory_matrix g = generator(p, z);
  double square = p->mode ? z * z : -z * z;
  if (p->integrator == SYMPLECTIC || (p->integrator == MODIFIED && !p->density))
    return verlet(square);
  if (p->integrator == MODIFIED) return theory_polynomial(&g, 4, polynomials[POLYNOMIAL_heun]);
  return theory_polynomial(&g, 4, polynomials[p->integrator]);
}

/* Rounding; Verlet's eigenvalues meet at their limit, and are then as uncertain as its root. */
static enum status is_stable(const struct amplification *p, double z, bool *stable) {
  bool meet = p->integrator == SYMPLECTIC || (p->integrator == MODIFIED && !p->density);
  struct theory_matrix m = step_of(p, z);
  double radius;
  TRY(theory_radius(&m, &radius));
  *stable = radius <= 1 + (meet ? 1e-7 : 1e-13);
  return OK;
}

/* The largest z up to which the step is stable, found from below. */
static enum status limit(const struct amplification *p, double *z) {
  const double most = 8, step = 1. / 64;
  double low = 0, high = step;
  bool stable = true;
  for (; high < most; high += step) {
    TRY(is_stable(p, high, &stable));
    if (!stable) break;
    low = high;
  }
  *z = 0;
  if (low == 0) return OK;
  while (high - low > 1e-13) {
    double middle = (low + high) / 2;
    TRY(is_stable(p, middle, &stable));
    *(stable ? &low : &high) = middle;
  }
  *z = low;
  return OK;
}

static const struct param params[] = {
    THEORY_CHOICE(amplification, integrator, integrator_names, integrator_helps,
                  "euler, predictor-corrector, modified-predictor-corrector, tvd-rk3, rk4",
                  "how a step is made"),
    THEORY_CHOICE(amplification, density, density_names, density_helps, "direct",
                  "how the density is found"),
    THEORY_CHOICE(amplification, mode, mode_names, mode_helps, "oscillating", "form of the mode"),
    THEORY_REAL(amplification, to, PARAM_ABOVE_0, 100, "3", "largest z"),
    THEORY_POINTS(amplification),
};
static const struct theory_column columns[] = {
    {.key = "z",
     .unit = "1",
     .label = "z = μ_c |sin kh| or μ_c sinh μh",
     .help = "c dt times the symbol of the derivative"},
    {.key = "lambda",
     .unit = "1",
     .label = "|λ|",
     .axis = "|λ| of a step",
     .level = "1",
     .top = 2.5,
     .help = "largest factor of a step"},
};
enum { LIMIT };
static const struct theory_value values[] = {
    [LIMIT] =
        {"z_most", "1",
         "largest stable z, and so Courant number mu_c of the shortest sine; 0: there is none"},
};

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct amplification *p = with;
  for (int i = 0; i < p->points; i++) {
    double z = theory_between(0, p->to, i, p->points), radius;
    struct theory_matrix m = step_of(p, z);
    TRY(theory_radius(&m, &radius));
    TRY(THEORY_ROW(curve, z, radius));
  }
  return limit(p, &curve->value[LIMIT]);
}

const struct theory_topic theory_amplification = {
    .name = "amplification",
    .help =
        "factor by which a step multiplies linear waves, and Courant limits, of each integrator "
        "and density (T, section 2.6.4, eqs 2.246-2.268)",
    .params_size = sizeof(struct amplification),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

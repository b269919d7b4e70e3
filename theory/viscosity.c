/* Artificial viscosity (T, section 3.4.4) in the midpoint step, on a line of particles with dx = h:
 *     y' = v,  v' = -(c sin(kh)/h)^2 y + G v,   G = -(2 alpha c/h) sin^2(kh/2)
 * for a viscosity that acts on both signs; where it acts on approaching pairs only, on one side of
 * a particle, G = -alpha c (1 - e^(+-i kh))/(2 h). T prints a plus for e^(-i kh), a real part that
 * would not damp. With s = mu_c sin kh and g = G dt the step's eigenvalues are
 *     1 - s^2/2 + g/2 + g^2/4 +- (1/4) sqrt(-16 s^2 + 4 g^2 - 16 s^2 g - 4 s^2 g^2 + 4 g^3 + g^4),
 * |lambda|^2 = 1 + s^4/4 + g (1 + s^2/2) + O(g^2): it does stabilise, which T denies. */
#include <complex.h>
#include <math.h>

#include "theory/linear.h"
#include "theory/theory.h"

static const char *const pair_names[] = {"both", "one-side", NULL};
static const char *const pair_helps[] = {"pairs that approach and that part (no switch)",
                                         "one neighbour of the two, as with the switch"};

struct viscosity {
  double alpha, courant;
  int pairs, points;
};

static const struct param params[] = {
    THEORY_REAL(viscosity, alpha, 0, 100, "0, 0.01, 0.05", "coefficient of the viscosity"),
    THEORY_REAL(viscosity, courant, PARAM_ABOVE_0, 10, "0.3", "mu_c = c dt/h"),
    THEORY_CHOICE(viscosity, pairs, pair_names, pair_helps, "both", "on which pairs it acts"),
    THEORY_POINTS(viscosity),
};
static const struct theory_column columns[] = {
    {.key = "kh", .unit = "1", .label = "k h", .help = "wavenumber times h"},
    {.key = "growth",
     .unit = "1",
     .label = "|λ| − 1",
     .axis = "|λ| − 1 of a step",
     .level = "0",
     .help = "growth in a step"},
};
enum { WORST, WORST_AT, LIMIT };
static const struct theory_value values[] = {
    [WORST] = {"growth_most", "1", "largest growth in a step"},
    [WORST_AT] = {"kh_most", "1", "k h of that"},
    [LIMIT] = {"courant_most", "1", "Courant number up to which no wave grows; 0: there is none"},
};

/* Of y and dt v. */
static struct theory_matrix rates_of(const struct viscosity *p, double courant, double kh) {
  double s = courant * sin(kh);
  double complex one_side = -p->alpha * courant * (1 - cexp(I * kh)) / 2;
  double complex g = p->pairs ? one_side : -2 * p->alpha * courant * pow(sin(kh / 2), 2);
  return (struct theory_matrix){2, {{0, 1}, {-s * s, g}}};
}

static enum status growth(const struct viscosity *p, double courant, double kh, double *excess) {
  struct theory_matrix z = rates_of(p, courant, kh);
  struct theory_matrix m = theory_step(&sph_damped_pc, &z, 0); /* which is the midpoint's */
  TRY(theory_radius(&m, excess));
  *excess -= 1;
  return OK;
}

static enum status worst(const struct viscosity *p, double courant, double *most, double *at) {
  *most = -INFINITY;
  for (int i = 1; i <= THEORY_WAVES; i++) {
    double kh = M_PI * i / THEORY_WAVES, excess;
    TRY(growth(p, courant, kh, &excess));
    if (excess <= *most) continue;
    *most = excess;
    *at = kh;
  }
  return OK;
}

/* From what a midpoint step changes, Z + Z^2/2: without viscosity growth is mu_c^4/8, which is not
 * seen beside 1. */
static bool any_grows(double courant, const void *with) {
  const struct viscosity *p = with;
  for (int i = 1; i <= THEORY_WAVES; i++) {
    const struct theory_matrix z = rates_of(p, courant, M_PI * i / THEORY_WAVES);
    struct theory_matrix d = z;
    for (int row = 0; row < 2; row++)
      for (int column = 0; column < 2; column++)
        d.a[row][column] += (z.a[row][0] * z.a[0][column] + z.a[row][1] * z.a[1][column]) / 2;
    if (theory_excess(&d) > 0) return true;
  }
  return false;
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct viscosity *p = with;
  for (int i = 0; i < p->points; i++) {
    double kh = theory_between(0, M_PI, i, p->points), excess;
    TRY(growth(p, p->courant, kh, &excess));
    TRY(THEORY_ROW(curve, kh, excess));
  }
  TRY(worst(p, p->courant, &curve->value[WORST], &curve->value[WORST_AT]));
  curve->value[LIMIT] = theory_limit(any_grows, p, 4);
  return OK;
}

const struct theory_topic theory_viscosity = {
    .name = "viscosity",
    .help = "growth in a midpoint step with artificial viscosity (T, eqs 3.46-3.55, corrected)",
    .params_size = sizeof(struct viscosity),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

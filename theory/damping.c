/* Initial damping (T, section 3.4.3): with zeta = 1 + Gamma dt/2
 *     predictor  y_p = y + (dt/2) v,          v_p = (v + (dt/2) v')/zeta
 *     corrector  y   = y + dt v_p,            v   = (2/zeta) (v + (dt/2) v'_p) - v
 * and likewise of the density. Its matrix, with X = (c dt F)^2 of the shortest wave (|sin kh| = 1)
 * or of a decaying mode, has the eigenvalues
 *     lambda = [1 + X/2 +- sqrt(1 + X - 2 zeta + zeta^2)]/zeta,
 * here those of the solver's step. Waves are stable up to s^2 = 2 sqrt(2 zeta (zeta - 1)), s^2 =
 * -X; without damping (zeta = 1) never. Decaying modes grow with any. */
#include <math.h>

#include "theory/linear.h"
#include "theory/theory.h"

static const char *const mode_names[] = {"oscillating", "decaying", NULL};
static const char *const mode_helps[] = {"e^(i k x), X = -(mu_c sin kh)^2",
                                         "e^(mu y), X = (mu_c sinh mu h)^2"};

struct damping {
  double zeta, to;
  int mode, points;
};

static const struct param params[] = {
    THEORY_REAL(damping, zeta, 1, 100, "1, 1.005, 1.025", "1 + Gamma dt/2"),
    THEORY_CHOICE(damping, mode, mode_names, mode_helps, "oscillating", "form of the mode"),
    THEORY_REAL(damping, to, PARAM_ABOVE_0, 100, "1", "largest c dt |F|"),
    THEORY_POINTS(damping),
};
static const struct theory_column columns[] = {
    {.key = "courant",
     .unit = "1",
     .label = "μ_c |sin kh| or μ_c sinh μh",
     .help = "c dt |F|: the Courant number of the worst wave, or mu*"},
    {.key = "lambda",
     .unit = "1",
     .label = "|λ|",
     .axis = "|λ| of a step",
     .level = "1",
     .help = "largest factor of a step"},
};
enum { LIMIT };
static const struct theory_value values[] = {
    [LIMIT] = {"courant_most", "1", "largest stable Courant number; 0: there is none"},
};

/* The step of (y, dt v), with dt^2 v' = X y. */
static struct theory_matrix step_of(const struct damping *p, double x) {
  struct theory_matrix z = {2, {{0, 1}, {x, 0}}};
  return theory_step(&sph_damped_pc, &z, 2 * (p->zeta - 1));
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct damping *p = with;
  for (int i = 0; i < p->points; i++) {
    double s = theory_between(0, p->to, i, p->points), radius;
    struct theory_matrix m = step_of(p, p->mode ? s * s : -s * s);
    TRY(theory_radius(&m, &radius));
    TRY(THEORY_ROW(curve, s, radius));
  }
  curve->value[LIMIT] = p->mode ? 0 : sqrt(2 * sqrt(2 * p->zeta * (p->zeta - 1)));
  return OK;
}

const struct theory_topic theory_damping = {
    .name = "damping",
    .help = "factor of a step with initial damping (T, section 3.4.3, figures 3-1 and 3-2)",
    .params_size = sizeof(struct damping),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

/* Initial damping (T, section 3.4.3): with zeta = 1 + Gamma dt/2
 *     predictor  y_p = y + (dt/2) v,          v_p = (v + (dt/2) v')/zeta
 *     corrector  y   = y + dt v_p,            v   = (2/zeta) (v + (dt/2) v'_p) - v
 * and likewise of the density, without zeta, where its rate is integrated, which leaves the same
 * eigenvalues. Its matrix, with X = (c dt F)^2 of the shortest wave (|sin kh| = 1)
 * or of a decaying mode, has the eigenvalues
 *     lambda = [1 + X/2 +- sqrt(1 + X - 2 zeta + zeta^2)]/zeta,
 * here those of the solver's step, beside this closed form and the scheme itself, carried out for
 * `steps` steps. Waves are stable up to s^2 = 2 sqrt(2 zeta (zeta - 1)), s^2 = -X; without damping
 * (zeta = 1) never; the limit given is found by halving, from what a step of the scheme changes.
 * Decaying modes grow with any. */
#include <complex.h>
#include <math.h>

#include "theory/linear.h"
#include "theory/theory.h"

static const char *const mode_names[] = {"oscillating", "decaying", NULL};
static const char *const mode_helps[] = {"e^(i k x), X = -(mu_c sin kh)^2",
                                         "e^(mu y), X = (mu_c sinh mu h)^2"};

static const char *const density_names[] = {"direct", "advanced", NULL};
static const char *const density_helps[] = {"rho = sum m W", "its rate is integrated"};

struct damping {
  double zeta, to;
  int mode, density, points, steps;
};

static const struct param params[] = {
    THEORY_REAL(damping, zeta, 1, 100, "1, 1.005, 1.025", "1 + Gamma dt/2"),
    THEORY_CHOICE(damping, mode, mode_names, mode_helps, "oscillating", "form of the mode"),
    THEORY_CHOICE(damping, density, density_names, density_helps, "direct",
                  "how the density is found, of the solver's step"),
    THEORY_REAL(damping, to, PARAM_ABOVE_0, 100, "1", "largest c dt |F|"),
    THEORY_POINTS(damping),
    THEORY_INT(damping, steps, 0, 1000000, "0", "how many are carried out, of `after`"),
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
    {.key = "closed",
     .unit = "1",
     .label = "closed form",
     .undrawn = true,
     .help = "its closed form"},
    {.key = "after",
     .unit = "1",
     .label = "after the steps",
     .undrawn = true,
     .help = "amplitude after `steps` steps from 1, position and velocity over c F"},
};
enum { LIMIT };
static const struct theory_value values[] = {
    [LIMIT] = {"courant_most", "1", "largest stable Courant number; 0: there is none"},
};

/* The step of (y, dt v), with dt^2 v' = X y, or of (v/c, r). */
static struct theory_matrix step_of(const struct damping *p, double x) {
  const double complex f = csqrt(x);
  const struct theory_matrix direct = {2, {{0, 1}, {x, 0}}};
  const struct theory_matrix advanced = {3, {{0, 1, 0}, {0, 0, -f}, {0, -f, 0}}};
  struct theory_matrix m =
      theory_step(&sph_damped_pc, p->density ? &advanced : &direct, 2 * (p->zeta - 1));
  return p->density ? theory_block(&m, 1, 2) : m;
}

static double closed(const struct damping *p, double x) {
  double complex root = csqrt(1 + x - 2 * p->zeta + p->zeta * p->zeta);
  return fmax(cabs(1 + x / 2 + root), cabs(1 + x / 2 - root)) / p->zeta;
}

struct state {
  double y, v; /* v: dt times it */
};

/* The scheme (3.36)-(3.39): what a step changes. */
static struct state change(const struct damping *p, double x, struct state w) {
  const double y_p = w.y + w.v / 2, v_p = (w.v + x * w.y / 2) / p->zeta;
  return (struct state){v_p, (x * y_p - 2 * (p->zeta - 1) * w.v) / p->zeta};
}

static double carried_out(const struct damping *p, double x) {
  struct state w = {1, 0};
  for (int i = 0; i < p->steps; i++) {
    const struct state more = change(p, x, w);
    w.y += more.y;
    w.v += more.v;
  }
  return x == 0 ? w.y : hypot(w.y, w.v / sqrt(fabs(x)));
}

static bool grows(double s, const void *with) {
  const struct damping *p = with;
  const double x = p->mode ? s * s : -s * s;
  const struct state a = change(p, x, (struct state){1, 0}), b = change(p, x, (struct state){0, 1});
  const struct theory_matrix d = {2, {{a.y, b.y}, {a.v, b.v}}};
  return theory_excess(&d) > 0;
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct damping *p = with;
  for (int i = 0; i < p->points; i++) {
    double s = theory_between(0, p->to, i, p->points), radius;
    double x = p->mode ? s * s : -s * s;
    struct theory_matrix m = step_of(p, x);
    TRY(theory_radius(&m, &radius));
    TRY(THEORY_ROW(curve, s, radius, closed(p, x), p->steps ? carried_out(p, x) : NAN));
  }
  curve->value[LIMIT] = theory_limit(grows, p, 100);
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

/* What a step of the particle solver's integrators does to linear waves of the discrete scheme (T,
 * section 2.6.4). On an undisturbed line of particles, dx = h, with the cubic B-spline,
 * perturbations of position, velocity and density over rho_f, times e^(kappa x), obey (T, table
 * 3.1)
 *
 *   direct density    y' = v, v' = (c F)^2 y
 *   advanced density  v' = -c^2 F r,  r' = -F v   (y' = v only adds an eigenvalue 1)
 *
 * where F = i sin(kh)/h for waves and sinh(mu h)/h for modes that decay. So it all depends on
 * z = mu_c |sin kh| or mu_c sinh(mu h), mu_c = c dt/h. The step is the solver's own
 * (sph/time/linear.h), without damping. */
#include <complex.h>
#include <math.h>

#include "theory/linear.h"
#include "theory/theory.h"

static const char *const integrator_names[] = {
#define X(variant, name, help) name,
    SPH_INTEGRATORS(X)
#undef X
        NULL};
static const char *const integrator_helps[] = {
#define X(variant, name, help) help,
    SPH_INTEGRATORS(X)
#undef X
        NULL};
static const char *const density_names[] = {"direct", "advanced", NULL};
static const char *const density_helps[] = {"rho = sum m W (T, eq. 2.16)",
                                            "its rate is integrated (T, eq. 2.201)"};
static const char *const mode_names[] = {"oscillating", "decaying", NULL};
static const char *const mode_helps[] = {"e^(i k x)", "e^(mu y)"};

struct amplification {
  int integrator, density, mode, points;
  double to;
};

/* Of (y, v dt) or (v/c, r), which have eigenvalues +- z or +- i z. */
static struct theory_matrix step_of(const struct amplification *p, double z) {
  const double complex f = p->mode ? z : I * z;
  const struct theory_matrix direct = {2, {{0, 1}, {f * f, 0}}};
  const struct theory_matrix advanced = {3, {{0, 1, 0}, {0, 0, -f}, {0, -f, 0}}};
  struct theory_matrix m =
      theory_step(sph_integrators[p->integrator], p->density ? &advanced : &direct, 0);
  return p->density ? theory_block(&m, 1, 2) : m;
}

/* Its two eigenvalues meet at the limit of stability, which then is as uncertain as their root. */
static bool is_neutral(const struct amplification *p) {
  return p->integrator == SPH_INTEGRATOR_stoermer_verlet ||
         (p->integrator == SPH_INTEGRATOR_modified_pc && !p->density);
}

/* But for rounding. */
static enum status is_stable(const struct amplification *p, double z, bool *stable) {
  struct theory_matrix m = step_of(p, z);
  double radius;
  TRY(theory_radius(&m, &radius));
  *stable = radius <= 1 + (is_neutral(p) ? 1e-7 : 1e-13);
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
                  "euler, predictor-corrector, modified-pc, tvd-rk3, rk4", "how a step is made"),
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
        "factor by which a step of the particle solver's integrators multiplies linear waves, and "
        "Courant limits, with either density (T, section 2.6.4, eqs 2.246-2.268)",
    .params_size = sizeof(struct amplification),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

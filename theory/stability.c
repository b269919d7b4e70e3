/* Up to what time step the particle solver's own integrators are stable in water at rest, for every
 * wave that a square lattice carries (sph/theory/stability.h), and how waves grow beyond. P's
 * bounds (27) and (29) are such numbers for the Gaussian, with room left for disordered particles.
 */
#include "sph/theory/stability.h"

#include <math.h>

#include "sph/pair/derivative.h"
#include "sph/pair/forms.h"
#include "sph/time/integrator.h"
#include "theory/kernels.h"
#include "theory/theory.h"

struct stability {
  int kernel, integrator, diffusion, derivative, continuity, waves, points;
  double ratio, radius, delta, alpha, rate, to;
};

static const struct param params[] = {
    THEORY_CHOICE(stability, kernel, theory_kernel_names, NULL, "gaussian", "the kernel"),
    THEORY_CHOICE(stability, integrator, sph_integrator_names, NULL, "rk4, rk4-frozen, tvd-rk3",
                  "the integrator"),
    THEORY_CHOICE(stability, diffusion, theory_diffusion_names, NULL, "antuono",
                  "the diffusive term"),
    THEORY_CHOICE(stability, derivative, theory_derivative_names, NULL, "kernel",
                  "how gradients and divergences are taken"),
    THEORY_REAL(stability, radius, 1, 3, "1.5", "of mls and mueller, in h"),
    THEORY_CHOICE(stability, continuity, theory_continuity_names, NULL, "divergence",
                  "the continuity equation; what matters is whether the density is a sum"),
    THEORY_REAL_OR(stability, delta, 0, 10, sph_delta_words, sph_delta_word_helps, "auto",
                   "its coefficient"),
    THEORY_REAL(stability, alpha, 0, 1, "0", "artificial viscosity"),
    THEORY_REAL(stability, ratio, 0.8, 3, "1.3333333333333333", "h/dx"),
    THEORY_REAL(stability, rate, 0, 1, "0", "growth that is let be, c0/h"),
    THEORY_INT(stability, waves, 4, 128, "32", "along each axis"),
    THEORY_REAL(stability, to, PARAM_ABOVE_0, 20, "4", "largest c0 dt/h"),
    THEORY_INT(stability, points, 2, 10000, "81", "points of each curve"),
};
static const struct theory_column columns[] = {
    {.key = "courant", .unit = "1", .label = "c_0 Δt/h", .help = "the time step"},
    {.key = "lambda",
     .unit = "1",
     .label = "|λ|",
     .axis = "|λ| of a step",
     .level = "1",
     .top = 2.5,
     .help = "largest factor by which a step multiplies any wave"},
};
enum { DELTA, LIMIT, DIFFUSIVE };
static const struct theory_value values[] = {
    [DELTA] = {"delta", "1", "coefficient of the diffusion"},
    [LIMIT] = {"courant_most", "1", "largest stable c0 dt/h"},
    [DIFFUSIVE] = {"diffusive_most", "1", "delta times that, as in (27)"},
};

static enum status fill(const struct stability *p, const struct sph_scheme *o, struct sph_modes *m,
                        struct theory_curve *curve) {
  double *v = curve->value;
  for (int i = 1; i <= p->points; i++) {
    double courant = p->to * i / p->points, growth;
    TRY(sph_modes_growth(m, courant, &growth, NULL));
    TRY(THEORY_ROW(curve, courant, growth));
  }
  v[DELTA] = sph_scheme_delta(o);
  TRY(sph_modes_limit(m, p->rate, &v[LIMIT]));
  v[DIFFUSIVE] = v[DELTA] * v[LIMIT];
  return OK;
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct stability *p = with;
  const bool pairs = p->derivative == SPH_DERIVATIVE_kernel;
  const struct sph_scheme o = {.momentum = pairs ? SPH_MOMENTUM_plus : SPH_MOMENTUM_minus,
                               .derivative = p->derivative,
                               .derivative_radius = p->radius,
                               .continuity = p->continuity,
                               .kernel = p->kernel,
                               .integrator = p->integrator,
                               .diffusion = p->diffusion,
                               .h_over_dx = p->ratio,
                               .delta = p->delta,
                               .alpha = p->alpha,
                               .c0 = 1};
  struct sph_modes *m;
  const char *key, *wrong = sph_forms_refusal(&o, &key);
  CHECK(!wrong, ERR_USAGE, "%s: found %s", key, wrong);
  TRY(sph_modes_create(&o, p->waves, &m));
  enum status status = fill(p, &o, m, curve);
  sph_modes_destroy(m);
  return status;
}

const struct theory_topic theory_stability = {
    .name = "stability",
    .help = "largest stable time step of the particle solver's integrators with its kernels and "
            "diffusions (P, eqs 25-29)",
    .params_size = sizeof(struct stability),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

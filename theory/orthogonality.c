/* Inner products of wave modes (T, eqs 2.85-2.93, figures 2-20, 2-22 and 2-23, top)
 *     I_mn = int e^(-2 delta z) (psi_m' psi_n' + kappa^2 psi_m psi_n) dz                   (2.91)
 * vanish for exact modes that differ. (2.85) prints psi_-1 = e^((kappa - delta) y) and acoustic
 * modes without e^(delta y); they are orthogonal with e^(kappa y) in deep water, and with e^(delta
 * y). (2.88) lacks the weight, (2.89) prints psi(-H) = 0 for psi'(-H) = 0. With the deep psi_-1
 *     I_-1n = -e^(2 delta H) omega_n^2 psi_n(-H) kappa e^(-kappa H)/(omega_n^2 - g kappa).
 * The norm of an acoustic mode is I_nn = omega_n^2 (psi_n(0)^2/g + int e^(-2 delta z) psi_n^2 dz
 * /c^2). Units: g = H = 1. */
#include <math.h>

#include "theory/modes.h"
#include "theory/theory.h"

struct orthogonality {
  double beta, kappa, amplitude;
  int mode, profile, last;
};

static const struct param params[] = {
    THEORY_INT(orthogonality, mode, -1, 200, "-1", "m; -1: the decaying mode"),
    THEORY_CHOICE(orthogonality, profile, theory_profile_names, theory_profile_helps, "exact, deep",
                  "which modes"),
    THEORY_REAL(orthogonality, kappa, PARAM_ABOVE_0, 1e3, "6.283185307179586",
                "horizontal wavenumber times H"),
    THEORY_REAL(orthogonality, beta, PARAM_ABOVE_0, 1e6, "10", "c^2/(g H)"),
    THEORY_REAL(orthogonality, amplitude, PARAM_ABOVE_0, 1e6, "1",
                "of the potential of mode m, e.g. A sqrt(g/kappa)"),
    THEORY_INT(orthogonality, last, 0, 200, "50", "n of the last mode"),
};
static const struct theory_column columns[] = {
    {.key = "n", .unit = "1", .label = "mode n", .help = "number of the other mode"},
    {.key = "product",
     .unit = "1",
     .label = "|I_{mn}|",
     .help = "magnitude of (2.91)",
     .log = true,
     .points = true},
    {.key = "share",
     .unit = "1",
     .label = "|I_{mn}|/√(I_{mm} I_{nn})",
     .panel = 1,
     .log = true,
     .points = true,
     .help = "the same over both norms"},
    {.key = "closed",
     .unit = "1",
     .label = "closed form",
     .undrawn = true,
     .help = "closed form of the product of the deep psi_-1; none for others"},
    {.key = "own", .unit = "1", .label = "I_{nn}", .undrawn = true, .help = "norm of mode n"},
    {.key = "own_closed",
     .unit = "1",
     .label = "closed form",
     .undrawn = true,
     .help = "its closed form, of exact wavenumbers; none for others"},
};
enum { NORM };
static const struct theory_value values[] = {[NORM] = {"norm", "1", "I_mm"}};

static double weighted_square(double z, const void *with) {
  const struct theory_mode *m = with;
  return exp(-2 * m->exact.delta * z) * pow(theory_mode_psi(m, z), 2);
}

/* |I_-1n| with e^(kappa y), and I_nn; NaN where a mode is not exact. */
static double product_closed(const struct orthogonality *p, const struct theory_mode *n) {
  double square = n->exact.omega * n->exact.omega, kappa = p->kappa;
  if (p->mode >= 0 || p->profile != THEORY_DEEP) return NAN;
  return p->amplitude * exp(2 * n->exact.delta) * square * fabs(theory_mode_psi(n, -1)) * kappa *
         exp(-kappa) / (square - kappa);
}

static double norm_closed(const struct orthogonality *p, const struct theory_mode *n) {
  if (p->profile == THEORY_LEADING || p->profile == THEORY_PRINTED) return NAN;
  return pow(n->exact.omega, 2) *
         (pow(theory_mode_psi(n, 0), 2) + theory_integral(weighted_square, n) / p->beta);
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct orthogonality *p = with;
  struct theory_mode m, n;
  TRY(theory_mode_find(p->beta, p->kappa, p->mode, (enum theory_profile)p->profile, &m));
  double norm = theory_inner_product(&m, &m);
  for (int k = 0; k <= p->last; k++) {
    TRY(theory_mode_find(p->beta, p->kappa, k, (enum theory_profile)p->profile, &n));
    double product = fabs(theory_inner_product(&m, &n));
    double own = theory_inner_product(&n, &n), share = product / sqrt(norm * own);
    TRY(THEORY_ROW(curve, k, p->amplitude * product, share, product_closed(p, &n), own,
                   norm_closed(p, &n)));
  }
  curve->value[NORM] = norm;
  return OK;
}

const struct theory_topic theory_orthogonality = {
    .name = "orthogonality",
    .help = "inner products of wave modes (T, eqs 2.85-2.93, figures 2-20, 2-22, 2-23)",
    .params_size = sizeof(struct orthogonality),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

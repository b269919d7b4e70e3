/* Linear gravity waves: omega of deep water, sqrt(g kappa) (T, eq. 2.50), of finite depth,
 * sqrt(g kappa tanh kappa H) (Airy), and of stratified, weakly compressible water of that depth (T,
 * eqs 2.31, 2.39), whose profile decays like e^((delta + mu) y). Units: g = H = 1. */
#include <math.h>

#include "common/flow/waves.h"
#include "theory/modes.h"
#include "theory/theory.h"

struct waves {
  double beta, from, to;
  int points;
};

static const struct param params[] = {
    THEORY_REAL(waves, beta, PARAM_ABOVE_0, 1e12, "1, 10, 100", "c^2/(g H)"),
    THEORY_REAL(waves, from, PARAM_ABOVE_0, 1e4, "0.05", "least kappa H"),
    THEORY_REAL(waves, to, PARAM_ABOVE_0, 1e4, "10", "largest kappa H"),
    THEORY_POINTS(waves),
};
static const struct theory_column columns[] = {
    {.key = "kappa", .unit = "1/H", .label = "κ H", .help = "wavenumber", .log = true},
    {.key = "deep",
     .unit = "sqrt(g/H)",
     .label = "deep water",
     .axis = "ω √(H/g)",
     .same = true,
     .log = true,
     .help = "frequency in deep water (2.50)"},
    {.key = "airy",
     .unit = "sqrt(g/H)",
     .label = "finite depth",
     .same = true,
     .help = "frequency by Airy, finite depth"},
    {.key = "compressible",
     .unit = "sqrt(g/H)",
     .label = "compressible",
     .help = "frequency of compressible water"},
    {.key = "shift",
     .unit = "1",
     .label = "(ω/ω_{Airy})^2 − 1",
     .level = "0",
     .panel = 1,
     .help = "what compressibility does to its square"},
    {.key = "mu",
     .unit = "1/H",
     .label = "μ H",
     .undrawn = true,
     .help = "vertical wavenumber, root of (2.39)"},
};

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct waves *p = with;
  CHECK(p->from < p->to, ERR_USAGE, "from: found %g; allowed: less than to = %g", p->from, p->to);
  for (int i = 0; i < p->points; i++) {
    double kappa = exp(theory_between(log(p->from), log(p->to), i, p->points));
    struct wave_column tank;
    TRY(theory_tank(p->beta, kappa, &tank));
    struct wave_mode m = wave_mode_gravity(&tank);
    double airy = wave_frequency_linear(kappa, 1, 1), ratio = m.omega / airy;
    TRY(THEORY_ROW(curve, kappa, sqrt(kappa), airy, m.omega, ratio * ratio - 1, m.root));
  }
  return OK;
}

const struct theory_topic theory_waves = {
    .name = "waves",
    .help = "frequency of linear gravity waves: deep, of finite depth, compressible (T, eqs 2.39, "
            "2.50)",
    .params_size = sizeof(struct waves),
    THEORY_TABLES,
    .evaluate = evaluate,
};

/* What the filters of a single wavenumber find in 2 phi_-1 + phi_n, unit potentials (T,
 * eqs 2.93-2.95, figure 2-21): the amplitude 2, and an error that is
 *
 *     plain     (s_n - e^(-kappa H) psi_n(-H))/(1 - e^(-2 kappa H))
 *     weighted  I_-1n/I_-1-1,  I_-1-1 = kappa^2 (1 - e^(-2 (kappa - delta) H))/(kappa - delta)
 *     exact     0
 *
 * s_n is largest, delta/kappa, at nu = kappa. With psi_-1 = e^((kappa - delta) y), as T prints it,
 * (2.94) is not the projection; (2.96) is then superfluous. */
#include "theory/projection.h"

#include <math.h>

#include "theory/theory.h"

const char *const theory_filter_names[] = {"plain", "weighted", "exact", "printed", NULL};
const char *const theory_filter_helps[] = {"(2.95)", "(2.94), corrected",
                                           "(2.93), modes of the tank",
                                           "the first form of (2.94), as it stands"};

struct field {
  enum theory_filter filter;
  const struct theory_mode *decaying;
  double (*psi)(double y, const void *with), (*slope)(double y, const void *with);
  const void *with;
};

/* v - i u is psi' + kappa psi. */
static double found(double z, const void *with) {
  const struct field *f = with;
  double kappa = f->decaying->exact.in.wavenumber, delta = f->decaying->exact.delta;
  double psi = f->psi(z, f->with), slope = f->slope(z, f->with);
  switch (f->filter) {
  case THEORY_FILTER_PLAIN:
    return exp(kappa * z) * (slope + kappa * psi);
  case THEORY_FILTER_WEIGHTED:
    return exp((kappa - 2 * delta) * z) * (slope + kappa * psi);
  case THEORY_FILTER_PRINTED:
    return exp((kappa - 3 * delta) * z) * ((kappa - delta) * slope + kappa * kappa * psi);
  case THEORY_FILTER_EXACT:
    break;
  }
  return exp(-2 * delta * z) * (theory_mode_slope(f->decaying, z) * slope +
                                kappa * kappa * theory_mode_psi(f->decaying, z) * psi);
}

static double own_psi(double y, const void *with) {
  return theory_mode_psi(with, y);
}

static double own_slope(double y, const void *with) {
  return theory_mode_slope(with, y);
}

double theory_filter_apply(enum theory_filter filter, const struct theory_mode *decaying,
                           double (*psi)(double y, const void *with),
                           double (*slope)(double y, const void *with), const void *with) {
  struct field field = {filter, decaying, psi, slope, with};
  struct theory_mode mode = *decaying;
  if (filter == THEORY_FILTER_PRINTED) mode.lacked = mode.exact.delta;
  struct field own = {filter, decaying, own_psi, own_slope, &mode};
  return theory_integral(found, &field) / theory_integral(found, &own);
}

struct projection {
  double beta, kappa;
  int filter, last;
};

static const struct param params[] = {
    THEORY_CHOICE(projection, filter, theory_filter_names, theory_filter_helps,
                  "plain, weighted, exact", "the filter"),
    THEORY_REAL(projection, kappa, PARAM_ABOVE_0, 1e3, "6.283185307179586",
                "horizontal wavenumber times H"),
    THEORY_REAL(projection, beta, PARAM_ABOVE_0, 1e6, "10", "c^2/(g H)"),
    THEORY_INT(projection, last, 0, 200, "50", "n of the last mode"),
};
static const struct theory_column columns[] = {
    {.key = "n", .unit = "1", .label = "mode n", .help = "number of the acoustic mode"},
    {.key = "amplitude",
     .unit = "1",
     .label = "amplitude found",
     .level = "2",
     .points = true,
     .help = "of the decaying mode, which is 2"},
    {.key = "error",
     .unit = "1",
     .label = "|error|",
     .panel = 1,
     .log = true,
     .points = true,
     .help = "its error"},
    {.key = "closed",
     .unit = "1",
     .label = "closed form",
     .undrawn = true,
     .help = "closed form of the error's magnitude; none of the printed filter"},
    {.key = "own",
     .unit = "1",
     .label = "found alone",
     .undrawn = true,
     .help = "found of the decaying mode alone, which is 1"},
};
enum { WORST, WORST_AT };
static const struct theory_value values[] = {
    [WORST] = {"error_most", "1", "largest error"},
    [WORST_AT] = {"error_mode", "1", "n of that"},
};

static double closed(const struct projection *p, const struct theory_mode *n) {
  double kappa = p->kappa, delta = n->exact.delta, bed = theory_mode_psi(n, -1);
  double square = n->exact.omega * n->exact.omega;
  switch ((enum theory_filter)p->filter) {
  case THEORY_FILTER_PLAIN:
    return fabs(n->exact.s - exp(-kappa) * bed) / (1 - exp(-2 * kappa));
  case THEORY_FILTER_WEIGHTED:
    return exp(2 * delta) * square * fabs(bed) * exp(-kappa) / (square - kappa) * (kappa - delta) /
           (kappa * (1 - exp(-2 * (kappa - delta))));
  case THEORY_FILTER_EXACT:
    return 0;
  case THEORY_FILTER_PRINTED:
    break;
  }
  return NAN;
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct projection *p = with;
  enum theory_filter filter = (enum theory_filter)p->filter;
  enum theory_profile profile = filter == THEORY_FILTER_EXACT ? THEORY_EXACT : THEORY_DEEP;
  struct theory_mode decaying, n;
  TRY(theory_mode_find(p->beta, p->kappa, -1, profile, &decaying));
  double alone = theory_filter_apply(filter, &decaying, own_psi, own_slope, &decaying);
  for (int k = 0; k <= p->last; k++) {
    TRY(theory_mode_find(p->beta, p->kappa, k, profile, &n));
    double sound = theory_filter_apply(filter, &decaying, own_psi, own_slope, &n);
    double error = sound + 2 * (alone - 1);
    TRY(THEORY_ROW(curve, k, 2 + error, fabs(error), closed(p, &n), alone));
    if (fabs(error) <= curve->value[WORST]) continue; /* NaN at first */
    curve->value[WORST] = fabs(error);
    curve->value[WORST_AT] = k;
  }
  return OK;
}

const struct theory_topic theory_projection = {
    .name = "projection",
    .help =
        "what modal filters find of the decaying mode beside an acoustic one (T, eqs 2.93-2.95, "
        "figure 2-21)",
    .params_size = sizeof(struct projection),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

#include "compare/convergence/triple.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

#include "common/base/root.h"

const char *const cmp_trend_names[CMP_N_TRENDS] = {
#define X(name, help) #name,
    CMP_TRENDS(X)
#undef X
};

struct ratios {
  double fine, coarse, change; /* h2/h1, h3/h2, (f3 - f2)/(f2 - f1) */
};

/* ln of r21^p (r32^p - 1)/(r21^p - 1), which rises with p from ln(r32)/ln(r21) at 0, over that of
 * the ratio of differences. */
static double off(double p, const void *with) {
  const struct ratios *r = with;
  const double a = p * log(r->fine), b = p * log(r->coarse);
  return a + log(expm1(b)) - log(expm1(a)) - log(r->change);
}

/* Where the finer difference is the larger one, as without a limit: 0 or less; NaN never. */
static double order_of(const struct ratios *r) {
  if (r->change <= log(r->coarse) / log(r->fine)) return 0;
  const double most = log1p(r->change) / log(r->coarse); /* r21^p/(r21^p - 1) is more than 1 */
  const double p = root_between(off, r, 1e-9, 1.01 * most + 1e-6);
  return isnan(p) ? 0 : p; /* so near the limit of order 0 that it cannot be told from it */
}

static struct cmp_triple without_order(enum cmp_trend trend, double bar) {
  return (struct cmp_triple){trend, NAN, NAN, NAN, bar};
}

static double half_range(const double f[3]) {
  return (fmax(f[0], fmax(f[1], f[2])) - fmin(f[0], fmin(f[1], f[2]))) / 2;
}

struct cmp_triple cmp_triple_of(const double h[3], const double f[3], const double known_to[3]) {
  const double size = fmax(fabs(f[0]), fmax(fabs(f[1]), fabs(f[2])));
  const double rounding = 8 * DBL_EPSILON * size, coarse = f[0] - f[1], fine = f[1] - f[2];
  const bool same_fine = fabs(fine) <= rounding, same_coarse = fabs(coarse) <= rounding;
  if (same_fine && same_coarse) return without_order(CMP_TREND_constant, 0);
  if (same_fine) return without_order(CMP_TREND_stalled, NAN);
  if (same_coarse) return without_order(CMP_TREND_diverging, NAN);
  if (fabs(coarse) <= known_to[0] + known_to[1] || fabs(fine) <= known_to[1] + known_to[2])
    return without_order(CMP_TREND_unresolved, fmax(half_range(f), known_to[2]));
  const struct ratios r = {h[1] / h[2], h[0] / h[1], coarse / fine};
  if (r.change < 0) {
    if (r.change < -1) return without_order(CMP_TREND_oscillating, half_range(f));
    return without_order(CMP_TREND_diverging, NAN);
  }
  const double p = order_of(&r);
  if (!(p > 0)) return without_order(CMP_TREND_diverging, NAN);
  struct cmp_triple t = {.trend = CMP_TREND_monotone, .order = p};
  const double rest = -fine / expm1(p * log(r.fine)); /* from the finest value to the limit */
  t.limit = f[2] + rest;
  t.gci = f[2] != 0 ? CMP_GCI_SAFETY * fabs(rest / f[2]) : NAN;
  t.bar = CMP_GCI_SAFETY * fabs(fine) / expm1(fmin(p, CMP_BAR_ORDER) * log(r.fine));
  return t;
}

double cmp_error_order(const double h[2], const double e[2]) {
  if (!(fabs(e[0]) > 0) || !(fabs(e[1]) > 0) || !isfinite(e[0]) || !isfinite(e[1])) return NAN;
  return log(fabs(e[0] / e[1])) / log(h[0] / h[1]);
}

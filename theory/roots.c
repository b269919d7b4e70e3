/* The dispersion relation of decaying modes as the crossing of two curves (T, section 2.4.1,
 * figures 2-4 to 2-6): with y = (mu^2 - delta^2)/kappa^2, a = kappa/delta and eps = delta H,
 *     f1 = (1 + y)/(1 - y) = f2 = s coth(eps s),   s = mu/delta = sqrt(1 + a^2 y),  -1/a^2 <= y
 * < 1. T's laws: shallow water y1 = 1 - 2 eps (2.44), deep water y1 = 1 - 2/a (2.47) and f2(y0) =
 * 1/eps (2.43, 2.46). A second root, mu = delta, appears for eps >= eps_o = (a^2 + 1)/(a^2 - 1);
 * the requirement after (2.47) prints eps_o < ... for eps < eps_o. */
#include <math.h>

#include "common/base/root.h"
#include "theory/theory.h"

struct roots {
  double a, eps, from, to;
  int points;
};

static const struct param params[] = {
    THEORY_REAL(roots, a, PARAM_ABOVE_0, 1e6, "5, 10, 100", "kappa/delta"),
    THEORY_REAL(roots, eps, PARAM_ABOVE_0, 1e4, "0.001", "delta H"),
    THEORY_REAL(roots, from, -1, 0.999999, "-1",
                "least y, if curves do not begin later, at -1/a^2"),
    THEORY_REAL(roots, to, -1, 0.999999, "0.9999", "largest y, below 1"),
    THEORY_POINTS(roots),
};
static const struct theory_column columns[] = {
    {.key = "y", .unit = "1", .label = "y = (μ^2 − δ^2)/κ^2", .help = "square of the wavenumber"},
    {.key = "f1",
     .unit = "1",
     .label = "f_1 = (1 + y)/(1 − y)",
     .axis = "f_1, f_2",
     .help = "left side",
     .log = true,
     .same = true},
    {.key = "f2", .unit = "1", .label = "f_2 = s coth(ε s)", .help = "right side"},
    {.key = "root",
     .unit = "1",
     .label = "root",
     .help = "where both are equal; none in other rows",
     .points = true},
};
enum { LARGE, SMALL, COUNT, MU_LARGE, MU_SMALL, SECOND_FROM, SHALLOW, DEEP, FLATNESS };
static const struct theory_value values[] = {
    [LARGE] = {"y1", "1", "the root near 1"},
    [SMALL] = {"y0", "1", "the second root, near 0"},
    [COUNT] = {"roots", "1", "how many there are"},
    [MU_LARGE] = {"mu1", "delta", "vertical wavenumber of y1"},
    [MU_SMALL] = {"mu0", "delta", "vertical wavenumber of y0"},
    [SECOND_FROM] = {"eps_o", "1", "eps from which there are two"},
    [SHALLOW] = {"y1_shallow", "1",
                 "law of shallow water, 1 - (2 eps/(1 + eps)) (1 - (eps a)^2/3)"},
    [DEEP] = {"y1_deep", "1", "law of deep water, 1 - 2/a"},
    [FLATNESS] = {"flatness", "1", "largest |eps f2 - 1|: 0 where (2.43) holds"},
};

static double f2(const struct roots *p, double y) {
  double s = sqrt(fmax(1 + p->a * p->a * y, 0)), x = p->eps * s;
  return x < 1e-4 ? (1 + x * x / 3) / p->eps : s / tanh(x);
}

static double difference(double y, const void *with) { /* (1 - y) (f1 - f2): no pole at y = 1 */
  return 1 + y - (1 - y) * f2(with, y);
}

/* f1 - f2 is positive at y = 1. Where it is so at the least y, too, f1 is convex and f2 concave,
 * and they cross twice: between lies a y with f1 < f2, which a scan looks for. */
static void find(const struct roots *p, double *value) {
  enum { SCAN = 4096 };
  double low = -1 / (p->a * p->a), between = low;
  for (int i = 1; i < SCAN && difference(between, p) >= 0; i++)
    between = low + (1 - low) * i / SCAN;
  bool one = difference(low, p) < 0, two = !one && difference(between, p) < 0;
  value[LARGE] = one || two ? root_between(difference, p, between, 1) : NAN;
  value[SMALL] = two ? root_between(difference, p, low, between) : NAN;
  value[COUNT] = two ? 2 : one;
  value[MU_LARGE] = sqrt(1 + p->a * p->a * value[LARGE]);
  value[MU_SMALL] = sqrt(1 + p->a * p->a * value[SMALL]);
}

static enum status row_add(const struct roots *p, double y, bool root, struct theory_curve *curve) {
  double f1 = (1 + y) / (1 - y);
  return THEORY_ROW(curve, y, f1, f2(p, y), root ? f1 : NAN);
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct roots *p = with;
  double *v = curve->value, a2 = p->a * p->a, least = -1 / a2;
  double from = fmax(p->from, least);
  CHECK(from < p->to, ERR_USAGE, "from: found %g; allowed: less than to = %g", from, p->to);
  find(p, v);
  double last = -INFINITY;
  for (int i = 0; i < p->points; i++) { /* closer towards y = 1, where f1 has its pole */
    double y = 1 - exp(theory_between(log1p(-from), log1p(-p->to), i, p->points));
    for (int k = SMALL; k >= LARGE; k--)
      if (v[k] >= from && v[k] > last && v[k] <= y) TRY(row_add(p, v[k], true, curve));
    TRY(row_add(p, y, false, curve));
    last = y;
  }
  v[SECOND_FROM] = a2 > 1 ? (a2 + 1) / (a2 - 1) : NAN;
  if (p->eps * p->a < 1)
    v[SHALLOW] = 1 - 2 * p->eps / (1 + p->eps) * (1 - p->eps * p->eps * a2 / 3);
  v[DEEP] = 1 - 2 / p->a;
  v[FLATNESS] = fmax(fabs(p->eps * f2(p, 1) - 1), fabs(p->eps * f2(p, least) - 1));
  return OK;
}

const struct theory_topic theory_roots = {
    .name = "roots",
    .help = "graphic roots of the dispersion relation of decaying modes (T, eqs 2.39-2.47, figures "
            "2-4 to 2-6)",
    .params_size = sizeof(struct roots),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

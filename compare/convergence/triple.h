/* What three resolutions say of a number's way to its limit: f = limit + C h^p. Roache, J. Fluids
 * Eng. 116, 405 (1994); for ratios that differ Celik et al., J. Fluids Eng. 130, 078001 (2008),
 * whose p is the one found here, by bisection instead of iteration. */
#pragma once

/* X(name, help): how the three values follow each other. Only the first has an order. */
#define CMP_TRENDS(X)                                                                              \
  X(monotone, "both differences have one sign, and the finer one is smaller than a limit allows")  \
  X(oscillating, "the differences have opposite signs, and the finer one is smaller")              \
  X(diverging, "the finer difference is too large for a limit")                                    \
  X(constant, "all three are the same but for rounding")                                           \
  X(stalled, "the finer two are the same but for rounding, the coarsest is another")               \
  X(unresolved, "a difference is no larger than what its two values are known to")

enum cmp_trend {
#define X(name, help) CMP_TREND_##name,
  CMP_TRENDS(X)
#undef X
      CMP_N_TRENDS
};
extern const char *const cmp_trend_names[CMP_N_TRENDS];

/* The factor of safety of the grid convergence index with three resolutions (Roache), and the order
 * that an error bar relies on at most: higher ones are as often values that lie close together by
 * chance. */
#define CMP_GCI_SAFETY 1.25
#define CMP_BAR_ORDER  2.0

struct cmp_triple {
  enum cmp_trend trend;
  double order; /* p; NaN where there is none to claim, as the next two */
  double limit; /* Richardson's value at h = 0 */
  double gci;   /* CMP_GCI_SAFETY |f1 - f2| / ((h2/h1)^p - 1) over |f1|, the finest value; NaN: that
                   is 0 */
  double bar;   /* of the finest value: the same not divided, with p at most CMP_BAR_ORDER; of
                   oscillating ones half their range (Stern et al., J. Fluids Eng. 123, 793, 2001);
                   of what is unresolved that, or what the finest is known to, if more; NaN:
                   none */
};

/* h: spacings, the coarsest first, all different; f: finite values there; known_to: how far they
 * may be off by the way they were found, 0 where that is exact. */
struct cmp_triple cmp_triple_of(const double h[3], const double f[3], const double known_to[3]);

/* ln(e0/e1)/ln(h0/h1) of two errors; NaN where one is 0 or not known. */
double cmp_error_order(const double h[2], const double e[2]);

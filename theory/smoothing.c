/* How often velocity and density must be smoothed so that sound in a column at rest does not grow
 * (T, eqs 4.51-4.55, figure 4-18): every n steps an application multiplies waves by S(kh) = (2 +
 * cos kh)/3, and a step of RK4 by lambda:
 *
 *     period   n < -ln S/ln |lambda|. Growth does not vanish with kh, so that n does: the least
 *              one is that of waves shorter than kh = `from`
 *     printed  1/((|lambda| - 1) (1 - (kh)^2/6)) (4.55), whose 1 should be (kh)^2/6: as it stands
 *              waves could grow that smoothing does not touch; negative for kh > sqrt(6)
 *
 * with |lambda| of
 *
 *     printed    the matrix (2.273); `reading`: its first entry literally, or with 8/3 for 1/3
 *     equations  RK4 of (2.270)-(2.272): no growth, no period
 *     corrected  the same with P = c^2 (rho - rho_f): theta = 2 delta |y|, theta' = -2 delta; the
 *                growth of a step is at most mu_c g h/c^2 */
#include <math.h>

#include "theory/column.h"
#include "theory/theory.h"

static const char *const layer_names[] = {"printed", "equations", "corrected", NULL};
static const char *const layer_helps[] = {"the matrix (2.273)",
                                          "RK4 of the printed equations (2.270)-(2.272)",
                                          "RK4 of the equations without background pressure"};
enum { PRINTED, EQUATIONS, CORRECTED };

struct smoothing {
  double courant, beta, spacing, depth, from;
  int layer, reading, points;
};

static const struct param params[] = {
    THEORY_CHOICE(smoothing, layer, layer_names, layer_helps, "printed", "which equations"),
    THEORY_CHOICE(smoothing, reading, theory_reading_names, theory_reading_helps, "first",
                  "how the printed matrix is read"),
    THEORY_REAL(smoothing, courant, PARAM_ABOVE_0, 4, "1, 0.8, 0.5", "mu_c = c dt/h"),
    THEORY_REAL(smoothing, beta, PARAM_ABOVE_0, 1e6, "118.9263",
                "c^2/(g H), of corrected: T, 4.3.8"),
    THEORY_REAL(smoothing, spacing, PARAM_ABOVE_0, 1, "0.0416666666666667", "h/H, of corrected"),
    THEORY_REAL(smoothing, depth, 0, 1, "0.5", "|y|/H of the particles, of corrected"),
    THEORY_REAL(smoothing, from, PARAM_ABOVE_0, 3, "0.5",
                "k h of the longest wave of period_least"),
    THEORY_POINTS(smoothing),
};
static const struct theory_column columns[] = {
    {.key = "kh", .unit = "1", .label = "k h", .help = "wavenumber times h"},
    {.key = "printed",
     .unit = "1",
     .label = "n of (4.55)",
     .axis = "steps between smoothings",
     .log = true,
     .help = "steps between two applications, (4.55); none where it does not apply"},
    {.key = "period",
     .unit = "1",
     .label = "n, exact",
     .help = "most steps between two applications that hold growth; none without growth"},
    {.key = "growth",
     .unit = "1",
     .label = "|λ| − 1",
     .axis = "|λ| − 1 of a step",
     .level = "0",
     .panel = 1,
     .help = "growth in a step"},
    {.key = "sound",
     .unit = "1",
     .label = "|λ| − 1, sound",
     .help = "the same of the eigenvalue farthest from 1, which may decay",
     .panel = 1,
     .undrawn = true},
    {.key = "frequency",
     .unit = "c/h",
     .label = "frequency",
     .help = "largest eigenvalue of the equations, not of a step; none of a printed matrix",
     .panel = 1,
     .undrawn = true},
    {.key = "still",
     .unit = "c/h",
     .label = "least eigenvalue",
     .help = "magnitude of the least one, likewise",
     .panel = 1,
     .undrawn = true},
};
enum { LEAST, LEAST_AT, PERIOD, PERIOD_AT, WORST, WORST_AT };
static const struct theory_value values[] = {
    [LEAST] = {"printed_least", "1", "least n of (4.55)"},
    [LEAST_AT] = {"printed_kh", "1", "k h of that"},
    [PERIOD] = {"period_least", "1", "least exact n for k h from `from` on"},
    [PERIOD_AT] = {"period_kh", "1", "k h of that"},
    [WORST] = {"growth_most", "1", "largest growth in a step"},
    [WORST_AT] = {"kh_most", "1", "k h of that"},
};

/* theta and theta' h of the equations. */
struct rest {
  double theta, slope;
};

static struct rest rest_of(const struct smoothing *p) {
  const double delta = 1 / (2 * p->beta); /* H */
  if (p->layer == EQUATIONS) return (struct rest){1, 0};
  return (struct rest){2 * delta * p->depth, -2 * delta * p->spacing};
}

static struct theory_matrix step_of(const struct smoothing *p, double kh) {
  const struct rest rest = rest_of(p);
  if (p->layer == PRINTED)
    return theory_column_printed(p->courant, kh, (enum theory_reading)p->reading);
  return theory_column_step(p->courant, kh, rest.theta, rest.slope);
}

/* The extreme so far; NaN at first. */
static void note(double *extreme, double *at, double value, double kh, double sign) {
  if (isnan(value) || sign * value <= sign * *extreme) return;
  *extreme = value;
  *at = kh;
}

/* What there is at one wavenumber; NaN: none. */
struct at {
  double growth, printed, period, sound, frequency, still;
};

static enum status measure_equations(const struct smoothing *p, double kh, struct at *at) {
  const struct rest rest = rest_of(p);
  const struct theory_matrix z = theory_column_rates(p->courant, kh, rest.theta, rest.slope);
  double complex rate[THEORY_LARGEST];
  TRY(theory_eigenvalues(&z, rate));
  at->frequency = 0;
  at->still = INFINITY;
  for (int i = 0; i < z.n; i++) {
    at->frequency = fmax(at->frequency, cabs(rate[i]) / p->courant);
    at->still = fmin(at->still, cabs(rate[i]) / p->courant);
  }
  return OK;
}

static enum status measure(const struct smoothing *p, double kh, struct at *at) {
  const double rounding = 1e-12;
  double radius = 0, far = -1;
  double complex lambda[THEORY_LARGEST];
  const struct theory_matrix m = step_of(p, kh);
  TRY(theory_eigenvalues(&m, lambda));
  *at = (struct at){NAN, NAN, NAN, NAN, NAN, NAN};
  for (int i = 0; i < m.n; i++) {
    radius = fmax(radius, cabs(lambda[i]));
    if (cabs(lambda[i] - 1) <= far) continue;
    far = cabs(lambda[i] - 1);
    at->sound = cabs(lambda[i]) - 1;
  }
  at->growth = radius - 1;
  if (p->layer != PRINTED) TRY(measure_equations(p, kh, at));
  if (radius <= 1 + rounding) return OK;
  at->period = -log((2 + cos(kh)) / 3) / log(radius);
  if (kh < 2.4) /* beyond: towards its pole at sqrt(6), then negative */
    at->printed = 1 / ((radius - 1) * (1 - kh * kh / 6));
  return OK;
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct smoothing *p = with;
  double *v = curve->value;
  struct at at;
  for (int i = 1; i <= p->points; i++) {
    double kh = M_PI * i / p->points;
    TRY(measure(p, kh, &at));
    TRY(THEORY_ROW(curve, kh, at.printed, at.period, at.growth, at.sound, at.frequency, at.still));
    note(&v[LEAST], &v[LEAST_AT], at.printed, kh, -1);
    if (kh > p->from) note(&v[PERIOD], &v[PERIOD_AT], at.period, kh, -1);
    note(&v[WORST], &v[WORST_AT], at.growth, kh, 1);
  }
  TRY(measure(p, p->from, &at));
  note(&v[PERIOD], &v[PERIOD_AT], at.period, p->from, -1);
  return OK;
}

const struct theory_topic theory_smoothing = {
    .name = "smoothing",
    .help = "steps between two smoothings that hold the growth of sound (T, eq. 4.55, figure 4-18)",
    .params_size = sizeof(struct smoothing),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

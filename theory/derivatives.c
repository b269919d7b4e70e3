/* Fits to neighbours, on particles spaced dx and disturbed by up to `disturbance` dx either way (T,
 * section 3.3.1, table 3.2):
 *
 *     mls-value   value of the line c + a.x fitted with the weight of a hat (3.3)-(3.8)
 *     mls         its slope (3.9)-(3.12), (4.13)
 *     mueller     slope of the line through the particle's own value (3.13), (3.14)
 *
 * Each finds f = sin(1.3 x + 0.4) cos(0.9 y - 0.2) or f_x at 256 places; the rows have the rms of
 * its errors against h = dx, the same disturbances at each, and `order` is the slope of its
 * logarithm over the three finest. Moments of particles on a line are singular: `line` is the least
 * eigenvalue of the fit's matrix there over its largest; and `nearly` what the fit finds of what is
 * there when they are 1e-6 dx beside it, to either side in turn. Lengths in units of f. */
#include <math.h>

#include "theory/theory.h"

static const char *const method_names[] = {"mls-value", "mls", "mueller", NULL};
static const char *const method_helps[] = {"value of a fitted plane", "slope of a fitted plane",
                                           "slope of a plane through the particle's own value"};
enum { MLS_VALUE, MLS, MUELLER };
static const char *const weight_names[] = {"unit", "hat", NULL};
static const char *const weight_helps[] = {"1 within the radius", "1 - |x|/radius"};

struct derivatives {
  double disturbance, radius;
  int method, weight, levels;
};

static const struct param params[] = {
    THEORY_CHOICE(derivatives, method, method_names, method_helps, "mls-value, mls, mueller",
                  "what is fitted"),
    THEORY_REAL(derivatives, disturbance, 0, 0.3, "0, 0.2", "of the lattice, dx"),
    THEORY_REAL(derivatives, radius, 1.2, 4, "2", "of the neighbours, dx"),
    THEORY_CHOICE(derivatives, weight, weight_names, weight_helps, "hat", "of the neighbours"),
    THEORY_INT(derivatives, levels, 3, 12, "6", "spacings: 1/8, 1/16, ..."),
};
static const struct theory_column columns[] = {
    {.key = "spacing", .unit = "1", .label = "Δx", .help = "spacing", .log = true},
    {.key = "error",
     .unit = "1",
     .label = "error",
     .help = "rms of the errors",
     .log = true,
     .points = true},
};
enum { ORDER, LINE, NEARLY };
static const struct theory_value values[] = {
    [ORDER] = {"order", "1", "of the error in dx, over the three finest spacings"},
    [LINE] = {"line", "1", "least over largest eigenvalue of the fit's matrix on a line"},
    [NEARLY] = {"nearly", "1", "by the fit 1e-6 dx beside that line, over what is there"},
};

static double f_of(double x, double y) {
  return sin(1.3 * x + 0.4) * cos(0.9 * y - 0.2);
}
static double f_x_of(double x, double y) {
  return 1.3 * cos(1.3 * x + 0.4) * cos(0.9 * y - 0.2);
}

/* In [-1, 1], the same always (a linear congruential generator, Knuth's). */
static double random_next(unsigned long long *state) {
  *state = *state * 6364136223846793005ULL + 1442695040888963407ULL;
  return (double)(*state >> 11) / 4503599627370496.0 - 1;
}

/* Moments of the weights: of 1, x, y, and of f; lengths in dx. */
struct moments {
  double m[3][3], b[3];
};

static void take(struct moments *s, double w, double x, double y, double f) {
  double p[3] = {1, x, y};
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) s->m[i][j] += w * p[i] * p[j];
    s->b[i] += w * p[i] * f;
  }
}

static double weight(const struct derivatives *p, double x, double y) {
  double q = hypot(x, y) / p->radius;
  return q >= 1 ? 0 : p->weight ? 1 - q : 1;
}

/* The solution by Cramer's rule of the fit; of Mueller's, of the slopes alone. */
static double determinant(const double m[3][3]) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

static double solve(const struct derivatives *p, const struct moments *s) {
  if (p->method == MUELLER)
    return (s->b[1] * s->m[2][2] - s->b[2] * s->m[1][2]) /
           (s->m[1][1] * s->m[2][2] - s->m[1][2] * s->m[2][1]);
  struct moments with = *s;
  for (int i = 0; i < 3; i++) with.m[i][p->method == MLS] = s->b[i];
  return determinant(with.m) / determinant(s->m);
}

/* The error at (X, Y) of the particle there, its neighbours disturbed at random. */
static double error_at(const struct derivatives *p, double dx, double X, double Y,
                       unsigned long long *state) {
  enum { REACH = 5 };
  struct moments s = {0};
  double own = p->method == MUELLER ? f_of(X, Y) : 0;
  for (int i = -REACH; i <= REACH; i++)
    for (int j = -REACH; j <= REACH; j++) {
      double x = i + p->disturbance * random_next(state);
      double y = j + p->disturbance * random_next(state);
      if (!i && !j) x = y = 0;
      take(&s, weight(p, x, y), x, y, f_of(X + x * dx, Y + y * dx) - own);
    }
  double found = solve(p, &s);
  return p->method == MLS_VALUE ? found - f_of(X, Y) : found / dx - f_x_of(X, Y);
}

static double error_of(const struct derivatives *p, double dx) {
  enum { PLACES = 256 };
  unsigned long long state = 1;
  double sum = 0;
  for (int n = 0; n < PLACES; n++) {
    double X = random_next(&state), Y = random_next(&state);
    sum += pow(error_at(p, dx, X, Y, &state), 2);
  }
  return sqrt(sum / PLACES);
}

/* Eigenvalues of [a b; b c] of the slopes, less the mean where a mean is fitted: on the line y =
 * x/2 the least is 0 but for rounding. */
static double singular(const struct derivatives *p) {
  struct moments s = {0};
  for (int i = -4; i <= 4; i++) take(&s, weight(p, i, 0.5 * i), i, 0.5 * i, 0);
  double mean = p->method == MUELLER ? 0 : 1 / s.m[0][0];
  double a = s.m[1][1] - mean * s.m[0][1] * s.m[0][1];
  double b = s.m[1][2] - mean * s.m[0][1] * s.m[0][2];
  double c = s.m[2][2] - mean * s.m[0][2] * s.m[0][2];
  double half = (a + c) / 2, spread = hypot((a - c) / 2, b);
  return (half - spread) / (half + spread);
}

/* What the fit finds of what is there from neighbours beside that line: where they do not span the
 * plane, the curvature of f, over their distance from the line, passes for a slope across it. */
static double found_beside_a_line(const struct derivatives *p) {
  static const double dx = 1. / 64, X = 0.3, Y = 0.2, beside = 1e-6;
  struct moments s = {0};
  const double own = p->method == MUELLER ? f_of(X, Y) : 0;
  for (int i = -4; i <= 4; i++) {
    const double away = i % 2 ? beside : -beside, x = i - 0.5 * away, y = 0.5 * i + away;
    take(&s, weight(p, x, y), x, y, f_of(X + x * dx, Y + y * dx) - own);
  }
  const double found = solve(p, &s);
  return p->method == MLS_VALUE ? found / f_of(X, Y) : found / dx / f_x_of(X, Y);
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct derivatives *p = with;
  double error[3] = {NAN, NAN, NAN};
  for (int k = 0; k < p->levels; k++) {
    double dx = ldexp(1, -3 - k);
    error[0] = error[1];
    error[1] = error[2];
    error[2] = error_of(p, dx);
    TRY(THEORY_ROW(curve, dx, error[2]));
  }
  curve->value[ORDER] = log2(error[0] / error[2]) / 2;
  curve->value[LINE] = singular(p);
  curve->value[NEARLY] = found_beside_a_line(p);
  return OK;
}

const struct theory_topic theory_derivatives = {
    .name = "derivatives",
    .help = "errors of MLS values, MLS slopes and Mueller's slopes on lattices, in order or "
            "disturbed (T, eqs 3.3-3.15, 4.13, table 3.2)",
    .params_size = sizeof(struct derivatives),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

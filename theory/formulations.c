/* The linearised schemes on a line of particles (T, table 3.1): perturbations e^(kappa x) obey
 *     direct density   y' = v, v' = c^2 F^2 y        advanced   y' = v, v' = -c^2 F r, r' = -F v
 * with F = sum_b dx W'(x_a - x_b) e^(kappa (x_b - x_a)), i sin(kh)/h and sinh(mu h)/h where dx = h.
 * Both have the eigenvalues +- sqrt(c^2 F^2): waves are neutral, decaying modes grow. T's (3.31) to
 * (3.33) have a factor h too many. The values apply the sum to the particles of a line, one by one:
 * a ring of 64 with cosines, and the middle of 64 with e^(mu x). */
#include <math.h>

#include "theory/linear.h"
#include "theory/spline.h"
#include "theory/theory.h"

struct formulations {
  double ratio, to;
  int points;
};

static const struct param params[] = {
    THEORY_REAL(formulations, ratio, 0.5, 10, "1", "h/dx"),
    THEORY_REAL(formulations, to, PARAM_ABOVE_0, 30, "3.141592653589793", "largest kh and mu h"),
    THEORY_POINTS(formulations),
};
static const struct theory_column columns[] = {
    {.key = "kh", .unit = "1", .label = "k h or μ h", .help = "wavenumber times h"},
    {.key = "symbol_oscillating",
     .unit = "1/h",
     .label = "F/i, waves",
     .axis = "F h",
     .help = "F/i for e^(i k x)"},
    {.key = "symbol_decaying", .unit = "1/h", .label = "F, decaying", .help = "F for e^(mu x)"},
    {.key = "direct",
     .unit = "c/h",
     .label = "frequency, waves",
     .axis = "rate h/c",
     .help = "largest imaginary part of an eigenvalue, waves",
     .panel = 1},
    {.key = "advanced",
     .unit = "c/h",
     .label = "frequency, advanced",
     .help = "the same",
     .panel = 1,
     .undrawn = true},
    {.key = "direct_growth",
     .unit = "c/h",
     .label = "growth, decaying",
     .help = "largest real part of an eigenvalue, decaying modes",
     .panel = 1},
    {.key = "advanced_growth",
     .unit = "c/h",
     .label = "growth, advanced",
     .help = "the same",
     .panel = 1,
     .undrawn = true},
    {.key = "advanced_still",
     .unit = "c/h",
     .label = "least, advanced",
     .help = "magnitude of its least eigenvalue, of waves and decaying modes",
     .panel = 1,
     .undrawn = true},
};

enum { LINE = 64 };
enum { WAVES_OFF, DECAYING_OFF };
static const struct theory_value values[] = {
    [WAVES_OFF] = {"ring_off", "1/h",
                   "largest difference of the sum over a ring of particles from F, waves"},
    [DECAYING_OFF] = {"line_off", "1",
                      "of the sum over a line of particles from F, decaying, over F"},
};

/* h sum_b dx W'(x_a - x_b) f_b over particles spaced dx = h/ratio; a ring, or a line. */
static double derivative(const double *f, int a, double ratio, bool ring) {
  double sum = 0;
  int reach = (int)(2 * ratio);
  for (int b = a - reach; b <= a + reach; b++)
    sum += theory_spline_slope((a - b) / ratio) * f[ring ? (b + LINE) % LINE : b] / ratio;
  return sum;
}

static double ring_off(double ratio) {
  double most = 0, f[LINE];
  for (int m = 0; m <= LINE / 2; m++) {
    double step = 2 * M_PI * m / LINE; /* k dx */
    double F = cimag(theory_spline_slope_symbol(I * step * ratio, ratio));
    for (int b = 0; b < LINE; b++) f[b] = cos(step * b);
    for (int a = 0; a < LINE; a++)
      most = fmax(most, fabs(derivative(f, a, ratio, true) + F * sin(step * a)));
  }
  return most;
}

static double line_off(double ratio) {
  double most = 0, f[LINE];
  int reach = (int)(2 * ratio);
  for (int m = 1; m <= 8; m++) {
    double step = M_PI * m / 8 / ratio; /* mu dx */
    double F = creal(theory_spline_slope_symbol(step * ratio, ratio));
    for (int b = 0; b < LINE; b++) f[b] = exp(step * (b - LINE / 2));
    for (int a = reach; a < LINE - reach; a++)
      most = fmax(most, fabs(derivative(f, a, ratio, false) / (F * f[a]) - 1));
  }
  return most;
}

/* The largest real and imaginary parts and the least magnitude, in c/h. */
static enum status rates(double complex f, bool advanced, double *growth, double *frequency,
                         double *least) {
  struct theory_matrix direct = {2, {{0, 1}, {f * f, 0}}};
  struct theory_matrix three = {3, {{0, 1, 0}, {0, 0, -f}, {0, -f, 0}}};
  double complex lambda[THEORY_LARGEST];
  const struct theory_matrix *m = advanced ? &three : &direct;
  TRY(theory_eigenvalues(m, lambda));
  *growth = *frequency = 0;
  *least = INFINITY;
  for (int i = 0; i < m->n; i++) {
    *least = fmin(*least, cabs(lambda[i]));
    *growth = fmax(*growth, creal(lambda[i]));
    *frequency = fmax(*frequency, cimag(lambda[i]));
  }
  return OK;
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct formulations *p = with;
  for (int i = 0; i < p->points; i++) {
    double k = theory_between(0, p->to, i, p->points), unused, frequency[2], growth[2], still[2];
    double complex wave = theory_spline_slope_symbol(I * k, p->ratio);
    double complex decaying = theory_spline_slope_symbol(k, p->ratio);
    for (int advanced = 0; advanced < 2; advanced++) {
      TRY(rates(wave, advanced, &unused, &frequency[advanced], &still[0]));
      TRY(rates(decaying, advanced, &growth[advanced], &unused, &still[1]));
    }
    TRY(THEORY_ROW(curve, k, cimag(wave), creal(decaying), frequency[0], frequency[1], growth[0],
                   growth[1], fmax(still[0], still[1])));
  }
  curve->value[WAVES_OFF] = ring_off(p->ratio);
  curve->value[DECAYING_OFF] = line_off(p->ratio);
  return OK;
}

const struct theory_topic theory_formulations = {
    .name = "formulations",
    .help = "symbols and eigenvalues of the scheme with direct and advanced density (T, table 3.1)",
    .params_size = sizeof(struct formulations),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

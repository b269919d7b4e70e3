/* A noisy profile, what a modal filter leaves of it, and what it leaves after the mean over x was
 * taken off (T, figures 2-22 and 2-23, bottom): velocities u = i kappa (psi_-1 + psi_n) e^(i kappa
 * x) and v = (psi_-1' + psi_n') e^(i kappa x) + f_u', with f_u = e^(2 kappa y), uniform in x, of
 * the vertical velocity alone (T says only that its wavenumber is above kappa). The mean over a
 * wavelength, or over two or more columns evenly spaced in it, is f_u' itself: waves have none. The
 * filter takes the column x = 0. The plain one finds 1 + F0 + leak, or 1 + F0: leak = mu/(kappa +
 * mu) (1 - e^(-(kappa + mu) H))/(1 - e^(-2 kappa H)), mu = 2 kappa. Units: g = H = 1. */
#include <math.h>

#include "theory/projection.h"
#include "theory/theory.h"

struct filter {
  double beta, kappa;
  int filter, mode, points;
};

static const struct param params[] = {
    THEORY_CHOICE(filter, filter, theory_filter_names, theory_filter_helps, "plain", "the filter"),
    THEORY_REAL(filter, kappa, PARAM_ABOVE_0, 1e3, "6.283185307179586",
                "horizontal wavenumber times H"),
    THEORY_REAL(filter, beta, PARAM_ABOVE_0, 1e6, "10", "c^2/(g H)"),
    THEORY_INT(filter, mode, 0, 200, "20", "n of the acoustic mode"),
    THEORY_POINTS(filter),
};
static const struct theory_column columns[] = {
    {.key = "y", .unit = "H", .label = "y/H", .help = "height above the surface"},
    {.key = "noisy",
     .unit = "1",
     .label = "noisy",
     .axis = "f",
     .level = "0",
     .help = "psi_-1 + psi_n + f_u"},
    {.key = "filtered", .unit = "1", .label = "filtered", .help = "what the filter finds"},
    {.key = "reduced",
     .unit = "1",
     .label = "filtered without f_u",
     .help = "after the mean over x was taken off"},
    {.key = "wave", .unit = "1", .label = "ψ_{−1}", .help = "what it should find"},
};
enum { AMPLITUDE, REDUCED };
static const struct theory_value values[] = {
    [AMPLITUDE] = {"amplitude", "1", "found in the noisy profile; 1 would be right"},
    [REDUCED] = {"amplitude_reduced", "1", "found after the mean over x was taken off"},
};

struct field {
  const struct filter *p;
  const struct theory_mode *wave, *sound;
  bool reduced; /* by the mean over x */
};

/* Of u, over i kappa. */
static double psi(double y, const void *with) {
  const struct field *f = with;
  return theory_mode_psi(f->wave, y) + theory_mode_psi(f->sound, y);
}

/* v. */
static double slope(double y, const void *with) {
  const struct field *f = with;
  const double kappa = f->p->kappa, mean = 2 * kappa * exp(2 * kappa * y);
  return theory_mode_slope(f->wave, y) + theory_mode_slope(f->sound, y) + (f->reduced ? 0 : mean);
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct filter *p = with;
  enum theory_filter filter = (enum theory_filter)p->filter;
  enum theory_profile profile = filter == THEORY_FILTER_EXACT ? THEORY_EXACT : THEORY_DEEP;
  struct theory_mode wave, sound;
  TRY(theory_mode_find(p->beta, p->kappa, -1, profile, &wave));
  TRY(theory_mode_find(p->beta, p->kappa, p->mode, profile, &sound));
  struct field field = {p, &wave, &sound, false};
  double amplitude = theory_filter_apply(filter, &wave, psi, slope, &field);
  field.reduced = true;
  double reduced = theory_filter_apply(filter, &wave, psi, slope, &field);
  for (int i = 0; i < p->points; i++) {
    double y = theory_between(-1, 0, i, p->points), right = theory_mode_psi(&wave, y);
    double noisy = right + theory_mode_psi(&sound, y) + exp(2 * p->kappa * y);
    TRY(THEORY_ROW(curve, y, noisy, amplitude * right, reduced * right, right));
  }
  curve->value[AMPLITUDE] = amplitude;
  curve->value[REDUCED] = reduced;
  return OK;
}

const struct theory_topic theory_filter = {
    .name = "filter",
    .help = "a noisy profile before and after a modal filter (T, eq. 2.86, figures 2-22 and 2-23)",
    .params_size = sizeof(struct filter),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

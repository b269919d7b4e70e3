/* Growth of disturbances in water at rest between a bed and a free surface, by the particle
 * solver's own rates, linearised about the start of a run, or about rows that have settled
 * (sph/theory/column.h): T, section 2.6.2.2 and figures 2-25 to 2-32, which blame disturbances that
 * decay with the depth, e^(mu y).
 *
 * Wavenumbers are the m-th of a tank of 2 (points - 1) columns, from 0, where nothing varies along
 * it, to pi/dx, where every other column moves the other way. Units: g = H = 1. */
#include "sph/theory/column.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/case/case.h"
#include "sph/domain/fitted.h"
#include "sph/pair/derivative.h"
#include "sph/pair/diffusion.h"
#include "sph/solver.h"
#include "theory/kernels.h"
#include "theory/theory.h"

struct spectrum {
  int kernel, derivative, momentum, continuity, free_surface, diffusion, walls, at;
  int rows, points;
  double beta, ratio, radius, alpha;
};

/* Those that move with the water; fixed particles add fields or fits of their own. */
static const char *const walls[] = {"mirror-exponential", "mirror", "mirror-reference",
                                    "mirror-plain", NULL};

enum { START, SETTLED };
static const char *const at[] = {[START] = "start", [SETTLED] = "settled", NULL};

static const struct param params[] = {
    THEORY_CHOICE(spectrum, momentum, theory_momentum_names, NULL, "mass",
                  "form of the pressure force"),
    THEORY_CHOICE(spectrum, continuity, theory_continuity_names, NULL, "absolute, mass",
                  "form of the continuity equation"),
    THEORY_CHOICE(spectrum, derivative, theory_derivative_names, NULL, "kernel",
                  "how gradients and divergences are taken"),
    THEORY_REAL(spectrum, radius, 1, 3, "1.5", "of mls and mueller, in h"),
    THEORY_CHOICE(spectrum, free_surface, theory_free_surface_names, NULL, "natural",
                  "natural: first row half a spacing below it; others: on it, with p = 0 or not"),
    THEORY_CHOICE(spectrum, walls, walls, NULL, "mirror-exponential", "images below the bed"),
    THEORY_CHOICE(spectrum, kernel, theory_kernel_names, NULL, "tensor", "the kernel"),
    THEORY_REAL(spectrum, ratio, 0.8, 3, "1", "h/dx"),
    THEORY_CHOICE(spectrum, diffusion, theory_diffusion_names, NULL, "none",
                  "the diffusive term, of the strength that runs have by default"),
    THEORY_REAL(spectrum, alpha, 0, 1, "0", "artificial viscosity"),
    THEORY_CHOICE(spectrum, at, at, NULL, "start",
                  "start: of the rows as a run starts; settled: when they have come to rest"),
    THEORY_REAL(spectrum, beta, 1, 1e6, "40", "c0^2/(g H)"),
    THEORY_INT(spectrum, rows, 8, 200, "50", "H/dx"),
    THEORY_INT(spectrum, points, 2, 1000, "26", "wavenumbers"),
};
static const struct theory_column columns[] = {
    {.key = "k_dx", .unit = "1", .label = "k Δx", .help = "wavenumber times spacing"},
    {.key = "growth",
     .unit = "sqrt(g/H)",
     .label = "growth",
     .axis = "growth √(H/g)",
     .help = "largest real part of an eigenvalue"},
    {.key = "frequency",
     .unit = "sqrt(g/H)",
     .label = "its frequency",
     .help = "imaginary part of that",
     .undrawn = true},
};
/* Of water that is neutral there, sqrt(g/H): rows that shift are double zeros. */
static const double rounding = 0.01;

enum { MOST, MOST_AT, UNIFORM, MIDDLE, UNREST, SUNK, DELTA };
static const struct theory_value values[] = {
    [MOST] = {"growth_most", "sqrt(g/H)", "largest growth"},
    [MOST_AT] = {"k_dx_most", "1", "where"},
    [UNIFORM] = {"growth_uniform", "sqrt(g/H)",
                 "of what does not vary along the tank; up to 0.01: none, but for rounding"},
    [MIDDLE] = {"middle", "1",
                "of that, vertical velocity at half the depth over that of the first row"},
    [UNREST] = {"unrest", "g", "largest acceleration where rates are taken"},
    [SUNK] = {"sunk", "H", "how far the first row has sunk since the start"},
    [DELTA] = {"delta", "1", "strength of the diffusive term, which runs have by default"},
};

/* As wide as its rates reach, twice and more; higher than two supports. */
static enum status write_case(const struct spectrum *p, size_t room, char *text) {
  const double reach = ceil(3 * fmax(3, 4 * p->ratio)), dx = 1. / p->rows;
  const double width = (2 * reach + 3) * dx;
  const bool below = p->free_surface == SPH_FREE_SURFACE_natural;
  const enum sph_derivative d = (enum sph_derivative)p->derivative;
  char radius[60] = ""; /* refused where it does nothing */
  if (derivative_is_fit(d) && derivative_has_radius(d))
    snprintf(radius, sizeof radius, "derivative_radius: %.17g, ", p->radius);
  const int n = snprintf(
      text, room,
      "title: column\nfluid: {density: 1, gravity: 1}\nscales: {H: 1}\n"
      "tank: {walls: [[[0, 3], [0, 0], [%.17g, 0], [%.17g, 3]]], sides: periodic}\n"
      "water: {wave: {kind: pressed, strength: 1e-30, wavelength: %.17g, decay: 0.25, depth: "
      "%.17g}}\n"
      "time: {end: 1, every: 1}\nruns:\n"
      "  - {name: r, solver: sph, resolution: %d, c0: %.17g, precision: double, integrator: rk4, "
      "kernel: %s, h_over_dx: %.17g, derivative: %s, %smomentum: %s, "
      "continuity: %s, free_surface: %s, walls: %s, diffusion: %s, alpha: %.17g}\n",
      width, width, width, below ? 1 : 1 - dx / 2, p->rows, sqrt(p->beta),
      theory_kernel_names[p->kernel], p->ratio, theory_derivative_names[p->derivative], radius,
      theory_momentum_names[p->momentum], theory_continuity_names[p->continuity],
      theory_free_surface_names[p->free_surface], walls[p->walls],
      theory_diffusion_names[p->diffusion], p->alpha);
  CHECK(n > 0 && (size_t)n < room, ERR_USAGE, "the case of a column is too long");
  return OK;
}

/* What runs call otherwise. */
static const struct name {
  const char *key, *param;
} names[] = {{"derivative_radius", "radius"}, {"h_over_dx", "ratio"}};

static const struct name *name_at(const char *text) {
  for (size_t k = 0; k < sizeof names / sizeof *names; k++)
    if (!strncmp(text, names[k].key, strlen(names[k].key))) return &names[k];
  return NULL;
}

/* What a case file is refused for, said of the parameter. */
static enum status refuse(const struct problems *problems) {
  if (!problems->n) return status_raise(ERR_USAGE, "%s", status_message());
  const char *found = strstr(problems->text[0], "runs.r.");
  const char *from = found ? found + strlen("runs.r.") : problems->text[0];
  char text[1000] = "";
  for (size_t n = 0; *from && n + 40 < sizeof text;) {
    const struct name *name = name_at(from);
    if (name)
      n += (size_t)snprintf(text + n, sizeof text - n, "%s", name->param);
    else
      text[n++] = *from;
    from += name ? strlen(name->key) : 1;
  }
  return status_raise(ERR_USAGE, "%s", text);
}

static enum status start(const struct spectrum *p, struct case_file **c, struct sph **s) {
  static const struct solver *const solvers[] = {&sph_solver};
  const struct registry registry = {.solvers = solvers, .n_solvers = 1};
  struct problems problems = {0};
  char text[2000];
  TRY(write_case(p, sizeof text, text));
  enum status status = case_parse("column", text, &registry, &problems, c);
  if (status == ERR_INPUT) status = refuse(&problems);
  problems_destroy(&problems);
  TRY(status);
  return sph_create(*c, p->rows, (*c)->runs[0].options, s);
}

static size_t of_largest(const double *x, size_t n) {
  size_t most = 0;
  for (size_t k = 1; k < n; k++)
    if (x[k] > x[most]) most = k;
  return most;
}

static enum status fill(const struct spectrum *p, const struct sph_column *c,
                        struct theory_curve *curve) {
  const size_t rows = sph_column_rows(c), n = 5 * rows;
  double *re = NULL, *im = NULL, *v = NULL, *value = curve->value;
  enum status status = OK;
  ATTEMPT(array_create(&re, n, "eigenvalues"));
  ATTEMPT(array_create(&im, n, "eigenvalues"));
  ATTEMPT(array_create(&v, rows, "a mode"));
  for (int i = 0; i < p->points; i++) {
    const double turn = theory_between(0, M_PI, i, p->points);
    ATTEMPT(sph_column_spectrum(c, turn, re, im, i ? NULL : v));
    const size_t k = of_largest(re, n);
    ATTEMPT(THEORY_ROW(curve, turn, re[k], fabs(im[k])));
    if (i == 0) {
      value[UNIFORM] = re[k];
      if (re[k] > rounding) value[MIDDLE] = v[rows / 2] / v[rows - 1];
    }
    if (i > 0 && re[k] <= value[MOST]) continue;
    value[MOST] = re[k];
    value[MOST_AT] = turn;
  }
  value[UNREST] = sph_column_unrest(c);
done:
  free(re);
  free(im);
  free(v);
  return status;
}

static double surface_of(const struct sph *s) {
  double most = 0;
  for (size_t i = 0; i < s->f.n; i++) most = fmax(most, s->f.w.y[i]);
  return most;
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct spectrum *p = with;
  struct case_file *c = NULL;
  struct sph *s = NULL;
  struct sph_column *column = NULL;
  enum status status = OK;
  ATTEMPT(start(p, &c, &s));
  const double before = surface_of(s);
  if (p->at == SETTLED) ATTEMPT(sph_column_settle(s, 1e-6));
  ATTEMPT(sph_column_create(s, &column));
  curve->value[SUNK] = before - surface_of(s);
  if (p->diffusion != SPH_DIFFUSION_none) curve->value[DELTA] = s->scheme.delta;
  status = fill(p, column, curve);
done:
  sph_column_destroy(column);
  sph_destroy(s);
  case_destroy(c);
  return status;
}

const struct theory_topic theory_spectrum = {
    .name = "spectrum",
    .help = "growth of disturbances in columns of particles at rest below a free surface, by the "
            "solver's own rates (T, section 2.6.2.2, figures 2-25 to 2-32)",
    .params_size = sizeof(struct spectrum),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

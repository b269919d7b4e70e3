/* What density re-initialisations do to a wave of density on a line of particles that were advected
 * from a lattice, dx = h, cubic B-spline (T, section 3.4.6):
 *
 *     x = X + (a/k) sin k X,  m = rho_0(X) h,  rho = rho_0(X)/(1 + a cos k X)
 *
 *     shepard     sum m W / sum V W (3.60): rho + (h^2/6) rho'' (3.61)
 *     mls-volume  sum m w, sum V w = 1 and sum V w (x_b - x_a) = 0: T's reference [3]; keeps
 *                 gradients of density, too
 *     mls-mass    sum w m/h, sum w = 1 and sum w (x_b - x_a) = 0, as T has it (3.63): the density
 *                 that the particle had at first; removes them
 *
 * rho_0 = 1 or, with `delta`, 1 - 2 delta x. `kept` is the share of rho - rho_0 that is left, its
 * projection on itself; `second`, of all but mls-mass, the projection of rho* - rho on h^2 rho''.
 */
#include <math.h>
#include <stdlib.h>

#include "common/base/array.h"
#include "theory/spline.h"
#include "theory/theory.h"

static const char *const scheme_names[] = {"shepard", "mls-volume", "mls-mass", NULL};
static const char *const scheme_helps[] = {"(3.60)", "fit with volumes", "fit of masses, (3.63)"};
enum { SHEPARD, MLS_VOLUME, MLS_MASS };

struct densities {
  double wave, amplitude, delta;
  int scheme;
};

static const struct param params[] = {
    THEORY_CHOICE(densities, scheme, scheme_names, scheme_helps, "shepard, mls-volume, mls-mass",
                  "how the density is found anew"),
    THEORY_REAL(densities, wave, 0.01, 2, "0.2", "k h of the wave"),
    THEORY_REAL(densities, amplitude, 1e-9, 0.5, "0.001", "a, of the density"),
    THEORY_REAL(densities, delta, 0, 1e-3, "0", "of the density at first, 1/h"),
};
static const struct theory_column columns[] = {
    {.key = "x", .unit = "h", .label = "x/h", .help = "place"},
    {.key = "before",
     .unit = "rho_f",
     .label = "before",
     .axis = "ρ/ρ_f − 1",
     .level = "0",
     .same = true,
     .help = "density over rho_f less 1"},
    {.key = "after", .unit = "rho_f", .label = "after", .help = "after re-initialisation"},
};
enum { KEPT, SECOND };
static const struct theory_value values[] = {
    [KEPT] = {"kept", "1", "share of the density's wave that is left"},
    [SECOND] = {"second", "1", "rho* = rho + this times h^2 rho''; none of mls-mass"},
};

struct line { /* arrays [n] */
  size_t n;
  double *x, *rho, *first, *m;
};

static double found(const struct densities *p, const struct line *l, size_t a) {
  double s[3] = {0}, t[2] = {0}; /* sums of w x^k, and of w f and w x f */
  const bool volumes = p->scheme != MLS_MASS;
  for (size_t b = a - 4; b <= a + 4; b++) {
    double x = l->x[b] - l->x[a], w = theory_spline(x);
    double f = volumes ? l->rho[b] : l->m[b]; /* m/h */
    if (volumes) w *= l->m[b] / l->rho[b];
    for (int k = 0; k < 3; k++) s[k] += w * pow(x, k);
    t[0] += w * f;
    t[1] += w * x * f;
  }
  if (p->scheme == SHEPARD) return t[0] / s[0];
  return (s[2] * t[0] - s[1] * t[1]) / (s[0] * s[2] - s[1] * s[1]);
}

static void fill(const struct densities *p, struct line *l) {
  for (size_t i = 0; i < l->n; i++) {
    double X = (double)i - 4, phase = p->wave * X;
    l->x[i] = X + p->amplitude / p->wave * sin(phase);
    l->first[i] = l->m[i] = 1 - 2 * p->delta * X;
    l->rho[i] = l->first[i] / (1 + p->amplitude * cos(phase));
  }
}

/* Over whole waves, or nearly so. */
static enum status measure(const struct densities *p, const struct line *l,
                           struct theory_curve *curve) {
  double kept[2] = {0}, second[2] = {0};
  for (size_t a = 4; a + 4 < l->n; a++) {
    double after = found(p, l, a), own = l->rho[a] - l->first[a];
    double bend = -p->wave * p->wave * own; /* h^2 rho'' to first order in the amplitude */
    TRY(THEORY_ROW(curve, l->x[a], l->rho[a] - 1, after - 1));
    kept[0] += (after - l->first[a]) * own;
    kept[1] += own * own;
    second[0] += (after - l->rho[a]) * bend;
    second[1] += bend * bend;
  }
  curve->value[KEPT] = kept[0] / kept[1];
  if (p->scheme != MLS_MASS) curve->value[SECOND] = second[0] / second[1];
  return OK;
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct densities *p = with;
  const int waves = 4;
  struct line l = {.n = (size_t)lround(waves * 2 * M_PI / p->wave) + 8};
  double *all;
  enum status status;
  TRY(array_create(&all, 4 * l.n, "a line of particles"));
  l.x = all;
  l.rho = all + l.n;
  l.first = all + 2 * l.n;
  l.m = all + 3 * l.n;
  fill(p, &l);
  status = measure(p, &l, curve);
  free(all);
  return status;
}

const struct theory_topic theory_densities = {
    .name = "densities",
    .help = "what density re-initialisations leave of a wave of density (T, section 3.4.6, eqs "
            "3.59-3.63, table 3.2)",
    .params_size = sizeof(struct densities),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

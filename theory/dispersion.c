/* Sound with diffusion (P, section III). The linearised equations (17) for density and velocity,
 *
 *     rho_t + rho0 u_x + delta h^3 c0 B rho_xxxx = 0
 *     u_t + (c0^2/rho0) rho_x = (alpha h c0/2) u_xx
 *
 * have plane waves exp(i k (x - (a + i b) t)). With mu = k h,
 *
 *     F = 1 - (mu^2/4) (alpha/2 - B delta mu^2)^2                                 (19)
 *     F >= 0:  a = c0 sqrt(F),  b = -(c0 mu/2) (alpha/2 + B delta mu^2)           (20)
 *     F < 0:   a = 0,  b = c0 {-(mu/2) (alpha/2 + B delta mu^2) +- sqrt(-F)}      (21)
 *
 * B = <q_x^2>/4 is 1/8 for the Gaussian: (16), as printed, is -1 in one dimension.
 *
 * On a square lattice the particle solver has G for mu, D for B mu^4 and X for mu^2/2, from the
 * sums over neighbours (sph/theory/lattice.h), of waves along a row: with d = delta D and x = alpha
 * X the waves have (a mu)^2 = G^2 - (x - d)^2/4 and b mu = -(x + d)/2. Of all waves that the
 * lattice carries, those that do not travel are counted, too, with X taken along G. */
#include <math.h>

#include "common/base/root.h"
#include "sph/theory/lattice.h"
#include "theory/kernels.h"
#include "theory/theory.h"

static const char *const operator_names[] = {"continuum", "lattice", NULL};
static const char *const operator_helps[] = {"of the equations (17), with the moment B",
                                             "of sums over a square lattice, waves along a row"};

struct dispersion {
  double alpha, delta, moment, ratio, to;
  int operator, kernel, diffusion, points;
};

struct medium { /* what waves run through */
  const struct dispersion *p;
  struct sph_lattice lattice;
};

struct wave { /* in c0/h */
  double gradient, diffusion, viscosity;
};

static struct wave wave_of(const struct medium *m, double mu) {
  const struct dispersion *p = m->p;
  struct sph_symbols s;
  if (!p->operator)
    return (struct wave){mu, p->delta * p->moment * pow(mu, 4), p->alpha * mu * mu / 2};
  sph_lattice_symbols(&m->lattice, (enum sph_diffusion)p->diffusion, mu, 0, &s);
  return (struct wave){s.Gx, p->delta * s.D, p->alpha * s.xx};
}

/* (a mu)^2 over G^2, which is F in the continuum. */
static double discriminant(double mu, const void *with) {
  struct wave w = wave_of(with, mu);
  double difference = (w.viscosity - w.diffusion) / 2;
  return 1 - pow(difference / w.gradient, 2);
}

static double speed(const struct medium *m, double mu) { /* a/c0 */
  return wave_of(m, mu).gradient / mu * sqrt(fmax(discriminant(mu, m), 0));
}

static double rate(const struct medium *m, double mu, double sign) { /* b/c0 */
  struct wave w = wave_of(m, mu);
  double f = discriminant(mu, m), middle = -(w.viscosity + w.diffusion) / 2;
  return (f < 0 ? middle + sign * w.gradient * sqrt(-f) : middle) / mu;
}

/* The smallest mu where waves cease to travel, as far as the first of these: the shortest wave of a
 * lattice, and where (mu/2) |alpha/2 - B delta mu^2| = 1 for sure in the continuum. */
static double regime_end(const struct medium *m) {
  enum { SCAN = 4000 };
  const struct dispersion *p = m->p;
  double diffusion = p->moment * p->delta;
  double viscous = p->alpha > 0 ? 4 / p->alpha : 0;
  double most = diffusion > 0 ? 2 * sqrt(p->alpha / (6 * diffusion)) + 2 * cbrt(2 / diffusion)
                              : 1.01 * viscous;
  if (p->operator) most = 0.9999 * M_PI * p->ratio; /* where G vanishes */
  for (int i = 1; i < SCAN && most > 0; i++) {
    double low = most * i / SCAN, high = most * (i + 1) / SCAN;
    if (discriminant(high, m) < 0) return root_between(discriminant, m, low, high);
  }
  return NAN;
}

/* The share of the zone |kx|, |ky| < pi/dx in which waves do not travel; of it the triangle
 * 0 < ky < kx, midpoints of squares, those on its side counted half. */
static double share_that_stands(const struct medium *m) {
  enum { ACROSS = 100 };
  const struct dispersion *p = m->p;
  const double step = M_PI * p->ratio / ACROSS;
  double standing = 0;
  for (int i = 0; i < ACROSS; i++)
    for (int j = 0; j <= i; j++) {
      struct sph_symbols s;
      sph_lattice_symbols(&m->lattice, (enum sph_diffusion)p->diffusion, (i + 0.5) * step,
                          (j + 0.5) * step, &s);
      const double G2 = s.Gx * s.Gx + s.Gy * s.Gy;
      const double along = s.Gx * s.Gx * s.xx + 2 * s.Gx * s.Gy * s.xy + s.Gy * s.Gy * s.yy;
      const double x = p->alpha * along / G2, d = p->delta * s.D;
      if (pow((x - d) / 2, 2) > G2) standing += i == j ? 0.5 : 1;
    }
  return 2 * standing / (ACROSS * ACROSS);
}

static const struct param params[] = {
    THEORY_REAL(dispersion, alpha, 0, 100, "0.01", "artificial viscosity"),
    THEORY_REAL(dispersion, delta, 0, 100, "1", "coefficient of the diffusion"),
    THEORY_CHOICE(dispersion, operator, operator_names, operator_helps, "continuum",
                  "what waves run through"),
    THEORY_REAL(dispersion, moment, 0, 1, "0.125",
                "of the continuum: B of the kernel, 1/8 of the Gaussian; 3/8 is what the smoothed "
                "gradient of Antuono's term makes of it"),
    THEORY_CHOICE(dispersion, kernel, theory_kernel_names, NULL, "gaussian", "of the lattice"),
    THEORY_CHOICE(dispersion, diffusion, theory_diffusion_names, NULL, "antuono", "of the lattice"),
    THEORY_REAL(dispersion, ratio, 0.5, 4, "1.3333333333333333", "of the lattice: h/dx"),
    THEORY_REAL(dispersion, to, PARAM_ABOVE_0, 1000, "4.1887902047863905",
                "largest k h; pi h/dx is that of the shortest wave between particles"),
    THEORY_POINTS(dispersion),
};
static const struct theory_column columns[] = {
    {.key = "mu", .unit = "1", .label = "μ = k h", .help = "wavenumber times h"},
    {.key = "a",
     .unit = "c0",
     .label = "a/c_0",
     .axis = "speed a/c_0, damping b/c_0",
     .level = "0",
     .help = "speed of the wave"},
    {.key = "b",
     .unit = "c0",
     .label = "b/c_0",
     .help = "damping over the wavenumber; the slower of two beyond the change of regime"},
    {.key = "b_minus",
     .unit = "c0",
     .label = "b^-/c_0",
     .help = "the faster of two",
     .undrawn = true},
};
enum { END, DAMPING_AT_END, STANDING };
static const struct theory_value values[] = {
    [END] = {"mu_star", "1", "k h at which waves cease to travel, F = 0 (19)"},
    [DAMPING_AT_END] = {"b_star", "c0", "damping there"},
    [STANDING] = {"standing", "1",
                  "of the lattice: share of its waves, of any direction, that do not travel"},
};

static enum status rows_add(const struct medium *m, struct theory_curve *curve) {
  const struct dispersion *p = m->p;
  double most = p->operator? fmin(p->to, M_PI * p->ratio) : p->to;
  for (int i = 0; i < p->points; i++) {
    double mu = theory_between(0, most, i, p->points), at = fmax(mu, 1e-6); /* its limit at 0 */
    TRY(THEORY_ROW(curve, mu, speed(m, at), rate(m, at, 1), rate(m, at, -1)));
  }
  double end = regime_end(m);
  curve->value[END] = end;
  if (isfinite(end)) curve->value[DAMPING_AT_END] = rate(m, end, 0);
  if (p->operator) curve->value[STANDING] = share_that_stands(m);
  return OK;
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  struct medium m = {.p = with};
  if (m.p->operator) sph_lattice_of((enum sph_kernel)m.p->kernel, m.p->ratio, &m.lattice);
  return rows_add(&m, curve);
}

const struct theory_topic theory_dispersion = {
    .name = "dispersion",
    .help = "speed and damping of sound with diffusion and viscosity (P, eqs 17-21, figure 1), in "
            "the continuum or on a lattice of particles",
    .params_size = sizeof(struct dispersion),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

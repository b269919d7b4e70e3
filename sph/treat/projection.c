/* Modal re-projection in a periodic tank (thesis, eqs. (2.94), (2.98) to (2.103) corrected, and
 * 4.2.4): velocities become those of the waves
 *
 *   Phi = sum_m (a_m sin k_m x + b_m cos k_m x) Y_m(y),  k_m = 2 pi m/L,  m = 1 to projection_modes
 *
 * that come nearest to them: that minimise sum_i V_i w(y_i) |u_i - grad Phi|^2. On undisturbed rows
 * of particles the modes are orthogonal, and a_m is the thesis' integral of grad phi . u over that
 * of |grad phi|^2 by the same quadrature, over the particles; on disturbed ones the small linear
 * system keeps the modes apart. There is no m = 0, which has no gradient. The modes
 * (projection_profile):
 *
 *   deep      Y = e^{k y}, w = 1 (eq. (2.95), F0)
 *   weighted  Y = e^{k y}, w = e^{-2 delta y}, delta = g/2c0^2 (eq. (2.94) corrected, F1)
 *   finite    Y = cosh k(y + H)/cosh kH, w = 1: nothing flows through the bed
 *
 * y counted from the surface at rest. The pressure above the hydrostatic one becomes that of waves
 * that travel to the right, rho0 omega/k u_m (for `deep` rho0 sqrt(g/k) u_m).
 *
 * Where p = 0 is kept on a first row of particles, that row is the surface, and its heights are
 * projected on the same harmonics: y becomes the sum of a constant and of sines and cosines of
 * k_m x that comes nearest. Nothing else would take shorter corrugations away, and the lattice
 * makes them grow: with particles 1/16 and 1/32 of the wave apart and c0^2 = 10 g L, seven and
 * thirteen to its length, with 2.1 and 3.1 sqrt(g/L) as long as velocities and pressures are left
 * alone, still with 0.63 and 0.69 sqrt(g/L) where these are projected every 15 steps, since
 * corrugated particles set them off anew (sph/theory/rows.h), so that after 20 periods there is
 * nothing else. */
#include <lapack.h>
#include <math.h>
#include <stdlib.h>

#include "sph/treat/treat.h"
#include "sph/treat/waves.h"

enum { MOST = 2 * SPH_MOST_MODES, MOST_HARMONICS = MOST + 1 };

/* Gradients of the modes at a particle: sine, cosine, of m = 1, ... */
struct modes {
  int n;
  double level, depth, k1, delta;
  enum sph_profile profile;
};

static struct modes modes_of(const struct sph *s) {
  const double level = sph_treat_level(s);
  return (struct modes){.n = 2 * s->scheme.projection_modes,
                        .level = level,
                        .depth = level - s->tank.box.min[1],
                        .k1 = 2 * M_PI / tank_size(&s->tank, 0),
                        .delta = s->g / (2 * s->c0 * s->c0),
                        .profile = (enum sph_profile)s->scheme.projection_profile};
}

/* Y, and Y'/k. */
static void profile_at(const struct modes *o, double k, double y, double *Y, double *slope) {
  switch (o->profile) {
  case SPH_PROFILE_deep:
  case SPH_PROFILE_weighted:
    *Y = *slope = exp(k * y);
    return;
  case SPH_PROFILE_finite: { /* of exponentials that do not overflow */
    const double up = exp(k * y), down = exp(-k * (y + 2 * o->depth));
    const double top = 1 + exp(-2 * k * o->depth);
    *Y = (up + down) / top;
    *slope = (up - down) / top;
    return;
  }
  }
  __builtin_unreachable();
}

static double weight_at(const struct modes *o, double y) {
  return o->profile == SPH_PROFILE_weighted ? exp(-2 * o->delta * y) : 1;
}

static void gradients_at(const struct modes *o, double x, double y, double gx[MOST],
                         double gy[MOST]) {
  for (int m = 0; m < o->n; m += 2) {
    const double k = (m / 2 + 1) * o->k1, sine = sin(k * x), cosine = cos(k * x);
    double Y, slope;
    profile_at(o, k, y - o->level, &Y, &slope);
    gx[m] = k * cosine * Y;
    gy[m] = k * sine * slope;
    gx[m + 1] = -k * sine * Y;
    gy[m + 1] = k * cosine * slope;
  }
}

/* Normal equations: A [n][n], row after row of its lower half, and b [n]. */
struct normal {
  int n;
  double *A, b[MOST_HARMONICS];
};

static struct normal normal_create(int n, double *A) {
  struct normal e = {.n = n, .A = A};
  for (int k = 0; k < n * n; k++) A[k] = 0;
  return e;
}

/* A sample f of what functions f_k are fitted to, with weight w. */
static void normal_add(struct normal *e, double w, const double *f_k, double f) {
  for (int k = 0; k < e->n; k++) {
    e->b[k] += w * f_k[k] * f;
    for (int l = 0; l <= k; l++) e->A[k * e->n + l] += w * f_k[k] * f_k[l];
  }
}

/* Their solution, into b. */
static enum status normal_solve(const struct sph *s, struct normal *e) {
  lapack_int n = e->n, one = 1, info;
  LAPACK_dposv("U", &n, &one, e->A, &n, e->b, &n, &info);
  CHECK(info == 0, ERR_DIVERGED,
        "at t = %g s the particles cannot tell %d waves apart: lower projection_modes", s->t,
        s->scheme.projection_modes);
  return OK;
}

static enum status find_amplitudes(const struct sph *s, const struct modes *o, struct normal *e) {
  *e = normal_create(o->n, s->treated[SPH_TREATMENT_projection]);
  for (size_t i = 0; i < s->f.n; i++) {
    double gx[MOST], gy[MOST];
    const double w = sph_treat_volume(s, i) * weight_at(o, s->f.w.y[i] - o->level);
    gradients_at(o, s->f.w.x[i], s->f.w.y[i], gx, gy);
    normal_add(e, w, gx, s->f.w.u[i]);
    normal_add(e, w, gy, s->f.w.v[i]);
  }
  return normal_solve(s, e);
}

static void harmonics_at(const struct modes *o, double x, double f[MOST_HARMONICS]) {
  f[0] = 1;
  for (int m = 0; m < o->n; m += 2) {
    const double k = (m / 2 + 1) * o->k1;
    f[m + 1] = sin(k * x);
    f[m + 2] = cos(k * x);
  }
}

static enum status project_first_row(struct sph *s, const struct modes *o) {
  if (!s->fitted) return OK;
  struct normal e = normal_create(o->n + 1, s->treated[SPH_TREATMENT_projection]);
  double f[MOST_HARMONICS];
  for (size_t i = 0; i < s->f.n; i++) {
    if (!s->fitted[s->f.id[i]]) continue;
    harmonics_at(o, s->f.w.x[i], f);
    normal_add(&e, 1, f, s->f.w.y[i] - o->level);
  }
  TRY(normal_solve(s, &e));
  for (size_t i = 0; i < s->f.n; i++) {
    if (!s->fitted[s->f.id[i]]) continue;
    harmonics_at(o, s->f.w.x[i], f);
    s->f.w.y[i] = o->level;
    for (int k = 0; k < e.n; k++) s->f.w.y[i] += e.b[k] * f[k];
  }
  return OK;
}

static enum status project(struct sph *s) {
  const struct modes o = modes_of(s);
  struct normal e;
  TRY(project_first_row(s, &o));
  TRY(find_amplitudes(s, &o, &e));
  const double *b = e.b;
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < s->f.n; i++) {
    double gx[MOST], gy[MOST], u = 0, v = 0, p = 0;
    gradients_at(&o, s->f.w.x[i], s->f.w.y[i], gx, gy);
    for (int k = 0; k < o.n; k++) {
      const double wave = (k / 2 + 1) * o.k1;
      const double finite = o.profile == SPH_PROFILE_finite ? tanh(wave * o.depth) : 1;
      u += b[k] * gx[k];
      v += b[k] * gy[k];
      p += s->rho0 * sqrt(s->g * finite / wave) * b[k] * gx[k];
    }
    s->f.w.u[i] = u;
    s->f.w.v[i] = v;
    sph_treat_set_dynamic(s, i, o.level, p);
  }
  return OK;
}

static enum status projection_create(struct sph *s, void **own) {
  const size_t n = 2 * (size_t)s->scheme.projection_modes + 1;
  double *A;
  TRY(sph_allocate(n * n, sizeof *A, &A));
  *own = A;
  return OK;
}

const struct sph_treatment sph_treatment_projection = {.create = projection_create,
                                                       .destroy = free,
                                                       .due = sph_treat_has_grown,
                                                       .apply = project,
                                                       .periodic = true,
                                                       .weighs = true};

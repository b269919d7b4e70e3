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
 * that travel to the right, rho0 omega/k u_m (for `deep` rho0 sqrt(g/k) u_m). */
#include <lapack.h>
#include <math.h>
#include <stdlib.h>

#include "sph/treat/treat.h"
#include "sph/treat/waves.h"

enum { MOST = 2 * SPH_MOST_MODES };

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

/* The normal equations, A [n][n] and b [n], and their solution in b. */
static enum status find_amplitudes(const struct sph *s, const struct modes *o, double *A,
                                   double b[MOST]) {
  for (int k = 0; k < o->n * o->n; k++) A[k] = 0;
  for (int k = 0; k < o->n; k++) b[k] = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    double gx[MOST], gy[MOST];
    const double w = s->f.m[i] / s->f.w.rho[i] * weight_at(o, s->f.w.y[i] - o->level);
    gradients_at(o, s->f.w.x[i], s->f.w.y[i], gx, gy);
    for (int k = 0; k < o->n; k++) {
      b[k] += w * (gx[k] * s->f.w.u[i] + gy[k] * s->f.w.v[i]);
      for (int l = 0; l <= k; l++) A[k * o->n + l] += w * (gx[k] * gx[l] + gy[k] * gy[l]);
    }
  }
  lapack_int n = o->n, one = 1, info;
  LAPACK_dposv("U", &n, &one, A, &n, b, &n, &info);
  CHECK(info == 0, ERR_DIVERGED,
        "at t = %g s the particles cannot tell %d waves apart: lower projection_modes", s->t,
        o->n / 2);
  return OK;
}

static enum status project(struct sph *s) {
  const struct modes o = modes_of(s);
  double b[MOST];
  TRY(find_amplitudes(s, &o, s->treated[SPH_TREATMENT_projection], b));
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
  const size_t n = 2 * (size_t)s->scheme.projection_modes;
  double *A;
  TRY(sph_allocate(n * n, sizeof *A, &A));
  *own = A;
  return OK;
}

const struct sph_treatment sph_treatment_projection = {.create = projection_create,
                                                       .destroy = free,
                                                       .due = sph_treat_has_grown,
                                                       .apply = project,
                                                       .periodic = true};

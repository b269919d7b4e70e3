#include "sph/time/linear.h"

#include <lapack.h>
#include <math.h>
#include <string.h>

#include "sph/time/chebyshev.h"
#include "sph/time/stages.h"

enum { X = SPH_LINEAR_X, Y, U, V, RHO };

struct sph_linear sph_linear_sound(double omega) {
  struct sph_linear p = {0};
  p.K[X][U] = 1;
  p.K[U][RHO] = p.K[RHO][U] = I * omega;
  return p;
}

struct sph_linear sph_linear_sound_direct(double omega) {
  struct sph_linear p = {0};
  p.K[X][U] = 1;
  p.K[U][X] = -omega * omega;
  return p;
}

static void rates(const struct sph_linear *p, const double complex *w, double complex decay,
                  double complex *k) {
  for (int i = 0; i < SPH_LINEAR; i++) {
    k[i] = 0;
    for (int j = 0; j < SPH_LINEAR; j++) k[i] += p->K[i][j] * w[j];
  }
  k[RHO] -= decay;
}

/* The state of row r from that at the start and the rates so far. */
static void set_state(const struct sph_row *row, int r, double dt, const double complex *start,
                      double complex (*k)[SPH_LINEAR], double complex *w) {
  w[U] = row->keep * start[U];
  w[V] = row->keep * start[V];
  for (int i = 0; i < SPH_LINEAR; i++) {
    const double *weights = i == RHO ? row->rho : i >= U ? row->u : row->x;
    if (i != U && i != V) w[i] = start[i];
    for (int l = 0; l < r; l++) w[i] += dt * weights[l] * k[l][i];
  }
  w[X] += dt * row->own * w[U];
  w[Y] += dt * row->own * w[V];
}

/* What the split diffusion leaves of a mode that decays at `rate`. */
static double left_of(double rate, double fastest) {
  const struct sph_chebyshev p = sph_chebyshev_of(fastest);
  return sph_chebyshev_value(&p, -rate);
}

void sph_linear_step(const struct sph_integrator *method, const struct sph_linear *p, double dt,
                     double complex G[SPH_LINEAR][SPH_LINEAR]) {
  const struct sph_stages s = sph_stages_of(method, p->damping * dt);
  for (int c = 0; c < SPH_LINEAR; c++) {
    double complex start[SPH_LINEAR] = {0}, w[SPH_LINEAR], k[SPH_MAX_STAGES][SPH_LINEAR];
    start[c] = 1;
    for (int r = 0; r < s.n; r++) {
      set_state(&s.row[r], r, dt, start, k, w);
      const double complex held = method->frozen ? start[RHO] : w[RHO];
      rates(p, w, method->split ? 0 : p->rate * held, k[r]);
    }
    set_state(&s.row[s.n], s.n, dt, start, k, w);
    if (method->split) w[RHO] *= left_of(p->rate * dt, p->fastest * dt);
    for (int i = 0; i < SPH_LINEAR; i++) G[i][c] = w[i];
  }
}

enum status sph_linear_factors(double complex G[SPH_LINEAR][SPH_LINEAR],
                               double complex factor[SPH_LINEAR]) {
  double complex a[SPH_LINEAR * SPH_LINEAR], work[4 * SPH_LINEAR];
  double real_work[2 * SPH_LINEAR];
  int n = SPH_LINEAR, one = 1, room = 4 * SPH_LINEAR, info = 0;
  memcpy(a, G, sizeof a); /* transposed, which has the same eigenvalues */
  LAPACK_zgeev("N", "N", &n, a, &n, factor, NULL, &one, NULL, &one, work, &room, real_work, &info);
  CHECK(info == 0, ERR_MEMORY, "LAPACK finds no eigenvalues of a step (zgeev: %d)", info);
  return OK;
}

enum status sph_linear_growth(const struct sph_integrator *method, const struct sph_linear *p,
                              double dt, double *growth) {
  double complex G[SPH_LINEAR][SPH_LINEAR], factor[SPH_LINEAR];
  sph_linear_step(method, p, dt, G);
  TRY(sph_linear_factors(G, factor));
  *growth = 0;
  for (int i = 0; i < SPH_LINEAR; i++) *growth = fmax(*growth, cabs(factor[i]));
  return OK;
}

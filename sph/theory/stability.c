#include "sph/theory/stability.h"

#include <float.h>
#include <lapack.h>
#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "sph/pair/continuity.h"
#include "sph/pair/rates.h"
#include "sph/sph.h"
#include "sph/theory/lattice.h"
#include "sph/time/integrator.h"

enum { COLUMNS = 3 }; /* of a wave: a "particle" each; the first is of rho, or of displacement */

struct sph_modes {
  struct sph_stand_in stand_in;
  struct sph s;
  size_t n;
  double (*k)[2];              /* [n], wave numbers, 1/h, owned */
  struct sph_symbols *symbols; /* [n], owned */
  double fastest;              /* largest decay rate, delta D */
  bool sums;                   /* the density follows from displacements */
  double whole;                /* sum W V */
};

/* ---- the right-hand side ---- */

static const struct sph_modes *modes_of(const struct sph *s) {
  return (const struct sph_modes *)s->stand_in; /* its first member */
}

static void diffusion(const struct sph *s, double *D) {
  const struct sph_modes *m = modes_of(s);
  for (size_t i = 0; i < s->f.n; i++)
    D[i] = -s->scheme.delta * m->symbols[i / COLUMNS].D * s->f.w.rho[i];
}

static double diffuse(struct sph *s, double *D) {
  diffusion(s, D);
  return modes_of(s)->fastest;
}

/* Densities that are sums over neighbours: with -i (x, y) for displacements, sum m W is G . x, and
 * Shepard's quotient, which takes volumes from it, that smoothed once. */
static void sum_densities(struct sph *s) {
  const struct sph_modes *m = modes_of(s);
  for (size_t i = 0; i < s->f.n; i++) {
    const struct sph_symbols *a = &m->symbols[i / COLUMNS];
    const double once = s->scheme.continuity == SPH_CONTINUITY_shepard ? a->W / m->whole : 1;
    s->f.w.rho[i] = once * (a->Gx * s->f.w.x[i] + a->Gy * s->f.w.y[i]);
  }
}

static void rates(struct sph *s, int stage, bool diffuse) {
  const struct sph_modes *m = modes_of(s);
  if (m->sums) sum_densities(s);
  const struct sph_state *w = &s->f.w, *k = &s->f.k[stage];
  const double alpha = s->scheme.alpha;
  if (diffuse) diffusion(s, s->f.D);
  for (size_t i = 0; i < s->f.n; i++) {
    const struct sph_symbols *a = &m->symbols[i / COLUMNS];
    k->x[i] = w->u[i];
    k->y[i] = w->v[i];
    k->u[i] = -a->Gx * w->rho[i] - alpha * (a->xx * w->u[i] + a->xy * w->v[i]);
    k->v[i] = -a->Gy * w->rho[i] - alpha * (a->xy * w->u[i] + a->yy * w->v[i]);
    k->rho[i] = a->Gx * w->u[i] + a->Gy * w->v[i] + (s->split ? 0 : s->f.D[i]);
  }
}

/* ---- the waves ---- */

static void set_waves(struct sph_modes *m, int n) {
  const struct sph_scheme *o = &m->s.scheme;
  struct sph_lattice l;
  const double step = M_PI * o->h_over_dx / n;
  sph_lattice_of_scheme(o, &l);
  m->whole = sph_lattice_moment(&l, 0, 0, SPH_LATTICE_REACH);
  m->n = 0;
  for (int i = 1; i <= n; i++)
    for (int j = 0; j <= i; j++, m->n++) {
      struct sph_symbols *a = &m->symbols[m->n];
      m->k[m->n][0] = i * step;
      m->k[m->n][1] = j * step;
      sph_lattice_symbols(&l, (enum sph_diffusion)o->diffusion, i * step, j * step, a);
      m->fastest = fmax(m->fastest, o->delta * a->D);
    }
}

enum status sph_modes_create(const struct sph_scheme *o, int n, struct sph_modes **out) {
  enum status status = OK;
  struct sph_modes *m;
  const size_t waves = (size_t)n * (size_t)(n + 3) / 2;
  TRY(sph_allocate(1, sizeof *m, &m));
  m->stand_in = (struct sph_stand_in){rates, diffuse};
  m->s = (struct sph){
      .scheme = *o, .scale = sph_scale_of(o), .rho0 = 1, .c0 = 1, .h = 1, .dx = 1 / o->h_over_dx};
  m->s.scheme.delta = sph_scheme_delta(o);
  m->s.scheme.integrator = sph_integrator_chosen(o);
  m->s.split = sph_integrators[m->s.scheme.integrator]->split;
  m->s.stand_in = &m->stand_in;
  m->sums = continuity_sums((enum sph_continuity)o->continuity);
  ATTEMPT(sph_allocate(waves, sizeof *m->k, &m->k));
  ATTEMPT(sph_allocate(waves, sizeof *m->symbols, &m->symbols));
  ATTEMPT(sph_particles_create(&m->s.f, COLUMNS * waves));
  set_waves(m, n);
done:
  if (status != OK) {
    sph_modes_destroy(m);
    m = NULL;
  }
  *out = m;
  return status;
}

void sph_modes_destroy(struct sph_modes *m) {
  if (!m) return;
  free(m->k);
  free(m->symbols);
  sph_particles_destroy(&m->s.f);
  free(m);
}

/* ---- a step ---- */

/* Along which a displacement compresses; any direction where none does. */
static void direction_of(const struct sph_symbols *a, double d[2]) {
  const double G = hypot(a->Gx, a->Gy);
  d[0] = G > 0 ? a->Gx / G : 1;
  d[1] = G > 0 ? a->Gy / G : 0;
}

static void set_columns(struct sph_modes *m) {
  const struct sph_state *w = &m->s.f.w;
  const size_t bytes = m->s.f.room * sizeof(double);
#define X(q, unit, help) memset(w->q, 0, bytes);
  SPH_EVOLVING(X)
#undef X
  for (size_t k = 0; k < m->n; k++) {
    const size_t i = COLUMNS * k;
    double d[2];
    direction_of(&m->symbols[k], d);
    w->rho[i] = m->sums ? 0 : 1;
    w->x[i] = m->sums ? d[0] : 0;
    w->y[i] = m->sums ? d[1] : 0;
    w->u[i + 1] = w->v[i + 2] = 1;
  }
#define X(q, unit, help) memcpy(m->s.f.w0.q, w->q, bytes);
  SPH_EVOLVING(X)
#undef X
}

static enum status advance(struct sph_modes *m, double courant) {
  struct sph *s = &m->s;
  const int threads = omp_get_max_threads();
  struct sph_totals spent = {0};
  bool held = true;
  set_columns(m);
  const struct sph_integrator *method = sph_integrators[s->scheme.integrator];
  enum status status = OK;
  omp_set_num_threads(1); /* waking another takes as long as the whole step */
  ATTEMPT(sph_rates(s, 0, true, false));
  ATTEMPT(method->step(s, method, courant, &spent, &held));
done:
  omp_set_num_threads(threads);
  return status;
}

static void matrix_of(const struct sph_modes *m, size_t wave, double T[COLUMNS][COLUMNS]) {
  const struct sph_state *w = &m->s.f.w;
  double d[2];
  direction_of(&m->symbols[wave], d);
  for (size_t c = 0; c < COLUMNS; c++) {
    const size_t i = COLUMNS * wave + c;
    T[0][c] = m->sums ? d[0] * w->x[i] + d[1] * w->y[i] : w->rho[i];
    T[1][c] = w->u[i];
    T[2][c] = w->v[i];
  }
}

/* Whether all eigenvalues are smaller than R: of z^3 + a z^2 + b z + c, whose zeros are theirs over
 * R, by the criterion of Schur, Cohn and Jury. Where all three are about 1, what is compared is
 * lost in rounding. */
static bool is_below(double T[COLUMNS][COLUMNS], double R) {
  const double trace = T[0][0] + T[1][1] + T[2][2];
  const double minors = T[0][0] * T[1][1] - T[0][1] * T[1][0] + T[0][0] * T[2][2] -
                        T[0][2] * T[2][0] + T[1][1] * T[2][2] - T[1][2] * T[2][1];
  const double det = T[0][0] * (T[1][1] * T[2][2] - T[1][2] * T[2][1]) -
                     T[0][1] * (T[1][0] * T[2][2] - T[1][2] * T[2][0]) +
                     T[0][2] * (T[1][0] * T[2][1] - T[1][1] * T[2][0]);
  const double a = -trace / R, b = minors / (R * R), c = -det / (R * R * R);
  const double least = -1e-13;
  return 1 - fabs(c) > least && 1 + a + b + c > least && 1 - a + b - c > least &&
         1 - c * c - fabs(b - a * c) > least;
}

static enum status is_stable(struct sph_modes *m, double rate, double courant, bool *stable) {
  double T[COLUMNS][COLUMNS];
  TRY(advance(m, courant));
  *stable = true;
  for (size_t k = 0; k < m->n && *stable; k++) {
    matrix_of(m, k, T);
    *stable = is_below(T, 1 + fmax(rate * courant, 1e-9));
  }
  return OK;
}

static double spectral_radius(double T[COLUMNS][COLUMNS]) {
  double re[COLUMNS], im[COLUMNS], work[8 * COLUMNS], most = 0;
  const lapack_int n = COLUMNS, one = 1, room = 8 * COLUMNS;
  lapack_int info;
  LAPACK_dgeev("N", "N", &n, &T[0][0], &n, re, im, NULL, &one, NULL, &one, work, &room, &info);
  for (int k = 0; k < COLUMNS; k++) most = fmax(most, hypot(re[k], im[k]));
  return info ? NAN : most;
}

enum status sph_modes_growth(struct sph_modes *m, double courant, double *growth, double *wave) {
  double T[COLUMNS][COLUMNS];
  TRY(advance(m, courant));
  *growth = 0;
  for (size_t k = 0; k < m->n; k++) {
    matrix_of(m, k, T);
    const double r = spectral_radius(T);
    if (r <= *growth) continue;
    *growth = r;
    if (wave) memcpy(wave, m->k[k], sizeof m->k[k]);
  }
  return OK;
}

enum status sph_modes_limit(struct sph_modes *m, double rate, double *courant) {
  double low = 0, high = 1;
  bool stable = true;
  while (high < 64) {
    TRY(is_stable(m, rate, high, &stable));
    if (!stable) break;
    low = high;
    high *= 1.5;
  }
  while (high - low > 1e-4 * high && high > 1e-3) {
    const double middle = (low + high) / 2;
    TRY(is_stable(m, rate, middle, &stable));
    *(stable ? &low : &high) = middle;
  }
  *courant = low;
  return OK;
}

enum status sph_stable_courant(const struct sph_scheme *o, double rate, double *courant) {
  struct sph_modes *m;
  TRY(sph_modes_create(o, 32, &m));
  enum status status = sph_modes_limit(m, rate, courant);
  sph_modes_destroy(m);
  return status;
}

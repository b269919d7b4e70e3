#include "common/flow/crest.h"

#include <complex.h>
#include <fftw3.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/root.h"

enum { POINTS = 4096, SWEEPS = 3000, SECANTS = 40, NEWTONS = 60 };

/* ---- far away ---- */

static double slower(double kappa, const void *froude) {
  const double f = *(const double *)froude;
  return sin(kappa) - f * f * kappa * cos(kappa);
}

static double decay_of(double froude) {
  return root_between(slower, &froude, 1e-3, M_PI / 2);
}

static double froude_about(double a) {
  return sqrt(1 + a - a * a / 20 - 3 * a * a * a / 70);
}

double wave_crest_decay_about(double amplitude) {
  return decay_of(froude_about(amplitude));
}

/* ---- Babenko's equation, on 0 <= xi <= half, where everything is even ---- */

struct babenko {
  double k[POINTS + 1], c[POINTS + 1];     /* wavenumbers, k coth k */
  double eta[POINTS + 1], hat[POINTS + 1]; /* cosine transforms times 2 POINTS */
  double work[POINTS + 1], square[POINTS + 1], by[POINTS + 1]; /* C eta, and what is nonlinear */
  fftw_plan plan; /* in place on work; applied twice it is 2 POINTS times the identity */
};

static void transform(struct babenko *b, const double *in, double *out) {
  memmove(b->work, in, sizeof b->work);
  fftw_execute(b->plan);
  memmove(out, b->work, sizeof b->work);
}

/* One sweep at F^2; how far the surface has moved. */
static double sweep(struct babenko *b, double f2) {
  double up = 0, down = 0, moved = 0;
  transform(b, b->eta, b->hat);
  for (int i = 0; i <= POINTS; i++) b->by[i] = b->c[i] * b->hat[i] / (2 * POINTS);
  transform(b, b->by, b->by);
  for (int i = 0; i <= POINTS; i++) b->square[i] = b->eta[i] * b->eta[i] / 2;
  for (int i = 0; i <= POINTS; i++) b->by[i] *= b->eta[i];
  transform(b, b->square, b->square);
  transform(b, b->by, b->by);
  for (int i = 0; i <= POINTS; i++) {
    const double twice = i == 0 || i == POINTS ? 1 : 2;
    b->by[i] += b->c[i] * b->square[i];
    up += twice * b->hat[i] * (f2 * b->c[i] - 1) * b->hat[i];
    down += twice * b->hat[i] * b->by[i];
  }
  const double s = up / down * (up / down);
  for (int i = 0; i <= POINTS; i++) b->by[i] *= s / (f2 * b->c[i] - 1) / (2 * POINTS);
  transform(b, b->by, b->by);
  for (int i = 0; i <= POINTS; i++) {
    moved = fmax(moved, fabs(b->by[i] - b->eta[i]));
    b->eta[i] = b->by[i];
  }
  return moved;
}

/* The height of the crest at F^2, or not a number where sweeps do not settle. */
static double height(struct babenko *b, double f2) {
  double moved = INFINITY;
  for (int i = 0; i < SWEEPS && moved >= 1e-14; i++) moved = sweep(b, f2);
  return moved < 1e-11 ? b->eta[0] : NAN;
}

static void lay(struct babenko *b, double amplitude, double half, double decay) {
  for (int i = 0; i <= POINTS; i++) {
    const double far = 1 / cosh(decay * half * i / POINTS / 2);
    b->k[i] = i * M_PI / half;
    b->c[i] = i > 0 ? b->k[i] / tanh(b->k[i]) : 1;
    b->eta[i] = amplitude * far * far;
  }
}

/* F^2 by secants. */
static enum status meet(struct babenko *b, double amplitude, double *f2) {
  double old = *f2 * (1 - 1e-3), was = height(b, old);
  for (int i = 0; i < SECANTS; i++) {
    const double is = height(b, *f2), miss = is - amplitude;
    if (fabs(miss) < 1e-12) return OK;
    const double next = *f2 - miss * (*f2 - old) / (is - was);
    CHECK(isfinite(next) && next > 1 && next < 1.675, ERR_SOLVER,
          "no solitary wave of amplitude %g depths was found", amplitude);
    old = *f2, was = is, *f2 = next;
  }
  CHECK(false, ERR_SOLVER, "no solitary wave of amplitude %g depths was found", amplitude);
}

/* What the wave is made of: a_j, while they are above rounding, and the integrals by the
 * trapezoidal rule, which is exact for cosines. */
static enum status keep(struct babenko *b, struct crest *w) {
  transform(b, b->eta, b->hat);
  size_t n = POINTS - 1;
  while (n > 1 && fabs(b->hat[n]) / POINTS < 1e-15) n--;
  w->wave = malloc(n * sizeof *w->wave);
  CHECK(w->wave, ERR_MEMORY, "no memory for a solitary wave");
  w->n = n;
  w->mean = b->hat[0] / (2 * POINTS);
  for (size_t j = 1; j <= n; j++) w->wave[j - 1] = b->hat[j] / POINTS / -expm1(-2 * b->k[j]);
  for (int i = 0; i <= POINTS; i++) b->by[i] = b->c[i] * b->hat[i] / (2 * POINTS);
  transform(b, b->by, b->by);
  for (int i = 0; i <= POINTS; i++) {
    const double part = (i == 0 || i == POINTS ? 1 : 2) * w->half / POINTS;
    w->mass += part * b->eta[i] * (1 + b->by[i]);
    w->kinetic += part * w->froude * w->froude * b->eta[i] * b->by[i] / 2;
    w->potential += part * b->eta[i] * b->eta[i] * (1 + b->by[i]) / 2;
  }
  return OK;
}

static enum status solve(struct babenko *b, struct crest *w) {
  double f2 = pow(froude_about(w->amplitude), 2);
  w->half = 32 / decay_of(sqrt(f2));
  lay(b, w->amplitude, w->half, decay_of(sqrt(f2)));
  TRY(meet(b, w->amplitude, &f2));
  w->froude = sqrt(f2);
  w->decay = decay_of(w->froude);
  return keep(b, w);
}

static enum status solve_anew(double amplitude, struct crest *w) {
  *w = (struct crest){.amplitude = amplitude};
  struct babenko *b = malloc(sizeof *b);
  CHECK(b, ERR_MEMORY, "no memory for a solitary wave");
  b->plan =
      fftw_plan_r2r_1d(POINTS + 1, b->work, b->work, FFTW_REDFT00, FFTW_ESTIMATE | FFTW_UNALIGNED);
  const enum status status = solve(b, w);
  fftw_destroy_plan(b->plan);
  free(b);
  return status;
}

static enum status copy(const struct crest *of, struct crest *w) {
  *w = *of;
  w->wave = malloc(of->n * sizeof *w->wave);
  CHECK(w->wave, ERR_MEMORY, "no memory for a solitary wave");
  memcpy(w->wave, of->wave, of->n * sizeof *w->wave);
  return OK;
}

/* A case asks half a dozen times for its one wave before it runs, at a tenth of a second each. */
enum status wave_crest_create(double amplitude, struct crest *w) {
  static _Thread_local struct crest last;
  *w = (struct crest){0};
  if (!last.wave || last.amplitude != amplitude) {
    wave_crest_destroy(&last);
    TRY(solve_anew(amplitude, &last));
  }
  return copy(&last, w);
}

void wave_crest_destroy(struct crest *w) {
  free(w->wave);
  w->wave = NULL;
}

/* ---- the map ---- */

/* Powers below exp(-42) of the first do not count. */
static void add_powers(const struct crest *w, double complex r, double complex *sum,
                       double complex *slope) {
  double complex p = 0, q = 0;
  const double fall = -log(cabs(r));
  const size_t n = fall * (double)w->n > 42 ? (size_t)ceil(42 / fall) : w->n;
  for (size_t j = n; j-- > 0;) {
    q = q * r + p;
    p = p * r + w->wave[j];
  }
  *sum = p * r;
  *slope = (q * r + p) * r; /* r d/dr of the sum */
}

/* z and its derivative. */
static double complex map(const struct crest *w, double complex zeta, double complex *slope) {
  const double k = M_PI / w->half;
  double complex down, up, down_slope, up_slope;
  add_powers(w, cexp(-I * k * zeta), &down, &down_slope);
  add_powers(w, cexp(I * k * zeta - 2 * k), &up, &up_slope);
  *slope = 1 + w->mean + k * (down_slope + up_slope);
  return zeta + w->mean * (zeta + I) + I * (down - up);
}

/* Beyond the period there is nothing left of the wave. */
static double within(const struct crest *w, double x) {
  return fmax(-w->half, fmin(w->half, x));
}

/* xi of the surface at x, where x - xi has the sign of x and x grows with xi. */
static double surface(const struct crest *w, double x) {
  double low = -w->half, high = w->half, xi = x;
  for (int i = 0; i < NEWTONS; i++) {
    double complex slope;
    const double miss = creal(map(w, xi, &slope)) - x;
    *(miss > 0 ? &high : &low) = xi;
    double next = xi - miss / creal(slope);
    if (!(next > low && next < high)) next = (low + high) / 2;
    if (fabs(next - xi) < 1e-14 * (1 + fabs(x))) return next;
    xi = next;
  }
  return xi;
}

double wave_crest_elevation(const struct crest *w, double x) {
  double complex slope;
  return cimag(map(w, surface(w, within(w, x)), &slope));
}

struct crest_point wave_crest_at(const struct crest *w, double x, double y) {
  double complex slope, z = within(w, x) + I * y;
  const double xi = surface(w, creal(z)), top = cimag(map(w, xi, &slope));
  double complex zeta = xi + I * ((1 + y) / (1 + top) - 1);
  for (int i = 0; i < NEWTONS; i++) {
    const double complex step = (map(w, zeta, &slope) - z) / slope;
    zeta -= step;
    if (cabs(step) < 1e-13) break;
  }
  map(w, zeta, &slope);
  const double complex u = w->froude * (1 - 1 / slope);
  return (struct crest_point){w->froude * creal(z - zeta), creal(u), -cimag(u)};
}

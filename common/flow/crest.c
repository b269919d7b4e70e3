#include "common/flow/crest.h"

#include <complex.h>
#include <fftw3.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/flow/babenko.h"

enum { NEWTONS = 60, FINER = 4, NEAR = 6 }; /* NEAR: points on either side for values between */

double wave_crest_decay_about(double amplitude) {
  return wave_babenko_decay(wave_babenko_solitary_about(amplitude));
}

double wave_crest_limit(double length) {
  const double l = length, m = 0.0077829, n = 0.0093407;
  if (l == 0) return m / n;
  return l * (0.141063 + l * (0.0095721 + l * m)) / (1 + l * (0.0788340 + l * (0.0317567 + l * n)));
}

/* ---- from Babenko's surface ---- */

/* In place, of values at the points of half a wave (REDFT00) or between its ends (RODFT00). */
static enum status transform(size_t n, double *values, fftw_r2r_kind kind) {
  fftw_plan plan = fftw_plan_r2r_1d((int)n, values, values, kind, FFTW_ESTIMATE | FFTW_UNALIGNED);
  CHECK(plan, ERR_MEMORY, "no memory for a transform of %zu points", n);
  fftw_execute(plan);
  fftw_destroy_plan(plan);
  return OK;
}

static double coth_of(double k) {
  return k < 20 ? 1 / tanh(k) : 1;
}

/* A surface, its cosine series, and what the equation makes of it. */
struct surface {
  struct babenko b;
  double *hat, *by; /* [b.n + 1]: coefficients of eta; C eta */
};

static void surface_close(struct surface *s) {
  wave_babenko_destroy(&s->b);
  free(s->hat);
  free(s->by);
}

static enum status surface_open(const struct babenko_wanted *wanted, struct surface *s) {
  TRY(wave_babenko_solve(wanted, &s->b));
  const size_t n = s->b.n;
  TRY(array_create(&s->hat, n + 1, "a steady wave"));
  TRY(array_create(&s->by, n + 1, "a steady wave"));
  memcpy(s->hat, s->b.eta, (n + 1) * sizeof *s->hat);
  TRY(transform(n + 1, s->hat, FFTW_REDFT00));
  for (size_t j = 0; j <= n; j++) {
    const double k = (double)j * M_PI / s->b.half;
    s->hat[j] /= (j == 0 || j == n ? 2 : 1) * (double)n;
    s->by[j] = (j == 0 ? 1 : k * coth_of(k)) * s->hat[j] / (j == 0 || j == n ? 1 : 2);
  }
  return transform(n + 1, s->by, FFTW_REDFT00);
}

/* Integrals over a wave by the trapezoidal rule, which is exact for cosines; in the units of the
 * strip: of eta x', of eta^2 x', of eta C eta; x' = 1 + C eta. */
struct sums {
  double first, second, work;
};

static struct sums integrate(const struct surface *s) {
  struct sums sum = {0};
  for (size_t i = 0; i <= s->b.n; i++) {
    const double part = (i == 0 || i == s->b.n ? 1 : 2) * s->b.half / (double)s->b.n;
    const double eta = s->b.eta[i], wide = part * (1 + s->by[i]);
    sum.first += wide * eta;
    sum.second += wide * eta * eta;
    sum.work += part * eta * s->by[i];
  }
  return sum;
}

/* All but the surface. A solitary wave's unit is its depth. Of a periodic one |dz/dzeta|^2 (F^2 - 2
 * eta) is another constant than F^2: the equation leaves its unit free. */
static void measure(const struct surface *s, struct crest *w) {
  const double f2 = s->b.f2, half = s->b.half, a0 = s->hat[0], low = s->b.eta[s->b.n];
  const struct sums sum = integrate(s);
  const double width = 2 * half * (1 + a0),
               flow = w->length > 0 ? sqrt(f2 - 2 * low) * (1 + s->by[s->b.n]) : sqrt(f2);
  const double speed = w->length > 0 ? flow / (1 + a0) : flow;
  const double mean = w->length > 0 ? sum.first / width : 0, unit = 1 / (1 + mean);
  w->half = half;
  w->decay = w->length > 0 ? 0 : wave_babenko_decay(f2);
  w->stretch = unit * (1 + a0);
  w->flow = pow(unit, 1.5) * flow;
  w->speed = sqrt(unit) * speed;
  w->mass = pow(unit, 2) * (sum.first - mean * width);
  w->bernoulli = unit * (f2 / 2 - mean);
  w->kinetic = pow(unit, 3) * speed * (speed * sum.work + (speed - flow) * 2 * half * a0) / 2;
  w->potential = pow(unit, 3) * (sum.second - mean * mean * width) / 2;
  w->impulse = pow(unit, 2.5) * (speed * sum.first + (speed - flow) * width);
}

/* The series, while it is above rounding, and the surface at more points than it needs. */
static enum status keep(const struct surface *s, struct crest *w) {
  const double unit = w->stretch / (1 + s->hat[0]);
  size_t n = s->b.n - 1;
  while (n > 1 && fabs(s->hat[n]) < 1e-16) n--;
  w->n = n;
  w->points = FINER * s->b.n;
  TRY(array_create(&w->wave, n, "a steady wave"));
  TRY(array_create(&w->x, w->points + 1, "a steady wave"));
  TRY(array_create(&w->y, w->points + 1, "a steady wave"));
  for (size_t j = 1; j <= n; j++) {
    const double k = (double)j * M_PI / w->half, a = unit * s->hat[j];
    w->wave[j - 1] = a / -expm1(-2 * k);
    w->x[j] = a * coth_of(k) / 2;
    w->y[j] = a / 2;
  }
  w->y[0] = w->stretch - 1;
  TRY(transform(w->points + 1, w->y, FFTW_REDFT00));
  TRY(transform(w->points - 1, w->x + 1, FFTW_RODFT00));
  for (size_t i = 0; i <= w->points; i++)
    w->x[i] += w->stretch * w->half * (double)i / (double)w->points;
  return OK;
}

static enum status solve_anew(double height, double length, struct crest *w) {
  struct surface s = {0};
  enum status status = OK;
  *w = (struct crest){.height = height, .length = length};
  ATTEMPT(surface_open(&(struct babenko_wanted){height, length, wave_crest_limit(length)}, &s));
  measure(&s, w);
  ATTEMPT(keep(&s, w));
done:
  surface_close(&s);
  return status;
}

static enum status copy(const struct crest *of, struct crest *w) {
  *w = *of;
  w->wave = w->x = w->y = NULL;
  TRY(array_create(&w->wave, of->n, "a steady wave"));
  TRY(array_create(&w->x, of->points + 1, "a steady wave"));
  TRY(array_create(&w->y, of->points + 1, "a steady wave"));
  memcpy(w->wave, of->wave, of->n * sizeof *w->wave);
  memcpy(w->x, of->x, (of->points + 1) * sizeof *w->x);
  memcpy(w->y, of->y, (of->points + 1) * sizeof *w->y);
  return OK;
}

/* A case asks half a dozen times for its one wave before it runs, at up to a second each. */
static enum status create(double height, double length, struct crest *w) {
  static _Thread_local struct crest last;
  *w = (struct crest){0};
  if (!last.y || last.height != height || last.length != length) {
    wave_crest_destroy(&last);
    TRY(solve_anew(height, length, &last));
  }
  return copy(&last, w);
}

enum status wave_crest_create(double amplitude, struct crest *w) {
  return create(amplitude, 0, w);
}

enum status wave_crest_create_periodic(double height, double length, struct crest *w) {
  return create(height, length, w);
}

void wave_crest_destroy(struct crest *w) {
  free(w->wave);
  free(w->x);
  free(w->y);
  w->wave = w->x = w->y = NULL;
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
  *slope = w->stretch + k * (down_slope + up_slope);
  return w->stretch * (zeta + I) - I + I * (down - up);
}

/* ---- the surface, between its points ---- */

/* In the wave whose crest is at 0; beyond the period of a solitary one there is nothing left. */
static double within(const struct crest *w, double x) {
  const double half = w->x[w->points];
  return w->length > 0 ? remainder(x, 2 * half) : fmax(-half, fmin(half, x));
}

/* Of a point of the surface, which goes on evenly beyond crest and trough. */
static void point_at(const struct crest *w, long i, double p[2]) {
  const long n = (long)w->points;
  const size_t k = (size_t)(i < 0 ? -i : i > n ? 2 * n - i : i);
  p[0] = i < 0 ? -w->x[k] : i > n ? 2 * w->x[n] - w->x[k] : w->x[k];
  p[1] = w->y[k];
}

/* The polynomial through 2 NEAR points of which the middle ones are at t = 0 and 1 (J.-P. Berrut &
 * L. N. Trefethen, SIAM Rev. 46, 2004): with FINER points for each that the series needs its error
 * is below 1e-12 of the height. */
static void between(double (*p)[2], double t, double out[2]) {
  double sum[2] = {0, 0}, all = 0, weight = 1;
  for (int k = 0; k < 2 * NEAR; k++) {
    const double away = t - (k - NEAR + 1);
    if (away == 0) {
      memcpy(out, p[k], sizeof *p);
      return;
    }
    all += weight / away;
    for (int axis = 0; axis < 2; axis++) sum[axis] += weight / away * p[k][axis];
    weight *= -(2.0 * NEAR - 1 - k) / (k + 1);
  }
  for (int axis = 0; axis < 2; axis++) out[axis] = sum[axis] / all;
}

/* xi and y of the surface at x within the wave. */
static double surface_at(const struct crest *w, double x, double *y) {
  const double ahead = fmin(fabs(x), w->x[w->points]);
  size_t low = 0, high = w->points;
  while (high - low > 1) {
    const size_t middle = (low + high) / 2;
    *(w->x[middle] > ahead ? &high : &low) = middle;
  }
  double p[2 * NEAR][2], q[2];
  for (int k = 0; k < 2 * NEAR; k++) point_at(w, (long)low + k - NEAR + 1, p[k]);
  const double step = w->x[high] - w->x[low];
  double t = (ahead - w->x[low]) / step;
  for (int i = 0; i < NEWTONS; i++) {
    between(p, t, q);
    const double miss = (q[0] - ahead) / step;
    t -= miss;
    if (fabs(miss) < 1e-14 * (1 + fabs(ahead / step))) break;
  }
  between(p, t, q);
  *y = q[1];
  return copysign(w->half * ((double)low + t) / (double)w->points, x);
}

double wave_crest_elevation(const struct crest *w, double x) {
  double y;
  surface_at(w, within(w, x), &y);
  return y;
}

/* Below the surface and never above: near a sharp crest Newton's steps go beyond. */
static double complex below(double complex zeta, double complex step) {
  const double complex next = zeta - step;
  return cimag(next) > 0 ? creal(next) + I * cimag(zeta) / 2 : next;
}

struct crest_point wave_crest_at(const struct crest *w, double x, double y) {
  double top;
  const double complex z = within(w, x) + I * y;
  const double xi = surface_at(w, creal(z), &top);
  double complex slope, zeta = xi + I * fmin((1 + y) / (1 + top) - 1, 0);
  for (int i = 0; i < NEWTONS; i++) {
    const double complex step = (map(w, zeta, &slope) - z) / slope;
    zeta = below(zeta, step);
    if (cabs(step) < 1e-13) break;
  }
  map(w, zeta, &slope);
  const double complex past = w->flow / slope; /* velocity beside the crest, to the left */
  const double head =
      w->bernoulli - y - (creal(past) * creal(past) + cimag(past) * cimag(past)) / 2;
  return (struct crest_point){w->speed * creal(z) - w->flow * creal(zeta), w->speed - creal(past),
                              cimag(past), head};
}

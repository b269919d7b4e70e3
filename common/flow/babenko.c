#include "common/flow/babenko.h"

#include <fftw3.h>
#include <kinsol/kinsol.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sunlinsol/sunlinsol_spgmr.h>

#include "common/base/array.h"
#include "common/base/root.h"

enum { FEWEST = 256, MOST = 1 << 18, KRYLOV = 60, STEPS = 200 };
#define DECAYS 32 /* half of a solitary wave's period, which it does not feel, over 1/kappa */

/* Coefficients beyond the last quarter of the series, over the height: of a step, of the wave. */
static const double STEP_TAIL = 1e-8, TAIL = 3e-15;
/* Of the equation, over the height, or LEAST, below which there is nothing but rounding. */
static const double ENOUGH = 1e-11, LEAST = 1e-4;

/* ---- far away ---- */

static double slower(double kappa, const void *f2) {
  return sin(kappa) - *(const double *)f2 * kappa * cos(kappa);
}

double wave_babenko_decay(double f2) {
  return root_between(slower, &f2, 1e-3, M_PI / 2);
}

double wave_babenko_solitary_about(double a) {
  return 1 + a - a * a / 20 - 3 * a * a * a / 70;
}

/* ---- the equation, on 0 <= xi <= half, where everything is even ---- */

struct equation {
  struct babenko_wanted wanted;
  double height; /* of this step */
  double unit;   /* that the unknown `half` counts in */
  double half;   /* that c is of */
  size_t n;
  double *c, *hat, *by, *work; /* [n + 1]: k coth k; cosine transforms times 2 n */
  fftw_plan plan;              /* in place on work; applied twice it is 2 n times the identity */
};

static void equation_close(struct equation *e) {
  if (e->plan) fftw_destroy_plan(e->plan);
  free(e->c);
  free(e->hat);
  free(e->by);
  free(e->work);
}

static enum status equation_open(struct equation *e, size_t n) {
  e->n = n;
  e->half = 0;
  TRY(array_create(&e->c, n + 1, "a steady wave"));
  TRY(array_create(&e->hat, n + 1, "a steady wave"));
  TRY(array_create(&e->by, n + 1, "a steady wave"));
  TRY(array_create(&e->work, n + 1, "a steady wave"));
  e->plan =
      fftw_plan_r2r_1d((int)n + 1, e->work, e->work, FFTW_REDFT00, FFTW_ESTIMATE | FFTW_UNALIGNED);
  CHECK(e->plan, ERR_MEMORY, "no memory for a transform of %zu points", n);
  return OK;
}

static enum status equation_resize(struct equation *e, size_t n) {
  struct equation old = *e;
  *e = (struct equation){.wanted = old.wanted, .height = old.height, .unit = old.unit};
  equation_close(&old);
  return equation_open(e, n);
}

static void transform(const struct equation *e, const double *in, double *out) {
  memmove(e->work, in, (e->n + 1) * sizeof *in);
  fftw_execute(e->plan);
  memmove(out, e->work, (e->n + 1) * sizeof *out);
}

static void set_half(struct equation *e, double half) {
  if (half == e->half) return;
  e->half = half;
  e->c[0] = 1;
  for (size_t i = 1; i <= e->n; i++) {
    const double k = (double)i * M_PI / half;
    e->c[i] = k < 20 ? k / tanh(k) : k;
  }
}

/* The mean over the period in x of eta; by is C eta, whose mean is a0. */
static double mean_level(const struct equation *e, const double *eta, double a0) {
  double sum = 0;
  for (size_t i = 0; i <= e->n; i++)
    sum += (i == 0 || i == e->n ? 0.5 : 1) * eta[i] * (1 + e->by[i]);
  return sum / (double)e->n / (1 + a0);
}

/* Unknown: eta, F^2, half over its unit; besides the equation the wave has its height and length.
 */
static int residuals(N_Vector unknown, N_Vector residual, void *data) {
  struct equation *e = data;
  const double *eta = N_VGetArrayPointer(unknown), f2 = eta[e->n + 1],
               half = e->unit * eta[e->n + 2];
  double *r = N_VGetArrayPointer(residual);
  const double each = 1 / (2 * (double)e->n), length = e->wanted.length;
  if (!(half > 0 && isfinite(half))) return 1;
  set_half(e, half);
  transform(e, eta, e->hat);
  for (size_t i = 0; i <= e->n; i++) e->by[i] = e->c[i] * e->hat[i] * each;
  transform(e, e->by, e->by);
  const double a0 = e->hat[0] * each, mean = length > 0 ? mean_level(e, eta, a0) : 0;
  for (size_t i = 0; i <= e->n; i++) e->by[i] *= eta[i];
  transform(e, e->by, e->by);
  for (size_t i = 0; i <= e->n; i++) e->by[i] = (e->by[i] + e->hat[i]) / e->c[i] * each;
  transform(e, e->by, e->by);
  for (size_t i = 0; i <= e->n; i++) r[i] = f2 * eta[i] - eta[i] * eta[i] / 2 - e->by[i];
  r[e->n + 1] = eta[0] - (length > 0 ? eta[e->n] : 0) - e->height * (1 + mean);
  r[e->n + 2] = length > 0 ? 2 * half * (1 + a0) / length - (1 + mean) : half / e->unit - 1;
  return 0;
}

/* The highest derivatives of the equation. */
static int precondition(N_Vector unknown, N_Vector unknown_scale, N_Vector residual,
                        N_Vector residual_scale, N_Vector v, void *data) {
  (void)unknown_scale, (void)residual, (void)residual_scale;
  const struct equation *e = data;
  const double *eta = N_VGetArrayPointer(unknown), f2 = eta[e->n + 1];
  double *to = N_VGetArrayPointer(v);
  for (size_t i = 0; i <= e->n; i++) to[i] /= fmax(f2 - 2 * eta[i], 1e-3 * f2);
  return 0;
}

/* ---- one wave ---- */

struct newton {
  SUNContext context;
  N_Vector u, scale;
  SUNLinearSolver linear;
  void *kinsol;
};

static void newton_close(struct newton *s) {
  if (s->kinsol) KINFree(&s->kinsol);
  if (s->linear) SUNLinSolFree(s->linear);
  if (s->u) N_VDestroy(s->u);
  if (s->scale) N_VDestroy(s->scale);
  if (s->context) SUNContext_Free(&s->context);
}

/* Quiet: what counts is the residual that is left. */
static void ignore(int code, const char *module, const char *function, char *message, void *data) {
  (void)code, (void)module, (void)function, (void)message, (void)data;
}

static enum status newton_open(struct newton *s, struct equation *e) {
  CHECK(SUNContext_Create(NULL, &s->context) == 0, ERR_SOLVER, "SUNDIALS gives no context");
  s->u = N_VNew_Serial((sunindextype)e->n + 3, s->context);
  s->scale = N_VNew_Serial((sunindextype)e->n + 3, s->context);
  CHECK(s->u && s->scale, ERR_MEMORY, "no memory for KINSOL");
  s->linear = SUNLinSol_SPGMR(s->u, SUN_PREC_RIGHT, KRYLOV, s->context);
  s->kinsol = KINCreate(s->context);
  CHECK(s->linear && s->kinsol, ERR_MEMORY, "no memory for KINSOL");
  N_VConst(1 / e->height, s->scale);
  const int failed =
      KINSetErrHandlerFn(s->kinsol, ignore, NULL) || KINInit(s->kinsol, residuals, s->u) ||
      KINSetUserData(s->kinsol, e) || KINSetLinearSolver(s->kinsol, s->linear, NULL) ||
      KINSetPreconditioner(s->kinsol, NULL, precondition) ||
      KINSetEtaForm(s->kinsol, KIN_ETACONSTANT) || KINSetEtaConstValue(s->kinsol, 1e-4) ||
      KINSetNoResMon(s->kinsol, SUNTRUE) || KINSetFuncNormTol(s->kinsol, 1e-14) ||
      KINSetScaledStepTol(s->kinsol, 1e-15) || KINSetNumMaxIters(s->kinsol, 20);
  CHECK(!failed, ERR_SOLVER, "KINSOL cannot be started");
  return OK;
}

/* From b towards a wave of e's height; how much of the equation is left. */
static enum status improve(struct equation *e, struct babenko *b, double *left) {
  struct newton s = {0};
  enum status status = OK;
  ATTEMPT(newton_open(&s, e));
  double *u = N_VGetArrayPointer(s.u);
  memcpy(u, b->eta, (b->n + 1) * sizeof *u);
  u[b->n + 1] = b->f2;
  u[b->n + 2] = b->half / e->unit;
  KINSol(s.kinsol, s.u, KIN_LINESEARCH, s.scale, s.scale);
  *left = residuals(s.u, s.scale, e) ? NAN : N_VMaxNorm(s.scale) / fmax(e->height, LEAST);
  memcpy(b->eta, u, (b->n + 1) * sizeof *u);
  b->f2 = u[b->n + 1];
  b->half = u[b->n + 2] * e->unit;
done:
  newton_close(&s);
  return status;
}

/* ---- as many points as it wants ---- */

/* The largest coefficient of the last quarter of the series, over the height. */
static double tail_of(const struct equation *e, const struct babenko *b) {
  double most = 0;
  transform(e, b->eta, e->hat);
  for (size_t i = e->n - e->n / 4; i <= e->n; i++) most = fmax(most, fabs(e->hat[i]));
  return most / (double)e->n / e->height;
}

/* The same series at twice as many points. */
static enum status refine(struct equation *e, struct babenko *b) {
  const size_t n = e->n;
  double *hat = NULL;
  enum status status = OK;
  ATTEMPT(array_create(&hat, 2 * n + 1, "a steady wave"));
  transform(e, b->eta, hat);
  hat[n] /= 2;
  for (size_t i = 0; i <= n; i++) hat[i] /= 2 * (double)n;
  ATTEMPT(equation_resize(e, 2 * n));
  ATTEMPT(array_resize(&b->eta, 2 * n + 1, "a steady wave"));
  b->n = 2 * n;
  transform(e, hat, b->eta);
done:
  free(hat);
  return status;
}

/* False: there is none near b. */
static enum status reach(struct equation *e, struct babenko *b, double tail, bool *found) {
  double left = NAN;
  TRY(improve(e, b, &left));
  *found = left < ENOUGH;
  while (*found && tail_of(e, b) > tail) {
    CHECK(e->n < MOST, ERR_SOLVER, "this wave is too sharp for %zu points", e->n);
    TRY(refine(e, b));
    TRY(improve(e, b, &left));
    *found = left < ENOUGH;
  }
  return OK;
}

/* ---- from a low wave ---- */

static double lowest(const struct babenko_wanted *w) {
  if (w->length == 0) return fmin(w->height, 0.3);
  return fmin(w->height, fmin(0.2 * w->limit, 4 / (w->length * w->length)));
}

static enum status begin(struct equation *e, struct babenko *b) {
  const struct babenko_wanted *w = &e->wanted;
  e->height = lowest(w);
  TRY(equation_open(e, FEWEST));
  TRY(array_create(&b->eta, e->n + 1, "a steady wave"));
  b->n = e->n;
  if (w->length > 0) {
    const double k = 2 * M_PI / w->length;
    e->unit = b->half = w->length / 2;
    b->f2 = tanh(k) / k;
  } else {
    e->unit = b->half = DECAYS / wave_babenko_decay(wave_babenko_solitary_about(w->height));
    b->f2 = wave_babenko_solitary_about(e->height);
  }
  const double kappa = w->length > 0 ? 0 : wave_babenko_decay(b->f2);
  for (size_t i = 0; i <= e->n; i++) {
    const double part = (double)i / (double)e->n;
    b->eta[i] = e->height *
                (w->length > 0 ? cos(M_PI * part) / 2 : pow(cosh(kappa * b->half * part / 2), -2));
  }
  return OK;
}

static enum status copy(const struct babenko *of, struct babenko *to) {
  double *eta = to->eta;
  TRY(array_resize(&eta, of->n + 1, "a steady wave"));
  memcpy(eta, of->eta, (of->n + 1) * sizeof *eta);
  *to = *of;
  to->eta = eta;
  return OK;
}

/* From the wave of one height to a guess of that of another: the surface that is as many times
 * higher. */
static void stretch(struct babenko *b, double by) {
  for (size_t i = 0; i <= b->n; i++) b->eta[i] *= by;
}

/* Where a step leads to no wave, back to the last one, on its points. */
static enum status fall_back(struct equation *e, const struct babenko *last, struct babenko *b) {
  TRY(copy(last, b));
  return e->n == last->n ? OK : equation_resize(e, last->n);
}

/* Steps of half of the height, or of what is left to the highest wave, while they lead to one. */
static enum status climb(struct equation *e, struct babenko *b) {
  const double wanted = e->wanted.height, limit = e->wanted.limit;
  struct babenko last = {0};
  enum status status = OK;
  double from = 0, part = 1;
  for (int i = 0; i < STEPS; i++) {
    bool found;
    const bool there = e->height >= wanted;
    ATTEMPT(reach(e, b, there ? TAIL : STEP_TAIL, &found));
    if (found && there) goto done;
    part = found ? fmin(1, 2 * part) : part / 4;
    if (found) {
      from = e->height;
      ATTEMPT(copy(b, &last));
    } else {
      if (!last.eta) break;
      ATTEMPT(fall_back(e, &last, b));
    }
    e->height = fmin(wanted, from + part * fmin(0.5 * from, 0.5 * (limit - from)));
    stretch(b, e->height / from);
  }
  status = status_raise(ERR_SOLVER, "no steady wave of height %g was found", wanted);
done:
  wave_babenko_destroy(&last);
  return status;
}

enum status wave_babenko_solve(const struct babenko_wanted *wanted, struct babenko *b) {
  struct equation e = {.wanted = *wanted};
  enum status status = OK;
  *b = (struct babenko){0};
  ATTEMPT(begin(&e, b));
  ATTEMPT(climb(&e, b));
done:
  equation_close(&e);
  return status;
}

void wave_babenko_destroy(struct babenko *b) {
  free(b->eta);
  b->eta = NULL;
}

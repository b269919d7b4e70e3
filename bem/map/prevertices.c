/* Unknown are the logarithms of the ratios of neighbouring gaps between prevertices, which may be
 * anything, so that prevertices stay in order; wanted are the ratios of neighbouring sides. KINSOL
 * (Newton with line search) finds them. */
#include "bem/map/prevertices.h"

#include <kinsol/kinsol.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdbool.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

static const double WANTED = 1e-13, ENOUGH = 1e-11; /* of the logarithm of a ratio of sides */

static double side(const struct bem_conformal *m, size_t k) {
  return cabs(m->point[k + 2] - m->point[k + 1]);
}

/* From -1 to 1, gaps in ratios exp(u); a single one, and the width of two, are free. */
static void place(struct bem_conformal *m, const double *u) {
  double width = 1, at = 1;
  m->xi[0] = 0;
  for (size_t k = 1; k < m->n; k++) {
    m->xi[k] = at;
    if (k + 1 < m->n) at += width *= exp(u[k - 1]);
  }
  const double middle = 0.5 * m->xi[m->n - 1], half = m->n > 1 ? middle : 1;
  for (size_t k = 0; k < m->n; k++) m->xi[k] = (m->xi[k] - middle) / half;
}

static int residuals(N_Vector unknown, N_Vector residual, void *data) {
  struct bem_conformal *m = data;
  double *r = N_VGetArrayPointer(residual);
  place(m, N_VGetArrayPointer(unknown));
  double last = log(bem_conformal_length(m, 0) / side(m, 0));
  for (size_t k = 1; k + 1 < m->n; k++) {
    const double next = log(bem_conformal_length(m, k) / side(m, k));
    if (!isfinite(next - last)) return 1;
    r[k - 1] = next - last;
    last = next;
  }
  return 0;
}

struct problem {
  SUNContext context;
  N_Vector u, scale;
  SUNMatrix jacobian;
  SUNLinearSolver linear;
  void *kinsol;
};

static void close_problem(struct problem *p) {
  if (p->kinsol) KINFree(&p->kinsol);
  if (p->linear) SUNLinSolFree(p->linear);
  if (p->jacobian) SUNMatDestroy(p->jacobian);
  if (p->u) N_VDestroy(p->u);
  if (p->scale) N_VDestroy(p->scale);
  if (p->context) SUNContext_Free(&p->context);
}

/* Quiet: what counts is the residual that is left. */
static void ignore(int code, const char *module, const char *function, char *message, void *data) {
  (void)code, (void)module, (void)function, (void)message, (void)data;
}

static enum status open_problem(struct problem *p, struct bem_conformal *m) {
  const sunindextype n = (sunindextype)m->n - 2;
  CHECK(SUNContext_Create(NULL, &p->context) == 0, ERR_SOLVER, "SUNDIALS gives no context");
  p->u = N_VNew_Serial(n, p->context);
  p->scale = N_VNew_Serial(n, p->context);
  p->jacobian = SUNDenseMatrix(n, n, p->context);
  CHECK(p->u && p->scale && p->jacobian, ERR_MEMORY, "no memory for KINSOL");
  p->linear = SUNLinSol_Dense(p->u, p->jacobian, p->context);
  p->kinsol = KINCreate(p->context);
  CHECK(p->linear && p->kinsol, ERR_MEMORY, "no memory for KINSOL");
  N_VConst(1, p->scale);
  const int failed =
      KINSetErrHandlerFn(p->kinsol, ignore, NULL) || KINInit(p->kinsol, residuals, p->u) ||
      KINSetUserData(p->kinsol, m) || KINSetLinearSolver(p->kinsol, p->linear, p->jacobian) ||
      KINSetFuncNormTol(p->kinsol, WANTED) || KINSetScaledStepTol(p->kinsol, 1e-15) ||
      KINSetMaxSetupCalls(p->kinsol, 1) || KINSetMaxNewtonStep(p->kinsol, 10);
  CHECK(!failed, ERR_SOLVER, "KINSOL cannot be started");
  return OK;
}

static enum status solve(struct problem *p, struct bem_conformal *m, bool follow) {
  TRY(open_problem(p, m));
  double *u = N_VGetArrayPointer(p->u);
  for (size_t k = 0; k + 2 < m->n; k++)
    u[k] = follow ? log((m->xi[k + 2] - m->xi[k + 1]) / (m->xi[k + 1] - m->xi[k]))
                  : log(side(m, k + 1) / side(m, k));
  KINSol(p->kinsol, p->u, KIN_LINESEARCH, p->scale, p->scale);
  const int failed = residuals(p->u, p->scale, m);
  const double left = N_VMaxNorm(p->scale);
  CHECK(!failed && left < ENOUGH, ERR_SOLVER,
        "no conformal map of the tank is found: the lengths of its sides are wrong by %.2g; walls "
        "with fewer bends, or without long narrow pits, may help",
        left);
  return OK;
}

static enum status find(struct bem_conformal *m, bool follow) {
  const double complex up = m->point[m->n + 1] - m->point[m->n];
  enum status status = OK;
  m->factor = 1;
  if (m->n > 2) {
    struct problem p = {0};
    status = solve(&p, m, follow);
    close_problem(&p);
  } else {
    place(m, NULL);
  }
  double is = m->n > 1 ? 0 : 1, wanted = is;
  for (size_t k = 0; k + 1 < m->n; k++) {
    is += bem_conformal_length(m, k);
    wanted += side(m, k);
  }
  m->factor = wanted / is * up / cabs(up);
  return status;
}

enum status bem_prevertices_find(struct bem_conformal *m) {
  return find(m, false);
}

enum status bem_prevertices_follow(struct bem_conformal *m) {
  return find(m, true);
}

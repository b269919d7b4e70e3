#include "bem/run/stepper.h"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <stdlib.h>
#include <string.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

struct bem_stepper {
  struct bem_flow *flow;
  double tolerance;
  const struct bem_roots *roots;
  void *data;
  int *found, *direction; /* [roots->n] */
  SUNContext context;
  void *cvode;
  N_Vector state, view; /* view: borrows the memory that an interpolation fills */
  SUNNonlinearSolver iteration;
  struct bem_stepper_counts count; /* of the integrators that have been closed */
};

static int rates(realtype time, N_Vector y, N_Vector rate, void *data) {
  struct bem_stepper *s = data;
  s->flow->status = bem_flow_rates(s->flow, time, N_VGetArrayPointer(y), N_VGetArrayPointer(rate));
  if (s->flow->status == OK) return 0;
  return s->flow->status == ERR_MEMORY ? -1 : 1; /* 1: CVODE may try a smaller step */
}

static int find_roots(realtype time, N_Vector y, realtype *root, void *data) {
  struct bem_stepper *s = data;
  if (bem_flow_move(s->flow, time) != OK) return -1;
  s->roots->find(s->data, time, N_VGetArrayPointer(y), root);
  return 0;
}

enum status bem_stepper_create(struct bem_flow *flow, double tolerance,
                               const struct bem_roots *roots, void *data,
                               struct bem_stepper **out) {
  struct bem_stepper *s = calloc(1, sizeof *s);
  CHECK(s, ERR_MEMORY, "no memory for the time integrator");
  s->flow = flow;
  s->tolerance = tolerance;
  s->roots = roots;
  s->data = data;
  *out = s;
  s->found = calloc((size_t)roots->n, sizeof *s->found);
  s->direction = calloc((size_t)roots->n, sizeof *s->direction);
  CHECK(s->found && s->direction, ERR_MEMORY, "no memory for the time integrator");
  for (int i = 0; i < roots->n; i++) s->direction[i] = -1;
  CHECK(SUNContext_Create(NULL, &s->context) == 0, ERR_SOLVER, "SUNDIALS gives no context");
  return OK;
}

struct bem_stepper_counts bem_stepper_count(const struct bem_stepper *s) {
  struct bem_stepper_counts c = s->count;
  long steps = 0, evaluations = 0;
  if (s->cvode) {
    CVodeGetNumSteps(s->cvode, &steps);
    CVodeGetNumRhsEvals(s->cvode, &evaluations);
  }
  c.steps += (double)steps;
  c.evaluations += (double)evaluations;
  return c;
}

static void close_integrator(struct bem_stepper *s) {
  s->count = bem_stepper_count(s);
  if (s->cvode) CVodeFree(&s->cvode);
  if (s->iteration) SUNNonlinSolFree(s->iteration);
  if (s->state) N_VDestroy(s->state);
  if (s->view) N_VDestroy(s->view);
  s->iteration = NULL;
  s->state = s->view = NULL;
}

void bem_stepper_destroy(struct bem_stepper *s) {
  if (!s) return;
  close_integrator(s);
  if (s->context) SUNContext_Free(&s->context);
  free(s->found);
  free(s->direction);
  free(s);
}

/* Quiet: the status that comes back says it all. */
static void ignore(int code, const char *module, const char *function, char *message, void *data) {
  (void)code, (void)module, (void)function, (void)message, (void)data;
}

enum status bem_stepper_restart(struct bem_stepper *s, double time) {
  close_integrator(s);
  TRY(bem_flow_reserve(s->flow, s->flow->surface.n));
  s->state =
      N_VMake_Serial((sunindextype)(3 * s->flow->surface.n), s->flow->surface.state, s->context);
  s->view = s->state ? N_VCloneEmpty(s->state) : NULL;
  s->iteration = s->state ? SUNNonlinSol_FixedPoint(s->state, 0, s->context) : NULL;
  s->cvode = CVodeCreate(CV_ADAMS, s->context);
  CHECK(s->view && s->iteration && s->cvode, ERR_MEMORY, "no memory for CVODE");
  CVodeSetErrHandlerFn(s->cvode, ignore, NULL);
  int failed =
      CVodeInit(s->cvode, rates, time, s->state) || CVodeSStolerances(s->cvode, 0, s->tolerance) ||
      CVodeSetUserData(s->cvode, s) || CVodeSetNonlinearSolver(s->cvode, s->iteration) ||
      CVodeRootInit(s->cvode, s->roots->n, find_roots) ||
      CVodeSetRootDirection(s->cvode, s->direction) || CVodeSetNoInactiveRootWarn(s->cvode);
  CHECK(!failed, ERR_SOLVER, "CVODE cannot be started");
  s->count.initialisations++;
  return OK;
}

enum status bem_stepper_step(struct bem_stepper *s, double *time, double *dt, const int **found) {
  double before = *time;
  memset(s->found, 0, (size_t)s->roots->n * sizeof *s->found);
  *found = s->found;
  s->flow->status = OK;
  int code = CVode(s->cvode, *time + 1, s->state, time, CV_ONE_STEP);
  if (code == CV_ROOT_RETURN) CVodeGetRootInfo(s->cvode, s->found);
  if (code < 0 && s->flow->status != OK) return s->flow->status;
  CHECK(code >= 0, ERR_SOLVER, "the flow cannot be followed any further (%s)",
        CVodeGetReturnFlagName(code));
  *dt = *time - before;
  return bem_flow_move(s->flow, *time);
}

enum status bem_stepper_interpolate(struct bem_stepper *s, double time, double *state) {
  N_VSetArrayPointer(state, s->view);
  int code = CVodeGetDky(s->cvode, time, 0, s->view);
  CHECK(code == CV_SUCCESS, ERR_SOLVER, "CVODE cannot interpolate to time %.6g (status %d)", time,
        code);
  return OK;
}

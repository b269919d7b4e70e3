#include "bem/kernel/solve.h"

#include <lapack.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>
#include <sunlinsol/sunlinsol_spgmr.h>

#include "bem/kernel/integrals.h"
#include "common/base/array.h"

/* OpenBLAS's, absent from other libraries. */
extern void openblas_set_num_threads(int n) __attribute__((weak));

enum { KRYLOV = 80, RESTARTS = 3 };

struct bem_solve {
  struct bem_solve_options options;
  struct bem_solve_counts count;
  size_t n, room;                  /* unknowns, allocated for */
  size_t ends;                     /* nodes before the first unknown, and after the last */
  double *a;                       /* matrix by rows, [n][n] */
  double *b;                       /* coefficients of phi by rows, [n][nodes], when kept */
  double *row;                     /* scratch, two rows a thread */
  double *f, *x;                   /* right-hand side and solution, [n] */
  const struct bem_panels *panels; /* of the last assembly */
  int dense;
  lapack_int *pivot;

  SUNContext context;
  N_Vector vector_f, vector_x;
  SUNLinearSolver gmres;
};

static int multiply(void *data, N_Vector v, N_Vector z) {
  struct bem_solve *s = data;
  const size_t n = s->n;
  const double *x = N_VGetArrayPointer(v);
  double *y = N_VGetArrayPointer(z);
#pragma omp parallel for schedule(static) if (n >= BEM_PARALLEL)
  for (size_t k = 0; k < n; k++) {
    const double *a = s->a + k * n;
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (size_t m = 0; m < n; m++) sum += a[m] * x[m];
    y[k] = sum;
  }
  return 0;
}

enum status bem_solve_create(const struct bem_solve_options *options, struct bem_solve **out) {
  struct bem_solve *s = calloc(1, sizeof *s);
  CHECK(s, ERR_MEMORY, "no memory for the linear solver");
  s->options = *options;
  *out = s;
  /* Its own threads change the last bits with their number. */
  if (openblas_set_num_threads) openblas_set_num_threads(1);
  CHECK(SUNContext_Create(NULL, &s->context) == 0, ERR_SOLVER, "SUNDIALS gives no context");
  return OK;
}

static void vectors_destroy(struct bem_solve *s) {
  if (s->gmres) SUNLinSolFree(s->gmres);
  if (s->vector_f) N_VDestroy(s->vector_f);
  if (s->vector_x) N_VDestroy(s->vector_x);
  s->gmres = NULL;
  s->vector_f = s->vector_x = NULL;
}

static void arrays_destroy(struct bem_solve *s) {
  free(s->a);
  free(s->b);
  free(s->row);
  free(s->f);
  free(s->x);
  free(s->pivot);
  s->a = s->b = s->row = s->f = s->x = NULL;
  s->pivot = NULL;
  s->room = 0;
}

void bem_solve_destroy(struct bem_solve *s) {
  if (!s) return;
  vectors_destroy(s);
  arrays_destroy(s);
  if (s->context) SUNContext_Free(&s->context);
  free(s);
}

struct bem_solve_counts bem_solve_count(const struct bem_solve *s) {
  return s->count;
}

/* Arrays and SUNDIALS handles for n unknowns. */
static enum status resize(struct bem_solve *s, size_t n) {
  if (n == s->n) return OK;
  if (n > s->room) {
    size_t room = n + n / 4;
    const char *what = "numbers of a boundary system";
    arrays_destroy(s);
    TRY(array_create(&s->a, room * room, what));
    TRY(array_create(&s->row, 2 * (room + 2) * (size_t)omp_get_max_threads(), what));
    TRY(array_create(&s->f, room, what));
    TRY(array_create(&s->x, room, what));
    TRY(array_create(&s->pivot, room, what));
    s->room = room;
  }
  s->n = n;
  s->dense = n + 2 <= s->options.dense_up_to;
  vectors_destroy(s);
  if (s->dense) return OK;
  s->vector_f = N_VMake_Serial((sunindextype)n, s->f, s->context);
  s->vector_x = N_VMake_Serial((sunindextype)n, s->x, s->context);
  CHECK(s->vector_f && s->vector_x, ERR_MEMORY, "no memory for vectors of %zu unknowns", n);
  s->gmres = SUNLinSol_SPGMR(s->vector_x, SUN_PREC_NONE, KRYLOV, s->context);
  CHECK(s->gmres, ERR_MEMORY, "no memory for GMRES with %zu unknowns", n);
  SUNLinSol_SPGMRSetMaxRestarts(s->gmres, RESTARTS);
  SUNLinSolSetATimes(s->gmres, s, multiply);
  CHECK(SUNLinSolInitialize(s->gmres) == 0 && SUNLinSolSetup(s->gmres, NULL) == 0, ERR_SOLVER,
        "GMRES cannot be set up for %zu unknowns", n);
  return OK;
}

static size_t count_nodes(const struct bem_solve *s) {
  return s->n + 2 * s->ends;
}

/* Row k belongs to the inner node k + ends. The right-hand side is summed while the row is at hand.
 */
static enum status assemble(struct bem_solve *s, const double *phi, int keep) {
  const struct bem_panels *p = s->panels;
  const size_t n = s->n, ends = s->ends, nodes = count_nodes(s);
  if (keep && !s->b)
    TRY(array_create(&s->b, s->room * (s->room + 2), "numbers of a boundary system"));
#pragma omp parallel for schedule(dynamic, 8)
  for (size_t k = 0; k < n; k++) {
    double *a = s->row + 2 * (n + 2) * (size_t)omp_get_thread_num();
    double *b = keep ? s->b + k * nodes : a + nodes;
    bem_integrals_row(p, k + ends, a, b);
    memcpy(s->a + k * n, a + ends, n * sizeof *a);
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (size_t m = 0; m < nodes; m++) sum += b[m] * phi[m];
    s->f[k] = sum;
  }
  s->count.assemblies++;
  return OK;
}

static enum status iterate(struct bem_solve *s) {
  double norm = sqrt(N_VDotProd(s->vector_f, s->vector_f));
  if (norm == 0) {
    N_VConst(0, s->vector_x);
    return OK;
  }
  CHECK(isfinite(norm), ERR_DIVERGED, "the right-hand side of the boundary system is not finite");
  int failed =
      SUNLinSolSolve(s->gmres, NULL, s->vector_x, s->vector_f, s->options.tolerance * norm);
  int iterations = SUNLinSolNumIters(s->gmres);
  s->count.iterations += iterations;
  CHECK(failed == 0, ERR_SOLVER, "GMRES stopped after %d iterations at a relative residual of %.2g",
        iterations, SUNLinSolResNorm(s->gmres) / norm);
  return OK;
}

static enum status finish(struct bem_solve *s, double *psi) {
  const size_t n = s->n;
  if (s->dense) {
    lapack_int size = (lapack_int)n, one = 1, info;
    memcpy(s->x, s->f, n * sizeof *s->x);
    LAPACK_dgetrs("T", &size, &one, s->a, &size, s->pivot, s->x, &size, &info);
  } else {
    memcpy(s->x, psi + s->ends, n * sizeof *s->x);
    TRY(iterate(s));
  }
  memcpy(psi + s->ends, s->x, n * sizeof *s->x);
  if (s->ends) psi[0] = psi[n + 1] = 0;
  return OK;
}

enum status bem_solve_first(struct bem_solve *s, const struct bem_panels *p, const double *phi,
                            double *psi, int keep) {
  s->ends = p->period.length > 0 ? 0 : 1;
  TRY(resize(s, p->n - 2 * s->ends));
  s->panels = p;
  TRY(assemble(s, phi, keep));
  if (s->dense) {
    lapack_int size = (lapack_int)s->n, info;
    LAPACK_dgetrf(&size, &size, s->a, &size, s->pivot, &info);
    CHECK(info == 0, ERR_SOLVER, "the boundary system of %d unknowns is singular", size);
    s->count.dense_factorisations++;
  }
  return finish(s, psi);
}

enum status bem_solve_again(struct bem_solve *s, const double *phi, double *psi) {
  const size_t n = s->n, nodes = count_nodes(s);
  for (size_t k = 0; k < n; k++) {
    const double *b = s->b + k * nodes;
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (size_t m = 0; m < nodes; m++) sum += b[m] * phi[m];
    s->f[k] = sum;
  }
  return finish(s, psi);
}

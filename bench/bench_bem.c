/* Speed of the boundary-element solver: what one solution for psi costs, by number of nodes: the
 * rows of the matrix alone, all of it with the dense factorisation, and all of it with
 * GMRES from a guess of zero; and how each grows. The surface is a steep wave over
 * three lengths.
 *
 *   bench_bem [most nodes, default 2000]
 *
 * Medians of repeats. On one thread the processor's time is taken, which a busy machine does not
 * lengthen; on more, the time of the clock on the wall. */
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bem/kernel/integrals.h"
#include "bem/kernel/solve.h"
#include "bench/bench.h"
#include "common/base/array.h"

enum { REPEATS = 7 };

struct system {
  struct bem_panels panels;
  struct bem_solve *dense, *gmres;
  double *phi, *psi, *a, *b;
};

static enum status rows(struct system *s) {
  for (size_t k = 1; k + 1 < s->panels.n; k++) bem_integrals_row(&s->panels, k, s->a, s->b);
  return OK;
}

static enum status dense(struct system *s) {
  return bem_solve_first(s->dense, &s->panels, s->phi, s->psi, 0);
}

static enum status gmres(struct system *s) {
  memset(s->psi, 0, s->panels.n * sizeof *s->psi);
  return bem_solve_first(s->gmres, &s->panels, s->phi, s->psi, 0);
}

/* Median in seconds; the first call, which allocates and factorises, is not counted. */
static double median(enum status (*work)(struct system *), struct system *s) {
  double t[REPEATS];
  for (int i = -1; i < REPEATS; i++) {
    double start = bench_seconds();
    if (work(s) != OK) {
      fprintf(stderr, "bench_bem: %s\n", status_message());
      exit(1);
    }
    if (i >= 0) t[i] = bench_seconds() - start;
  }
  qsort(t, REPEATS, sizeof *t, array_ascending);
  return t[REPEATS / 2];
}

static enum status measure(size_t n, const double before[3], double now[3]) {
  const double length = 3;
  struct system s = {0};
  double *x = malloc(6 * n * sizeof *x), *y = x + n;
  CHECK(x, ERR_MEMORY, "no memory for %zu nodes", n);
  s.phi = y + n, s.psi = s.phi + n, s.a = s.psi + n, s.b = s.a + n;
  for (size_t k = 0; k < n; k++) {
    x[k] = length * (double)k / (double)(n - 1);
    y[k] = 0.5 + 0.06 * cos(2 * M_PI * x[k]);
    s.phi[k] = cos(2 * M_PI * x[k]) + 0.2 * sin(7 * x[k]);
  }
  TRY(bem_solve_create(&(struct bem_solve_options){1e-9, n}, &s.dense));
  TRY(bem_solve_create(&(struct bem_solve_options){1e-9, 0}, &s.gmres));
  TRY(bem_panels_reserve(&s.panels, n));
  bem_panels_set(&s.panels, n, x, y, 0, length);
  now[0] = median(rows, &s), now[1] = median(dense, &s), now[2] = median(gmres, &s);
  struct bem_solve_counts c = bem_solve_count(s.gmres);
  printf("%6zu %10.3f %10.3f %10.3f %8.1f %10.1f", n, 1e3 * now[0], 1e3 * now[1], 1e3 * now[2],
         c.iterations / c.assemblies, 1e9 * now[0] / (double)(n * n));
  for (int i = 0; i < 3 && before[0] > 0; i++) printf(" %6.2f", log2(now[i] / before[i]));
  printf("\n");
  bem_solve_destroy(s.dense);
  bem_solve_destroy(s.gmres);
  bem_panels_destroy(&s.panels);
  free(x);
  return OK;
}

int main(int argc, char **argv) {
  size_t most = argc > 1 ? strtoul(argv[1], NULL, 10) : 2000;
  double before[3] = {0}, now[3];
  printf("%d threads; milliseconds; growth as the exponent of the number of nodes\n",
         omp_get_max_threads());
  printf("%6s %10s %10s %10s %8s %10s %20s\n", "nodes", "rows", "dense", "gmres", "iter.",
         "ns/pair", "growth of the three");
  for (size_t n = 32; n <= most; n *= 2) {
    if (measure(n, before, now) != OK) {
      fprintf(stderr, "bench_bem: %s\n", status_message());
      return 1;
    }
    memcpy(before, now, sizeof before);
  }
  return 0;
}

/* The same bits for any number of threads: rows of the matrix and of its products are summed by one
 * thread each, and the libraries underneath are kept to one. */
#include <omp.h>

#include "bem/kernel/solve.h"
#include "tests/bem/run.h"

extern void openblas_set_num_threads(int n) __attribute__((weak));

static const char text[] =
    "title: dam break\n"
    "fluid: {density: 1, gravity: 1}\n"
    "scales: {H: 1}\n"
    "tank: {walls: [[[0, 4], [0, 0], [2.4, 0], [2.4, 4]]]}\n"
    "water: {regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]], pressure: released}\n"
    "time: {end: 1.4, every: 0.7, sample: 0.1}\n"
    "probes: [{name: P1, at: [0, 0.266]}]\n"
    "runs: [{name: bem, solver: bem, resolution: 30, dense: %d}]\n";

static void test_result_does_not_depend_on_the_number_of_threads(void) {
  for (int dense = 0; dense <= 1000; dense += 1000) {
    char with[sizeof text + 20];
    struct result_file *f[2];
    snprintf(with, sizeof with, text, dense);
    for (int i = 0; i < 2; i++) {
      omp_set_num_threads(i ? 3 : 1);
      f[i] = run_bem(with);
    }
    if (!f[0] || !f[1]) return;
    EXPECT(f[0]->n_energy > 10 && f[0]->n_energy == f[1]->n_energy);
    for (size_t i = 0; i < f[0]->n_energy; i++) {
      EXPECT(f[0]->energy[i].kinetic == f[1]->energy[i].kinetic);
      EXPECT(f[0]->probes[0].value[i] == f[1]->probes[0].value[i]);
    }
    for (int i = 0; i < 2; i++) result_file_destroy(f[i]);
  }
}

/* Large enough for OpenBLAS to share it out, which it does from about a hundred unknowns. */
static void test_dense_solution_does_not_depend_on_the_threads_of_lapack(void) {
  enum { N = 300 };
  double x[N], y[N], phi[N], psi[2][N];
  for (size_t k = 0; k < N; k++) {
    x[k] = (double)k / (N - 1);
    y[k] = 0.5 + 0.05 * cos(M_PI * x[k]);
    phi[k] = cos(7 * x[k]);
  }
  struct bem_panels p = {0};
  EXPECT_OK(bem_panels_reserve(&p, N));
  bem_panels_set(&p, N, x, y, 0, 1);
  for (int i = 0; i < 2; i++) {
    struct bem_solve *s;
    if (openblas_set_num_threads) openblas_set_num_threads(i ? 3 : 1);
    EXPECT_OK(bem_solve_create(&(struct bem_solve_options){1e-9, N}, &s));
    EXPECT_OK(bem_solve_first(s, &p, phi, psi[i], 0));
    bem_solve_destroy(s);
  }
  EXPECT(memcmp(psi[0], psi[1], sizeof psi[0]) == 0);
  bem_panels_destroy(&p);
}

int main(void) {
  RUN(test_dense_solution_does_not_depend_on_the_threads_of_lapack);
  RUN(test_result_does_not_depend_on_the_number_of_threads);
  return TEST_RESULT;
}

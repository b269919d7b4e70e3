/* The same bits for any number of threads: rows of the matrix and of its products are summed by one
 * thread each. */
#include <omp.h>

#include "tests/bem/run.h"

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

int main(void) {
  RUN(test_result_does_not_depend_on_the_number_of_threads);
  return TEST_RESULT;
}

/* A file of measured values that a case names. */
#include <math.h>
#include <string.h>

#include "cli/registry.h"
#include "common/case/case.h"
#include "fuzz/fuzz.h"

enum { CASE_FILE = 101 };
static const char base[] =
    "scales: {H: 0.6}\n"
    "tank: {walls: [[[0, 3], [0, 0], [5.366, 0], [5.366, 3]]]}\n"
    "water: {regions: [[[0, 0], [2, 0], [2, 1], [0, 1]]]}\n"
    "time: {end: 8, every: 0.5}\n"
    "runs: [{name: a, solver: sph, resolution: 20}]\n"
    "compare: {experiments: [{label: x, source: y, target: front, file: " FUZZ_PATH "}]}\n";

int LLVMFuzzerInitialize(int *argc, char ***argv) {
  (void)argc, (void)argv;
  fuzz_file_create(FUZZ_FILE);
  fuzz_file_fill(fuzz_file_create(CASE_FILE), base, sizeof base - 1);
  return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  struct problems problems;
  struct case_file *c = NULL;
  fuzz_file_fill(FUZZ_FILE, data, size);
  if (case_load("/proc/self/fd/101", 0, NULL, &registry, &problems, &c) == OK) {
    const struct case_experiment *e = &c->compare.experiments[0];
    for (size_t i = 0; i < e->n; i++)
      if (!isfinite(e->t[i]) || !isfinite(e->value[i]) || (i && e->t[i] < e->t[i - 1])) abort();
  } else if (!problems.n && !problems.out_of_memory) {
    abort();
  }
  problems_destroy(&problems);
  case_destroy(c);
  return 0;
}

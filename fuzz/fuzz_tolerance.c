/* A tolerance file of `plunge diff`. */
#include <math.h>
#include <stdlib.h>

#include "common/result/result_tolerance.h"
#include "fuzz/fuzz.h"

int LLVMFuzzerInitialize(int *argc, char ***argv) {
  (void)argc, (void)argv;
  fuzz_file_create(FUZZ_FILE);
  return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const char *const names[] = {"series/energy/total", "VTKHDF/PointData/pressure", "@title"};
  struct result_tolerances t;
  fuzz_file_fill(FUZZ_FILE, data, size);
  if (result_tolerances_default(&t, 0, 0) != OK) abort();
  if (result_tolerances_read(&t, FUZZ_PATH) == OK)
    for (int i = 0; i < 3; i++) {
      const struct tolerance **rule = calloc(t.n, sizeof *rule);
      if (!rule) abort();
      const size_t n = result_tolerances_match(&t, names[i], rule);
      const struct tolerance *found = result_tolerance_at(n, rule, i - 1, 0.25);
      if (!found || !(found->relative >= 0) || !isfinite(found->relative)) abort();
      if (!(found->absolute >= 0) || !isfinite(found->absolute)) abort();
      free(rule);
    }
  result_tolerances_destroy(&t);
  return 0;
}

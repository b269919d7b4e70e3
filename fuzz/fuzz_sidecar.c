/* The sidecar of an import. */
#include "cli/registry.h"
#include "fuzz/fuzz.h"
#include "import/sidecar.h"

int LLVMFuzzerInitialize(int *argc, char ***argv) {
  (void)argc, (void)argv;
  fuzz_file_create(FUZZ_FILE);
  return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  struct problems problems;
  struct import_sidecar *s = NULL;
  fuzz_file_fill(FUZZ_FILE, data, size);
  if (import_sidecar_load(FUZZ_PATH, &registry, &problems, &s) == OK) {
    if (!(s->spacing > 0) || !(s->scales->H > 0) || !(s->unit.length > 0)) abort();
    if (!s->profiles.given && !s->grid.given && !s->particles.given) abort();
  } else if (!problems.n && !problems.out_of_memory) {
    abort(); /* refused without a word */
  }
  problems_destroy(&problems);
  import_sidecar_destroy(s);
  return 0;
}

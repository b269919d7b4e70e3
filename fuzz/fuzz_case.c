/* The text of a case, with the program's own solvers and measures. */
#include <string.h>

#include "cli/registry.h"
#include "common/case/case.h"
#include "fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  char *text = malloc(size + 1);
  struct problems problems;
  struct case_file *c = NULL;
  memcpy(text, data, size);
  text[size] = 0;
  if (case_parse("case.yaml", text, &registry, &problems, &c) == OK) {
    char fingerprint[33];
    for (size_t i = 0; i < c->n_runs; i++) {
      char *settings = NULL;
      case_fingerprint(c, &c->runs[i], fingerprint);
      if (case_run_settings(text, 1, (const char *const *)&c->runs[i].name, &settings) == OK &&
          !settings)
        abort(); /* a run of a sound case has them */
      free(settings);
    }
    case_water_fingerprint(c, fingerprint);
    if (c->gravity > 0 && !(case_rest_potential(c) > 0))
      abort(); /* what the result file promises */
  } else if (!problems.n && !problems.out_of_memory) {
    abort(); /* refused without a word */
  }
  problems_destroy(&problems);
  case_destroy(c);
  free(text);
  return 0;
}

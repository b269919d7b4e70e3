/* Overrides of a case on the command line, one a line. */
#include <string.h>

#include "cli/registry.h"
#include "common/case/case.h"
#include "fuzz/fuzz.h"

static const char base[] =
    "title: base\n"
    "fluid: {density: 1000}\n"
    "scales: {H: 0.6}\n"
    "tank: {walls: [[[0, 3], [0, 0], [5.366, 0], [5.366, 3]]]}\n"
    "water: {regions: [[[0, 0], [2, 0], [2, 1], [0, 1]]]}\n"
    "time: {end: 8, every: 0.5}\n"
    "probes: [{name: P1, at: [5.366, 0.2]}]\n"
    "gauges: [{name: G1, x: 1.5}]\n"
    "runs: [{name: ref, solver: bem, resolution: 30}, {name: a, solver: sph, resolution: 20}]\n"
    "compare: {times: [2, 4], tolerances: [{measure: front, below: 0.3}]}\n";

int LLVMFuzzerInitialize(int *argc, char ***argv) {
  (void)argc, (void)argv;
  fuzz_file_fill(fuzz_file_create(FUZZ_FILE), base, sizeof base - 1);
  return 0;
}

/* The text as run, which the result keeps, is the same case. */
static void check_text(const struct case_file *c) {
  struct problems problems;
  struct case_file *same = NULL;
  char a[33], b[33];
  if (case_parse(FUZZ_PATH, c->text, &registry, &problems, &same) != OK) abort();
  if (same->n_runs != c->n_runs) abort();
  for (size_t i = 0; i < c->n_runs; i++) {
    case_fingerprint(c, &c->runs[i], a);
    case_fingerprint(same, &same->runs[i], b);
    if (strcmp(a, b)) abort();
  }
  problems_destroy(&problems);
  case_destroy(same);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  enum { MOST = 16 };
  const char *set[MOST];
  char *text = malloc(size + 1), *rest = text, *line;
  size_t n = 0;
  memcpy(text, data, size);
  text[size] = 0;
  while (n < MOST && (line = strsep(&rest, "\n"))) set[n++] = line;
  struct problems problems;
  struct case_file *c = NULL;
  if (case_load(FUZZ_PATH, n, set, &registry, &problems, &c) == OK)
    check_text(c);
  else if (!problems.n && !problems.out_of_memory)
    abort(); /* refused without a word */
  problems_destroy(&problems);
  case_destroy(c);
  free(text);
  return 0;
}

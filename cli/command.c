#include "cli/command.h"

#include <stdio.h>

#include "cli/registry.h"

int command_fail(enum status status) {
  fprintf(stderr, "plunge: %s\n", status_message());
  return status_exit_code(status);
}

struct case_file *command_load_case(const char *path, size_t n_set, const char *const *set) {
  struct problems problems = {0};
  struct case_file *c = NULL;
  if (case_load(path, n_set, set, &registry, &problems, &c) != OK) {
    for (size_t i = 0; i < problems.n; i++) fprintf(stderr, "%s\n", problems.text[i]);
    if (!problems.n) command_fail(ERR_INPUT);
  }
  problems_destroy(&problems);
  return c;
}

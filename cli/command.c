#include "cli/command.h"

#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/registry.h"

int command_fail(enum status status) {
  fprintf(stderr, "plunge: %s\n", status_message());
  return status_exit_code(status);
}

int command_finish(int exit_code) {
  struct stat out;
  if (!fflush(stdout) && !ferror(stdout)) return exit_code;
  if (!fstat(STDOUT_FILENO, &out) && S_ISFIFO(out.st_mode))
    return exit_code; /* a reader that has had enough, as in `plunge list | head` */
  fputs("plunge: cannot write the output; is the disk full?\n", stderr);
  return exit_code == EXIT_BAD_INPUT ? exit_code : EXIT_RUN_FAILED;
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

/* Dispatches to a subcommand; nothing else happens here. */
#include <argp.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

#include "cli/command.h"
#include "cli/start.h"
#include "revision.h"

const char *argp_program_version = "plunge " PLUNGE_VERSION " (" PLUNGE_REVISION ")";

static void print_help(FILE *out) {
  fputs("Usage: plunge COMMAND [OPTION...] FILE...\n"
        "How far is an SPH run of breaking waves from the potential-flow solution?\n\n",
        out);
#define X(name, args, help) fprintf(out, "  plunge %-7s %-18s %s\n", #name, args, help);
  COMMANDS(X)
#undef X
  fputs("\nA case file describes tank and water, the runs (sweeps over any key among them), what "
        "they\n"
        "write (probes, gauges, points, forces on walls) and how they are compared (tolerances,\n"
        "experiments, events against published numbers). `plunge list` prints its keys,\n"
        "docs/case-file.md explains them.\n",
        out);
  fputs("\n`plunge COMMAND --help` tells more. Exit codes: 0 fine, 1 the verdict is \"fails\" or\n"
        "\"differs\", 2 usage or bad input, 3 a run failed or was stopped.\n",
        out);
}

int main(int argc, char **argv) {
  start_fill_descriptors();
  argp_err_exit_status = EXIT_BAD_INPUT;
  signal(SIGXFSZ, SIG_IGN); /* a file-size limit is then an error of the write, which says so */
  signal(SIGPIPE, SIG_IGN);
  progress_catch_signals();
  const char *name = argc > 1 ? argv[1] : "";
  if (!strcmp(name, "--help") || !strcmp(name, "-h") || !strcmp(name, "help")) {
    print_help(stdout);
    return EXIT_FINE;
  }
  if (!strcmp(name, "--version") || !strcmp(name, "-V")) {
    puts(argp_program_version);
    return EXIT_FINE;
  }
  char title[32];
  snprintf(title, sizeof title, "plunge %s", name);
#define X(command, args, help)                                                                     \
  if (!strcmp(name, #command)) {                                                                   \
    argv[1] = title;                                                                               \
    return command_finish(command_##command(argc - 1, argv + 1));                                  \
  }
  COMMANDS(X)
#undef X
  if (*name)
    fprintf(stderr, "plunge: there is no command \"%s\"\n\n", name);
  else
    fputs("plunge: a command is missing\n\n", stderr);
  print_help(stderr);
  return EXIT_BAD_INPUT;
}

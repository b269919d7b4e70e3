/* A subcommand: a few lines over library functions. Each returns the process exit code. */
#pragma once
#include <stdbool.h>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/case/case.h"
#include "common/result/result.h"

enum exit_code { EXIT_FINE = 0, EXIT_VERDICT = 1, EXIT_BAD_INPUT = 2, EXIT_RUN_FAILED = 3 };

/* The list of subcommands; the dispatcher, the help and the declarations expand it. */
#define COMMANDS(X)                                                                                \
  X(run, "CASE.yaml", "run what is missing or changed, then compare and write the report")         \
  X(plan, "CASE.yaml", "the runs of a case for make, Slurm or any other engine")                   \
  X(check, "CASE.yaml...", "validate case files: every problem with file, line and key")           \
  X(compare, "REF.h5 RUN.h5...", "report from existing result files")                              \
  X(import, "SIDECAR.yaml", "a result from the files of another program")                          \
  X(diff, "A B", "do two results, or two folders of them, agree? 0 yes, 1 no, 2 trouble")          \
  X(movie, "RESULT.h5...", "a film of results: surfaces over each other, or a field of particles") \
  X(info, "FILE.h5...", "what is in a result file")                                                \
  X(gallery, "[ID...]", "every figure and table of two documents made anew, each with a verdict")  \
  X(theory, "[TOPIC]", "theory without a run: dispersion, stability, waves; numbers and figures")  \
  X(list, "", "solvers, their parameters and the measures: what a case may name")

#define X(name, args, help) int command_##name(int argc, char **argv);
COMMANDS(X)
#undef X

/* Prints "plunge: message" of a failed status to stderr and returns its exit code. */
int command_fail(enum status status);

/* A line of warning on stderr, whatever --quiet says. */
void command_warn(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Sends off what was printed; the exit code, which becomes EXIT_RUN_FAILED when that is not
 * possible (a full disk). */
int command_finish(int exit_code);

/* Prints each to stderr, a line each. */
void command_list_problems(const struct problems *problems);

/* What --set gave, once or more. */
struct command_set {
  const char **item; /* [n], owned; the strings are argv's */
  size_t n;
};
struct argp_state;
/* Takes one; an error of argp when it is no assignment. Returns 0, or ENOMEM. */
int command_set_add(struct command_set *set, const char *assignment, struct argp_state *state);

/* The whole number from 1 to 1024 that an option has; an error of argp when it has none. */
int command_parse_count(const char *option, const char *arg, struct argp_state *state);

/* Marks the runs that --only names (which it takes apart), all of them without it. ERR_USAGE. */
enum status command_choose_runs(const struct case_file *c, char *only, bool *chosen);

/* --out, or out/ and the name of the case without its suffix; [PATH_MAX]. */
void command_name_folder(const char *out, const struct case_file *c, char *folder);

/* Loads a case; prints every problem to stderr. NULL when there is any, with the exit code. */
struct case_file *command_load_case(const char *path, size_t n_set, const char *const *set,
                                    int *exit_code);

/* Complains of every run (of those marked in `chosen`, [n_runs], unless it is NULL) that needs more
 * memory than there is; returns the exit code. */
int command_check_room(const struct case_file *c, const bool *chosen, size_t n_set,
                       const char *const *set);

/* Makes the folder of results and report and keeps it for this process, or, SHARED, for all that
 * share it and write no report, until `fd` is closed. When another process has it, waits for that
 * one or raises ERR_IO, which names it. */
enum command_lock { COMMAND_ALONE, COMMAND_SHARED };
enum status command_lock_folder(const char *folder, enum command_lock how, bool wait,
                                struct progress *progress, int *fd);

/* Finds the surfaces of files that have particles alone (result_find_all_surfaces), with a word. */
enum status command_find_surfaces(size_t n, struct result_file *const *files,
                                  struct progress *progress);

/* Compares `n` runs with `ref` by the settings of `c`, writes the report into `out` and prints the
 * verdict. Returns the exit code. */
int command_report(const struct case_file *c, const struct result_file *ref, size_t n,
                   struct result_file *const *runs, bool anyway, const char *out,
                   struct progress *progress);

/* What a solver is to the rest of the program: a name, a parameter table, a check and a run. The
 * list of solvers is in cli/registry.c; adding one touches its own folder and that list only. */
#pragma once
#include <stdbool.h>
#include <stddef.h>

#include "common/base/params.h"
#include "common/base/status.h"

struct case_file;
struct case_run;
struct problems;
struct progress;
struct result;

/* What a run will take, before anything of it is allocated: memory within a third or so, time
 * within a factor of three on a machine like those of docs/accuracy.md. */
struct solver_estimate {
  double points;    /* how many, at the start */
  const char *unit; /* what they are: "particles", "nodes" */
  double bytes;     /* most memory at once */
  double seconds;   /* of the clock, on one thread */
  double shared;    /* the part of them that threads share, 0 to 1 */
  double joining;   /* s more on two threads or more: they start and wait for each other */
};

/* Of the clock, on so many threads. */
static inline double solver_seconds(const struct solver_estimate *e, int threads) {
  return e->seconds * (1 - e->shared + e->shared / threads) + (threads > 1 ? e->joining : 0);
}

/* What a solver's water has lost or gained, as one column of /series/energy (J/m). */
struct solver_term {
  const char *name, *help;
  bool outside; /* it passes to and from what moves the tank or its sides: it may fall for ever */
};

/* A column of /series/diagnostics. */
struct solver_diagnostic {
  const char *name, *units, *help;
};

struct solver {
  const char *name, *help;
  const struct param *params; /* the keys a run of this solver may have, [n_params] */
  size_t n_params;
  const struct param_preset *presets; /* that the key `scheme` may name, [n_presets] */
  size_t n_presets;
  size_t options_size;             /* bytes of the struct that the table fills (zeroed first) */
  const struct solver_term *terms; /* of the budget of energy (result.h), [n_terms] */
  size_t n_terms;                  /* at most RESULT_TERMS */

  /* Completes a run of a case that is valid as such: what its options leave to the solver, and the
   * resolution where the run has the key `accuracy` in place of it. May be NULL. */
  void (*settle)(const struct case_file *c, struct case_run *r);

  /* Adds to `problems` whatever this solver cannot do with a case that is valid as such
   * (tank not rectangular, resolution too coarse for the tank ...). May be NULL. */
  void (*check)(const struct case_file *c, const struct case_run *r, struct problems *problems);

  /* Adds what to know before a run that `check` found fine, a sentence each. May be NULL. */
  void (*warn)(const struct case_file *c, const struct case_run *r, struct problems *warnings);

  /* Estimates a run that `check` found fine, in next to no time. */
  void (*estimate)(const struct case_file *c, const struct case_run *r, struct solver_estimate *e);

  /* Runs to the end of the case, writing every output into `out` (already created, not yet
   * finished) and reporting each step to `progress` (which the caller begins and ends). INTERRUPTED
   * when progress_stop_requested(). */
  enum status (*run)(const struct case_file *c, const struct case_run *r, struct result *out,
                     struct progress *progress);
};

/* What a case file may name; handed to case_load by whoever knows the solvers and the comparator.
 */
struct measure {
  const char *name, *units,
      *help; /* units: "H", "sqrt(H/g)", "1", ... : what `max` is counted in */
};

struct registry {
  const struct solver *const *solvers;
  size_t n_solvers;
  const struct measure *measures; /* what compare.tolerances may name */
  size_t n_measures;
};

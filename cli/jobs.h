/* Several pieces of work side by side, each in a process of its own: one that crashes takes no
 * other with it, and their libraries (HDF5, OpenMP) know nothing of each other. */
#pragma once
#include <stdbool.h>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/solver.h"

struct job {
  const char *name;
  size_t item; /* what the caller knows it by */
  struct solver_estimate estimate;
};

struct job_plan {
  const char *one, *many; /* what they are: "run", "runs" */
  int threads;            /* of all together */
  double room;            /* memory for all together, bytes */
  size_t most;            /* at most so many side by side */
  bool exactly;           /* and no fewer, though that be faster */
  size_t jobs;            /* the answer: so many side by side, 1 or more */
};

/* A plan for this machine: what there is of threads and memory, and how many side by side were
 * asked for (0: as many as are fast, but one where OpenMP binds its threads). */
struct job_plan jobs_plan_here(int asked, const char *one, const char *many);

/* Chooses how many side by side, of those that fit into memory whichever they are, are estimated to
 * be done first, each with an equal share of the threads; the fewest of equals. Puts them in order:
 * as they come when it is one at a time, else the longest first. */
void jobs_plan(size_t n, struct job *job, struct job_plan *plan);

/* Threads of place `k` of the plan: the first ones have those that are left over. */
int jobs_threads(const struct job_plan *plan, size_t k);

/* Calls `work(data, item)` for each job in a child process, which ends with the exit code returned.
 * What a child writes to stderr appears whole line by line. Failures do not stop the others; the
 * last one's is in `exit_code`. A signal to stop is passed on to every child, and what has not
 * begun is left: INTERRUPTED; a second one ends all at once. No OpenMP region may have run before:
 * a child of a process with a team of threads would wait for them for ever. */
enum status jobs_run(size_t n, const struct job *job, const struct job_plan *plan,
                     int (*work)(void *data, size_t item), void *data, struct progress *progress,
                     int *exit_code);

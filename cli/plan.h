/* The runs of a case as work for another engine: what is written, and how words get through it. */
#pragma once
#include <stdio.h>

#include "common/case/case.h"

/* X(name, help) */
#define PLAN_ENGINES(X)                                                                            \
  X(make, "a Makefile: make -j N -f FILE; `make compare` alone makes the report again")            \
  X(slurm, "a job array: sbatch FILE; `bash FILE` also queues the comparison behind it")           \
  X(tsv, "a table for any other: step, run, estimated seconds and MB, command")

enum plan_engine {
#define X(name, help) PLAN_##name,
  PLAN_ENGINES(X)
#undef X
      PLAN_N_ENGINES
};
extern const char *const plan_engines[PLAN_N_ENGINES];

struct plan {
  const char *program, *case_path, *folder; /* absolute */
  const struct case_file *c;
  const bool *chosen; /* of the runs, [c->n_runs] */
  size_t n_set;
  const char *const *set; /* [n_set] */
  int threads;            /* of each run */
};

/* ERR_USAGE when a word has a character that no line can hold. */
enum status plan_check(const struct plan *p);
void plan_write(const struct plan *p, enum plan_engine engine, FILE *out);

/* Runs as work for another engine: what is written, and how words get through it. */
#pragma once
#include <stdio.h>

#include "common/solver.h"

/* X(name, help) */
#define PLAN_ENGINES(X)                                                                            \
  X(make, "a Makefile: make -j N -f FILE; `make compare` (of the gallery: `make gallery`) alone "  \
          "is the last step")                                                                      \
  X(slurm, "a job array: sbatch FILE; `bash FILE` also queues the last step behind it")            \
  X(tsv, "a table for any other: step, run, estimated seconds and MB, command")

enum plan_engine {
#define X(name, help) PLAN_##name,
  PLAN_ENGINES(X)
#undef X
      PLAN_N_ENGINES
};
extern const char *const plan_engines[PLAN_N_ENGINES];

struct plan_run {
  const char *name;             /* in the plan */
  const char *case_path, *only; /* the case, absolute, and its run */
  const char *folder;           /* of its result, absolute */
  size_t n_set;
  const char *const *set; /* [n_set] */
  struct solver_estimate estimate;
};

struct plan {
  const char *of;      /* what it is a plan of: a path, or words */
  const char *program; /* absolute */
  size_t n_runs;
  const struct plan_run *run; /* [n_runs] */
  int threads;                /* of each run */
  bool go_on;                 /* the last step comes also when runs have failed: it tells */
  const char *last;           /* name of the last step */
  const char *folder;         /* where it begins, absolute */
  size_t n_words;             /* of its command, behind the program; 0: there is none */
  const char *const *word;
};

/* A word as the shell reads it back; for make, whose own sign is the dollar, with that doubled. */
void plan_word(FILE *out, const char *text, bool make);

/* ERR_USAGE when a word has a character that no line can hold. */
enum status plan_check(const struct plan *p);
void plan_write(const struct plan *p, enum plan_engine engine, FILE *out);

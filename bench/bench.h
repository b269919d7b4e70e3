/* What the programs that measure speed share. */
#pragma once
#include <omp.h>
#include <time.h>

/* On one thread the processor's time, which a busy machine does not lengthen; on more, the clock on
 * the wall. */
static inline double bench_seconds(void) {
  struct timespec t;
  clock_gettime(omp_get_max_threads() == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

#include "cli/room.h"

#include <lapack.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

/* "MemAvailable:   23114 kB" of /proc/meminfo, in bytes; infinite when it cannot be told. */
static double free_memory(void) {
  FILE *file = fopen("/proc/meminfo", "r");
  char line[256];
  double kb = INFINITY;
  while (file && fgets(line, sizeof line, file))
    if (sscanf(line, "MemAvailable: %lf kB", &kb) == 1) break;
  if (file) fclose(file);
  return 1024 * kb;
}

/* One number in a file of the control group; infinite when there is none ("max"). */
static double read_number(const char *path) {
  FILE *file = fopen(path, "r");
  double value = INFINITY;
  if (file && fscanf(file, "%lf", &value) != 1) value = INFINITY;
  if (file) fclose(file);
  return value;
}

static double group_memory(void) {
  double most = read_number("/sys/fs/cgroup/memory.max");
  double used = read_number("/sys/fs/cgroup/memory.current");
  return isinf(most) || isinf(used) ? INFINITY : most - used;
}

static double address_space(void) {
  struct rlimit limit;
  double pages = 0;
  if (getrlimit(RLIMIT_AS, &limit) || limit.rlim_cur == RLIM_INFINITY) return INFINITY;
  FILE *file = fopen("/proc/self/statm", "r");
  if (file && fscanf(file, "%lf", &pages) != 1) pages = 0;
  if (file) fclose(file);
  return fmax(0, (double)limit.rlim_cur - pages * (double)sysconf(_SC_PAGESIZE));
}

double room_available(const char **limit) {
  double machine = free_memory(), group = group_memory(), space = address_space();
  double least = fmin(machine, fmin(group, space));
  *limit = least == space   ? "left under the limit of address space (ulimit -v)"
           : least == group ? "left in the control group"
                            : "of free memory here";
  return least;
}

double room_for_all(void) {
  return fmin(free_memory(), group_memory());
}

void room_check(const struct case_run *r, const struct solver_estimate *e,
                struct problems *problems) {
  const char *limit;
  double room = room_available(&limit);
  if (e->bytes <= room) return;
  char todo[64] = "raise that limit"; /* no resolution helps when even the program has no room */
  if (room > 1e8)
    snprintf(todo, sizeof todo, "lower it to %.0f", floor(r->resolution * sqrt(room / e->bytes)));
  problems_add(
      problems, case_run_line(r, "resolution"),
      "runs.%s.resolution: found '%.6g', about %.0f %s in %.0f MB of memory; allowed: what "
      "fits into the %.0f MB %s; %s",
      r->name, r->resolution, e->points, e->unit, 1e-6 * e->bytes, 1e-6 * room, limit, todo);
}

enum status room_take_for_blas(void) {
  const size_t buffer = 144 << 20; /* 128 MB, what aligning it takes, and some */
  void *there = mmap(NULL, buffer, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  const char *limit;
  double room = room_available(&limit);
  CHECK(there != MAP_FAILED, ERR_MEMORY,
        "no memory for linear algebra: it takes %.0f MB, and there are %.0f MB %s",
        1e-6 * (double)buffer, 1e-6 * room, limit);
  munmap(there, buffer);
  double a[4] = {2, 1, 1, 2}; /* whatever the matrix, OpenBLAS takes its buffer for it */
  lapack_int n = 2, pivot[2], info;
  LAPACK_dgetrf(&n, &n, a, &n, pivot, &info);
  return OK;
}

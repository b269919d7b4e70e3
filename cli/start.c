/* The settings that libraries read while they are loaded, so that main() is too late for them: the
 * dynamic linker runs .preinit_array before any library's own start, and from there the program
 * starts once more.
 *   OPENBLAS_NUM_THREADS: its buffers for every core do not fit under a limit of address space
 *     (ulimit -v), and it then asks for memory for ever; besides, its number of threads changes the
 *     last bits of a result. One is enough: our own loops are what runs on threads.
 *   GOMP_SPINCOUNT: threads that wait for each other at the end of a loop spin for a while by
 *     default. On a machine that was busy with other work a run on two threads then took eight
 * times as long as with this short wait; on an idle one there was hardly a difference. */
#include "cli/start.h"

#include <fcntl.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>
#include <unistd.h>

static char one_thread[] = "OPENBLAS_NUM_THREADS=1", short_wait[] = "GOMP_SPINCOUNT=1000";
enum { MOST_VARIABLES = 4096 };

/* "NAME=value" among `environment`, whose end is a NULL. */
static char **find(char **environment, const char *name, size_t n) {
  while (*environment && (strncmp(*environment, name, n) != 0 || (*environment)[n] != '='))
    environment++;
  return environment;
}
#define FIND(environment, name) find(environment, name, sizeof name - 1)

/* Nothing is set up yet: system calls only. */
__attribute__((no_sanitize("address", "undefined"))) static void start_again(int argc, char **argv,
                                                                             char **environment) {
  char *changed[MOST_VARIABLES + 3];
  size_t n = 0;
  (void)argc;
  bool paced = *FIND(environment, "OMP_WAIT_POLICY") || *FIND(environment, "GOMP_SPINCOUNT");
  char *threads = *FIND(environment, "OPENBLAS_NUM_THREADS");
  if (paced && threads && !strcmp(threads, one_thread)) return;
  for (char **e = environment; *e; e++) {
    if (n == MOST_VARIABLES) return;
    if (*e != threads) changed[n++] = *e;
  }
  changed[n++] = one_thread;
  if (!paced) changed[n++] = short_wait;
  changed[n] = NULL;
  execve("/proc/self/exe", argv, changed); /* if that fails, it goes on as it is */
}

__attribute__((section(".preinit_array"),
               used)) static void (*const before_libraries)(int, char **, char **) = start_again;

void start_fill_descriptors(void) {
  for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++)
    if (fcntl(fd, F_GETFD) < 0) (void)open("/dev/null", O_RDWR); /* takes the lowest number free */
}

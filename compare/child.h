/* Programs that draw and encode, as child processes: started directly (no shell), each in a process
 * group of its own, and ended with this process. */
#pragma once
#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

#include "common/base/status.h"

enum { CMP_CHILD_MISSING = 127 }; /* the exit code where there is no such program */

/* Starts word[0], looked for in PATH, in the folder `dir`; what it complains of goes to the file
 * `log` there. `word`: NULL-terminated. ERR_IO. */
enum status cmp_child_start(const char *dir, const char *log, const char *const *word, pid_t *pid);
void cmp_child_kill(pid_t *pid); /* with what it has started; 0 then, and fine before */

/* Waits for it; as `limit` (s) of the clock is over, or the user asks to stop, it is ended:
 * ERR_IO or INTERRUPTED. `outcome` as of wait(2). */
enum status cmp_child_wait(pid_t *pid, double limit, int *outcome);

bool cmp_child_exists(const char *program); /* in PATH */

/* The first line of a log that says something, or "no reason given". */
void cmp_child_complaint(const char *dir, const char *log, const char *word, char *out,
                         size_t room);

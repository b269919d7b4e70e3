#include "compare/child.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "common/base/progress.h"
#include "compare/output.h"

/* In the child: nothing here but system calls. A parent that is killed takes it along. */
static void child_run(const char *dir, const char *log, const char *const *word, pid_t parent) {
  setpgid(0, 0);
  if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || getppid() != parent) _exit(126);
  int null = open("/dev/null", O_RDWR);
  if (null < 0 || chdir(dir) != 0) _exit(126);
  int complaints = open(log, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (complaints < 0) _exit(126);
  dup2(null, STDIN_FILENO);
  dup2(null, STDOUT_FILENO);
  dup2(complaints, STDERR_FILENO);
  execvp(word[0], (char *const *)word);
  _exit(CMP_CHILD_MISSING);
}

enum status cmp_child_start(const char *dir, const char *log, const char *const *word, pid_t *pid) {
  const pid_t parent = getpid();
  *pid = fork();
  if (*pid == 0) child_run(dir, log, word, parent);
  if (*pid < 0) {
    *pid = 0;
    return status_raise(ERR_IO, "cannot start %s: %s", word[0], strerror(errno));
  }
  setpgid(*pid, *pid); /* here too: whoever comes first */
  return OK;
}

void cmp_child_kill(pid_t *pid) {
  if (!*pid) return;
  kill(-*pid, SIGKILL);
  while (waitpid(*pid, NULL, 0) < 0 && errno == EINTR) continue;
  *pid = 0;
}

enum status cmp_child_wait(pid_t *pid, double limit, int *outcome) {
  const double deadline = progress_wall_clock() + limit;
  while (waitpid(*pid, outcome, WNOHANG) != *pid) {
    const bool stop = progress_stop_requested(), late = progress_wall_clock() > deadline;
    if (stop || late) {
      cmp_child_kill(pid);
      CHECK(!stop, INTERRUPTED, "stopped");
      return status_raise(ERR_IO, "it took longer than %g s and was stopped", limit);
    }
    nanosleep(&(struct timespec){.tv_nsec = 20000000}, NULL); /* a signal ends it */
  }
  kill(-*pid, SIGKILL); /* whatever it has left behind */
  *pid = 0;
  return OK;
}

bool cmp_child_exists(const char *program) {
  const char *path = getenv("PATH");
  bool found = false;
  for (const char *from = path ? path : "/usr/bin:/bin"; !found && from;) {
    const char *colon = strchr(from, ':');
    const int n = colon ? (int)(colon - from) : (int)strlen(from);
    char file[PATH_MAX];
    const int m = snprintf(file, sizeof file, "%.*s/%s", n ? n : 1, n ? from : ".", program);
    found = m < PATH_MAX && access(file, X_OK) == 0;
    from = colon ? colon + 1 : NULL;
  }
  return found;
}

void cmp_child_complaint(const char *dir, const char *log, const char *word, char *out,
                         size_t room) {
  char path[PATH_MAX], line[160];
  snprintf(out, room, "no reason given");
  if (cmp_path_join(dir, log, path) != OK) return;
  FILE *in = fopen(path, "r");
  while (in && fgets(line, sizeof line, in)) {
    line[strcspn(line, "\r\n")] = 0;
    if (strspn(line, " \t^") == strlen(line)) continue;
    snprintf(out, room, "%s", line);
    if (strstr(line, word)) break;
  }
  if (in) fclose(in);
}

#include "common/result/result_guard.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/base/file.h"

/* What a sound file may take, with a wide margin: reading inflates a result to less than 20 times
 * its size (columns of constants) at more than 50 MB/s. */
#define LEAST_MEMORY   ((size_t)256 << 20) /* bytes */
#define MEMORY_A_BYTE  32
#define LEAST_TIME     3       /* s of the processor */
#define BYTES_A_SECOND 4000000 /* more, for each second of the processor */
#define WAITING        12 /* s on the clock for each of the processor: slow disks, busy machines */

static _Thread_local size_t *blamed; /* shared by both processes while one runs */

void guard_blame(size_t which) {
  *blamed = which;
}

static size_t memory_allowed(const struct guard *g) {
  return LEAST_MEMORY + MEMORY_A_BYTE * g->size;
}

/* ---- the child ---- */

static size_t address_space(void) {
  size_t pages = 0;
  FILE *f = fopen("/proc/self/statm", "r");
  if (f && fscanf(f, "%zu", &pages) != 1) pages = 0;
  if (f) fclose(f);
  return pages * (size_t)sysconf(_SC_PAGESIZE);
}

/* Whether the limit is ours: the user's own may be lower. */
static bool limit_memory(const struct guard *g) {
  struct rlimit now;
  size_t used = address_space(), limit = used + memory_allowed(g);
  if (!used || getrlimit(RLIMIT_AS, &now) || now.rlim_cur <= limit) return false;
  return !setrlimit(RLIMIT_AS, &(struct rlimit){limit, limit});
}

static void limit_time(const struct guard *g) {
  rlim_t seconds = LEAST_TIME + g->size / BYTES_A_SECOND;
  struct rlimit now;
  if (!getrlimit(RLIMIT_CPU, &now) && now.rlim_cur > seconds)
    setrlimit(RLIMIT_CPU, &(struct rlimit){seconds, seconds + 1}); /* SIGXCPU, then SIGKILL */
  alarm(WAITING * (unsigned)seconds);
}

/* Signals end the child whatever the program has made of them. */
static void reset_signals(void) {
  static const int ending[] = {SIGINT, SIGTERM, SIGHUP, SIGALRM, SIGXCPU, SIGPIPE};
  sigset_t set;
  sigemptyset(&set);
  for (size_t i = 0; i < sizeof ending / sizeof *ending; i++) {
    signal(ending[i], SIG_DFL);
    sigaddset(&set, ending[i]);
  }
  sigprocmask(SIG_UNBLOCK, &set, NULL);
}

static void silence(void) {
  int nowhere = file_open("/dev/null", O_RDWR);
  for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++) dup2(nowhere, fd);
}

static enum status carry_outcome(struct carrier *c, size_t *outcome, char **message) {
  TRY(carry_number(c, outcome));
  return *outcome == OK ? OK : carry_text(c, message);
}

static _Noreturn void be_child(const struct guard *g, int pipe, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1); /* it died before the line above */
  reset_signals();
  silence(); /* last words of a crash */
  setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
  limit_time(g);
  bool limited = limit_memory(g);
  static struct carrier c; /* needs no memory when there is none */
  c.pipe = pipe;
  c.sending = true;
  enum status status = g->read(g->data);
  if (status == ERR_MEMORY && limited)
    status =
        status_raise(ERR_INPUT,
                     "%s is damaged: reading it takes more than %zu MB of memory, too much for "
                     "a file of its size",
                     g->name[*blamed], memory_allowed(g) >> 20);
  size_t outcome = status;
  char *message = (char *)status_message();
  status = carry_outcome(&c, &outcome, &message);
  if (status == OK && outcome == OK) status = g->carry(&c, g->data);
  if (status == OK) status = carry_end(&c);
  _exit(status != OK);
}

/* ---- the parent ---- */

/* Why there was no answer. */
static enum status explain(const struct guard *g, int wait_status) {
  const char *name = g->name[*blamed < 2 && g->name[*blamed] ? *blamed : 0];
  int number = WIFSIGNALED(wait_status) ? WTERMSIG(wait_status) : 0;
  if (number == SIGINT || number == SIGTERM || number == SIGHUP)
    return status_raise(INTERRUPTED, "interrupted while reading %s", name);
  if (number == SIGKILL)
    return status_raise(ERR_MEMORY, "no memory to read %s: the system ended the process", name);
  if (number == SIGXCPU || number == SIGALRM)
    return status_raise(ERR_INPUT, "%s is damaged beyond reading: reading it never ends",
                        name);
  return status_raise(ERR_INPUT, "%s is damaged beyond reading", name);
}

static enum status receive(const struct guard *g, struct carrier *c, bool *answered) {
  size_t outcome = OK;
  char *message = NULL;
  enum status status = carry_outcome(c, &outcome, &message);
  *answered = status == OK;
  if (status == OK && outcome != OK)
    status = status_raise(outcome <= INTERRUPTED ? (enum status)outcome : ERR_INPUT, "%s",
                          message ? message : "");
  free(message);
  if (status != OK) return status;
  status = g->carry(c, g->data);
  *answered = status != ERR_INPUT;
  return status;
}

static enum status be_parent(const struct guard *g, int pipe, pid_t child) {
  struct carrier *c = calloc(1, sizeof *c);
  bool answered = c != NULL;
  enum status status = c ? OK : status_raise(ERR_MEMORY, "no memory to read %s", g->name[0]);
  if (c) {
    c->pipe = pipe;
    c->room = memory_allowed(g);
    status = receive(g, c, &answered);
  }
  free(c);
  close(pipe); /* whatever the child still says ends it */
  int wait_status = 0;
  if (answered) kill(child, SIGKILL); /* it has said all */
  while (waitpid(child, &wait_status, 0) < 0 && errno == EINTR) continue;
  return answered ? status : explain(g, wait_status);
}

static enum status run_child(const struct guard *g) {
  int ends[2];
  CHECK(!pipe2(ends, O_CLOEXEC), ERR_IO, "cannot read %s: %s", g->name[0], strerror(errno));
  for (int i = 0; i < 2; i++) ends[i] = file_lift(ends[i]); /* the child closes 0, 1 and 2 */
  pid_t self = getpid(), child = fork();
  if (!child) be_child(g, ends[1], self);
  int reason = errno;
  close(ends[1]);
  enum status status = child > 0 ? be_parent(g, ends[0], child)
                                 : status_raise(reason == ENOMEM ? ERR_MEMORY : ERR_IO,
                                                "cannot start a process to read %s: %s", g->name[0],
                                                strerror(reason));
  if (child < 0) close(ends[0]);
  return status;
}

enum status guard_run(const struct guard *g) {
  blamed = mmap(NULL, sizeof *blamed, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  CHECK(blamed != MAP_FAILED, ERR_MEMORY, "no memory to read %s", g->name[0]);
  enum status status = run_child(g);
  munmap(blamed, sizeof *blamed);
  return status;
}

/* Compiled without sanitizers, whose own use of the counters' names would clash with ours, and
 * linked first, as the counters shall begin on a page. */
#include "fuzz/servant.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <sanitizer/common_interface_defs.h>
#include <signal.h>
#include <stdbool.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>

#include "common/base/file.h"
#include "fuzz/fuzz.h"
#include "fuzz/hasty.h"

enum { WORKS = 100, HASTY_TIME = 3 /* s of the processor */ };

static pid_t fuzzer;
static int line;   /* from the fuzzer to the servant */
static int report; /* of FUZZ_REPORT */

void __asan_init(void) __attribute__((weak)); /* NULL without the address sanitizer */

/* ---- libFuzzer's counters of the code that has run ---- */

__asm__(".pushsection __sancov_cntrs,\"aw\"\n.balign 4096\n.popsection");
extern uint8_t __start___sancov_cntrs[], __stop___sancov_cntrs[];

/* Puts them where all processes count: else it would see nothing of what the others do. Behind
 * them, on their last page, is only the table of their places, which never changes. */
static void share_counters(void) {
  uint8_t *from = __start___sancov_cntrs;
  size_t page = (size_t)sysconf(_SC_PAGESIZE);
  size_t size = ((size_t)(__stop___sancov_cntrs - from) + page - 1) / page * page;
  uint8_t *copy = malloc(size);
  if (!copy || (uintptr_t)from % page) abort();
  memcpy(copy, from, size);
  if (mmap(from, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_FIXED, -1, 0) ==
      MAP_FAILED)
    abort();
  memcpy(from, copy, size);
  free(copy);
}

/* ---- telling our errors from HDF5's ---- */

const char *__asan_default_options(void);
const char *__asan_default_options(void) {
  return "allocator_may_return_null=1:max_allocation_size_mb=300:symbolize=0:detect_leaks=0:"
         "malloc_context_size=2:quarantine_size_mb=4";
}

/* The innermost frames decide: HDF5 calls nothing of ours that could fail. Where memory is short,
 * as the guard sees to, the sanitizer itself may end. */
static bool is_from_hdf5(const char *text) {
  static const char *const short_of_memory[] = {
      "ERROR: AddressSanitizer failed to allocate", "ERROR: Failed to mmap",
      "ERROR: AddressSanitizer: out-of-memory", "internal allocator is out of memory"};
  const char *error = strstr(text, "ERROR: "), *end = error;
  if (!error) return false; /* it is compiled without checks of undefined behaviour */
  for (int i = 0; i < 4; i++)
    if (strstr(text, short_of_memory[i])) return true;
  for (int frames = 0; frames < 4 && (end = strstr(end, "\n    #")); frames++) end++;
  size_t n = end ? (size_t)(end - error) : strlen(error);
  return memmem(error, n, "libhdf5", 7) || memmem(error, n, "libz.so", 7);
}

/* Before each attempt, or an error of HDF5's in the one before would excuse one of ours. */
static void forget_report(void) {
  if (ftruncate(report, 0)) abort();
}

static void die(void) {
  static char text[1 << 16];
  if (pread(report, text, sizeof text - 1, 0) < 0 || !is_from_hdf5(text)) kill(fuzzer, SIGABRT);
}

/* In the servant and again in each child, as the sanitizers take a report's file for one process'.
 * Without the address sanitizer, every crash of a child is taken for HDF5's. */
static void watch(void) {
  static const int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL};
  __sanitizer_set_report_fd((void *)(intptr_t)report);
  __sanitizer_set_death_callback(die);
  for (int i = 0; !__asan_init && i < 4; i++) signal(crashes[i], SIG_DFL);
}

/* ---- processes that serve ---- */

static bool say(int fd) {
  return send(fd, "", 1, MSG_NOSIGNAL) == 1;
}

static bool hear(int fd) {
  char byte;
  ssize_t got;
  do got = read(fd, &byte, 1);
  while (got < 0 && errno == EINTR);
  return got == 1;
}

/* Whether this is the new process; `line` leads to the other. */
static bool divide(pid_t *child, int *to) {
  int end[2];
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, end)) abort();
  *child = fork();
  if (*child < 0) abort();
  close(end[*child == 0 ? 0 : 1]);
  *to = end[*child == 0 ? 1 : 0];
  if (!*child) prctl(PR_SET_PDEATHSIG, SIGKILL);
  return !*child;
}

/* 0: without limit. */
static void limit_time(int seconds) {
  setitimer(ITIMER_PROF, &(struct itimerval){.it_value.tv_sec = seconds}, NULL); /* SIGPROF */
}

static _Noreturn void be_worker(void (*serve)(void), int to) {
  fuzz_hasten();
  while (hear(to)) {
    limit_time(HASTY_TIME);
    serve();
    limit_time(0);
    if (!say(to)) break;
  }
  _exit(0);
}

/* False when the worker died of it, which says nothing yet. */
static bool have_worked(void (*serve)(void)) {
  static pid_t worker;
  static int to, works;
  forget_report();
  if (!worker && divide(&worker, &to)) be_worker(serve, to);
  bool done = say(to) && hear(to);
  if (done && ++works < WORKS) return true;
  close(to); /* ends it */
  waitpid(worker, NULL, 0);
  worker = 0, works = 0;
  return done;
}

void fuzz_servant_start(void (*serve)(void)) {
  pid_t servant;
  int to;
  share_counters();
  fuzzer = getpid();
  report = file_open(FUZZ_REPORT, O_RDWR | O_CREAT | O_TRUNC | O_APPEND);
  if (report < 0) abort();
  if (!divide(&servant, &to)) {
    line = to;
    return;
  }
  watch();
  if (pthread_atfork(NULL, NULL, watch)) abort();
  while (hear(to)) {
    if (!have_worked(serve)) {
      forget_report();
      serve();
    }
    if (!say(to)) break;
  }
  _exit(0);
}

void fuzz_servant_call(void) {
  if (!say(line) || !hear(line)) abort();
}

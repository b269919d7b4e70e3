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

#include "common/file.h"
#include "fuzz/fuzz.h"

static pid_t fuzzer;
static int line[2]; /* ends of the fuzzer and of the servant */
static int report;  /* of FUZZ_REPORT */
static bool from_hdf5;

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

/* weak: built without the address sanitizer, every crash of a child is taken for HDF5's */
void __asan_set_error_report_callback(void (*callback)(const char *text)) __attribute__((weak));

const char *__asan_default_options(void);
const char *__asan_default_options(void) {
  return "allocator_may_return_null=1:max_allocation_size_mb=300:symbolize=0:detect_leaks=0:"
         "malloc_context_size=2:quarantine_size_mb=4";
}

/* The innermost frames decide: HDF5 calls nothing of ours that could fail. */
static void see_report(const char *text) {
  const char *end = text;
  for (int frames = 0; frames < 4 && (end = strstr(end, "\n    #")); frames++) end++;
  size_t n = end ? (size_t)(end - text) : strlen(text);
  from_hdf5 = memmem(text, n, "libhdf5", 7) || memmem(text, n, "libz.so", 7);
}

static void die(void) {
  if (!from_hdf5)
    kill(fuzzer, SIGABRT);
  else if (ftruncate(report, 0))
    abort();
}

/* In the servant and again in each child, as the sanitizers take a report's file for one process'.
 */
static void watch(void) {
  static const int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL};
  __sanitizer_set_report_fd((void *)(intptr_t)report);
  __sanitizer_set_death_callback(die);
  if (__asan_set_error_report_callback)
    __asan_set_error_report_callback(see_report);
  else
    for (int i = 0; i < 4; i++) signal(crashes[i], SIG_DFL);
}

/* ---- the servant ---- */

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

void fuzz_servant_start(void (*serve)(void)) {
  share_counters();
  fuzzer = getpid();
  report = file_open(FUZZ_REPORT, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND);
  if (report < 0 || socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, line)) abort();
  pid_t servant = fork();
  if (servant < 0) abort();
  close(line[!servant ? 0 : 1]);
  if (servant) return;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  watch();
  if (pthread_atfork(NULL, NULL, watch)) abort();
  while (hear(line[1])) {
    serve();
    if (!say(line[1])) break;
  }
  _exit(0);
}

void fuzz_servant_call(void) {
  if (!say(line[0]) || !hear(line[0])) abort();
}

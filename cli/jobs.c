#include "cli/jobs.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <omp.h>
#include <poll.h>
#include <sched.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/room.h"
#include "common/base/array.h"
#include "common/base/file.h"

/* ---- the plan ---- */

static int by_length(const void *a, const void *b) {
  const struct job *p = a, *q = b;
  double s = p->estimate.seconds, t = q->estimate.seconds;
  return s < t ? 1 : s > t ? -1 : (p->item > q->item) - (p->item < q->item);
}

int jobs_threads(const struct job_plan *plan, size_t k) {
  int jobs = (int)plan->jobs, share = plan->threads / jobs + ((int)k < plan->threads % jobs);
  return share ? share : 1;
}

/* When the last of them is done, s: each goes to the place that is free first. `busy` [plan->jobs].
 */
static double last_done(size_t n, const struct job *job, const struct job_plan *plan,
                        double *busy) {
  double last = 0;
  for (size_t k = 0; k < plan->jobs; k++) busy[k] = 0;
  for (size_t i = 0; i < n; i++) {
    size_t first = 0;
    for (size_t k = 1; k < plan->jobs; k++)
      if (busy[k] < busy[first]) first = k;
    busy[first] += solver_seconds(&job[i].estimate, jobs_threads(plan, first));
    last = fmax(last, busy[first]);
  }
  return last;
}

/* How many fit into memory whichever they are. */
static size_t most_that_fit(size_t n, const struct job *job, double room, double *bytes) {
  size_t fit = 0;
  for (size_t i = 0; i < n; i++) bytes[i] = job[i].estimate.bytes;
  qsort(bytes, n, sizeof *bytes, array_ascending);
  for (double sum = 0; fit < n && (sum += bytes[n - 1 - fit]) <= room;) fit++;
  return fit;
}

struct job_plan jobs_plan_here(int asked, const char *one, const char *many) {
  const bool bound = omp_get_proc_bind() != omp_proc_bind_false;
  return (struct job_plan){.one = one,
                           .many = many,
                           .threads = omp_get_max_threads(),
                           .room = room_for_all(),
                           .most = asked   ? (size_t)asked
                                   : bound ? 1
                                           : SIZE_MAX,
                           .exactly = asked > 0};
}

void jobs_plan(size_t n, struct job *job, struct job_plan *plan) {
  double *scratch = malloc((n + 1) * sizeof *scratch), best = INFINITY;
  size_t most = plan->most < n ? plan->most : n, jobs = 1;
  if (!plan->exactly && most > (size_t)plan->threads) most = (size_t)plan->threads;
  size_t fit = scratch ? most_that_fit(n, job, plan->room, scratch) : 1;
  if (most > fit) most = fit;
  struct job *sorted = malloc((n + 1) * sizeof *sorted);
  if (!scratch || !sorted) most = 1; /* one at a time needs no memory */
  if (most > 1) {
    memcpy(sorted, job, n * sizeof *job);
    qsort(sorted, n, sizeof *sorted, by_length);
  }
  for (plan->jobs = plan->exactly ? most : 1; most > 1 && plan->jobs <= most; plan->jobs++) {
    double last = last_done(n, sorted, plan, scratch);
    if (last >= best) continue;
    best = last;
    jobs = plan->jobs;
  }
  plan->jobs = jobs;
  if (jobs > 1) memcpy(job, sorted, n * sizeof *job);
  free(scratch);
  free(sorted);
}

/* ---- at work ---- */

struct place {
  pid_t pid; /* 0: nobody is there */
  const struct job *job;
  int words, notes; /* pipes: its stderr, its live line */
  struct progress_note note;
  char text[4096]; /* of a line that it has begun, [n] */
  size_t n;
};

struct crew {
  struct place *place; /* [n], of which the first ones may be empty */
  size_t n, next, n_jobs, at_work;
  const struct job *job;
  const struct job_plan *plan;
  int (*work)(void *data, size_t item);
  void *data;
  struct progress *progress;
  bool told_to_stop;
  int *exit_code;
};

/* A thread that OpenMP has bound (OMP_PROC_BIND) stays where it is after a fork, and binds those
 * that join it as if the process were alone: children would share the first processors. So each
 * takes its own of the places, one for each of its threads, which stay with it. */
static void take_places(const struct job_plan *plan, size_t k) {
  const int places = omp_get_num_places(), threads = jobs_threads(plan, k);
  int first = 0;
  if (omp_get_proc_bind() == omp_proc_bind_false || places == 0) return;
  for (size_t j = 0; j < k; j++) first += jobs_threads(plan, j);
#pragma omp parallel num_threads(threads)
  {
    const int place = (first + omp_get_thread_num()) % places;
    int processor[omp_get_place_num_procs(place) + 1];
    cpu_set_t set;
    CPU_ZERO(&set);
    omp_get_place_proc_ids(place, processor);
    for (int p = 0; p < omp_get_place_num_procs(place); p++) CPU_SET((size_t)processor[p], &set);
    (void)sched_setaffinity(0, sizeof set, &set); /* refused: it works there as well */
  }
}

static _Noreturn void be_child(const struct crew *crew, size_t k, const struct job *job, int words,
                               int notes, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(EXIT_RUN_FAILED); /* it died before the line above */
  progress_obey_parent();
  progress_hold_signals(false);
  dup2(words, STDERR_FILENO);
  progress_send(crew->progress, notes);
  omp_set_num_threads(jobs_threads(crew->plan, k));
  take_places(crew->plan, k);
  exit(crew->work(crew->data, job->item));
}

/* Ends that neither process inherits by a program it starts, and that are none of 0, 1 and 2. */
static enum status pipe_open(int ends[2], const char *one, const char *name) {
  CHECK(!pipe2(ends, O_CLOEXEC), ERR_IO, "cannot start %s %s: %s", one, name, strerror(errno));
  for (int i = 0; i < 2; i++) ends[i] = file_lift(ends[i]);
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  return OK;
}

static void pipe_close(int ends[2]) {
  for (int i = 0; i < 2; i++)
    if (ends[i] >= 0) close(ends[i]);
}

static enum status place_fill(struct crew *crew, size_t k, const struct job *job) {
  struct place *p = &crew->place[k];
  int words[2] = {-1, -1}, notes[2] = {-1, -1};
  enum status status;
  ATTEMPT(pipe_open(words, crew->plan->one, job->name));
  ATTEMPT(pipe_open(notes, crew->plan->one, job->name));
  fcntl(notes[1], F_SETFL, O_NONBLOCK);
  *p = (struct place){.job = job, .words = words[0], .notes = notes[0], .note.left = NAN};
  snprintf(p->note.name, sizeof p->note.name, "%s", job->name);
  fflush(NULL); /* what is not yet printed would be twice */
  progress_hold_signals(true);
  pid_t parent = getpid(), pid = fork();
  if (!pid) be_child(crew, k, job, words[1], notes[1], parent);
  int reason = errno;
  progress_hold_signals(false);
  if (pid < 0)
    ATTEMPT(status_raise(reason == ENOMEM ? ERR_MEMORY : ERR_IO,
                         "cannot start a process for %s %s: %s", crew->plan->one, job->name,
                         strerror(reason)));
  p->pid = pid;
  crew->at_work++;
  words[0] = notes[0] = -1;
done:
  pipe_close(words);
  pipe_close(notes);
  return status;
}

/* The next of those that wait. One that cannot be started is a failure like any other. */
static void places_fill(struct crew *crew) {
  for (size_t k = 0; k < crew->n; k++)
    while (!crew->place[k].pid && crew->next < crew->n_jobs && !progress_stop_requested()) {
      enum status status = place_fill(crew, k, &crew->job[crew->next++]);
      if (status != OK) *crew->exit_code = command_fail(status);
    }
}

/* Prints the lines that are complete; all of it when no more will come. */
static void words_print(struct place *p, struct progress *progress, bool all) {
  char *end = memrchr(p->text, '\n', p->n);
  size_t n = all || p->n == sizeof p->text ? p->n : end ? (size_t)(end - p->text) + 1 : 0;
  if (!n) return;
  progress_forward(progress, p->text, n);
  if (all && p->text[n - 1] != '\n') progress_forward(progress, "\n", 1);
  p->n -= n;
  memmove(p->text, p->text + n, p->n);
}

/* Whether there was an end: the child has closed the pipe, or is no more. */
static bool words_read(struct place *p, struct progress *progress) {
  for (;;) {
    ssize_t n = read(p->words, p->text + p->n, sizeof p->text - p->n);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && errno == EAGAIN) return false;
    if (n <= 0) break;
    p->n += (size_t)n;
    words_print(p, progress, false);
  }
  words_print(p, progress, true);
  return true;
}

static void crash_tell(const char *one, const struct job *job, int outcome) {
  int number = WIFSIGNALED(outcome) ? WTERMSIG(outcome) : 0;
  if (number == SIGKILL)
    command_warn("%s %s: its process was killed; was there no memory left?", one, job->name);
  else if (number)
    command_warn("%s %s: its process crashed (%s)", one, job->name, strsignal(number));
  else
    command_warn("%s %s: its process ended with code %d", one, job->name, WEXITSTATUS(outcome));
}

static void place_empty(struct crew *crew, struct place *p) {
  int outcome = 0;
  while (waitpid(p->pid, &outcome, 0) < 0 && errno == EINTR) continue;
  close(p->words);
  close(p->notes);
  p->pid = 0;
  crew->at_work--;
  int code = WIFEXITED(outcome) ? WEXITSTATUS(outcome) : -1;
  if (code == EXIT_FINE) return;
  bool told = code == EXIT_BAD_INPUT || code == EXIT_RUN_FAILED;
  if (!told) crash_tell(crew->plan->one, p->job, outcome);
  *crew->exit_code = told ? code : EXIT_RUN_FAILED;
}

static void notes_show(struct crew *crew) {
  struct progress_note note[crew->n];
  size_t n = 0;
  for (size_t k = 0; k < crew->n; k++) {
    struct place *p = &crew->place[k];
    struct progress_note last;
    if (!p->pid) continue;
    while (read(p->notes, &last, sizeof last) == sizeof last) p->note = last;
    note[n++] = p->note;
  }
  if (n > 1 || (n && *note->line)) progress_show(crew->progress, note, n);
}

/* Waits until a child has said something, or for a moment: the live line goes on, and a signal that
 * came just before is heard. */
static void crew_wait(const struct crew *crew) {
  struct pollfd fd[crew->n];
  for (size_t k = 0; k < crew->n; k++)
    fd[k] = (struct pollfd){crew->place[k].pid ? crew->place[k].words : -1, POLLIN, 0};
  (void)poll(fd, crew->n, 200);
}

static void stop_pass_on(struct crew *crew) {
  if (crew->told_to_stop || !progress_stop_requested()) return;
  for (size_t k = 0; k < crew->n; k++)
    if (crew->place[k].pid) kill(crew->place[k].pid, PROGRESS_STOP);
  crew->told_to_stop = true;
}

static void crew_work(struct crew *crew) {
  for (places_fill(crew); crew->at_work; places_fill(crew)) {
    crew_wait(crew);
    stop_pass_on(crew);
    for (size_t k = 0; k < crew->n; k++) {
      struct place *p = &crew->place[k];
      if (p->pid && words_read(p, crew->progress)) place_empty(crew, p);
    }
    notes_show(crew);
  }
}

enum status jobs_run(size_t n, const struct job *job, const struct job_plan *plan,
                     int (*work)(void *data, size_t item), void *data, struct progress *progress,
                     int *exit_code) {
  struct crew crew = {.n = plan->jobs,
                      .n_jobs = n,
                      .job = job,
                      .plan = plan,
                      .work = work,
                      .data = data,
                      .progress = progress,
                      .exit_code = exit_code};
  TRY(array_create(&crew.place, crew.n, "runs side by side"));
  if (plan->jobs > 1)
    progress_say(progress, "%zu %s, %zu at a time, each on %d thread%s", n, plan->many, plan->jobs,
                 jobs_threads(plan, plan->jobs - 1),
                 jobs_threads(plan, plan->jobs - 1) > 1 ? "s" : "");
  crew_work(&crew);
  free(crew.place);
  CHECK(!progress_is_stopped(), INTERRUPTED, "stopped");
  progress_ask_no_more();
  return OK;
}

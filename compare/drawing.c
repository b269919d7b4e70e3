#include "compare/drawing.h"

#include <errno.h>
#include <omp.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "common/base/progress.h"
#include "compare/child.h"
#include "compare/output.h"

enum { MOST_WORKERS = 8 }; /* gnuplots at a time */

struct worker {
  pid_t pid; /* 0: idle; also its process group */
  struct cmp_figure *figure;
  double deadline;
};

struct drawing {
  struct cmp_figures *figures;
  struct cmp_drawing_limits limits;
  bool small;          /* the heavy figures have been given out, the others are next */
  size_t next, failed; /* of the figures */
  double used;         /* s, counted as limits.all is */
  size_t workers;
  struct worker worker[MOST_WORKERS];
};

/* ---- one gnuplot ---- */

static enum status worker_start(struct drawing *d, struct worker *w, struct cmp_figure *fig) {
  char script[128], log[128];
  snprintf(script, sizeof script, "%s.gp", fig->name);
  snprintf(log, sizeof log, "%s.log", fig->name);
  pid_t pid;
  TRY(cmp_child_start(d->figures->temporary, log, (const char *[]){"gnuplot", "-d", script, NULL},
                      &pid));
  *w = (struct worker){pid, fig, progress_wall_clock() + d->limits.each};
  return OK;
}

/* A full disk does not stop gnuplot: the end of what it wrote tells. */
static void drawing_check(const struct cmp_figures *f, struct cmp_figure *fig) {
  for (size_t k = 0; k < CMP_FORMATS; k++) {
    const struct cmp_format *format = &cmp_formats[k];
    char name[128], path[PATH_MAX], tail[33] = "";
    if (!cmp_figure_has(fig, format)) continue;
    snprintf(name, sizeof name, "%s%s", fig->name, format->suffix);
    FILE *file = cmp_path_join(f->temporary, name, path) == OK ? fopen(path, "rb") : NULL;
    size_t n = 0;
    if (file && fseek(file, -32, SEEK_END) == 0) n = fread(tail, 1, 32, file);
    if (file) fclose(file);
    if (n && memmem(tail, n, format->end, strlen(format->end))) continue;
    snprintf(fig->missing, sizeof fig->missing, "gnuplot wrote only part of %s; is the disk full?",
             name);
    return;
  }
}

static void outcome_note(struct drawing *d, struct cmp_figure *fig, int outcome) {
  char why[160];
  if (WIFEXITED(outcome) && WEXITSTATUS(outcome) == 0) {
    drawing_check(d->figures, fig);
  } else if (WIFSIGNALED(outcome)) {
    snprintf(fig->missing, sizeof fig->missing, "gnuplot was stopped (%s)",
             strsignal(WTERMSIG(outcome)));
  } else if (WEXITSTATUS(outcome) == CMP_CHILD_MISSING) {
    snprintf(fig->missing, sizeof fig->missing,
             "gnuplot is not installed (apt install gnuplot-nox)");
  } else {
    char log[128];
    snprintf(log, sizeof log, "%s.log", fig->name);
    cmp_child_complaint(d->figures->temporary, log, "line ", why, sizeof why); /* the place */
    snprintf(fig->missing, sizeof fig->missing, "gnuplot could not draw it: %s", why);
  }
  d->failed += *fig->missing != 0;
}

/* ---- all of them ---- */

static double seconds(const struct timeval *t) {
  return (double)t->tv_sec + 1e-6 * (double)t->tv_usec;
}

/* Whether a worker has ended, been ended, or was idle. */
static bool worker_tend(struct drawing *d, struct worker *w) {
  int outcome;
  struct rusage use;
  if (!w->pid) return true;
  pid_t ended = wait4(w->pid, &outcome, WNOHANG, &use);
  if (ended == w->pid) {
    kill(-w->pid, SIGKILL); /* whatever it has left behind */
    w->pid = 0;
    d->used += seconds(&use.ru_utime) + seconds(&use.ru_stime);
    outcome_note(d, w->figure, outcome);
  } else if (progress_wall_clock() > w->deadline) {
    cmp_child_kill(&w->pid);
    snprintf(w->figure->missing, sizeof w->figure->missing,
             "gnuplot took longer than %g s and was stopped", d->limits.each);
    d->used += d->limits.each;
    d->failed++;
  }
  return !w->pid;
}

/* The next figure to draw, or NULL. The heavy ones come first, so that no worker is left with one
 * at the end while the others have nothing to do. */
static struct cmp_figure *figure_take(struct drawing *d) {
  for (;; d->small = true, d->next = 0) {
    while (d->next < d->figures->n) {
      struct cmp_figure *fig = &d->figures->figure[d->next++];
      if (fig->raster != d->small) return fig;
    }
    if (d->small) return NULL;
  }
}

static void rest_leave_out(struct drawing *d) {
  for (struct cmp_figure *fig; (fig = figure_take(d));)
    snprintf(fig->missing, sizeof fig->missing,
             "left out, for all figures together took more than %g s of processor time",
             d->limits.all);
}

static enum status figures_draw(struct drawing *d) {
  for (bool busy = true; busy;) {
    CHECK(!progress_stop_requested(), INTERRUPTED, "stopped while drawing figures");
    busy = false;
    for (size_t k = 0; k < d->workers; k++) {
      struct worker *w = &d->worker[k];
      bool idle = worker_tend(d, w);
      if (d->used > d->limits.all) rest_leave_out(d);
      struct cmp_figure *fig = idle ? figure_take(d) : NULL;
      if (fig) TRY(worker_start(d, w, fig));
      busy = busy || w->pid;
    }
    if (busy) nanosleep(&(struct timespec){.tv_nsec = 5000000}, NULL); /* a signal ends it */
  }
  return OK;
}

static enum status failures_raise(const struct cmp_figures *f, size_t failed) {
  const struct cmp_figure *first = f->figure;
  while (!*first->missing) first++;
  CHECK(failed < f->n, ERR_IO, "cannot draw figures: %s", first->missing);
  return status_raise(ERR_IO, "%zu of %zu figures could not be drawn; %s: %s", failed, f->n,
                      first->name, first->missing);
}

enum status cmp_figures_draw(struct cmp_figures *f, struct cmp_drawing_limits limits) {
  struct drawing d = {.figures = f, .limits = limits};
  const int processors = omp_get_num_procs();
  d.workers = (size_t)(processors < MOST_WORKERS ? processors : MOST_WORKERS);
  enum status status = figures_draw(&d);
  for (size_t k = 0; k < d.workers; k++) cmp_child_kill(&d.worker[k].pid);
  if (status != OK) {
    for (size_t i = 0; i < f->n; i++)
      snprintf(f->figure[i].missing, sizeof f->figure[i].missing, "%.250s", status_message());
    return status;
  }
  TRY(cmp_figures_publish(f));
  return d.failed ? failures_raise(f, d.failed) : OK;
}

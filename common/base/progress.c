#include "common/base/progress.h"

#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

#include "common/base/text.h"

struct progress {
  enum progress_mode mode;
  bool terminal, line_open;
  int notes; /* where the live line goes instead of the terminal; -1: nowhere else */
  char name[64];
  double end, time_scale; /* s; time_scale = sqrt(H/g) */
  double began, last_shown;
  double pace; /* smoothed seconds of clock per second of physics */
  double pace_clock, pace_time;
};

/* The run that asks progress_stop_requested() will write its last output and end by itself;
 * whatever else is going on (set-up, comparison) is not asked: it ends in the handler. A run killed
 * at any moment leaves readable files, so nothing is lost by that but the time. */
static volatile sig_atomic_t stop_requested, is_asked;

enum { EXIT_STOPPED = 3 };

static void on_signal(int number) {
  static const char word[] = "plunge: stopped\n";
  (void)number;
  if (stop_requested || !is_asked) {
    if (write(STDERR_FILENO, word, sizeof word - 1) < 0) _exit(EXIT_STOPPED);
    _exit(EXIT_STOPPED);
  }
  stop_requested = 1;
}

static const int stopping[] = {SIGINT, SIGTERM, SIGHUP};

void progress_catch_signals(void) {
  struct sigaction action = {.sa_handler = on_signal}, before;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (size_t i = 0; i < sizeof stopping / sizeof *stopping; i++)
    if (stopping[i] != SIGHUP ||
        (!sigaction(SIGHUP, NULL, &before) && before.sa_handler != SIG_IGN))
      sigaction(stopping[i], &action, NULL); /* nohup stays what it is */
}

/* What the parent orders, it also reports. */
static void on_order(int number) {
  (void)number;
  if (stop_requested || !is_asked) _exit(EXIT_STOPPED);
  stop_requested = 1;
}

void progress_obey_parent(void) {
  stop_requested = is_asked = 0;
  sigaction(PROGRESS_STOP, &(struct sigaction){.sa_handler = on_order, .sa_flags = SA_RESTART},
            NULL);
  for (size_t i = 0; i < sizeof stopping / sizeof *stopping; i++) signal(stopping[i], SIG_IGN);
}

void progress_hold_signals(bool hold) {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, PROGRESS_STOP);
  for (size_t i = 0; i < sizeof stopping / sizeof *stopping; i++) sigaddset(&set, stopping[i]);
  sigprocmask(hold ? SIG_BLOCK : SIG_UNBLOCK, &set, NULL);
}

void progress_ask_no_more(void) {
  is_asked = 0;
}

bool progress_is_stopped(void) {
  return stop_requested;
}

bool progress_stop_requested(void) {
  is_asked = 1;
  return stop_requested;
}

double progress_wall_clock(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

struct progress *progress_create(enum progress_mode mode) {
  struct progress *p = calloc(1, sizeof *p);
  if (!p) return NULL;
  const char *term = getenv("TERM");
  p->mode = mode;
  p->notes = -1;
  p->terminal = isatty(STDERR_FILENO) && !(term && !strcmp(term, "dumb"));
  return p;
}

void progress_destroy(struct progress *p) {
  free(p);
}

void progress_begin(struct progress *p, const char *name, double end, double time_scale) {
  is_asked = 0;
  snprintf(p->name, sizeof p->name, "%s", name);
  p->end = end;
  p->time_scale = time_scale;
  p->began = p->pace_clock = progress_wall_clock();
  p->last_shown = -INFINITY;
  p->pace_time = 0;
  p->pace = NAN;
}

void progress_format_time(char *out, size_t size, double seconds) {
  if (!(seconds >= 0) || seconds > 1e7)
    snprintf(out, size, "-");
  else if (seconds < 90)
    snprintf(out, size, "%.0f s", seconds);
  else if (seconds < 5400)
    snprintf(out, size, "%.0f min", seconds / 60);
  else
    snprintf(out, size, "%.1f h", seconds / 3600);
}

void progress_send(struct progress *p, int notes) {
  p->notes = notes;
}

bool progress_is_live(const struct progress *p) {
  return p->terminal && p->mode != PROGRESS_QUIET;
}

static void close_line(struct progress *p) {
  if (p->line_open) fputs("\r\033[K", stderr);
  p->line_open = false;
}

/* Columns of the terminal, less the one that would break the line. */
static int line_width(void) {
  struct winsize size;
  return !ioctl(STDERR_FILENO, TIOCGWINSZ, &size) && size.ws_col > 20 ? size.ws_col - 1 : 200;
}

void progress_show(struct progress *p, const struct progress_note *note, size_t n) {
  char line[2048] = "";
  if (!progress_is_live(p) || !n) return;
  for (size_t i = 0, at = 0; i < n && at < sizeof line; i++) {
    char left[32];
    progress_format_time(left, sizeof left, note[i].left);
    at += (size_t)snprintf(line + at, sizeof line - at, "%s%s %.0f%% %s", i ? "   " : "",
                           note[i].name, note[i].percent, left);
  }
  fprintf(stderr, "\r\033[K%.*s", line_width(), n > 1 ? line : note->line);
  fflush(stderr);
  p->line_open = true;
}

static void note_publish(struct progress *p, const struct progress_note *note) {
  if (!p->terminal)
    fprintf(stderr, "%s\n", note->line);
  else if (p->notes < 0)
    progress_show(p, note, 1);
  else if (write(p->notes, note, sizeof *note) < 0)
    return; /* the reader has more than enough */
}

/* Whether it is time for a line: a few a second on a terminal, else one every 10 s. */
static bool is_due(struct progress *p, double now) {
  if (p->mode == PROGRESS_QUIET || now - p->last_shown < (p->terminal ? 0.2 : 10)) return false;
  if (!p->terminal && p->last_shown == -INFINITY) { /* the first plain line comes after 10 s */
    p->last_shown = p->began;
    if (now - p->began < 10) return false;
  }
  return true;
}

void progress_count(struct progress *p, size_t done, size_t n, const char *unit) {
  const double now = progress_wall_clock(), part = n ? (double)done / (double)n : 1;
  if (!is_due(p, now)) return;
  p->last_shown = now;
  struct progress_note note = {.percent = 100 * part,
                               .left = done ? (now - p->began) * (1 / part - 1) : NAN};
  char left[32];
  progress_format_time(left, sizeof left, note.left);
  memcpy(note.name, p->name, sizeof note.name);
  snprintf(note.line, sizeof note.line, "%-10s %3.0f%%  %zu of %zu %s  %s left", p->name,
           note.percent, done, n, unit, left);
  note_publish(p, &note);
}

void progress_step(struct progress *p, size_t step, double time, double dt, double units_of_work,
                   const char *unit, double energy_drift) {
  double now = progress_wall_clock();
  if (!is_due(p, now)) return;
  double pace = (now - p->pace_clock) / (time - p->pace_time);
  if (isfinite(pace) && time > p->pace_time) {
    p->pace = isnan(p->pace) ? pace : 0.8 * p->pace + 0.2 * pace;
    p->pace_clock = now;
    p->pace_time = time;
  }
  p->last_shown = now;

  struct progress_note note = {.percent = p->end > 0 ? 100 * time / p->end : 0,
                               .left = (p->end - time) * p->pace};
  char left[32], drift[48] = "";
  progress_format_time(left, sizeof left, note.left);
  if (!isnan(energy_drift)) snprintf(drift, sizeof drift, "  energy %+.1e", energy_drift);
  double elapsed = now - p->began;
  memcpy(note.name, p->name, sizeof note.name);
  snprintf(note.line, sizeof note.line,
           "%-10s %3.0f%%  step %zu  t*=%.3f of %.2f  dt*=%.1e  %.2g %s/s  %s left%s", p->name,
           note.percent, step, time / p->time_scale, p->end / p->time_scale, dt / p->time_scale,
           elapsed > 0 ? units_of_work / elapsed : 0, unit, left, drift);
  note_publish(p, &note);
}

void progress_end(struct progress *p, const char *outcome) {
  is_asked = 0;
  close_line(p);
  if (p->mode != PROGRESS_QUIET)
    fprintf(stderr, "%-10s %s (%.1f s)\n", p->name, outcome, progress_wall_clock() - p->began);
}

void progress_say(struct progress *p, const char *format, ...) {
  close_line(p);
  if (p->mode == PROGRESS_QUIET) return;
  char *text = NULL;
  va_list args;
  va_start(args, format);
  if (vasprintf(&text, format, args) < 0) text = NULL;
  va_end(args);
  if (text) text_show(stderr, text, "");
  fputc('\n', stderr);
  free(text);
}

void progress_forward(struct progress *p, const char *text, size_t n) {
  close_line(p);
  fwrite(text, 1, n, stderr);
}

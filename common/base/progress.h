/* One live line on a terminal, plain lines otherwise, silence with --quiet; and Ctrl-C. */
#pragma once
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

struct progress;

enum progress_mode { PROGRESS_AUTO, PROGRESS_QUIET };

struct progress *progress_create(enum progress_mode mode);
void progress_destroy(struct progress *p);

/* Starts a stretch of work called `name` that ends at physical time `end` (s). */
void progress_begin(struct progress *p, const char *name, double end, double time_scale);

/* Cheap enough for every step: prints at most a few times a second. `time`, `dt` in s;
 * `units_of_work` so far (particle or node updates), `unit` their name; `energy_drift` relative,
 * NaN if unknown. */
void progress_step(struct progress *p, size_t step, double time, double dt, double units_of_work,
                   const char *unit, double energy_drift);
/* The same of work that is counted: `done` of n, the name of which is `unit`. */
void progress_count(struct progress *p, size_t done, size_t n, const char *unit);
void progress_end(struct progress *p, const char *outcome);

/* What a live line is made of. */
struct progress_note {
  char name[64];
  double percent, left; /* s; NaN if unknown */
  char line[256];       /* all of it, for when there is no other */
};

bool progress_is_live(const struct progress *p); /* on a terminal, and not quiet */
/* The live line goes to a pipe, a note at a time, for another process to show; a pipe that is full
 * loses some. */
void progress_send(struct progress *p, int notes);
/* Shows the live line of one stretch of work, or of n at once in short form. */
void progress_show(struct progress *p, const struct progress_note *note, size_t n);
/* Prints what another process has said, also when quiet. */
void progress_forward(struct progress *p, const char *text, size_t n);

/* A line of talk (stderr) that does not break the live line. */
void progress_say(struct progress *p, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* SIGINT, SIGTERM and SIGHUP end the program at once with exit code 3, but for a run that has begun
 * to ask: there the first one sets a flag, and a second one ends the program. */
void progress_catch_signals(void);
bool progress_is_stopped(void);     /* the same without a promise to ask again */
bool progress_stop_requested(void); /* to be asked every step from the first one on */
void progress_ask_no_more(void);    /* a signal ends the program at once again */
double progress_wall_clock(void);   /* s, monotonic */

/* In a child: its parent alone says when to stop, by this signal; what the terminal sends to both,
 * the child leaves to the parent. Signals are held while the child is made. */
#define PROGRESS_STOP SIGUSR1
void progress_obey_parent(void);
void progress_hold_signals(bool hold);

/* "12 s", "3 min", "4.5 h"; "-" when that is unknown. */
void progress_format_time(char *out, size_t size, double seconds);

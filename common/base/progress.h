/* One live line on a terminal, plain lines otherwise, silence with --quiet; and Ctrl-C. */
#pragma once
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
void progress_end(struct progress *p, const char *outcome);

/* A line of talk (stderr) that does not break the live line. */
void progress_say(struct progress *p, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* SIGINT, SIGTERM and SIGHUP end the program at once with exit code 3, but for a run that has begun
 * to ask: there the first one sets a flag, and a second one ends the program. */
void progress_catch_signals(void);
bool progress_is_stopped(void);     /* the same without a promise to ask again */
bool progress_stop_requested(void); /* to be asked every step from the first one on */
double progress_wall_clock(void);   /* s, monotonic */

/* "12 s", "3 min", "4.5 h"; "-" when that is unknown. */
void progress_format_time(char *out, size_t size, double seconds);

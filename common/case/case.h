/* The case file: YAML in, one checked struct out. Everything is in SI units here. */
#pragma once
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "common/base/geometry.h"
#include "common/base/status.h"
#include "common/solver.h"
#include "common/tank/motion.h"

struct flow;

struct case_probe { /* wall pressure sensor */
  char *name;
  double x, y; /* centre, m, on a wall */
  double size; /* length along the wall over which it averages, m; 0 is a point */
};

struct case_gauge { /* vertical wire */
  char *name;
  double x; /* m */
};

struct case_point { /* in the water or on a wall */
  char *name;
  double x, y; /* m */
  int every;   /* steps of SPH from one row to the next */
  bool follow; /* the particle that is nearest at t = 0, of SPH alone */
};

/* What is known of the water at a point: of SPH means over the particles around it, or what the
 * particle has that is followed. NaN where there is next to no water, or where the solver does not
 * know it. X(name, units, help) */
#define CASE_POINT(X)                                                                              \
  X(p, "Pa", "pressure, of SPH by the equation of state")                                          \
  X(rho, "kg/m^3", "density")                                                                      \
  X(u, "m/s", "velocity along x")                                                                  \
  X(v, "m/s", "velocity along y")                                                                  \
  X(a_x, "m/s^2", "acceleration along x")                                                          \
  X(a_y, "m/s^2", "acceleration along y")                                                          \
  X(cover, "1",                                                                                    \
    "1 in the water, 0 outside; of SPH sum V W, below 0.1 of which there are no means")            \
  X(x, "m", "where it is")                                                                         \
  X(y, "m", "where it is")

enum { /* CASE_POINT_p, CASE_POINT_rho, ... */
#define X(name, units, help) CASE_POINT_##name,
       CASE_POINT(X)
#undef X
           CASE_POINT_FIELDS
};
extern const char *const case_point_fields[CASE_POINT_FIELDS]; /* names */

enum { CASE_LONGEST_NAME = 64 }; /* bytes, of a run, a probe, a gauge or a point */

struct case_run {
  char *name;
  const struct solver *solver;
  double resolution; /* H/dx for SPH, nodes per H for BEM; dx = H/resolution */
  void *options;     /* the solver's own struct, filled from its table; owned */
  int line;          /* of the run in the file, for messages */
  int *key_line;     /* of its keys: see case_run_line; owned */
  bool *key_given;   /* whether the run has them itself: see case_run_gives; owned */
};

struct case_tolerance {
  char *measure; /* one of the registry's measures */
  double at;     /* s; NaN: every comparison time */
  double max;    /* in the measure's own units: FAIL above it */
  size_t n_runs; /* 0: every run but the reference */
  size_t *runs;  /* indices into case_file.runs, [n_runs], owned */
};

struct case_average { /* a probe's signals are compared by their running means */
  size_t probe;       /* index into case_file.probes */
  double over;        /* s; 0: none */
};

/* What a probe's pressure is shown by beside what it is. X(name, help) */
#define CASE_FILTERS(X)                                                                            \
  X(low_pass,                                                                                      \
    "p = sum_k a_k cos(k pi t/D) over its duration D with a_k times 1 up to half the cut-off "     \
    "frequency f = 1/period, (1 - sin(pi (f_k/f - 1)))/2 up to 3/2, and 0; keeps the impulse")     \
  X(wall,                                                                                          \
    "the mean over the length of the wall, each probe there standing for what is nearest to it")   \
  X(impulse, "I(t) = int p dt from the first row on: each wave of frequency w over w")

enum case_filter_kind { /* CASE_FILTER_low_pass, ... */
#define X(name, help) CASE_FILTER_##name,
                        CASE_FILTERS(X)
#undef X
};

enum { CASE_LEAST_ON_WALL = 3 }; /* places; of less the mean would be nearly the probe's own */

struct case_filter {
  size_t probe; /* index into case_file.probes */
  enum case_filter_kind kind;
  double period; /* s, of low_pass */
  double length; /* m, of wall */
};

enum { CASE_MOST_PEAKS = 12 };

struct case_spectrum {
  char *series;    /* of a probe, a gauge, or "NAME.FIELD" of a point */
  double from, to; /* s; INFINITY: to the end */
  size_t peaks;    /* how many are listed, at most CASE_MOST_PEAKS */
};

struct case_experiment { /* a measured series laid over a probe's or a gauge's plot */
  char *label;           /* "Buchner 2002, digitisation a" */
  char *source;          /* the citation */
  char *target;          /* name of a probe or gauge, or "front" */
  size_t n;
  double *t, *value; /* s, and Pa or m, [n], owned */
};

/* X(name, help): what happens at an instant, as solvers name it. */
#define CASE_EVENTS(X)                                                                             \
  X(wall_impact, "the front reaches its wall")                                                     \
  X(overturning, "a face becomes vertical")                                                        \
  X(touchdown, "a jet reaches the water below")                                                    \
  X(self_contact, "the surface meets itself or a wall with air between")                           \
  X(overflow, "water passes the top of a wall")                                                    \
  X(run_up, "an edge of the water is highest on its slope")
enum {
#define X(name, help) CASE_EVENT_OF_##name,
  CASE_EVENTS(X)
#undef X
      CASE_N_EVENTS
};
enum case_event_part { CASE_EVENT_time, CASE_EVENT_x, CASE_EVENT_y, CASE_N_EVENT_PARTS };
extern const char *const case_event_names[], *const case_event_parts[]; /* "time", "x", "y" */

struct case_event {     /* a published number of an event */
  int event, part;      /* places in the two lists */
  double value, within; /* s or m; a larger difference fails */
  char *source;         /* owned */
  size_t n_runs;        /* 0: every run, and the reference */
  size_t *runs;         /* indices into case_file.runs, [n_runs], owned */
};

struct case_profile { /* a measured surface at an instant, laid over those of the runs */
  char *label, *source;
  double time; /* s */
  size_t n;
  double *x, *y; /* m, [n], owned */
};

struct case_file {
  char *path; /* as given by the user, "stdin" for "-"; "" when read from a result file */
  char *text; /* the case as run: the file with the overrides applied, still valid YAML */
  char *title;
  double density; /* rho_0, kg m^-3 */
  double gravity; /* m s^-2, along `down` */
  double down[2]; /* of length 1; (0, -1) unless the case says otherwise */
  double g;       /* of the scales, m s^-2: gravity, or where there is none what the case says */
  double H; /* scale of length, m; times are reported as t sqrt(g/H), pressures as p/(rho g H) */

  struct geo_lines walls; /* water lies on the left of every wall (down the left side, along the
                             bed, up the right side) */
  struct geo_box tank;    /* box of the walls */
  bool rectangular;       /* one open piece: left wall, flat bed, right wall */
  bool periodic[2];       /* along x: the sides are no walls; along y: nor is the bed */
  size_t n_motions;       /* of the tank or its sides; of a case that is read from a result file, */
  struct tank_motion *motions; /* those that came from a file are at rest */

  const struct flow *flow; /* the water at t = 0 (common/flow/flow.h) */
  void *form;              /* what the case says of it, in a struct of its own; owned */
  struct geo_lines water;  /* closed counter-clockwise regions, or the outline of the wave */
  double velocity[2];      /* of the regions at t = 0, m/s, that have none of their own */
  bool regions_differ;     /* some have */
  double (*velocities)[2]; /* of each region, [water.pieces], owned; NULL: there are none */

  double end;    /* s, last output time */
  double every;  /* s: surfaces and particles are written at exactly the multiples of it */
  double sample; /* s: series (energy, probes, gauges, run) get a row at the first step after each
                    multiple of it; default every/10 */

  size_t n_probes, n_gauges, n_points, n_runs;
  struct case_probe *probes;
  struct case_gauge *gauges;
  struct case_point *points;
  struct case_run *runs;

  struct {
    size_t reference; /* index into runs; n_runs when the case compares nothing */
    size_t n_times;
    double *times;         /* s */
    struct geo_box window; /* the part of the surface that is compared; default: everything */
    size_t n_tolerances;
    struct case_tolerance *tolerances;
    size_t n_averages;
    struct case_average *averages;
    size_t n_filters;
    struct case_filter *filters;
    size_t n_spectra;
    struct case_spectrum *spectra;
    size_t n_experiments;
    struct case_experiment *experiments;
    size_t n_profiles;
    struct case_profile *profiles;
    size_t n_events;
    struct case_event *events;
  } compare;
};

/* One problem a line: "dam.yaml:12: runs.antuono.alpha: found '-1'; allowed: a number from 0 to 1".
 * problems_add takes the part after the place; case_load puts "FILE:LINE: " before it and sorts. */
struct problems {
  size_t n, room;
  size_t unlisted; /* further ones, beyond the first hundred */
  bool out_of_memory;
  char **text; /* [n], owned */
  int *line;   /* [n], from 1; 0: the file as a whole; -k: the k-th --set */
};
void problems_add(struct problems *p, int line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
void problems_destroy(struct problems *p);

/* Sorts the problems and puts their place before each. */
void problems_finish(struct problems *p, const char *file, size_t n_set, const char *const *set);

/* Where to point when value `key` of a run is wrong: the line of the key, of the run without it. */
int case_run_line(const struct case_run *r, const char *key);

/* What a side does at most: to the left and to the right, m and rad. */
struct case_strokes {
  double piston[2], flap[2];
};
struct case_strokes case_find_strokes(const struct case_file *c, int side);

/* For the check of a solver whose walls do not move: refuses tank.motions. */
void case_refuse_motions(const struct case_file *c, const struct case_run *r,
                         struct problems *problems);

void case_event_destroy(struct case_event *e);     /* what it owns */
void case_profile_destroy(struct case_profile *p); /* what it owns */

/* Whether a run has value `key` itself, not from a named scheme or the solver's table. */
bool case_run_gives(const struct case_run *r, const char *key);

/* For the check of a flow: what is wrong at a key of its section (NULL: with all of it), as
 * case_doc_problem takes it. */
struct case_draft;
void case_flow_problem(struct case_draft *d, const char *key, const char *found,
                       const char *allowed, const char *todo);

/* Lengths, areas and times closer than this part of the whole are the same: decimal input and its
 * rounding in "5.366 H" stay far below, and no particle or node resolves it. */
extern const double CASE_SAME;
double case_tank_size(const struct case_file *c); /* the longer side of the tank's box, m */
double case_near(const struct case_file *c);      /* lengths closer than this (m) are the same */

/* Reads, overrides and checks a case; `path` "-" is standard input. `set` holds "path=value"
 * strings (runs.NAME.key=value, time.end=...). On ERR_INPUT *problems lists every problem found
 * (file, line, key, value found, what is allowed, what to do) and *c is NULL. Data files are taken
 * relative to the case file. */
enum status case_load(const char *path, size_t n_set, const char *const *set,
                      const struct registry *registry, struct problems *problems,
                      struct case_file **c);

/* The same from the text in a result file (`name` stands for the file in messages); experiments
 * are left empty: they are in the result file itself. */
enum status case_parse(const char *name, const char *text, const struct registry *registry,
                       struct problems *problems, struct case_file **c);

struct case_names {
  size_t n;
  const char *const *name; /* [n], borrowed */
};

/* What is known of results that are there already, for settings that stand by themselves. */
struct case_frame {
  double H, g;                   /* of the scales, m, m s^-2 */
  struct geo_box tank;           /* m */
  const struct geo_lines *walls; /* m, as the result has them, or NULL */
  const char *tank_text;         /* of the case that says how they move; NULL: the settings' own */
  size_t n_times;
  const double *times;    /* s, of the reference's outputs, [n_times] */
  struct case_names runs; /* the reference's first */
  struct case_names probes, gauges, points;
};

/* Settings of a comparison (the section `compare` alone) from a YAML file: *c has runs, probes,
 * gauges and points with names and nothing else, and `compare` filled. Problems as case_load. */
enum status case_load_settings(const char *path, const struct case_frame *frame,
                               const struct registry *registry, struct problems *problems,
                               struct case_file **c);

/* The same from the case in a result file (`name` stands for the file in messages), "" of one that
 * has none: of its sections other than `compare` only `time` and the names in its lists are looked
 * at, so that it may be of another version, or have solvers that nobody knows. Its own names are
 * there beside the frame's; data files are not read. */
enum status case_parse_settings(const char *name, const char *text, const struct case_frame *frame,
                                const struct registry *registry, struct problems *problems,
                                struct case_file **c);

/* The keys of n runs in the text of a case and their values in words, in alphabetical order, but
 * for name, solver and how fine a run is: runs that have the same differ by their resolution alone.
 * settings [n]: NULL where the text has no such run, or is no case; owned by the caller.
 * ERR_MEMORY, and all of them NULL. */
enum status case_run_settings(const char *text, size_t n, const char *const *run, char **settings);

/* Which ends of the tank are no walls by the text of a case (`periodic` of struct case_file): none
 * where it is no case. ERR_MEMORY. */
enum status case_periodic_ends(const char *text, bool periodic[2]);
void case_destroy(struct case_file *c);

/* Every section with its keys: what is allowed, the default, what it is (for `plunge list`). */
void case_print_keys(FILE *out);

/* Identifies everything that a run's result depends on: program version and revision, the case
 * without other runs and without `compare`, and the run's options (hex digits, 32 + NUL). */
void case_fingerprint(const struct case_file *c, const struct case_run *r, char out[33]);

/* Identifies what results must share to be compared at all: the tank, the water at t = 0, the fluid
 * and the scales, whatever solves them how finely for how long (hex digits, 32 + NUL). */
void case_water_fingerprint(const struct case_file *c, char out[33]);

/* The same of any text of n bytes. */
void case_text_fingerprint(const char *text, size_t n, char out[33]);

bool case_water_moves(const struct case_file *c); /* regions, at t = 0 */

double case_water_area(const struct case_file *c); /* m^2, at t = 0 */

/* Gravity has a direction of its own, which few can deal with. */
static inline bool case_is_turned(const struct case_file *c) {
  return c->down[0] != 0 || c->down[1] > 0;
}

/* Lines of the case, turned about the origin until gravity is downwards. ERR_MEMORY. */
enum status case_turn_lines(const struct case_file *c, const struct geo_lines *from,
                            struct geo_lines *to);

/* Where that water stands at rest, m. */
double case_rest_level(const struct case_file *c);

/* Potential energy (J per metre of width, y from 0) of the same water at rest in the tank. */
double case_rest_potential(const struct case_file *c);

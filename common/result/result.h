/* The result file (HDF5): the contract between solvers, comparator and users. The layout is
 * described in docs/result-file.md. SI units; every dataset has an attribute `units`. */
#pragma once
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "common/base/geometry.h"
#include "common/base/status.h"
#include "common/case/case.h"

/* ---- writing ---- */

struct result;

/* What is known of energy at one output, J per metre of width: what every solver has, and what has
 * left the water so far by terms that each solver names for itself (solver.h). */
#define RESULT_ENERGY(X)                                                                           \
  X(kinetic, "kinetic energy")                                                                     \
  X(potential, "potential energy, y from 0")                                                       \
  X(internal, "elastic energy of the weakly compressible fluid")                                   \
  X(total, "kinetic + potential + internal")                                                       \
  X(removed, "energy of water taken out of the computation so far")

enum { RESULT_TERMS = 32, RESULT_DIAGNOSTICS = 32 }; /* a solver's own, at most */

struct result_energy {
  double time; /* s */
#define X(name, help) double name;
  RESULT_ENERGY(X)
#undef X
  double term[RESULT_TERMS]; /* beyond the last of them 0 */
};

/* The budget that must close, kinetic + potential + internal + removed + all terms: it keeps its
 * value at t = 0. */
double result_energy_budget(const struct result_energy *e);

struct result_step {     /* one row of /series/run */
  double time, dt;       /* s */
  double evaluations;    /* of the right-hand side so far */
  double wall_time;      /* s, of the clock on the wall, so far */
  double volume;         /* m^2 */
  double removed_volume; /* m^2, taken out of the computation so far */
};

struct result_field {
  const char *name, *units, *help;
  const double *a, *b; /* [n]; b is NULL for a scalar, else the y component of a vector */
};

enum result_cells { RESULT_VERTICES, RESULT_LINE }; /* loose particles, or one polyline */

/* What a result file says before the run. What it points to is borrowed: texts until the file is
 * there, all else until it is written. */
struct result_about {
  const char *solver, *run, *title;
  const char *version, *revision; /* of the program; "" as below */
  const char *imported;           /* how it was made of another program's files; NULL: it was not */
  const char *case_text, *fingerprint, *water_fingerprint; /* "": there is none */
  bool floats;                                             /* a body without gravity */
  double H, g, density;                                    /* m, m s^-2, kg m^-3 */
  double resolution;                                       /* H over the spacing */
  double rest_potential;                                   /* J/m */
  const struct geo_lines *walls;                           /* of no piece: there are none */
  size_t n_probes, n_gauges, n_points;
  const struct case_probe *probes;
  const struct case_gauge *gauges;
  const struct case_point *points;
  size_t n_terms; /* of the solver, see solver.h */
  const struct solver_term *terms;
  size_t n_params;
  const struct param *params; /* the table behind `options` */
  const void *options;
  size_t n_experiments, n_profiles;
  const struct case_experiment *experiments;
  const struct case_profile *profiles;
};

/* Creates (truncates) the file with its header and empty series, and the .xdmf beside it. ERR_IO
 * with what to do. */
enum status result_begin(const char *path, const struct result_about *about, struct result **out);

/* The same of a run of a case. */
enum status result_create(const char *path, const struct case_file *c, const struct case_run *r,
                          struct result **out);

/* Append one output. result_flush ends an output time: what came before it survives a kill. Each of
 * these refuses beforehand, with ERR_IO, when the disk has no room, and leaves earlier outputs
 * readable. */
enum status result_points(struct result *w, double time, size_t n, const double *x, const double *y,
                          enum result_cells cells, size_t n_fields,
                          const struct result_field *fields); /* same fields at every output */
enum status result_surface(struct result *w, double time, const struct geo_lines *surface);
enum status result_energy(struct result *w, const struct result_energy *row);
enum status result_step(struct result *w, const struct result_step *row);
enum status result_probe(struct result *w, size_t probe, double time, double pressure);  /* Pa */
enum status result_gauge(struct result *w, size_t gauge, double time, double elevation); /* m */
/* A row at a point of the case, which has its series from the first one on; `value` in the order
 * of CASE_POINT. */
enum status result_point(struct result *w, size_t point, double time,
                         const double value[CASE_POINT_FIELDS]);
/* A row of what a run tells of itself, [n] values, n at most RESULT_DIAGNOSTICS; the same columns
 * in every row. The file has them from the first one on. */
enum status result_diagnostics(struct result *w, double time, size_t n,
                               const struct solver_diagnostic *columns, const double *values);
enum status result_event(struct result *w, const char *name, double time, double x, double y);
enum status result_statistic(struct result *w, const char *name, double value, const char *units,
                             const char *help);
enum status result_flush(struct result *w);

/* ---- error bars ---- */

/* A coarser run of the same case, in memory: of what a solver writes into it only what error bars
 * need is kept, and nothing reaches the disk. */
enum status result_create_coarser(const struct case_file *c, const struct case_run *r,
                                  struct result **out);

/* What the two runs are to each other: the ratio of their spacings, and the order in the spacing at
 * which their errors are taken to fall. */
struct result_coarser {
  double ratio, order;
};

/* From now on what `w` gets is held against what `coarser` has of the same instant, event or
 * surface, and its standard error is written as well: before anything else is, and `coarser` must
 * outlive it. */
enum status result_hold_against(struct result *w, const struct result *coarser,
                                const struct result_coarser *how);

/* ---- what is known at the end ---- */

/* The potential energy (J/m) of the solver's own water at rest, where that is not the
 * incompressible water of the case (case_rest_potential, which result_create writes). */
enum status result_rest(struct result *w, double potential);

/* Says in one sentence why the run ended before the end of its case: a failure, a stop, or an event
 * beyond which the solver cannot go (the touchdown of a jet). Kept with the next flush. */
enum status result_ended(struct result *w, const char *why);

/* Judges the run by what was written so far (common/result/health.h) and keeps that with the next
 * flush. `broke_off`: why the run failed, "" when it did not. */
struct health;
enum status result_health(struct result *w, const char *broke_off, struct health *h);

enum status result_finish(struct result *w); /* marks the file complete */
void result_destroy(struct result *w);       /* closes it, complete or not; NULL is fine */
/* The same, and removes it and the .xdmf beside it: of what is worth nothing by halves. */
void result_discard(struct result *w);

/* ---- reading ---- */

struct result_series {
  char *name, *units;
  char *help;        /* of a diagnostic; "" of others */
  double x, y, size; /* of a probe or gauge, m */
  size_t n;
  double *t, *value; /* [n] */
  size_t n_errors;   /* n, or 0: it has no error bars */
  double *error;     /* standard errors of the values, NaN where not known, [n_errors] */
};

struct result_point_read {
  char *name;
  double x, y; /* m */
  size_t n;
  double *t, *value[CASE_POINT_FIELDS]; /* [n] */
};

struct result_event_read {
  char *name;
  double time, x, y;
  double error[3]; /* standard errors of these, NaN where not known */
};

struct result_statistic_read {
  char *name, *help;
  double value;
};

struct result_term_read { /* of the budget of energy; its values: energy[].term */
  char *name, *help;
  bool outside; /* see struct solver_term */
};

/* Everything but the particles, in memory. A child process reads it: what is added here is also
 * handed over in result_carry.c. */
struct result_file {
  char *path, *solver, *run, *title, *version, *revision, *case_text, *fingerprint;
  char *water_fingerprint; /* case_water_fingerprint of its case; "" in files of before it */
  char *settings; /* of the solver, but for its resolution, in the words of whoever wrote them; "" */
  char *created;           /* UTC, 2026-11-22T19:24:21Z */
  char *imported;          /* how it was made of another program's files; "" when it was not */
  char *ended;  /* why it ended before the end of its case, one sentence; "" when it did not */
  char *health; /* verdict when it ended: sound, doubtful or failed; "" before that, or older */
  bool complete;
  bool floats;                   /* the water is a body without gravity */
  double H, g, density, spacing; /* m, m s^-2, kg m^-3, m */
  double rest_potential;         /* J/m */
  double c0;                     /* speed of sound, m/s; NaN: its solver has none */
  struct geo_lines walls;

  bool surfaces_found; /* from the particles, by result_find_all_surfaces */
  size_t n_surfaces;
  double *surface_time;
  struct geo_lines *surface; /* [n_surfaces] */
  size_t n_surface_errors;   /* of the points of all surfaces, in their order; 0: no error bars */
  double *surface_error;     /* standard errors across the surface, m, [n_surface_errors] */
  struct result_coarser coarser; /* than the run was the one that they come from; zeros: none */

  size_t n_energy;
  struct result_energy *energy;       /* [n_energy] */
  size_t n_energy_errors;             /* n_energy, or 0: there are no error bars */
  struct result_energy *energy_error; /* standard errors, [n_energy_errors] */
  size_t n_terms;
  struct result_term_read *terms; /* [n_terms] */
  size_t n_steps;
  struct result_step *steps; /* [n_steps] */

  size_t n_probes, n_gauges, n_events, n_experiments, n_statistics;
  struct result_series *probes, *gauges;
  size_t n_points;
  struct result_point_read *points; /* those that have series */
  size_t n_diagnostics;
  struct result_series *diagnostics; /* on the same times; units are their own */
  struct result_event_read *events;
  struct case_experiment *experiments;
  size_t n_profiles;
  struct case_profile *profiles;
  struct result_statistic_read *statistics;
  size_t n_outputs; /* of points */
  double *output_time;
  int64_t *output_points; /* how many, [n_outputs] */
  size_t n_fields;
  char **fields; /* names for result_stream (scalars and vectors), [n_fields] */
};

/* ERR_INPUT with one sentence when the file is missing, truncated, damaged or not a result file. */
enum status result_read(const char *path, struct result_file **out);
void result_file_destroy(struct result_file *f);

enum { RESULT_WANTED = 4 }; /* fields at a time, at most */

struct result_wanted {
  const char *name;
  bool vector;   /* its x and y */
  bool optional; /* a file may be without it */
};

struct result_water { /* the points of one output */
  size_t n;
  double (*p)[2];               /* m, [n]; NULL: not wanted */
  double *value[RESULT_WANTED]; /* [n]; of vectors their x and y in turn, [2 n]; NULL: none */
};

/* Hands over the points of n outputs with some fields, one output after the other, so that no more
 * than one is in memory; the file is opened and checked once. `take` may keep what it is given, and
 * zeroes what it keeps; its failure ends it. */
enum status result_stream(const char *path, size_t n_fields, const struct result_wanted *field,
                          size_t n, const size_t *output,
                          enum status (*take)(void *data, size_t k, struct result_water *water),
                          void *data);
void result_water_free(struct result_water *water);

/* What is wanted of each output: some of its points, and whether their places, too. */
struct result_part {
  size_t n;
  const size_t *point; /* [n], ascending, each less than every output's number of points; NULL: all */
  bool no_places;
};

/* The same of a part of each output: what is stored far from it is not inflated. */
enum status result_stream_part(const char *path, const struct result_part *part, size_t n_fields,
                               const struct result_wanted *field, size_t n, const size_t *output,
                               enum status (*take)(void *data, size_t k, struct result_water *water),
                               void *data);

/* Finds the surfaces of those of n files that have particles and no /surface, by common/cloud, at
 * each output that they have; those of others stay. Walls, and the case that says which of them are
 * periodic: a file's own, or those of the first that has walls; without any, nothing is found.
 * ERR_INPUT: particles that are too scattered. */
enum status result_find_all_surfaces(size_t n, struct result_file *const *files);

/* Whether `path` is a finished result with this fingerprint (never raises). */
bool result_is_current(const char *path, const char *fingerprint);

/* A case while it is being read: what the reader, the checks and the overrides share. Internal. */
#pragma once
#include <stddef.h>

#include "common/case/case_doc.h"

enum { CASE_MOST_ITEMS = 1000 }; /* runs, probes, times ... in one list */

struct case_draft {
  struct case_doc doc;
  struct case_file *c;
  const struct registry *registry;
  bool read_data; /* what is in files of its own is read: experiments, motions, surfaces */
  struct {        /* the nodes of the sections, 0 when absent */
    int fluid, scales, tank, water, time, probes, gauges, points, runs, compare;
  } at;
  struct { /* sections read without a fault: what the checks may rely on */
    bool scales, tank, water, time, probes, gauges, points, runs;
    bool shapes; /* tank and water make sense together */
  } good;
  size_t wall_item[CASE_MOST_ITEMS]; /* of tank.walls that each wall begins with: joined ones are
                                        one */
  int pressure;                      /* water.pressure: place among the flows of regions */
};

/* Table rows for a member of a struct that has the key's name. */
#define ROWS(table) sizeof(table) / sizeof *(table)
#define REAL(struct_, member, qty, lo, hi, def, text)                                              \
  {                                                                                                \
    .key = #member, .type = PARAM_REAL, .quantity = qty, .offset = offsetof(struct_, member),      \
    .min = lo, .max = hi, .value = def, .help = text                                               \
  }
#define NODE(struct_, member, def, text)                                                           \
  {                                                                                                \
    .key = #member, .type = PARAM_NODE, .offset = offsetof(struct_, member), .value = def,         \
    .help = text                                                                                   \
  }
#define TEXT(struct_, member, longest, def, text)                                                  \
  {                                                                                                \
    .key = #member, .type = PARAM_TEXT, .offset = offsetof(struct_, member), .max = longest,       \
    .value = def, .help = text                                                                     \
  }

struct case_table { /* what `plunge list` shows of a section; a NULL name ends a list of them */
  const char *name;
  const struct param *params;
  size_t n;
};

/* case_sections.c: every section but runs and compare. */
enum status case_read_sections(struct case_draft *d);
void case_read_time(struct case_draft *d);
bool case_read_section(struct case_draft *d, int node, const char *path, const struct param *rows,
                       size_t n, void *into);
void case_release_form(struct case_file *c);

/* case_sweep.c: puts runs with one value each in the place of runs that have `sweep`. False with
 * problems: what else is wrong with runs cannot be told then. */
bool case_sweep_expand(struct case_doc *d);

/* case_runs.c: runs, then compare, which names them. */
enum status case_read_runs(struct case_draft *d);
enum status case_read_compare(struct case_draft *d);
/* Names of runs as indices, *runs the caller's; the reference may be among them or not. */
enum status case_read_run_names(struct case_draft *d, int node, const char *path, bool reference,
                                size_t *n, size_t **runs);

extern const struct case_table case_section_tables[], case_run_tables[];

size_t case_find_probe(struct case_draft *d, int node, const char *path); /* n_probes: none */

/* case_signals.c: compare.filters and compare.spectra. */
enum status case_read_filters(struct case_draft *d, int node);
enum status case_read_spectra(struct case_draft *d, int node);
extern const struct case_table case_signal_tables[];
/* `end` (s): the last time there is, which is `what`; `sample` (s): no series is finer than this.
 */
void case_check_filters(struct case_draft *d, double sample, double end, const char *what);
void case_check_spectra(struct case_draft *d, double end, const char *what);

/* case_check.c: whether what was read makes sense together. */
void case_check(struct case_draft *d);
/* A probe or a gauge of the mapping `item`, called `path`, in a tank that is good. */
void case_check_probe(struct case_draft *d, const struct case_probe *p, int item, const char *path);
void case_check_gauge(struct case_draft *d, double x, int item, const char *path);
void case_check_tolerances(struct case_draft *d); /* their times are among compare.times */
/* That *time, the key of an item, is one of compare.times, and then exactly that; a problem if not.
 */
void case_check_compared(struct case_draft *d, int item, const char *key, const char *path,
                         double *time);
/* A time in the unit that the one at `node` is written in. */
void case_time_words(struct case_draft *d, int node, double seconds, char out[64]);
void case_check_averages(struct case_draft *d, double end, const char *what); /* s */
void case_check_window(struct case_draft *d);

/* case_check_geometry.c: tank and water; what fails is no longer good. */
void case_check_geometry(struct case_draft *d);
void case_check_walls(struct case_draft *d); /* the walls of `at.tank` alone */

/* case_lines.c: walls and regions, and what their points are made of. */
bool case_read_pair(struct case_doc *doc, int node, const char *path, const struct param *row,
                    const char *what, double out[2]);
bool case_read_point(struct case_doc *doc, int node, const char *path, double out[2]);
bool case_read_velocity(struct case_doc *doc, int node, const char *path, double out[2]);
enum status case_read_walls(struct case_draft *d, int node);
enum status case_read_regions(struct case_draft *d, int node);
extern const struct case_table case_line_tables[];

/* case_rows.c: two to four columns of numbers from a text file, its path relative to the case
 * file, in SI units. Adds problems; `line` and `path` are those of the key that names it. */
enum { CASE_MOST_COLUMNS = 4 };
struct case_columns {
  const char *what; /* "time, value" */
  size_t most;      /* 2, or more: those after the second may be missing in all lines */
  double unit[CASE_MOST_COLUMNS]; /* of the file's numbers, SI */
  enum { CASE_ROWS_ANY, CASE_ROWS_DO_NOT_FALL, CASE_ROWS_RISE } order; /* of the first one */
  const char *ordered, *si; /* "times that increase"; SI unit of the first one */
};
struct case_rows {
  size_t n, columns;
  double *x, *y, *z, *w; /* [n], owned; z, w NULL: fewer columns */
};
enum status case_read_rows(struct case_draft *d, const char *file, int line, const char *path,
                           const struct case_columns *columns, struct case_rows *r);
/* Rows that a spline shall go through: enough of them, and no hole. */
enum status case_check_rows(struct case_draft *d, const char *file, int line, const char *path,
                            const struct case_columns *columns, const struct case_rows *r);
void case_rows_destroy(struct case_rows *r);

/* case_motion.c: tank.motions, behind the walls; what they are checked for when all is read. */
enum status case_read_motions(struct case_draft *d, int node);
void case_check_motions(struct case_draft *d);
void case_release_motions(struct case_file *c);
/* A problem of motion i at one of its keys, or with all of it. */
void case_motion_problem(struct case_draft *d, size_t i, const char *key, const char *found,
                         const char *allowed, const char *todo);

/* case_stroke.c: how far sides move. ERR_MEMORY. */
enum status case_check_strokes(struct case_draft *d);

extern const struct case_table case_motion_tables[];

/* case_profile.c: compare.profiles; their times are among compare.times. */
enum status case_read_profiles(struct case_draft *d, int node);
void case_check_profiles(struct case_draft *d);
extern const struct case_table case_profile_tables[];

/* case_event.c: compare.events. */
enum status case_read_events(struct case_draft *d, int node);
void case_check_events(struct case_draft *d);
extern const struct case_table case_event_tables[];

/* case_experiment.c: reads the data file of e, a path relative to the case file, into SI units.
 * Adds problems; `line` and `path` are those of the key `file`. */
enum status case_read_experiment(struct case_draft *d, struct case_experiment *e, const char *file,
                                 int line, const char *path);

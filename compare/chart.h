/* One chart against time, of one or more panels above each other: axes, key, the reference's
 * instants as vertical lines, and the table that it is drawn from. */
#pragma once
#include "compare/comparison.h"
#include "compare/figure.h"
#include "compare/frame.h"
#include "compare/panels.h"
#include "compare/pick.h"

/* "run r" or, for SIZE_MAX, the reference. */
const struct cmp_run *cmp_run_or_ref(const struct comparison *c, size_t r);

struct cmp_chart {
  const struct comparison *c;
  struct cmp_figure *fig;
  FILE *table, *others; /* of what is named in the key; of the runs that are not */
  size_t other;         /* the run that `others` is at */
  size_t panels;
  struct cmp_key key;
  double end;   /* of the time axis */
  bool first;   /* the next curve opens a plot command */
  int marks[2]; /* at the top and the bottom of this panel so far */
};

struct cmp_chart_plan {
  enum cmp_section section;
  const char *name, *columns; /* of its files; of the table after series, name and t_star */
  size_t panels;
  int panel_height;   /* px */
  const char *target; /* of the experiments in the key, or NULL */
  double end;         /* of the time axis; 0: the end of the runs */
  size_t note;        /* characters of the longest note in the key */
};

double cmp_chart_time_end(const struct comparison *c, const struct cmp_chart_plan *plan);
enum status cmp_chart_begin(const struct comparison *c, struct cmp_figures *f,
                            const struct cmp_chart_plan *plan, struct cmp_chart *chart);
enum status cmp_chart_end(struct cmp_chart *chart);

/* A row of the table; series are numbered: runs, then n_runs for the reference, then experiments.
 */
void cmp_chart_row(struct cmp_chart *chart, size_t series, const char *name, double t,
                   const double *value, size_t n);

/* Starts panel k from the top; `title` stands in its corner (NULL: none). */
void cmp_chart_panel(struct cmp_chart *chart, size_t k, const struct cmp_frame *frame,
                     const char *label, const char *title);

/* Marks, before the curves, the extremes of a series that leaves the frame: an arrow at the edge
 * and the value there. */
void cmp_chart_mark(struct cmp_chart *chart, const struct cmp_beyond *beyond, const char *colour);

struct cmp_curve {
  size_t series;
  size_t column;    /* of values in the table, from 0 */
  const char *name; /* in the key; NULL: not there */
  const char *note; /* behind the name in the key, e.g. " (beyond the frame)"; NULL: none */
  struct cmp_style style;
  double width;
  int symbol;   /* 0: a line */
  size_t every; /* draws one row in so many; 0: all */
};
void cmp_chart_curve(struct cmp_chart *chart, const struct cmp_curve *curve);
/* Between two columns of the table that follow each other, where both are numbers. */
void cmp_chart_band(struct cmp_chart *chart, size_t series, size_t column, const char *colour);
void cmp_chart_others(struct cmp_chart *chart, size_t column,
                      bool named);                           /* runs without a style */
void cmp_chart_level(struct cmp_chart *chart, double level); /* dashed, horizontal */
void cmp_chart_key_entry(struct cmp_chart *chart, size_t run,
                         const char *note); /* not drawn here */
void cmp_chart_panel_end(struct cmp_chart *chart);

/* gnuplot's name for a dash pattern. */
const char *cmp_dashes(const struct cmp_style *style);

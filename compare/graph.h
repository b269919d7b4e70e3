/* A figure of curves that share an axis, from columns of numbers that no run has: panels above each
 * other, a colour for each curve, dashes for the columns of a panel. */
#pragma once
#include <stdbool.h>
#include <stddef.h>

#include "compare/figure.h"
#include "compare/pick.h"

struct cmp_graph_column {
  const char *head;  /* of the table: "a [c0]" */
  const char *label; /* in the key, and on the axis where there is no other */
  const char *axis;  /* on the axis of its panel; NULL: the label. Of its first column */
  const char *level; /* a dashed line across its panel, as a number; NULL: none */
  double top;        /* its panel goes no higher; 0: as high as its curves. Of its first column */
  int panel;         /* from the top; the first column is the axis of all */
  double span; /* of a log axis: it ends so many times below its top; 0: with the lowest value */
  const double *ends; /* [2] where the axis begins and ends; NaN: where its curves do. Of its first
                         column; NULL: where they do */
  bool log, points, same; /* its axis; symbols, no line; alike in all curves, and drawn once */
  bool undrawn;           /* only in the table */
};

struct cmp_graph_curve {
  const char *name;
  const struct cmp_style *style; /* NULL: the k-th has the k-th */
  size_t n;
  const double *row; /* [n][n_columns]; NaN breaks a line */
  bool points;       /* symbols, no line */
};

struct cmp_graph {
  const char *name;         /* of its files */
  const char *title;        /* above the first panel; NULL: none */
  const char *caption;      /* NULL: none */
  enum cmp_section section; /* of a report */
  bool raster;              /* heavy: see cmp_figure_begin */
  bool narrow;              /* in one column of a journal, not in two as well */
  bool equal;               /* one panel, of which x and y have one scale as long as that makes it
                               60 to 1200 px high, in one width alone */
  size_t n_columns, n_curves;
  const struct cmp_graph_column *column; /* [n_columns] */
  const struct cmp_graph_curve *curve;   /* [n_curves] */
};

/* Writes its script and table; cmp_figures_draw makes the picture. */
enum status cmp_graph_write(const struct cmp_graph *graph, struct cmp_figures *f);

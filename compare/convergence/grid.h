/* A page of log-log panels, two in a row, under one key: errors over what they are held against. */
#pragma once
#include <stdbool.h>
#include <stddef.h>

#include "compare/figure.h"
#include "compare/pick.h"

struct cmp_grid_curve {
  const char *name; /* in the key: curves called alike look alike there */
  struct cmp_style style;
  int symbol; /* place in the list of them: the key has a line for each, too */
  size_t n;
  const double *x, *y; /* [n], > 0, borrowed */
  double slope;        /* of the end, written beside it; NaN: not */
};

struct cmp_grid_panel {
  char title[96];
  const char *x, *y; /* labels of the axes */
  bool slopes;       /* lines of first and second order beside the curves */
  size_t n;
  struct cmp_grid_curve *curve; /* [n], borrowed */
};

enum { CMP_GRID_PANELS = 8, CMP_GRID_SYMBOLS = 6 }; /* most of a page; that differ */

struct cmp_grid {
  const char *name, *caption; /* of its files */
  enum cmp_section section;
  size_t n;
  const struct cmp_grid_panel *panel; /* [n] */
  size_t n_symbols;
  const char *const *symbol; /* what each stands for, [n_symbols] */
};

enum status cmp_grid_write(const struct cmp_grid *grid, struct cmp_figures *f);

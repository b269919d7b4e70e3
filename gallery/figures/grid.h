/* Pictures of water in a grid, which have one scale of colours. */
#pragma once
#include "common/base/geometry.h"
#include "compare/figure.h"
#include "gallery/figures/marks.h"

enum { GALLERY_NOTE = 64 };

struct gallery_pane {
  double side;             /* of the squares that its points are drawn as, H; 0: there are none */
  char note[GALLERY_NOTE]; /* above it, at its right end */
  size_t walls, surface;   /* series of the table of lines; SIZE_MAX: none */
};

struct gallery_grid {
  size_t columns, rows;
  const char *const *column, *const *row; /* their heads */
  struct gallery_pane *pane;              /* [rows][columns] */
  struct geo_box view;                    /* H */
  struct geo_box room;                    /* H: there is water nowhere else */
  double low, high;                       /* of the colours */
  const char *label;                      /* of these, enhanced text */
  const struct gallery_marks *marks;      /* in every pane */
};

/* Points of pane k are rows "x,y,value" of NAME-points-K.csv, K from 1; walls and surfaces those of
 * NAME-surfaces.csv (compare/panes.h). Sets the figure's height, writes its script and ends it. */
enum status gallery_grid_draw(const struct gallery_grid *g, struct cmp_figure *fig);

/* px of the figure. */
int gallery_grid_width(bool wide);

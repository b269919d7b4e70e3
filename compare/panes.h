/* Pictures of the tank at an instant, one for each run: where they are, what they show of it, and
 * the surfaces in them. */
#pragma once
#include "compare/comparison.h"
#include "compare/figure.h"

enum { /* px */
       CMP_PANES_LEFT = 74,
       CMP_PANES_RIGHT = 100,
       CMP_PANES_TOP = 8,
       CMP_PANES_TITLE = 24,
       CMP_PANES_BOTTOM = 52,
       CMP_PANES_GAP = 26
};

struct cmp_layout {
  size_t columns, rows;
  double width, height; /* of a panel, px */
  double stretch;       /* so much larger are heights drawn than lengths */
  int total;            /* height of the figure, px */
};

extern const char cmp_panes_palette[], cmp_panes_diverging[]; /* gnuplot's commands */

/* The tank's width, up to a little above the main surfaces; spray may fly out of the picture. */
struct geo_box cmp_panes_view(const struct comparison *c, size_t time);
struct cmp_layout cmp_panes_layout(const struct geo_box *view, size_t panels);
/* "" or how the panels are stretched, for a caption. */
void cmp_layout_say(const struct cmp_layout *l, char *out, size_t room);
/* Points of a table as discs of a radius in H, coloured by one of its columns. */
void cmp_pane_discs(const struct cmp_figure *fig, const struct cmp_layout *l, const char *table,
                    double radius, int colour);
void cmp_pane_place(const struct cmp_figure *fig, const struct cmp_layout *l, size_t k);

/* Labels of the axes of panel k of n, at the edges of the figure only. */
void cmp_pane_axes(const struct cmp_figure *fig, const struct cmp_layout *l, size_t k, size_t n);

/* The title of a panel, above it. */
void cmp_pane_title(const struct cmp_figure *fig, const char *title);

/* The box of colours beside the first panel, and above it what they are `of`: beside it there is no
 * room next to long numbers. After the title. */
void cmp_pane_colours(const struct cmp_figure *fig, const struct cmp_layout *l, const char *of);

/* The table of surfaces of the runs picked when there is room for `most`. Walls are series n_runs +
 * 1, the reference n_runs, run r is r; what was measured is n_runs + 2. */
enum status cmp_panes_surfaces(const struct comparison *c, struct cmp_figures *f,
                               const struct cmp_figure *fig, size_t time, size_t most);
bool cmp_panes_profiled(const struct comparison *c, size_t time); /* surfaces were measured then */

/* Rows of that table for a series `id`, its lines in H. */
#define CMP_PANE_LINES_HEAD "series,name,piece,x [H],y [H]\n"
void cmp_pane_lines(FILE *data, size_t id, const char *name, const struct geo_lines *l);

/* Adds a series of it to gnuplot's plot command. */
void cmp_panes_plot(const struct cmp_figure *fig, size_t id, const char *style);

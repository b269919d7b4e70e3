#include "gallery/figures/grid.h"

#include <math.h>
#include <stdint.h>

#include "compare/panels.h"
#include "compare/panes.h"
#include "compare/text.h"

enum { /* px */
       LEFT = 62,
       RIGHT = 16,
       TOP = 8,
       COLUMN_HEAD = 22,
       ROW_HEAD = 22,
       GAP = 14,
       ROW_GAP = 8,
       BOTTOM = 48,
       BAR = 12,
       BAR_ROOM = 58, /* with its ticks and label */
       BAR_LONGEST = 420
};
#define LABEL_X 16.0 /* px: the middle of the label of the y axis */

struct layout {
  double width, height; /* of a pane, px */
  struct geo_box water; /* what of it points are drawn in, H: between the walls */
  double top;           /* of the first row's head */
  double bar;           /* top of the bar of colours */
};

int gallery_grid_width(bool wide) {
  return wide ? CMP_PANELS_WIDTH : CMP_PANELS_NARROW;
}

static struct layout layout_of(const struct gallery_grid *g, struct cmp_figure *fig) {
  const double aspect = (g->view.max[0] - g->view.min[0]) / (g->view.max[1] - g->view.min[1]);
  const double gaps = GAP * (double)(g->columns - 1);
  struct layout l = {.top = TOP + COLUMN_HEAD};
  l.width = (fig->width - LEFT - RIGHT - gaps) / (double)g->columns;
  l.height = l.width / aspect;
  l.bar =
      l.top + (double)g->rows * (ROW_HEAD + l.height) + ROW_GAP * (double)(g->rows - 1) + BOTTOM;
  fig->height = (int)ceil(l.bar + BAR_ROOM);
  for (int k = 0; k < 2; k++) {
    l.water.min[k] = fmax(g->view.min[k], g->room.min[k]);
    l.water.max[k] = fmin(g->view.max[k], g->room.max[k]);
  }
  return l;
}

/* Of ticks along `length` px: about five, and none so near to the next that their labels touch. */
static double step_of(double low, double high, double length, double label) {
  const double step = cmp_tick_step(&(struct cmp_frame){low, high});
  const double least = (high - low) * label / length;
  return step >= least ? step : cmp_tick_step(&(struct cmp_frame){0, 5 * least});
}

static const char *palette_of(const struct gallery_grid *g) {
  return g->low < 0 && fabs(g->low + g->high) < 1e-9 * g->high ? cmp_panes_diverging
                                                               : cmp_panes_palette;
}

/* px of a layer along an axis. */
static long layer_px(const struct gallery_grid *g, const struct layout *l,
                     const struct cmp_figure *fig, int axis) {
  const double share =
      (l->water.max[axis] - l->water.min[axis]) / (g->view.max[axis] - g->view.min[axis]);
  return lround(fmax(1, fig->layer * share * (axis ? l->height : l->width)));
}

/* Points as squares, below which larger ones close the gaps where the water is stretched. */
#define FILLING 1.7

static void squares_write(const struct cmp_figure *fig, size_t pane, double half) {
  fprintf(fig->script,
          "'%s-points-%zu.csv' skip 1 using 1:2:(%.6g):(%.6g):3 with boxxyerror linecolor palette "
          "fillstyle solid 1 noborder",
          fig->name, pane + 1, half, half);
}

/* Points are drawn once into a transparent picture of each pane's size, which the formats share. */
static void layers_write(const struct gallery_grid *g, const struct layout *l,
                         const struct cmp_figure *fig) {
  fprintf(fig->script,
          "%sset cbrange [%g:%g]\n"
          "set terminal pngcairo transparent size %ld,%ld\nset margins 0,0,0,0\n"
          "unset border\nunset tics\nunset colorbox\nunset key\n"
          "set xrange [%.6g:%.6g]\nset yrange [%.6g:%.6g]\n",
          palette_of(g), g->low, g->high, layer_px(g, l, fig, 0), layer_px(g, l, fig, 1),
          l->water.min[0], l->water.max[0], l->water.min[1], l->water.max[1]);
  for (size_t k = 0; k < g->columns * g->rows; k++) {
    const double half = g->pane[k].side / 2;
    if (!(half > 0)) continue;
    fprintf(fig->script, "set output '%s.layer%zu.png'\nplot ", fig->name, k);
    squares_write(fig, k, FILLING * half);
    fputs(", ", fig->script);
    squares_write(fig, k, half);
    fputc('\n', fig->script);
  }
  fputs("unset output\nreset\nset datafile separator ','\n", fig->script);
}

static void place_write(const struct gallery_grid *g, const struct layout *l,
                        const struct cmp_figure *fig, size_t k) {
  const double left = LEFT + (double)(k % g->columns) * (l->width + GAP);
  const double top =
      l->top + ROW_HEAD + (double)(k / g->columns) * (l->height + ROW_HEAD + ROW_GAP);
  fprintf(fig->script,
          "set lmargin at screen %.5f\nset rmargin at screen %.5f\nset tmargin at screen %.5f\n"
          "set bmargin at screen %.5f\n",
          left / fig->width, (left + l->width) / fig->width, 1 - top / fig->height,
          1 - (top + l->height) / fig->height);
}

static void label_write(FILE *s, const char *text, const char *where) {
  if (!*text) return;
  fputs("set label ", s);
  cmp_gnuplot_string(s, text);
  fprintf(s, " at %s noenhanced\n", where);
}

static void heads_write(const struct gallery_grid *g, const struct layout *l,
                        const struct cmp_figure *fig, size_t k) {
  FILE *s = fig->script;
  char where[96];
  fputs("unset label\n", s);
  if (k % g->columns == 0) /* gnuplot's own would leave a narrow margin */
    fprintf(s, "set label 'y / H' at screen %.5f, graph 0.5 center rotate\n", LABEL_X / fig->width);
  if (k < g->columns) {
    snprintf(where, sizeof where, "graph 0.5, screen %.5f center",
             1 - (l->top - COLUMN_HEAD / 2.0) / fig->height);
    label_write(s, g->column[k], where);
  }
  if (k % g->columns == 0)
    label_write(s, g->row[k / g->columns],
                "graph 0, graph 1 left offset 0, character 0.7 font small");
  label_write(s, g->pane[k].note, "graph 1, graph 1 right offset 0, character 0.7 font small");
  fputs("unset arrow\n", s);
  gallery_marks_write(g->marks, &g->view, s);
}

static void axes_write(const struct gallery_grid *g, const struct cmp_figure *fig, size_t k) {
  fputs(k / g->columns + 1 == g->rows ? "set format x\nset xlabel 'x / H' offset 0,0.3\n"
                                      : "set format x ''\nunset xlabel\n",
        fig->script);
  fputs(k % g->columns == 0 ? "set format y\n" : "set format y ''\n", fig->script);
}

/* Below all panes, of which the first draws it. */
static void bar_write(const struct gallery_grid *g, const struct layout *l,
                      const struct cmp_figure *fig) {
  const double length = fmin(BAR_LONGEST, fig->width - LEFT - RIGHT);
  const double left = LEFT + (fig->width - LEFT - RIGHT - length) / 2;
  fprintf(fig->script,
          "set colorbox horizontal user origin screen %.5f, screen %.5f size screen %.5f, screen "
          "%.5f\nset cblabel '%s' offset 0,0.4\n",
          left / fig->width, 1 - (l->bar + BAR) / fig->height, length / fig->width,
          (double)BAR / fig->height, g->label);
}

static void pane_write(const struct gallery_grid *g, const struct layout *l,
                       const struct cmp_figure *fig, size_t k) {
  const struct gallery_pane *p = &g->pane[k];
  FILE *s = fig->script;
  place_write(g, l, fig, k);
  heads_write(g, l, fig, k);
  axes_write(g, fig, k);
  if (k == 0)
    bar_write(g, l, fig);
  else
    fputs("unset colorbox\n", s);
  /* one point of the palette, so that the bar appears */
  fputs("plot '+' using (-1e9):(-1e9):(0) with points pointtype 0 linecolor palette notitle", s);
  if (p->side > 0) {
    const struct geo_box *w = &l->water;
    const double dx = (w->max[0] - w->min[0]) / (double)layer_px(g, l, fig, 0);
    const double dy = (w->max[1] - w->min[1]) / (double)layer_px(g, l, fig, 1);
    fprintf(s,
            ", \\\n  '%s.layer%zu.png' binary filetype=png origin=(%.8g,%.8g) dx=%.8g dy=%.8g with "
            "rgbalpha notitle",
            fig->name, k, w->min[0] + dx / 2, w->min[1] + dy / 2, dx, dy);
  }
  if (p->walls != SIZE_MAX) cmp_panes_plot(fig, p->walls, "linewidth 1.6 linecolor '#666666'");
  if (p->surface != SIZE_MAX) {
    cmp_panes_plot(fig, p->surface, "linewidth 2.6 linecolor '#ffffff'");
    cmp_panes_plot(fig, p->surface, "linewidth 1.2 linecolor '#000000'");
  }
  fputc('\n', s);
}

enum status gallery_grid_draw(const struct gallery_grid *g, struct cmp_figure *fig) {
  const struct layout l = layout_of(g, fig);
  const struct geo_box *v = &g->view;
  layers_write(g, &l, fig);
  cmp_figure_formats(fig);
  fprintf(fig->script,
          "%sset cbrange [%g:%g]\nset cbtics %g\nunset key\nunset grid\nset tics front font small\n"
          "set xrange [%.6g:%.6g]\nset yrange [%.6g:%.6g]\nset xtics %g\nset ytics %g\n"
          "set multiplot\n",
          palette_of(g), g->low, g->high, step_of(g->low, g->high, BAR_LONGEST, 40), v->min[0],
          v->max[0], v->min[1], v->max[1], step_of(v->min[0], v->max[0], l.width, 32),
          step_of(v->min[1], v->max[1], l.height, 22));
  for (size_t k = 0; k < g->columns * g->rows; k++) pane_write(g, &l, fig, k);
  fputs("unset multiplot\n", fig->script);
  return cmp_figure_end(fig);
}

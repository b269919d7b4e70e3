#include "compare/currents.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/chart.h"
#include "compare/cloud.h"
#include "compare/panes.h"
#include "compare/text.h"

enum { ARROWS = 36 };               /* in a row across a panel, at most */
static const double LONGEST = 0.95; /* of the way from one to the next */
static const double WIDE = 0.75;    /* of the spacing: radius of a disc, so that no gaps are left */

/* Light enough for arrows in black. */
static const char speeds[] = "set palette defined (0 '#f7fbff', 1 '#d0e1f2', 2 '#94c4df', "
                             "3 '#4a98c9', 4 '#1764ab')\n";

/* One run at one time, or the reference. */
struct current {
  size_t run; /* SIZE_MAX: the reference */
  size_t output;
  double spacing, top;        /* H; the speed that all but one in a hundred stay below, sqrt(gH) */
  struct result_water points; /* and their velocities, owned */
};

static double speed_unit(const struct comparison *c) {
  return c->scales.H / c->scales.T;
}

/* ---- what there is to show ---- */

static enum status keep(void *data, size_t k, struct result_water *w) {
  (void)k;
  *(struct result_water *)data = *w;
  *w = (struct result_water){0};
  return OK;
}

static enum status look(const struct comparison *c, size_t time, size_t r, struct current *out) {
  const struct cmp_run *run = cmp_run_or_ref(c, r);
  const struct result_file *f = run->data.file;
  *out = (struct current){.run = r};
  out->output = cmp_cloud_output(c, f, r == SIZE_MAX ? c->times[time] : run->at[time].t);
  if (out->output == SIZE_MAX) return OK;
  out->spacing = cmp_cloud_spacing(f, (size_t)f->output_points[out->output]) / c->scales.H;
  if (!(out->spacing > 0)) return OK;
  const struct result_wanted velocity = {"velocity", true, false};
  if (result_stream(f->path, 1, &velocity, 1, &out->output, keep, &out->points) != OK)
    out->spacing = 0; /* points that do not say how they move */
  return OK;
}

/* Speeds of all points, sorted: the largest but those of one in a hundred. */
static enum status find_top(const struct comparison *c, struct current *k) {
  const struct result_water *p = &k->points;
  double *speed = NULL;
  if (!p->n) return OK;
  TRY(array_create(&speed, p->n, "speeds"));
  for (size_t i = 0; i < p->n; i++)
    speed[i] = hypot(p->value[0][2 * i], p->value[0][2 * i + 1]) / speed_unit(c);
  qsort(speed, p->n, sizeof *speed, array_ascending);
  k->top = speed[p->n - 1 - p->n / 100];
  free(speed);
  return OK;
}

/* ---- tables ---- */

static void write_row(const struct comparison *c, const struct result_water *p, size_t i,
                      FILE *data) {
  const double u = p->value[0][2 * i] / speed_unit(c), v = p->value[0][2 * i + 1] / speed_unit(c);
  fprintf(data, "%.6g,%.6g,%.5g,%.5g,%.5g\n", p->p[i][0] / c->scales.H, p->p[i][1] / c->scales.H, u,
          v, hypot(u, v));
}

static const char header[] = "x [H],y [H],u [sqrt(g H)],v [sqrt(g H)],speed [sqrt(g H)]\n";

static size_t number_of(const struct current *k) {
  return k->run == SIZE_MAX ? 0 : k->run + 1;
}

static enum status write_points(const struct comparison *c, struct cmp_figures *f,
                                const struct cmp_figure *fig, const struct current *k) {
  FILE *data;
  char suffix[48];
  snprintf(suffix, sizeof suffix, "-points-%zu.csv", number_of(k));
  TRY(cmp_figure_data(f, fig, suffix, &data));
  fputs(header, data);
  for (size_t i = 0; i < k->points.n; i++) write_row(c, &k->points, i, data);
  return cmp_figure_data_end(fig, data);
}

/* The point nearest to the middle of each cell of a lattice, which are squares on the page, of
 * those in it. */
static enum status choose(const struct comparison *c, const struct result_water *p,
                          const struct geo_box *view, const double cell[2], size_t columns,
                          size_t rows, size_t *chosen) {
  double *least = NULL;
  TRY(array_create(&least, columns * rows, "arrows"));
  for (size_t k = 0; k < columns * rows; k++) chosen[k] = SIZE_MAX, least[k] = INFINITY;
  for (size_t i = 0; i < p->n; i++) {
    const double x = (p->p[i][0] / c->scales.H - view->min[0]) / cell[0],
                 y = (p->p[i][1] / c->scales.H - view->min[1]) / cell[1];
    if (!(x >= 0 && y >= 0 && x < (double)columns && y < (double)rows)) continue;
    const size_t k = (size_t)y * columns + (size_t)x;
    const double off = hypot(x - floor(x) - 0.5, y - floor(y) - 0.5);
    if (off < least[k]) least[k] = off, chosen[k] = i;
  }
  free(least);
  return OK;
}

static enum status write_arrows(const struct comparison *c, struct cmp_figures *f,
                                const struct cmp_figure *fig, const struct current *k,
                                const struct geo_box *view, const double cell[2]) {
  const size_t columns = (size_t)ceil((view->max[0] - view->min[0]) / cell[0]),
               rows = (size_t)ceil((view->max[1] - view->min[1]) / cell[1]);
  FILE *data;
  char suffix[48];
  size_t *chosen = NULL;
  enum status status = OK;
  TRY(array_create(&chosen, columns * rows, "arrows"));
  snprintf(suffix, sizeof suffix, "-arrows-%zu.csv", number_of(k));
  ATTEMPT(choose(c, &k->points, view, cell, columns, rows, chosen));
  ATTEMPT(cmp_figure_data(f, fig, suffix, &data));
  fputs(header, data);
  for (size_t i = 0; i < columns * rows; i++)
    if (chosen[i] != SIZE_MAX) write_row(c, &k->points, chosen[i], data);
  ATTEMPT(cmp_figure_data_end(fig, data));
done:
  free(chosen);
  return status;
}

/* ---- drawing ---- */

/* Points into transparent pictures, as for the overlays. */
static void layer_draw(const struct cmp_figure *fig, const struct cmp_layout *l,
                       const struct current *k) {
  const size_t id = number_of(k);
  char table[192];
  snprintf(table, sizeof table, "%s-points-%zu.csv", fig->name, id);
  fprintf(fig->script, "set output '%s.layer%zu.png'\n", fig->name, id);
  cmp_pane_discs(fig, l, table, WIDE * k->spacing, 5);
}

static void layers_draw(const struct cmp_figure *fig, const struct cmp_layout *l,
                        const struct geo_box *view, size_t n, const struct current *all,
                        double top) {
  fprintf(fig->script,
          "%sset cbrange [0:%g]\nset style fill solid 1 noborder\n"
          "set terminal pngcairo transparent size %d,%d\nset margins 0,0,0,0\n"
          "unset border\nunset tics\nunset colorbox\nunset key\n"
          "set xrange [%.6g:%.6g]\nset yrange [%.6g:%.6g]\n",
          speeds, top, (int)lround(2 * l->width), (int)lround(2 * l->height), view->min[0],
          view->max[0], view->min[1], view->max[1]);
  for (size_t k = 0; k < n; k++) layer_draw(fig, l, &all[k]);
  fputs("unset output\nreset\nset datafile separator ','\n", fig->script);
}

static void panel_draw(const struct comparison *c, const struct cmp_figure *fig,
                       const struct cmp_layout *l, const struct geo_box *view, size_t k, size_t n,
                       const struct current *now, double scale) {
  const size_t id = number_of(now);
  FILE *s = fig->script;
  cmp_pane_place(fig, l, k);
  cmp_pane_title(fig, cmp_run_or_ref(c, now->run)->data.label);
  cmp_pane_axes(fig, l, k, n);
  if (k == 0)
    cmp_pane_colours(fig, l, "|u| / √(g H)");
  else
    fputs("unset colorbox\n", s);
  fputs("plot '+' using (-1e9):(-1e9):(0) with points pointtype 0 linecolor palette notitle", s);
  fprintf(s,
          ", \\\n  '%s.layer%zu.png' binary filetype=png origin=(%.8g,%.8g) dx=%.8g dy=%.8g with "
          "rgbalpha notitle",
          fig->name, id, view->min[0], view->min[1],
          (view->max[0] - view->min[0]) / round(2 * l->width),
          (view->max[1] - view->min[1]) / round(2 * l->height));
  fprintf(s,
          ", \\\n  '%s-arrows-%zu.csv' skip 1 using 1:2:(%.6g*$3):(%.6g*$4) with vectors head "
          "size screen 0.004,25,60 filled linewidth 0.8 linecolor '#000000' notitle",
          fig->name, id, scale, scale / l->stretch);
  cmp_panes_plot(fig, c->n_runs + 1, "linewidth 1.6 linecolor '#666666'");
  cmp_panes_plot(fig, now->run == SIZE_MAX ? c->n_runs : now->run,
                 "linewidth 1 linecolor '#d55e00'");
  fputc('\n', s);
}

static double rounded_up(double top) {
  return fmax(0.1, ceil(top * 10 - 1e-9) / 10);
}

static enum status figure_draw(const struct comparison *c, struct cmp_figures *f, size_t time,
                               size_t n, const struct current *all) {
  const struct geo_box view = cmp_panes_view(c, time);
  const struct cmp_layout l = cmp_panes_layout(&view, n);
  const double wide = (view.max[0] - view.min[0]) / ARROWS * (double)l.columns;
  const double cell[] = {wide, wide / l.stretch};
  char stretched[64];
  struct cmp_figure *fig;
  double top = 0;
  for (size_t k = 0; k < n; k++) top = fmax(top, k ? fmin(all[k].top, 1.5 * top) : all[k].top);
  const double colours = rounded_up(top), scale = LONGEST * wide / colours;
  TRY(cmp_figure_begin(f, CMP_SECTION_OVERLAY, true, CMP_PANELS_WIDTH, l.total, &fig,
                       "velocity-t%.4g", c->times[time]));
  cmp_layout_say(&l, stretched, sizeof stretched);
  snprintf(fig->caption, sizeof fig->caption,
           "t* = %.4g. Velocity of the water: points coloured by its speed (the same colours for "
           "all), arrows as long as it is large; at rest there is none. The surface in orange.%s",
           c->times[time], stretched);
  TRY(cmp_panes_surfaces(c, f, fig, time, CMP_PANELS));
  for (size_t k = 0; k < n; k++) {
    TRY(write_points(c, f, fig, &all[k]));
    TRY(write_arrows(c, f, fig, &all[k], &view, cell));
  }
  layers_draw(fig, &l, &view, n, all, colours);
  cmp_figure_formats(fig);
  fprintf(fig->script,
          "%sset cbrange [0:%g]\nset cbtics %g\n"
          "unset key\nunset grid\nset tics front\n"
          "set xrange [%.6g:%.6g]\nset yrange [%.6g:%.6g]\nset ytics 0.5\nset multiplot\n",
          speeds, colours, colours / 4, view.min[0], view.max[0], view.min[1], view.max[1]);
  for (size_t k = 0; k < n; k++) panel_draw(c, fig, &l, &view, k, n, &all[k], scale);
  fputs("unset multiplot\n", fig->script);
  return cmp_figure_end(fig);
}

static enum status take(const struct comparison *c, size_t time, size_t r, struct current *all,
                        size_t *n) {
  TRY(look(c, time, r, &all[*n]));
  if (!(all[*n].spacing > 0)) return OK;
  return find_top(c, &all[(*n)++]);
}

static enum status write_time(const struct comparison *c, struct cmp_figures *f, size_t time) {
  struct current all[CMP_PANELS + 1];
  size_t n = 0;
  enum status status = OK;
  if (!cmp_comparison_has_output(c, time)) return OK;
  ATTEMPT(take(c, time, SIZE_MAX, all, &n));
  for (size_t r = 0; n > 0 && r < c->n_runs; r++)
    if (cmp_run_is_picked(c, r, CMP_PANELS)) ATTEMPT(take(c, time, r, all, &n));
  if (n > 0) ATTEMPT(figure_draw(c, f, time, n, all));
done:
  for (size_t k = 0; k < n; k++) result_water_free(&all[k].points);
  return status;
}

enum status cmp_currents_write(const struct comparison *c, struct cmp_figures *f) {
  for (size_t k = 0; k < c->n_times; k++) TRY(write_time(c, f, k));
  return OK;
}

#include "compare/panes.h"

#include <math.h>
#include <stdint.h>

#include "common/tank/motion.h"
#include "compare/outline.h"
#include "compare/pick.h"
#include "compare/polyline.h"
#include "compare/profiles.h"
#include "compare/text.h"

/* Nine colours of matplotlib's viridis (public domain, CC0): perceptually uniform, safe for
 * colour-blind readers. */
const char cmp_panes_palette[] =
    "set palette defined (0 '#440154', 1 '#472c7a', 2 '#3b518b', 3 '#2c718e', 4 '#21908d', "
    "5 '#27ad81', 6 '#5cc863', 7 '#aadc32', 8 '#fde725')\n";

static const double LOW = 90; /* px: lower panels are stretched */

/* Moreland's cool to warm ("Diverging color maps for scientific visualization", 2009). */
const char cmp_panes_diverging[] =
    "set palette defined (0 '#3b4cc0', 1 '#6282ea', 2 '#8db0fe', 3 '#b8d0f9', 4 '#dddddd', "
    "5 '#f5c4ad', 6 '#f49a7b', 7 '#de604d', 8 '#b40426')\n";

/* ---- data files ---- */

/* Pieces are kept apart by an empty line, which CSV readers skip and gnuplot needs. */
void cmp_pane_lines(FILE *data, size_t id, const char *name, const struct geo_lines *l) {
  for (size_t k = 0; k < l->pieces; k++) {
    size_t a = l->first[k], n = l->first[k + 1] - a;
    for (size_t i = 0; i < n + l->closed[k] && n; i++) {
      fprintf(data, "%zu,", id);
      cmp_csv_string(data, name);
      fprintf(data, ",%zu,%.8g,%.8g\n", k, l->p[a + i % n][0], l->p[a + i % n][1]);
    }
    fputc('\n', data);
  }
}

/* Series n_runs + 2: a point a row. */
static void profiles_write(const struct comparison *c, FILE *data, size_t time) {
  const struct result_file *f = c->ref.data.file;
  for (size_t k = 0; k < f->n_profiles; k++)
    for (size_t i = 0; i < f->profiles[k].n && cmp_profile_is_at(c, k, time); i++) {
      fprintf(data, "%zu,", c->n_runs + 2);
      cmp_csv_string(data, f->profiles[k].label);
      fprintf(data, ",%zu,%.8g,%.8g\n", k, f->profiles[k].x[i] / c->scales.H,
              f->profiles[k].y[i] / c->scales.H);
    }
}

bool cmp_panes_profiled(const struct comparison *c, size_t time) {
  size_t k = 0;
  while (k < c->ref.data.file->n_profiles && !cmp_profile_is_at(c, k, time)) k++;
  return k < c->ref.data.file->n_profiles;
}

/* The walls where they are then, in H: the sides of a tank may move in it. */
static enum status walls_then(const struct comparison *c, size_t time, struct geo_lines *walls) {
  const struct case_file *s = c->settings;
  TRY(geo_lines_copy(walls, &c->ref.data.walls));
  if (!s->n_motions || s->walls.points != walls->points) return OK;
  tank_vertices_at(&s->walls, s->motions, s->n_motions, c->times[time] * c->scales.T, walls->p,
                   NULL, NULL);
  for (size_t i = 0; i < walls->points; i++)
    for (int axis = 0; axis < 2; axis++) walls->p[i][axis] /= c->scales.H;
  return OK;
}

static enum status tank_write(const struct comparison *c, FILE *data, size_t time) {
  struct geo_lines walls = {0};
  const enum status status = walls_then(c, time, &walls);
  if (status == OK) cmp_pane_lines(data, c->n_runs + 1, "tank", &walls);
  geo_lines_destroy(&walls);
  return status;
}

/* Of the runs picked when there is room for `most`. Walls are series n_runs + 1, the reference
 * n_runs, run r is r. */
enum status cmp_panes_surfaces(const struct comparison *c, struct cmp_figures *f,
                               const struct cmp_figure *fig, size_t time, size_t most) {
  FILE *data;
  TRY(cmp_figure_data(f, fig, "-surfaces.csv", &data));
  fputs(CMP_PANE_LINES_HEAD, data);
  const enum status status = tank_write(c, data, time);
  profiles_write(c, data, time);
  bool reference = false;
  for (size_t r = 0; r < c->n_runs; r++) {
    const struct cmp_at *at = &c->run[r].at[time];
    if (at->output != SIZE_MAX && cmp_run_is_picked(c, r, most))
      cmp_pane_lines(data, r, c->run[r].data.label, &c->run[r].data.surface[at->output]);
    if (at->ref_output == SIZE_MAX || reference) continue;
    cmp_pane_lines(data, c->n_runs, c->ref.data.label, &c->ref.data.surface[at->ref_output]);
    reference = true;
  }
  TRY(cmp_figure_data_end(fig, data));
  return status;
}

void cmp_panes_plot(const struct cmp_figure *fig, size_t id, const char *style) {
  fprintf(fig->script,
          ", \\\n  '%s-surfaces.csv' skip 1 using ($1==%zu?$4:NaN):5 with lines %s notitle",
          fig->name, id, style);
}

/* ---- what is seen ---- */

/* Up to the top of the main surface, films on walls left out. */
static void view_include(const struct comparison *c, const struct geo_lines *surface,
                         struct geo_box *view) {
  struct geo_lines main = {0}, thick = {0};
  if (cmp_lines_main(surface, CMP_MAIN_FRACTION, &main) == OK &&
      cmp_lines_away(&main, &c->ref.data.walls, c->depth, &thick) == OK && thick.points)
    view->max[1] = fmax(view->max[1], geo_lines_box(&thick).max[1]);
  geo_lines_destroy(&main);
  geo_lines_destroy(&thick);
}

/* The tank's width, up to a little above the main surfaces; spray may fly out of the picture. */
struct geo_box cmp_panes_view(const struct comparison *c, size_t time) {
  struct geo_box view = geo_lines_box(&c->ref.data.walls);
  double top = view.max[1];
  view.max[1] = view.min[1] + 0.3;
  for (size_t r = 0; r < c->n_runs; r++) {
    const struct cmp_at *at = &c->run[r].at[time];
    if (!cmp_run_is_picked(c, r, CMP_PANELS)) continue;
    if (at->output != SIZE_MAX) view_include(c, &c->run[r].data.surface[at->output], &view);
    if (at->ref_output != SIZE_MAX) view_include(c, &c->ref.data.surface[at->ref_output], &view);
  }
  view.max[1] = fmin(fmax(top, 0.5), view.max[1] + 0.08);
  for (int k = 0; k < 2; k++) { /* a window narrower than the tank is what matters */
    view.min[k] = fmax(view.min[k], c->window.min[k]);
    view.max[k] = fmin(view.max[k], c->window.max[k]);
  }
  return view;
}

/* Of a panel that would be so many pixels high: a round number that makes it readable. */
static double stretch_of(double height) {
  static const double round[] = {1, 2, 5, 10, 20, 50, 100};
  size_t k = 0;
  while (k + 1 < sizeof round / sizeof *round && round[k] * height < LOW) k++;
  return round[k];
}

void cmp_layout_say(const struct cmp_layout *l, char *out, size_t room) {
  out[0] = 0;
  if (l->stretch > 1) snprintf(out, room, " Heights are drawn %g times as large.", l->stretch);
}

void cmp_pane_discs(const struct cmp_figure *fig, const struct cmp_layout *l, const char *table,
                    double radius, int colour) {
  if (l->stretch > 1)
    fprintf(fig->script,
            "plot '%s' skip 1 using 1:2:(%.6g):(%.6g):(0):%d with ellipses units xy linecolor "
            "palette\n",
            table, 2 * radius, 2 * radius, colour);
  else
    fprintf(fig->script, "plot '%s' skip 1 using 1:2:(%.6g):%d with circles linecolor palette\n",
            table, radius, colour);
}

struct cmp_layout cmp_panes_layout(const struct geo_box *view, size_t panels) {
  double aspect = (view->max[0] - view->min[0]) / (view->max[1] - view->min[1]);
  struct cmp_layout l = {.columns = aspect > 1.9 || panels < 2 ? 1 : 2};
  l.rows = (panels + l.columns - 1) / l.columns;
  l.width = (CMP_PANELS_WIDTH - CMP_PANES_LEFT - CMP_PANES_RIGHT - 30.0 * (double)(l.columns - 1)) /
            (double)l.columns;
  l.stretch = stretch_of(l.width / aspect);
  l.height = l.stretch * l.width / aspect;
  l.total =
      (int)ceil(CMP_PANES_TOP + CMP_PANES_BOTTOM + (double)l.rows * (l.height + CMP_PANES_TITLE) +
                CMP_PANES_GAP * (double)(l.rows - 1));
  return l;
}

void cmp_pane_place(const struct cmp_figure *fig, const struct cmp_layout *l, size_t k) {
  double left = CMP_PANES_LEFT + (double)(k % l->columns) * (l->width + 30);
  double top = CMP_PANES_TOP + CMP_PANES_TITLE +
               (double)(k / l->columns) * (l->height + CMP_PANES_TITLE + CMP_PANES_GAP);
  cmp_figure_margins(
      fig, &(struct cmp_margins){left, CMP_PANELS_WIDTH - left - l->width, top, l->height}, NULL);
}

void cmp_pane_title(const struct cmp_figure *fig, const char *title) {
  fputs("unset label\nset label 1 ", fig->script);
  cmp_gnuplot_string(fig->script, title);
  fputs(" at graph 0, graph 1 offset 0, character 0.7 left noenhanced\n", fig->script);
}

void cmp_pane_axes(const struct cmp_figure *fig, const struct cmp_layout *l, size_t k, size_t n) {
  const bool last = k / l->columns + 1 == l->rows || k + l->columns >= n;
  fputs(last ? "set format x\nset xlabel 'x / H'\n" : "set format x ''\nunset xlabel\n",
        fig->script);
  fputs(k % l->columns == 0 ? "set format y\nset ylabel 'y / H'\n"
                            : "set format y ''\nunset ylabel\n",
        fig->script);
}

void cmp_pane_colours(const struct cmp_figure *fig, const struct cmp_layout *l, const char *of) {
  const double top = CMP_PANES_TOP + CMP_PANES_TITLE;
  fprintf(fig->script,
          "set colorbox user origin screen %.5f, screen %.5f size screen 0.016, screen %.5f\n",
          1 - (CMP_PANES_RIGHT - 16.0) / CMP_PANELS_WIDTH, 1 - (top + l->height) / fig->height,
          l->height / fig->height);
  fputs("set label 2 ", fig->script);
  cmp_gnuplot_string(fig->script, of);
  fprintf(fig->script, " at screen %.5f, screen %.5f center noenhanced\n",
          1 - CMP_PANES_RIGHT / 2.0 / CMP_PANELS_WIDTH,
          1 - (top - 0.7 * CMP_PANES_TITLE) / fig->height);
}

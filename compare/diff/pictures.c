/* Pictures of a run that differs: both surfaces when it first does and when they do most, how far
 * apart they are at every output, and series over each other with their difference. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/comparison.h"
#include "compare/diff/diff.h"
#include "compare/frame.h"
#include "compare/graph.h"
#include "compare/overlays.h"
#include "compare/panels.h"
#include "compare/panes.h"
#include "compare/pick.h"
#include "compare/text.h"

enum { MOST_ROWS = 4000 }; /* of a curve in a picture */

/* ---- surfaces ---- */

/* "bem (A)" and "bem (B)": what they are called in pictures. */
static enum status name_sides(struct result_file *const file[2]) {
  for (int k = 0; k < 2; k++) {
    char *name;
    CHECK(asprintf(&name, "%.60s (%c)", file[k]->run, "AB"[k]) >= 0, ERR_MEMORY,
          "no memory for a name");
    free(file[k]->run);
    file[k]->run = name;
  }
  return OK;
}

/* The output at which the surfaces are furthest apart; NaN when they never are. */
static double time_of_most(const struct comparison *c) {
  const struct cmp_evolution *e = &c->run[0].evolution;
  const double *mean = e->value[CMP_MEASURE_mean_distance];
  double most = 0, t = NAN;
  for (size_t i = 0; i < e->n; i++)
    if (mean[i] > most) most = mean[i], t = e->t[i];
  return t * c->scales.T;
}

/* A graph of one curve with n rows, which are freed. */
static enum status curve_draw(const struct cmp_graph *about, const char *name, size_t n,
                              double *row, struct cmp_figures *f) {
  const struct cmp_graph_curve curve = {.name = name, .n = n, .row = row};
  struct cmp_graph graph = *about;
  graph.n_curves = 1;
  graph.curve = &curve;
  const enum status status = cmp_graph_write(&graph, f);
  free(row);
  return status;
}

/* How far the surfaces are apart at every output. */
static enum status distances_draw(const struct comparison *c, struct cmp_figures *f) {
  enum { T, MEAN, LARGEST, COLUMNS };
  const struct cmp_evolution *e = &c->run[0].evolution;
  const double *const value[COLUMNS] = {e->t, e->value[CMP_MEASURE_mean_distance],
                                        e->value[CMP_MEASURE_largest_distance]};
  double *row;
  TRY(array_create(&row, e->n * COLUMNS, "distances"));
  for (size_t i = 0; i < e->n; i++)
    for (size_t k = 0; k < COLUMNS; k++) row[i * COLUMNS + k] = value[k][i];
  const struct cmp_graph_column column[COLUMNS] = {
      [T] = {.head = "t_star [sqrt(H/g)]", .label = "t √(g/H)"},
      [MEAN] = {.head = "mean_distance [H]", .label = "mean", .axis = "distance / H"},
      [LARGEST] = {.head = "largest_distance [H]", .label = "largest"}};
  const struct cmp_graph graph = {.name = "distance",
                                  .title = "between both free surfaces",
                                  .caption = "How far the free surfaces are apart at every output.",
                                  .section = CMP_SECTION_DISTANCE,
                                  .n_columns = COLUMNS,
                                  .column = column};
  return curve_draw(&graph, "distance", e->n, row, f);
}

/* H: surfaces nearer to each other are the same in the digits that pictures have. */
static const double SEEN = 1e-6;

/* Both surfaces around the place where they are furthest apart, so near that this is seen. */
static enum status closeup_draw(const struct comparison *c, struct cmp_figures *f) {
  enum { SIZE = 480, SMALL = 300, LEFT = 130, EDGE = 20, BELOW = 90 }; /* px */
  const size_t time = c->n_times - 1;
  const struct cmp_at *at = &c->run[0].at[time];
  if (!cmp_known(&at->largest) || !(at->largest.value > SEEN)) return OK;
  const double reach = 4 * at->largest.value;
  const struct cmp_frame frame = {-reach, reach};
  const double tick = cmp_tick_step(&frame);
  struct cmp_figure *fig;
  TRY(cmp_figure_begin(f, CMP_SECTION_OVERLAY, false, CMP_PANELS_WIDTH, SIZE + EDGE + BELOW, &fig,
                       "closeup-t%.4g", c->times[time]));
  fig->column_height = SMALL + EDGE + BELOW;
  snprintf(fig->caption, sizeof fig->caption,
           "t* = %.4g, where the surfaces are furthest apart: %.3g H, at x = %.6g H, y = %.6g H.",
           at->t, at->largest.value, at->where[0], at->where[1]);
  TRY(cmp_panes_surfaces(c, f, fig, time, 1));
  cmp_figure_formats(fig);
  const double side = 0.5 * (CMP_PANELS_WIDTH - SIZE);
  cmp_figure_margins(fig, &(struct cmp_margins){side, side, EDGE, SIZE},
                     &(struct cmp_margins){LEFT, EDGE, EDGE, SMALL});
  fprintf(
      fig->script,
      "set xrange [%.12g:%.12g]\nset yrange [%.12g:%.12g]\n"
      "set xlabel 'x / H'\nset ylabel 'y / H'\nset xtics %.6g\nset ytics %.6g\nset clip two\n"
      "set format '%%.%df'\n"
      "set key at screen 0.5, screen 0.01 bottom center horizontal noenhanced\nplot NaN notitle",
      at->where[0] - reach, at->where[0] + reach, at->where[1] - reach, at->where[1] + reach,
      2 * tick, tick, (int)fmax(0, ceil(-log10(tick))));
  cmp_panes_plot(fig, 2, "linewidth 1.6 linecolor '#666666'");
  cmp_panes_plot(fig, 1, "linewidth 2 linecolor '#000000'");
  cmp_panes_plot(fig, 0, "linewidth 1.2 linecolor '#d55e00'");
  fputs(", \\\n  keyentry with lines linewidth 2 linecolor '#000000' title 'A', \\\n"
        "  keyentry with lines linewidth 1.2 linecolor '#d55e00' title 'B'\n",
        fig->script);
  return cmp_figure_end(fig);
}

static double known(const struct cmp_value *v) {
  return cmp_known(v) ? v->value : NAN;
}

static void distances_take(const struct comparison *c, struct cmp_diff_run *run) {
  for (size_t k = 0; k < c->n_times && k < 2; k++) {
    const struct cmp_at *at = &c->run[0].at[k];
    if (at->output == SIZE_MAX || at->ref_output == SIZE_MAX) continue;
    run->distance[run->n_distances++] =
        (struct cmp_diff_distance){at->t, known(&at->mean), known(&at->largest), known(&at->area)};
  }
}

static enum status comparison_at(const struct cmp_diff_run *run, const struct case_file *settings,
                                 struct comparison **c) {
  return cmp_comparison_create(settings, run->d->file[0], 1, &run->d->file[1], true, c);
}

/* Since when the surfaces differ; where they do not, anything. */
static double time_of_first(const struct result_diff *d) {
  const struct result_quantity *first = result_diff_first(d);
  for (size_t i = 0; i < d->n; i++)
    if (d->quantity[i].differs && !strcmp(d->quantity[i].name, "surface/points"))
      first = &d->quantity[i];
  const double since = first ? result_quantity_since(first) : NAN;
  return isfinite(since) ? since : 0;
}

static enum status surfaces_draw(struct cmp_diff_run *run, const struct case_file *settings,
                                 struct cmp_figures *f) {
  double times[2] = {time_of_first(run->d)};
  struct case_file s = cmp_settings_at(settings, NULL, times, 1);
  struct comparison *c = NULL;
  enum status status;
  ATTEMPT(result_find_all_surfaces(2, run->d->file));
  ATTEMPT(comparison_at(run, &s, &c));
  const double most = time_of_most(c);
  if (isfinite(most)) { /* all that is new is known only now */
    times[1] = most;
    s = cmp_settings_at(settings, NULL, times, 2);
    cmp_comparison_destroy(c);
    c = NULL;
    ATTEMPT(comparison_at(run, &s, &c));
  }
  distances_take(c, run);
  ATTEMPT(cmp_runs_rank(c));
  ATTEMPT(cmp_overlays_write(c, f));
  if (isfinite(most)) ATTEMPT(closeup_draw(c, f));
  if (isfinite(most)) ATTEMPT(distances_draw(c, f));
done:
  cmp_comparison_destroy(c);
  return status;
}

/* ---- series ---- */

/* B at time t, linear between its rows; NaN outside of them. `from`: where to look on. */
static double value_at(const struct result_curve *c, double t, size_t *from) {
  while (*from + 1 < c->n && c->t[*from + 1] < t) ++*from;
  const size_t i = *from;
  if (!c->n || t < c->t[0] || t > c->t[c->n - 1]) return NAN;
  if (t == c->t[i] || i + 1 == c->n) return c->value[i];
  if (t == c->t[i + 1]) return c->value[i + 1];
  const double u = (t - c->t[i]) / (c->t[i + 1] - c->t[i]);
  return c->value[i] + u * (c->value[i + 1] - c->value[i]);
}

enum { TIME, A, B, DIFFERENCE, COLUMNS };

/* Of each so many rows the one that differs most. */
static enum status rows_make(const struct result_curve curve[2], double **row, size_t *n) {
  const size_t bins = curve[0].n < MOST_ROWS ? curve[0].n : MOST_ROWS;
  size_t from = 0;
  TRY(array_create(row, bins * COLUMNS, "rows of a picture"));
  *n = 0;
  for (size_t k = 0, i = 0; k < bins; k++) {
    double *kept = *row + *n * COLUMNS;
    const size_t first = i, end = curve[0].n * (k + 1) / bins;
    for (; i < end; i++) {
      const double a = curve[0].value[i], b = value_at(&curve[1], curve[0].t[i], &from), d = b - a;
      if (i > first && !(fabs(d) > fabs(kept[DIFFERENCE]))) continue;
      memcpy(kept, (double[COLUMNS]){curve[0].t[i], a, b, d}, COLUMNS * sizeof *kept);
    }
    *n += end > first;
  }
  return OK;
}

/* A label that gnuplot reads: units are the file's own words. */
static void axis_write(const char *what, const char *units, char *out, size_t room) {
  static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/^. -";
  const bool good = *units && strlen(units) < 24 && strspn(units, plain) == strlen(units);
  snprintf(out, room, good ? "%s (%s)" : "%s", what, units);
}

static enum status series_draw(const struct result_quantity *q, double scale,
                               struct cmp_figures *f) {
  char name[96], title[128], axis[2][64], caption[256], visible[160];
  double *row;
  size_t n;
  for (int k = 0; k < 2; k++)
    if (!q->curve[k].n) return OK;
  TRY(rows_make(q->curve, &row, &n));
  cmp_slug(q->name + strlen("series/"), name, 64);
  cmp_text_fit(q->name, title, sizeof title);
  cmp_text_fit(q->name, visible, 120);
  axis_write("value", q->units, axis[0], sizeof axis[0]);
  axis_write("B - A", q->units, axis[1], sizeof axis[1]);
  const double since = result_quantity_since(q);
  snprintf(caption, sizeof caption,
           "%s in both, and their difference, which begins at t = %.6g s (t√(g/H) = %.4g).",
           visible, since, since / scale);
  const struct cmp_graph_column column[COLUMNS] = {
      [TIME] = {.head = "t [s]", .label = "t (s)"},
      [A] = {.head = "A", .label = "A", .axis = axis[0]},
      [B] = {.head = "B", .label = "B"},
      [DIFFERENCE] = {.head = "B - A", .label = axis[1], .panel = 1, .level = "0"}};
  const struct cmp_graph graph = {.name = name,
                                  .title = title,
                                  .caption = caption,
                                  .section = CMP_SECTION_ENERGY,
                                  .n_columns = COLUMNS,
                                  .column = column};
  return curve_draw(&graph, "both", n, row, f);
}

/* ---- all of a run ---- */

static enum status pictures_draw(struct cmp_diff_run *run, const struct case_file *settings,
                                 struct cmp_figures *f) {
  const struct result_quantity **q = NULL;
  size_t n;
  enum status status = surfaces_draw(run, settings, f);
  if (status == ERR_INPUT) { /* no walls, no surfaces */
    run->pictures_missing = strdup(status_message());
    status = run->pictures_missing ? OK : ERR_MEMORY;
  }
  if (status != OK) return status;
  TRY(cmp_diff_order(run, &n, &q));
  for (size_t i = 0; i < n && status == OK; i++) status = series_draw(q[i], run->d->time_scale, f);
  free(q);
  return status;
}

/* "bem-" of the run bem.h5. */
static void prefix_make(const char *name, char *out, size_t room) {
  char slug[40];
  cmp_slug(name, slug, sizeof slug);
  const size_t n = strlen(slug);
  if (n == strlen(name) && n > 3) slug[n - 3] = 0;
  snprintf(out, room, "%s-", slug);
}

enum status cmp_diff_picture(struct cmp_diff *d, size_t k, const struct case_file *settings,
                             struct cmp_figures *f) {
  struct cmp_diff_run *run = &d->run[k];
  enum status status = OK;
  size_t drawn = 0;
  if (!run->d) return OK;
  for (size_t i = 0; i < k; i++) drawn += d->run[i].n_figures > 0;
  run->first_figure = f->n;
  if (run->outcome == CMP_DIFF_DIFFERS && drawn < CMP_DIFF_PICTURED) {
    if (d->folders) prefix_make(run->name, f->prefix, sizeof f->prefix);
    status = name_sides(run->d->file);
    if (status == OK) status = pictures_draw(run, settings, f);
    f->prefix[0] = 0;
  } else if (run->outcome == CMP_DIFF_DIFFERS) {
    run->pictures_missing = strdup("left out: the first runs that differ have pictures");
  }
  run->n_figures = f->n - run->first_figure;
  result_diff_forget(run->d);
  return status;
}

#include "compare/overlays.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/chart.h"
#include "compare/cloud.h"
#include "compare/panes.h"
#include "compare/profiles.h"
#include "compare/text.h"

/* ---- colours ---- */

/* The top of the colours, common to all runs: the (lower) median of theirs, so that a run full of
 * noise does not take the contrast from the others. */
static double median_top(size_t n, const struct cmp_cloud *cloud) {
  double *top = malloc((n + 1) * sizeof *top), median = 0;
  size_t found = 0;
  for (size_t r = 0; top && r < n; r++)
    if (cloud[r].n) top[found++] = cloud[r].top;
  if (found) {
    qsort(top, found, sizeof *top, array_ascending);
    median = top[(found - 1) / 2];
  }
  free(top);
  return median;
}

static double fifths(double top) {
  return fmax(0.2, ceil(top * 5 - 1e-9) / 5);
}

enum status cmp_shades_choose(const struct comparison *c, size_t n, const size_t *time,
                              struct cmp_shades *s, bool *any) {
  struct cmp_cloud *cloud;
  double top = 0, off = 0;
  *any = false;
  TRY(array_create(&cloud, n, "colours"));
  for (size_t r = 0; r < c->n_runs; r++) {
    const enum status status = cmp_clouds_look(c, r, s->field, n, time, cloud);
    if (status != OK) {
      free(cloud);
      return status;
    }
    for (size_t k = 0; k < n; k++) {
      if (!cloud[k].n) continue;
      *any = true;
      top = fmax(top, cloud[k].top);
      off = fmax(off, fmax(fabs(cloud[k].low - 1), fabs(cloud[k].top - 1)));
    }
  }
  free(cloud);
  s->low = 0;
  s->high = fifths(top);
  if (s->field != CMP_FIELD_density) return OK;
  off = fmax(0.002, ceil(off * 500 - 1e-9) / 500);
  s->low = 1 - off;
  s->high = 1 + off;
  return OK;
}

/* ---- overlays ---- */

/* Particles are drawn once into a transparent picture of the panel's size, which the three formats
 * then share: as vectors twenty thousand discs a panel would make files of a hundred megabytes. */
static void layers_draw(const struct cmp_figure *fig, const struct cmp_layout *l,
                        const struct geo_box *view, const struct comparison *c,
                        const struct cmp_cloud *cloud, const struct cmp_shades *shades) {
  int w = (int)lround(fig->layer * l->width), h = (int)lround(fig->layer * l->height);
  fprintf(fig->script,
          "%sset cbrange [%g:%g]\nset style fill solid 1 noborder\n"
          "set terminal pngcairo transparent size %d,%d\nset margins 0,0,0,0\n"
          "unset border\nunset tics\nunset colorbox\nunset key\n"
          "set xrange [%.6g:%.6g]\nset yrange [%.6g:%.6g]\n",
          cmp_panes_palette, shades->low, shades->high, w, h, view->min[0], view->max[0],
          view->min[1], view->max[1]);
  for (size_t r = 0; r < c->n_runs; r++) {
    char table[192];
    if (!cloud[r].n) continue;
    snprintf(table, sizeof table, "%s-particles-%zu.csv", fig->name, r + 1);
    fprintf(fig->script, "set output '%s.layer%zu.png'\n", fig->name, r);
    cmp_pane_discs(fig, l, table, cloud[r].spacing / 2, 3);
  }
  fputs("unset output\nreset\nset datafile separator ','\n", fig->script);
}

static void panel_title(const struct comparison *c, const struct cmp_run *run, size_t time,
                        const struct cmp_shades *shades, char *title, size_t room) {
  const struct cmp_at *at = &run->at[time];
  const char *label = run->data.label, *ref = c->ref.data.label;
  char when[96] = "";
  if (shades->film && at->output != SIZE_MAX) {
    const bool under = !shades->alone && at->ref_output != SIZE_MAX;
    snprintf(title, room, "%.60s%s%.60s, t* = %.2f", label, under ? " under " : "",
             under ? ref : "", at->t);
    return;
  }
  if (at->output == SIZE_MAX) {
    snprintf(title, room, "%.60s: no output at this time", label);
    return;
  }
  if (at->ref_output == SIZE_MAX) {
    snprintf(title, room, "%.60s: t* = %.4g, %.60s has no surface then", label, at->t, ref);
    return;
  }
  if (fabs(at->t - at->ref_t) > 1e-6 || fabs(at->t - c->times[time]) > 1e-6)
    snprintf(when, sizeof when, " (t* = %.4g, %.40s at %.4g)", at->t, ref, at->ref_t);
  if (cmp_known(&at->mean) && cmp_known(&at->area))
    snprintf(title, room, "%.60s%s: mean %.2g H, area %.2g H²", label, when, at->mean.value,
             at->area.value);
  else
    snprintf(title, room, "%.60s%s", label, when);
}

static void panel_draw(const struct comparison *c, const struct cmp_figure *fig,
                       const struct cmp_layout *l, const struct geo_box *view,
                       const struct cmp_cloud *cloud, const struct cmp_shades *shades,
                       bool particles, size_t time, size_t k, size_t r) {
  const struct cmp_run *run = &c->run[r];
  const struct cmp_at *at = &run->at[time];
  FILE *s = fig->script;
  cmp_pane_place(fig, l, k);
  char title[256];
  panel_title(c, run, time, shades, title, sizeof title);
  cmp_pane_title(fig, title);
  cmp_pane_axes(fig, l, k, cmp_runs_picked(c, CMP_PANELS));
  if (k == 0 && particles)
    cmp_pane_colours(fig, l, cmp_fields[shades->field].label);
  else
    fputs("unset colorbox\n", s);
  /* one point of the palette, so that the colour box appears */
  fputs("plot '+' using (-1e9):(-1e9):(0) with points pointtype 0 linecolor palette notitle", s);
  if (cloud->n)
    fprintf(s,
            ", \\\n  '%s.layer%zu.png' binary filetype=png origin=(%.8g,%.8g) dx=%.8g dy=%.8g with "
            "rgbalpha notitle",
            fig->name, r, view->min[0], view->min[1],
            (view->max[0] - view->min[0]) / round(fig->layer * l->width),
            (view->max[1] - view->min[1]) / round(fig->layer * l->height));
  cmp_panes_plot(fig, c->n_runs + 1, "linewidth 1.6 linecolor '#666666'");
  cmp_panes_plot(fig, r,
                 shades->alone ? "linewidth 1 linecolor '#000000'"
                               : "linewidth 0.8 linecolor '#d55e00'");
  if (at->ref_output != SIZE_MAX && !shades->alone) {
    cmp_panes_plot(fig, c->n_runs, "linewidth 2.6 linecolor '#ffffff'");
    cmp_panes_plot(fig, c->n_runs, "linewidth 1.2 linecolor '#000000'");
  }
  if (cmp_panes_profiled(c, time))
    fprintf(s,
            ", \\\n  '%s-surfaces.csv' skip 1 using ($1==%zu?$4:NaN):5 with points pointtype 6 "
            "pointsize 0.7 linecolor '#0072b2' notitle",
            fig->name, c->n_runs + 2);
  fputc('\n', s);
}

static enum status overlay_begin(const struct comparison *c, struct cmp_figures *f, size_t time,
                                 struct cmp_overlay *o) {
  struct cmp_figure *fig;
  o->figure = SIZE_MAX;
  if (!cmp_comparison_has_output(c, time)) return OK;
  o->view = cmp_panes_view(c, time);
  o->layout = cmp_panes_layout(&o->view, cmp_runs_picked(c, CMP_PANELS));
  TRY(cmp_figure_begin(f, CMP_SECTION_OVERLAY, true, CMP_PANELS_WIDTH, o->layout.total, &fig,
                       "overlay-t%.4g", c->times[time]));
  o->figure = f->n - 1;
  return cmp_panes_surfaces(c, f, fig, time, CMP_PANELS);
}

static bool any_particles(const struct comparison *c, const struct cmp_cloud *cloud) {
  for (size_t r = 0; r < c->n_runs; r++)
    if (cloud[r].n) return true;
  return false;
}

/* What was measured, and how far each run picked is from it. */
static void profiles_say(const struct comparison *c, size_t time, struct cmp_figure *fig) {
  const struct result_file *f = c->ref.data.file;
  const size_t room = sizeof fig->caption;
  for (size_t k = 0; k < f->n_profiles; k++) {
    if (!cmp_profile_is_at(c, k, time)) continue;
    size_t at = strlen(fig->caption);
    snprintf(fig->caption + at, room - at, " Circles: %.60s", f->profiles[k].label);
    for (size_t r = 0, shown = 0; r < c->n_runs; r++) {
      const struct cmp_value v = cmp_profile_distance(c, &c->run[r], k, time);
      if (!cmp_run_is_picked(c, r, CMP_PANELS) || !cmp_known(&v)) continue;
      at = strlen(fig->caption);
      snprintf(fig->caption + at, room - at, "%s %.30s %.2g H",
               shown++ ? "," : "; mean distance from", c->run[r].data.label, v.value);
    }
    at = strlen(fig->caption);
    snprintf(fig->caption + at, room - at, ".");
  }
}

/* Points of a lattice are none. */
static const char *points_of(const struct comparison *c) {
  for (size_t r = 0; r < c->n_runs; r++)
    if (!strcmp(c->run[r].data.file->solver, "sph")) return "Particles";
  return "Points in the water";
}

static void overlay_caption(const struct comparison *c, size_t time, bool particles,
                            const struct cmp_layout *l, struct cmp_figure *fig) {
  char stretched[64], coloured[128];
  snprintf(coloured, sizeof coloured,
           "%s coloured by pressure (the same colours for every run), the run's own", points_of(c));
  cmp_layout_say(l, stretched, sizeof stretched);
  snprintf(fig->caption, sizeof fig->caption,
           "t* = %.4g. %s free surface in thin orange, that of %.60s in black. Mean: distance "
           "between the two; area: between them.%s",
           c->times[time], particles ? coloured : "The run's", c->ref.data.label, stretched);
  profiles_say(c, time, fig);
  size_t used = strlen(fig->caption);
  cmp_picked_say(c, CMP_PANELS, "have no panel", fig->caption + used, sizeof fig->caption - used);
}

enum status cmp_overlay_draw(const struct comparison *c, struct cmp_figures *f, size_t time,
                             const struct cmp_overlay *o, const struct cmp_shades *shades,
                             const struct cmp_cloud *cloud) {
  struct cmp_figure *fig = &f->figure[o->figure];
  const struct geo_box *view = &o->view;
  const bool particles = any_particles(c, cloud);
  overlay_caption(c, time, particles, &o->layout, fig);
  layers_draw(fig, &o->layout, view, c, cloud, shades);
  cmp_figure_formats(fig);
  fprintf(fig->script,
          "%sset cbrange [%g:%g]\nset cbtics %g\n"
          "unset key\nunset grid\nset tics front\n"
          "set xrange [%.6g:%.6g]\nset yrange [%.6g:%.6g]\nset ytics 0.5\nset multiplot\n",
          cmp_panes_palette, shades->low, shades->high, (shades->high - shades->low) / 4,
          view->min[0], view->max[0], view->min[1], view->max[1]);
  for (size_t r = 0, k = 0; r < c->n_runs; r++)
    if (cmp_run_is_picked(c, r, CMP_PANELS))
      panel_draw(c, fig, &o->layout, view, &cloud[r], shades, particles, time, k++, r);
  fputs("unset multiplot\n", fig->script);
  return cmp_figure_end(fig);
}

static enum status overlay_draw(const struct comparison *c, struct cmp_figures *f, size_t time,
                                const struct cmp_overlay *o, const struct cmp_cloud *cloud) {
  const struct cmp_shades shades = {.high = fifths(median_top(c->n_runs, cloud))};
  return cmp_overlay_draw(c, f, time, o, &shades, cloud);
}

/* Run by run, for each file is read once, and one run's particles at a time are in memory. `cloud`
 * [n_times][n_runs]. */
static enum status clouds_take(const struct comparison *c, struct cmp_figures *f,
                               const struct cmp_overlay *o, struct cmp_cloud *cloud) {
  enum status status = OK;
  size_t *figure = calloc(c->n_times + 1, sizeof *figure);
  struct cmp_cloud *own = calloc(c->n_times + 1, sizeof *own);
  if (!figure || !own) status = status_raise(ERR_MEMORY, "no memory for the pictures");
  for (size_t k = 0; status == OK && k < c->n_times; k++) figure[k] = o[k].figure;
  for (size_t r = 0; r < c->n_runs && status == OK; r++) {
    if (!cmp_run_is_picked(c, r, CMP_PANELS)) continue;
    status = cmp_clouds_write(c, r, CMP_FIELD_pressure, f, figure, own);
    for (size_t k = 0; k < c->n_times; k++) cloud[k * c->n_runs + r] = own[k];
  }
  free(figure);
  free(own);
  return status;
}

/* ---- the jet, close up ---- */

static const struct cmp_jet *jet_at(const struct comparison *c, size_t time, size_t r) {
  if (r < c->n_runs) {
    const struct cmp_at *at = &c->run[r].at[time];
    const struct cmp_jet *jet = at->output == SIZE_MAX ? NULL : &c->run[r].data.jet[at->output];
    return jet && jet->found ? jet : NULL;
  }
  for (size_t q = 0; q < c->n_runs; q++) {
    size_t output = c->run[q].at[time].ref_output;
    if (output != SIZE_MAX && c->ref.data.jet[output].found) return &c->ref.data.jet[output];
  }
  return NULL;
}

static void view_around(const struct cmp_jet *jet, struct geo_box *view) {
  const double *points[] = {jet->tip, jet->root, isfinite(jet->foot[0]) ? jet->foot : jet->tip};
  *view = (struct geo_box){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
  for (size_t i = 0; i < 3; i++)
    for (int k = 0; k < 2; k++) {
      view->min[k] = fmin(view->min[k], points[i][k] - 0.25);
      view->max[k] = fmax(view->max[k], points[i][k] + 0.25);
    }
}

struct jet_figure {
  struct geo_box view;
  struct cmp_margins margins[2]; /* [0] as usual, [1] in one column */
  struct cmp_key key;
  int height[2];
};

enum { JET_EDGE = 20, JET_HIGHEST = 520 }; /* px */

static struct jet_figure jet_layout(const struct comparison *c, const struct cmp_jet *jet) {
  struct jet_figure l;
  view_around(jet, &l.view);
  const double aspect = (l.view.max[0] - l.view.min[0]) / (l.view.max[1] - l.view.min[1]);
  size_t longest = cmp_key_length(c->ref.data.label);
  for (size_t r = 0; r < c->n_runs; r++)
    if (cmp_run_is_picked(c, r, CMP_NAMED) && cmp_key_length(c->run[r].data.label) > longest)
      longest = cmp_key_length(c->run[r].data.label);
  l.key = cmp_key_of(cmp_runs_picked(c, CMP_NAMED) + 1, longest);
  for (int k = 0; k < 2; k++) {
    const double room = (k ? CMP_PANELS_NARROW : CMP_PANELS_WIDTH) - CMP_PANES_LEFT - JET_EDGE;
    const double height = fmin(JET_HIGHEST, room / aspect), spare = 0.5 * (room - height * aspect);
    l.margins[k] = (struct cmp_margins){CMP_PANES_LEFT + spare, JET_EDGE + spare, JET_EDGE, height};
    l.height[k] = (int)height + JET_EDGE + l.key.height[k];
  }
  return l;
}

static void jet_curve(const struct comparison *c, const struct cmp_figure *fig, size_t time,
                      size_t k) {
  FILE *s = fig->script;
  size_t r = k < c->n_runs ? k : SIZE_MAX;
  struct cmp_style style = cmp_run_style(c, r);
  bool shown = r == SIZE_MAX || c->run[r].at[time].output != SIZE_MAX;
  fprintf(s,
          ", \\\n  '%s-surfaces.csv' skip 1 using ($1==%zu?$4:NaN):5 with lines linewidth %g "
          "dashtype %s linecolor '%s' title ",
          fig->name, k, r == SIZE_MAX ? 2.0 : 1.1, cmp_dashes(&style), style.colour);
  cmp_key_string(s, cmp_run_or_ref(c, r)->data.label, shown ? NULL : " (no output then)");
  const struct cmp_jet *jet = jet_at(c, time, k);
  if (jet)
    fprintf(s,
            ", \\\n  '+' using (%.6g):(%.6g) every ::0::0 with points pointtype 2 pointsize 0.9 "
            "linecolor '%s' notitle",
            jet->tip[0], jet->tip[1], style.colour);
}

/* Drawn when the reference has a jet: of one that only a run has, the overlay shows enough. */
static enum status jet_draw(const struct comparison *c, struct cmp_figures *f, size_t time) {
  const struct cmp_jet *main = jet_at(c, time, c->n_runs);
  if (!main) return OK;
  struct jet_figure l = jet_layout(c, main);
  struct cmp_figure *fig;
  TRY(cmp_figure_begin(f, CMP_SECTION_JET, false, CMP_PANELS_WIDTH, l.height[0], &fig, "jet-t%.4g",
                       c->times[time]));
  fig->column_height = l.height[1];
  snprintf(fig->caption, sizeof fig->caption,
           "The plunging jet at t* = %.4g, same scale in both directions; crosses mark the tips.",
           c->times[time]);
  size_t used = strlen(fig->caption);
  cmp_picked_say(c, CMP_NAMED, "are left out", fig->caption + used, sizeof fig->caption - used);
  TRY(cmp_panes_surfaces(c, f, fig, time, CMP_NAMED));
  cmp_figure_formats(fig);
  FILE *s = fig->script;
  cmp_figure_margins(fig, &l.margins[0], &l.margins[1]);
  cmp_key_place(fig, &l.key);
  fprintf(s,
          "set xrange [%.6g:%.6g]\nset yrange [%.6g:%.6g]\n"
          "set xlabel 'x / H' offset 0, character 0.4\nset ylabel 'y / H'\nplot NaN notitle",
          l.view.min[0], l.view.max[0], l.view.min[1], l.view.max[1]);
  cmp_panes_plot(fig, c->n_runs + 1, "linewidth 1.6 linecolor '#666666'");
  jet_curve(c, fig, time, c->n_runs); /* the reference below: a run that lies on it is seen */
  for (size_t r = 0; r < c->n_runs; r++)
    if (cmp_run_is_picked(c, r, CMP_NAMED)) jet_curve(c, fig, time, r);
  fputc('\n', s);
  return cmp_figure_end(fig);
}

enum status cmp_overlays_write(const struct comparison *c, struct cmp_figures *f) {
  enum status status = OK;
  struct cmp_overlay *o = calloc(c->n_times + 1, sizeof *o);
  struct cmp_cloud *cloud = calloc(c->n_times * c->n_runs + 1, sizeof *cloud);
  if (!o || !cloud) {
    status = status_raise(ERR_MEMORY, "no memory for the pictures");
    goto done;
  }
  for (size_t k = 0; k < c->n_times; k++) ATTEMPT(overlay_begin(c, f, k, &o[k]));
  ATTEMPT(clouds_take(c, f, o, cloud));
  for (size_t k = 0; k < c->n_times; k++) {
    if (o[k].figure == SIZE_MAX) continue;
    ATTEMPT(overlay_draw(c, f, k, &o[k], &cloud[k * c->n_runs]));
    ATTEMPT(jet_draw(c, f, k));
  }
done:
  free(o);
  free(cloud);
  return status;
}

#include "compare/chart.h"

#include <stdint.h>
#include <string.h>

#include "compare/text.h"

enum { MOST_MARKS = 4 };

const struct cmp_run *cmp_run_or_ref(const struct comparison *c, size_t r) {
  return r == SIZE_MAX ? &c->ref : &c->run[r];
}

double cmp_chart_time_end(const struct comparison *c, const struct cmp_chart_plan *plan) {
  double end = 0;
  if (plan->end > 0) return plan->end;
  for (size_t r = 0; r <= c->n_runs; r++) {
    const struct cmp_data *d = &cmp_run_or_ref(c, r < c->n_runs ? r : SIZE_MAX)->data;
    if (d->n) end = fmax(end, d->t[d->n - 1]);
    if (d->kinetic.n) end = fmax(end, d->kinetic.t[d->kinetic.n - 1]);
  }
  return end > 0 ? end : 1;
}

static size_t longer(size_t longest, const char *label) {
  size_t n = cmp_key_length(label);
  return n > longest ? n : longest;
}

static void key_measure(const struct comparison *c, const struct cmp_chart_plan *plan,
                        struct cmp_chart *chart) {
  const struct cmp_data *ref = &c->ref.data;
  size_t named = cmp_runs_picked(c, CMP_NAMED), n = named + 1, longest = longer(0, ref->label);
  if (named < c->n_runs) {
    n++;
    longest = longer(longest, "1000 other runs");
  }
  for (size_t r = 0; r < c->n_runs; r++)
    if (cmp_run_is_picked(c, r, CMP_NAMED)) longest = longer(longest, c->run[r].data.label);
  for (size_t k = 0; plan->target && k < ref->n_experiments; k++) {
    if (strcmp(ref->file->experiments[k].target, plan->target)) continue;
    n++;
    longest = longer(longest, ref->experiments[k].name);
  }
  chart->key = cmp_key_of(n, longest + plan->note);
}

enum status cmp_chart_begin(const struct comparison *c, struct cmp_figures *f,
                            const struct cmp_chart_plan *plan, struct cmp_chart *chart) {
  *chart = (struct cmp_chart){.c = c, .panels = plan->panels, .end = cmp_chart_time_end(c, plan)};
  key_measure(c, plan, chart);
  int height[2];
  cmp_panels_heights(plan->panels, plan->panel_height, &chart->key, height);
  bool many = c->n_runs > CMP_NAMED; /* as vectors, a thousand curves are tens of megabytes */
  TRY(cmp_figure_begin(f, plan->section, many, CMP_PANELS_WIDTH, height[0], &chart->fig, "%s",
                       plan->name));
  chart->fig->column_height = height[1];
  TRY(cmp_figure_data(f, chart->fig, ".csv", &chart->table));
  fprintf(chart->table, "series,name,t_star [sqrt(H/g)],%s\n", plan->columns);
  if (many) {
    TRY(cmp_figure_data(f, chart->fig, "-others.csv", &chart->others));
    fprintf(chart->others, "series,name,t_star [sqrt(H/g)],%s\n", plan->columns);
  }
  cmp_figure_formats(chart->fig);
  fprintf(chart->fig->script, "set multiplot\nset xrange [0:%.6g]\n", chart->end);
  return OK;
}

enum status cmp_chart_end(struct cmp_chart *chart) {
  struct cmp_figure *fig = chart->fig;
  fputs("unset multiplot\n", fig->script);
  enum status table = cmp_figure_data_end(fig, chart->table);
  enum status others = chart->others ? cmp_figure_data_end(fig, chart->others) : OK;
  enum status script = cmp_figure_end(fig);
  return table != OK ? table : others != OK ? others : script;
}

/* The rows of other runs stand in a table of their own, kept apart by empty lines: one pass of
 * gnuplot draws all of them, while every named curve is a pass over its table. */
static FILE *table_of(struct cmp_chart *chart, size_t series) {
  if (!chart->others || series >= chart->c->n_runs ||
      cmp_run_is_picked(chart->c, series, CMP_NAMED))
    return chart->table;
  if (series != chart->other) fputc('\n', chart->others);
  chart->other = series;
  return chart->others;
}

void cmp_chart_row(struct cmp_chart *chart, size_t series, const char *name, double t,
                   const double *value, size_t n) {
  FILE *table = table_of(chart, series);
  fprintf(table, "%zu,", series);
  cmp_csv_string(table, name);
  fprintf(table, ",%.10g", t);
  for (size_t k = 0; k < n; k++)
    if (isfinite(value[k]))
      fprintf(table, ",%.10g", value[k]);
    else
      fputs(",NaN", table); /* breaks the line; gnuplot draws one over an empty field */
  fputc('\n', table);
}

/* Names of instants above a panel: those that would lie on each other stand in higher rows. */
struct row_of_names {
  double apart; /* of names in a row */
  double last[3];
  bool any[3];
};

/* The height of the lowest row that has room at t, in characters; the last if none has. */
static double row_above(struct row_of_names *r, double t) {
  int k = 0;
  while (k < 2 && r->any[k] && fabs(t - r->last[k]) < r->apart) k++;
  r->any[k] = true;
  r->last[k] = t;
  return 0.5 + 0.85 * k;
}

/* Instants of the reference as vertical lines, named above the first panel. */
static void instants_mark(const struct cmp_chart *chart, bool named) {
  const struct cmp_data *ref = &chart->c->ref.data;
  char over[128];
  snprintf(over, sizeof over, "end of %.80s", ref->label);
  struct cmp_value last = cmp_number(ref->n ? ref->t[ref->n - 1] : NAN);
  if (ref->n && last.value > chart->end - 1e-6) last.value = NAN;
  const struct {
    const struct cmp_value *t;
    const char *name;
  } mark[] = {{&ref->impact.time, "wall impact"},
              {&ref->overturning.time, "overturning"},
              {&ref->touchdown.time, "touchdown"},
              {&last, over}};
  FILE *s = chart->fig->script;
  struct row_of_names rows[] = {{.apart = 0.12 * chart->end}, {.apart = 0.26 * chart->end}};
  fputs("unset arrow\nunset label\n", s);
  double before = -1;
  for (size_t k = 0; k < sizeof mark / sizeof *mark; k++) {
    if (!cmp_known(mark[k].t) || mark[k].t->value > chart->end) continue;
    double t = mark[k].t->value;
    if (t == before) continue;
    fprintf(s,
            "set arrow from %.6g, graph 0 to %.6g, graph 1 nohead back linecolor '#999999' "
            "dashtype 3 linewidth 0.8\n",
            t, t);
    before = t;
    if (!named) continue;
    const double wide = row_above(&rows[0], t), narrow = row_above(&rows[1], t);
    fputs("set label ", s);
    cmp_key_string(s, mark[k].name, NULL);
    if (t > 0.85 * chart->end) /* it would leave the page */
      fputs(" at graph 1", s);
    else
      fprintf(s, " at %.6g", t);
    fprintf(s,
            ", graph 1 offset 0, character (narrow ? %.2f : %.2f) %s noenhanced textcolor "
            "'#666666' font small\n",
            narrow, wide, t > 0.85 * chart->end ? "right" : "center");
  }
}

static struct cmp_panels panels_of(const struct cmp_chart *chart) {
  return (struct cmp_panels){chart->fig, chart->panels, chart->key};
}

void cmp_chart_panel(struct cmp_chart *chart, size_t k, const struct cmp_frame *frame,
                     const char *label, const char *title) {
  struct cmp_panels panels = panels_of(chart);
  cmp_panel_place(&panels, k, "t √(g/H)");
  instants_mark(chart, k == 0);
  cmp_panel_labels(&panels, label, title);
  fprintf(chart->fig->script, "set yrange [%.12g:%.12g]\nset ytics %.12g\n", frame->low,
          frame->high, cmp_tick_step(frame));
  chart->first = true;
  chart->marks[0] = chart->marks[1] = 0;
}

static void extreme_mark(struct cmp_chart *chart, const struct cmp_extreme *x, bool top,
                         const char *colour) {
  FILE *s = chart->fig->script;
  int *marks = &chart->marks[top ? 0 : 1];
  struct cmp_panels panels = panels_of(chart);
  double px = 1 / cmp_panel_height(&panels); /* of the panel's height */
  double edge = top ? 1 : 0, inwards = top ? -px : px;
  if (!x->found) return;
  fprintf(s,
          "set arrow from %.6g, graph %.4f to %.6g, graph %.4f front head filled size screen "
          "8.1/wide,20 linewidth 1 linecolor '%s'\n",
          x->t, edge + (24 + 18 * fmin(*marks, MOST_MARKS)) * inwards, x->t, edge, colour);
  if (*marks < MOST_MARKS) {
    bool late = x->t > 0.85 * chart->end;
    fprintf(s,
            "set label '%.3g' at %.6g, graph %.4f offset character %s, 0 %s front boxed textcolor "
            "'%s' font small\n",
            x->value, x->t, edge + (18 + 18 * *marks) * inwards, late ? "-0.6" : "0.6",
            late ? "right" : "left", colour);
  }
  ++*marks;
}

void cmp_chart_mark(struct cmp_chart *chart, const struct cmp_beyond *b, const char *colour) {
  extreme_mark(chart, &b->above, true, colour);
  extreme_mark(chart, &b->below, false, colour);
}

static void curve_open(struct cmp_chart *chart) {
  fputs(chart->first ? "plot " : ", \\\n  ", chart->fig->script);
  chart->first = false;
}

void cmp_chart_curve(struct cmp_chart *chart, const struct cmp_curve *k) {
  FILE *s = chart->fig->script;
  curve_open(chart);
  fprintf(s, "'%s.csv' skip 1 every %zu using ($1==%zu?$3:NaN):%zu", chart->fig->name,
          k->every ? k->every : 1, k->series, k->column + 4);
  if (k->symbol)
    fprintf(s, " with points pointtype %d pointsize 0.6 linewidth 0.8", k->symbol);
  else
    fprintf(s, " with lines linewidth %g dashtype %s", k->width, cmp_dashes(&k->style));
  fprintf(s, " linecolor '%s' ", k->style.colour);
  if (!k->name) {
    fputs("notitle", s);
    return;
  }
  fputs("title ", s);
  cmp_key_string(s, k->name, k->note);
}

void cmp_chart_band(struct cmp_chart *chart, size_t series, size_t column, const char *colour) {
  curve_open(chart);
  fprintf(chart->fig->script,
          "'%s.csv' skip 1 using ($1==%zu?$3:NaN):%zu:%zu with filledcurves fillcolor '%s' "
          "fillstyle transparent solid 0.25 noborder notitle",
          chart->fig->name, series, column + 4, column + 5, colour);
}

void cmp_chart_others(struct cmp_chart *chart, size_t column, bool named) {
  FILE *s = chart->fig->script;
  if (!chart->others) return;
  curve_open(chart);
  fprintf(s, "'%s-others.csv' skip 1 using 3:%zu with lines linewidth 0.4 linecolor '#c4c4c4' ",
          chart->fig->name, column + 4);
  if (named)
    fprintf(s, "title '%zu other runs'", chart->c->n_runs - CMP_NAMED);
  else
    fputs("notitle", s);
}

void cmp_chart_level(struct cmp_chart *chart, double level) {
  curve_open(chart);
  fprintf(chart->fig->script,
          "%.6g with lines linewidth 0.8 dashtype 2 linecolor '#777777' notitle", level);
}

void cmp_chart_key_entry(struct cmp_chart *chart, size_t run, const char *note) {
  struct cmp_style style = cmp_run_style(chart->c, run);
  curve_open(chart);
  fprintf(chart->fig->script, "keyentry with lines linewidth 1.2 dashtype %s linecolor '%s' title ",
          cmp_dashes(&style), style.colour);
  cmp_key_string(chart->fig->script, chart->c->run[run].data.label, note);
}

void cmp_chart_panel_end(struct cmp_chart *chart) {
  fputc('\n', chart->fig->script);
}

/* ---- keys ---- */

const char *cmp_dashes(const struct cmp_style *style) {
  static const char *const pattern[] = {"1", "(9,4)", "(2,3)", "(9,3,2,3)"};
  return pattern[style->dashes];
}

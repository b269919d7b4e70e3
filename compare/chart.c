#include "compare/chart.h"

#include <stdint.h>
#include <string.h>

#include "compare/text.h"

enum { WIDTH = 900, LEFT = 92, RIGHT = 20, TOP = 36, GAP = 16 };

/* Okabe and Ito's colours, yellow left out: it is lost on white. The reference is black. */
const char *cmp_colour(size_t r) {
  static const char *const palette[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                        "#e69f00", "#56b4e9", "#7f7f7f"};
  return r == SIZE_MAX ? "#000000" : palette[r % (sizeof palette / sizeof *palette)];
}

const struct cmp_run *cmp_run_or_ref(const struct comparison *c, size_t r) {
  return r == SIZE_MAX ? &c->ref : &c->run[r];
}

int cmp_key_columns(size_t longest, int width) {
  int columns = width / (84 + 9 * (int)longest); /* a sample and text of 14 px */
  return columns > 1 ? columns : 1;
}

int cmp_key_height(size_t n, int columns) {
  return 70 + 19 * (int)((n + (size_t)columns - 1) / (size_t)columns);
}

static double time_end(const struct comparison *c) {
  double end = 0;
  for (size_t r = 0; r <= c->n_runs; r++) {
    const struct cmp_data *d = &cmp_run_or_ref(c, r < c->n_runs ? r : SIZE_MAX)->data;
    if (d->n) end = fmax(end, d->t[d->n - 1]);
    if (d->kinetic.n) end = fmax(end, d->kinetic.t[d->kinetic.n - 1]);
  }
  return end > 0 ? end : 1;
}

static void key_measure(const struct comparison *c, const char *target, struct cmp_chart *chart) {
  const struct cmp_data *ref = &c->ref.data;
  size_t n = c->n_runs + 1, longest = strlen(ref->label);
  for (size_t r = 0; r < c->n_runs; r++)
    if (strlen(c->run[r].data.label) > longest) longest = strlen(c->run[r].data.label);
  for (size_t k = 0; target && k < ref->n_experiments; k++) {
    if (strcmp(ref->file->experiments[k].target, target)) continue;
    n++;
    if (strlen(ref->experiments[k].name) > longest) longest = strlen(ref->experiments[k].name);
  }
  chart->columns = cmp_key_columns(longest, WIDTH - 40);
  chart->bottom = cmp_key_height(n, chart->columns);
}

enum status cmp_chart_begin(const struct comparison *c, struct cmp_figures *f,
                            enum cmp_section section, size_t panels, int panel_height,
                            const char *target, double end, const char *columns, const char *name,
                            struct cmp_chart *chart) {
  *chart = (struct cmp_chart){.c = c, .panels = panels, .end = end > 0 ? end : time_end(c)};
  key_measure(c, target, chart);
  int height = TOP + (int)panels * panel_height + GAP * ((int)panels - 1) + chart->bottom;
  TRY(cmp_figure_begin(f, section, false, WIDTH, height, &chart->fig, "%s", name));
  TRY(cmp_figure_data(f, chart->fig, ".csv", &chart->table));
  fprintf(chart->table, "series,name,t_star [sqrt(H/g)],%s\n", columns);
  cmp_figure_formats(chart->fig);
  fprintf(chart->fig->script, "set multiplot\nset xrange [0:%.6g]\n", chart->end);
  return OK;
}

enum status cmp_chart_end(struct cmp_chart *chart) {
  fputs("unset multiplot\n", chart->fig->script);
  enum status table = cmp_figure_data_end(chart->fig, chart->table);
  enum status script = cmp_figure_end(chart->fig);
  return table != OK ? table : script;
}

void cmp_chart_row(struct cmp_chart *chart, size_t series, const char *name, double t,
                   const double *value, size_t n) {
  fprintf(chart->table, "%zu,", series);
  cmp_csv_string(chart->table, name);
  fprintf(chart->table, ",%.10g", t);
  for (size_t k = 0; k < n; k++)
    if (isfinite(value[k]))
      fprintf(chart->table, ",%.10g", value[k]);
    else
      fputs(",", chart->table);
  fputc('\n', chart->table);
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
  fputs("unset arrow\nunset label\n", s);
  double before = -1;
  bool raised = false;
  for (size_t k = 0; k < sizeof mark / sizeof *mark; k++) {
    if (!cmp_known(mark[k].t) || mark[k].t->value > chart->end) continue;
    double t = mark[k].t->value;
    if (t == before) continue;
    fprintf(s,
            "set arrow from %.6g, graph 0 to %.6g, graph 1 nohead back linecolor '#999999' "
            "dashtype 3 linewidth 0.8\n",
            t, t);
    raised = before >= 0 && t - before < 0.12 * chart->end && !raised;
    before = t;
    if (!named) continue;
    fputs("set label ", s);
    cmp_gnuplot_string(s, mark[k].name);
    fprintf(s,
            " at %.6g, graph 1 offset 0, character %.2f center noenhanced textcolor '#666666' "
            "font ',%s'\n",
            t, raised ? 1.35 : 0.5, "11");
  }
}

void cmp_chart_panel(struct cmp_chart *chart, size_t k, const char *range, const char *label) {
  const struct cmp_figure *fig = chart->fig;
  double panels = (double)chart->panels;
  double height = (fig->height - TOP - chart->bottom - GAP * (panels - 1)) / panels;
  double top = TOP + (double)k * (height + GAP);
  fprintf(fig->script,
          "set lmargin at screen %.5f\nset rmargin at screen %.5f\nset tmargin at screen %.5f\n"
          "set bmargin at screen %.5f\n",
          (double)LEFT / fig->width, 1 - (double)RIGHT / fig->width, 1 - top / fig->height,
          1 - (top + height) / fig->height);
  if (k + 1 == chart->panels)
    fprintf(fig->script,
            "set format x\nset xlabel 't √(g/H)' offset 0, character 0.4\n"
            "set key at screen 0.5, screen %.5f bottom center horizontal maxcols %d samplen 2.2 "
            "noenhanced\n",
            8.0 / fig->height, chart->columns);
  else
    fputs("set format x ''\nunset xlabel\nunset key\n", fig->script);
  instants_mark(chart, k == 0);
  fprintf(fig->script, "set yrange [%s]\nset ylabel '%s'\n", range, label);
  chart->first = true;
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
    fprintf(s, " with lines linewidth %g", k->width);
  fprintf(s, " linecolor '%s' ", k->colour);
  if (!k->name) {
    fputs("notitle", s);
    return;
  }
  fputs("title ", s);
  cmp_gnuplot_string(s, k->name);
}

void cmp_chart_level(struct cmp_chart *chart, double level) {
  curve_open(chart);
  fprintf(chart->fig->script,
          "%.6g with lines linewidth 0.8 dashtype 2 linecolor '#777777' notitle", level);
}

void cmp_chart_key_entry(struct cmp_chart *chart, size_t run) {
  curve_open(chart);
  fprintf(chart->fig->script, "keyentry with lines linewidth 1.2 linecolor '%s' title ",
          cmp_colour(run));
  cmp_gnuplot_string(chart->fig->script, chart->c->run[run].data.label);
}

void cmp_chart_panel_end(struct cmp_chart *chart) {
  fputc('\n', chart->fig->script);
}

#include "compare/charts.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text.h"

/* Okabe and Ito's colours, yellow left out: it is lost on white. The reference is black. */
const char *cmp_colour(size_t r) {
  static const char *const palette[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                        "#e69f00", "#56b4e9", "#7f7f7f"};
  return r == SIZE_MAX ? "#000000" : palette[r % (sizeof palette / sizeof *palette)];
}

const struct cmp_run *cmp_run_or_ref(const struct comparison *c, size_t r) {
  return r == SIZE_MAX ? &c->ref : &c->run[r];
}

/* ---- what every chart against time has ---- */

enum { WIDTH = 900, LEFT = 78, RIGHT = 16, TOP = 34, GAP = 14, BOTTOM = 84 };

static double time_end(const struct comparison *c) {
  double end = 0;
  for (size_t r = 0; r <= c->n_runs; r++) {
    const struct cmp_data *d = &cmp_run_or_ref(c, r < c->n_runs ? r : SIZE_MAX)->data;
    if (d->n) end = fmax(end, d->t[d->n - 1]);
    if (d->kinetic.n) end = fmax(end, d->kinetic.t[d->kinetic.n - 1]);
  }
  return end > 0 ? end : 1;
}

/* Panel k of n, from the top; only the lowest has times written below it. */
static void panel_place(const struct cmp_figure *fig, size_t k, size_t n) {
  double height = (double)(fig->height - TOP - BOTTOM - GAP * ((int)n - 1)) / (double)n;
  double top = TOP + (double)k * (height + GAP);
  fprintf(fig->script,
          "set lmargin at screen %.5f\nset rmargin at screen %.5f\nset tmargin at screen %.5f\n"
          "set bmargin at screen %.5f\n",
          (double)LEFT / fig->width, 1 - (double)RIGHT / fig->width, 1 - top / fig->height,
          1 - (top + height) / fig->height);
  if (k + 1 == n)
    fputs("set format x\nset xlabel 't √(g/H)'\n"
          "set key at screen 0.5, screen 0.012 bottom center horizontal samplen 2.2 noenhanced\n",
          fig->script);
  else
    fputs("set format x ''\nunset xlabel\nunset key\n", fig->script);
}

/* Instants of the reference as vertical lines, named above the first panel. */
static void instants_mark(const struct comparison *c, const struct cmp_figure *fig, size_t panel) {
  const struct {
    const struct cmp_value *t;
    const char *name;
  } mark[] = {{&c->ref.data.impact.time, "wall impact"},
              {&c->ref.data.overturning.time, "overturning"},
              {&c->ref.data.touchdown.time, "touchdown"}};
  fputs("unset arrow\nunset label\n", fig->script);
  double before = -1, width = time_end(c);
  int raised = 0;
  for (size_t k = 0; k < sizeof mark / sizeof *mark; k++) {
    if (!cmp_known(mark[k].t)) continue;
    double t = mark[k].t->value;
    fprintf(fig->script,
            "set arrow from %.6g, graph 0 to %.6g, graph 1 nohead back linecolor '#999999' "
            "dashtype 3 linewidth 0.8\n",
            t, t);
    raised = before >= 0 && t - before < 0.11 * width ? !raised : 0;
    before = t;
    if (panel == 0)
      fprintf(fig->script,
              "set label '%s' at %.6g, graph 1 offset 0, character %.2f center textcolor "
              "'#666666' font ',%s'\n",
              mark[k].name, t, raised ? 1.35 : 0.55, "11");
  }
}

static enum status chart_begin(const struct comparison *c, struct cmp_figures *f,
                               enum cmp_section section, int height, const char *name,
                               struct cmp_figure **fig) {
  TRY(cmp_figure_begin(f, section, false, WIDTH, height, fig, "%s", name));
  cmp_figure_formats(*fig);
  fprintf((*fig)->script, "set multiplot\nset xrange [0:%.6g]\n", time_end(c));
  return OK;
}

static enum status chart_end(struct cmp_figure *fig) {
  fputs("unset multiplot\n", fig->script);
  return cmp_figure_end(fig);
}

/* ---- data: one long table a figure; `series` numbers what belongs together ---- */

static enum status table_begin(struct cmp_figures *f, const struct cmp_figure *fig,
                               const char *columns, FILE **table) {
  TRY(cmp_figure_data(f, fig, ".csv", table));
  fprintf(*table, "series,name,%s\n", columns);
  return OK;
}

static void table_row(FILE *table, size_t id, const char *name, double t, const double *value,
                      size_t n) {
  fprintf(table, "%zu,", id);
  cmp_csv_string(table, name);
  fprintf(table, ",%.10g", t);
  for (size_t k = 0; k < n; k++)
    if (isfinite(value[k]))
      fprintf(table, ",%.10g", value[k]);
    else
      fputs(",", table);
  fputc('\n', table);
}

static void table_series(FILE *table, size_t id, const char *name, const struct cmp_series *s) {
  for (size_t i = 0; i < s->n; i++) table_row(table, id, name, s->t[i], &s->value[i], 1);
}

struct curve {
  size_t id;
  int column;
  const char *name, *colour;
  double width;
  int symbol, dash; /* symbol 0: a line */
};

/* One element of a plot command; `first` says whether it opens the command. */
static void curve_plot(const struct cmp_figure *fig, bool first, const struct curve *k) {
  fprintf(fig->script, "%s'%s.csv' skip 1 using ($1==%zu?$3:NaN):%d", first ? "plot " : ", \\\n  ",
          fig->name, k->id, k->column);
  if (k->symbol)
    fprintf(fig->script, " with points pointtype %d pointsize 0.6 linewidth 0.8", k->symbol);
  else
    fprintf(fig->script, " with lines linewidth %g dashtype %d", k->width, k->dash ? k->dash : 1);
  fprintf(fig->script, " linecolor '%s' ", k->colour);
  if (!k->name) {
    fputs("notitle", fig->script);
    return;
  }
  fputs("title ", fig->script);
  cmp_gnuplot_string(fig->script, k->name);
}

static void level_plot(const struct cmp_figure *fig, double level, const char *colour,
                       const char *name) {
  fprintf(fig->script, ", \\\n  %.6g with lines linewidth 0.8 dashtype 2 linecolor '%s' ", level,
          colour);
  if (name)
    fprintf(fig->script, "title '%s'", name);
  else
    fputs("notitle", fig->script);
}

static void end_plot(const struct cmp_figure *fig) {
  fputc('\n', fig->script);
}

/* ---- distance against time ---- */

static enum status distance_chart(const struct comparison *c, struct cmp_figures *f) {
  struct cmp_figure *fig;
  FILE *table;
  TRY(chart_begin(c, f, CMP_SECTION_DISTANCE, 720, "distance", &fig));
  snprintf(
      fig->caption, sizeof fig->caption,
      "Distance of each run's free surface from that of %.60s at every common output: mean and "
      "largest distance of the main surfaces, and the area between them. Dashed: the noise "
      "floor, half a particle spacing (times the surface's length for the area).",
      c->ref.data.label);
  TRY(table_begin(f, fig, "t_star [sqrt(H/g)],mean_distance [H],largest_distance [H],area [H^2]",
                  &table));
  for (size_t r = 0; r < c->n_runs; r++) {
    const struct cmp_evolution *e = &c->run[r].evolution;
    for (size_t i = 0; i < e->n; i++)
      table_row(table, r, c->run[r].data.label, e->t[i],
                (double[]){e->mean[i], e->largest[i], e->area[i]}, 3);
  }
  TRY(cmp_figure_data_end(fig, table));
  static const char *const label[] = {"mean distance / H", "largest distance / H", "area / H^2"};
  for (size_t panel = 0; panel < 3; panel++) {
    panel_place(fig, panel, 3);
    instants_mark(c, fig, panel);
    fprintf(fig->script, "set yrange [0:*]\nset ylabel '%s'\n", label[panel]);
    for (size_t r = 0; r < c->n_runs; r++)
      curve_plot(
          fig, r == 0,
          &(struct curve){r, 4 + (int)panel, c->run[r].data.label, cmp_colour(r), 1.3, 0, 0});
    for (size_t r = 0; r < c->n_runs && panel == 0; r++) {
      bool same = r > 0 && fabs(c->run[r].noise - c->run[r - 1].noise) < 1e-12;
      if (!same) level_plot(fig, c->run[r].noise, "#777777", NULL);
    }
    end_plot(fig);
  }
  return chart_end(fig);
}

/* ---- charts of one kind of series ---- */

/* A series of every run, the reference (drawn on top) and of experiments, in one panel each or
 * all together. */
struct family {
  const struct cmp_series **run; /* [n_runs + 1]: the reference last; NULL: it has none */
  const char *target;            /* of experiments; NULL: none are drawn */
  const char *column, *label;    /* of the table, of the axis */
};

static enum status family_table(const struct comparison *c, struct cmp_figures *f,
                                const struct cmp_figure *fig, const struct family *family) {
  FILE *table;
  char columns[160];
  snprintf(columns, sizeof columns, "t_star [sqrt(H/g)],%s", family->column);
  TRY(table_begin(f, fig, columns, &table));
  for (size_t r = 0; r <= c->n_runs; r++)
    if (family->run[r])
      table_series(table, r, cmp_run_or_ref(c, r < c->n_runs ? r : SIZE_MAX)->data.label,
                   family->run[r]);
  const struct cmp_data *ref = &c->ref.data;
  for (size_t k = 0; k < ref->n_experiments && family->target; k++)
    if (!strcmp(ref->file->experiments[k].target, family->target))
      table_series(table, c->n_runs + 1 + k, ref->experiments[k].name, &ref->experiments[k]);
  return cmp_figure_data_end(fig, table);
}

static void experiments_plot(const struct comparison *c, const struct cmp_figure *fig,
                             const struct family *family, bool *first, bool named) {
  static const int symbols[] = {4, 6, 8, 12, 2};
  const struct cmp_data *ref = &c->ref.data;
  size_t shown = 0;
  for (size_t k = 0; k < ref->n_experiments && family->target; k++) {
    if (strcmp(ref->file->experiments[k].target, family->target)) continue;
    curve_plot(fig, *first,
               &(struct curve){c->n_runs + 1 + k, 4, named ? ref->experiments[k].name : NULL,
                               shown % 2 ? "#a08050" : "#707070", 1, symbols[shown % 5], 0});
    shown++;
    *first = false;
  }
}

static void reference_plot(const struct comparison *c, const struct cmp_figure *fig,
                           const struct family *family, bool *first, bool named) {
  if (!family->run[c->n_runs]) return;
  curve_plot(fig, *first,
             &(struct curve){c->n_runs, 4, named ? c->ref.data.label : NULL, "#000000", 1.1, 0, 0});
  *first = false;
}

static void family_panel(const struct comparison *c, const struct cmp_figure *fig,
                         const struct family *family) {
  bool first = true;
  experiments_plot(c, fig, family, &first, true);
  for (size_t r = 0; r < c->n_runs; r++) {
    if (!family->run[r]) continue;
    curve_plot(fig, first, &(struct curve){r, 4, c->run[r].data.label, cmp_colour(r), 1.2, 0, 0});
    first = false;
  }
  reference_plot(c, fig, family, &first, true);
  end_plot(fig);
}

static bool family_empty(const struct comparison *c, const struct family *family) {
  for (size_t r = 0; r <= c->n_runs; r++)
    if (family->run[r] && family->run[r]->n) return false;
  return true;
}

/* Picks a series of every run by a name, e.g. a probe. */
typedef const struct cmp_series *series_pick(const struct cmp_data *d, const char *name);

static const struct cmp_series *pick_probe(const struct cmp_data *d, const char *name) {
  return cmp_series_find(d->probes, d->n_probes, name);
}

static const struct cmp_series *pick_gauge(const struct cmp_data *d, const char *name) {
  return cmp_series_find(d->gauges, d->n_gauges, name);
}

static const struct cmp_series *pick_own(const struct cmp_data *d, const char *name) {
  const struct cmp_series *own[] = {&d->kinetic,   &d->potential, &d->mechanical, &d->viscosity,
                                    &d->diffusion, &d->closure,   &d->front};
  for (size_t k = 0; k < sizeof own / sizeof *own; k++)
    if (own[k]->name && !strcmp(own[k]->name, name)) return own[k]->n ? own[k] : NULL;
  return NULL;
}

static enum status family_pick(const struct comparison *c, series_pick *pick, const char *name,
                               struct family *family) {
  family->run = calloc(c->n_runs + 1, sizeof *family->run);
  CHECK(family->run, ERR_MEMORY, "no memory for a chart");
  for (size_t r = 0; r <= c->n_runs; r++)
    family->run[r] = pick(&cmp_run_or_ref(c, r < c->n_runs ? r : SIZE_MAX)->data, name);
  return OK;
}

static enum status family_chart(const struct comparison *c, struct cmp_figures *f,
                                enum cmp_section section, const char *file, const char *caption,
                                const char *range, const struct family *family) {
  struct cmp_figure *fig;
  TRY(chart_begin(c, f, section, 400, file, &fig));
  snprintf(fig->caption, sizeof fig->caption, "%s", caption);
  TRY(family_table(c, f, fig, family));
  panel_place(fig, 0, 1);
  instants_mark(c, fig, 0);
  fprintf(fig->script, "set yrange [%s]\nset ylabel '%s'\n", range, family->label);
  family_panel(c, fig, family);
  return chart_end(fig);
}

/* ---- energy ---- */

static enum status energy_charts(const struct comparison *c, struct cmp_figures *f) {
  static const struct {
    const char *name, *file, *column, *label, *range, *caption;
  } charts[] = {
      {"mechanical", "energy", "mechanical [E0]", "(E_k + E_p − E_{rest}) / E_0", "*:*",
       "Mechanical energy (kinetic + potential, relative to the same water at rest) over its "
       "initial value in the reference: what is lost shows as decay."},
      {"kinetic", "energy-kinetic", "kinetic [E0]", "E_k / E_0", "0:*", "Kinetic energy."},
      {"potential", "energy-potential", "potential [E0]", "(E_p − E_{rest}) / E_0", "*:*",
       "Potential energy relative to the same water at rest."},
      {"closure", "energy-budget", "closure [E0]", "budget error / E_0", "*:*",
       "Closure of each energy budget: kinetic + potential + elastic + everything dissipated or "
       "taken "
       "out, minus its value at t = 0. It is zero where every loss is accounted for."}};
  for (size_t k = 0; k < sizeof charts / sizeof *charts; k++) {
    struct family family = {.column = charts[k].column, .label = charts[k].label};
    enum status status = family_pick(c, pick_own, charts[k].name, &family);
    if (status == OK && !family_empty(c, &family))
      status = family_chart(c, f, CMP_SECTION_ENERGY, charts[k].file, charts[k].caption,
                            charts[k].range, &family);
    free(family.run);
    TRY(status);
  }
  return OK;
}

/* ---- pressure: a panel for every run, or noise would hide the others ---- */

static int ascending(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Below and above all but a few rows of the series. */
static void series_extent(const struct cmp_series *s, double *low, double *high) {
  if (!s || !s->n) return;
  double *v = malloc(s->n * sizeof *v);
  size_t n = 0;
  for (size_t i = 0; v && i < s->n; i++)
    if (isfinite(s->value[i])) v[n++] = s->value[i];
  if (n) {
    qsort(v, n, sizeof *v, ascending);
    *low = fmin(*low, v[n / 200]);
    *high = fmax(*high, v[n - 1 - n / 200]);
  }
  free(v);
}

static enum status probe_chart(const struct comparison *c, struct cmp_figures *f,
                               const struct cmp_series *probe, const struct family *family) {
  struct cmp_figure *fig;
  char slug[40], file[64];
  cmp_slug(probe->name, slug, sizeof slug);
  snprintf(file, sizeof file, "pressure-%s", slug);
  size_t panels = c->n_runs ? c->n_runs : 1;
  int height = TOP + BOTTOM + (int)panels * (panels == 1 ? 300 : 190);
  TRY(chart_begin(c, f, CMP_SECTION_PRESSURE, height, file, &fig));
  snprintf(fig->caption, sizeof fig->caption,
           "Pressure at %.60s (x = %.4g H, y = %.4g H): each run, the reference %.60s in black, "
           "experiments as symbols. The axis leaves out the most extreme 0.5 %% of the rows.",
           probe->name, probe->x, probe->y, c->ref.data.label);
  TRY(family_table(c, f, fig, family));
  double low = 0, high = 0;
  for (size_t r = 0; r <= c->n_runs; r++) series_extent(family->run[r], &low, &high);
  for (size_t k = 0; k < c->ref.data.n_experiments; k++)
    if (!strcmp(c->ref.data.file->experiments[k].target, probe->name))
      series_extent(&c->ref.data.experiments[k], &low, &high);
  double room = 0.08 * (high - low) + 1e-3;
  for (size_t panel = 0; panel < panels; panel++) {
    panel_place(fig, panel, panels);
    instants_mark(c, fig, panel);
    fprintf(fig->script, "set yrange [%.6g:%.6g]\nset ylabel 'p / (ρ g H)'\n", low - room,
            high + room);
    bool first = true, last = panel + 1 == panels; /* whose key names every curve */
    experiments_plot(c, fig, family, &first, last);
    if (panel < c->n_runs && family->run[panel]) {
      const char *name = last ? c->run[panel].data.label : NULL;
      curve_plot(fig, first, &(struct curve){panel, 4, name, cmp_colour(panel), 1, 0, 0});
      first = false;
    }
    reference_plot(c, fig, family, &first, last);
    for (size_t r = 0; r + 1 < c->n_runs && last; r++) {
      fprintf(fig->script, ", \\\n  keyentry with lines linewidth 1.2 linecolor '%s' title ",
              cmp_colour(r));
      cmp_gnuplot_string(fig->script, c->run[r].data.label);
    }
    end_plot(fig);
  }
  return chart_end(fig);
}

static enum status signal_charts(const struct comparison *c, struct cmp_figures *f) {
  const struct cmp_data *ref = &c->ref.data;
  for (size_t k = 0; k < ref->n_probes; k++) {
    struct family family = {
        .target = ref->probes[k].name, .column = "pressure [rho g H]", .label = "p / (ρ g H)"};
    enum status status = family_pick(c, pick_probe, ref->probes[k].name, &family);
    if (status == OK) status = probe_chart(c, f, &ref->probes[k], &family);
    free(family.run);
    TRY(status);
  }
  for (size_t k = 0; k < ref->n_gauges; k++) {
    char slug[40], file[64], caption[256];
    const struct cmp_series *g = &ref->gauges[k];
    cmp_slug(g->name, slug, sizeof slug);
    snprintf(file, sizeof file, "gauge-%s", slug);
    snprintf(caption, sizeof caption, "Height of the water standing at %.60s (x = %.4g H).",
             g->name, g->x);
    struct family family = {.target = g->name, .column = "elevation [H]", .label = "y / H"};
    enum status status = family_pick(c, pick_gauge, g->name, &family);
    if (status == OK) status = family_chart(c, f, CMP_SECTION_GAUGE, file, caption, "*:*", &family);
    free(family.run);
    TRY(status);
  }
  struct family family = {.target = "front", .column = "front [H]", .label = "x_{front} / H"};
  char caption[256];
  snprintf(
      caption, sizeof caption,
      "Position of the front, where the water standing on the bed is %.3g H deep (two particle "
      "spacings of the coarsest run).",
      c->depth);
  enum status status = family_pick(c, pick_own, "front", &family);
  if (status == OK && !family_empty(c, &family))
    status = family_chart(c, f, CMP_SECTION_FRONT, "front", caption, "*:*", &family);
  free(family.run);
  return status;
}

enum status cmp_charts_write(const struct comparison *c, struct cmp_figures *f) {
  if (c->n_runs) TRY(distance_chart(c, f));
  TRY(energy_charts(c, f));
  return signal_charts(c, f);
}

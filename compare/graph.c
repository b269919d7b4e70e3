#include "compare/graph.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "compare/chart.h"
#include "compare/panels.h"
#include "compare/text.h"

enum { TITLE_LINE = 56 }; /* bytes of a title that one column has room for */
enum { ALONE = 380, ONE_OF_TWO = 260, ONE_OF_MANY = 210 }; /* px, heights of a panel */
enum { LOWEST = 60, HIGHEST = 1200 };                          /* of one to scale */

struct graph {
  const struct cmp_graph *g;
  struct cmp_panels panels;
  bool first; /* the next curve opens a plot command */
};

/* ---- what is drawn ---- */

static bool is_drawn(const struct cmp_graph *g, size_t column, size_t panel) {
  const struct cmp_graph_column *c = &g->column[column];
  return column > 0 && !c->undrawn && (size_t)c->panel == panel;
}

static size_t panels_in(const struct cmp_graph *g) {
  size_t n = 1;
  for (size_t k = 1; k < g->n_columns; k++)
    if (!g->column[k].undrawn && (size_t)g->column[k].panel >= n)
      n = (size_t)g->column[k].panel + 1;
  return n;
}

static const struct cmp_graph_column *first_of(const struct cmp_graph *g, size_t panel) {
  size_t k = 1;
  while (!is_drawn(g, k, panel)) k++;
  return &g->column[k];
}

static bool has_company(const struct cmp_graph *g, size_t column) {
  for (size_t k = 1; k < g->n_columns; k++)
    if (k != column && is_drawn(g, k, (size_t)g->column[column].panel)) return true;
  return false;
}

/* A column has an entry in the key of its own when its panel has others, too. */
static bool is_keyed(const struct cmp_graph *g, size_t column) {
  const struct cmp_graph_column *c = &g->column[column];
  return column > 0 && !c->undrawn && (c->same || has_company(g, column));
}

/* The first column with this label: columns of several panels that are called alike look alike. */
static size_t namesake_of(const struct cmp_graph *g, size_t column) {
  for (size_t k = 1; k < column; k++)
    if (is_keyed(g, k) && !strcmp(g->column[k].label, g->column[column].label)) return k;
  return column;
}

static bool is_alike(const struct cmp_graph_column *a, const struct cmp_graph_column *b) {
  return a->points == b->points && a->same == b->same;
}

/* How many entries of the key come before this column's: of its own kind, or of any. 0 of one that
 * is alone in its panel. */
static size_t rank_of(const struct cmp_graph *g, size_t column, bool any) {
  size_t first = is_keyed(g, column) ? namesake_of(g, column) : 0, n = 0;
  for (size_t k = 1; k < first; k++)
    n += is_keyed(g, k) && namesake_of(g, k) == k &&
         (any || is_alike(&g->column[k], &g->column[first]));
  return n;
}

/* ---- ranges ---- */

struct range {
  double low, high;
};

static struct range range_of(const struct cmp_graph *g, size_t panel, bool log) {
  struct range r = {INFINITY, -INFINITY};
  for (size_t c = 0; c < g->n_curves; c++)
    for (size_t i = 0; i < g->curve[c].n; i++)
      for (size_t k = 1; k < g->n_columns; k++) {
        double value = g->curve[c].row[i * g->n_columns + k];
        if (!is_drawn(g, k, panel) || !isfinite(value) || (log && !(value > 0))) continue;
        r.low = fmin(r.low, value);
        r.high = fmax(r.high, value);
      }
  return r;
}

/* Puts the ends that a column asks for in the place of those of its curves. */
static void ends_take(const struct cmp_graph_column *c, double *low, double *high) {
  if (c->ends && isfinite(c->ends[0])) *low = c->ends[0];
  if (c->ends && isfinite(c->ends[1])) *high = c->ends[1];
}

static void log_range_write(const struct graph *d, const struct cmp_graph_column *c,
                            const struct range *r) {
  double low = r->low / 1.3, high = r->high * 1.3;
  ends_take(c, &low, &high);
  fprintf(d->panels.fig->script,
          "set logscale y\nset yrange [%.6g:%.6g]\nset ytics auto\nset format y '%s'\n", low, high,
          r->high / r->low > 1e4 || r->low < 1e-3 ? "10^{%L}" : "%g");
}

enum { ROOM_OF_COLUMN = 6 }; /* characters of a tick's label that are not in the axis label's way */

static size_t longest_tick(const struct cmp_frame *frame, double step) {
  size_t longest = 0;
  for (double k = ceil(frame->low / step); k * step <= frame->high; k++) {
    char text[32];
    const int n = snprintf(text, sizeof text, "%g", k * step);
    if (n > 0 && (size_t)n > longest) longest = (size_t)n;
  }
  return longest;
}

/* Of the values that a panel shows, whose first column is c. */
static struct range shown_of(const struct cmp_graph *g, const struct cmp_graph_column *c) {
  struct range r = range_of(g, (size_t)c->panel, c->log);
  if (!(r.low <= r.high)) r = (struct range){1, 10};
  if (c->span > 0 && r.low < r.high / c->span) r.low = r.high / c->span;
  if (c->top > 0 && r.low < c->top) r.high = fmin(r.high, c->top);
  ends_take(c, &r.low, &r.high);
  return r;
}

/* Of an axis that is not logarithmic. */
static struct cmp_frame frame_of(const struct cmp_graph_column *c, const struct range *r) {
  const double margin = fmax(0.06 * (r->high - r->low), 1e-9 * fmax(fabs(r->high), DBL_MIN));
  struct cmp_frame frame = {r->low - margin, r->high + margin};
  ends_take(c, &frame.low, &frame.high);
  return frame;
}

static void range_write(const struct graph *d, size_t panel) {
  const struct cmp_graph_column *c = first_of(d->g, panel);
  const struct range r = shown_of(d->g, c);
  FILE *s = d->panels.fig->script;
  if (c->log && r.low > 0 && r.high > 20 * r.low) { /* else it would have a tick or two */
    log_range_write(d, c, &r);
    return;
  }
  const struct cmp_frame frame = frame_of(c, &r);
  const double step = cmp_tick_step(&frame);
  fprintf(s,
          "ticks = %s\nunset logscale y\nset yrange [%.9g:%.9g]\nset ytics %.9g font ticks\n"
          "set format y '%%g'\n",
          longest_tick(&frame, step) > ROOM_OF_COLUMN ? "narrow ? small : ''" : "''", frame.low,
          frame.high, step);
}

static bool has_points(const struct cmp_graph *g) {
  for (size_t c = 0; c < g->n_curves; c++)
    if (g->curve[c].points) return true;
  for (size_t k = 1; k < g->n_columns; k++)
    if (g->column[k].points && !g->column[k].undrawn) return true;
  return false;
}

/* Of the axis that the panels share; low above high: there is nothing. */
static struct range axis_of(const struct cmp_graph *g) {
  const bool log = g->column[0].log;
  struct range r = {INFINITY, -INFINITY};
  for (size_t c = 0; c < g->n_curves; c++)
    for (size_t i = 0; i < g->curve[c].n; i++) {
      double x = g->curve[c].row[i * g->n_columns];
      if (log && !(x > 0)) continue;
      r.low = fmin(r.low, x);
      r.high = fmax(r.high, x);
    }
  const double margin = has_points(g) && !log ? 0.03 * (r.high - r.low) : 0;
  if (!log && r.low > 0 && r.low < 0.02 * r.high) r.low = 0;
  r = (struct range){r.low - margin, r.high + margin};
  ends_take(&g->column[0], &r.low, &r.high);
  return r;
}

static void axis_write(const struct graph *d) {
  const struct range r = axis_of(d->g);
  FILE *s = d->panels.fig->script;
  if (d->g->column[0].log) fputs("set logscale x\n", s);
  if (r.low < r.high) fprintf(s, "set xrange [%.9g:%.9g]\n", r.low, r.high);
}

/* ---- curves ---- */

static void open_curve(struct graph *d) {
  fputs(d->first ? "plot " : ", \\\n  ", d->panels.fig->script);
  d->first = false;
}

/* A curve alone has a colour for each column. */
static struct cmp_style style_of(const struct cmp_graph *g, size_t curve, size_t column) {
  size_t rank = rank_of(g, column, false);
  const struct cmp_style *own = g->curve[curve].style;
  if (g->n_curves == 1 && !own) return cmp_style_of(rank_of(g, column, true));
  struct cmp_style style = own ? *own : cmp_style_of(curve);
  if (g->column[column].same) style = (struct cmp_style){"#000000", 0};
  if (!g->column[column].points) style.dashes = (int)(((size_t)style.dashes + rank) % 4);
  return style;
}

#define SYMBOL 0.7 /* size of one, as gnuplot counts; half of it where there are many */
enum { MANY = 120 };

static void symbol_write(FILE *s, size_t rank, double size, const struct cmp_style *style) {
  static const int symbols[] = {7, 6, 5, 4, 9, 8}; /* discs, rings, squares, triangles */
  fprintf(s, " with points pointtype %d pointsize %g linewidth 1 linecolor '%s' ",
          symbols[rank % (sizeof symbols / sizeof *symbols)], size, style->colour);
}

static void look_write(FILE *s, const struct cmp_graph *g, size_t column,
                       const struct cmp_style *style) {
  if (g->column[column].points)
    symbol_write(s, rank_of(g, column, false), SYMBOL, style);
  else
    fprintf(s, " with lines linewidth 1.3 dashtype %s linecolor '%s' ", cmp_dashes(style),
            style->colour);
}

static void curve_draw(struct graph *d, size_t curve, size_t column) {
  const struct cmp_graph *g = d->g;
  struct cmp_style style = style_of(g, curve, column);
  open_curve(d);
  FILE *s = d->panels.fig->script;
  fprintf(s, "'%s.csv' skip 1 using ($1==%zu?$3:NaN):%zu", d->panels.fig->name, curve, column + 3);
  if (g->curve[curve].points)
    symbol_write(s, curve, g->curve[curve].n > MANY ? SYMBOL / 2 : SYMBOL, &style);
  else
    look_write(s, g, column, &style);
  fputs("notitle", s);
}

/* One curve alone says by its style whose it is. */
static bool has_names(const struct cmp_graph *g) {
  return g->n_curves > 1 || g->curve[0].style;
}

/* The key: the curves by their colours, then the columns of panels that have several. */
static void key_draw(struct graph *d) {
  const struct cmp_graph *g = d->g;
  FILE *s = d->panels.fig->script;
  for (size_t c = 0; has_names(g) && c < g->n_curves; c++) {
    struct cmp_style style = g->curve[c].style ? *g->curve[c].style : cmp_style_of(c);
    open_curve(d);
    fputs("keyentry", s);
    if (g->curve[c].points)
      symbol_write(s, c, SYMBOL, &style);
    else
      fprintf(s, " with lines linewidth 1.3 dashtype %s linecolor '%s' ", cmp_dashes(&style),
              style.colour);
    fputs("title ", s);
    cmp_key_string(s, g->curve[c].name, NULL);
  }
  for (size_t k = 1; k < g->n_columns; k++) {
    if (!is_keyed(g, k) || namesake_of(g, k) != k) continue;
    struct cmp_style style = style_of(g, 0, k);
    if (has_names(g)) style.colour = g->column[k].same ? "#000000" : "#555555";
    open_curve(d);
    fputs("keyentry", s);
    look_write(s, g, k, &style);
    fputs("title ", s);
    cmp_key_string(s, g->column[k].label, NULL);
    fputs(" enhanced", s);
  }
}

static struct cmp_key key_of(const struct cmp_graph *g) {
  size_t n = 0, longest = 0;
  for (size_t c = 0; has_names(g) && c < g->n_curves; c++, n++)
    if (cmp_key_length(g->curve[c].name) > longest) longest = cmp_key_length(g->curve[c].name);
  for (size_t k = 1; k < g->n_columns; k++) {
    if (!is_keyed(g, k) || namesake_of(g, k) != k) continue;
    n++;
    if (cmp_key_length(g->column[k].label) > longest) longest = cmp_key_length(g->column[k].label);
  }
  return cmp_key_of(n, longest);
}

/* Where a title is broken into two lines of one column; its length: it fits into one. */
static size_t break_of(const char *title) {
  const size_t n = strlen(title);
  size_t at = n;
  for (size_t k = 0; n > TITLE_LINE && k <= TITLE_LINE; k++)
    if (title[k] == ' ') at = k;
  return at;
}

static void title_write(const struct graph *d) {
  const char *title = d->g->title;
  const size_t at = title ? break_of(title) : 0;
  char first[TITLE_LINE + 1], second[TITLE_LINE + 1];
  FILE *s = d->panels.fig->script;
  if (!title) return;
  fputs("set label ", s);
  if (title[at]) {
    snprintf(first, sizeof first, "%.*s", (int)at, title);
    fputs("narrow ? ", s);
    cmp_gnuplot_string(s, first);
    fputs(".\"\\n\".", s);
    cmp_text_fit(title + at + 1, second, sizeof second); /* captions have it whole */
    cmp_gnuplot_string(s, second);
    fputs(" : ", s);
  }
  cmp_gnuplot_string(s, title);
  fprintf(s,
          " at graph 0, graph 1 offset 0, character (narrow ? %g : 0.8) left noenhanced font "
          "small\n",
          title[at] ? 1.5 : 0.8);
}

static void panel_draw(struct graph *d, size_t panel) {
  const struct cmp_graph *g = d->g;
  const struct cmp_graph_column *c = first_of(g, panel);
  FILE *s = d->panels.fig->script;
  cmp_panel_place(&d->panels, panel, g->column[0].label);
  fputs("unset label\nset format x '%g'\n", s);
  if (panel + 1 < d->panels.n) fputs("set format x ''\n", s);
  if (!panel) title_write(d);
  cmp_panel_labels(&d->panels, c->axis ? c->axis : c->label, NULL);
  range_write(d, panel);
  d->first = true;
  if (c->level) {
    open_curve(d);
    fprintf(s, "%s with lines linewidth 0.8 dashtype 2 linecolor '#777777' notitle", c->level);
  }
  for (size_t curve = 0; curve < g->n_curves; curve++)
    for (size_t k = 1; k < g->n_columns; k++)
      if (is_drawn(g, k, panel) && (!curve || !g->column[k].same)) curve_draw(d, curve, k);
  if (panel + 1 == d->panels.n) key_draw(d);
  fputc('\n', s);
}

static enum status table_write(const struct cmp_graph *g, struct cmp_figures *f,
                               const struct cmp_figure *fig) {
  FILE *table;
  TRY(cmp_figure_data(f, fig, ".csv", &table));
  fputs("curve,name", table);
  for (size_t k = 0; k < g->n_columns; k++) fprintf(table, ",%s", g->column[k].head);
  fputc('\n', table);
  for (size_t c = 0; c < g->n_curves; c++)
    for (size_t i = 0; i < g->curve[c].n; i++) {
      fprintf(table, "%zu,", c);
      cmp_csv_string(table, g->curve[c].name);
      for (size_t k = 0; k < g->n_columns; k++) {
        double value = g->curve[c].row[i * g->n_columns + k];
        if (isfinite(value))
          fprintf(table, ",%.10g", value);
        else
          fputs(",NaN", table);
      }
      fputc('\n', table);
    }
  return cmp_figure_data_end(fig, table);
}

/* px of a panel, which has x and y to one scale. */
static int equal_height(const struct cmp_graph *g) {
  const struct cmp_graph_column *c = first_of(g, 0);
  const struct range x = axis_of(g), shown = shown_of(g, c);
  const struct cmp_frame y = frame_of(c, &shown);
  const double height = cmp_panels_width(g->narrow) * (y.high - y.low) / (x.high - x.low);
  return (int)lround(fmin(fmax(height, LOWEST), HIGHEST)); /* NaN: there is nothing to draw */
}

enum status cmp_graph_write(const struct cmp_graph *g, struct cmp_figures *f) {
  struct graph d = {.g = g, .panels = {.n = panels_in(g)}};
  size_t n = d.panels.n;
  int height[2];
  d.panels.key = key_of(g);
  cmp_panels_heights(n,
                     g->equal ? equal_height(g)
                     : n == 1 ? ALONE
                     : n == 2 ? ONE_OF_TWO
                              : ONE_OF_MANY,
                     &d.panels.key, height);
  const int width = g->narrow ? CMP_PANELS_NARROW : CMP_PANELS_WIDTH;
  TRY(cmp_figure_begin(f, g->section, g->raster, width, height[g->narrow], &d.panels.fig, "%s",
                       g->name));
  if (!g->narrow && !g->equal) d.panels.fig->column_height = height[1];
  if (g->caption) snprintf(d.panels.fig->caption, sizeof d.panels.fig->caption, "%s", g->caption);
  TRY(table_write(g, f, d.panels.fig));
  cmp_figure_formats(d.panels.fig);
  fputs("set multiplot\n", d.panels.fig->script);
  axis_write(&d);
  for (size_t k = 0; k < n; k++) panel_draw(&d, k);
  fputs("unset multiplot\n", d.panels.fig->script);
  return cmp_figure_end(d.panels.fig);
}

#include "compare/convergence/grid.h"

#include <math.h>
#include <string.h>

#include "compare/chart.h"
#include "compare/panels.h"
#include "compare/text.h"

/* px */
enum { LEFT = 78, RIGHT = 22, TOP = 34, GAP_X = 92, GAP_Y = 84, PANEL = 216 };
enum { MOST_ENDS = 6 }; /* curves whose ends carry their order */

/* Errors below the largest of a panel by more than this are rounding: they would flatten the rest.
 */
#define DECADES 1e8

static const int symbols[CMP_GRID_SYMBOLS] = {7, 6, 5, 4, 9, 8}; /* discs, rings, squares, ... */

struct range {
  double low, high;
};

static void range_take(struct range *r, double v) {
  r->low = fmin(r->low, v);
  r->high = fmax(r->high, v);
}

static void ranges_of(const struct cmp_grid_panel *p, struct range *x, struct range *y) {
  *x = *y = (struct range){INFINITY, 0};
  for (size_t k = 0; k < p->n; k++)
    for (size_t i = 0; i < p->curve[k].n; i++) {
      range_take(x, p->curve[k].x[i]);
      range_take(y, p->curve[k].y[i]);
    }
  y->low = fmax(y->low, y->high / DECADES);
}

/* Ticks at few or many multiples of powers of ten, by how many decades there are, else at powers.
 */
static void axis_write(FILE *s, char axis, struct range r, double margin) {
  const double low = r.low / margin, high = r.high * margin;
  fprintf(s, "set %crange [%.6g:%.6g]\nunset m%ctics\n", axis, low, high, axis);
  if (high / low > 200) {
    fprintf(s, "set %ctics autofreq\nset format %c '10^{%%L}'\n", axis, axis);
    return;
  }
  static const double few[] = {1, 2, 5}, many[] = {1, 1.5, 2, 3, 4, 5, 7};
  const bool wide = high / low > 8;
  fprintf(s, "set format %c '%%g'\nset %ctics (", axis, axis);
  const char *lead = "";
  for (int power = (int)floor(log10(low)); power <= (int)floor(log10(high)); power++)
    for (int k = 0; k < (wide ? 3 : 7); k++) {
      const double tick = (wide ? few : many)[k] * pow(10, power);
      if (tick < low || tick > high) continue;
      fprintf(s, "%s%.3g", lead, tick);
      lead = ", ";
    }
  fputs(")\n", s);
}

static void place(const struct cmp_figure *fig, size_t k) {
  const double width = (CMP_PANELS_WIDTH - LEFT - RIGHT - GAP_X) / 2.0, other = width + GAP_X;
  const double top = TOP + (double)(k / 2) * (PANEL + GAP_Y);
  cmp_figure_margins(
      fig,
      &(struct cmp_margins){LEFT + (k % 2 ? other : 0), RIGHT + (k % 2 ? 0 : other), top, PANEL},
      NULL);
}

/* From the largest error at the largest spacing down, for two orders. */
static void slopes_write(FILE *s, const struct range *x, const struct range *y) {
  for (int p = 1; p <= 2; p++) {
    const double low = fmax(x->low, x->high * pow(y->low / y->high, 1.0 / p));
    fprintf(s,
            "set arrow from %.6g, %.6g to %.6g, %.6g nohead back linecolor '#aaaaaa' linewidth 0.8 "
            "dashtype %d\n",
            x->high, y->high, low, y->high * pow(low / x->high, p), p == 1 ? 2 : 3);
    const double middle = sqrt(low * x->high); /* the ends have other numbers */
    fprintf(s,
            "set label '%d' at %.6g, %.6g offset 0, character -0.6 center font small textcolor "
            "'#888888'\n",
            p, middle, y->high * pow(middle / x->high, p));
  }
}

static void ends_write(FILE *s, const struct cmp_grid_panel *p, const struct range *y) {
  for (size_t k = 0; p->n <= MOST_ENDS && k < p->n; k++) {
    const struct cmp_grid_curve *c = &p->curve[k];
    if (!isfinite(c->slope) || c->y[c->n - 1] < y->low) continue;
    fprintf(s,
            "set label '%.2f' at %.6g, %.6g offset character -0.5, 0 right front font small "
            "textcolor '%s'\n",
            c->slope, c->x[c->n - 1], c->y[c->n - 1], c->style.colour);
  }
}

static void look_write(FILE *s, const struct cmp_style *style, int symbol) {
  fprintf(s,
          " with linespoints linewidth 1.2 dashtype %s pointtype %d pointsize 0.6 linecolor '%s' ",
          cmp_dashes(style), symbols[symbol % CMP_GRID_SYMBOLS], style->colour);
}

/* ---- the key ---- */

struct key {
  size_t n;
  const struct cmp_grid_curve *curve[CMP_NAMED];
};

static void key_make(const struct cmp_grid *g, struct key *key) {
  *key = (struct key){0};
  for (size_t i = 0; i < g->n; i++)
    for (size_t j = 0; j < g->panel[i].n; j++) {
      const struct cmp_grid_curve *c = &g->panel[i].curve[j];
      size_t k = 0;
      while (k < key->n && strcmp(key->curve[k]->name, c->name)) k++;
      if (k == key->n && k < CMP_NAMED) key->curve[key->n++] = c;
    }
}

static size_t key_longest(const struct cmp_grid *g, const struct key *key) {
  size_t longest = 0;
  for (size_t k = 0; k < key->n + g->n_symbols; k++) {
    const size_t n = cmp_key_length(k < key->n ? key->curve[k]->name : g->symbol[k - key->n]);
    if (n > longest) longest = n;
  }
  return longest;
}

static void key_write(FILE *s, const struct cmp_grid *g, const struct key *key) {
  for (size_t k = 0; k < key->n; k++) {
    fprintf(s, ", \\\n  keyentry with lines linewidth 1.6 dashtype %s linecolor '%s' title ",
            cmp_dashes(&key->curve[k]->style), key->curve[k]->style.colour);
    cmp_key_string(s, key->curve[k]->name, NULL);
  }
  for (size_t k = 0; k < g->n_symbols; k++) {
    fprintf(s, ", \\\n  keyentry with points pointtype %d pointsize 0.7 linecolor '#444444' title ",
            symbols[k % CMP_GRID_SYMBOLS]);
    cmp_key_string(s, g->symbol[k], NULL);
  }
}

/* ---- the page ---- */

static enum status table_write(const struct cmp_grid *g, struct cmp_figures *f,
                               const struct cmp_figure *fig) {
  FILE *t;
  TRY(cmp_figure_data(f, fig, ".csv", &t));
  fputs("panel,curve,x,y,what,name\n", t);
  for (size_t i = 0; i < g->n; i++)
    for (size_t j = 0; j < g->panel[i].n; j++) {
      const struct cmp_grid_curve *c = &g->panel[i].curve[j];
      for (size_t k = 0; k < c->n; k++) {
        fprintf(t, "%zu,%zu,%.10g,%.10g,", i, j, c->x[k], c->y[k]);
        cmp_csv_string(t, g->panel[i].title);
        fputc(',', t);
        cmp_csv_string(t, c->name);
        fputc('\n', t);
      }
    }
  return cmp_figure_data_end(fig, t);
}

static void panel_write(const struct cmp_grid *g, const struct cmp_figure *fig, size_t k,
                        const struct key *key) {
  const struct cmp_grid_panel *p = &g->panel[k];
  struct range x, y;
  FILE *s = fig->script;
  ranges_of(p, &x, &y);
  place(fig, k);
  fputs("unset arrow\nunset label\nset label ", s);
  cmp_gnuplot_string(s, p->title);
  fputs(" at graph 0, graph 1 offset 0, character 0.6 left noenhanced font small\n", s);
  fprintf(s,
          "set xlabel '%s' offset 0, character 0.5 font small\nset ylabel '%s' offset character "
          "0.8, 0 font small\n",
          p->x, p->y);
  axis_write(s, 'x', x, p->slopes ? 1.3 : 1.18);
  axis_write(s, 'y', y, 1.6);
  if (p->slopes) slopes_write(s, &x, &y);
  ends_write(s, p, &y);
  for (size_t j = 0; j < p->n; j++) {
    fprintf(s, "%s'%s.csv' skip 1 using ($1==%zu && $2==%zu ? $3 : NaN):4",
            j ? ", \\\n  " : "plot ", fig->name, k, j);
    look_write(s, &p->curve[j].style, p->curve[j].symbol);
    fputs("notitle", s);
  }
  if (k + 1 == g->n) key_write(s, g, key);
  fputc('\n', s);
}

enum status cmp_grid_write(const struct cmp_grid *g, struct cmp_figures *f) {
  struct cmp_figure *fig;
  struct key key;
  key_make(g, &key);
  const struct cmp_key place_of_key = cmp_key_of(key.n + g->n_symbols, key_longest(g, &key));
  const int rows = (int)(g->n + 1) / 2;
  TRY(cmp_figure_begin(f, g->section, false, CMP_PANELS_WIDTH,
                       TOP + rows * PANEL + (rows - 1) * GAP_Y + place_of_key.height[0], &fig, "%s",
                       g->name));
  snprintf(fig->caption, sizeof fig->caption, "%s", g->caption);
  TRY(table_write(g, f, fig));
  cmp_figure_formats(fig);
  fprintf(fig->script, "set multiplot\nset logscale xy\nset tics font small\nunset key\n");
  for (size_t k = 0; k < g->n; k++) {
    if (k + 1 == g->n) cmp_key_place(fig, &place_of_key);
    panel_write(g, fig, k, &key);
  }
  fputs("unset multiplot\n", fig->script);
  return cmp_figure_end(fig);
}

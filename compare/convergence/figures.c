#include "compare/convergence/figures.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/convergence/grid.h"

enum axis { SPACING, SECONDS, EVALUATIONS };
enum { MOST_GROUPS = 14, MOST_TIMES = CMP_GRID_SYMBOLS };

static const char *const axis_labels[] = {"spacing / H", "wall time / s", "evaluations"};

/* Panels of a page while they are filled, and what they point to. */
struct page {
  const struct comparison *c;
  const struct cmp_convergence *v;
  struct cmp_grid_panel panel[CMP_GRID_PANELS];
  struct cmp_grid_curve *curve; /* of all panels, [CMP_GRID_PANELS * most] */
  double *number;               /* all their x and y */
  char (*label)[64];            /* axes of the panels */
  size_t n, most, n_numbers;
  size_t pages;
};

static double x_of(const struct page *p, const struct cmp_group *g, size_t i, enum axis axis) {
  return axis == SPACING   ? g->spacing[i]
         : axis == SECONDS ? cmp_member_seconds(p->c, g->member[i])
                           : cmp_member_evaluations(p->c, g->member[i]);
}

/* The same row of another group; NULL: it has none. */
static const struct cmp_row_of_group *row_find(const struct cmp_group *g,
                                               const struct cmp_row_of_group *of) {
  for (size_t k = 0; k < g->n_rows; k++) {
    const struct cmp_row_of_group *row = &g->row[k];
    if (!strcmp(row->name, of->name) && row->time == of->time &&
        (row->of == of->of || (row->of && of->of && !strcmp(row->of, of->of))))
      return row;
  }
  return NULL;
}

/* Errors that are there and not 0, over the axis: at least two make a curve. */
static bool curve_take(struct page *p, const struct cmp_group *g,
                       const struct cmp_row_of_group *row, enum axis axis,
                       struct cmp_grid_curve *curve) {
  double *x = p->number + p->n_numbers, *y = x + g->n, last[2] = {NAN, NAN}, error[2] = {NAN, NAN};
  size_t n = 0;
  for (size_t i = 0; i < g->n; i++) {
    const double at = x_of(p, g, i, axis);
    if (!(row->error[i] > 0) || !isfinite(row->error[i]) || !(at > 0)) continue;
    last[0] = last[1];
    error[0] = error[1];
    last[1] = x[n] = at;
    error[1] = y[n++] = row->error[i];
  }
  if (n < 2) return false;
  p->n_numbers += 2 * g->n;
  const size_t place = (size_t)(g - p->v->group);
  *curve = (struct cmp_grid_curve){.name = g->name,
                                   .style = cmp_style_of(place),
                                   .n = n,
                                   .x = x,
                                   .y = y,
                                   .slope = axis == SPACING ? cmp_error_order(last, error) : NAN};
  return true;
}

static size_t groups_shown(const struct page *p) {
  return p->v->n < MOST_GROUPS ? p->v->n : MOST_GROUPS;
}

/* A panel of this number for every group, at every time that it has; false when it is empty. */
static bool panel_take(struct page *p, const struct cmp_row_of_group *of, enum axis axis,
                       bool all_times) {
  struct cmp_grid_panel *panel = &p->panel[p->n];
  const size_t times = of->time == SIZE_MAX ? 1 : p->c->n_times;
  *panel = (struct cmp_grid_panel){.curve = p->curve + p->n * p->most,
                                   .x = axis_labels[axis],
                                   .y = p->label[p->n],
                                   .slopes = axis == SPACING};
  for (size_t t = 0; t < times && t < MOST_TIMES; t++)
    for (size_t k = 0; k < groups_shown(p); k++) {
      struct cmp_row_of_group wanted = *of;
      if (of->time != SIZE_MAX && all_times) wanted.time = t;
      if (!all_times && t) break;
      const struct cmp_row_of_group *row = row_find(&p->v->group[k], &wanted);
      struct cmp_grid_curve *curve = &panel->curve[panel->n];
      if (!row || !curve_take(p, &p->v->group[k], row, axis, curve)) continue;
      curve->symbol = of->time == SIZE_MAX || !all_times ? 0 : (int)t;
      panel->n++;
    }
  if (!panel->n) return false;
  snprintf(p->label[p->n], sizeof *p->label, strchr(of->units, ' ') ? "error / (%s)" : "error / %s",
           of->units);
  if (!strcmp(of->units, "1")) snprintf(p->label[p->n], sizeof *p->label, "error");
  snprintf(panel->title, sizeof panel->title, "%s%s%.40s", of->name, of->of ? " of " : "",
           of->of ? of->of : "");
  for (char *c = panel->title; *c; c++)
    if (*c == '_') *c = ' ';
  if (!all_times && of->time != SIZE_MAX) {
    const size_t n = strlen(panel->title);
    snprintf(panel->title + n, sizeof panel->title - n, " at t* = %.3g", p->c->times[of->time]);
  }
  p->n++;
  return true;
}

static enum status page_write(struct page *p, struct cmp_figures *f, const char *name,
                              const char *caption, bool timed) {
  char times[MOST_TIMES][32], file[64];
  const char *symbol[MOST_TIMES];
  const size_t n = p->c->n_times < MOST_TIMES ? p->c->n_times : MOST_TIMES;
  for (size_t t = 0; t < n; t++) {
    snprintf(times[t], sizeof times[t], "t* = %.4g", p->c->times[t]);
    symbol[t] = times[t];
  }
  snprintf(file, sizeof file, p->pages ? "%s-%zu" : "%s", name, p->pages + 1);
  const struct cmp_grid grid = {.name = file,
                                .caption = caption,
                                .section = CMP_SECTION_CONVERGENCE,
                                .n = p->n,
                                .panel = p->panel,
                                .n_symbols = timed ? n : 0,
                                .symbol = symbol};
  p->pages++;
  const enum status status = p->n ? cmp_grid_write(&grid, f) : OK;
  p->n = p->n_numbers = 0;
  return status;
}

/* ---- errors over the spacing ---- */

/* Whether no group before has this number at any time: each is drawn once. */
static bool is_first(const struct page *p, size_t group, size_t row) {
  const struct cmp_row_of_group *of = &p->v->group[group].row[row];
  for (size_t i = 0; i <= group; i++) {
    const struct cmp_group *g = &p->v->group[i];
    for (size_t k = 0; k < (i < group ? g->n_rows : row); k++)
      if (!strcmp(g->row[k].name, of->name) &&
          (g->row[k].of == of->of || (g->row[k].of && of->of && !strcmp(g->row[k].of, of->of))))
        return false;
  }
  return true;
}

static bool same_errors(const struct cmp_group *g, const struct cmp_row_of_group *a,
                        const struct cmp_row_of_group *b) {
  for (size_t i = 0; i < g->n; i++)
    if (!(fabs(a->error[i] - b->error[i]) <= 1e-9 * fabs(b->error[i])) &&
        (isfinite(a->error[i]) || isfinite(b->error[i])))
      return false;
  return true;
}

/* Whether a measure before it is that number's own error, as that of an energy is. */
static bool is_echo(const struct cmp_group *g, size_t row) {
  const struct cmp_row_of_group *own = &g->row[row];
  for (size_t k = 0; k < row; k++)
    if (g->row[k].is_difference && g->row[k].section == own->section &&
        g->row[k].time == own->time && same_errors(g, &g->row[k], own))
      return true;
  return false;
}

static enum status section_draw(struct page *p, enum cmp_section section, const char *name,
                                struct cmp_figures *f) {
  static const char caption[] =
      "Errors against the reference over the spacing. Grey: first (dashed) and second order "
      "(dotted); "
      "numbers: the order between the finest two, where there are few curves.";
  bool timed = false;
  p->pages = 0;
  for (size_t i = 0; i < groups_shown(p); i++)
    for (size_t k = 0; k < p->v->group[i].n_rows; k++) {
      const struct cmp_row_of_group *row = &p->v->group[i].row[k];
      if (row->section != section || !is_first(p, i, k) || is_echo(&p->v->group[i], k)) continue;
      if (panel_take(p, row, SPACING, true) && row->time != SIZE_MAX) timed = true;
      if (p->n == CMP_GRID_PANELS) TRY(page_write(p, f, name, caption, timed));
    }
  return p->n ? page_write(p, f, name, caption, timed) : OK;
}

/* ---- errors over cost ---- */

/* A number of each kind: what a scheme is chosen by. */
static enum status cost_draw(struct page *p, struct cmp_figures *f) {
  static const char *const chosen[] = {"mean_distance", "mechanical", "jet_tip", "peak_pressure"};
  p->pages = 0;
  for (size_t i = 0; i < sizeof chosen / sizeof *chosen; i++) {
    const struct cmp_row_of_group *last = NULL;
    for (size_t k = 0; k < groups_shown(p); k++)
      for (size_t r = 0; r < p->v->group[k].n_rows; r++) {
        const struct cmp_row_of_group *row = &p->v->group[k].row[r];
        if (strcmp(row->name, chosen[i]) != 0) continue;
        const bool other = last && row->of && last->of && strcmp(row->of, last->of);
        if (!last || (!other && row->time != SIZE_MAX && row->time > last->time)) last = row;
      }
    if (!last) continue;
    panel_take(p, last, SECONDS, false);
    panel_take(p, last, EVALUATIONS, false);
  }
  return page_write(
      p, f, "convergence-cost",
      "Errors against the reference over what the runs have cost: seconds of the clock, "
      "and evaluations of the right-hand side. Lower and further left is better.",
      false);
}

/* ---- all ---- */

enum status cmp_convergence_draw(const struct comparison *c, const struct cmp_convergence *v,
                                 struct cmp_figures *f) {
  static const struct {
    enum cmp_section section;
    const char *name;
  } pages[] = {
      {CMP_SECTION_DISTANCE, "convergence-distance"}, {CMP_SECTION_FRONT, "convergence-front"},
      {CMP_SECTION_JET, "convergence-jet"},           {CMP_SECTION_ENERGY, "convergence-energy"},
      {CMP_SECTION_PRESSURE, "convergence-pressure"}, {CMP_SECTION_GAUGE, "convergence-levels"},
      {CMP_SECTION_CHECKS, "convergence-signals"}};
  struct page p = {.c = c, .v = v, .most = MOST_GROUPS * MOST_TIMES};
  enum status status = OK;
  size_t longest = 1;
  if (!v->n) return OK;
  for (size_t i = 0; i < v->n; i++)
    if (v->group[i].n > longest) longest = v->group[i].n;
  ATTEMPT(array_create(&p.curve, CMP_GRID_PANELS * p.most, "curves"));
  ATTEMPT(array_create(&p.label, CMP_GRID_PANELS, "labels"));
  ATTEMPT(array_create(&p.number, 2 * longest * CMP_GRID_PANELS * p.most, "points of curves"));
  for (size_t k = 0; k < sizeof pages / sizeof *pages; k++)
    ATTEMPT(section_draw(&p, pages[k].section, pages[k].name, f));
  ATTEMPT(cost_draw(&p, f));
done:
  free(p.curve);
  free(p.label);
  free(p.number);
  return status;
}

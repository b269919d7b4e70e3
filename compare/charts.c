#include "compare/charts.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text.h"

/* ---- distance ---- */

/* Of a panel of distances: gnuplot finds no range where there is no number. */
static const char *distance_range(const struct comparison *c, size_t panel) {
  for (size_t r = 0; r < c->n_runs; r++) {
    const struct cmp_evolution *e = &c->run[r].evolution;
    const double *value = panel == 0 ? e->mean : panel == 1 ? e->largest : e->area;
    for (size_t i = 0; i < e->n; i++)
      if (isfinite(value[i])) return "0:*";
  }
  return "0:1";
}

static bool distance_known(const struct comparison *c) {
  for (size_t r = 0; r < c->n_runs; r++)
    if (c->run[r].evolution.n) return true;
  return false;
}

static enum status distance_chart(const struct comparison *c, struct cmp_figures *f) {
  struct cmp_chart chart;
  TRY(cmp_chart_begin(c, f, CMP_SECTION_DISTANCE, 3, 190, NULL, 0,
                      "mean_distance [H],largest_distance [H],area [H^2]", "distance", &chart));
  snprintf(
      chart.fig->caption, sizeof chart.fig->caption,
      "Distance of each run's free surface from that of %.60s at every common output: mean and "
      "largest distance of the main surfaces away from walls, and the area between the two. "
      "Dashed: the noise floor of the mean distance, half a particle spacing.",
      c->ref.data.label);
  for (size_t r = 0; r < c->n_runs; r++) {
    const struct cmp_evolution *e = &c->run[r].evolution;
    for (size_t i = 0; i < e->n; i++)
      cmp_chart_row(&chart, r, c->run[r].data.label, e->t[i],
                    (double[]){e->mean[i], e->largest[i], e->area[i]}, 3);
  }
  static const char *const label[] = {"mean distance / H", "largest distance / H", "area / H^2"};
  for (size_t panel = 0; panel < 3; panel++) {
    cmp_chart_panel(&chart, panel, distance_range(c, panel), label[panel]);
    for (size_t r = 0; r < c->n_runs; r++)
      cmp_chart_curve(
          &chart, &(struct cmp_curve){r, panel, c->run[r].data.label, cmp_colour(r), 1.3, 0, 0});
    for (size_t r = 0; r < c->n_runs && panel == 0; r++)
      if (r == 0 || fabs(c->run[r].noise - c->run[r - 1].noise) > 1e-12)
        cmp_chart_level(&chart, c->run[r].noise);
    cmp_chart_panel_end(&chart);
  }
  return cmp_chart_end(&chart);
}

/* ---- the same series of every run, of the reference and of experiments ---- */

struct family {
  const struct cmp_series **run; /* [n_runs + 1]: the reference last; NULL: it has none */
  const char *target;            /* of experiments; NULL: none are drawn */
  const char *column, *label;    /* of the table, of the axis */
  double end;                    /* of the time axis; 0: the end of the runs */
};

typedef const struct cmp_series *series_pick(const struct cmp_data *d, const char *name);

static const struct cmp_series *pick_probe(const struct cmp_data *d, const char *name) {
  return cmp_series_find(d->probes, d->n_probes, name);
}

static const struct cmp_series *pick_gauge(const struct cmp_data *d, const char *name) {
  return cmp_series_find(d->gauges, d->n_gauges, name);
}

static const struct cmp_series *pick_own(const struct cmp_data *d, const char *name) {
  const struct cmp_series *own[] = {&d->kinetic, &d->potential, &d->mechanical, &d->closure,
                                    &d->front};
  for (size_t k = 0; k < sizeof own / sizeof *own; k++)
    if (!strcmp(own[k]->name, name)) return own[k]->n ? own[k] : NULL;
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

static bool family_empty(const struct comparison *c, const struct family *family) {
  for (size_t r = 0; r <= c->n_runs; r++)
    if (family->run[r] && family->run[r]->n) return false;
  return true;
}

static bool family_shows(const struct comparison *c, const struct family *family, size_t k) {
  return family->target && !strcmp(c->ref.data.file->experiments[k].target, family->target);
}

static void series_rows(struct cmp_chart *chart, size_t id, const char *name,
                        const struct cmp_series *s) {
  for (size_t i = 0; i < s->n; i++) cmp_chart_row(chart, id, name, s->t[i], &s->value[i], 1);
}

static void family_rows(struct cmp_chart *chart, const struct family *family) {
  const struct comparison *c = chart->c;
  for (size_t r = 0; r <= c->n_runs; r++)
    if (family->run[r])
      series_rows(chart, r, cmp_run_or_ref(c, r < c->n_runs ? r : SIZE_MAX)->data.label,
                  family->run[r]);
  for (size_t k = 0; k < c->ref.data.n_experiments; k++)
    if (family_shows(c, family, k))
      series_rows(chart, c->n_runs + 1 + k, c->ref.data.experiments[k].name,
                  &c->ref.data.experiments[k]);
}

/* ---- the range of the axis ---- */

struct extent {
  double low, high;
};

static int ascending(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Of all but the most extreme rows, one in two hundred at each end. */
static bool series_extent(const struct cmp_series *s, double end, struct extent *e) {
  double *v = s ? malloc((s->n + 1) * sizeof *v) : NULL;
  size_t n = 0;
  for (size_t i = 0; v && i < s->n; i++)
    if (isfinite(s->value[i]) && s->t[i] <= end) v[n++] = s->value[i];
  if (n) {
    qsort(v, n, sizeof *v, ascending);
    *e = (struct extent){v[n / 200], v[n - 1 - n / 200]};
  }
  free(v);
  return n > 0;
}

/* The union of the extents, except those that span more than four times the median span: a run that
 * has blown up leaves the picture and not the others flat. */
static struct extent family_extent(const struct cmp_chart *chart, const struct family *family) {
  const struct comparison *c = chart->c;
  size_t room = c->n_runs + 1 + c->ref.data.n_experiments, n = 0;
  struct extent all = {INFINITY, -INFINITY}, *e = calloc(room, sizeof *e);
  double *span = calloc(room, sizeof *span);
  for (size_t k = 0; e && span && k < room; k++) {
    const struct cmp_series *s = k <= c->n_runs ? family->run[k]
                                 : family_shows(c, family, k - c->n_runs - 1)
                                     ? &c->ref.data.experiments[k - c->n_runs - 1]
                                     : NULL;
    if (!series_extent(s, chart->end, &e[n])) continue;
    span[n] = e[n].high - e[n].low;
    n++;
  }
  if (n) qsort(span, n, sizeof *span, ascending);
  for (size_t k = 0; k < n; k++) {
    if (e[k].high - e[k].low > fmax(4 * span[n / 2], 0.02)) continue;
    all.low = fmin(all.low, e[k].low);
    all.high = fmax(all.high, e[k].high);
  }
  free(e);
  free(span);
  if (!(all.low <= all.high)) return (struct extent){0, 1};
  double size = fmax(fabs(all.low), fabs(all.high));
  double margin = fmax(0.06 * (all.high - all.low), size > 0 ? 1e-6 * size : 1e-6);
  return (struct extent){all.low - margin, all.high + margin};
}

static void panel_begin(struct cmp_chart *chart, const struct family *family, size_t k) {
  char range[64];
  struct extent e = family_extent(chart, family);
  snprintf(range, sizeof range, "%.12g:%.12g", e.low, e.high);
  cmp_chart_panel(chart, k, range, family->label);
}

/* ---- drawing a family ---- */

static void experiments_draw(struct cmp_chart *chart, const struct family *family, bool named) {
  static const int symbols[] = {4, 6, 8, 12, 2};
  const struct comparison *c = chart->c;
  size_t shown = 0;
  for (size_t k = 0; k < c->ref.data.n_experiments; k++) {
    if (!family_shows(c, family, k)) continue;
    const char *name = named ? c->ref.data.experiments[k].name : NULL;
    size_t every = c->ref.data.experiments[k].n / 80 + 1; /* symbols, not a smear */
    cmp_chart_curve(chart, &(struct cmp_curve){c->n_runs + 1 + k, 0, name,
                                               shown % 2 ? "#a08050" : "#707070", 1,
                                               symbols[shown % 5], every});
    shown++;
  }
}

static void run_draw(struct cmp_chart *chart, const struct family *family, size_t r, bool named) {
  if (!family->run[r]) return;
  bool reference = r == chart->c->n_runs;
  size_t id = reference ? SIZE_MAX : r;
  const char *name = named ? cmp_run_or_ref(chart->c, id)->data.label : NULL;
  cmp_chart_curve(chart, &(struct cmp_curve){r, 0, name, cmp_colour(id), 1.1, 0, 0});
}

static enum status family_chart(const struct comparison *c, struct cmp_figures *f,
                                enum cmp_section section, const char *file, const char *caption,
                                const struct family *family) {
  struct cmp_chart chart;
  TRY(cmp_chart_begin(c, f, section, 1, 280, family->target, family->end, family->column, file,
                      &chart));
  snprintf(chart.fig->caption, sizeof chart.fig->caption, "%s", caption);
  family_rows(&chart, family);
  panel_begin(&chart, family, 0);
  experiments_draw(&chart, family, true);
  for (size_t r = 0; r <= c->n_runs; r++) run_draw(&chart, family, r, true);
  cmp_chart_panel_end(&chart);
  return cmp_chart_end(&chart);
}

static enum status picked_chart(const struct comparison *c, struct cmp_figures *f,
                                enum cmp_section section, const char *file, const char *caption,
                                series_pick *pick, const char *name, struct family family) {
  enum status status = family_pick(c, pick, name, &family);
  if (status == OK && !family_empty(c, &family))
    status = family_chart(c, f, section, file, caption, &family);
  free(family.run);
  return status;
}

static enum status energy_charts(const struct comparison *c, struct cmp_figures *f) {
  static const struct {
    const char *name, *file, *label, *caption;
  } charts[] = {
      {"mechanical", "energy", "(E_k + E_p − E_{rest}) / E_0",
       "Mechanical energy (kinetic + potential, relative to the same water at rest) over "
       "its initial value in the reference: what is lost shows as decay."},
      {"kinetic", "energy-kinetic", "E_k / E_0", "Kinetic energy."},
      {"potential", "energy-potential", "(E_p − E_{rest}) / E_0",
       "Potential energy relative to the same water at rest."},
      {"closure", "energy-budget", "budget error / E_0",
       "Closure of each energy budget: kinetic + potential + elastic + everything "
       "dissipated or taken out, minus its value at t = 0. It is zero where every loss is "
       "accounted for."}};
  for (size_t k = 0; k < sizeof charts / sizeof *charts; k++) {
    char column[64];
    snprintf(column, sizeof column, "%s [E0]", charts[k].name);
    struct family family = {.column = column, .label = charts[k].label};
    TRY(picked_chart(c, f, CMP_SECTION_ENERGY, charts[k].file, charts[k].caption, pick_own,
                     charts[k].name, family));
  }
  return OK;
}

/* A panel for every run: one full of noise would hide the others. */
static enum status probe_chart(const struct comparison *c, struct cmp_figures *f,
                               const struct cmp_series *probe, const struct family *family) {
  struct cmp_chart chart;
  char slug[40], file[64];
  cmp_slug(probe->name, slug, sizeof slug);
  snprintf(file, sizeof file, "pressure-%s", slug);
  size_t panels = c->n_runs ? c->n_runs : 1;
  TRY(cmp_chart_begin(c, f, CMP_SECTION_PRESSURE, panels, panels == 1 ? 280 : 175, family->target,
                      0, family->column, file, &chart));
  snprintf(chart.fig->caption, sizeof chart.fig->caption,
           "Pressure at %.60s (x = %.4g H, y = %.4g H): each run, the reference %.60s in black, "
           "experiments as symbols.",
           probe->name, probe->x, probe->y, c->ref.data.label);
  family_rows(&chart, family);
  for (size_t k = 0; k < panels; k++) {
    bool last = k + 1 == panels; /* its key names every curve */
    panel_begin(&chart, family, k);
    experiments_draw(&chart, family, last);
    for (size_t r = 0; last && r + 1 < c->n_runs; r++) cmp_chart_key_entry(&chart, r);
    if (k < c->n_runs) run_draw(&chart, family, k, last);
    run_draw(&chart, family, c->n_runs, last);
    cmp_chart_panel_end(&chart);
  }
  return cmp_chart_end(&chart);
}

static enum status probe_charts(const struct comparison *c, struct cmp_figures *f) {
  for (size_t k = 0; k < c->ref.data.n_probes; k++) {
    const struct cmp_series *probe = &c->ref.data.probes[k];
    struct family family = {
        .target = probe->name, .column = "pressure [rho g H]", .label = "p / (ρ g H)"};
    enum status status = family_pick(c, pick_probe, probe->name, &family);
    if (status == OK) status = probe_chart(c, f, probe, &family);
    free(family.run);
    TRY(status);
  }
  return OK;
}

static enum status gauge_charts(const struct comparison *c, struct cmp_figures *f) {
  for (size_t k = 0; k < c->ref.data.n_gauges; k++) {
    char slug[40], file[64], caption[256];
    const struct cmp_series *g = &c->ref.data.gauges[k];
    cmp_slug(g->name, slug, sizeof slug);
    snprintf(file, sizeof file, "gauge-%s", slug);
    snprintf(caption, sizeof caption, "Height of the water standing at %.60s (x = %.4g H).",
             g->name, g->x);
    struct family family = {.target = g->name, .column = "elevation [H]", .label = "y / H"};
    TRY(picked_chart(c, f, CMP_SECTION_GAUGE, file, caption, pick_gauge, g->name, family));
  }
  return OK;
}

static enum status front_chart(const struct comparison *c, struct cmp_figures *f) {
  char caption[256];
  snprintf(
      caption, sizeof caption,
      "Position of the front, where the water standing on the bed is %.3g H deep: two particle "
      "spacings of the coarsest run.",
      c->depth);
  struct family family = {.target = "front", .column = "front [H]", .label = "x_{front} / H"};
  const struct cmp_value *impact = &c->ref.data.impact.time; /* what follows is no front */
  if (!cmp_comparison_has_front(c)) return OK;
  if (cmp_known(impact)) family.end = 1.1 * impact->value;
  return picked_chart(c, f, CMP_SECTION_FRONT, "front", caption, pick_own, "front", family);
}

enum status cmp_charts_write(const struct comparison *c, struct cmp_figures *f) {
  if (distance_known(c)) TRY(distance_chart(c, f));
  TRY(front_chart(c, f));
  TRY(energy_charts(c, f));
  TRY(probe_charts(c, f));
  return gauge_charts(c, f);
}

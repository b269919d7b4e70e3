#include "compare/charts.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "compare/cuts.h"
#include "compare/family.h"
#include "compare/filters.h"
#include "compare/measure.h"
#include "compare/measures/look.h"
#include "compare/text.h"

/* ---- distance ---- */

static double distance_top(const struct comparison *c, size_t measure) {
  double top = 0;
  for (size_t r = 0; r < c->n_runs; r++) {
    const struct cmp_evolution *e = &c->run[r].evolution;
    const double *value = e->value[measure];
    for (size_t i = 0; i < e->n; i++)
      if (isfinite(value[i])) top = fmax(top, value[i]);
  }
  return top;
}

/* The finest and the coarsest run's: levels in between would make a grey bar. Those so high that
 * the curves would lie on the axis are not drawn, and the caption says where they are. */
struct noise {
  double low, high;
  bool drawn;
};

static struct noise noise_of(const struct comparison *c) {
  struct noise noise = {INFINITY, 0, false};
  double top = distance_top(c, CMP_MEASURE_mean_distance);
  for (size_t r = 0; r < c->n_runs; r++) {
    noise.low = fmin(noise.low, c->run[r].noise);
    noise.high = fmax(noise.high, c->run[r].noise);
  }
  noise.drawn = noise.high < 8 * top || !(top > 0);
  return noise;
}

static struct cmp_frame distance_frame(const struct comparison *c, size_t measure,
                                       const struct noise *noise) {
  double top = distance_top(c, measure);
  if (measure == CMP_MEASURE_mean_distance && noise->drawn) top = fmax(top, noise->high);
  return (struct cmp_frame){0, top > 0 ? 1.06 * top : 1};
}

static void noise_say(const struct noise *noise, char *out, size_t room) {
  const char *what = "the noise floor of the mean distance, half a particle spacing";
  bool one = noise->high - noise->low < 1e-12;
  if (noise->drawn)
    snprintf(out, room, " Dashed: %s%s.", what, one ? "" : " (of the finest and the coarsest run)");
  else if (one)
    snprintf(out, room, " Far above the frame: %s, %.2g H.", what, noise->high);
  else
    snprintf(out, room, " Far above the frame: %s, %.2g to %.2g H.", what, noise->low, noise->high);
}

static bool distance_known(const struct comparison *c) {
  for (size_t r = 0; r < c->n_runs; r++)
    if (c->run[r].evolution.n) return true;
  return false;
}

/* The measures that have a panel, and the columns of the table, e.g. "area [H^2],...". */
static size_t distance_panels(size_t measure[CMP_N_MEASURES], char *columns, size_t room) {
  size_t n = 0, used = 0;
  for (size_t m = 0; m < CMP_N_MEASURES; m++) {
    if (!cmp_measure_always(m) || cmp_measure_sections[m] != CMP_SECTION_DISTANCE) continue;
    if (used < room)
      used += (size_t)snprintf(columns + used, room - used, "%s%s [%s]", n ? "," : "",
                               cmp_measures[m].name, cmp_measures[m].units);
    measure[n++] = m;
  }
  return n;
}

static void distance_rows(const struct comparison *c, struct cmp_chart *chart,
                          const size_t *measure) {
  double value[CMP_N_MEASURES];
  for (size_t r = 0; r < c->n_runs; r++) {
    const struct cmp_evolution *e = &c->run[r].evolution;
    for (size_t i = 0; i < e->n; i++) {
      for (size_t k = 0; k < chart->panels; k++) value[k] = e->value[measure[k]][i];
      cmp_chart_row(chart, r, c->run[r].data.label, e->t[i], value, chart->panels);
    }
  }
}

static void distance_panel(const struct comparison *c, struct cmp_chart *chart, size_t panel,
                           size_t measure, const struct noise *noise) {
  struct cmp_frame frame = distance_frame(c, measure, noise);
  char label[96];
  snprintf(label, sizeof label, "%s / %s", cmp_measures[measure].name, cmp_measures[measure].units);
  for (char *s = label; *s; s++)
    if (*s == '_') *s = ' ';
  cmp_chart_panel(chart, panel, &frame, label, NULL);
  cmp_chart_others(chart, panel, true);
  for (size_t r = 0; r < c->n_runs; r++)
    if (cmp_run_is_picked(c, r, CMP_NAMED))
      cmp_chart_curve(chart, &(struct cmp_curve){.series = r,
                                                 .column = panel,
                                                 .name = c->run[r].data.label,
                                                 .style = cmp_run_style(c, r),
                                                 .width = 1.3});
  if (measure == CMP_MEASURE_mean_distance && noise->drawn) {
    cmp_chart_level(chart, noise->low);
    if (noise->high > noise->low) cmp_chart_level(chart, noise->high);
  }
  cmp_chart_panel_end(chart);
}

static enum status distance_chart(const struct comparison *c, struct cmp_figures *f) {
  struct cmp_chart chart;
  struct noise noise = noise_of(c);
  char floor[192], columns[1024];
  size_t measure[CMP_N_MEASURES];
  const struct cmp_chart_plan plan = {.section = CMP_SECTION_DISTANCE,
                                      .name = "distance",
                                      .panels = distance_panels(measure, columns, sizeof columns),
                                      .columns = columns,
                                      .panel_height = 190};
  TRY(cmp_chart_begin(c, f, &plan, &chart));
  noise_say(&noise, floor, sizeof floor);
  snprintf(
      chart.fig->caption, sizeof chart.fig->caption,
      "Distance of each run's free surface from that of %.60s at every common output: mean and "
      "largest distance of the main surfaces away from walls, and the area between the two.%s",
      c->ref.data.label, floor);
  cmp_family_caption_end(c, chart.fig);
  distance_rows(c, &chart, measure);
  for (size_t k = 0; k < plan.panels; k++) distance_panel(c, &chart, k, measure[k], &noise);
  return cmp_chart_end(&chart);
}

/* ---- one series of every run ---- */

typedef const struct cmp_series *series_pick(const struct cmp_data *d, const char *name);

static const struct cmp_series *pick_probe(const struct cmp_data *d, const char *name) {
  return cmp_series_find(d->probes, d->n_probes, name);
}

static const struct cmp_series *pick_gauge(const struct cmp_data *d, const char *name) {
  return cmp_series_find(d->gauges, d->n_gauges, name);
}

static const struct cmp_series *pick_own(const struct cmp_data *d, const char *name) {
  const struct cmp_series *own[] = {&d->kinetic, &d->potential, &d->mechanical,
                                    &d->closure, &d->removed,   &d->front};
  for (size_t k = 0; k < sizeof own / sizeof *own; k++)
    if (!strcmp(own[k]->name, name)) return own[k]->n ? own[k] : NULL;
  return NULL;
}

static enum status family_pick(const struct comparison *c, series_pick *pick, const char *name,
                               struct cmp_family *family) {
  family->run = calloc(c->n_runs + 1, sizeof *family->run);
  CHECK(family->run, ERR_MEMORY, "no memory for a chart");
  for (size_t r = 0; r <= c->n_runs; r++)
    family->run[r] = pick(&cmp_run_or_ref(c, r < c->n_runs ? r : SIZE_MAX)->data, name);
  return OK;
}

static enum status picked_chart(const struct comparison *c, struct cmp_figures *f,
                                const char *caption, series_pick *pick, const char *name,
                                struct cmp_family family) {
  enum status status = family_pick(c, pick, name, &family);
  if (status == OK && !cmp_family_empty(c, &family))
    status = cmp_family_chart(c, f, caption, &family);
  free(family.run);
  return status;
}

static enum status energy_charts(const struct comparison *c, struct cmp_figures *f) {
  static const struct {
    const char *name, *file, *label, *caption;
    bool cuts;
  } charts[] = {
      {"mechanical", "energy", "(E_k + E_p − E_{rest}) / E_0",
       "Mechanical energy (kinetic + potential, relative to the same water at rest, with that of "
       "water taken out added back) over its initial value in the reference: what is lost shows as "
       "decay.",
       false},
      {"kinetic", "energy-kinetic", "E_k / E_0", "Kinetic energy.", true},
      {"potential", "energy-potential", "(E_p − E_{rest}) / E_0",
       "Potential energy relative to the same water at rest.", true},
      {"removed", "energy-removed", "E_{removed} / E_0",
       "Energy of water that was taken out of the computation so far, since it left the tank or "
       "could not be followed.",
       true},
      {"closure", "energy-budget", "budget error / E_0",
       "Closure of each energy budget: kinetic + potential + elastic + everything "
       "dissipated or taken out, minus its value at t = 0. It is zero where every loss is "
       "accounted for.",
       false}};
  for (size_t k = 0; k < sizeof charts / sizeof *charts; k++) {
    char column[64];
    if (!strcmp(charts[k].name, "removed") && !cmp_cuts_any(c)) continue;
    snprintf(column, sizeof column, "%s [E0]", charts[k].name);
    struct cmp_family family = {
        .label = charts[k].label,
        .cuts = charts[k].cuts,
        .plan = {.section = CMP_SECTION_ENERGY, .name = charts[k].file, .columns = column}};
    TRY(picked_chart(c, f, charts[k].caption, pick_own, charts[k].name, family));
  }
  return OK;
}

/* What a probe's signal is the mean over. */
static void probe_means(const struct cmp_series *probe, char *out, size_t room) {
  size_t n = 0;
  out[0] = 0;
  if (probe->size > 0)
    n = (size_t)snprintf(out, room, " Mean over %.4g H of the wall.", probe->size);
  if (probe->average > 0)
    snprintf(out + n, room - n,
             " Thick curves and symbols: running means over %.4g √(H/g), which every number is "
             "taken of; thin: the raw signals, which may leave the frame.",
             probe->average);
}

static enum status probe_chart(const struct comparison *c, struct cmp_figures *f,
                               const struct cmp_series *probe, struct cmp_family *family) {
  char slug[40], file[64], means[224], caption[512];
  cmp_slug(probe->name, slug, sizeof slug);
  snprintf(file, sizeof file, "pressure-%s", slug);
  family->plan = (struct cmp_chart_plan){
      .section = CMP_SECTION_PRESSURE,
      .name = file,
      .columns = probe->average > 0 ? "mean pressure [rho g H],raw pressure [rho g H]"
                                    : "pressure [rho g H]",
      .target = probe->name};
  probe_means(probe, means, sizeof means);
  snprintf(caption, sizeof caption,
           "Pressure at %.60s (x = %.4g H, y = %.4g H): each run, the reference %.60s in black, "
           "experiments as symbols.%s",
           probe->name, probe->x, probe->y, c->ref.data.label, means);
  return cmp_family_panels(c, f, caption, family);
}

/* ---- sensors: those of the reference, and then those that only runs have ---- */

static void sensors_of(const struct cmp_data *d, bool gauges, size_t *n,
                       const struct cmp_series **list) {
  const struct cmp_series *own = gauges ? d->gauges : d->probes;
  for (size_t k = 0; k < (gauges ? d->n_gauges : d->n_probes); k++) {
    bool known = false;
    for (size_t i = 0; i < *n && !known; i++) known = !strcmp(list[i]->name, own[k].name);
    if (!known) list[(*n)++] = &own[k];
  }
}

static enum status sensors_list(const struct comparison *c, bool gauges, size_t *n,
                                const struct cmp_series ***list) {
  size_t room = 1;
  for (size_t r = 0; r <= c->n_runs; r++) {
    const struct cmp_data *d = &cmp_run_or_ref(c, r < c->n_runs ? r : SIZE_MAX)->data;
    room += gauges ? d->n_gauges : d->n_probes;
  }
  *n = 0;
  *list = calloc(room, sizeof **list);
  CHECK(*list, ERR_MEMORY, "no memory for %zu sensors", room);
  sensors_of(&c->ref.data, gauges, n, *list);
  for (size_t r = 0; r < c->n_runs; r++) sensors_of(&c->run[r].data, gauges, n, *list);
  return OK;
}

static void reference_lacks(const struct comparison *c, const struct cmp_series *of_reference,
                            struct cmp_figure *fig) {
  size_t used = strlen(fig->caption);
  if (!of_reference)
    snprintf(fig->caption + used, sizeof fig->caption - used,
             " %.60s has none of that name: nothing is compared.", c->ref.data.label);
}

static enum status probe_charts(const struct comparison *c, struct cmp_figures *f) {
  size_t n;
  const struct cmp_series **probes;
  enum status status = sensors_list(c, false, &n, &probes);
  for (size_t k = 0; status == OK && k < n; k++) {
    struct cmp_family family = {.label =
                                    probes[k]->average > 0 ? "mean p / (ρ g H)" : "p / (ρ g H)"};
    status = family_pick(c, pick_probe, probes[k]->name, &family);
    if (status == OK && !cmp_family_empty(c, &family)) {
      status = probe_chart(c, f, probes[k], &family);
      reference_lacks(c, family.run[c->n_runs], &f->figure[f->n - 1]);
    }
    free(family.run);
  }
  free(probes);
  return status;
}

static enum status gauge_chart(const struct comparison *c, struct cmp_figures *f,
                               const struct cmp_series *g) {
  char slug[40], file[64], caption[256];
  cmp_slug(g->name, slug, sizeof slug);
  snprintf(file, sizeof file, "gauge-%s", slug);
  snprintf(caption, sizeof caption, "Height of the water standing at %.60s (x = %.4g H).", g->name,
           g->x);
  struct cmp_family family = {.label = "y / H",
                              .plan = {.section = CMP_SECTION_GAUGE,
                                       .name = file,
                                       .columns = "elevation [H]",
                                       .target = g->name}};
  size_t before = f->n;
  TRY(picked_chart(c, f, caption, pick_gauge, g->name, family));
  if (f->n > before) reference_lacks(c, pick_gauge(&c->ref.data, g->name), &f->figure[f->n - 1]);
  return OK;
}

static enum status gauge_charts(const struct comparison *c, struct cmp_figures *f) {
  size_t n;
  const struct cmp_series **gauges;
  enum status status = sensors_list(c, true, &n, &gauges);
  for (size_t k = 0; status == OK && k < n; k++) status = gauge_chart(c, f, gauges[k]);
  free(gauges);
  return status;
}

static enum status front_chart(const struct comparison *c, struct cmp_figures *f) {
  char caption[256];
  snprintf(
      caption, sizeof caption,
      "Position of the front, where the water standing on the bed is %.3g H deep: two particle "
      "spacings of the coarsest run.",
      c->depth);
  struct cmp_family family = {.label = "x_{front} / H",
                              .plan = {.section = CMP_SECTION_FRONT,
                                       .name = "front",
                                       .columns = "front [H]",
                                       .target = "front"}};
  const struct cmp_value *impact = &c->ref.data.impact.time; /* what follows is no front */
  if (!cmp_comparison_has_front(c)) return OK;
  if (cmp_known(impact)) family.plan.end = 1.1 * impact->value;
  return picked_chart(c, f, caption, pick_own, "front", family);
}

/* ---- filters ---- */

static const char *const filter_slugs[] = {
#define X(name, help) #name,
    CASE_FILTERS(X)
#undef X
};

/* A filter's pressures above the raw ones, thin; of an impulse alone. */
static enum status filter_chart(const struct comparison *c, struct cmp_figures *f, size_t k,
                                struct cmp_family *family) {
  const struct case_filter *filter = &c->settings->compare.filters[k];
  const char *probe = c->settings->probes[filter->probe].name;
  const bool impulse = filter->kind == CASE_FILTER_impulse;
  char slug[40], file[96], what[96], caption[512];
  cmp_slug(probe, slug, sizeof slug);
  snprintf(file, sizeof file, "filter-%zu-%s-%s", k + 1, slug, filter_slugs[filter->kind]);
  cmp_filter_say(filter, c->scales.T, c->scales.H, what, sizeof what);
  family->label = impulse ? "∫ p dt / (ρ g H √(H/g))" : "p / (ρ g H)";
  family->plan = (struct cmp_chart_plan){
      .section = CMP_SECTION_PRESSURE,
      .name = file,
      .columns = impulse ? "impulse [rho g H sqrt(H/g)]"
                         : "filtered pressure [rho g H],raw pressure [rho g H]",
      .target = impulse ? NULL : probe};
  snprintf(caption, sizeof caption, "%.60s, %s: each run, the reference %.60s in black.%s", probe,
           what, c->ref.data.label,
           impulse ? ""
                   : " Thin: the raw signals, which may leave the frame"
                     "; experiments are as measured.");
  return cmp_family_panels(c, f, caption, family);
}

static enum status filter_charts(const struct comparison *c, struct cmp_figures *f) {
  enum status status = OK;
  for (size_t k = 0; status == OK && k < c->settings->compare.n_filters; k++) {
    struct cmp_family family = {.run = calloc(c->n_runs + 1, sizeof *family.run)};
    CHECK(family.run, ERR_MEMORY, "no memory for a chart");
    for (size_t r = 0; r <= c->n_runs; r++) {
      const struct cmp_filtered *own =
          &cmp_run_or_ref(c, r < c->n_runs ? r : SIZE_MAX)->filtered[k];
      family.run[r] = own->series.n ? &own->series : NULL;
    }
    if (!cmp_family_empty(c, &family)) status = filter_chart(c, f, k, &family);
    free(family.run);
  }
  return status;
}

enum status cmp_charts_write(const struct comparison *c, struct cmp_figures *f) {
  if (distance_known(c)) TRY(distance_chart(c, f));
  TRY(front_chart(c, f));
  TRY(energy_charts(c, f));
  TRY(probe_charts(c, f));
  TRY(filter_charts(c, f));
  return gauge_charts(c, f);
}

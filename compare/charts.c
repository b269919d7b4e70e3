#include "compare/charts.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

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

static void caption_end(const struct comparison *c, struct cmp_figure *fig) {
  size_t used = strlen(fig->caption);
  cmp_picked_say(c, CMP_NAMED, "are drawn in thin grey", fig->caption + used,
                 sizeof fig->caption - used);
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
  caption_end(c, chart.fig);
  distance_rows(c, &chart, measure);
  for (size_t k = 0; k < plan.panels; k++) distance_panel(c, &chart, k, measure[k], &noise);
  return cmp_chart_end(&chart);
}

/* ---- the same series of every run, of the reference and of experiments ---- */

struct family {
  const struct cmp_series **run; /* [n_runs + 1]: the reference last; NULL: it has none */
  const char *label;             /* of the axis */
  struct cmp_chart_plan plan;    /* without a target no experiments are drawn */
  struct cmp_frame frame;
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
  return family->plan.target &&
         !strcmp(c->ref.data.file->experiments[k].target, family->plan.target);
}

static void series_rows(struct cmp_chart *chart, size_t id, const char *name,
                        const struct cmp_series *s) {
  for (size_t i = 0; i < s->n; i++) {
    double both[] = {s->value[i], s->raw ? s->raw[i] : NAN};
    cmp_chart_row(chart, id, name, s->t[i], both, s->raw ? 2 : 1);
  }
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

static const struct cmp_series *family_member(const struct comparison *c,
                                              const struct family *family, size_t k) {
  if (k <= c->n_runs) return family->run[k];
  k -= c->n_runs + 1;
  return family_shows(c, family, k) ? &c->ref.data.experiments[k] : NULL;
}

/* What the key says of a series: a few peaks have their mark, and no word. */
static const char *family_note(const struct comparison *c, const struct family *family, size_t k) {
  const struct cmp_series *s = family_member(c, family, k);
  if (!s || !s->n) return " (has none)";
  struct cmp_beyond b = cmp_frame_beyond(&family->frame, s, family->plan.end);
  if (b.n && b.outside == b.n) return " (beyond the frame)";
  return 50 * b.outside > b.n ? " (partly beyond the frame)" : NULL;
}

/* In a column of panels, curves far from the others have their own, where the mark says how far. */
static enum status family_frame(const struct comparison *c, struct family *family) {
  struct cmp_chart_plan *plan = &family->plan;
  plan->end = cmp_chart_time_end(c, plan);
  size_t n = c->n_runs + 1 + c->ref.data.n_experiments;
  const struct cmp_series **all = calloc(n, sizeof(struct cmp_series *));
  CHECK(all, ERR_MEMORY, "no memory for a chart");
  for (size_t k = 0; k < n; k++) all[k] = family_member(c, family, k);
  family->frame = cmp_frame_choose(n, all, plan->end, plan->panels > 1 ? 2.5 : 8);
  free(all);
  for (size_t k = 0; k < n; k++) {
    const char *note = family_note(c, family, k);
    if (note && strlen(note) > plan->note) plan->note = strlen(note);
  }
  return OK;
}

/* Of the series that a panel shows, before its curves. */
static void beyond_mark(struct cmp_chart *chart, const struct family *family, size_t k,
                        const char *colour) {
  const struct cmp_series *s = family_member(chart->c, family, k);
  if (!s || !s->n) return;
  struct cmp_beyond beyond = cmp_frame_beyond(&family->frame, s, chart->end);
  cmp_chart_mark(chart, &beyond, colour);
}

/* ---- drawing a family ---- */

static const char *experiment_colour(size_t shown) {
  return shown % 2 ? "#a08050" : "#707070";
}

static void experiments_mark(struct cmp_chart *chart, const struct family *family) {
  const struct comparison *c = chart->c;
  for (size_t k = 0, shown = 0; k < c->ref.data.n_experiments; k++)
    if (family_shows(c, family, k))
      beyond_mark(chart, family, c->n_runs + 1 + k, experiment_colour(shown++));
}

static void experiments_draw(struct cmp_chart *chart, const struct family *family, bool named) {
  static const int symbols[] = {4, 6, 8, 12, 2};
  const struct comparison *c = chart->c;
  size_t shown = 0;
  for (size_t k = 0; k < c->ref.data.n_experiments; k++) {
    if (!family_shows(c, family, k)) continue;
    cmp_chart_curve(
        chart, &(struct cmp_curve){.series = c->n_runs + 1 + k,
                                   .name = named ? c->ref.data.experiments[k].name : NULL,
                                   .note = family_note(c, family, c->n_runs + 1 + k),
                                   .style = {experiment_colour(shown), 0},
                                   .symbol = symbols[shown % 5],
                                   .every = c->ref.data.experiments[k].n / 80 + 1}); /* no smear */
    shown++;
  }
}

/* The reference is wider and below: a run that lies on it is seen. */
static void run_draw(struct cmp_chart *chart, const struct family *family, size_t r, bool named) {
  if (!family->run[r] || !family->run[r]->n) return;
  bool reference = r == chart->c->n_runs;
  size_t id = reference ? SIZE_MAX : r;
  cmp_chart_curve(chart, &(struct cmp_curve){
                             .series = r,
                             .name = named ? cmp_run_or_ref(chart->c, id)->data.label : NULL,
                             .note = family_note(chart->c, family, r),
                             .style = cmp_run_style(chart->c, id),
                             .width = reference ? 2 : 1,
                         });
}

/* What a mean was taken of, thin and below every mean. */
static void raw_draw(struct cmp_chart *chart, const struct family *family, size_t r) {
  if (!family->run[r] || !family->run[r]->n || !family->run[r]->raw) return;
  struct cmp_style style = cmp_run_style(chart->c, r < chart->c->n_runs ? r : SIZE_MAX);
  style.dashes = 0;
  cmp_chart_curve(chart,
                  &(struct cmp_curve){.series = r, .column = 1, .style = style, .width = 0.35});
}

static void runs_draw(struct cmp_chart *chart, const struct family *family) {
  const struct comparison *c = chart->c;
  cmp_chart_others(chart, 0, true);
  run_draw(chart, family, c->n_runs, true);
  for (size_t r = 0; r < c->n_runs; r++)
    if (cmp_run_is_picked(c, r, CMP_NAMED)) run_draw(chart, family, r, true);
}

static enum status family_chart(const struct comparison *c, struct cmp_figures *f,
                                const char *caption, struct family *family) {
  struct cmp_chart chart;
  family->plan.panels = 1;
  family->plan.panel_height = 280;
  TRY(family_frame(c, family));
  TRY(cmp_chart_begin(c, f, &family->plan, &chart));
  snprintf(chart.fig->caption, sizeof chart.fig->caption, "%s", caption);
  caption_end(c, chart.fig);
  family_rows(&chart, family);
  cmp_chart_panel(&chart, 0, &family->frame, family->label, NULL);
  experiments_mark(&chart, family);
  for (size_t r = 0; r <= c->n_runs; r++)
    beyond_mark(&chart, family, r, cmp_run_style(c, r < c->n_runs ? r : SIZE_MAX).colour);
  experiments_draw(&chart, family, true);
  runs_draw(&chart, family);
  cmp_chart_panel_end(&chart);
  return cmp_chart_end(&chart);
}

static enum status picked_chart(const struct comparison *c, struct cmp_figures *f,
                                const char *caption, series_pick *pick, const char *name,
                                struct family family) {
  enum status status = family_pick(c, pick, name, &family);
  if (status == OK && !family_empty(c, &family)) status = family_chart(c, f, caption, &family);
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
    struct family family = {
        .label = charts[k].label,
        .plan = {.section = CMP_SECTION_ENERGY, .name = charts[k].file, .columns = column}};
    TRY(picked_chart(c, f, charts[k].caption, pick_own, charts[k].name, family));
  }
  return OK;
}

/* The key of a column of panels stands below the last and names every curve of all. */
static void key_draw(struct cmp_chart *chart, const struct family *family, size_t except) {
  const struct comparison *c = chart->c;
  for (size_t r = 0; r < c->n_runs; r++)
    if (r != except && cmp_run_is_picked(c, r, CMP_PANELS))
      cmp_chart_key_entry(chart, r, family_note(c, family, r));
}

static void probe_panel(struct cmp_chart *chart, const struct family *family, size_t k, size_t r) {
  const struct comparison *c = chart->c;
  bool last = k + 1 == chart->panels, run = r < c->n_runs;
  cmp_chart_panel(chart, k, &family->frame, family->label,
                  chart->panels > 1 ? c->run[r].data.label : NULL);
  experiments_mark(chart, family);
  beyond_mark(chart, family, c->n_runs, cmp_run_style(c, SIZE_MAX).colour);
  if (run) beyond_mark(chart, family, r, cmp_run_style(c, r).colour);
  raw_draw(chart, family, c->n_runs);
  if (run) raw_draw(chart, family, r);
  experiments_draw(chart, family, last);
  run_draw(chart, family, c->n_runs, last);
  if (last) key_draw(chart, family, r);
  if (run && family->run[r] && family->run[r]->n)
    run_draw(chart, family, r, last);
  else if (run && last)
    cmp_chart_key_entry(chart, r, family_note(c, family, r));
  cmp_chart_panel_end(chart);
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

/* A panel for every run: one full of noise would hide the others. */
static enum status probe_chart(const struct comparison *c, struct cmp_figures *f,
                               const struct cmp_series *probe, struct family *family) {
  struct cmp_chart chart;
  char slug[40], file[64], left_out[160], means[224];
  cmp_slug(probe->name, slug, sizeof slug);
  snprintf(file, sizeof file, "pressure-%s", slug);
  size_t picked = cmp_runs_picked(c, CMP_PANELS), panels = picked ? picked : 1;
  family->plan = (struct cmp_chart_plan){
      .section = CMP_SECTION_PRESSURE,
      .name = file,
      .columns = probe->average > 0 ? "mean pressure [rho g H],raw pressure [rho g H]"
                                    : "pressure [rho g H]",
      .panels = panels,
      .panel_height = panels == 1 ? 280 : 175,
      .target = probe->name};
  TRY(family_frame(c, family));
  TRY(cmp_chart_begin(c, f, &family->plan, &chart));
  cmp_picked_say(c, CMP_PANELS, "have no panel", left_out, sizeof left_out);
  probe_means(probe, means, sizeof means);
  snprintf(chart.fig->caption, sizeof chart.fig->caption,
           "Pressure at %.60s (x = %.4g H, y = %.4g H): each run, the reference %.60s in black, "
           "experiments as symbols.%s%s",
           probe->name, probe->x, probe->y, c->ref.data.label, means, left_out);
  family_rows(&chart, family);
  for (size_t r = 0, k = 0; r < c->n_runs || (k == 0 && r == c->n_runs); r++)
    if (r == c->n_runs || cmp_run_is_picked(c, r, CMP_PANELS)) probe_panel(&chart, family, k++, r);
  return cmp_chart_end(&chart);
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
    struct family family = {.label = probes[k]->average > 0 ? "mean p / (ρ g H)" : "p / (ρ g H)"};
    status = family_pick(c, pick_probe, probes[k]->name, &family);
    if (status == OK && !family_empty(c, &family)) {
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
  struct family family = {.label = "y / H",
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
  struct family family = {.label = "x_{front} / H",
                          .plan = {.section = CMP_SECTION_FRONT,
                                   .name = "front",
                                   .columns = "front [H]",
                                   .target = "front"}};
  const struct cmp_value *impact = &c->ref.data.impact.time; /* what follows is no front */
  if (!cmp_comparison_has_front(c)) return OK;
  if (cmp_known(impact)) family.plan.end = 1.1 * impact->value;
  return picked_chart(c, f, caption, pick_own, "front", family);
}

enum status cmp_charts_write(const struct comparison *c, struct cmp_figures *f) {
  if (distance_known(c)) TRY(distance_chart(c, f));
  TRY(front_chart(c, f));
  TRY(energy_charts(c, f));
  TRY(probe_charts(c, f));
  return gauge_charts(c, f);
}

#include "compare/data.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/result/health.h"
#include "compare/bed.h"
#include "compare/text.h"

enum status cmp_scales_set(const struct result_file *reference, struct cmp_scales *s) {
  const struct result_file *f = reference;
  CHECK(f->H > 0 && f->g > 0 && f->density > 0, ERR_INPUT,
        "%s: H = %g m, g = %g m/s^2 and density = %g kg/m^3 must be positive", f->path, f->H, f->g,
        f->density);
  *s = (struct cmp_scales){.H = f->H, .T = sqrt(f->H / f->g), .p = f->density * f->g * f->H};
  s->rest = f->rest_potential;
  s->E = health_energy_scale(f->n_energy ? &f->energy[0] : NULL, f->rest_potential,
                             s->p * s->H * s->H, &s->at_rest);
  return OK;
}

struct cmp_scales cmp_scales_of(const struct cmp_scales *reference, const struct result_file *run) {
  struct cmp_scales s = *reference;
  if (run->H == s.H && run->density * run->g * run->H == s.p) return s;
  s.H = run->H;
  s.T = sqrt(run->H / run->g);
  s.p = run->density * run->g * run->H;
  s.E = reference->E * (s.p * s.H * s.H) / (reference->p * reference->H * reference->H);
  return s;
}

/* ---- units ---- */

/* Of a file's unit in the scales; those that there is none for stay what they are. */
static struct cmp_unit unit_of(const char *si, const struct cmp_scales *s) {
  const double speed = s->H / s->T, density = s->p * s->T * s->T / (s->H * s->H);
  const struct cmp_unit units[] = {
      {"1", "1", "1", 1},
      {"m", "H", "H", s->H},
      {"s", "sqrt(H/g)", "√(H/g)", s->T},
      {"m/s", "sqrt(gH)", "√(gH)", speed},
      {"m/s^2", "g", "g", speed / s->T},
      {"kg/m^3", "rho", "ρ", density},
      {"Pa", "rho g H", "ρ g H", s->p},
      {"kg/s", "rho H^2 sqrt(gH)", "ρ H² √(gH)", density * s->H * s->H * speed},
      {"kg m/s", "rho H^3 sqrt(gH)", "ρ H³ √(gH)", density * s->H * s->H * s->H * speed}};
  for (size_t k = 0; k < sizeof units / sizeof *units; k++)
    if (!strcmp(units[k].si, si)) return units[k];
  return (struct cmp_unit){si, si, si, 1};
}

/* ---- series ---- */

static enum status series_room(struct cmp_series *s, const char *name, size_t n) {
  s->name = name;
  s->t = calloc(n + 1, sizeof *s->t);
  s->value = calloc(n + 1, sizeof *s->value);
  CHECK(s->t && s->value, ERR_MEMORY, "no memory for a series of %zu rows", n);
  return OK;
}

static void series_free(struct cmp_series *s) {
  free(s->t);
  free(s->value);
  free(s->raw);
  free(s->error);
}

static void series_add(struct cmp_series *s, double t, double value, double error) {
  if (s->n && !(t > s->t[s->n - 1])) return; /* a row at the same instant says nothing new */
  if (s->error) s->error[s->n] = error;
  s->t[s->n] = t;
  s->value[s->n++] = value;
}

static enum status series_error_room(struct cmp_series *s, size_t n) {
  s->error = calloc(n + 1, sizeof *s->error);
  CHECK(s->error, ERR_MEMORY, "no memory for the errors of a series of %zu rows", n);
  return OK;
}

/* error: [n], or NULL. */
static enum status series_scaled(const char *name, size_t n, const double *t, const double *value,
                                 const double *error, double T, double unit, struct cmp_series *s) {
  TRY(series_room(s, name, n));
  if (error) TRY(series_error_room(s, n));
  for (size_t i = 0; i < n; i++)
    series_add(s, t[i] / T, value[i] / unit, error ? error[i] / unit : NAN);
  return OK;
}

static enum status series_list(const struct result_series *from, size_t n,
                               const struct cmp_scales *s, const char *si, struct cmp_series **to) {
  *to = calloc(n + 1, sizeof **to);
  CHECK(*to, ERR_MEMORY, "no memory for %zu series", n);
  for (size_t k = 0; k < n; k++) {
    const struct cmp_unit unit = unit_of(si ? si : from[k].units, s);
    TRY(series_scaled(from[k].name, from[k].n, from[k].t, from[k].value,
                      from[k].n_errors ? from[k].error : NULL, s->T, unit.size, &(*to)[k]));
    (*to)[k].units = unit.name;
    (*to)[k].label = unit.label;
    (*to)[k].x = from[k].x / s->H;
    (*to)[k].y = from[k].y / s->H;
    (*to)[k].size = from[k].size / s->H;
  }
  return OK;
}

static enum status point_fields(const struct result_point_read *p, const struct cmp_scales *s,
                                struct cmp_series *to) {
  static const struct {
    const char *name, *units;
  } field[] = {
#define X(name, units, help) {#name, units},
      CASE_POINT(X)
#undef X
  };
  for (size_t k = 0; k < CASE_POINT_FIELDS; k++) {
    const struct cmp_unit unit = unit_of(field[k].units, s);
    char *name;
    if (asprintf(&name, "%s.%s", p->name, field[k].name) < 0)
      return status_raise(ERR_MEMORY, "no memory for a name");
    enum status status =
        series_scaled(name, p->n, p->t, p->value[k], NULL, s->T, unit.size, &to[k]);
    to[k].name = name; /* whatever happened: it is freed with the series */
    TRY(status);
    to[k].x = p->x / s->H;
    to[k].y = p->y / s->H;
    to[k].units = unit.name;
    to[k].label = unit.label;
  }
  return OK;
}

static enum status points(const struct result_file *f, const struct cmp_scales *s,
                          struct cmp_data *d) {
  d->points = calloc(CASE_POINT_FIELDS * f->n_points + 1, sizeof *d->points);
  CHECK(d->points, ERR_MEMORY, "no memory for the series of %zu points", f->n_points);
  for (size_t k = 0; k < f->n_points; k++) {
    d->n_points += CASE_POINT_FIELDS;
    TRY(point_fields(&f->points[k], s, &d->points[CASE_POINT_FIELDS * k]));
  }
  return OK;
}

const struct cmp_series *cmp_data_series(const struct cmp_data *d, const char *name) {
  const struct cmp_series *s = cmp_series_find(d->probes, d->n_probes, name);
  if (!s) s = cmp_series_find(d->gauges, d->n_gauges, name);
  return s ? s : cmp_series_find(d->points, d->n_points, name);
}

const struct cmp_series *cmp_series_find(const struct cmp_series *s, size_t n, const char *name) {
  for (size_t k = 0; k < n; k++)
    if (!strcmp(s[k].name, name)) return &s[k];
  return NULL;
}

/* ---- the parts of a file ---- */

static enum status energies(const struct result_file *f, const struct cmp_scales *s,
                            struct cmp_data *d) {
  struct cmp_series *all[] = {&d->kinetic,  &d->potential, &d->mechanical,
                              &d->internal, &d->closure,   &d->removed};
  static const char *const names[] = {"kinetic",  "potential", "mechanical",
                                      "internal", "closure",   "removed"};
  enum { SERIES = sizeof all / sizeof *all };
  for (size_t k = 0; k < SERIES; k++) TRY(series_room(all[k], names[k], f->n_energy));
  for (size_t k = 0; k < 3 && f->n_energy_errors; k++) TRY(series_error_room(all[k], f->n_energy));
  const double rest =
      f->rest_potential; /* its own: a compressible fluid's is not the reference's */
  for (size_t i = 0; i < f->n_energy; i++) {
    const struct result_energy *e = &f->energy[i];
    double value[SERIES] = {e->kinetic,
                            e->potential - rest,
                            e->kinetic + e->potential + e->removed - rest,
                            e->internal,
                            result_energy_budget(e) - result_energy_budget(&f->energy[0]),
                            e->removed};
    const struct result_energy *error = f->n_energy_errors ? &f->energy_error[i] : NULL;
    const double bar[SERIES] = {error ? error->kinetic : NAN,
                                error ? error->potential : NAN,
                                error ? error->total : NAN,
                                NAN,
                                NAN,
                                NAN};
    for (size_t k = 0; k < SERIES; k++)
      series_add(all[k], e->time / s->T, value[k] / s->E, bar[k] / s->E);
  }
  TRY(series_room(&d->volume, "volume", f->n_steps));
  for (size_t i = 0; i < f->n_steps; i++)
    series_add(&d->volume, f->steps[i].time / s->T,
               (f->steps[i].volume + f->steps[i].removed_volume) / (s->H * s->H), NAN);
  return OK;
}

static enum status terms(const struct result_file *f, const struct cmp_scales *s,
                         struct cmp_data *d) {
  d->n_terms = f->n_terms;
  d->terms = calloc(f->n_terms + 1, sizeof *d->terms);
  CHECK(d->terms, ERR_MEMORY, "no memory for %zu terms of energy", f->n_terms);
  for (size_t k = 0; k < f->n_terms; k++) {
    TRY(series_room(&d->terms[k], f->terms[k].name, f->n_energy));
    for (size_t i = 0; i < f->n_energy; i++)
      series_add(&d->terms[k], f->energy[i].time / s->T, f->energy[i].term[k] / s->E, NAN);
  }
  return OK;
}

static enum status lines_scaled(const struct geo_lines *from, double H, struct geo_lines *to) {
  TRY(geo_lines_copy(to, from));
  for (size_t i = 0; i < to->points; i++) {
    to->p[i][0] /= H;
    to->p[i][1] /= H;
  }
  return OK;
}

static struct cmp_jet_place jet_place(const struct cmp_data *d, double depth,
                                      const struct geo_box *window) {
  return (struct cmp_jet_place){&d->walls, *window, 1, CMP_JET_LEAST * depth, depth};
}

static enum status surfaces(const struct result_file *f, const struct cmp_scales *s, double depth,
                            const struct geo_box *window, struct cmp_data *d) {
  struct cmp_jet_place place = jet_place(d, depth, window);
  size_t n = f->n_surfaces;
  d->t = calloc(n + 1, sizeof *d->t);
  d->surface = calloc(n + 1, sizeof *d->surface);
  d->jet = calloc(n + 1, sizeof *d->jet);
  CHECK(d->t && d->surface && d->jet, ERR_MEMORY, "no memory for %zu surfaces", n);
  for (int k = 0; k < 2; k++) TRY(series_room(&d->fronts[k], "front", n));
  for (size_t i = 0; i < n; i++) {
    double t = f->surface_time[i] / s->T;
    if (d->n && !(t > d->t[d->n - 1])) continue;
    d->t[d->n] = t;
    TRY(lines_scaled(&f->surface[i], s->H, &d->surface[d->n++]));
    const struct geo_lines *surface = &d->surface[d->n - 1];
    if (!d->floats) cmp_jet_find(surface, &place, &d->jet[d->n - 1]);
    for (int side = 0; side < 2; side++) {
      double front;
      TRY(cmp_bed_front(&d->walls, surface, side, depth, &front));
      if (isfinite(front)) series_add(&d->fronts[side], t, front, NAN);
    }
  }
  return OK;
}

static struct cmp_instant event_instant(const struct result_event_read *e,
                                        const struct cmp_scales *s) {
  return (struct cmp_instant){.time = cmp_number(e->time / s->T),
                              .error = isfinite(e->error[0]) ? e->error[0] / s->T : 0,
                              .located = true,
                              .at = {e->x / s->H, e->y / s->H}};
}

static bool event_take(const struct result_file *f, const struct cmp_scales *s, const char *name,
                       struct cmp_instant *instant) {
  for (size_t k = 0; k < f->n_events; k++)
    if (!strcmp(f->events[k].name, name)) {
      const struct result_event_read *e = &f->events[k];
      *instant = event_instant(e, s);
      return true;
    }
  return false;
}

static void instants(const struct result_file *f, const struct cmp_scales *s, double depth,
                     const struct geo_box *window, struct cmp_data *d) {
  struct cmp_jet_sequence seen = {
      .n = d->n, .t = d->t, .jet = d->jet, .surface = d->surface, .spacing = d->dx};
  seen.place = jet_place(d, depth, window);
  if (d->floats) {
    d->overturning = d->touchdown =
        (struct cmp_instant){cmp_unknown("the water is a body that floats, not a wave that breaks"),
                             NAN,
                             false,
                             {NAN, NAN}};
    return;
  }
  if (!event_take(f, s, "overturning", &d->overturning))
    cmp_jet_overturning(&seen, &d->overturning);
  if (!event_take(f, s, "touchdown", &d->touchdown)) cmp_jet_touchdown(&seen, &d->touchdown);
}

static enum status experiments(const struct result_file *f, const struct cmp_scales *s,
                               struct cmp_data *d) {
  d->n_experiments = f->n_experiments;
  d->experiments = calloc(f->n_experiments + 1, sizeof *d->experiments);
  CHECK(d->experiments, ERR_MEMORY, "no memory for %zu experiments", f->n_experiments);
  for (size_t k = 0; k < f->n_experiments; k++) {
    const struct case_experiment *e = &f->experiments[k];
    double unit = cmp_series_find(d->probes, d->n_probes, e->target) ? s->p : s->H;
    TRY(series_scaled(e->label, e->n, e->t, e->value, NULL, s->T, unit, &d->experiments[k]));
  }
  return OK;
}

enum status cmp_data_create(const struct result_file *f, const struct geo_lines *walls,
                            const struct cmp_scales *s, double depth, const struct geo_box *window,
                            struct cmp_data *d) {
  *d = (struct cmp_data){.file = f, .dx = f->spacing / s->H, .floats = f->floats};
  CHECK(f->spacing > 0, ERR_INPUT, "%s: its spacing is %g m; it must be positive", f->path,
        f->spacing);
  cmp_text_fit(f->run, d->label, CMP_LABEL + 1);
  TRY(lines_scaled(walls, s->H, &d->walls));
  TRY(surfaces(f, s, depth, window, d));
  TRY(energies(f, s, d));
  TRY(terms(f, s, d));
  d->n_probes = f->n_probes;
  TRY(series_list(f->probes, f->n_probes, s, "Pa", &d->probes));
  d->n_gauges = f->n_gauges;
  TRY(series_list(f->gauges, f->n_gauges, s, "m", &d->gauges));
  TRY(points(f, s, d));
  d->n_diagnostics = f->n_diagnostics;
  TRY(series_list(f->diagnostics, f->n_diagnostics, s, NULL, &d->diagnostics));
  TRY(experiments(f, s, d));
  instants(f, s, depth, window, d);
  return OK;
}

void cmp_data_destroy(struct cmp_data *d) {
  if (!d) return;
  for (size_t i = 0; d->surface && i < d->n; i++) geo_lines_destroy(&d->surface[i]);
  free(d->t);
  free(d->surface);
  free(d->jet);
  geo_lines_destroy(&d->walls);
  struct cmp_series *single[] = {&d->kinetic,  &d->potential, &d->mechanical,
                                 &d->internal, &d->closure,   &d->removed,
                                 &d->volume,   &d->fronts[0], &d->fronts[1]};
  for (size_t k = 0; k < sizeof single / sizeof *single; k++) series_free(single[k]);
  struct {
    struct cmp_series *s;
    size_t n;
  } list[] = {{d->terms, d->n_terms},
              {d->probes, d->n_probes},
              {d->gauges, d->n_gauges},
              {d->points, d->n_points},
              {d->diagnostics, d->n_diagnostics},
              {d->experiments, d->n_experiments}};
  for (size_t k = 0; d->points && k < d->n_points; k++) free((char *)d->points[k].name);
  for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
    for (size_t i = 0; list[k].s && i < list[k].n; i++) series_free(&list[k].s[i]);
    free(list[k].s);
  }
}

/* ---- the side and the time that are compared ---- */

/* How far the front on this side moves until it stands at its wall; -1 when the bed before it is
 * not dry at first. */
static double run_length(const struct cmp_data *d, enum cmp_side side, double depth) {
  const struct cmp_series *front = &d->fronts[side];
  const double sign = side == CMP_RIGHT ? 1 : -1, foot = cmp_bed_foot(&d->walls, side);
  double furthest = 0;
  if (!front->n || !d->n || front->t[0] > d->t[0] || sign * (foot - front->value[0]) <= depth)
    return -1;
  for (size_t i = 0; i < front->n; i++)
    furthest = fmax(furthest, sign * (front->value[i] - front->value[0]));
  return furthest;
}

enum cmp_side cmp_data_side(const struct cmp_data *d, double depth) {
  double left = run_length(d, CMP_LEFT, depth), right = run_length(d, CMP_RIGHT, depth);
  if (fmax(left, right) <= depth) return CMP_NO_SIDE; /* known to no better than this */
  return right >= left ? CMP_RIGHT : CMP_LEFT;
}

void cmp_data_face(struct cmp_data *d, const struct cmp_scales *s, enum cmp_side side) {
  struct geo_box box = geo_lines_box(&d->walls);
  double near = 1e-6 * (box.max[0] - box.min[0]);
  d->impact = (struct cmp_instant){
      cmp_unknown("the file has no event wall_impact"), NAN, false, {NAN, NAN}};
  if (side == CMP_NO_SIDE) {
    d->impact.time = cmp_unknown("no front runs to a wall");
    return;
  }
  d->front = d->fronts[side];
  for (size_t k = 0; k < d->file->n_events; k++) {
    const struct result_event_read *e = &d->file->events[k];
    const double at[2] = {e->x / s->H, e->y / s->H};
    if (strcmp(e->name, "wall_impact") || !cmp_bed_is_at_wall(&d->walls, side, at, near)) continue;
    d->impact = event_instant(e, s);
    return;
  }
}

static void series_cut(struct cmp_series *s, double until) {
  while (s->n && s->t[s->n - 1] > until) s->n--;
}

static void instant_cut(struct cmp_instant *i, double until) {
  if (cmp_known(&i->time) && i->time.value > until)
    *i = (struct cmp_instant){cmp_unknown("the run had failed by then"), NAN, false, {NAN, NAN}};
}

void cmp_data_cut(struct cmp_data *d, double until) {
  struct cmp_series *single[] = {&d->kinetic, &d->potential, &d->mechanical, &d->fronts[0],
                                 &d->fronts[1]};
  while (d->n && d->t[d->n - 1] > until) geo_lines_destroy(&d->surface[--d->n]);
  for (size_t k = 0; k < sizeof single / sizeof *single; k++) series_cut(single[k], until);
  for (size_t k = 0; k < d->n_probes; k++) series_cut(&d->probes[k], until);
  for (size_t k = 0; k < d->n_gauges; k++) series_cut(&d->gauges[k], until);
  for (size_t k = 0; k < d->n_points; k++) series_cut(&d->points[k], until);
  instant_cut(&d->overturning, until);
  instant_cut(&d->touchdown, until);
}

/* The errors of rows so near each other are taken to be of one sign: their mean is the mean's. */
static enum status error_average(struct cmp_series *s, double over) {
  const struct cmp_signal each = {s->n, s->t, s->error};
  double *mean = calloc(s->n + 1, sizeof *mean);
  CHECK(mean, ERR_MEMORY, "no memory for the errors of a series of %zu rows", s->n);
  const enum status status = cmp_signal_average(&each, over, mean);
  free(s->error);
  s->error = mean;
  return status;
}

static enum status series_average(struct cmp_series *s, double over) {
  struct cmp_signal raw = cmp_series_signal(s);
  double *mean = calloc(s->n + 1, sizeof *mean);
  CHECK(mean, ERR_MEMORY, "no memory for the mean of a series of %zu rows", s->n);
  s->raw = s->value;
  s->value = mean;
  s->average = over;
  TRY(cmp_signal_average(&raw, over, mean));
  return s->error ? error_average(s, over) : OK;
}

enum status cmp_data_average(struct cmp_data *d, const char *probe, double over) {
  for (size_t k = 0; k < d->n_probes; k++)
    if (!strcmp(d->probes[k].name, probe)) TRY(series_average(&d->probes[k], over));
  for (size_t k = 0; k < d->n_experiments; k++)
    if (!strcmp(d->file->experiments[k].target, probe))
      TRY(series_average(&d->experiments[k], over));
  return OK;
}

struct cmp_value cmp_data_energy(const struct cmp_data *d, const struct cmp_series *s, double t) {
  struct cmp_signal signal = cmp_series_signal(s);
  double interval = s->n > 1 ? (s->t[s->n - 1] - s->t[0]) / (double)(s->n - 1) : 0;
  if (s->n && t > s->t[s->n - 1] && t <= s->t[s->n - 1] + 2 * interval + 1e-6) t = s->t[s->n - 1];
  double v = cmp_signal_at(&signal, t);
  if (isfinite(v)) return cmp_number(v);
  if (s->n && t >= s->t[0] && t <= s->t[s->n - 1])
    return cmp_unknown("an energy of %.40s at t* = %.4g is not a number", d->label, t);
  return s->n ? cmp_unknown("%.40s has no energies at t* = %.4g (its last: %.4g)", d->label, t,
                            s->t[s->n - 1])
              : cmp_unknown("%.60s has no energies", d->label);
}

size_t cmp_data_output(const struct cmp_data *d, double t, double slack) {
  size_t best = SIZE_MAX;
  for (size_t i = 0; i < d->n; i++)
    if (fabs(d->t[i] - t) <= slack &&
        (best == SIZE_MAX || fabs(d->t[i] - t) < fabs(d->t[best] - t)))
      best = i;
  return best;
}

double cmp_data_interval(const struct cmp_data *d) {
  if (d->n < 2) return 0;
  double *gap = malloc(d->n * sizeof *gap),
         median = (d->t[d->n - 1] - d->t[0]) / (double)(d->n - 1);
  if (!gap) return median;
  for (size_t i = 0; i + 1 < d->n; i++) gap[i] = d->t[i + 1] - d->t[i];
  qsort(gap, d->n - 1, sizeof *gap, array_ascending);
  median = gap[(d->n - 1) / 2];
  free(gap);
  return median;
}

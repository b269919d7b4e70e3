#include "compare/comparison.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/surfaces.h"

/* ---- what is compared where and when ---- */

struct case_file cmp_settings_at(const struct case_file *settings, const struct geo_box *window,
                                 double *times, size_t n) {
  struct case_file s = settings ? *settings : (struct case_file){0};
  const struct geo_box all = {{-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
  memset(&s.compare, 0, sizeof s.compare);
  s.compare.window = window ? *window : all;
  s.compare.times = times;
  s.compare.n_times = n;
  return s;
}

static enum status times_set(struct comparison *c) {
  const struct case_file *s = c->settings;
  size_t room = s->compare.n_times + s->compare.n_tolerances + 3, n = 0;
  c->times = malloc(room * sizeof *c->times);
  CHECK(c->times, ERR_MEMORY, "no memory for %zu comparison times", room);
  for (size_t i = 0; i < s->compare.n_times; i++) c->times[n++] = s->compare.times[i] / c->scales.T;
  for (size_t i = 0; i < s->compare.n_tolerances; i++)
    if (isfinite(s->compare.tolerances[i].at))
      c->times[n++] = s->compare.tolerances[i].at / c->scales.T;
  const struct cmp_data *ref = &c->ref.data;
  if (!n && ref->n) /* nothing asked: the outputs nearest to the thirds of the reference's time */
    for (size_t k = 1; k <= 3; k++)
      c->times[n++] = ref->t[cmp_data_output(ref, ref->t[ref->n - 1] * (double)k / 3, INFINITY)];
  qsort(c->times, n, sizeof *c->times, array_ascending);
  c->n_times = 0;
  for (size_t i = 0; i < n; i++)
    if (!c->n_times || c->times[i] - c->times[c->n_times - 1] > 1e-6)
      c->times[c->n_times++] = c->times[i];
  return OK;
}

static void box_join(struct geo_box *a, const struct geo_box *b) {
  for (int k = 0; k < 2; k++) {
    a->min[k] = fmin(a->min[k], b->min[k]);
    a->max[k] = fmax(a->max[k], b->max[k]);
  }
}

/* Makes the window finite: GEOS needs it so. */
static void window_set(struct comparison *c) {
  struct geo_box all = geo_lines_box(&c->ref.data.walls);
  for (size_t r = 0; r <= c->n_runs; r++) {
    const struct cmp_data *d = r < c->n_runs ? &c->run[r].data : &c->ref.data;
    for (size_t i = 0; i < d->n; i++)
      if (d->surface[i].points) {
        struct geo_box box = geo_lines_box(&d->surface[i]);
        box_join(&all, &box);
      }
  }
  c->window_whole = true;
  for (int k = 0; k < 2; k++) {
    if (c->window.min[k] > all.min[k] || c->window.max[k] < all.max[k]) c->window_whole = false;
    c->window.min[k] = fmax(c->window.min[k], all.min[k] - 1);
    c->window.max[k] = fmin(c->window.max[k], all.max[k] + 1);
  }
}

static void labels_make_unique(struct comparison *c) {
  for (size_t r = c->n_runs; r-- > 0;) { /* from the last: those before it are as they were */
    char *label = c->run[r].data.label;
    const size_t room = sizeof c->run[r].data.label, n = strlen(label);
    unsigned copies = 1 + !strcmp(c->ref.data.label, label);
    for (size_t q = 0; q < r; q++) copies += !strcmp(c->run[q].data.label, label);
    if (copies > 1) snprintf(label + n, room - n, " (%u)", copies);
  }
}

/* ---- surfaces ---- */

/* Keeps the longest of the stretches [from, to] of outputs without a distance. */
static void gap_take(double *longest, double from, double to) {
  if (to - from <= longest[1] - longest[0]) return;
  longest[0] = from;
  longest[1] = to;
}

/* Why there is no distance at any output of the run. */
static struct cmp_value nothing_shared(const struct comparison *c, const struct cmp_run *run) {
  const struct cmp_data *a = &run->data, *b = &c->ref.data;
  double off = INFINITY;
  for (size_t i = 0; i < a->n && b->n; i++) {
    const double here = a->t[i] - b->t[cmp_data_output(b, a->t[i], INFINITY)];
    if (fabs(here) < fabs(off)) off = here;
  }
  if (run->evolution.n || !isfinite(off)) return cmp_unknown("no surfaces at common times");
  return cmp_unknown("no outputs at common times: the nearest is %.3g s %s one of the reference "
                     "(see time_offset)",
                     fabs(off) * c->scales.T, off < 0 ? "before" : "after");
}

static void off_measure(const struct comparison *c, struct cmp_run *run) {
  const struct cmp_evolution *e = &run->evolution;
  const double *mean = e->value[CMP_MEASURE_mean_distance];
  double worst = NAN;
  run->unseen[0] = run->unseen[1] = NAN;
  for (size_t i = 0, next = 0; i < e->n; i++) { /* next: after the last output with a distance */
    worst = fmax(worst, mean[i]);
    if (isfinite(mean[i]))
      next = i + 1;
    else
      gap_take(run->unseen, e->t[next], e->t[i]);
  }
  run->off = !cmp_known(&c->motion) ? c->motion
             : isfinite(worst)      ? cmp_number(worst / c->motion.value)
                                    : nothing_shared(c, run);
}

/* Until when the mean distance stays within one particle spacing, linear between outputs that
 * follow each other; it is not known to stay any longer than before outputs that cannot be
 * compared. */
static void agreement_measure(const struct comparison *c, struct cmp_run *run) {
  const struct cmp_evolution *e = &run->evolution;
  const double *mean = e->value[CMP_MEASURE_mean_distance];
  double limit = 2 * run->noise;
  size_t last = SIZE_MAX; /* the last output with a distance */
  run->blind[0] = run->blind[1] = NAN;
  run->agreement = nothing_shared(c, run);
  for (size_t i = 0; i < e->n; i++) {
    if (!isfinite(mean[i])) continue;
    size_t next = last == SIZE_MAX ? 0 : last + 1;
    bool leaves = mean[i] > limit;
    if (i > next) gap_take(run->blind, e->t[next], e->t[i - 1]);
    if (leaves) {
      double t = e->t[i];
      if (last != SIZE_MAX)
        t = e->t[last] +
            (i > next ? 0 : (limit - mean[last]) / (mean[i] - mean[last]) * (t - e->t[last]));
      run->agreement = cmp_number(t);
      return;
    }
    last = i;
  }
  if (last == SIZE_MAX) return;
  if (last + 1 < e->n) gap_take(run->blind, e->t[last + 1], e->t[e->n - 1]);
  run->agreement = cmp_unknown("it never leaves it");
}

/* ---- energy, volume ---- */

static struct cmp_value largest_magnitude(const struct cmp_series *s, double until) {
  double worst = -1;
  for (size_t i = 0; i < s->n && s->t[i] <= until; i++) {
    if (!isfinite(s->value[i])) return cmp_unknown("the energies are not all numbers");
    worst = fmax(worst, fabs(s->value[i]));
  }
  return worst >= 0 ? cmp_number(worst) : cmp_unknown("the file has no energies then");
}

static void budget_measure(const struct comparison *c, struct cmp_run *run) {
  const struct cmp_value *impact = &c->ref.data.impact.time;
  run->closure = largest_magnitude(&run->data.closure, INFINITY);
  run->closure_before =
      cmp_known(impact) ? largest_magnitude(&run->data.closure, impact->value) : *impact;
  const struct cmp_series *v = &run->data.volume;
  double worst = 0;
  for (size_t i = 0; i < v->n; i++) worst = fmax(worst, fabs(v->value[i] / v->value[0] - 1));
  run->volume = v->n ? cmp_number(worst) : cmp_unknown("the file has no volumes");
}

/* ---- signals ---- */

static void pair_add(struct cmp_run *run, const struct cmp_series *a, const struct cmp_series *b,
                     size_t experiment, enum cmp_quantity quantity) {
  struct cmp_pair *pair = &run->pairs[run->n_pairs++];
  *pair = (struct cmp_pair){.a = a, .b = b, .experiment = experiment, .quantity = quantity};
  struct cmp_signal x = cmp_series_signal(a), y = cmp_series_signal(b);
  cmp_signal_compare(&x, &y, CMP_ONSET, CMP_SHIFT_REACH, &pair->m);
}

static enum status pairs_measure(const struct comparison *c, struct cmp_run *run) {
  const struct cmp_data *ref = &c->ref.data, *d = &run->data;
  run->pairs = calloc(d->n_probes + d->n_gauges + ref->n_experiments + 1, sizeof *run->pairs);
  CHECK(run->pairs, ERR_MEMORY, "no memory for the comparison of signals");
  for (int kind = 0; kind < 2 && run != &c->ref; kind++) {
    const struct cmp_series *mine = kind ? d->gauges : d->probes;
    const struct cmp_series *its = kind ? ref->gauges : ref->probes;
    for (size_t k = 0; k < (kind ? d->n_gauges : d->n_probes); k++) {
      const struct cmp_series *b =
          cmp_series_find(its, kind ? ref->n_gauges : ref->n_probes, mine[k].name);
      if (b) pair_add(run, &mine[k], b, SIZE_MAX, kind ? CMP_ELEVATION : CMP_PRESSURE);
    }
  }
  for (size_t k = 0; k < ref->n_experiments; k++) {
    const char *target = ref->file->experiments[k].target;
    const struct cmp_series *probe = cmp_series_find(d->probes, d->n_probes, target);
    const struct cmp_series *gauge = cmp_series_find(d->gauges, d->n_gauges, target);
    if (probe)
      pair_add(run, probe, &ref->experiments[k], k, CMP_PRESSURE);
    else if (gauge)
      pair_add(run, gauge, &ref->experiments[k], k, CMP_ELEVATION);
    else if (!strcmp(target, "front"))
      pair_add(run, &d->front, &ref->experiments[k], k, CMP_FRONT);
  }
  return OK;
}

/* Of raw signals: spectra, where the run has the series, and filters. */
static enum status signals_take(const struct comparison *c, struct cmp_run *run) {
  const struct case_file *s = c->settings;
  run->spectrum = calloc(s->compare.n_spectra + 1, sizeof *run->spectrum);
  CHECK(run->spectrum, ERR_MEMORY, "no memory for %zu spectra", s->compare.n_spectra);
  for (size_t k = 0; k < s->compare.n_spectra; k++) {
    const struct case_spectrum *asked = &s->compare.spectra[k];
    const struct cmp_series *series = cmp_data_series(&run->data, asked->series);
    run->spectrum[k].interval = cmp_unknown("the run has no series of that name");
    if (!series) continue;
    const struct cmp_signal raw = cmp_series_raw(series);
    TRY(cmp_spectrum_create(&raw, asked->from / c->scales.T, asked->to / c->scales.T, asked->peaks,
                            &run->spectrum[k]));
  }
  return cmp_filters_take(s, &run->data, c->scales.T, c->scales.H, CMP_ONSET, &run->filtered);
}

/* ---- all of it ---- */

static enum status run_measure(const struct comparison *c, struct cmp_run *run) {
  agreement_measure(c, run);
  off_measure(c, run);
  budget_measure(c, run);
  return pairs_measure(c, run);
}

static bool near(double a, double b) {
  return fabs(a / b - 1) < 1e-9;
}

/* A file without walls is taken to be of any tank. */
static bool same_walls(const struct result_file *a, const struct result_file *b) {
  if (!a->walls.pieces || !b->walls.pieces) return true;
  if (a->walls.points != b->walls.points || a->walls.pieces != b->walls.pieces) return false;
  for (size_t i = 0; i < a->walls.points; i++)
    for (int k = 0; k < 2; k++)
      if (fabs(a->walls.p[i][k] - b->walls.p[i][k]) > 1e-9 * a->H) return false;
  return true;
}

/* What the run does not share with the reference, or NULL. Files of before the fingerprint are
 * known by their scales and walls only. */
static const char *strange(const struct result_file *ref, const struct result_file *run) {
  if (!near(run->H, ref->H) || !near(run->g, ref->g) || !near(run->density, ref->density))
    return "H, g or density (plunge info shows them)";
  if (!same_walls(ref, run)) return "tank";
  bool told = *ref->water_fingerprint && *run->water_fingerprint;
  return told && strcmp(ref->water_fingerprint, run->water_fingerprint) ? "water at t = 0" : NULL;
}

static enum status run_admit(const struct result_file *ref, const struct result_file *run,
                             bool anyway, bool *foreign) {
  const char *what = strange(ref, run);
  *foreign = what != NULL;
  CHECK(!what || anyway, ERR_INPUT,
        "%s has another %s than the reference %s: they are not of the same case; --anyway compares "
        "them all the same",
        run->path, what, ref->path);
  return OK;
}

/* After what cannot be believed has gone: a mean holds what comes after it too. */
static enum status averages_take(const struct comparison *c, struct cmp_data *d) {
  const struct case_file *s = c->settings;
  for (size_t k = 0; k < s->compare.n_averages; k++) {
    const struct case_average *a = &s->compare.averages[k];
    if (a->over > 0) TRY(cmp_data_average(d, s->probes[a->probe].name, a->over / c->scales.T));
  }
  return OK;
}

/* The walls of the first file that has any. */
static enum status tank_find(struct comparison *c, const struct result_file *ref, size_t n,
                             struct result_file *const *runs) {
  c->tank = &ref->walls;
  for (size_t r = 0; r < n && !c->tank->pieces; r++) c->tank = &runs[r]->walls;
  CHECK(c->tank->pieces, ERR_INPUT,
        "neither %s nor any other file has /walls: add them to one (docs/result-file.md), since "
        "only a tank says which side of a surface is water",
        ref->path);
  return OK;
}

/* The scales, the depth of fronts, the reference as far as it can be believed. */
static enum status reference_take(struct comparison *c, const struct result_file *ref, size_t n,
                                  struct result_file *const *runs) {
  TRY(tank_find(c, ref, n, runs));
  double coarsest = n ? 0 : ref->spacing / ref->H;
  TRY(cmp_scales_set(ref, &c->scales));
  for (size_t r = 0; r < n; r++) coarsest = fmax(coarsest, runs[r]->spacing / runs[r]->H);
  c->depth = 2 * coarsest;
  for (int k = 0; k < 2; k++) {
    c->window.min[k] = c->settings->compare.window.min[k] / c->scales.H;
    c->window.max[k] = c->settings->compare.window.max[k] / c->scales.H;
  }
  TRY(cmp_data_create(ref, c->tank, &c->scales, c->depth, &c->window, &c->ref.data));
  health_of_file(ref, &c->ref.health);
  c->until = health_since(ref, HEALTH_FAILED) / c->scales.T;
  cmp_data_cut(&c->ref.data, c->until);
  TRY(averages_take(c, &c->ref.data));
  TRY(signals_take(c, &c->ref));
  c->side = cmp_data_side(&c->ref.data, c->depth);
  cmp_data_face(&c->ref.data, &c->scales, c->side);
  return OK;
}

static enum status run_take(struct comparison *c, const struct result_file *file, bool anyway,
                            struct cmp_run *run) {
  TRY(run_admit(c->ref.data.file, file, anyway, &run->foreign));
  struct cmp_scales own = cmp_scales_of(&c->scales, file);
  const struct geo_lines *walls = file->walls.pieces ? &file->walls : c->tank;
  TRY(cmp_data_create(file, walls, &own, c->depth, &c->window, &run->data));
  TRY(averages_take(c, &run->data));
  TRY(signals_take(c, run));
  cmp_data_face(&run->data, &own, c->side);
  health_of_file(file, &run->health);
  return OK;
}

enum status cmp_comparison_open(const struct case_file *settings, const struct result_file *ref,
                                size_t n, struct result_file *const *runs, bool anyway,
                                struct comparison **out) {
  enum status status = OK;
  struct comparison *c = calloc(1, sizeof *c);
  *out = NULL;
  CHECK(c, ERR_MEMORY, "no memory for a comparison");
  c->settings = settings;
  c->run = calloc(n + 1, sizeof *c->run);
  if (!c->run) {
    status = status_raise(ERR_MEMORY, "no memory for a comparison of %zu runs", n);
    goto done;
  }
  ATTEMPT(reference_take(c, ref, n, runs));
  for (size_t r = 0; r < n; r++) {
    c->n_runs = r + 1;
    ATTEMPT(run_take(c, runs[r], anyway, &c->run[r]));
  }
  labels_make_unique(c);
  ATTEMPT(times_set(c));
  window_set(c);
  c->ref.noise = c->ref.data.dx / 2;
  for (size_t r = 0; r < n; r++) c->run[r].noise = c->run[r].data.dx / 2;
  ATTEMPT(cmp_surfaces_choose(c));
done:
  if (status != OK) {
    cmp_comparison_destroy(c);
    c = NULL;
  }
  *out = c;
  return status;
}

static enum status measure(struct comparison *c) {
  TRY(cmp_surfaces_motion(c));
  budget_measure(c, &c->ref);
  TRY(pairs_measure(c, &c->ref));
  TRY(cmp_surfaces_measure(c));
  for (size_t r = 0; r < c->n_runs; r++) TRY(run_measure(c, &c->run[r]));
  return OK;
}

enum status cmp_comparison_create(const struct case_file *settings, const struct result_file *ref,
                                  size_t n, struct result_file *const *runs, bool anyway,
                                  struct comparison **out) {
  TRY(cmp_comparison_open(settings, ref, n, runs, anyway, out));
  const enum status status = measure(*out);
  if (status == OK) return OK;
  cmp_comparison_destroy(*out);
  *out = NULL;
  return status;
}

static void run_destroy(const struct comparison *c, struct cmp_run *run) {
  for (size_t k = 0; run->spectrum && k < c->settings->compare.n_spectra; k++)
    cmp_spectrum_destroy(&run->spectrum[k]);
  free(run->spectrum);
  cmp_filters_destroy(c->settings->compare.n_filters, run->filtered);
  cmp_data_destroy(&run->data);
  free(run->at);
  free(run->evolution.t);
  for (size_t m = 0; m < CMP_N_MEASURES; m++) free(run->evolution.value[m]);
  free(run->pairs);
}

void cmp_comparison_destroy(struct comparison *c) {
  if (!c) return;
  run_destroy(c, &c->ref);
  for (size_t r = 0; c->run && r < c->n_runs; r++) run_destroy(c, &c->run[r]);
  free(c->run);
  free(c->times);
  free(c);
}

bool cmp_comparison_has_output(const struct comparison *c, size_t time) {
  for (size_t r = 0; r < c->n_runs; r++)
    if (c->run[r].at[time].output != SIZE_MAX) return true;
  return false;
}

bool cmp_comparison_has_front(const struct comparison *c) {
  return c->side != CMP_NO_SIDE;
}

double cmp_comparison_settled(const struct comparison *c) {
  const struct cmp_value *impact = &c->ref.data.impact.time;
  return cmp_known(impact) ? impact->value : 0;
}

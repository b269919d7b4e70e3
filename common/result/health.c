#include "common/result/health.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const char *const health_verdicts[] = {"sound", "doubtful", "failed"};

const struct health_measure health_measures[HEALTH_N] = {
#define X(name, doubtful, failed, percent, label, before, after, help)                             \
  {#name, doubtful, failed, percent, label, before, after, help},
    HEALTH_MEASURES(X)
#undef X
};

/* Of the potential energy: what is less above rest is not told from the rounding of the sums, nor
 * from the layers of particles in which water at rest is set up, (g H/c0^2) (dx/H)^2/6 of it. */
static const double AT_REST = 1e-6;

double health_energy_scale(const struct result_energy *first, double rest, double column,
                           bool *at_rest) {
  double above = first ? first->kinetic + first->potential - rest : 0;
  *at_rest = !(above > AT_REST * fmax(column, first ? fabs(first->potential) : 0));
  return *at_rest ? column : above;
}

/* ---- gathering ---- */

void health_watch_begin(struct health_watch *w, double rest, double column) {
  *w = (struct health_watch){.rest = rest, .column = column, .numbers = true};
  w->mach = w->lightest = w->heaviest = w->spilled = w->lost = w->cut = w->steps = w->theory = NAN;
}

/* What the water has, less what a tank that moves gave it. */
static double stored(const struct health_watch *w, const struct result_energy *e) {
  double sum = e->kinetic + e->potential + e->internal + e->removed;
  for (size_t k = 0; k < RESULT_TERMS; k++)
    if (w->outside[k]) sum += e->term[k];
  return sum;
}

void health_watch_energy(struct health_watch *w, const struct result_energy *row) {
  if (w->n_energy++ == 0) w->first = *row;
  if (!isfinite(result_energy_budget(row))) w->numbers = false;
  w->gained = fmax(w->gained, stored(w, row) - stored(w, &w->first));
  w->worst_budget =
      fmax(w->worst_budget, fabs(result_energy_budget(row) - result_energy_budget(&w->first)));
  w->elastic = fmax(w->elastic, fabs(row->internal));
}

void health_watch_step(struct health_watch *w, const struct result_step *row) {
  double volume = row->volume + row->removed_volume;
  if (w->n_steps++ == 0) w->volume = volume;
  if (!isfinite(volume)) w->numbers = false;
  w->volume_change = fmax(w->volume_change, fabs(volume - w->volume));
  w->removed = fmax(w->removed, row->removed_volume);
}

void health_watch_statistic(struct health_watch *w, const char *name, double value) {
  const struct {
    const char *name;
    double *to;
  } facts[] = {{"largest_mach", &w->mach},
               {"lowest_density", &w->lightest},
               {"highest_density", &w->heaviest},
               {"steps_cut", &w->cut},
               {"steps", &w->steps},
               {"cvode_steps", &w->steps},
               {"spilled_volume", &w->spilled},
               {"lost_volume", &w->lost},
               {"theory_error", &w->theory}};
  for (size_t k = 0; k < sizeof facts / sizeof *facts; k++)
    if (!strcmp(name, facts[k].name)) *facts[k].to = value;
}

/* ---- judging ---- */

/* The part of the measures that the series tell. */
static void measure_series(const struct health_watch *w, double *value) {
  bool at_rest;
  double E = health_energy_scale(&w->first, w->rest, w->column, &at_rest);
  if (w->n_energy) {
    value[HEALTH_energy_gained] = w->gained / E;
    value[HEALTH_budget] = w->worst_budget / E;
  }
  if (!w->n_steps || !(w->volume > 0)) return;
  value[HEALTH_volume_change] = w->volume_change / w->volume;
  double told = (isnan(w->spilled) ? 0 : w->spilled) + (isnan(w->lost) ? 0 : w->lost);
  value[HEALTH_cut_away] = fmax(0, w->removed - told) / w->volume;
}

static void measure(const struct health_watch *w, double *value) {
  for (size_t k = 0; k < HEALTH_N; k++) value[k] = NAN;
  measure_series(w, value);
  value[HEALTH_mach] = w->mach;
  value[HEALTH_density_change] = fmax(1 - w->lightest, w->heaviest - 1); /* of the one told */
  if (w->volume > 0) {
    value[HEALTH_spilled] = w->spilled / w->volume;
    value[HEALTH_lost] = w->lost / w->volume;
  }
  if (w->steps > 0) value[HEALTH_steps_cut] = w->cut / w->steps;
  value[HEALTH_theory_error] = w->theory;
}

/* Of a theory, what energy rises and the budget is off by is its own error: it is judged as that.
 */
static size_t judged_as(size_t k, const struct health *h) {
  bool energy = k == HEALTH_energy_gained || k == HEALTH_budget;
  return energy && isfinite(h->value[HEALTH_theory_error]) ? HEALTH_theory_error : k;
}

static enum health_verdict verdict_of(size_t k, double value) {
  return value > health_measures[k].failed     ? HEALTH_FAILED
         : value > health_measures[k].doubtful ? HEALTH_DOUBTFUL
                                               : HEALTH_SOUND;
}

/* Adds to a list of things in words; what does not fit is cut. */
__attribute__((format(printf, 4, 5))) static void
append(char *text, size_t room, const char *separator, const char *format, ...) {
  size_t n = strlen(text);
  if (n) n += (size_t)snprintf(text + n, room - n, "%s", separator);
  if (n >= room) return;
  va_list args;
  va_start(args, format);
  vsnprintf(text + n, room - n, format, args);
  va_end(args);
}

static void judge_measure(size_t k, struct health *h) {
  const struct health_measure *m = &health_measures[k];
  const struct health_measure *limits = &health_measures[judged_as(k, h)];
  enum health_verdict verdict = verdict_of(judged_as(k, h), h->value[k]);
  double value = h->value[k] * (m->percent ? 100 : 1);
  double limit =
      (verdict == HEALTH_FAILED ? limits->failed : limits->doubtful) * (m->percent ? 100 : 1);
  const char *unit = m->percent ? " %" : k == HEALTH_mach ? "" : " E0";
  if (value > 0) append(h->facts, sizeof h->facts, ", ", "%s %.3g%s", m->label, value, unit);
  if (verdict == HEALTH_SOUND) return;
  append(h->reasons, sizeof h->reasons, "; ", "%s %.3g%s (%s beyond %g%s)", m->before, value,
         m->after, health_verdicts[verdict], limit, unit);
  if (verdict > h->verdict) h->verdict = verdict;
}

/* Incompressible water has neither sound nor another density nor particles that slip through a
 * wall; theory, which alone has an error of its own, neither spills nor steps. */
static bool applies(size_t k, const struct health_watch *w) {
  if (k == HEALTH_mach || k == HEALTH_density_change || k == HEALTH_lost) return w->elastic > 0;
  if (k == HEALTH_spilled || k == HEALTH_steps_cut) return isnan(w->theory);
  return k != HEALTH_theory_error;
}

void health_judge(const struct health_watch *w, const char *broke_off, struct health *h) {
  memset(h, 0, sizeof *h);
  measure(w, h->value);
  if (*broke_off) append(h->reasons, sizeof h->reasons, "; ", "it broke off: %s", broke_off);
  h->broke_off = strlen(h->reasons);
  if (!w->numbers)
    append(h->reasons, sizeof h->reasons, "; ", "its energies or volumes are not all numbers");
  if (*broke_off || !w->numbers) h->verdict = HEALTH_FAILED;
  for (size_t k = 0; k < HEALTH_N; k++)
    if (isfinite(h->value[k]) || h->value[k] > 0)
      judge_measure(k, h);
    else if (applies(k, w))
      append(h->missing, sizeof h->missing, ", ", "%s", health_measures[k].label);
}

const char *health_word(const struct health *h) {
  bool told = h->verdict != HEALTH_SOUND;
  for (size_t k = 0; k < HEALTH_N; k++) told = told || !isnan(h->value[k]);
  return told ? health_verdicts[h->verdict] : "not known";
}

const char *health_other_reasons(const struct health *h) {
  const char *rest = h->reasons + h->broke_off;
  return rest + (h->broke_off ? strspn(rest, "; ") : 0);
}

/* ---- of a file ---- */

static void watch_file(const struct result_file *f, struct health_watch *w) {
  health_watch_begin(w, f->rest_potential, f->density * f->g * f->H * f->H * f->H);
  for (size_t k = 0; k < f->n_terms; k++) w->outside[k] = f->terms[k].outside;
}

/* A run that was stopped by its user says why it ended too, but its own verdict does not fail. */
static const char *broke_off(const struct result_file *f) {
  bool fine = f->complete || !strcmp(f->health, health_verdicts[HEALTH_SOUND]) ||
              !strcmp(f->health, health_verdicts[HEALTH_DOUBTFUL]);
  return fine ? "" : f->ended;
}

void health_of_file(const struct result_file *f, struct health *h) {
  struct health_watch w;
  watch_file(f, &w);
  for (size_t i = 0; i < f->n_energy; i++) health_watch_energy(&w, &f->energy[i]);
  for (size_t i = 0; i < f->n_steps; i++) health_watch_step(&w, &f->steps[i]);
  for (size_t i = 0; i < f->n_statistics; i++)
    health_watch_statistic(&w, f->statistics[i].name, f->statistics[i].value);
  health_judge(&w, broke_off(f), h);
}

double health_since(const struct result_file *f, enum health_verdict verdict) {
  struct health_watch w;
  watch_file(f, &w);
  for (size_t i = 0, j = 0; i < f->n_energy || j < f->n_steps;) {
    bool energy = j == f->n_steps || (i < f->n_energy && f->energy[i].time <= f->steps[j].time);
    double t = energy ? f->energy[i].time : f->steps[j].time, value[HEALTH_N] = {0};
    if (energy)
      health_watch_energy(&w, &f->energy[i++]);
    else
      health_watch_step(&w, &f->steps[j++]);
    measure_series(&w, value);
    if (!w.numbers) return t;
    for (size_t k = 0; k < HEALTH_N; k++)
      if (verdict_of(k, value[k]) >= verdict) return t;
  }
  return INFINITY;
}

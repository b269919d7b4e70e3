#include "compare/events.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/chart.h"

const char *cmp_check_units(const struct cmp_check *check) {
  return check->of->part == CASE_EVENT_time ? "sqrt(H/g)" : "H";
}

/* One that is read off the surfaces where the solver does not name it; NULL: another one. */
static const struct cmp_instant *instant_of(const struct cmp_data *d, int event) {
  return event == CASE_EVENT_OF_wall_impact   ? &d->impact
         : event == CASE_EVENT_OF_overturning ? &d->overturning
         : event == CASE_EVENT_OF_touchdown   ? &d->touchdown
                                              : NULL;
}

static struct cmp_value of_file(const struct comparison *c, const struct result_file *f,
                                const struct case_event *e) {
  const char *name = case_event_names[e->event];
  for (size_t k = 0; k < f->n_events; k++) {
    const struct result_event_read *at = &f->events[k];
    if (strcmp(at->name, name) != 0) continue;
    return cmp_number(e->part == CASE_EVENT_time
                          ? at->time / c->scales.T
                          : (e->part == CASE_EVENT_x ? at->x : at->y) / c->scales.H);
  }
  return cmp_unknown("the run has no event %s", name);
}

struct cmp_value cmp_event_value(const struct comparison *c, const struct cmp_data *d,
                                 const struct case_event *e) {
  const struct cmp_instant *i = instant_of(d, e->event);
  if (!i) return of_file(c, d->file, e);
  if (e->part == CASE_EVENT_time || !cmp_known(&i->time)) return i->time;
  const double at = i->at[e->part - CASE_EVENT_x];
  return isfinite(at) ? cmp_number(at) : cmp_unknown("where it was is not known");
}

static bool concerns(const struct comparison *c, const struct case_event *e, size_t run) {
  const char *name = cmp_run_or_ref(c, run)->data.file->run;
  for (size_t k = 0; k < e->n_runs; k++)
    if (!strcmp(c->settings->runs[e->runs[k]].name, name)) return true;
  return !e->n_runs;
}

static struct cmp_check check_make(const struct comparison *c, const struct case_event *e,
                                   size_t run) {
  const double unit = e->part == CASE_EVENT_time ? c->scales.T : c->scales.H;
  struct cmp_check k = {
      .of = e, .run = run, .published = e->value / unit, .within = e->within / unit};
  k.value = cmp_event_value(c, &cmp_run_or_ref(c, run)->data, e);
  k.passed = fabs(k.value.value - k.published) <= k.within;
  return k;
}

enum status cmp_checks_create(const struct comparison *c, struct cmp_checks *checks) {
  const size_t events = c->settings->compare.n_events;
  *checks = (struct cmp_checks){0};
  TRY(array_create(&checks->check, events * (c->n_runs + 1), "checks of events"));
  for (size_t i = 0; i < events; i++)
    for (size_t r = 0; r <= c->n_runs; r++) {
      const struct case_event *e = &c->settings->compare.events[i];
      const size_t run = r ? r - 1 : SIZE_MAX;
      if (concerns(c, e, run)) checks->check[checks->n++] = check_make(c, e, run);
    }
  return OK;
}

void cmp_checks_destroy(struct cmp_checks *checks) {
  free(checks->check);
  *checks = (struct cmp_checks){0};
}

#include "compare/convergence/numbers.h"

#include <stdint.h>

#include "compare/chart.h"
#include "compare/events.h"

static const struct cmp_data *data_of(const struct comparison *c, size_t member) {
  return &cmp_run_or_ref(c, member)->data;
}

/* The output that is compared at that time; SIZE_MAX: none. */
static size_t output_of(const struct comparison *c, size_t member, size_t time) {
  if (member != SIZE_MAX) return c->run[member].at[time].output;
  const struct cmp_data *d = &c->ref.data;
  return cmp_data_output(d, c->times[time], cmp_data_interval(d) / 2);
}

static struct cmp_value jet_number(const struct comparison *c, size_t member, size_t time,
                                   struct cmp_value (*value)(const struct cmp_jet *)) {
  const size_t output = output_of(c, member, time);
  if (output == SIZE_MAX) return cmp_unknown("the run has no surface at that time");
  const struct cmp_jet *jet = &data_of(c, member)->jet[output];
  return jet->found ? value(jet) : cmp_unknown("its surface does not overhang");
}

static struct cmp_value tip_x(const struct cmp_jet *j) {
  return cmp_number(j->tip[0]);
}

static struct cmp_value tip_y(const struct cmp_jet *j) {
  return cmp_number(j->tip[1]);
}

static struct cmp_value overhang(const struct cmp_jet *j) {
  return cmp_number(j->overhang);
}

static struct cmp_value cavity(const struct cmp_jet *j) {
  return j->cavity;
}

/* ---- one function a number ---- */

#define ENERGY_OF(series)                                                                          \
  static struct cmp_value series##_energy(const struct comparison *c, size_t member,               \
                                          size_t time) {                                           \
    const struct cmp_data *d = data_of(c, member);                                                 \
    return cmp_data_energy(d, &d->series, c->times[time]);                                         \
  }
ENERGY_OF(kinetic)
ENERGY_OF(potential)
ENERGY_OF(mechanical)

static struct cmp_value front_position(const struct comparison *c, size_t member, size_t time) {
  if (c->side == CMP_NO_SIDE) return cmp_unknown("no front runs to a wall in the reference");
  const struct cmp_data *d = data_of(c, member);
  const struct cmp_signal front = cmp_series_signal(&d->front);
  const double impact = d->impact.time.value;
  const double x =
      c->times[time] <= impact || isnan(impact) ? cmp_signal_at(&front, c->times[time]) : NAN;
  return isfinite(x) ? cmp_number(x) : cmp_unknown("no front is on its way then");
}

static struct cmp_value jet_tip_x(const struct comparison *c, size_t member, size_t time) {
  return jet_number(c, member, time, tip_x);
}

static struct cmp_value jet_tip_y(const struct comparison *c, size_t member, size_t time) {
  return jet_number(c, member, time, tip_y);
}

static struct cmp_value jet_overhang(const struct comparison *c, size_t member, size_t time) {
  return jet_number(c, member, time, overhang);
}

static struct cmp_value jet_cavity_area(const struct comparison *c, size_t member, size_t time) {
  return jet_number(c, member, time, cavity);
}

const struct cmp_number cmp_numbers[CMP_N_NUMBERS] = {
#define X(name, units, section, help) {#name, units, CMP_SECTION_##section, name},
    CMP_INSTANT_NUMBERS(X)
#undef X
};

struct cmp_value cmp_event_number(const struct comparison *c, size_t member, int event, int part) {
  const struct case_event wanted = {.event = event, .part = part};
  return cmp_event_value(c, data_of(c, member), &wanted);
}

double cmp_event_known_to(const struct comparison *c, size_t member, int event, int part) {
  const struct cmp_data *d = data_of(c, member);
  const struct cmp_instant *instant = event == CASE_EVENT_OF_wall_impact   ? &d->impact
                                      : event == CASE_EVENT_OF_overturning ? &d->overturning
                                      : event == CASE_EVENT_OF_touchdown   ? &d->touchdown
                                                                           : NULL;
  return part == CASE_EVENT_time && instant && isfinite(instant->error) ? instant->error : 0;
}

double cmp_measure_known_to(const struct comparison *c, size_t member, size_t measure) {
  return measure == CMP_MEASURE_overturning_time
             ? cmp_event_known_to(c, member, CASE_EVENT_OF_overturning, CASE_EVENT_time)
         : measure == CMP_MEASURE_touchdown_time
             ? cmp_event_known_to(c, member, CASE_EVENT_OF_touchdown, CASE_EVENT_time)
             : 0;
}

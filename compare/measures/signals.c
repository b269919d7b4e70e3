/* Probes and gauges, against those of the reference and against experiments. */
#include "compare/measures/look.h"

#include <stdint.h>

enum number { RMS, PEAK, PEAK_TIME, ONSET, IMPULSE, SHIFT };

static struct cmp_value apart(const struct cmp_value *a, const struct cmp_value *b) {
  if (!cmp_known(a)) return *a;
  if (!cmp_known(b)) return *b;
  return cmp_number(fabs(a->value - b->value));
}

static struct cmp_value pair_number(const struct cmp_pair *p, enum number which) {
  switch (which) {
  case PEAK:
    return apart(&p->m.a.peak, &p->m.b.peak);
  case PEAK_TIME:
    return apart(&p->m.a.peak_time, &p->m.b.peak_time);
  case ONSET:
    return apart(&p->m.a.onset, &p->m.b.onset);
  case IMPULSE:
    return apart(&p->m.a.impulse, &p->m.b.impulse);
  case SHIFT: {
    struct cmp_value v = p->m.shift;
    if (cmp_known(&v)) v.value = fabs(v.value);
    return v;
  }
  default:
    return p->m.rms;
  }
}

/* "P1, mean over 0.05; without P2 (it never reaches the threshold) and 2 more" */
static void pairs_say(struct cmp_look *l, const struct cmp_pair *worst, const char *name,
                      const char *first_out, const struct cmp_value *why) {
  int n = worst->a->average > 0 ? snprintf(l->detail, l->detail_room, "%.36s, mean over %.3g", name,
                                           worst->a->average)
                                : snprintf(l->detail, l->detail_room, "%.58s", name);
  if (!first_out || n < 0 || (size_t)n >= l->detail_room) return;
  n += snprintf(l->detail + n, l->detail_room - (size_t)n, "; without %.30s (%.60s)", first_out,
                why->why);
  if (l->left_out > 1 && (size_t)n < l->detail_room)
    snprintf(l->detail + n, l->detail_room - (size_t)n, " and %zu more", l->left_out - 1);
}

/* The worst over those of the pairs wanted that have such a number; the others are named. When none
 * has, why the first has not. */
static struct cmp_value worst_pair(struct cmp_look *l, bool experiment, bool pressure,
                                   enum number which) {
  struct cmp_value worst = {NAN, ""}, why = {NAN, ""};
  const struct cmp_pair *found = NULL;
  const char *name = NULL, *first_out = NULL;
  for (size_t k = 0; k < l->run->n_pairs; k++) {
    const struct cmp_pair *p = &l->run->pairs[k];
    if ((p->experiment != SIZE_MAX) != experiment || (p->quantity == CMP_PRESSURE) != pressure)
      continue;
    struct cmp_value v = pair_number(p, which);
    const char *own = experiment ? p->b->name : p->a->name;
    if (!cmp_known(&v) && !l->left_out++) {
      first_out = own;
      why = v;
    }
    if (!cmp_known(&v) || (found && v.value <= worst.value)) continue;
    worst = v;
    found = p;
    name = own;
  }
  if (found)
    pairs_say(l, found, name, first_out, &why);
  else if (first_out)
    snprintf(l->detail, l->detail_room, "%.58s", first_out);
  else
    why =
        cmp_unknown(experiment ? "no experiment to compare with" : "no such signal in both files");
  return found ? worst : why;
}

struct cmp_value cmp_measure_probe_rms(struct cmp_look *l) {
  return worst_pair(l, false, true, RMS);
}

struct cmp_value cmp_measure_probe_peak(struct cmp_look *l) {
  return worst_pair(l, false, true, PEAK);
}

struct cmp_value cmp_measure_probe_peak_time(struct cmp_look *l) {
  return worst_pair(l, false, true, PEAK_TIME);
}

struct cmp_value cmp_measure_probe_onset(struct cmp_look *l) {
  return worst_pair(l, false, true, ONSET);
}

struct cmp_value cmp_measure_probe_impulse(struct cmp_look *l) {
  return worst_pair(l, false, true, IMPULSE);
}

struct cmp_value cmp_measure_probe_shift(struct cmp_look *l) {
  return worst_pair(l, false, true, SHIFT);
}

struct cmp_value cmp_measure_gauge_rms(struct cmp_look *l) {
  return worst_pair(l, false, false, RMS);
}

struct cmp_value cmp_measure_experiment_probe_rms(struct cmp_look *l) {
  return worst_pair(l, true, true, RMS);
}

struct cmp_value cmp_measure_experiment_gauge_rms(struct cmp_look *l) {
  return worst_pair(l, true, false, RMS);
}

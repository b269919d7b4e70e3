/* The plunging jets, and the instants of breaking. */
#include "compare/measures/look.h"

static bool jets(const struct cmp_look *l, const struct cmp_jet **a, const struct cmp_jet **b,
                 struct cmp_value *why) {
  if (l->at->output == SIZE_MAX || l->at->ref_output == SIZE_MAX) {
    *why = l->at->mean;
    return false;
  }
  *a = &l->run->data.jet[l->at->output];
  *b = &l->c->ref.data.jet[l->at->ref_output];
  if ((*a)->found && (*b)->found) return true;
  if (l->run->data.floats && l->c->ref.data.floats) {
    *why = l->run->data.overturning.time;
    return false;
  }
  const char *who = (*a)->found ? l->c->ref.data.label : l->run->data.label;
  *why = !(*a)->found && !(*b)->found
             ? cmp_unknown("neither surface overhangs by %.3g H", CMP_JET_LEAST * l->c->depth)
             : cmp_unknown("the surface of %.40s does not overhang by %.3g H", who,
                           CMP_JET_LEAST * l->c->depth);
  return false;
}

struct cmp_value cmp_measure_jet_tip(struct cmp_look *l) {
  const struct cmp_jet *a, *b;
  struct cmp_value v;
  if (!jets(l, &a, &b, &v)) return v;
  return cmp_number(hypot(a->tip[0] - b->tip[0], a->tip[1] - b->tip[1]));
}

struct cmp_value cmp_measure_jet_direction(struct cmp_look *l) {
  const struct cmp_jet *a, *b;
  struct cmp_value v;
  if (!jets(l, &a, &b, &v)) return v;
  if (!cmp_known(&a->direction)) return a->direction;
  if (!cmp_known(&b->direction)) return b->direction;
  return cmp_number(fabs(remainder(a->direction.value - b->direction.value, 360)));
}

struct cmp_value cmp_measure_jet_thickness(struct cmp_look *l) {
  const struct cmp_jet *a, *b;
  struct cmp_value v;
  if (!jets(l, &a, &b, &v)) return v;
  v = cmp_unknown("a jet is shorter than %g H", cmp_jet_station[0]);
  for (size_t k = 0; k < CMP_JET_STATIONS; k++) {
    if (!cmp_known(&a->thickness[k]) || !cmp_known(&b->thickness[k])) continue;
    double d = fabs(a->thickness[k].value - b->thickness[k].value);
    if (cmp_known(&v) && d <= v.value) continue;
    v = cmp_number(d);
    snprintf(l->detail, l->detail_room, "%g H behind the tip", cmp_jet_station[k]);
  }
  return v;
}

struct cmp_value cmp_measure_jet_cavity(struct cmp_look *l) {
  const struct cmp_jet *a, *b;
  struct cmp_value v;
  if (!jets(l, &a, &b, &v)) return v;
  if (!cmp_known(&a->cavity)) return a->cavity;
  if (!cmp_known(&b->cavity)) return b->cavity;
  return cmp_number(fabs(a->cavity.value - b->cavity.value));
}

static struct cmp_value instants(struct cmp_look *l, const struct cmp_instant *a,
                                 const struct cmp_instant *b) {
  if (!cmp_known(&a->time)) return a->time;
  if (!cmp_known(&b->time)) return b->time;
  snprintf(l->detail, l->detail_room, "%.4g against %.4g, located to +-%.2g", a->time.value,
           b->time.value, a->error + b->error);
  return cmp_number(fabs(a->time.value - b->time.value));
}

struct cmp_value cmp_measure_overturning_time(struct cmp_look *l) {
  return instants(l, &l->run->data.overturning, &l->c->ref.data.overturning);
}

struct cmp_value cmp_measure_touchdown_time(struct cmp_look *l) {
  return instants(l, &l->run->data.touchdown, &l->c->ref.data.touchdown);
}

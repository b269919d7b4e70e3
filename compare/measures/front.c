/* The front that runs to a wall over a dry bed. */
#include "compare/measures/look.h"

/* When the reference reaches its wall: the event, or else the last output before its front stands
 * there. */
static double front_until(const struct comparison *c) {
  const struct cmp_data *ref = &c->ref.data;
  struct geo_box box = geo_lines_box(&ref->walls);
  double wall = c->side == CMP_LEFT ? box.min[0] : box.max[0];
  size_t n = 0;
  if (cmp_known(&ref->impact.time)) return ref->impact.time.value;
  while (n < ref->front.n && fabs(ref->front.value[n] - wall) > c->depth) n++;
  return n ? ref->front.t[n - 1] : INFINITY;
}

struct cmp_value cmp_measure_front(struct cmp_look *l) {
  struct cmp_signal ref = cmp_series_signal(&l->c->ref.data.front);
  const struct cmp_series *a = &l->run->data.front;
  double until = front_until(l->c), worst = -1, when = NAN;
  if (l->c->side == CMP_NO_SIDE) return cmp_unknown("no front runs to a wall in the reference");
  for (size_t i = 0; i < a->n && a->t[i] <= until; i++) {
    double d = fabs(a->value[i] - cmp_signal_at(&ref, a->t[i]));
    if (d > worst) {
      worst = d;
      when = a->t[i];
    }
  }
  if (worst < 0) return cmp_unknown("no front at common times");
  snprintf(l->detail, l->detail_room, "at t* = %.3g", when);
  return cmp_number(worst);
}

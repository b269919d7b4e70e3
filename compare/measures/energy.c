/* Energies, and the budgets of energy and volume. */
#include "compare/measures/look.h"

static struct cmp_value series_at(const struct cmp_data *d, const struct cmp_series *s, double t) {
  struct cmp_signal signal = cmp_series_signal(s);
  /* the last row may precede the last output by up to a sampling interval and a step */
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

static struct cmp_value difference_at(struct cmp_look *l, const struct cmp_series *a,
                                      const struct cmp_series *b) {
  struct cmp_value x = series_at(&l->run->data, a, l->t), y = series_at(&l->c->ref.data, b, l->t);
  if (!cmp_known(&x)) return x;
  if (!cmp_known(&y)) return y;
  return cmp_number(fabs(x.value - y.value));
}

struct cmp_value cmp_measure_kinetic(struct cmp_look *l) {
  return difference_at(l, &l->run->data.kinetic, &l->c->ref.data.kinetic);
}

struct cmp_value cmp_measure_potential(struct cmp_look *l) {
  return difference_at(l, &l->run->data.potential, &l->c->ref.data.potential);
}

struct cmp_value cmp_measure_mechanical(struct cmp_look *l) {
  return difference_at(l, &l->run->data.mechanical, &l->c->ref.data.mechanical);
}

struct cmp_value cmp_measure_decay(struct cmp_look *l) {
  const struct cmp_series *s = &l->run->data.mechanical;
  struct cmp_value now = series_at(&l->run->data, s, l->t);
  return cmp_known(&now) ? cmp_number(s->value[0] - now.value) : now;
}

struct cmp_value cmp_measure_budget(struct cmp_look *l) {
  return l->run->closure;
}

struct cmp_value cmp_measure_budget_before_impact(struct cmp_look *l) {
  return l->run->closure_before;
}

struct cmp_value cmp_measure_volume(struct cmp_look *l) {
  return l->run->volume;
}

/* Energies, and the budgets of energy and volume. */
#include "compare/ledger.h"
#include "compare/measures/look.h"

static struct cmp_value difference_at(struct cmp_look *l, const struct cmp_series *a,
                                      const struct cmp_series *b) {
  struct cmp_value x = cmp_data_energy(&l->run->data, a, l->t),
                   y = cmp_data_energy(&l->c->ref.data, b, l->t);
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
  return cmp_ledger_lost_within(&l->run->data, l->t);
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

#include "compare/ledger.h"

#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"

static bool knows(const struct cmp_ledger *l, const char *name) {
  for (size_t k = 0; k < l->n; k++)
    if (!strcmp(l->term[k].name, name)) return true;
  return false;
}

static bool is_zero(const struct cmp_series *s) {
  for (size_t i = 0; i < s->n; i++)
    if (s->value[i] != 0) return false;
  return true;
}

static enum status take(const struct cmp_data *d, size_t *room, struct cmp_ledger *l) {
  for (size_t k = 0; k < d->n_terms; k++) {
    if (is_zero(&d->terms[k]) || knows(l, d->terms[k].name)) continue;
    TRY(array_grow(&l->term, room, l->n + 1, "terms of the budget of energy"));
    l->term[l->n++] = (struct cmp_ledger_term){d->terms[k].name, d->file->terms[k].help};
  }
  return OK;
}

enum status cmp_ledger_create(const struct comparison *c, struct cmp_ledger *l) {
  size_t room = 0;
  *l = (struct cmp_ledger){0};
  enum status status = take(&c->ref.data, &room, l);
  for (size_t r = 0; r < c->n_runs && status == OK; r++) status = take(&c->run[r].data, &room, l);
  if (status != OK) cmp_ledger_destroy(l);
  return status;
}

void cmp_ledger_destroy(struct cmp_ledger *l) {
  free(l->term);
  *l = (struct cmp_ledger){0};
}

static struct cmp_value risen(const struct cmp_data *d, const struct cmp_series *s, double sign,
                              double t) {
  struct cmp_value now = cmp_data_energy(d, s, t);
  return cmp_known(&now) ? cmp_number(sign * (now.value - s->value[0])) : now;
}

struct cmp_value cmp_ledger_lost(const struct cmp_data *d, double t) {
  return risen(d, &d->mechanical, -1, t);
}

struct cmp_value cmp_ledger_lost_within(const struct cmp_data *d, double t) {
  struct cmp_value lost = cmp_ledger_lost(d, t);
  for (size_t k = 0; k < d->n_terms && cmp_known(&lost); k++) {
    if (!d->file->terms[k].outside) continue;
    const struct cmp_value passed = risen(d, &d->terms[k], 1, t);
    lost = cmp_known(&passed) ? cmp_number(lost.value - passed.value) : passed;
  }
  return lost;
}

struct cmp_value cmp_ledger_elastic(const struct cmp_data *d, double t) {
  return risen(d, &d->internal, 1, t);
}

struct cmp_value cmp_ledger_term(const struct cmp_data *d, const char *name, double t) {
  const struct cmp_series *s = cmp_series_find(d->terms, d->n_terms, name);
  return s ? risen(d, s, 1, t) : cmp_number(0);
}

struct cmp_value cmp_ledger_rest(const struct cmp_data *d, double t) {
  return risen(d, &d->closure, -1, t);
}

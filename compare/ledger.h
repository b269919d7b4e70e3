/* Where the mechanical energy of a run has gone: what is lost of it is what is gained in elastic
 * energy, what each of the solver's own terms has taken, and a rest that nothing accounts for. */
#pragma once
#include "compare/comparison.h"

/* The terms of all that is compared, by name; those that stay zero everywhere are left out. */
struct cmp_ledger {
  size_t n;
  struct cmp_ledger_term {
    const char *name, *help; /* borrowed */
  } * term;                  /* [n], owned */
};

enum status cmp_ledger_create(const struct comparison *c, struct cmp_ledger *l);
void cmp_ledger_destroy(struct cmp_ledger *l);

/* Each from t = 0 to t, in E0. A term that the solver does not have has taken nothing. */
struct cmp_value cmp_ledger_lost(const struct cmp_data *d, double t);
/* The same less what has gone to, or come from, what moves the tank and its sides. */
struct cmp_value cmp_ledger_lost_within(const struct cmp_data *d, double t);
struct cmp_value cmp_ledger_elastic(const struct cmp_data *d, double t);
struct cmp_value cmp_ledger_term(const struct cmp_data *d, const char *name, double t);
struct cmp_value cmp_ledger_rest(const struct cmp_data *d, double t); /* less than none: gained */

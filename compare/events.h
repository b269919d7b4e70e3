/* Published numbers of events, which every run and the reference are held against. */
#pragma once
#include "compare/comparison.h"

struct cmp_check {
  const struct case_event *of;
  size_t run;             /* index in comparison.run; SIZE_MAX: the reference */
  struct cmp_value value; /* of the run's own first event of that name, t* or H */
  double published, within;
  bool passed; /* a value that is not available does not */
};

struct cmp_checks {
  size_t n;
  struct cmp_check *check; /* [n], owned */
};

enum status cmp_checks_create(const struct comparison *c, struct cmp_checks *checks);
void cmp_checks_destroy(struct cmp_checks *checks);
/* The number of a run that the event asks for, t* or H: of the first of its kind. */
struct cmp_value cmp_event_value(const struct comparison *c, const struct cmp_data *d,
                                 const struct case_event *e);
const char *cmp_check_units(const struct cmp_check *check);

/* What a measure sees, and the functions of all of them. */
#pragma once
#include "compare/comparison.h"
#include "compare/measures/list.h"

struct cmp_look {
  const struct comparison *c;
  const struct cmp_run *run;
  const struct cmp_at *at; /* NULL for measures of the whole run */
  double t;                /* the comparison time asked for */
  char *detail;            /* a measure may say here where it found the worst */
  size_t detail_room;
  bool absent;     /* and here that others have one at other times */
  size_t left_out; /* and here how many sensors have no such number, where others have */
};

/* Each looks at one run, and at one comparison time where it is measured AT them. */
#define X(name, units, when, noise, section, of, help)                                             \
  struct cmp_value cmp_measure_##name(struct cmp_look *l);
CMP_MEASURES(X)
#undef X

/* Of one of them, by its place in the list. */
bool cmp_measure_always(size_t measure);
bool cmp_measure_at_times(size_t measure); /* else of the whole run */
enum cmp_measure_kind { CMP_OF_DIFFERENCE, CMP_OF_DEFECT, CMP_OF_OWN, CMP_OF_MEASURED };
enum cmp_measure_kind cmp_measure_kind(size_t measure);
struct cmp_value cmp_measure_take(size_t measure, struct cmp_look *l);

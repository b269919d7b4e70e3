/* Runs of one solver that differ by their resolution alone, and how every number of theirs goes on
 * as the spacing falls. */
#pragma once
#include "compare/convergence/triple.h"
#include "compare/measure.h"

struct cmp_neighbours { /* three runs of a row that follow each other */
  size_t member[3];
  struct cmp_triple triple;
};

struct cmp_row_of_group {
  const char *name, *units; /* of a measure, or of a number of the run itself */
  const char *of;           /* the event, probe or gauge; NULL: none; borrowed */
  enum cmp_section section; /* where its kind stands in the report */
  size_t time;              /* index in comparison.times; SIZE_MAX: of the whole run */
  bool is_difference;       /* the value itself is the error */
  struct cmp_value *value;  /* [group.n], owned */
  double *known_to;         /* how far each may be off by the way it was found; [group.n], owned */
  double *error;            /* against the reference, >= 0; NaN: not known; [group.n], owned */
  size_t n_triples;
  struct cmp_neighbours *triple; /* [n_triples], the coarsest first, owned */
};

struct cmp_left_out {
  size_t run; /* as members */
  char why[160];
};

struct cmp_group {
  char name[96];
  char *settings;    /* in words; NULL: no file says; owned */
  size_t n;          /* 2 or more */
  size_t *member;    /* index in comparison.run, SIZE_MAX: the reference; coarsest first, owned */
  double *spacing;   /* H, falling, [n], owned */
  size_t n_left_out; /* owned, as rows */
  struct cmp_left_out *left_out;
  size_t n_rows;
  struct cmp_row_of_group *row;
};

struct cmp_convergence {
  size_t n;
  struct cmp_group *group;
};

/* `rows`: of all measures, of the same comparison. */
enum status cmp_convergence_create(const struct comparison *c, const struct cmp_rows *rows,
                                   struct cmp_convergence *v);
void cmp_convergence_destroy(struct cmp_convergence *v);

/* The finest triple of a row; NULL: there is none. */
const struct cmp_neighbours *cmp_row_finest(const struct cmp_row_of_group *row);

/* What a row comes to, a sentence: "monotone, order 1.02, limit 0.0213, finest 0.0231 +- 0.0022",
 * or why there is nothing to say. */
void cmp_row_say(const struct cmp_group *g, const struct cmp_row_of_group *row, char *out,
                 size_t room);

/* Cost of a member: seconds on the clock, and evaluations; NaN where the file does not tell. */
double cmp_member_seconds(const struct comparison *c, size_t member);
double cmp_member_evaluations(const struct comparison *c, size_t member);

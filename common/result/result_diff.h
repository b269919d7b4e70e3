/* Two result files side by side, dataset by dataset (`plunge diff`), and one at a glance
 * (`plunge info`). */
#pragma once
#include <stdbool.h>
#include <stdio.h>

#include "common/base/status.h"
#include "common/result/result.h"
#include "common/result/result_tolerance.h"

struct result_spot { /* two numbers that differ, and where */
  double value[2], difference;
  size_t row, component;
  double time;     /* s; NaN: it has none */
  double place[2]; /* m, in the first file, of its point, probe, gauge or event; NaN: not known */
};

struct result_used { /* a rule that rows of a quantity were held against */
  size_t rule;
  double worst; /* largest difference of them; negative: they were ignored */
};

struct result_curve { /* a series of one file */
  size_t n;
  double *t, *value; /* s and the quantity's units, [n], owned */
};

struct result_quantity { /* a dataset, or "@" and the name of an attribute */
  char *name, *units;    /* "": none */
  int rank;              /* 0: one number */
  bool differs, ignored; /* ignored: by a rule, and not looked at */
  char *what;       /* what differs and is no number, a sentence without its end; NULL: nothing */
  double what_time; /* s, from when on; NaN: not known */
  size_t n, beyond; /* numbers that both have; those beyond their tolerance */
  double scale;     /* largest magnitude in both; of equal ones not known, 0 */
  double allowed;   /* for the worst number */
  /* Of the numbers beyond their tolerance the first in time and the one that differs most; when
   * none is, both are the one that differs most. */
  struct result_spot first, worst;
  size_t n_used;
  struct result_used *used;     /* [n_used], owned */
  struct result_curve curve[2]; /* of a series that differs, where they were asked for */
};

struct result_diff {
  char *path[2];
  double time_scale; /* sqrt(H/g) of the first, s */
  size_t n, n_same, n_differ, n_ignored;
  struct result_quantity *quantity; /* [n]: attributes, then datasets by name */
  size_t n_rules;
  unsigned char *matched;      /* whether a rule of the tolerances is for anything, [n_rules] */
  struct result_file *file[2]; /* all but their points; NULL unless asked for */
};

/* Compares two files. `shown`: also keeps what was read of them, and both curves of so many of the
 * series that differ, those that do so first; 0: neither. ERR_INPUT when either is missing, damaged
 * or not a result. */
enum status result_diff_create(const char *a, const char *b,
                               const struct result_tolerances *tolerances, size_t shown,
                               struct result_diff **out);
void result_diff_forget(struct result_diff *d);  /* what was kept for being shown */
void result_diff_destroy(struct result_diff *d); /* NULL is fine */

/* Of what differs, the one that does so first in time; NULL when nothing that has a time does. */
const struct result_quantity *result_diff_first(const struct result_diff *d);
double result_quantity_since(const struct result_quantity *q); /* s; NaN: it has no time */

/* One line for each quantity that differs, with the worst difference and where it is, one with the
 * first in time, and one of summary. */
void result_diff_print(const struct result_diff *d, FILE *out);
/* What differs in a quantity in a sentence or two, without the name; to be freed. NULL: no memory.
 */
char *result_quantity_say(const struct result_diff *d, const struct result_quantity *q);

/* Rules under which each of n pairs counts as the same. ERR_MEMORY. */
enum status result_diff_draft(size_t n, struct result_diff *const *d,
                              const struct result_tolerances *tolerances, FILE *out);

/* What is in the file, in lines of at most 100 columns. ERR_INPUT. */
enum status result_info(const char *path, FILE *out);

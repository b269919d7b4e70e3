/* Which of many runs a figure names, and how it draws them. */
#pragma once
#include "compare/comparison.h"

enum {
  CMP_NAMED = 28, /* runs with a style of their own and a place in the key: 7 colours, 4 dashes */
  CMP_PANELS = 12 /* runs with a panel of their own */
};

/* Ranks the runs (run[r].rank, from 0) by how long they agree with the reference. */
enum status cmp_runs_rank(struct comparison *c);

/* Whether run r is among the `most` that are shown where there is no room for all: half of them
 * agree with the reference longest, half leave it first. */
bool cmp_run_is_picked(const struct comparison *c, size_t r, size_t most);
size_t cmp_runs_picked(const struct comparison *c, size_t most); /* how many */

/* A sentence about the runs left out, for a caption; "" when there are none. `how` says what
 * happens to them. */
void cmp_picked_say(const struct comparison *c, size_t most, const char *how, char *out,
                    size_t room);

struct cmp_style {
  const char *colour; /* "#rrggbb", distinct for colour-blind readers */
  int dashes;         /* from 0, the solid line, to 3 */
};
struct cmp_style cmp_style_of(size_t k); /* the k-th: colours first, then dashes */
struct cmp_style cmp_run_style(const struct comparison *c, size_t r); /* SIZE_MAX: the reference */

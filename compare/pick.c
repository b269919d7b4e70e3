#include "compare/pick.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "compare/summary.h"

enum status cmp_runs_rank(struct comparison *c) {
  size_t *order;
  TRY(cmp_summary_order(c, &order));
  for (size_t k = 0; k < c->n_runs; k++) c->run[order[k]].rank = k;
  free(order);
  return OK;
}

bool cmp_run_is_picked(const struct comparison *c, size_t r, size_t most) {
  size_t rank = c->run[r].rank;
  return c->n_runs <= most || rank < most / 2 || rank + most - most / 2 >= c->n_runs;
}

size_t cmp_runs_picked(const struct comparison *c, size_t most) {
  return c->n_runs <= most ? c->n_runs : most;
}

void cmp_picked_say(const struct comparison *c, size_t most, const char *how, char *out,
                    size_t room) {
  *out = 0;
  if (c->n_runs > most)
    snprintf(out, room,
             " Of %zu runs, the %zu that agree with the reference longest and the %zu that leave "
             "it first; the %zu others %s.",
             c->n_runs, most / 2, most - most / 2, c->n_runs - most, how);
}

struct cmp_style cmp_style_of(size_t k) {
  /* Okabe and Ito's colours, yellow left out: it is lost on white. */
  static const char *const palette[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                        "#e69f00", "#56b4e9", "#7f7f7f"};
  enum { COLOURS = sizeof palette / sizeof *palette, DASHES = 4 };
  return (struct cmp_style){palette[k % COLOURS], (int)(k / COLOURS % DASHES)};
}

/* The reference is black. */
struct cmp_style cmp_run_style(const struct comparison *c, size_t r) {
  if (r == SIZE_MAX) return (struct cmp_style){"#000000", 0};
  if (!cmp_run_is_picked(c, r, CMP_NAMED)) return (struct cmp_style){"#c4c4c4", 0};
  size_t k = 0;
  for (size_t q = 0; q < r; q++) k += cmp_run_is_picked(c, q, CMP_NAMED);
  return cmp_style_of(k);
}

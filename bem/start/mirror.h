/* Water that is to run out to the left, such as a column at the right wall, is solved for as it is
 * seen in an upright mirror through the middle of the tank, where it runs to the right. */
#pragma once
#include "common/case/case.h"

struct bem_mirror {
  struct case_file c; /* as the solver sees it; what is not seen in the mirror is the case's own */
  bool turned; /* it is what the mirror shows; walls, water, probes, gauges, points and motions are
                  owned then */
};

/* ERR_MEMORY; destroy *m even then. */
enum status bem_mirror_create(const struct case_file *c, struct bem_mirror *m);
void bem_mirror_destroy(struct bem_mirror *m);

/* Where a place x of the tank is in the mirror, m. */
static inline double bem_mirror_x(const struct case_file *c, double x) {
  return c->tank.min[0] + (c->tank.max[0] - x);
}

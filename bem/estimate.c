#include "bem/estimate.h"

#include <math.h>

#include "bem/accuracy.h"
#include "bem/mesh.h"
#include "common/flow/flow.h"

/* Measured: one matrix of 8 n^2 bytes; nodes 1.14 times those of even spacing on a column of
 * H by H, and twice as many when the water has run along a tank of two to three columns. The clock,
 * for dam breaks of 40 and 90 nodes per H to t = 6.5 sqrt(H/g): 3.7 and 29 s (docs/accuracy.md), on
 * one thread and on two. */
static const double BYTES_ALONE = 40e6, MORE_NODES = 1.14, GROWTH = 2;
static const double SECONDS_OF_137 = 0.57, POWER = 2.5; /* per sqrt(H/g), with 137 nodes */

void bem_estimate(const struct case_file *c, const struct case_run *r, struct solver_estimate *e) {
  struct geo_box w = geo_lines_box(&c->water);
  double wide = (w.max[0] - w.min[0]) / c->H, high = (w.max[1] - w.min[1]) / c->H;
  bool wave = flow_is_wave(c->flow);
  double n = ceil(r->resolution * (wave ? wide : MORE_NODES * (wide + high)));
  double most = fmin(BEM_MOST_NODES, wave ? n : GROWTH * n);
  e->points = n;
  e->unit = "nodes";
  e->bytes = BYTES_ALONE + 8 * most * most;
  const struct bem_options *o = r->options;
  const double runs = o->error_bars ? 1 + pow(BEM_COARSER, -POWER) : 1;
  e->seconds = runs * SECONDS_OF_137 * c->end * sqrt(c->gravity / c->H) * pow(n / 137, POWER);
}

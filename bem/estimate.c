#include "bem/estimate.h"

#include <math.h>

#include "bem/accuracy.h"
#include "bem/options.h"
#include "bem/shape/mesh.h"
#include "common/flow/flow.h"

/* Measured: one matrix of 8 n^2 bytes; nodes 1.14 times those of even spacing on a column of
 * H by H, and twice as many when the water has run along a tank of two to three columns. The clock,
 * for dam breaks of 40 and 90 nodes per H to t = 6.5 sqrt(H/g): 3.7 and 29 s (docs/accuracy.md), on
 * one thread and on two. */
static const double BYTES_ALONE = 40e6, MORE_NODES = 1.14, GROWTH = 2;
static const double SECONDS_OF_137 = 0.57, POWER = 2.5; /* per sqrt(H/g), with 137 nodes */

/* Of a lattice, measured as well: of each point at each output for every node, with panels and
 * their mirror images; 20,000 points under 330 nodes and 13,000 in a tank of slopes under 375
 * took 1.1e-7 and 1.2e-7 s, 12,500 without sides 2e-7 s. And fields of a point. */
static const double SECONDS_OF_POINT = 1.2e-7, BYTES_OF_POINT = 100;

/* The lattice of a run, under `nodes` of the surface: seconds for those of all outputs together. */
static void add_lattice(const struct case_file *c, const struct case_run *r, double nodes,
                        struct solver_estimate *e) {
  const struct bem_options *o = r->options;
  if (!(o->lattice > 0)) return;
  const double points = case_water_area(c) / (o->lattice * o->lattice);
  const double outputs = 1 + floor(c->end / c->every * (1 + CASE_SAME));
  const double runs = o->error_bars ? 1 + 1 / BEM_COARSER : 1;
  e->bytes += BYTES_OF_POINT * points;
  e->seconds += runs * SECONDS_OF_POINT * outputs * points * nodes;
}

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
  add_lattice(c, r, 0.5 * (n + most), e);
}

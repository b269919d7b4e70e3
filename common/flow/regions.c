#include "common/flow/regions.h"

#include <math.h>

#include "common/base/geometry_check.h"

void flow_regions_velocity(const struct flow_water *w, double x, double y, double t,
                           double velocity[2]) {
  const double *of = w->c->velocity;
  (void)t;
  if (w->c->regions_differ) {
    double nearest[2];
    size_t region = 0;
    if (!geo_lines_find(&w->c->water, x, y, &region))
      geo_lines_distance(&w->c->water, x, y, nearest, &region);
    of = w->c->velocities[region];
  }
  velocity[0] = of[0];
  velocity[1] = of[1];
}

bool flow_find_column(const struct case_file *c, struct flow_column *column) {
  const double near = case_near(c);
  if (c->water.pieces != 1) return false;
  struct geo_box b = geo_lines_box(&c->water);
  double area = (b.max[0] - b.min[0]) * (b.max[1] - b.min[1]);
  *column = (struct flow_column){.left = fabs(b.min[0] - c->tank.min[0]) <= near,
                                 .right = fabs(b.max[0] - c->tank.max[0]) <= near,
                                 .box = b};
  return fabs(geo_piece_area(&c->water, 0) - area) <= CASE_SAME * area &&
         fabs(b.min[1] - c->tank.min[1]) <= near && (column->left || column->right);
}

#include "common/tank/tank.h"

bool tank_is_rectangular(const struct geo_lines *walls, double near) {
  const struct geo_box box = geo_lines_box(walls);
  enum { LEFT, BED, RIGHT } part = LEFT;
  if (walls->pieces != 1 || walls->closed[0] || walls->points < 4) return false;
  for (size_t i = 0; i + 1 < walls->points; i++) {
    const double *p = walls->p[i], *q = walls->p[i + 1];
    if (part == LEFT && i > 0 && fabs(p[1] - box.min[1]) <= near) part = BED;
    if (part == BED && fabs(p[0] - box.max[0]) <= near) part = RIGHT;
    double side = part == LEFT ? box.min[0] : box.max[0];
    bool along = part == BED ? fabs(p[1] - box.min[1]) <= near && fabs(q[1] - box.min[1]) <= near &&
                                   q[0] > p[0]
                             : fabs(p[0] - side) <= near && fabs(q[0] - side) <= near &&
                                   (part == LEFT ? q[1] < p[1] : q[1] > p[1]);
    if (!along) return false;
  }
  return part == RIGHT;
}

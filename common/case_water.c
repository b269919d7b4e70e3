/* How much water a case holds, and the energy of that water at rest. */
#include <math.h>

#include "common/case.h"
#include "common/geometry_check.h"

double case_water_area(const struct case_file *c) {
  double area = 0;
  if (c->wave.kind) /* the crests fill the troughs in a whole number of half waves */
    return c->wave.depth * (c->tank.max[0] - c->tank.min[0]);
  for (size_t k = 0; k < c->water.pieces; k++) area += geo_piece_area(&c->water, k);
  return area;
}

double case_rest_potential(const struct case_file *c) {
  double wanted = case_water_area(c), bed = c->tank.min[1], area = 0, centre[2] = {0, 0};
  double width = c->tank.max[0] - c->tank.min[0];
  if (c->rectangular || c->walls.pieces == 0) {
    double level = bed + wanted / width;
    return c->density * c->gravity * width * (level * level - bed * bed) / 2;
  }
  /* any other tank: the level by bisection, to the last digits that an area has */
  double low = bed, high = c->tank.max[1];
  for (int i = 0; i < 60 && high - low > 1e-15 * fabs(high); i++) {
    double level = (low + high) / 2;
    if (geo_area_below(&c->walls, level, &area, centre) != OK) return NAN;
    if (area < wanted)
      low = level;
    else
      high = level;
  }
  if (geo_area_below(&c->walls, high, &area, centre) != OK) return NAN;
  return c->density * c->gravity * wanted * centre[1];
}

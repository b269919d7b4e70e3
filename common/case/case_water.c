/* How much water a case holds, and the energy of that water at rest. */
#include <math.h>

#include "common/base/geometry_check.h"
#include "common/case/case.h"
#include "common/flow/flow.h"

double case_water_area(const struct case_file *c) {
  double area = 0;
  if (c->flow->scale && c->rectangular)
    return c->flow->scale(c).mean * (c->tank.max[0] - c->tank.min[0]);
  for (size_t k = 0; k < c->water.pieces; k++) area += geo_piece_area(&c->water, k);
  return area;
}

/* In a box without a lid, from y = bed upwards. */
static double box_potential(const struct case_file *c, double area) {
  double width = c->tank.max[0] - c->tank.min[0], bed = c->tank.min[1], level = bed + area / width;
  return c->density * c->gravity * width * (level * level - bed * bed) / 2;
}

/* The level by bisection, to the last digits that an area has; its area and centroid. False when
 * the walls bound no room, or one too small. */
static bool find_level(const struct case_file *c, double wanted, double *level, double *area,
                       double centre[2]) {
  double low = c->tank.min[1], high = c->tank.max[1];
  *level = NAN;
  centre[1] = NAN; /* without memory */
  if (geo_area_below(&c->walls, high, area, centre) != OK) return true;
  if (*area < wanted) return false;
  for (int i = 0; i < 60 && high - low > 1e-15 * fabs(high); i++) {
    *level = (low + high) / 2;
    if (geo_area_below(&c->walls, *level, area, centre) != OK) return true;
    if (*area < wanted)
      low = *level;
    else
      high = *level;
  }
  *level = high;
  if (geo_area_below(&c->walls, high, area, centre) != OK) centre[1] = NAN;
  return true;
}

enum status case_turn_lines(const struct case_file *c, const struct geo_lines *from,
                            struct geo_lines *to) {
  TRY(geo_lines_copy(to, from));
  for (size_t i = 0; i < to->points; i++) {
    const double x = to->p[i][0], y = to->p[i][1];
    to->p[i][0] = c->down[0] * y - c->down[1] * x;
    to->p[i][1] = -c->down[0] * x - c->down[1] * y;
  }
  return OK;
}

/* Of water that comes to rest in the tank as gravity has it; NaN without memory. */
static double turned_potential(const struct case_file *c, double wanted) {
  struct case_file level = {.density = c->density, .gravity = c->gravity, .down = {0, -1}};
  double at, area, centre[2], potential = NAN;
  if (case_turn_lines(c, &c->walls, &level.walls) == OK) {
    level.tank = geo_lines_box(&level.walls);
    potential = find_level(&level, wanted, &at, &area, centre)
                    ? c->density * c->gravity * wanted * centre[1]
                    : box_potential(&level, wanted);
  }
  geo_lines_destroy(&level.walls);
  return potential;
}

bool case_water_moves(const struct case_file *c) {
  bool moves = c->velocity[0] != 0 || c->velocity[1] != 0;
  for (size_t k = 0; c->regions_differ && k < c->water.pieces; k++)
    moves |= c->velocities[k][0] != 0 || c->velocities[k][1] != 0;
  return moves;
}

double case_rest_level(const struct case_file *c) {
  const double wanted = case_water_area(c);
  double level, area = 0, centre[2] = {0, 0};
  if (!c->rectangular && find_level(c, wanted, &level, &area, centre)) return level;
  return c->tank.min[1] + wanted / (c->tank.max[0] - c->tank.min[0]);
}

double case_rest_potential(const struct case_file *c) {
  const double wanted = case_water_area(c);
  double level, area = 0, centre[2] = {0, 0};
  if (c->flow->pull) return c->density * flow_pull_rest(c->flow->pull(c), wanted);
  if (case_is_turned(c)) return turned_potential(c, wanted);
  if (c->rectangular || !find_level(c, wanted, &level, &area, centre))
    return box_potential(c, wanted);
  return c->density * c->gravity * wanted * centre[1];
}

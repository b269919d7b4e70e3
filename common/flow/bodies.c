#include "common/flow/bodies.h"

#include <math.h>
#include <stdio.h>

void flow_body_middle(const struct case_file *c, double middle[2]) {
  for (int k = 0; k < 2; k++) middle[k] = (c->tank.min[k] + c->tank.max[k]) / 2;
}

struct flow_scale flow_body_scale(const struct case_file *c, double size, double area) {
  return (struct flow_scale){
      .depth = size, .mean = area / (c->tank.max[0] - c->tank.min[0]), .length = size};
}

void flow_body_check_room(const struct case_file *c, struct case_draft *d, double reach,
                          const char *key) {
  const struct geo_box *t = &c->tank;
  const double room = fmin(t->max[0] - t->min[0], t->max[1] - t->min[1]) / 2;
  char found[96], allowed[96];
  if (reach < room) return;
  snprintf(found, sizeof found, "water that reaches %.6g m from the middle of the tank", reach);
  snprintf(allowed, sizeof allowed, "less than the walls, which are %.6g m away", room);
  case_flow_problem(d, key, found, allowed, "make the tank longer and its walls higher");
}

/* What initial states of regions share. */
#pragma once
#include "common/case/case.h"
#include "common/flow/flow.h"

/* Of the region that (x, y) is in, or nearest to. */
void flow_regions_velocity(const struct flow_water *w, double x, double y, double t,
                           double velocity[2]);

/* Water that is one rectangle on the bed, against one side of the tank or both. */
struct flow_column {
  bool left, right;   /* the sides that it touches */
  struct geo_box box; /* m */
};
bool flow_find_column(const struct case_file *c, struct flow_column *column);

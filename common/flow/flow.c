#include "common/flow/flow.h"

#include <math.h>

#include "common/case/case.h"

enum { OUTLINE_POINTS = 256, MOST_LENGTHS = 64 }; /* of an outline, for each length of the wave */

#define FLOW(name, help) &flow_##name,
#define NAME(name, help) #name,
#define HELP(name, help) help,
static const struct flow *const regions[] = {FLOWS_OF_REGIONS(FLOW)};
static const struct flow *const waves[] = {FLOWS_OF_WAVES(FLOW)};
const struct flow_list flow_regions = {sizeof regions / sizeof *regions, regions};
const struct flow_list flow_waves = {sizeof waves / sizeof *waves, waves};
const char *const flow_region_names[] = {FLOWS_OF_REGIONS(NAME) NULL};
const char *const flow_region_helps[] = {FLOWS_OF_REGIONS(HELP) NULL};
const char *const flow_wave_names[] = {FLOWS_OF_WAVES(NAME) NULL};
const char *const flow_wave_helps[] = {FLOWS_OF_WAVES(HELP) NULL};

bool flow_is_wave(const struct flow *f) {
  return f->elevation != NULL;
}

size_t flow_place(const struct flow *f) {
  const struct flow_list *list = flow_is_wave(f) ? &flow_waves : &flow_regions;
  size_t i = 0;
  while (list->flow[i] != f) i++;
  return i;
}

const char *flow_name(const struct flow *f) {
  return (flow_is_wave(f) ? flow_wave_names : flow_region_names)[flow_place(f)];
}

double flow_potential(const struct case_file *c, double x, double y) {
  return c->flow->potential ? c->flow->potential(c, x, y) : 0;
}

void flow_velocity(const struct case_file *c, double x, double y, double velocity[2]) {
  velocity[0] = velocity[1] = 0;
  if (c->flow->velocity) c->flow->velocity(c, x, y, velocity);
}

enum status flow_head(const struct case_file *c, void *prepared, const struct flow_point *p,
                      double *head) {
  if (c->flow->head) return c->flow->head(c, prepared, p, head);
  *head = c->flow->elevation(c, p->x) - p->y;
  return OK;
}

enum status flow_outline(const struct case_file *c, struct geo_lines *water) {
  double left = c->tank.min[0], bed = c->tank.min[1], width = c->tank.max[0] - left;
  double lengths = fmin(width / c->flow->scale(c).length, MOST_LENGTHS);
  size_t n = (size_t)ceil(lengths * OUTLINE_POINTS);
  geo_lines_clear(water);
  TRY(geo_lines_begin(water, true));
  TRY(geo_lines_add(water, left, bed));
  TRY(geo_lines_add(water, c->tank.max[0], bed));
  for (size_t i = n + 1; i-- > 0;) {
    double x = left + width * (double)i / (double)n;
    TRY(geo_lines_add(water, x, c->flow->elevation(c, x)));
  }
  return OK;
}

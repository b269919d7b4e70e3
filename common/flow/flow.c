#include "common/flow/flow.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

#include "common/case/case.h"
#include "common/flow/edges.h"
#include "common/flow/line.h"

enum { OUTLINE_POINTS = 256, MOST_LENGTHS = 64 }; /* of an outline, for each length of the wave */
enum { LINE_POINTS = 2000 };                      /* of one that hangs over, at least */

#define FLOW(name, help) &flow_##name,
#define NAME(name, help) #name,
#define HELP(name, help) help,
static const struct flow *const regions[] = {FLOWS_OF_REGIONS(FLOW)};
static const struct flow *const waves[] = {FLOWS_OF_WAVES(FLOW)};
static const struct flow *const bodies[] = {FLOWS_OF_BODIES(FLOW)};
const struct flow_list flow_regions = {sizeof regions / sizeof *regions, regions};
const struct flow_list flow_waves = {sizeof waves / sizeof *waves, waves};
const struct flow_list flow_bodies = {sizeof bodies / sizeof *bodies, bodies};
const char *const flow_region_names[] = {FLOWS_OF_REGIONS(NAME) NULL};
const char *const flow_region_helps[] = {FLOWS_OF_REGIONS(HELP) NULL};
const char *const flow_wave_names[] = {FLOWS_OF_WAVES(NAME) NULL};
const char *const flow_wave_helps[] = {FLOWS_OF_WAVES(HELP) NULL};
const char *const flow_body_names[] = {FLOWS_OF_BODIES(NAME) NULL};
const char *const flow_body_helps[] = {FLOWS_OF_BODIES(HELP) NULL};

bool flow_is_wave(const struct flow *f) {
  return f->elevation != NULL;
}

bool flow_is_body(const struct flow *f) {
  return f->outline != NULL;
}

size_t flow_place(const struct flow *f) {
  const struct flow_list *list = flow_is_wave(f)   ? &flow_waves
                                 : flow_is_body(f) ? &flow_bodies
                                                   : &flow_regions;
  size_t i = 0;
  while (i < list->n && list->flow[i] != f) i++;
  assert(i < list->n);
  return i;
}

const char *const flow_direction_names[] = {"right", "left", NULL};
const char *const flow_direction_helps[] = {"to greater x", "to smaller x"};

const char *flow_name(const struct flow *f) {
  const char *const *names = flow_is_wave(f)   ? flow_wave_names
                             : flow_is_body(f) ? flow_body_names
                                               : flow_region_names;
  return names[flow_place(f)];
}

bool flow_has_theory(const struct flow *f) {
  return f->error != NULL;
}

enum status flow_open(const struct case_file *c, struct flow_use use, struct flow_water *w) {
  *w = (struct flow_water){c, use, NULL};
  return c->flow->create ? c->flow->create(w) : OK;
}

void flow_close(struct flow_water *w) {
  if (w->c && w->c->flow->destroy) w->c->flow->destroy(w);
}

double flow_level(const struct case_file *c) {
  return (c->flow->bed ? c->flow->bed(c) : c->tank.min[1]) + c->flow->scale(c).depth;
}

double flow_elevation(const struct flow_water *w, double x, double t) {
  return w->c->flow->elevation(w, x, t);
}

double flow_potential(const struct flow_water *w, double x, double y, double t) {
  const struct flow *f = w->c->flow;
  return f->at_rest && t == 0 ? 0 : f->potential(w, x, y, t);
}

void flow_velocity(const struct flow_water *w, double x, double y, double t, double velocity[2]) {
  const struct flow *f = w->c->flow;
  velocity[0] = velocity[1] = 0;
  if (!f->at_rest || t != 0) f->velocity(w, x, y, t, velocity);
}

enum status flow_head(const struct flow_water *w, const struct flow_point *p, double *head) {
  if (w->c->flow->head) return w->c->flow->head(w, p, head);
  *head = flow_elevation(w, p->x, 0) - p->y;
  return OK;
}

const struct flow_line *flow_line_of(const struct case_file *c) {
  return c->flow->line ? c->flow->line(c) : NULL;
}

/* A surface that may hang over, from the right to the left, without its ends. */
static enum status draw_line(const struct flow_line *l, struct geo_lines *water) {
  size_t n;
  double *way;
  enum status status = flow_line_sample(l, 0, (l->to - l->from) / LINE_POINTS, &n, &way);
  for (size_t i = n; status == OK && i-- > 2;) {
    const struct flow_line_point at = flow_line_at(l, way[i - 1]);
    status = geo_lines_add(water, at.p[0], at.p[1]);
  }
  free(way);
  return status;
}

/* Parts of the surface over a width. */
static size_t count_parts(const struct flow_water *w, double width) {
  const double lengths = fmin(width / w->c->flow->scale(w->c).length, MOST_LENGTHS);
  return (size_t)ceil(lengths * OUTLINE_POINTS);
}

/* In a tank of any one wall; nothing where the water is not one body, as the check will say. */
static enum status draw_between_walls(const struct flow_water *w, struct geo_lines *water) {
  struct flow_edges e;
  geo_lines_clear(water);
  if (flow_find_edges(w, &e)) return OK;
  TRY(geo_lines_begin(water, true));
  TRY(geo_lines_add(water, e.at[0][0], e.at[0][1]));
  for (size_t i = e.side[0] + 1; i <= e.side[1]; i++)
    TRY(geo_lines_add(water, w->c->walls.p[i][0], w->c->walls.p[i][1]));
  TRY(geo_lines_add(water, e.at[1][0], e.at[1][1]));
  if (flow_line_of(w->c)) return draw_line(flow_line_of(w->c), water);
  const double left = e.at[0][0], width = e.at[1][0] - left;
  const size_t n = count_parts(w, width);
  for (size_t i = n; i-- > 1;) {
    double x = left + width * (double)i / (double)n;
    TRY(geo_lines_add(water, x, flow_elevation(w, x, 0)));
  }
  return OK;
}

static enum status draw(const struct flow_water *w, struct geo_lines *water) {
  const struct geo_box *tank = &w->c->tank;
  double left = tank->min[0], bed = tank->min[1], width = tank->max[0] - left;
  size_t n = count_parts(w, width);
  geo_lines_clear(water);
  TRY(geo_lines_begin(water, true));
  TRY(geo_lines_add(water, left, bed));
  TRY(geo_lines_add(water, tank->max[0], bed));
  for (size_t i = n + 1; i-- > 0;) {
    double x = left + width * (double)i / (double)n;
    TRY(geo_lines_add(water, x, flow_elevation(w, x, 0)));
  }
  return OK;
}

enum status flow_outline(const struct case_file *c, struct geo_lines *water) {
  struct flow_water w;
  if (flow_is_body(c->flow)) return c->flow->outline(c, water);
  enum status status = flow_open(c, (struct flow_use){0}, &w);
  if (status == OK)
    status = c->rectangular && !flow_line_of(c) ? draw(&w, water) : draw_between_walls(&w, water);
  flow_close(&w);
  return status;
}

#include "bem/start/start.h"

#include <math.h>
#include <string.h>

#include "bem/options.h"
#include "bem/start/basin.h"
#include "bem/start/drawn.h"
#include "bem/start/outline.h"
#include "common/flow/flow.h"
#include "common/flow/regions.h"

enum { FEWEST = 8 };                   /* nodes that a surface needs */
static const double DEEP = 4;          /* nodes over the mean depth of regions */
static const double MOST_POINTS = 1e5; /* of a lattice: each costs as much as an equation */

/* `length` of the surface in H. */
static void check_most(const struct case_run *r, double length, struct problems *problems) {
  if (length * r->resolution < BEM_MOST_NODES) return;
  problems_add(problems, case_run_line(r, "resolution"),
               "runs.%s.resolution: found '%.6g', %.0f nodes on the surface; allowed: fewer than "
               "%d nodes; lower it to %g",
               r->name, r->resolution, length * r->resolution, BEM_MOST_NODES,
               floor(0.5 * BEM_MOST_NODES / length));
}

/* The first cut would leave a film that is to be cut at once, at every step. */
static void check_film(const struct case_file *c, const struct case_run *r,
                       struct problems *problems) {
  const struct bem_options *o = r->options;
  if (o->film / c->H < BEM_IMPACT) return;
  problems_add(problems, r->line,
               "runs.%s.film: found %.4g m; allowed: less than %.4g m (%g H), the film's thickness "
               "when it is cut at the wall after the impact; make it thinner",
               r->name, o->film, BEM_IMPACT * c->H, BEM_IMPACT);
}

/* `length` of the `part` of the outline in H. */
static void check_fewest(const struct case_run *r, double length, const char *part,
                         struct problems *problems) {
  if (length * r->resolution >= FEWEST) return;
  problems_add(problems, case_run_line(r, "resolution"),
               "runs.%s.resolution: found '%.6g', %.3g nodes on the %s; allowed: at least %d "
               "nodes; raise it to %g",
               r->name, r->resolution, length * r->resolution, part, FEWEST, ceil(FEWEST / length));
}

/* The one velocity of all water at t = 0, m/s; false: some regions have another. */
static bool find_velocity(const struct case_file *c, double velocity[2]) {
  memcpy(velocity, c->regions_differ ? c->velocities[0] : c->velocity, sizeof c->velocity);
  for (size_t k = 1; c->regions_differ && k < c->water.pieces; k++)
    for (int axis = 0; axis < 2; axis++)
      if (c->velocities[k][axis] != velocity[axis]) return false;
  return true;
}

static void check_velocity(const struct case_file *c, const struct case_run *r,
                           struct problems *problems) {
  double velocity[2];
  if (!case_water_moves(c) || find_velocity(c, velocity)) return;
  problems_add(problems, case_run_line(r, "solver"),
               "runs.%s.solver: found 'bem' with regions that move in ways of their own; allowed: "
               "one velocity of all water; take another solver",
               r->name);
}

/* Of the surface that it has otherwise. */
static void check_outline(const struct case_file *c, const struct case_run *r,
                          struct problems *problems) {
  struct bem_outline o;
  const char *problem;
  if (bem_outline_find(c, &o, &problem) != OK) problems->out_of_memory = true;
  if (problem) bem_outline_refuse(r, problems, problem);
  const double length = bem_outline_length(&o) / c->H;
  if (!problem && length > 0) {
    bem_outline_check(&o, c, r, problems);
    check_fewest(r, length, "surface", problems);
    check_most(r, length, problems);
  }
  bem_outline_destroy(&o);
}

static void check_regions(const struct case_file *c, const struct case_run *r,
                          struct problems *problems) {
  struct flow_column column;
  struct geo_box b = geo_lines_box(&c->water);
  double wide = (b.max[0] - b.min[0]) / c->H, high = (b.max[1] - b.min[1]) / c->H;
  check_film(c, r, problems);
  if (flow_is_body(c->flow)) {
    bem_outline_refuse(r, problems, "water that floats");
    return;
  }
  if (!flow_find_column(c, &column)) {
    check_outline(c, r, problems);
    return;
  }
  check_fewest(r, fmin(wide, high), "shorter side of the water", problems);
  check_most(r, wide + high, problems);
}

/* Rows and columns so far apart miss the water. */
static void check_wide_lattice(const struct case_file *c, const struct case_run *r,
                               struct problems *problems) {
  const struct bem_options *o = r->options;
  const struct geo_box b = geo_lines_box(&c->water);
  const double most = 0.5 * fmin(b.max[0] - b.min[0], b.max[1] - b.min[1]);
  if (o->lattice <= most) return;
  problems_add(problems, case_run_line(r, "velocity_lattice"),
               "runs.%s.velocity_lattice: found %.4g m, more than half the height or the width of "
               "the water at t = 0; allowed: up to %.4g m; lower it",
               r->name, o->lattice, most);
}

/* Of the tank's box below the highest water at t = 0. */
static void check_lattice(const struct case_file *c, const struct case_run *r,
                          struct problems *problems) {
  const struct bem_options *o = r->options;
  const double height = geo_lines_box(&c->water).max[1] - c->tank.min[1];
  check_wide_lattice(c, r, problems);
  const double area = (c->tank.max[0] - c->tank.min[0]) * height;
  if (!(o->lattice > 0) || !(area / (o->lattice * o->lattice) > MOST_POINTS)) return;
  problems_add(problems, case_run_line(r, "velocity_lattice"),
               "runs.%s.velocity_lattice: found %.4g m, %.2g points under the highest water; "
               "allowed: up to %.0e points; widen it to %.2g m",
               r->name, o->lattice, area / (o->lattice * o->lattice), MOST_POINTS,
               ceil(sqrt(area / MOST_POINTS) * 1000) / 1000);
}

void bem_start_check(const struct case_file *c, const struct case_run *r,
                     struct problems *problems) {
  double width = (c->tank.max[0] - c->tank.min[0]) / c->H;
  if (!(c->gravity > 0))
    problems_add(problems, case_run_line(r, "solver"),
                 "runs.%s.solver: found 'bem' without gravity; allowed: gravity, which its scales "
                 "are made of; set fluid.gravity or take another solver",
                 r->name);
  if (c->periodic[0] && !flow_is_wave(c->flow))
    problems_add(problems, case_run_line(r, "solver"),
                 "runs.%s.solver: found 'bem' with regions of water in a tank with periodic sides; "
                 "allowed: a wave there; change tank.sides or take another solver",
                 r->name);
  check_velocity(c, r, problems);
  check_lattice(c, r, problems);
  if (case_is_turned(c))
    problems_add(problems, case_run_line(r, "solver"),
                 "runs.%s.solver: found 'bem' with gravity along (%g, %g); allowed: gravity "
                 "downwards; write fluid.gravity as one number or take another solver",
                 r->name, c->down[0], c->down[1]);
  if (bem_basin_is_mapped(c)) {
    bem_basin_check(c, r, problems, &width);
    width /= c->H;
    if (!(width > 0)) return;
  } else if (!flow_is_wave(c->flow)) {
    check_regions(c, r, problems);
    return;
  }
  check_fewest(r, width, "surface", problems);
  check_most(r, width, problems);
}

/* In other tanks the nodes are denser where the water is shallow. */
double bem_start_shallowest(const struct case_file *c) {
  if (flow_is_wave(c->flow) || bem_basin_is_mapped(c)) return 0;
  return DEEP * c->H / (case_rest_level(c) - c->tank.min[1]);
}

void bem_start_warn(const struct case_file *c, const struct case_run *r,
                    struct problems *warnings) {
  const double least = bem_start_shallowest(c);
  if (r->resolution < least * (1 - CASE_SAME))
    problems_add(warnings, case_run_line(r, "resolution"),
                 "resolution = %.4g: %.2g nodes over the mean depth of the water, where %g are "
                 "wanted: what falls back on it breaks up into spray that is no more than noise; "
                 "%g would do",
                 r->resolution, DEEP * r->resolution / least, DEEP, ceil(least));
}

/* From wall to wall, or round a tank without sides, with the potential that the flow has there. */
static enum status start_wave(const struct flow_water *w, double resolution, struct bem_flow *f) {
  const struct case_file *c = w->c;
  struct bem_surface *s = &f->surface;
  size_t last = (size_t)ceil(s->tank * resolution);
  double speed = sqrt(c->gravity * c->H);
  s->right = BEM_END_WALL;
  s->length = s->tank;
  if (c->periodic[0]) s->period = bem_period_create(s->tank, c->flow->scale(c).mean / c->H);
  if (flow_line_of(c)) return bem_drawn_start(c, flow_line_of(c), f);
  TRY(bem_surface_reserve(s, last + 1));
  double *x = s->state, *y = x + s->n, *phi = y + s->n;
  for (size_t k = 0; k < s->n; k++) {
    x[k] = s->tank * (double)k / (double)last;
    double at = c->tank.min[0] + c->H * x[k], eta = flow_elevation(w, at, 0);
    y[k] = (eta - c->tank.min[1]) / c->H;
    phi[k] = flow_potential(w, at, eta, 0) / (c->H * speed);
  }
  if (c->periodic[0]) y[last] = y[0];
  return OK;
}

/* At rest: from wall to wall, or over the top and down the free side of a released one. */
static enum status start_column(double wide, double high, struct bem_flow *f) {
  struct bem_surface *s = &f->surface;
  bool released = wide < s->tank * (1 - CASE_SAME);
  s->right = released ? BEM_END_BED : BEM_END_WALL;
  s->length = released ? 2 * s->tank : s->tank;
  s->tip = released ? BEM_TOE : 0;
  size_t top = (size_t)ceil(wide * f->mesh.resolution),
         side = released ? (size_t)ceil(high * f->mesh.resolution) : 0;
  s->corner = released ? top : 0;
  TRY(bem_surface_reserve(s, top + side + 1));
  double *x = s->state, *y = x + s->n, *phi = y + s->n;
  for (size_t k = 0; k < s->n; k++) {
    x[k] = k < top ? wide * (double)k / (double)top : wide;
    y[k] = k <= top ? high : high * (double)(s->n - 1 - k) / (double)side;
    phi[k] = 0;
  }
  if (released) /* the spacing at the toe is found by repetition */
    for (int i = 0; i < 4; i++) TRY(bem_mesh_regrid(&f->mesh, s));
  return OK;
}

/* Between upright walls under any other outline, or up to where it will run along the bed. */
static enum status start_outline(const struct case_file *c, const struct case_run *r,
                                 struct bem_flow *f) {
  struct bem_surface *s = &f->surface;
  struct bem_outline o;
  const char *problem;
  enum status status = bem_outline_find(c, &o, &problem);
  s->right = o.toe[1] ? BEM_END_BED : BEM_END_WALL;
  s->length = o.toe[1] ? 2 * s->tank : s->tank;
  ATTEMPT(status);
  ATTEMPT(bem_outline_start(&o, c, r, f));
done:
  bem_outline_destroy(&o);
  return status;
}

/* Water that all of it moves, in the frame of a tank that may move at once as well: what holds it
 * between walls acts by pressures that the surface does not bear. */
static void start_moving(const struct case_file *c, struct bem_flow *f) {
  const struct bem_surface *s = &f->surface;
  const double unit = sqrt(c->gravity * c->H);
  double *x = s->state, *y = x + s->n, *phi = y + s->n, velocity[2] = {0}, water[2];
  find_velocity(c, water);
  if (f->motion.frame) bem_motion_velocity(&f->motion, 0, velocity);
  for (int axis = 0; axis < 2; axis++) velocity[axis] -= water[axis] / unit;
  for (size_t k = 0; k < s->n; k++) phi[k] -= velocity[0] * x[k] + velocity[1] * y[k];
}

bool bem_start_is_rounded(const struct case_file *c) {
  struct flow_column column;
  struct bem_outline o;
  const char *problem;
  if (flow_is_wave(c->flow) || flow_is_body(c->flow)) return false;
  if (!bem_basin_is_mapped(c) && flow_find_column(c, &column)) return false;
  const bool bent = bem_outline_find(c, &o, &problem) == OK && !problem && o.chain.points > 2;
  bem_outline_destroy(&o);
  return bent;
}

static enum status start_regions(const struct case_file *c, const struct case_run *r,
                                 struct bem_flow *f) {
  struct flow_column column;
  const struct geo_box *b = &column.box;
  if (!flow_find_column(c, &column)) return start_outline(c, r, f);
  const double wide = (b->max[0] - b->min[0]) / c->H, high = (b->max[1] - b->min[1]) / c->H;
  f->level = wide * high / f->surface.tank;
  return start_column(wide, high, f);
}

static enum status start_at_rest(const struct case_file *c, const struct case_run *r,
                                 struct bem_shore *shore, struct bem_flow *f) {
  f->mesh.resolution = r->resolution;
  f->motion = bem_motion_create(c);
  f->surface.tank = (c->tank.max[0] - c->tank.min[0]) / c->H;
  f->level = (case_rest_level(c) - c->tank.min[1]) / c->H;
  if (shore) return bem_basin_start(c, r, shore, f);
  if (!flow_is_wave(c->flow)) return start_regions(c, r, f);
  f->level = c->flow->scale(c).mean / c->H;
  struct flow_water w;
  enum status status = flow_open(c, (struct flow_use){0}, &w);
  if (status == OK) status = start_wave(&w, r->resolution, f);
  flow_close(&w);
  return status;
}

enum status bem_start_surface(const struct case_file *c, const struct case_run *r,
                              struct bem_shore *shore, struct bem_flow *f) {
  TRY(start_at_rest(c, r, shore, f));
  if (f->motion.frame || case_water_moves(c)) start_moving(c, f);
  return OK;
}

/* Whether tank and water make sense: walls and regions that do not meet themselves or each other,
 * water in the tank, waves that fit into it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/geometry_check.h"
#include "common/case/case_draft.h"
#include "common/flow/edges.h"
#include "common/tank/room.h"

static const double LEAST_GAP = 0.01; /* of the tank's size */

/* ---- geometry ---- */

static int item_line(struct case_draft *d, int section, const char *key, size_t i) {
  int list = case_doc_member(&d->doc, section, key);
  return case_doc_line(&d->doc,
                       i < case_doc_size(&d->doc, list) ? case_doc_item(&d->doc, list, i) : list);
}

static int wall_line(struct case_draft *d, size_t k) {
  return item_line(d, d->at.tank, "walls", d->wall_item[k]);
}

/* Two equal points in a row, and a piece that meets itself. True when there is neither. */
static bool check_piece(struct case_draft *d, const struct geo_lines *l, size_t k, int line,
                        const char *path, const char *noun) {
  char found[128];
  bool simple;
  double at[2] = {0};
  size_t a = l->first[k], b = l->first[k + 1];
  for (size_t i = a; i + !l->closed[k] < b; i++) {
    const double *p = l->p[i], *q = l->p[i + 1 < b ? i + 1 : a];
    if (p[0] != q[0] || p[1] != q[1]) continue;
    snprintf(found, sizeof found, "the point (%.6g, %.6g) m twice in a row", p[0], p[1]);
    case_doc_problem(&d->doc, line, path, found, "points that differ", "remove one");
    return false;
  }
  if (geo_piece_simple(l, k, l->closed[k], &simple, at) != OK) {
    d->doc.problems->out_of_memory = true;
    return false;
  }
  if (simple) return true;
  snprintf(found, sizeof found, "a %s that crosses or touches itself at (%.6g, %.6g) m", noun,
           at[0], at[1]);
  char allowed[64];
  snprintf(allowed, sizeof allowed, "a %s that does not meet itself", noun);
  case_doc_problem(&d->doc, line, path, found, allowed, "correct its points or their order");
  return false;
}

/* The wall that makes the tank leaves a room between itself and the line from end to end. */
static bool check_vessel(struct case_draft *d, size_t k) {
  const struct geo_lines *w = &d->c->walls;
  bool simple;
  double at[2] = {0};
  char path[CASE_PATH], found[128];
  int line = wall_line(d, k);
  snprintf(path, sizeof path, "tank.walls[%zu]", d->wall_item[k]);
  if (geo_piece_simple(w, k, true, &simple, at) != OK) {
    d->doc.problems->out_of_memory = true;
    return false;
  }
  if (!simple) {
    snprintf(found, sizeof found, "a wall that meets the line between its ends at (%.6g, %.6g) m",
             at[0], at[1]);
    case_doc_problem(&d->doc, line, path, found, "a wall that is open to one side",
                     "extend its ends");
    return false;
  }
  if (geo_piece_area(w, k) > 0) return true;
  case_doc_problem(&d->doc, line, path, "a wall with the tank on its right",
                   "water on the left: down the left side, along the bed, up the right side",
                   "reverse the order of its points");
  return false;
}

/* A gap that nobody sees is a slip of the pen; water leaves through wider ones. */
static bool check_gaps(struct case_draft *d) {
  const double least = LEAST_GAP * case_tank_size(d->c);
  struct tank_gap gap;
  char path[CASE_PATH], found[128], allowed[96];
  if (!tank_find_gap(&d->c->walls, &gap) || gap.width >= least) return true;
  snprintf(path, sizeof path, "tank.walls[%zu]", d->wall_item[gap.wall[1]]);
  snprintf(found, sizeof found, "a gap of %.6g m to walls[%zu] at (%.6g, %.6g) m", gap.width,
           d->wall_item[gap.wall[0]], gap.at[0], gap.at[1]);
  snprintf(allowed, sizeof allowed, "walls that meet, or that are at least %.3g m apart", least);
  case_doc_problem(&d->doc, wall_line(d, gap.wall[1]), path, found, allowed,
                   "let one begin where the other ends");
  return false;
}

/* A closed wall in the tank keeps water out. */
static bool check_obstacles(struct case_draft *d) {
  const struct geo_lines *w = &d->c->walls;
  const size_t vessel = geo_lines_vessel(w);
  char path[CASE_PATH];
  for (size_t k = 0; k < w->pieces; k++) {
    if (!w->closed[k] || vessel == w->pieces || geo_piece_area(w, k) < 0) continue;
    snprintf(path, sizeof path, "tank.walls[%zu]", d->wall_item[k]);
    case_doc_problem(&d->doc, wall_line(d, k), path, "a closed wall with its water inside",
                     "in a tank that another wall makes: obstacles, with the water outside, "
                     "clockwise",
                     "reverse the order of its points");
    return false;
  }
  return true;
}

void case_check_walls(struct case_draft *d) {
  const struct geo_lines *w = &d->c->walls;
  char path[CASE_PATH], found[96];
  bool good = true;
  for (size_t k = 0; k < w->pieces; k++) {
    snprintf(path, sizeof path, "tank.walls[%zu]", d->wall_item[k]);
    good &= check_piece(d, w, k, wall_line(d, k), path, "wall");
  }
  for (size_t k = 1; good && k < w->pieces; k++)
    for (size_t j = 0; j < k; j++) {
      bool cross;
      if (geo_pieces_cross(w, j, k, &cross) != OK)
        d->doc.problems->out_of_memory = true;
      else if (cross) {
        snprintf(path, sizeof path, "tank.walls[%zu]", d->wall_item[k]);
        snprintf(found, sizeof found, "a wall that crosses or covers walls[%zu]", d->wall_item[j]);
        case_doc_problem(&d->doc, wall_line(d, k), path, found,
                         "walls that meet at their ends at most", "correct its points");
        good = false;
      }
    }
  size_t vessel = geo_lines_vessel(w);
  if (good && vessel < w->pieces) good = check_vessel(d, vessel);
  if (good && !(d->c->tank.max[0] > d->c->tank.min[0])) {
    case_doc_problem(&d->doc, case_doc_member_line(&d->doc, d->at.tank, "walls"), "tank.walls",
                     "a tank without width", "walls that span some width", "add the bed");
    good = false;
  }
  if (good) good = check_obstacles(d) && check_gaps(d);
  d->good.tank = good;
}

static void check_region_in_tank(struct case_draft *d, size_t k, int line, const char *path) {
  const struct case_file *c = d->c;
  double part = 0, at[2] = {0};
  char found[128];
  enum status status = geo_piece_outside(&c->water, k, &c->walls, &part, at);
  if (status == OK && part > CASE_SAME * geo_piece_area(&c->water, k)) {
    snprintf(found, sizeof found, "water outside the tank, at (%.6g, %.6g) m for one", at[0],
             at[1]);
    case_doc_problem(&d->doc, line, path, found, "regions inside tank.walls",
                     c->walls.pieces > 1 && !c->walls.closed[0] && !c->walls.closed[1]
                         ? "move the region, or join the walls to one round the water"
                         : "move the region or the walls");
    return;
  }
  if (status == OK) status = geo_piece_crossed(&c->water, k, &c->walls, case_near(c), &part, at);
  if (status != OK)
    d->doc.problems->out_of_memory = true;
  else if (part > CASE_SAME * case_tank_size(c)) {
    snprintf(found, sizeof found, "a wall through the water, at (%.6g, %.6g) m for one", at[0],
             at[1]);
    case_doc_problem(&d->doc, line, path, found, "walls along the rim of a region at most",
                     "move the region or the wall");
  }
}

static void check_regions(struct case_draft *d) {
  struct geo_lines *w = &d->c->water;
  char path[CASE_PATH], found[128];
  bool good = true;
  for (size_t k = 0; k < w->pieces; k++) {
    int line = item_line(d, d->at.water, "regions", k);
    snprintf(path, sizeof path, "water.regions[%zu]", k);
    if (!check_piece(d, w, k, line, path, "region")) {
      good = false;
      continue;
    }
    double area = geo_piece_area(w, k);
    if (area < 0) geo_piece_reverse(w, k); /* either sense says the same water */
    if (d->good.tank) check_region_in_tank(d, k, line, path);
  }
  for (size_t k = 1; good && k < w->pieces; k++)
    for (size_t j = 0; j < k; j++) {
      double area;
      if (geo_pieces_overlap(w, j, k, &area) != OK)
        d->doc.problems->out_of_memory = true;
      else if (area > CASE_SAME * geo_piece_area(w, k)) {
        snprintf(path, sizeof path, "water.regions[%zu]", k);
        snprintf(found, sizeof found, "%.6g m^2 in common with regions[%zu]", area, j);
        case_doc_problem(&d->doc, item_line(d, d->at.water, "regions", k), path, found,
                         "regions that do not overlap", "join them or move one");
        good = false;
      }
    }
  d->good.water = good;
}

void case_flow_problem(struct case_draft *d, const char *key, const char *found,
                       const char *allowed, const char *todo) {
  const struct flow *f = d->c->flow;
  const char *form = flow_is_wave(f) ? "wave" : flow_is_body(f) ? "body" : NULL;
  int node = form ? case_doc_member(&d->doc, d->at.water, form) : d->at.water;
  char path[CASE_PATH];
  snprintf(path, sizeof path, "water%s%s%s%s", form ? "." : "", form ? form : "", key ? "." : "",
           key ? key : "");
  case_doc_problem(&d->doc,
                   key ? case_doc_member_line(&d->doc, node, key) : case_doc_line(&d->doc, node),
                   path, found, allowed, todo);
}

/* In a tank that is not rectangular: one body of water; whether the bed is one for the wave is its
 * own check. */
static bool check_wave_between_walls(struct case_draft *d) {
  const struct case_file *c = d->c;
  struct flow_water w;
  struct flow_edges edges;
  if (c->flow->round || c->walls.pieces != 1 || c->walls.closed[0]) {
    case_flow_problem(d, NULL, "a wave in a tank that is not rectangular",
                      "one wall: down the left side, along a flat bed, up the right side",
                      "change tank.walls or give water.regions");
    return false;
  }
  if (flow_line_of(c)) return true; /* the check of its own says more */
  const char *problem = NULL;
  if (flow_open(c, (struct flow_use){0}, &w) == OK)
    problem = flow_find_edges(&w, &edges);
  else
    d->doc.problems->out_of_memory = true;
  flow_close(&w);
  if (problem)
    case_flow_problem(d, "depth", problem, "one body of water from wall to wall below one surface",
                      "change it, or the walls");
  return !problem;
}

/* What every wave asks of the tank that it fills. */
static void check_tank_of_wave(struct case_draft *d) {
  const struct case_file *c = d->c;
  const struct flow_scale scale = c->flow->scale(c);
  double height = c->tank.max[1] - c->tank.min[1], crest = scale.depth + scale.amplitude;
  char found[96], allowed[128];
  if (!c->rectangular && !check_wave_between_walls(d)) return;
  if (!(c->gravity > 0))
    case_flow_problem(d, "kind", "a wave without gravity", "a wave that gravity brings back",
                      "set fluid.gravity or give water.regions");
  if (case_is_turned(c))
    case_flow_problem(d, "kind", "a wave under gravity that is not downwards",
                      "gravity downwards, as waves have it",
                      "write fluid.gravity as one number or give water.regions");
  if (c->flow->round && !c->periodic[0]) {
    snprintf(found, sizeof found, "'%s' between walls", flow_name(c->flow));
    case_flow_problem(d, "kind", found, "a wave that walls keep, standing",
                      "write tank.sides: periodic");
  }
  if (c->rectangular && !flow_line_of(c) && crest > height * (1 + CASE_SAME)) {
    snprintf(found, sizeof found, "crests %.6g m above the bed", crest);
    snprintf(allowed, sizeof allowed, "up to the walls' top, %.6g m", height);
    case_flow_problem(d, "depth", found, allowed, "make the walls higher");
  }
}

static void check_tank_of_body(struct case_draft *d) {
  const struct case_file *c = d->c;
  if (!c->rectangular)
    case_flow_problem(d, NULL, "a body in a tank that is not rectangular",
                      "one wall: down the left side, along a flat bed, up the right side",
                      "change tank.walls or give water.regions");
  if (c->gravity > 0)
    case_flow_problem(d, "kind", "a body under gravity", "a body that floats",
                      "set fluid.gravity to 0 and give scales.g");
}

/* The water's own, if it has a form. */
static void check_no_velocity(struct case_draft *d) {
  const struct case_file *c = d->c;
  const char *noun = flow_is_wave(c->flow) ? "wave" : "body";
  char found[96], todo[96];
  if (c->velocity[0] == 0 && c->velocity[1] == 0) return;
  snprintf(found, sizeof found, "a velocity with a %s", noun);
  if (flow_is_wave(c->flow))
    snprintf(todo, sizeof todo, "remove it: a %s wave %s", flow_name(c->flow),
             c->flow->at_rest ? "starts at rest" : "has its own");
  else
    snprintf(todo, sizeof todo, "remove it: a %s has its own", flow_name(c->flow));
  case_doc_problem(&d->doc, case_doc_member_line(&d->doc, d->at.water, "velocity"),
                   "water.velocity", found, "a velocity of regions", todo);
}

static void check_form(struct case_draft *d) {
  const struct case_file *c = d->c;
  if (d->good.tank) {
    if (flow_is_wave(c->flow))
      check_tank_of_wave(d);
    else
      check_tank_of_body(d);
    check_no_velocity(d);
  }
  if (c->flow->check) c->flow->check(c, d);
}

/* Regions choose their pressure; it is the own of waves and bodies. */
static void check_pressure(struct case_draft *d) {
  const struct case_file *c = d->c;
  const char *name = flow_region_names[d->pressure];
  char found[96], allowed[96];
  if (!c->flow->scale) {
    if (c->flow->check) c->flow->check(c, d);
    return;
  }
  if (d->pressure == 0) return;
  snprintf(found, sizeof found, "'%s' with a %s", name, flow_is_wave(c->flow) ? "wave" : "body");
  snprintf(allowed, sizeof allowed, "%s for regions of water", name);
  case_doc_problem(&d->doc, case_doc_member_line(&d->doc, d->at.water, "pressure"),
                   "water.pressure", found, allowed, "write hydrostatic");
}

void case_check_geometry(struct case_draft *d) {
  struct case_file *c = d->c;
  size_t faults = d->doc.faults;
  if (d->good.tank) case_check_walls(d);
  if (d->good.tank && c->periodic[1] && (!c->periodic[0] || c->gravity > 0))
    case_doc_problem(&d->doc, case_doc_member_line(&d->doc, d->at.tank, "bed"), "tank.bed",
                     c->gravity > 0 ? "'periodic' with gravity" : "'periodic' between walls",
                     "a periodic bed between periodic sides, without gravity",
                     c->gravity > 0 ? "set fluid.gravity to 0" : "write sides: periodic");
  if (d->good.tank && c->periodic[0] && !tank_can_be_round(&c->walls, case_near(c)))
    case_doc_problem(&d->doc, case_doc_member_line(&d->doc, d->at.tank, "sides"), "tank.sides",
                     "'periodic' with walls that do not go on at the other side",
                     "one wall: down an upright left side, along a bed that ends as high as it "
                     "begins and never goes back, up an upright right side",
                     "change tank.walls or write walls");
  if (d->good.water && c->flow->scale)
    check_form(d);
  else if (d->good.water)
    check_regions(d);
  d->good.shapes = d->good.water && d->good.tank && d->doc.faults == faults;
  if (d->good.water && d->good.tank) check_pressure(d);
}

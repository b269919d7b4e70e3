/* Polylines of a case: walls, and regions of water with a velocity of their own. */
#include <math.h>
#include <stdlib.h>

#include "common/base/array.h"
#include "common/case/case_draft.h"
#include "common/tank/room.h"

enum { MOST_POINTS = 20000 };

static const struct param coordinate = {
    .type = PARAM_REAL, .quantity = QTY_LENGTH, .min = -1e6, .max = 1e6};
static const struct param speed = {
    .type = PARAM_REAL, .quantity = QTY_VELOCITY, .min = -1e6, .max = 1e6};

bool case_read_pair(struct case_doc *doc, int node, const char *path, const struct param *row,
                    const char *what, double out[2]) {
  bool good = case_doc_expect_list(doc, node, path, 2, 2, what);
  for (size_t k = 0; good && k < 2; k++) {
    char item[CASE_PATH + 64];
    snprintf(item, sizeof item, "%s[%zu]", path, k);
    good = case_doc_value(doc, case_doc_item(doc, node, k), item, row, &out[k]);
  }
  return good;
}

bool case_read_point(struct case_doc *doc, int node, const char *path, double out[2]) {
  return case_read_pair(doc, node, path, &coordinate, "lengths [x, y]", out);
}

bool case_read_velocity(struct case_doc *doc, int node, const char *path, double out[2]) {
  return case_read_pair(doc, node, path, &speed, "velocities [u, v]", out);
}

/* A piece whose last point is its first is closed. */
static void close_ring(struct geo_lines *l) {
  const size_t a = l->first[l->pieces - 1], b = l->points;
  if (b <= a + 2 || l->p[a][0] != l->p[b - 1][0] || l->p[a][1] != l->p[b - 1][1]) return;
  l->first[l->pieces] = --l->points;
  l->closed[l->pieces - 1] = 1;
}

/* Adds one piece; *more is false when nothing that follows can make sense. */
static enum status read_piece(struct case_doc *doc, int node, const char *name, size_t n_min,
                              bool closed, struct geo_lines *out, bool *more) {
  char item[CASE_PATH + 32];
  if (!case_doc_expect_list(doc, node, name, n_min, MOST_POINTS, "points [x, y]")) return OK;
  if (!case_doc_is_list(doc, case_doc_item(doc, node, 0))) {
    case_doc_problem(doc, case_doc_line(doc, node), name, "a list without points",
                     "a list of points [x, y]", "put one more pair of brackets round the points");
    *more = false;
    return OK;
  }
  TRY(geo_lines_begin(out, closed));
  for (size_t i = 0; i < case_doc_size(doc, node); i++) {
    double p[2];
    snprintf(item, sizeof item, "%s[%zu]", name, i);
    if (case_read_point(doc, case_doc_item(doc, node, i), item, p))
      TRY(geo_lines_add(out, p[0], p[1]));
  }
  return OK;
}

/* False, with a problem, when the points are too many to make sense of. */
static bool few_enough(struct case_doc *doc, int node, const char *path,
                       const struct geo_lines *l) {
  char found[64];
  if (l->points <= MOST_POINTS) return true;
  snprintf(found, sizeof found, "more than %d points", MOST_POINTS);
  case_doc_problem(doc, case_doc_line(doc, node), path, found, "as few points as tell the shape",
                   "leave points out");
  return false;
}

enum status case_read_walls(struct case_draft *d, int node) {
  struct case_doc *doc = &d->doc;
  struct geo_lines *out = &d->c->walls;
  const size_t faults = doc->faults;
  bool more = true;
  geo_lines_clear(out);
  if (!case_doc_expect_list(doc, node, "tank.walls", 1, CASE_MOST_ITEMS,
                            "walls, each a list of points"))
    return OK;
  for (size_t k = 0; k < case_doc_size(doc, node) && more; k++) {
    char name[CASE_PATH];
    snprintf(name, sizeof name, "tank.walls[%zu]", k);
    const size_t pieces = out->pieces;
    TRY(read_piece(doc, case_doc_item(doc, node, k), name, 2, false, out, &more));
    if (out->pieces > pieces) close_ring(out);
    more &= few_enough(doc, node, "tank.walls", out);
  }
  for (size_t k = 0; k < out->pieces; k++) d->wall_item[k] = k;
  if (doc->faults > faults) return OK;
  const struct geo_box box = geo_lines_box(out);
  const double size = fmax(box.max[0] - box.min[0], box.max[1] - box.min[1]);
  return tank_join_walls(out, CASE_SAME * size, d->wall_item);
}

struct region_section {
  int points, velocity;
};
static const struct param region_rows[] = {
    NODE(struct region_section, points, NULL, "a list of points [x, y]"),
    NODE(struct region_section, velocity, "", "a list of 2 velocities [u, v]"),
};
const struct case_table case_line_tables[] = {
    {"water.regions (a list of lists of points, or of mappings)", region_rows, ROWS(region_rows)},
    {0},
};

/* The points of a region, which is a list of them or a mapping that has more to say; 0: neither. */
static int read_region(struct case_draft *d, int node, const char *name, char path[CASE_PATH],
                       double velocity[2]) {
  struct region_section s = {0};
  char key[CASE_PATH + 16];
  snprintf(path, CASE_PATH, "%s", name);
  if (!case_doc_is_mapping(&d->doc, node)) return node;
  snprintf(path, CASE_PATH, "%.*s.points", CASE_PATH - 16, name);
  if (!case_read_section(d, node, name, region_rows, ROWS(region_rows), &s)) return 0;
  snprintf(key, sizeof key, "%s.velocity", name);
  if (s.velocity && case_read_velocity(&d->doc, s.velocity, key, velocity))
    d->c->regions_differ = true;
  return s.points;
}

enum status case_read_regions(struct case_draft *d, int node) {
  struct case_doc *doc = &d->doc;
  struct case_file *c = d->c;
  bool more = true;
  geo_lines_clear(&c->water);
  free(c->velocities);
  c->velocities = NULL;
  c->regions_differ = false;
  if (!case_doc_expect_list(doc, node, "water.regions", 1, CASE_MOST_ITEMS,
                            "regions, each a list of points"))
    return OK;
  TRY(array_create(&c->velocities, case_doc_size(doc, node), "regions of water"));
  for (size_t k = 0; k < case_doc_size(doc, node) && more; k++) {
    char name[CASE_PATH], path[CASE_PATH];
    double *velocity = c->velocities[c->water.pieces];
    velocity[0] = c->velocity[0];
    velocity[1] = c->velocity[1];
    snprintf(name, sizeof name, "water.regions[%zu]", k);
    int points = read_region(d, case_doc_item(doc, node, k), name, path, velocity);
    if (!points) continue;
    const size_t pieces = c->water.pieces;
    TRY(read_piece(doc, points, path, 3, true, &c->water, &more));
    if (c->water.pieces > pieces) close_ring(&c->water);
    more &= few_enough(doc, node, "water.regions", &c->water);
  }
  return OK;
}

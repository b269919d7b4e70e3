#include "common/flow/edges.h"

#include <math.h>
#include <string.h>

#include "common/case/case.h"
#include "common/flow/line.h"

enum { SAMPLES = 32 }; /* of a segment of the wall, at which it must be under water */

/* Depth under the surface of a point of a segment of the wall. */
static double depth_at(const struct flow_water *w, size_t segment, double part, double at[2]) {
  const double *a = w->c->walls.p[segment], *b = w->c->walls.p[segment + 1];
  for (int axis = 0; axis < 2; axis++) at[axis] = a[axis] + part * (b[axis] - a[axis]);
  return flow_elevation(w, at[0], 0) - at[1];
}

/* The point of a segment at which the surface meets it: `dry` and `wet` are its ends, 0 and 1. */
static void find_edge(const struct flow_water *w, size_t segment, double dry, double wet,
                      double at[2]) {
  for (int i = 0; i < 60; i++) { /* until there is no number between them */
    const double middle = (dry + wet) / 2;
    if (depth_at(w, segment, middle, at) > 0)
      wet = middle;
    else
      dry = middle;
  }
  depth_at(w, segment, wet, at);
}

static bool covered(const struct flow_water *w, const struct flow_edges *e) {
  double at[2];
  for (size_t i = e->side[0]; i <= e->side[1]; i++) {
    if (i > e->side[0] && !(depth_at(w, i, 0, at) > 0)) return false;
    for (int j = 1; j < SAMPLES && i > e->side[0] && i < e->side[1]; j++)
      if (!(depth_at(w, i, (double)j / SAMPLES, at) > 0)) return false;
  }
  return true;
}

/* The segment of the wall that is nearest to a point, and how near. */
static size_t find_side(const struct geo_lines *walls, const double p[2], double *distance) {
  size_t side = 0;
  *distance = INFINITY;
  for (size_t i = 0; i + 1 < walls->points; i++) {
    double foot[2];
    geo_segment_foot(walls->p[i], walls->p[i + 1], p, foot);
    const double here = hypot(foot[0] - p[0], foot[1] - p[1]);
    if (here >= *distance) continue;
    *distance = here;
    side = i;
  }
  return side;
}

const char *flow_line_edges(const struct geo_lines *walls, const struct flow_line *line,
                            double near, struct flow_edges *e) {
  static const char *const off[] = {"a surface that begins on no wall",
                                    "a surface that ends on no wall"};
  for (int end = 0; end < 2; end++) {
    double distance;
    const struct flow_line_point at = flow_line_at(line, end ? line->to : line->from);
    memcpy(e->at[end], at.p, sizeof at.p);
    e->side[end] = find_side(walls, at.p, &distance);
    if (distance > near) return off[end];
  }
  return e->side[0] < e->side[1] ? NULL : "a surface that runs to the left, or back to its wall";
}

const char *flow_find_edges(const struct flow_water *w, struct flow_edges *e) {
  const struct geo_lines *walls = &w->c->walls;
  double at[2];
  if (walls->pieces != 1 || walls->closed[0] || walls->points < 2) return "walls of several pieces";
  if (flow_line_of(w->c)) return flow_line_edges(walls, flow_line_of(w->c), case_near(w->c), e);
  const size_t last = walls->points - 2;
  if (depth_at(w, 0, 0, at) > 0) return "water above the top of the left side";
  if (depth_at(w, last, 1, at) > 0) return "water above the top of the right side";
  size_t i = 0, j = last;
  while (i < last && !(depth_at(w, i, 1, at) > 0)) i++;
  while (j > 0 && !(depth_at(w, j, 0, at) > 0)) j--;
  if (i >= j) return "no water";
  find_edge(w, i, 0, 1, e->at[0]);
  find_edge(w, j, 1, 0, e->at[1]);
  e->side[0] = i;
  e->side[1] = j;
  return covered(w, e) ? NULL : "walls that come out of the water between its edges";
}

/* Of a wall, whose segment i is on the bed and level; what goes on level beside it belongs to it.
 */
static struct flow_flat flat_at(const struct geo_lines *walls, size_t k, size_t i, double near) {
  size_t j = i + 1;
  const double bed = walls->p[i][1];
  while (i > walls->first[k] && fabs(walls->p[i - 1][1] - bed) <= near &&
         walls->p[i - 1][0] < walls->p[i][0])
    i--;
  while (j + 1 < walls->first[k + 1] && fabs(walls->p[j + 1][1] - bed) <= near &&
         walls->p[j + 1][0] > walls->p[j][0])
    j++;
  return (struct flow_flat){walls->p[i][0], walls->p[j][0], bed};
}

bool flow_find_flat(const struct case_file *c, double x, struct flow_flat *f) {
  const struct geo_lines *walls = &c->walls;
  const double near = case_near(c);
  bool found = false;
  for (size_t k = 0; k < walls->pieces; k++)
    for (size_t i = walls->first[k]; i + 1 < walls->first[k + 1]; i++) {
      const double *a = walls->p[i], *b = walls->p[i + 1];
      const bool level = b[0] > a[0] && fabs(b[1] - a[1]) <= near;
      if (!level || x < a[0] || x > b[0] || (found && a[1] >= f->bed)) continue;
      *f = flat_at(walls, k, i, near);
      found = true;
    }
  return found;
}

/* Regions whose pressure counts from the surface that stands above each point, regions that touch
 * being one water. Under a wall (an obstacle, an overhang, a lid) that is the level of the water
 * round it: the rim of the water is followed along the wall to where a surface begins, of its two
 * ends the higher one; an obstacle that is under water all round counts from what stands above its
 * top. Where the water below the point ends above the walls, it falls free and has none. Above and
 * below are as gravity has them, whose direction may be any.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/geometry_check.h"
#include "common/flow/flow.h"
#include "common/flow/regions.h"
#include "common/flow/release_rim.h"

struct standing_water {
  struct geo_lines turned;  /* the regions, with gravity downwards */
  struct geo_cut cut;       /* the water above and below a point */
  struct release_rims rims; /* of all water */
};

static enum status create(struct flow_water *w) {
  const struct case_file *c = w->c;
  struct standing_water *own = w->own = calloc(1, sizeof *own);
  CHECK(own, ERR_MEMORY, "no memory for a cut through the water");
  if (w->use.spacing == 0 || !(c->gravity > 0)) return OK;
  TRY(case_turn_lines(c, &c->water, &own->turned));
  return release_rims_create(&c->water, &c->walls, 0, case_near(c), &own->rims);
}

static void destroy(struct flow_water *w) {
  struct standing_water *own = w->own;
  if (!own) return;
  release_rims_destroy(&own->rims);
  geo_cut_destroy(&own->cut);
  geo_lines_destroy(&own->turned);
  free(own);
}

static bool is_on_wall(const struct case_file *c, const double p[2]) {
  double nearest[2];
  size_t piece;
  return geo_lines_distance(&c->walls, p[0], p[1], nearest, &piece) <= case_near(c);
}

static double height(const struct case_file *c, const double p[2]) {
  return -c->down[0] * p[0] - c->down[1] * p[1];
}

/* From the foot of the water that is around a point to its top, up the vertical; NULL: none is. */
static enum status cut(const struct flow_water *w, const double p[2], const double **span) {
  const double *down = w->c->down;
  struct standing_water *own = w->own;
  const double across = down[0] * p[1] - down[1] * p[0];
  TRY(geo_lines_cut(&own->turned, 0, across, case_near(w->c), &own->cut));
  *span = geo_cut_span(&own->cut, height(w->c, p));
  return OK;
}

/* The point of the vertical through p at a height. */
static void lift(const struct case_file *c, const double p[2], double to, double out[2]) {
  const double rise = to - height(c, p);
  for (int k = 0; k < 2; k++) out[k] = p[k] - rise * c->down[k];
}

/* ---- round what is above ---- */

/* The edge of the water's rim that a point lies on; NULL: the rim has none. */
static const struct release_rim *rim_at(const struct release_rims *r, const double p[2]) {
  const struct release_rim *best = NULL;
  double least = INFINITY;
  for (size_t i = 0; i < r->n; i++) {
    const struct release_rim *e = &r->edge[i];
    double foot[2];
    geo_segment_foot(e->end[0], e->end[1], p, foot);
    const double away = hypot(p[0] - foot[0], p[1] - foot[1]);
    if (e->kind == RELEASE_SLIT || away >= least) continue;
    least = away;
    best = e;
  }
  return best;
}

/* Periodic sides are no surface either: the rim goes on to the other side's. */
static bool is_held(const struct case_file *c, const struct release_rim *e) {
  const double near = case_near(c);
  bool aside[2];
  for (int k = 0; k < 2; k++)
    aside[k] =
        fabs(e->end[k][0] - c->tank.min[0]) <= near || fabs(e->end[k][0] - c->tank.max[0]) <= near;
  const bool upright = fabs(e->end[0][0] - e->end[1][0]) <= near;
  return e->kind == RELEASE_WALL || (c->periodic[0] && aside[0] && aside[1] && upright);
}

/* The wall that an edge of the rim is part of: where it ends. */
struct shore {
  double level;          /* m: the higher of the places where a surface begins */
  bool has_surface;      /* on that closed line */
  const double *highest; /* place of the wall, m */
};

/* Adds what is met on the way along a closed line, `step` edges at a time of its n. */
static void follow(const struct case_file *c, const struct release_rim *ring, size_t n, size_t from,
                   size_t step, struct shore *s) {
  const bool back = step > 1;
  for (size_t i = 0, k = from; i < n; i++, k = (k + step) % n) {
    const double *begin = ring[k].end[back], *end = ring[k].end[!back];
    if (!is_held(c, &ring[k])) {
      s->level = fmax(s->level, height(c, begin));
      s->has_surface = true;
      return;
    }
    if (height(c, end) > height(c, s->highest)) s->highest = end;
  }
}

static struct shore shore_of(const struct case_file *c, const struct release_rims *r, size_t from) {
  struct shore s = {-INFINITY, false, r->edge[from].end[0]};
  size_t first = from, end = from + 1;
  while (first > 0 && r->edge[first - 1].ring == r->edge[from].ring) first--;
  while (end < r->n && r->edge[end].ring == r->edge[from].ring) end++;
  const size_t n = end - first;
  follow(c, &r->edge[first], n, from - first, 1, &s);
  follow(c, &r->edge[first], n, from - first, n - 1, &s);
  return s;
}

/* The level of the water around a point whose vertical ends at `top` (m). */
static enum status find_level(const struct flow_water *w, const double p[2], double top,
                              double *level) {
  const struct case_file *c = w->c;
  const struct release_rims *r = &((const struct standing_water *)w->own)->rims;
  double at[2];
  *level = top;
  for (lift(c, p, top, at); is_on_wall(c, at); lift(c, at, *level, at)) {
    const struct release_rim *rim = rim_at(r, at);
    if (!rim || !is_held(c, rim)) return OK;
    const struct shore shore = shore_of(c, r, (size_t)(rim - r->edge));
    *level = fmax(*level, shore.level);
    if (shore.has_surface || height(c, shore.highest) <= *level + case_near(c)) return OK;
    const double *span;
    memcpy(at, shore.highest, sizeof at);
    TRY(cut(w, at, &span));
    *level = fmax(height(c, at), span ? span[1] : -INFINITY);
  }
  return OK;
}

static enum status head(const struct flow_water *w, const struct flow_point *p, double *out) {
  const struct case_file *c = w->c;
  const double at[2] = {p->x, p->y}, up = height(c, at);
  const double *span;
  double foot[2], level;
  *out = 0;
  if (!(c->gravity > 0)) return OK;
  TRY(cut(w, at, &span));
  if (!span) return OK;
  lift(c, at, span[0], foot);
  if (!is_on_wall(c, foot)) return OK;
  TRY(find_level(w, at, span[1], &level));
  *out = fmax(level - up, 0);
  return OK;
}

const struct flow flow_hydrostatic = {
    .example = "regions: [[[0, 0], [4, 0], [4, 0.5], [0, 0.5]], [[0, 0.5], [1, 0.5], [0, 1.5]]]",
    .create = create,
    .destroy = destroy,
    .velocity = flow_regions_velocity,
    .head = head,
};

/* Regions whose pressure counts from the surface that stands above each point, regions that touch
 * being one water. Where the water below the point ends above the walls, it falls free and has
 * none. Above and below are as gravity has them, whose direction may be any.
 */
#include <math.h>
#include <stdlib.h>

#include "common/base/geometry_check.h"
#include "common/flow/flow.h"
#include "common/flow/regions.h"

struct standing_water {
  struct geo_lines turned; /* the regions, with gravity downwards */
  struct geo_cut cut;      /* the water above and below a point */
};

static enum status create(struct flow_water *w) {
  struct standing_water *own = w->own = calloc(1, sizeof *own);
  CHECK(own, ERR_MEMORY, "no memory for a cut through the water");
  return case_turn_lines(w->c, &w->c->water, &own->turned);
}

static void destroy(struct flow_water *w) {
  struct standing_water *own = w->own;
  if (!own) return;
  geo_cut_destroy(&own->cut);
  geo_lines_destroy(&own->turned);
  free(own);
}

static bool is_on_wall(const struct case_file *c, const double p[2]) {
  double nearest[2];
  size_t piece;
  return geo_lines_distance(&c->walls, p[0], p[1], nearest, &piece) <= case_near(c);
}

static enum status head(const struct flow_water *w, const struct flow_point *p, double *out) {
  const struct case_file *c = w->c;
  const double *down = c->down;
  struct standing_water *own = w->own;
  const double across = down[0] * p->y - down[1] * p->x, up = -down[0] * p->x - down[1] * p->y;
  TRY(geo_lines_cut(&own->turned, 0, across, case_near(c), &own->cut));
  const double *span = geo_cut_span(&own->cut, up), drop = span ? up - span[0] : 0;
  const double foot[2] = {p->x + drop * down[0], p->y + drop * down[1]};
  *out = c->gravity > 0 && span && is_on_wall(c, foot) ? fmax(span[1] - up, 0) : 0;
  return OK;
}

const struct flow flow_hydrostatic = {
    .example = "regions: [[[0, 0], [4, 0], [4, 0.5], [0, 0.5]], [[0, 0.5], [1, 0.5], [0, 1.5]]]",
    .create = create,
    .destroy = destroy,
    .velocity = flow_regions_velocity,
    .head = head,
};

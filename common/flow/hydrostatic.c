/* Regions whose pressure counts from the surface that stands above each point, regions that touch
 * being one water. Where the water below the point ends above the bed, it falls free and has none.
 */
#include <math.h>
#include <stdlib.h>

#include "common/flow/flow.h"
#include "common/flow/regions.h"

static enum status create(struct flow_water *w) {
  w->own = calloc(1, sizeof(struct geo_cut)); /* the water above and below a point */
  CHECK(w->own, ERR_MEMORY, "no memory for a cut through the water");
  return OK;
}

static void destroy(struct flow_water *w) {
  geo_cut_destroy(w->own);
  free(w->own);
}

static enum status head(const struct flow_water *w, const struct flow_point *p, double *out) {
  const struct case_file *c = w->c;
  const double near = case_near(c);
  TRY(geo_lines_cut(&c->water, 0, p->x, near, w->own));
  const double *span = geo_cut_span(w->own, p->y);
  bool stands = c->gravity > 0 && span && fabs(span[0] - c->tank.min[1]) <= near;
  *out = stands ? fmax(span[1] - p->y, 0) : 0;
  return OK;
}

const struct flow flow_hydrostatic = {
    .example = "regions: [[[0, 0], [4, 0], [4, 0.5], [0, 0.5]], [[0, 0.5], [1, 0.5], [0, 1.5]]]",
    .create = create,
    .destroy = destroy,
    .velocity = flow_regions_velocity,
    .head = head,
};

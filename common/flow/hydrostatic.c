/* Regions whose pressure counts from the surface that stands above each point, regions that touch
 * being one water. Where the water below the point ends above the bed, it falls free and has none.
 */
#include <math.h>
#include <stdlib.h>

#include "common/flow/flow.h"
#include "common/flow/regions.h"

static enum status prepare(const struct case_file *c, double spacing, void **prepared) {
  (void)c, (void)spacing;
  struct geo_cut *above = calloc(1, sizeof *above); /* the water above and below a point */
  CHECK(above, ERR_MEMORY, "no memory for a cut through the water");
  *prepared = above;
  return OK;
}

static void finish(void *prepared) {
  geo_cut_destroy(prepared);
  free(prepared);
}

static enum status head(const struct case_file *c, void *prepared, const struct flow_point *p,
                        double *out) {
  const double near = case_near(c);
  TRY(geo_lines_cut(&c->water, 0, p->x, near, prepared));
  const double *span = geo_cut_span(prepared, p->y);
  bool stands = span && fabs(span[0] - c->tank.min[1]) <= near;
  *out = stands ? fmax(span[1] - p->y, 0) : 0;
  return OK;
}

const struct flow flow_hydrostatic = {
    .example = "regions: [[[0, 0], [4, 0], [4, 0.5], [0, 0.5]], [[0, 0.5], [1, 0.5], [0, 1.5]]]",
    .velocity = flow_regions_velocity,
    .prepare = prepare,
    .head = head,
    .finish = finish,
};

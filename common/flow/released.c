/* Regions with the pressure of the instant after everything that held them has gone (release.h):
 * the Fourier series for one column at a wall, the sparse solve for everything else. */
#include "common/flow/release.h"

#include <stdlib.h>

#include "common/flow/flow.h"
#include "common/flow/regions.h"

struct pressure {
  bool alone; /* a column at just one wall */
  struct flow_column column;
  struct release *solved; /* any other water; owned */
};

/* The pressure is solved for between upright walls and a flat bed. */
static void check(const struct case_file *c, struct case_draft *d) {
  if (!c->rectangular)
    case_flow_problem(d, "pressure", "'released' in another tank",
                      "released for regions of water in a rectangular tank", "write hydrostatic");
  else if (c->periodic[0])
    case_flow_problem(d, "pressure", "'released' with periodic sides",
                      "released for regions of water between walls", "write hydrostatic");
  else if (case_is_turned(c))
    case_flow_problem(d, "pressure", "'released' under gravity that is not downwards",
                      "released for regions of water under gravity downwards", "write hydrostatic");
}

static enum status create(struct flow_water *w) {
  const struct case_file *c = w->c;
  const struct tank tank = tank_of(&c->walls, c->periodic);
  struct pressure *p = w->own = calloc(1, sizeof *p);
  CHECK(p, ERR_MEMORY, "no memory for the released pressure");
  p->alone = flow_find_column(c, &p->column) && p->column.left != p->column.right;
  if (p->alone || w->use.spacing == 0 || !(c->gravity > 0)) return OK;
  const struct release_drive weight = {.weight = 1};
  return release_create(&c->water, &tank, w->use.spacing, case_near(c), &weight, &p->solved);
}

static void destroy(struct flow_water *w) {
  struct pressure *p = w->own;
  if (p) release_destroy(p->solved);
  free(p);
}

static enum status head(const struct flow_water *w, const struct flow_point *p, double *out) {
  const struct pressure *pressure = w->own;
  const struct geo_box *b = &pressure->column.box;
  if (!(w->c->gravity > 0))
    *out = 0; /* nothing has held it */
  else if (pressure->alone)
    *out = release_head(pressure->column.left ? p->x - b->min[0] : b->max[0] - p->x,
                        p->y - b->min[1], b->max[0] - b->min[0], b->max[1] - b->min[1]);
  else
    *out = release_at(pressure->solved, p->x, p->y);
  return OK;
}

const struct flow flow_released = {
    .example = "pressure: released, regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]]",
    .check = check,
    .create = create,
    .destroy = destroy,
    .velocity = flow_regions_velocity,
    .head = head,
};

/* Regions with the pressure of the instant after everything that held them has gone (release.h). */
#include "common/flow/release.h"

#include <stdio.h>

#include "common/flow/flow.h"
#include "common/flow/regions.h"
#include "common/flow/release_rim.h"

/* A matrix of water without surface has no solution. What fails here fails again at the start. */
static void check_surface(const struct case_file *c, struct case_draft *d) {
  struct release_rims rims;
  double at[2];
  char found[160];
  if (release_rims_create(&c->water, &c->walls, 0, case_near(c), &rims) == OK &&
      release_rims_closed(&rims, at)) {
    snprintf(found, sizeof found,
             "'released' for water with walls all round it, from (%g, %g) m on", at[0], at[1]);
    case_flow_problem(d, "pressure", found, "released for water that has a surface",
                      "write hydrostatic, or leave air above it");
  }
  release_rims_destroy(&rims);
}

static void check(const struct case_file *c, struct case_draft *d) {
  if (c->periodic[0])
    case_flow_problem(d, "pressure", "'released' with periodic sides",
                      "released for regions of water between walls", "write hydrostatic");
  else if (c->gravity > 0)
    check_surface(c, d);
}

static enum status create(struct flow_water *w) {
  const struct case_file *c = w->c;
  const struct release_drive weight = {.weight = {c->down[0], c->down[1]}};
  struct release *r = NULL;
  if (w->use.spacing == 0 || !(c->gravity > 0))
    return OK; /* without it nothing has held the water */
  TRY(release_create(&c->water, &c->walls, w->use.spacing, case_near(c), &weight, &r));
  w->own = r;
  return OK;
}

static double seconds(const struct case_file *c, double spacing) {
  return c->gravity > 0 ? release_seconds(&c->water, spacing) : 0;
}

static void destroy(struct flow_water *w) {
  release_destroy(w->own);
}

static enum status head(const struct flow_water *w, const struct flow_point *p, double *out) {
  *out = w->own ? release_at(w->own, p->x, p->y) : 0;
  return OK;
}

const struct flow flow_released = {
    .example = "pressure: released, regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]]",
    .check = check,
    .create = create,
    .destroy = destroy,
    .seconds = seconds,
    .velocity = flow_regions_velocity,
    .head = head,
};

#include "sph/tips.h"

#include <math.h>

#include "common/tank/faces.h"

static const double thinnest = 2, same = 1e-6; /* dx; of it */

struct tip {
  double at[2], out[2]; /* where it is, m; unit vector from there away from the wall */
  double thickness;     /* m */
};

/* Of the wall that ends where that face does. */
static bool find_tip(const struct faces *faces, uint32_t k, struct tip *tip) {
  const struct face *f = &faces->face[k];
  const bool half = f->end[1] == FACE_END_HALF;
  if (!half && !(f->end[1] == FACE_END_EDGE && fabs(f->turn) > M_PI - same)) return false;
  *tip = (struct tip){.at = {f->b[0], f->b[1]},
                      .out = {half ? -f->t[1] : f->t[0], half ? f->t[0] : f->t[1]},
                      .thickness = half ? f->length + faces->face[f->next].length : 0};
  return true;
}

/* On either side of what is half a spacing beyond it, where regions may meet. */
static bool is_under_water(const struct tip *t, const struct geo_lines *water, double dx) {
  for (int side = -1; side <= 1; side += 2) {
    const double aside = side * dx / 8, beyond = dx / 2;
    if (geo_lines_contain(water, t->at[0] + beyond * t->out[0] - aside * t->out[1],
                          t->at[1] + beyond * t->out[1] + aside * t->out[0]))
      return true;
  }
  return false;
}

static void refuse(const struct case_file *c, const struct case_run *r, const struct tip *t,
                   struct problems *problems) {
  const double dx = c->H / r->resolution;
  if (t->thickness == 0)
    problems_add(problems, case_run_line(r, "solver"),
                 "runs.%s.solver: found 'sph' with a plate without thickness that ends under water "
                 "at (%.6g, %.6g) m; allowed: plates that are at least %g particle spacings (%g m) "
                 "thick there; draw it as a closed wall of that thickness, or end it above the "
                 "water",
                 r->name, t->at[0], t->at[1], thinnest, thinnest * dx);
  else
    problems_add(problems, case_run_line(r, "resolution"),
                 "runs.%s.resolution: found '%g', where a wall that ends under water at (%.6g, "
                 "%.6g) m is %.3g particle spacings thick; allowed: at least %g, with a resolution "
                 "of %g or more; raise it, or draw the wall thicker",
                 r->name, r->resolution, t->at[0], t->at[1], t->thickness / dx, thinnest,
                 ceil(thinnest * c->H / t->thickness * (1 - same)));
}

void sph_tips_check(const struct case_file *c, const struct case_run *r,
                    struct problems *problems) {
  const double dx = c->H / r->resolution;
  struct faces faces = {0};
  if (faces_set(&faces, &c->walls, thinnest * dx, NULL) != OK) problems->out_of_memory = true;
  for (uint32_t k = 0; k < faces.n; k++) {
    struct tip tip;
    if (!find_tip(&faces, k, &tip) || tip.thickness >= thinnest * dx * (1 - same)) continue;
    if (!is_under_water(&tip, &c->water, dx)) continue;
    refuse(c, r, &tip, problems);
    break;
  }
  faces_destroy(&faces);
}

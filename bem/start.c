#include "bem/start.h"

#include <math.h>

#include "bem/options.h"

static const double TOE = 0.15;  /* of the released column, see struct bem_surface */
static const double NEAR = 1e-9; /* of the tank: lengths that count as equal */
enum { FEWEST = 8 };             /* nodes that a surface needs */

static bool is_rectangle(const struct geo_lines *l, const struct geo_box *b) {
  if (l->pieces != 1 || l->points != 4) return false;
  double near = NEAR * (b->max[0] - b->min[0]);
  for (size_t k = 0; k < 4; k++)
    for (int d = 0; d < 2; d++)
      if (fabs(l->p[k][d] - b->min[d]) > near && fabs(l->p[k][d] - b->max[d]) > near) return false;
  return true;
}

/* `length` of the surface in H. */
static void check_most(const struct case_run *r, double length, struct problems *problems) {
  if (length * r->resolution < BEM_MOST_NODES) return;
  problems_add(problems, case_run_line(r, "resolution"),
               "runs.%s.resolution: found '%.6g', %.0f nodes on the surface; allowed: fewer than "
               "%d nodes; lower it to %g",
               r->name, r->resolution, length * r->resolution, BEM_MOST_NODES,
               floor(0.5 * BEM_MOST_NODES / length));
}

/* The first cut would leave a film that is to be cut at once, at every step. */
static void check_film(const struct case_file *c, const struct case_run *r,
                       struct problems *problems) {
  const struct bem_options *o = r->options;
  if (o->film / c->H < BEM_IMPACT) return;
  problems_add(problems, r->line,
               "runs.%s.film: found %.4g m; allowed: less than %.4g m (%g H), the film's thickness "
               "when it is cut at the wall after the impact; make it thinner",
               r->name, o->film, BEM_IMPACT * c->H, BEM_IMPACT);
}

void bem_start_check(const struct case_file *c, const struct case_run *r,
                     struct problems *problems) {
  if (!c->rectangular)
    problems_add(
        problems, case_run_line(r, "solver"),
        "runs.%s.solver: found 'bem' in a tank that is not rectangular; allowed: one wall, "
        "open at the top, down the left side, along a flat bed, up the right side; take another "
        "solver",
        r->name);
  double width = c->tank.max[0] - c->tank.min[0], near = NEAR * width;
  if (c->wave.kind != CASE_WAVE_NONE) {
    if (width / c->H * r->resolution < FEWEST)
      problems_add(problems, case_run_line(r, "resolution"),
                   "runs.%s.resolution: found '%.6g', %.3g nodes on the surface; allowed: at least "
                   "%d nodes; raise it to %g",
                   r->name, r->resolution, width / c->H * r->resolution, FEWEST,
                   ceil(FEWEST * c->H / width));
    check_most(r, width / c->H, problems);
    return;
  }
  check_film(c, r, problems);
  if (c->water.pieces != 1) {
    problems_add(problems, case_run_line(r, "solver"),
                 "runs.%s.solver: found 'bem' with %zu regions of water; allowed: one region; take "
                 "another solver",
                 r->name, c->water.pieces);
    return;
  }
  struct geo_box b = geo_lines_box(&c->water);
  if (!is_rectangle(&c->water, &b) || fabs(b.min[0] - c->tank.min[0]) > near ||
      fabs(b.min[1] - c->tank.min[1]) > near)
    problems_add(
        problems, case_run_line(r, "solver"),
        "runs.%s.solver: found 'bem' with other water; allowed: a rectangle that stands on "
        "the bed against the left wall; take another solver",
        r->name);
  if (c->velocity[0] != 0 || c->velocity[1] != 0)
    problems_add(problems, case_run_line(r, "solver"),
                 "runs.%s.solver: found 'bem' with moving water; allowed: water at rest at t = 0; "
                 "remove water.velocity",
                 r->name);
  double shortest = fmin(b.max[0] - b.min[0], b.max[1] - b.min[1]) / c->H;
  if (shortest * r->resolution < FEWEST)
    problems_add(problems, case_run_line(r, "resolution"),
                 "runs.%s.resolution: found '%.6g', %.3g nodes on the shorter side of the water; "
                 "allowed: at least %d nodes; raise it to %g",
                 r->name, r->resolution, shortest * r->resolution, FEWEST, ceil(FEWEST / shortest));
  check_most(r, (b.max[0] - b.min[0] + b.max[1] - b.min[1]) / c->H, problems);
}

enum status bem_start_surface(const struct case_file *c, const struct case_run *r,
                              struct bem_flow *f) {
  struct bem_surface *s = &f->surface;
  struct geo_box b = geo_lines_box(&c->water);
  double tank = (c->tank.max[0] - c->tank.min[0]) / c->H;
  double wide = tank, high = c->wave.depth / c->H;
  if (c->wave.kind == CASE_WAVE_NONE) {
    wide = (b.max[0] - b.min[0]) / c->H;
    high = (b.max[1] - b.min[1]) / c->H;
  }
  bool released = wide < tank * (1 - NEAR);
  f->mesh.resolution = r->resolution;
  f->level = wide * high / tank;
  s->tank = tank;
  s->right = released ? BEM_END_BED : BEM_END_WALL;
  s->length = released ? 2 * tank : tank;
  s->tip = released ? TOE : 0;
  size_t top = (size_t)ceil(wide * r->resolution),
         side = released ? (size_t)ceil(high * r->resolution) : 0;
  s->corner = released ? top : 0;
  TRY(bem_surface_reserve(s, top + side + 1));
  double *x = s->state, *y = x + s->n, *phi = y + s->n;
  bool wave = c->wave.kind != CASE_WAVE_NONE;
  double k0 = wave ? 2 * M_PI * c->H / c->wave.wavelength : 0;
  for (size_t k = 0; k < s->n; k++) {
    x[k] = k < top ? wide * (double)k / (double)top : wide;
    y[k] = k <= top ? high : high * (double)(s->n - 1 - k) / (double)side;
    phi[k] = 0;
    if (wave) y[k] += c->wave.amplitude / c->H * cos(k0 * x[k]);
  }
  if (released) /* the spacing at the toe is found by repetition */
    for (int i = 0; i < 4; i++) TRY(bem_mesh_regrid(&f->mesh, s));
  return OK;
}

#include "bem/start/outline.h"

#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bem/options.h"
#include "common/base/array.h"
#include "common/base/geometry_check.h"

static const double STRAIGHT = 1e-6; /* rad: a bend that is none */
static const double LEVEL = 0.02;    /* slope of water on a slope that is as good as level */
static const double SHARE = 0.4;     /* of the shorter side beside it: what an arc may take */
static const double GROWTH = 0.2;    /* of the spacing from one node to the next */
enum {
  PANELS = 20, /* of a quarter of a turn */
  REPEATS = 4  /* of placing the nodes, of which each depends on its neighbours */
};

/* ---- which part of the outline it is ---- */

static double wall_distance(const struct case_file *c, double x, double y) {
  double nearest[2];
  size_t piece;
  return geo_lines_distance(&c->walls, x, y, nearest, &piece);
}

static bool on_wall(const struct case_file *c, double x, double y) {
  return wall_distance(c, x, y) <= case_near(c);
}

static bool along_wall(const struct case_file *c, const double a[2], const double b[2]) {
  return on_wall(c, a[0], a[1]) && on_wall(c, b[0], b[1]) &&
         on_wall(c, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
}

/* The first of the sides in a row that are free, and how many; false: they are not in one row. */
static bool find_free(const struct case_file *c, const struct geo_lines *l, size_t *first,
                      size_t *count) {
  const size_t n = l->points;
  size_t rows = 0;
  bool before = !along_wall(c, l->p[n - 1], l->p[0]);
  *count = 0;
  for (size_t i = 0; i < n; i++) {
    const bool is = !along_wall(c, l->p[i], geo_segment_end(l, 0, i));
    if (is && !before) *first = i, rows++;
    *count += is;
    before = is;
  }
  return rows == 1;
}

static double turn(const double a[2], const double b[2], const double d[2]) {
  return carg((CMPLX(d[0] - b[0], d[1] - b[1])) * conj(CMPLX(b[0] - a[0], b[1] - a[1])));
}

/* The outline has the water on its left, so that its free sides begin at the right end. */
static enum status take_chain(const struct geo_lines *l, size_t first, size_t count,
                              struct geo_lines *chain) {
  const size_t n = l->points;
  geo_lines_clear(chain);
  TRY(geo_lines_begin(chain, false));
  for (size_t k = count + 1; k-- > 0;) {
    const double *p = l->p[(first + k) % n], *next = l->p[(first + k + n - 1) % n];
    const bool inner = k > 0 && k < count;
    if (inner && fabs(turn(chain->p[chain->points - 1], p, next)) < STRAIGHT) continue;
    TRY(geo_lines_add(chain, p[0], p[1]));
  }
  return OK;
}

/* On a wall that is not upright, which the bed of a rectangular tank is; on a slope only where the
 * water is not level. One straight surface in a tank of slopes leans where it stood at rest in
 * another: its edges are no fronts. */
static bool is_toe(const struct case_file *c, const struct geo_lines *chain, const double end[2],
                   const double inner[2]) {
  const double step = 1e3 * case_near(c);
  const bool level = fabs(end[1] - inner[1]) <= LEVEL * fabs(end[0] - inner[0]);
  if (!c->rectangular && (chain->points == 2 || level)) return false;
  return !on_wall(c, end[0], end[1] + step);
}

static const char *find_ends(const struct case_file *c, struct bem_outline *o) {
  const struct geo_lines *chain = &o->chain;
  const size_t n = chain->points;
  const double *left = chain->p[0], *right = chain->p[n - 1];
  if (along_wall(c, left, right)) return "water that is on one straight wall only";
  o->toe[0] = is_toe(c, chain, left, chain->p[1]);
  o->toe[1] = is_toe(c, chain, right, chain->p[n - 2]);
  return o->toe[0] && o->toe[1] ? "water that is to run out to both sides" : NULL;
}

static const char *take(const struct case_file *c, const struct geo_lines *l, struct bem_outline *o,
                        enum status *status) {
  size_t first = 0, count = 0;
  if (l->pieces != 1) return "water in several bodies, or round air";
  if (!find_free(c, l, &first, &count))
    return count ? "water whose surface is not one line from wall to wall"
                 : "water without a free surface";
  *status = take_chain(l, first, count, &o->chain);
  return *status == OK ? find_ends(c, o) : NULL;
}

enum status bem_outline_find(const struct case_file *c, struct bem_outline *o,
                             const char **problem) {
  struct geo_lines all = {0};
  *o = (struct bem_outline){0};
  *problem = NULL;
  enum status status = c->water.pieces > 1 ? geo_lines_outline(&c->water, case_near(c), &all)
                                           : geo_lines_copy(&all, &c->water);
  if (status == OK) *problem = take(c, &all, o, &status);
  geo_lines_destroy(&all);
  return status;
}

void bem_outline_destroy(struct bem_outline *o) {
  geo_lines_destroy(&o->chain);
}

double bem_outline_length(const struct bem_outline *o) {
  return o->chain.pieces ? geo_piece_length(&o->chain, 0) : 0;
}

/* ---- nodes ---- */

struct path { /* of nodes, H */
  size_t n, room;
  double complex *z; /* owned */
};

static enum status add(struct path *p, double complex z) {
  TRY(array_grow(&p->z, &p->room, p->n + 1, "nodes of an outline"));
  p->z[p->n++] = z;
  return OK;
}

/* Nodes on the way to b, b included, with spacings that grow from `from` and fall to `to`, to
 * `most` at most. */
static enum status add_side(struct path *p, double complex b, double from, double to, double most) {
  const double complex a = p->z[p->n - 1];
  const double length = cabs(b - a);
  const size_t before = p->n;
  double way = 0, last = 0;
  while (way < length) {
    const double step = fmin(most, fmin(from + GROWTH * way, to + GROWTH * (length - way)));
    way += step;
    last = way;
    TRY(add(p, way));
  }
  for (size_t i = before; i < p->n; i++) p->z[i] = a + creal(p->z[i]) / last * (b - a);
  return OK;
}

/* A kink as an arc: from `in` before it to as far behind it, around a centre. */
struct arc {
  double complex in, out, centre;
  double turn; /* rad, anticlockwise */
  size_t panels;
};

static double complex in_H(const struct case_file *c, const double p[2]) {
  return CMPLX((p[0] - c->tank.min[0]) / c->H, (p[1] - c->tank.min[1]) / c->H);
}

static struct arc arc_at(const struct case_file *c, const struct geo_lines *l, size_t i,
                         double radius) {
  const double complex a = in_H(c, l->p[i - 1]), b = in_H(c, l->p[i]), d = in_H(c, l->p[i + 1]);
  const double complex before = (b - a) / cabs(b - a), after = (d - b) / cabs(d - b);
  struct arc arc = {.turn = carg(after * conj(before))};
  const double steep = tan(0.5 * fabs(arc.turn));
  const double way = fmin(radius * steep, SHARE * fmin(cabs(b - a), cabs(d - b)));
  const double side = arc.turn > 0 ? 1 : -1;
  arc.in = b - way * before;
  arc.out = b + way * after;
  arc.centre = arc.in + CMPLX(0, side * way / steep) * before;
  arc.panels = (size_t)ceil(PANELS * fabs(arc.turn) / (M_PI / 2)) + 1;
  return arc;
}

static double arc_panel(const struct arc *arc) {
  return cabs(arc->in - arc->centre) * fabs(arc->turn) / (double)arc->panels;
}

static enum status add_arc(struct path *p, const struct arc *arc) {
  for (size_t k = 1; k < arc->panels; k++) {
    const double angle = arc->turn * (double)k / (double)arc->panels;
    TRY(add(p, arc->centre + (arc->in - arc->centre) * cexp(CMPLX(0, angle))));
  }
  return add(p, arc->out);
}

static enum status walk(const struct bem_outline *o, const struct case_file *c, double radius,
                        double most, struct path *p) {
  const struct geo_lines *l = &o->chain;
  double from = most;
  TRY(add(p, in_H(c, l->p[0])));
  for (size_t i = 1; i + 1 < l->points; i++) {
    const struct arc arc = arc_at(c, l, i, radius / c->H);
    TRY(add_side(p, arc.in, from, arc_panel(&arc), most));
    TRY(add_arc(p, &arc));
    from = arc_panel(&arc);
  }
  return add_side(p, in_H(c, l->p[l->points - 1]), from, most, most);
}

enum status bem_outline_start(const struct bem_outline *o, const struct case_file *c,
                              const struct case_run *r, struct bem_flow *f) {
  const struct bem_options *options = r->options;
  struct bem_surface *s = &f->surface;
  struct path p = {0};
  enum status status = walk(o, c, options->rounding, 1 / r->resolution, &p);
  if (status == OK) status = bem_surface_reserve(s, p.n);
  for (size_t k = 0; status == OK && k < p.n; k++) {
    s->state[k] = creal(p.z[k]);
    s->state[s->n + k] = cimag(p.z[k]);
    s->state[2 * s->n + k] = 0;
  }
  free(p.z);
  s->tip = o->toe[1] ? BEM_TOE : 0;
  for (int i = 0; i < REPEATS && status == OK; i++) status = bem_mesh_regrid(&f->mesh, s);
  return status;
}

static bool is_corner(const struct case_file *c, const double at[2]) {
  const double near = case_near(c);
  const bool side = fabs(at[0] - c->tank.min[0]) <= near || fabs(at[0] - c->tank.max[0]) <= near;
  return c->rectangular && side && fabs(at[1] - c->tank.min[1]) <= near;
}

/* Where the surface bends it moves at once, over a wall so near that neither the arc of the bend
 * nor a panel knows it from one that it touches. */
static void check_bends(const struct bem_outline *o, const struct case_file *c,
                        const struct case_run *r, struct problems *problems) {
  const struct bem_options *options = r->options;
  const double least = fmax(options->rounding, c->H / r->resolution);
  for (size_t i = 1; i + 1 < o->chain.points; i++) {
    const double *at = o->chain.p[i], gap = wall_distance(c, at[0], at[1]);
    if (gap >= least) continue;
    problems_add(
        problems, case_run_line(r, "solver"),
        "runs.%s.solver: found 'bem' with a surface that bends at (%g, %g) m, %.4g m from a "
        "wall; allowed: at least %.4g m, a panel and the radius of rounding; move the bend, "
        "or raise the resolution and lower rounding",
        r->name, at[0], at[1], gap, least);
    return;
  }
}

/* Distance of the i-th point of the walls from the surface between its edges, which may begin as
 * near to it as they like. */
static double crest_gap(const struct geo_lines *surface, const struct case_file *c, size_t i) {
  const double *at = c->walls.p[i];
  double nearest[2];
  size_t piece;
  const double gap = geo_lines_distance(surface, at[0], at[1], nearest, &piece);
  for (int end = 0; end < 2; end++) {
    const double *edge = surface->p[end ? surface->points - 1 : 0];
    if (hypot(nearest[0] - edge[0], nearest[1] - edge[1]) <= fmax(gap, case_near(c)))
      return HUGE_VAL;
  }
  return gap;
}

/* Advises the resolution whose panels are as short as that, unless it has too many nodes. */
static void refuse_crest(const struct case_file *c, const struct case_run *r, const double at[2],
                         double gap, double length, struct problems *problems) {
  const double resolution = ceil(c->H / gap);
  char raise[64] = "";
  if (length / c->H * resolution < BEM_MOST_NODES)
    snprintf(raise, sizeof raise, "raise the resolution to %.0f, or ", resolution);
  problems_add(problems, case_run_line(r, "solver"),
               "runs.%s.solver: found 'bem' with a surface that passes the bend of the walls at "
               "(%g, %g) m at %.4g m; allowed: at least %.4g m, a panel; %slet the water cover the "
               "bend or leave it dry",
               r->name, at[0], at[1], gap, c->H / r->resolution, raise);
}

void bem_outline_check_crests(const struct geo_lines *surface, double length,
                              const struct case_file *c, const struct case_run *r,
                              struct problems *problems) {
  for (size_t i = 1; i + 1 < c->walls.points; i++) {
    if (turn(c->walls.p[i - 1], c->walls.p[i], c->walls.p[i + 1]) > -STRAIGHT) continue;
    const double gap = crest_gap(surface, c, i);
    if (gap >= c->H / r->resolution) continue;
    refuse_crest(c, r, c->walls.p[i], gap, length, problems);
    return;
  }
}

void bem_outline_check(const struct bem_outline *o, const struct case_file *c,
                       const struct case_run *r, struct problems *problems) {
  const size_t n = o->chain.points;
  if (is_corner(c, o->chain.p[0]) || is_corner(c, o->chain.p[n - 1]))
    bem_outline_refuse_edge(r, problems);
  check_bends(o, c, r, problems);
}

void bem_outline_refuse_edge(const struct case_run *r, struct problems *problems) {
  problems_add(problems, case_run_line(r, "solver"),
               "runs.%s.solver: found 'bem' with the water's edge on a bend of the walls; allowed: "
               "an edge beside it, which has one wall to slide along; take another solver",
               r->name);
}

void bem_outline_refuse(const struct case_run *r, struct problems *problems, const char *problem) {
  problems_add(problems, case_run_line(r, "solver"),
               "runs.%s.solver: found 'bem' with %s; allowed: one body of water under one surface "
               "from wall to wall, or a wave; take another solver",
               r->name, problem);
}

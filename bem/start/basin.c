#include "bem/start/basin.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bem/motion/moving.h"
#include "bem/start/drawn.h"
#include "bem/start/outline.h"
#include "common/base/array.h"
#include "common/flow/edges.h"

enum {
  REPEATS = 4, /* of placing the nodes, of which each depends on its neighbours */
  FINER = 4    /* parts of a panel: distances of a wave are then good to a hundredth of one */
};

static double in_H_x(const struct case_file *c, double x) {
  return (x - c->tank.min[0]) / c->H;
}

static double complex in_H(const struct case_file *c, const double p[2]) {
  return CMPLX(in_H_x(c, p[0]), (p[1] - c->tank.min[1]) / c->H);
}

/* The points of the walls (H), and those that hinges are at: with(n, point, keep, out).
 * ERR_MEMORY. */
static enum status with_points(const struct case_file *c,
                               enum status (*with)(size_t n, const double (*point)[2],
                                                   const bool *keep, void *out),
                               void *out) {
  const size_t n = c->walls.points;
  double(*point)[2] = NULL;
  bool keep[BEM_MOST_BENDS + 2];
  CHECK(n <= BEM_MOST_BENDS + 2, ERR_SOLVER, "a wall has too many points");
  TRY(array_create(&point, n, "points of a wall"));
  bem_moving_keep(c, keep);
  for (size_t i = 0; i < n; i++) {
    const double complex z = in_H(c, c->walls.p[i]);
    point[i][0] = creal(z);
    point[i][1] = cimag(z);
  }
  const enum status status = with(n, point, keep, out);
  free(point);
  return status;
}

static enum status create_shore(size_t n, const double (*point)[2], const bool *keep, void *out) {
  return bem_shore_create(n, point, keep, out);
}

static enum status create_map(size_t n, const double (*point)[2], const bool *keep, void *out) {
  return bem_conformal_create(n, point, keep, out);
}

bool bem_basin_is_mapped(const struct case_file *c) {
  bool mapped = !c->rectangular;
  for (size_t i = 0; i < c->n_motions; i++)
    mapped |= c->motions[i].kind == TANK_MOTION_roll || c->motions[i].kind == TANK_MOTION_flap;
  return mapped && !c->periodic[0];
}

enum status bem_basin_shore(const struct case_file *c, struct bem_shore **s) {
  *s = NULL;
  return with_points(c, create_shore, s);
}

/* ---- where the surface is ---- */

/* The surface: of regions, its outline; a straight one is placed as that of a wave. */
struct lie {
  struct bem_outline outline;
  double at[2][2]; /* of its left and its right edge, m */
  bool straight;
};

static enum status find_lie(const struct case_file *c, const struct flow_water *w, struct lie *l,
                            const char **problem) {
  struct flow_edges e;
  *l = (struct lie){.straight = true};
  if (flow_is_wave(c->flow)) {
    *problem = flow_find_edges(w, &e);
    if (!*problem) memcpy(l->at, e.at, sizeof e.at);
    return OK;
  }
  TRY(bem_outline_find(c, &l->outline, problem));
  const struct geo_lines *chain = &l->outline.chain;
  if (*problem) return OK;
  memcpy(l->at[0], chain->p[0], sizeof l->at[0]);
  memcpy(l->at[1], chain->p[chain->points - 1], sizeof l->at[1]);
  l->straight = chain->points == 2 && !l->outline.toe[0] && !l->outline.toe[1];
  return OK;
}

static void set_node(const struct flow_water *w, const double p[2], struct bem_surface *s,
                     size_t k) {
  const struct case_file *c = w->c;
  const double complex z = in_H(c, p);
  s->state[k] = creal(z);
  s->state[s->n + k] = cimag(z);
  s->state[2 * s->n + k] = flow_is_wave(c->flow)
                               ? flow_potential(w, p[0], p[1], 0) / (c->H * sqrt(c->gravity * c->H))
                               : 0;
}

static void set_nodes(const struct flow_water *w, double at[2][2], struct bem_surface *s,
                      const double *part) {
  for (size_t k = 0; k < s->n; k++) {
    const bool inner = k > 0 && k + 1 < s->n;
    double p[2] = {at[0][0] + part[k] * (at[1][0] - at[0][0]),
                   at[0][1] + part[k] * (at[1][1] - at[0][1])};
    if (inner && flow_is_wave(w->c->flow)) p[1] = flow_elevation(w, p[0], 0);
    set_node(w, k == 0 ? at[0] : inner ? p : at[1], s, k);
  }
}

/* Places nodes on the surface itself where the mesh wants them. */
static enum status place(const struct flow_water *w, double at[2][2], struct bem_flow *f) {
  struct bem_surface *s = &f->surface;
  const double length = hypot(at[1][0] - at[0][0], at[1][1] - at[0][1]) / w->c->H;
  const double left = in_H_x(w->c, at[0][0]), right = in_H_x(w->c, at[1][0]);
  double *part = NULL;
  size_t n = (size_t)ceil(length * f->mesh.resolution) + 1;
  enum status status = OK;
  for (int i = 0; i <= REPEATS; i++) {
    ATTEMPT(array_resize(&part, n, "nodes of a surface"));
    for (size_t k = 0; k < n; k++)
      part[k] = i == 0 ? (double)k / (double)(n - 1) : (s->state[k] - left) / (right - left);
    ATTEMPT(bem_surface_reserve(s, n));
    set_nodes(w, at, s, part);
    if (i == REPEATS) break;
    ATTEMPT(bem_mesh_regrid(&f->mesh, s));
    n = s->n;
  }
done:
  free(part);
  return status;
}

static enum status place_lie(const struct flow_water *w, const struct case_run *r, struct lie *l,
                             struct bem_flow *f) {
  const struct flow_line *line = flow_line_of(w->c);
  if (line) return bem_drawn_start(w->c, line, f);
  return l->straight ? place(w, l->at, f) : bem_outline_start(&l->outline, w->c, r, f);
}

static enum status start(const struct flow_water *w, const struct case_run *r,
                         struct bem_shore *shore, struct bem_flow *f) {
  struct lie l;
  const char *problem = NULL;
  enum status status = find_lie(w->c, w, &l, &problem);
  ATTEMPT(status);
  if (problem) status = status_raise(ERR_SOLVER, "%s", problem);
  ATTEMPT(status);
  const double complex edge[2] = {in_H(w->c, l.at[0]), in_H(w->c, l.at[1])};
  ATTEMPT(bem_shore_place(shore, edge, &f->surface));
  ATTEMPT(place_lie(w, r, &l, f));
done:
  bem_outline_destroy(&l.outline);
  return status;
}

enum status bem_basin_start(const struct case_file *c, const struct case_run *r,
                            struct bem_shore *shore, struct bem_flow *f) {
  struct flow_water w;
  enum status status = flow_open(c, (struct flow_use){0}, &w);
  f->surface.right = BEM_END_WALL;
  if (status == OK) status = start(&w, r, shore, f);
  flow_close(&w);
  return status;
}

/* ---- what is refused ---- */

static void refuse(const struct case_run *r, struct problems *problems, const char *found,
                   const char *allowed) {
  problems_add(problems, case_run_line(r, "solver"),
               "runs.%s.solver: found 'bem' with %s; allowed: %s; take another solver", r->name,
               found, allowed);
}

/* Whether the sides, which the map takes to go on for ever, meet something within the tank's size.
 */
static enum status goes_on(size_t n, const double (*point)[2], const bool *keep, void *simple) {
  (void)keep;
  double complex *z = NULL;
  TRY(array_create(&z, n, "points of a wall"));
  for (size_t i = 0; i < n; i++) z[i] = CMPLX(point[i][0], point[i][1]);
  const enum status status = bem_shore_goes_on(n, z, simple);
  free(z);
  return status;
}

static bool check_walls(const struct case_file *c, const struct case_run *r,
                        struct problems *problems) {
  bool simple = false;
  if (c->walls.pieces != 1 || c->walls.closed[0]) {
    refuse(r, problems, "several walls, or a closed one",
           "one wall, open at the top, down the left side, along the bed, up the right side");
    return false;
  }
  if (c->walls.points > BEM_MOST_BENDS) {
    refuse(r, problems, "a wall of too many points", "64 of them");
    return false;
  }
  if (with_points(c, goes_on, &simple) != OK) {
    problems->out_of_memory = true;
    return false;
  }
  if (!simple)
    refuse(r, problems, "sides that meet if they go on",
           "sides that may go on for ever, as the water does not know where they end");
  return simple;
}

/* At a bend towards the water its velocity has no bound. */
static void check_probes(const struct case_file *c, const struct case_run *r,
                         const struct bem_conformal *m, struct problems *problems) {
  for (size_t i = 0; i < c->n_probes; i++) {
    const double at[2] = {c->probes[i].x, c->probes[i].y};
    for (size_t k = 0; k < m->n; k++)
      if (m->power[k] > 0 && cabs(in_H(c, at) - m->point[k + 1]) * c->H <= case_near(c))
        problems_add(problems, case_run_line(r, "solver"),
                     "runs.%s.solver: found 'bem' with the probe %s on an edge of the walls, where "
                     "water that flows round it has no lowest pressure; allowed: a point beside "
                     "it; move the probe",
                     r->name, c->probes[i].name);
  }
}

static void check_edges(const struct case_file *c, const struct case_run *r,
                        const struct bem_conformal *m, const struct lie *l,
                        struct problems *problems, double *length) {
  for (int end = 0; end < 2; end++)
    for (size_t k = 0; k < m->n; k++)
      if (cabs(in_H(c, l->at[end]) - m->point[k + 1]) * c->H <= case_near(c)) {
        bem_outline_refuse_edge(r, problems);
        return;
      }
  *length = l->straight ? hypot(l->at[1][0] - l->at[0][0], l->at[1][1] - l->at[0][1])
                        : bem_outline_length(&l->outline);
}

static enum status draw_line(const struct flow_line *line, double step, struct geo_lines *l) {
  size_t n;
  double *way;
  enum status status = flow_line_sample(line, 0, step, &n, &way);
  for (size_t k = 0; status == OK && k < n; k++) {
    const struct flow_line_point at = flow_line_at(line, way[k]);
    status = geo_lines_add(l, at.p[0], at.p[1]);
  }
  free(way);
  return status;
}

/* The surface of a wave in SI units, finer than its panels. */
static enum status draw_wave(const struct flow_water *w, const struct case_run *r, double at[2][2],
                             struct geo_lines *l) {
  const double width = at[1][0] - at[0][0],
               step = fmax(w->c->H / r->resolution, width / BEM_MOST_NODES) / FINER;
  const size_t n = geo_intervals(width, step);
  TRY(geo_lines_begin(l, false));
  if (flow_line_of(w->c)) return draw_line(flow_line_of(w->c), step, l);
  TRY(geo_lines_add(l, at[0][0], at[0][1]));
  for (size_t k = 1; k < n; k++) {
    const double x = at[0][0] + width * (double)k / (double)n;
    TRY(geo_lines_add(l, x, flow_elevation(w, x, 0)));
  }
  return geo_lines_add(l, at[1][0], at[1][1]);
}

/* Where the surface is, and, of a wave, as it is drawn. */
static enum status find_water(const struct case_file *c, const struct case_run *r, struct lie *l,
                              struct geo_lines *wave, const char **problem) {
  struct flow_water w;
  enum status status = flow_open(c, (struct flow_use){0}, &w);
  if (status == OK) status = find_lie(c, &w, l, problem);
  if (status == OK && !*problem && flow_is_wave(c->flow)) status = draw_wave(&w, r, l->at, wave);
  flow_close(&w);
  return status;
}

static void check_water(const struct case_file *c, const struct case_run *r,
                        const struct bem_conformal *m, struct problems *problems, double *length) {
  struct lie l = {0};
  struct geo_lines wave = {0};
  const struct geo_lines *chain = &l.outline.chain;
  const char *problem = NULL;
  if (find_water(c, r, &l, &wave, &problem) != OK)
    problems->out_of_memory = true;
  else if (problem)
    bem_outline_refuse(r, problems, problem);
  else {
    if (chain->pieces) bem_outline_check(&l.outline, c, r, problems);
    check_edges(c, r, m, &l, problems, length);
    if (*length > 0)
      bem_outline_check_crests(chain->pieces ? chain : &wave, *length, c, r, problems);
  }
  geo_lines_destroy(&wave);
  bem_outline_destroy(&l.outline);
}

void bem_basin_check(const struct case_file *c, const struct case_run *r, struct problems *problems,
                     double *length) {
  struct bem_conformal *m = NULL;
  *length = 0;
  if (!check_walls(c, r, problems)) return;
  const enum status status = with_points(c, create_map, &m);
  if (status == ERR_MEMORY) problems->out_of_memory = true;
  if (status == ERR_SOLVER)
    refuse(r, problems, status_message(), "walls of which the conformal map is found");
  if (status == OK) {
    check_probes(c, r, m, problems);
    check_water(c, r, m, problems, length);
  }
  bem_conformal_destroy(m);
}

#include "bem/water/shore.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bem/shape/curve.h"
#include "common/base/array.h"
#include "common/base/geometry_check.h"

static const double STRAIGHT = 1e-9; /* rad: walls that bend less do not */

/* In lengths of the panel at the edge. An edge that runs up to a bend towards the water goes on
 * freely, as it cannot feel yet what is there, until the next side cuts the surface CUT from the
 * bend; at one away from the water it lands LANDING beyond it at once, and so it does below a bend
 * that it has come down to within NEAR, where water that is about to leave a corner dwells. */
static const double CUT = 1, LANDING = 0.5, NEAR = 0.25;
enum { LOCAL = 12 }; /* nodes that tell how the surface meets the next side */

void bem_shore_destroy(struct bem_shore *s) {
  if (!s) return;
  for (size_t i = 0; s->map && i < s->n * s->n; i++) bem_conformal_destroy(s->map[i]);
  free(s->map);
  free(s->point);
  free(s->keep);
  free(s);
}

static enum status set_points(struct bem_shore *s, size_t n, const double (*p)[2],
                              const bool *keep) {
  TRY(array_create(&s->keep, n, "points of a wall"));
  TRY(array_create(&s->point, n, "points of a wall"));
  for (size_t i = 0; i < n; i++) {
    const double complex at = CMPLX(p[i][0], p[i][1]);
    if (i > 0 && i + 1 < n) {
      const double complex next = CMPLX(p[i + 1][0], p[i + 1][1]);
      if (fabs(carg((next - at) * conj(at - s->point[s->n - 1]))) < STRAIGHT && !keep[i]) continue;
    }
    s->keep[s->n] = keep[i];
    s->point[s->n++] = at;
  }
  return array_create(&s->map, s->n * s->n, "maps of a tank");
}

enum status bem_shore_create(size_t n, const double (*point)[2], const bool *keep,
                             struct bem_shore **out) {
  struct bem_shore *s = *out = calloc(1, sizeof *s);
  CHECK(s, ERR_MEMORY, "no memory for the walls of a tank");
  return set_points(s, n, point, keep);
}

/* ---- maps ---- */

enum status bem_shore_goes_on(size_t n, const double complex *point, bool *simple) {
  struct geo_lines l = {0};
  double far = 0, at[2];
  enum status status = OK;
  *simple = false;
  for (size_t i = 0; i < n; i++) far = fmax(far, 2 * cabs(point[i] - point[0]));
  ATTEMPT(geo_lines_begin(&l, false));
  for (size_t i = 0; i < n; i++) {
    double complex p = point[i];
    if (i == 0) p += far * (point[0] - point[1]) / cabs(point[0] - point[1]);
    if (i + 1 == n) p += far * (p - point[n - 2]) / cabs(p - point[n - 2]);
    ATTEMPT(geo_lines_add(&l, creal(p), cimag(p)));
  }
  ATTEMPT(geo_piece_simple(&l, 0, false, simple, at));
done:
  geo_lines_destroy(&l);
  return status;
}

/* *m: the map of segments `from` to `to`, NULL if they would meet themselves. */
static enum status find_map(struct bem_shore *s, size_t from, size_t to,
                            const struct bem_conformal **m) {
  struct bem_conformal **map = &s->map[from * s->n + to];
  bool simple = true;
  *m = *map;
  if (*map) return OK;
  TRY(bem_shore_goes_on(to - from + 2, s->point + from, &simple));
  if (!simple) return OK;
  double p[BEM_MOST_BENDS + 2][2];
  for (size_t i = from; i <= to + 1; i++) {
    p[i - from][0] = creal(s->point[i]);
    p[i - from][1] = cimag(s->point[i]);
  }
  TRY(bem_conformal_create(to - from + 2, p, s->keep + from, map));
  *m = *map;
  return OK;
}

/* Gives the surface the map of the walls between its edges, or else of all. */
static enum status set_map(struct bem_shore *s, struct bem_surface *surface) {
  const struct bem_conformal *m;
  CHECK(s->side[0] < s->side[1], ERR_SOLVER, "there is no water left between the walls");
  TRY(find_map(s, s->side[0], s->side[1], &m));
  size_t before = s->side[0];
  if (!m) {
    TRY(find_map(s, 0, s->n - 2, &m));
    before = 0;
  }
  CHECK(m, ERR_SOLVER, "the sides of the tank meet if they go on");
  surface->walls = m;
  for (int end = 0; end < 2; end++) surface->side[end] = s->side[end] - before;
  return OK;
}

static size_t find_segment(const struct bem_shore *s, double complex z) {
  double least = INFINITY;
  size_t segment = 0;
  for (size_t i = 0; i + 1 < s->n; i++) {
    const double complex a = s->point[i], way = s->point[i + 1] - a;
    const double u = creal((z - a) * conj(way)) / creal(way * conj(way));
    const double distance = cabs(z - a - fmin(fmax(u, 0), 1) * way);
    if (distance < least) least = distance, segment = i;
  }
  return segment;
}

enum status bem_shore_place(struct bem_shore *s, const double complex edge[2],
                            struct bem_surface *surface) {
  for (int end = 0; end < 2; end++) s->side[end] = find_segment(s, edge[end]);
  return set_map(s, surface);
}

/* ---- edges ---- */

/* Along a segment, with the water on the left. */
static double complex along(const struct bem_shore *s, size_t segment) {
  const double complex way = s->point[segment + 1] - s->point[segment];
  return way / cabs(way);
}

bool bem_shore_at_top(const struct bem_shore *s, bool right) {
  return s->side[right] == (right ? s->n - 2 : 0);
}

double bem_shore_way(const struct bem_shore *s, bool right, bool up, double complex z) {
  const size_t side = s->side[right];
  const double complex end = s->point[side + (right == up)];
  return creal((end - z) * conj((right == up ? 1 : -1) * along(s, side)));
}

/* The segment that an edge passes on to, the bend before it, and the direction from there. */
struct next {
  size_t side;
  double complex bend, along;
  bool towards; /* the water: the walls turn into its way up */
};

static struct next next_of(const struct bem_shore *s, bool right, int way) {
  const size_t side = s->side[right], i = side + (right == (way > 0));
  struct next n = {.side = right == (way > 0) ? side + 1 : side - 1, .bend = s->point[i]};
  n.along = (right == (way > 0) ? 1 : -1) * along(s, n.side);
  n.towards = cimag(conj(s->point[i] - s->point[i - 1]) * (s->point[i + 1] - s->point[i])) > 0;
  return n;
}

static double complex node(const struct bem_surface *s, size_t k) {
  return CMPLX(s->state[k], s->state[s->n + k]);
}

/* Distance of a point from the line of a segment, on the side of the water. */
static double inside(const struct bem_shore *s, size_t segment, double complex z) {
  return cimag(conj(along(s, segment)) * (z - s->point[segment]));
}

/* How many nodes from an edge on are beyond a segment. */
static size_t count_beyond(const struct bem_shore *s, const struct bem_surface *w, bool right,
                           size_t segment) {
  size_t count = 0;
  while (count + LOCAL < w->n &&
         !(inside(s, segment, node(w, right ? w->n - 1 - count : count)) > 0))
    count++;
  return count;
}

/* Where the line through the last node beyond a segment and the next one meets it: how far from the
 * bend. */
static double cut_at(const struct bem_shore *s, const struct bem_surface *w, bool right,
                     const struct next *to) {
  const size_t beyond = count_beyond(s, w, right, to->side);
  if (!beyond) return -1;
  const double complex out = node(w, right ? w->n - beyond : beyond - 1),
                       in = node(w, right ? w->n - 1 - beyond : beyond);
  const double a = inside(s, to->side, out), b = inside(s, to->side, in);
  return creal((out + a / (a - b) * (in - out) - to->bend) * conj(to->along));
}

static double panel(const struct bem_surface *w, bool right) {
  return right ? cabs(node(w, w->n - 1) - node(w, w->n - 2)) : cabs(node(w, 1) - node(w, 0));
}

int bem_shore_arrives(const struct bem_shore *s, const struct bem_surface *w, bool right) {
  const double complex edge = node(w, right ? w->n - 1 : 0);
  const double size = panel(w, right);
  if (!bem_shore_at_top(s, right) && bem_shore_way(s, right, true, edge) <= 0) {
    const struct next to = next_of(s, right, 1);
    return !to.towards || cut_at(s, w, right, &to) >= CUT * size;
  }
  if (s->side[0] + 1 < s->side[1] && bem_shore_way(s, right, false, edge) < NEAR * size) return -1;
  return 0;
}

/* ---- passing ---- */

/* What is to take the place of the nodes at an edge. */
struct landing {
  size_t drop; /* nodes */
  double point[BEM_FIELDS];
};

/* The edge itself goes on from the bend, with the potential that is continued from it. */
static void land_beyond(const struct bem_flow *f, bool right, const struct next *to,
                        struct landing *l) {
  const struct bem_surface *w = &f->surface;
  const size_t edge = right ? w->n - 1 : 0;
  const double past = creal((node(w, edge) - to->bend) * conj(to->along));
  const double complex at = to->bend + fmax(past, LANDING * panel(w, right)) * to->along;
  l->drop = 1;
  l->point[0] = creal(at);
  l->point[1] = cimag(at);
  l->point[2] = w->state[2 * w->n + edge] + creal(f->w[edge] * (at - node(w, edge)));
}

/* The edge is where the surface meets the segment. */
static enum status land_where_cut(const struct bem_shore *s, const struct bem_surface *w,
                                  bool right, const struct next *to, struct bem_curve *c,
                                  struct landing *l) {
  const size_t beyond = count_beyond(s, w, right, to->side), most = beyond + LOCAL - 2;
  TRY(bem_curve_fit(c, w, right ? w->n - 1 - most : 0, right ? w->n - 1 : most, 0));
  double out = c->arc[right ? c->n - beyond : beyond - 1],
         in = c->arc[right ? c->n - 1 - beyond : beyond];
  const double splinter = 0.5 * fabs(in - out), inner = in;
  for (int i = 0; i < 60; i++) { /* until there is no number between them */
    const double middle = 0.5 * (in + out);
    const double complex z = CMPLX(bem_curve_value(c, 0, middle), bem_curve_value(c, 1, middle));
    *(inside(s, to->side, z) > 0 ? &in : &out) = middle;
  }
  for (size_t field = 0; field < BEM_FIELDS; field++)
    l->point[field] = bem_curve_value(c, field, in);
  l->drop = beyond + (fabs(inner - in) < splinter);
  return OK;
}

/* Exactly on the segment, to which rounding has brought it. */
static void put_on(const struct next *to, struct landing *l) {
  const double complex z = CMPLX(l->point[0], l->point[1]);
  const double complex on = to->bend + creal((z - to->bend) * conj(to->along)) * to->along;
  l->point[0] = creal(on);
  l->point[1] = cimag(on);
}

static enum status replace_edge(struct bem_surface *w, bool right, const struct landing *l) {
  struct bem_surface fresh = {0};
  const size_t keep = w->n - l->drop;
  TRY(bem_surface_follow(&fresh, w, keep + 1));
  for (size_t field = 0; field < BEM_FIELDS; field++) {
    double *to = fresh.state + field * fresh.n;
    memcpy(right ? to : to + 1, w->state + field * w->n + (right ? 0 : l->drop), keep * sizeof *to);
    to[right ? keep : 0] = l->point[field];
  }
  if (!right && fresh.corner) fresh.corner = fresh.corner + 1 - l->drop;
  bem_surface_replace(w, &fresh);
  return OK;
}

enum status bem_shore_pass(struct bem_shore *s, struct bem_flow *f, bool right, int way) {
  struct bem_surface *w = &f->surface;
  CHECK(!f->moving.map || !bem_rigid_moves(f->moving.body[w->side[right]]), ERR_SOLVER,
        "the edge of the water leaves the side that moves");
  const struct next to = next_of(s, right, way);
  struct bem_curve curve = {0};
  struct landing landing;
  enum status status = OK;
  if (way > 0 && to.towards)
    status = land_where_cut(s, w, right, &to, &curve, &landing);
  else
    land_beyond(f, right, &to, &landing);
  bem_curve_destroy(&curve);
  TRY(status);
  put_on(&to, &landing);
  TRY(replace_edge(w, right, &landing));
  s->side[right] = to.side;
  TRY(set_map(s, w));
  return bem_mesh_regrid(&f->mesh, w);
}

#include "bem/motion/moving.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/tank/motion.h"
#include "common/tank/tank.h"

static const double STEP = 1e-3; /* of the shortest side: by which points move in differences */

void bem_moving_destroy(struct bem_moving *m) {
  bem_conformal_destroy(m->map);
  *m = (struct bem_moving){0};
}

static double complex in_H(const struct case_file *c, const double p[2]) {
  return CMPLX(p[0] - c->tank.min[0], p[1] - c->tank.min[1]) / c->H;
}

static size_t find_vertex(const struct case_file *c, double complex z) {
  size_t nearest = 0;
  for (size_t i = 1; i < c->walls.points; i++)
    if (cabs(in_H(c, c->walls.p[i]) - z) < cabs(in_H(c, c->walls.p[nearest]) - z)) nearest = i;
  return nearest;
}

void bem_moving_keep(const struct case_file *c, bool *keep) {
  for (size_t i = 0; i < c->walls.points; i++) keep[i] = false;
  for (int side = TANK_LEFT; side <= TANK_RIGHT; side++) {
    const double hinge = tank_hinge(c->motions, c->n_motions, side);
    struct tank_side s;
    if (!isfinite(hinge) || !tank_find_side(&c->walls, side, &s)) continue;
    const size_t low = s.top < s.foot ? s.top : s.foot, high = s.top < s.foot ? s.foot : s.top;
    for (size_t i = low + 1; i < high; i++)
      keep[i] = fabs(c->walls.p[i][1] - hinge) <= case_near(c);
  }
}

/* The map becomes this one; charts of whichever there was are none of it. */
static void set_map(struct bem_moving *m, struct bem_conformal *map) {
  bem_conformal_destroy(m->map);
  m->map = map;
  map->changes = ++m->changes;
}

enum status bem_moving_start(struct bem_moving *m, const struct case_file *c,
                             const struct bem_conformal *at_rest) {
  struct bem_conformal *map = NULL;
  m->c = c;
  m->time = NAN;
  for (size_t i = 0; i < at_rest->n + 2; i++) m->vertex[i] = find_vertex(c, at_rest->point[i]);
  const enum status status = bem_conformal_copy(at_rest, &map);
  if (status == OK)
    set_map(m, map);
  else
    bem_conformal_destroy(map);
  return status;
}

enum status bem_moving_follow(struct bem_moving *m, const struct bem_moving *like) {
  TRY(bem_moving_start(m, like->c, like->map));
  memcpy(m->vertex, like->vertex, sizeof m->vertex);
  return OK;
}

/* The rigid motion of two points. */
static struct bem_rigid rigid(const double complex z[2], const double complex v[2]) {
  const double turn = creal((v[1] - v[0]) / (I * (z[1] - z[0])));
  return (struct bem_rigid){v[0] - I * turn * z[0], turn};
}

/* Whether a side of the map is of one that moves as it is: the bed next to it is not. */
static bool is_of_side(const struct bem_moving *m, size_t side) {
  const size_t a = m->vertex[side], b = m->vertex[side + 1];
  for (int i = TANK_LEFT; i <= TANK_RIGHT; i++) {
    struct tank_side s;
    if (!tank_find_side(&m->c->walls, i, &s)) continue;
    const size_t low = s.top < s.foot ? s.top : s.foot, high = s.top < s.foot ? s.foot : s.top;
    if (a >= low && b <= high) return true;
  }
  return false;
}

static void set_bodies(struct bem_moving *m, const double complex *a) {
  const struct bem_conformal *map = m->map;
  for (size_t i = 0; i <= map->n; i++) {
    m->body[i] = m->rate[i] = (struct bem_rigid){0};
    if (!is_of_side(m, i)) continue;
    const double complex *z = map->point + i, *v = m->velocity + i;
    m->body[i] = rigid(z, v);
    /* an acceleration is the rate at a fixed place, and by the way to others */
    const double complex at_place[2] = {a[i] - I * m->body[i].turn * v[0],
                                        a[i + 1] - I * m->body[i].turn * v[1]};
    m->rate[i] = rigid(z, at_place);
  }
}

enum status bem_moving_set(struct bem_moving *m, double time) {
  const struct case_file *c = m->c;
  const double scale = sqrt(c->H / c->gravity);
  const size_t n = c->walls.points;
  double(*p)[2] = NULL;
  double complex point[BEM_MOST_BENDS + 2], a[BEM_MOST_BENDS + 2];
  if (time == m->time) return OK;
  TRY(array_create(&p, 3 * n, "points of walls"));
  tank_vertices_at(&c->walls, c->motions, c->n_motions, time * scale, p, p + n, p + 2 * n);
  for (size_t i = 0; i < m->map->n + 2; i++) {
    const double *at = p[m->vertex[i]], *v = p[n + m->vertex[i]], *w = p[2 * n + m->vertex[i]];
    point[i] = in_H(c, at);
    m->velocity[i] = CMPLX(v[0], v[1]) * scale / c->H;
    a[i] = CMPLX(w[0], w[1]) / c->gravity;
  }
  free(p);
  m->time = NAN;
  TRY(bem_conformal_move(m->map, point));
  m->changes = m->map->changes;
  m->time = time;
  set_bodies(m, a);
  return OK;
}

double complex bem_moving_place(const struct bem_moving *m, double complex z) {
  const struct bem_conformal *map = m->map;
  for (size_t i = 0; i <= map->n; i++) {
    if (!is_of_side(m, i)) continue;
    const double complex a = in_H(m->c, m->c->walls.p[m->vertex[i]]),
                         b = in_H(m->c, m->c->walls.p[m->vertex[i + 1]]);
    const double complex part = (z - a) / (b - a);
    if (fabs(cimag(part)) * cabs(b - a) < 1e-6 && creal(part) >= 0 && creal(part) <= 1)
      return map->point[i] + creal(part) * (map->point[i + 1] - map->point[i]);
  }
  return z;
}

/* The map where the points have gone on for a time at their velocities. */
static enum status map_after(const struct bem_moving *m, double time, struct bem_conformal **map) {
  double complex point[BEM_MOST_BENDS + 2];
  for (size_t i = 0; i < m->map->n + 2; i++) point[i] = m->map->point[i] + time * m->velocity[i];
  TRY(bem_conformal_copy(m->map, map));
  return bem_conformal_move(*map, point);
}

/* Whether the image of a bend moves beside which there is a flux. */
static bool drifts(const struct bem_moving *m, const struct bem_map_rate *rate, bool turns) {
  for (size_t k = 0; k < m->map->n; k++)
    if (rate->xi[k] != 0 &&
        (turns || bem_rigid_moves(m->body[k]) || bem_rigid_moves(m->body[k + 1])))
      return true;
  return false;
}

/* Central differences of fourth order. */
enum status bem_moving_rate(const struct bem_moving *m, bool turns, struct bem_map_rate *rate) {
  static const double at[4] = {-2, -1, 1, 2}, weight[4] = {1. / 12, -2. / 3, 2. / 3, -1. / 12};
  double fastest = 0, shortest = INFINITY;
  *rate = (struct bem_map_rate){0};
  for (size_t i = 0; i <= m->map->n; i++) {
    fastest = fmax(fastest, fmax(cabs(m->velocity[i]), cabs(m->velocity[i + 1])));
    shortest = fmin(shortest, cabs(m->map->point[i + 1] - m->map->point[i]));
  }
  if (!(fastest > 0)) return OK;
  const double step = STEP * shortest / fastest;
  for (int i = 0; i < 4; i++) {
    struct bem_conformal *map = NULL;
    const enum status status = map_after(m, at[i] * step, &map);
    for (size_t k = 0; status == OK && k < map->n; k++) {
      rate->xi[k] += weight[i] / step * map->xi[k];
      rate->power[k] += weight[i] / step * map->power[k];
    }
    if (status == OK) rate->factor += weight[i] / step * clog(map->factor / m->map->factor);
    bem_conformal_destroy(map);
    TRY(status);
  }
  rate->xi[0] = rate->xi[m->map->n - 1] = 0; /* they stay, but for rounding */
  rate->drifts = drifts(m, rate, turns);
  return OK;
}

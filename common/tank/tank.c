#include "common/tank/tank.h"

#include "common/tank/room.h"

struct tank tank_of(const struct geo_lines *walls, const bool periodic[2]) {
  struct tank t = {.box = geo_lines_box(walls), .periodic = {periodic[0], periodic[1]}};
  t.top[TANK_LEFT] = t.periodic[0] ? INFINITY : walls->p[0][1];
  t.top[TANK_RIGHT] = t.periodic[0] ? INFINITY : walls->p[walls->points - 1][1];
  return t;
}

struct geo_box tank_around(const struct tank *t, double reach) {
  return (struct geo_box){{t->box.min[0] - reach, t->box.min[1] - reach},
                          {t->box.max[0] + reach, t->box.max[1] + (t->periodic[1] ? reach : 0)}};
}

struct geo_box tank_walled(const struct tank *t) {
  struct geo_box walled = t->box;
  for (int axis = 0; axis < 2; axis++)
    if (t->periodic[axis]) {
      walled.min[axis] = -INFINITY;
      walled.max[axis] = INFINITY;
    }
  return walled;
}

/* The point at x of the piece of bed from p to q, which it is on. */
static enum status cut_bed(const double p[2], const double q[2], double x, struct geo_lines *out) {
  return geo_lines_add(out, x, p[1] + (q[1] - p[1]) * (x - p[0]) / (q[0] - p[0]));
}

/* A bed that is not flat, again and again, from `beyond` before the tank to as much behind it. */
static enum status round_bed(const struct tank *t, const struct geo_lines *walls, double beyond,
                             struct geo_lines *out) {
  const double length = tank_size(t, 0), from = t->box.min[0] - beyond, to = t->box.max[0] + beyond;
  const int more = (int)ceil(beyond / length);
  size_t first, last;
  tank_find_bed(walls, &first, &last);
  TRY(geo_lines_begin(out, false));
  for (int k = -more; k <= more; k++)
    for (size_t i = first; i < last; i++) {
      const double p[2] = {walls->p[i][0] + k * length, walls->p[i][1]};
      const double q[2] = {walls->p[i + 1][0] + k * length, walls->p[i + 1][1]};
      if (p[0] < from && q[0] > from) TRY(cut_bed(p, q, from, out));
      if (p[0] >= from && p[0] <= to) TRY(geo_lines_add(out, p[0], p[1]));
      if (p[0] < to && q[0] > to) TRY(cut_bed(p, q, to, out));
      if (k == more && i + 1 == last && q[0] <= to) TRY(geo_lines_add(out, q[0], q[1]));
    }
  return OK;
}

enum status tank_walls(const struct tank *t, const struct geo_lines *walls, double beyond,
                       struct geo_lines *out) {
  geo_lines_clear(out);
  if (!tank_is_periodic(t)) return geo_lines_copy(out, walls);
  if (t->periodic[1]) return OK;
  if (!tank_is_rectangular(walls, 1e-9 * tank_size(t, 0))) return round_bed(t, walls, beyond, out);
  TRY(geo_lines_begin(out, false));
  TRY(geo_lines_add(out, t->box.min[0] - beyond, t->box.min[1]));
  return geo_lines_add(out, t->box.max[0] + beyond, t->box.min[1]);
}

enum status tank_outline(const struct tank *t, const struct geo_lines *walls,
                         struct geo_lines *out) {
  const struct geo_box *b = &t->box;
  if (!t->periodic[1]) return geo_lines_copy(out, walls);
  geo_lines_clear(out);
  TRY(geo_lines_begin(out, true));
  TRY(geo_lines_add(out, b->min[0], b->min[1]));
  TRY(geo_lines_add(out, b->max[0], b->min[1]));
  TRY(geo_lines_add(out, b->max[0], b->max[1]));
  return geo_lines_add(out, b->min[0], b->max[1]);
}

bool tank_is_rectangular(const struct geo_lines *walls, double near) {
  const struct geo_box box = geo_lines_box(walls);
  enum { LEFT, BED, RIGHT } part = LEFT;
  if (walls->pieces != 1 || walls->closed[0] || walls->points < 4) return false;
  for (size_t i = 0; i + 1 < walls->points; i++) {
    const double *p = walls->p[i], *q = walls->p[i + 1];
    if (part == LEFT && i > 0 && fabs(p[1] - box.min[1]) <= near) part = BED;
    if (part == BED && fabs(p[0] - box.max[0]) <= near) part = RIGHT;
    double side = part == LEFT ? box.min[0] : box.max[0];
    bool along = part == BED ? fabs(p[1] - box.min[1]) <= near && fabs(q[1] - box.min[1]) <= near &&
                                   q[0] > p[0]
                             : fabs(p[0] - side) <= near && fabs(q[0] - side) <= near &&
                                   (part == LEFT ? q[1] < p[1] : q[1] > p[1]);
    if (!along) return false;
  }
  return part == RIGHT;
}

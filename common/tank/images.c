#include "common/tank/images.h"

#include <math.h>
#include <stdlib.h>

#include "common/base/array.h"

static const double right_angle = 1e-6; /* cosine; walls are known no better (case_near) */

struct rigid rigid_mirror(const double a[2], const double b[2]) {
  double ex = b[0] - a[0], ey = b[1] - a[1], l2 = ex * ex + ey * ey;
  double even = (ex * ex - ey * ey) / l2, odd = 2 * ex * ey / l2;
  return (struct rigid){{a[0] - even * a[0] - odd * a[1], a[1] - odd * a[0] + even * a[1]},
                        {{even, odd}, {odd, -even}}};
}

struct rigid rigid_half_turn(const double about[2]) {
  return (struct rigid){{2 * about[0], 2 * about[1]}, {{-1, 0}, {0, -1}}};
}

struct rigid rigid_shift(double x, double y) {
  return (struct rigid){{x, y}, {{1, 0}, {0, 1}}};
}

/* ---- the walls ---- */

static enum status make_room(struct images *t, size_t n) {
  TRY(array_grow(&t->found, &t->found_room, 2 * n, "images in walls"));
  if (n <= t->room) return OK;
  TRY(array_resize(&t->wall, n, "walls with images"));
  TRY(array_resize(&t->beside, n, "walls with images"));
  TRY(array_resize(&t->here, n, "walls with images"));
  t->room = n;
  return OK;
}

static bool is_sharp(const struct face *u, const struct face *v) {
  const double along = u->t[0] * v->t[0] + u->t[1] * v->t[1];
  return along <= right_angle && u->t[0] * v->t[1] - u->t[1] * v->t[0] > 0;
}

static void set_end(const struct images *t, const struct face *f, int end, bool divided,
                    struct reflector *w) {
  const uint32_t other = end ? f->next : f->before;
  if (f->end[end] == FACE_END_TOP) return;
  const struct face *g = &t->faces.face[other];
  if (f->end[end] == FACE_END_CORNER) w->sharp[end] = end ? is_sharp(f, g) : is_sharp(g, f);
  if (f->end[end] == FACE_END_EDGE) w->sharp[end] = !divided;
  if (f->end[end] != FACE_END_BLUNT && !(f->end[end] == FACE_END_EDGE && divided)) return;
  for (int axis = 0; axis < 2; axis++)
    w->across[end][axis] = (end ? 1 : -1) * (f->t[axis] + g->t[axis]);
}

enum status images_set_walls(struct images *t, const struct geo_lines *walls, double thin) {
  TRY(faces_set(&t->faces, walls, thin, NULL));
  t->n = t->faces.n;
  TRY(make_room(t, t->n));
  for (size_t i = 0; i < t->n; i++) {
    const struct face *f = &t->faces.face[i];
    t->wall[i] = (struct reflector){.motion = {rigid_mirror(f->a, f->b), rigid_half_turn(f->a)}};
    for (int end = 0; end < 2; end++) set_end(t, f, end, thin == 0, &t->wall[i]);
  }
  return OK;
}

void images_move(struct images *t, const struct faces *faces) {
  for (size_t i = 0; i < t->n; i++) {
    const struct face *f = &faces->face[i];
    t->faces.face[i] = *f;
    t->wall[i].motion[0] = rigid_mirror(f->a, f->b);
    t->wall[i].motion[1] = rigid_half_turn(f->a);
  }
}

/* Beyond an edge as far as the reach. */
static double room_beyond(const struct face *f, const struct reflector *w, int end, double reach,
                          double beyond) {
  return f->end[end] == FACE_END_EDGE && w->sharp[end] ? reach + beyond : beyond;
}

void images_set_reach(struct images *t, double reach, double beyond) {
  t->reach = reach;
  for (size_t i = 0; i < t->n; i++) {
    const struct face *f = &t->faces.face[i];
    struct reflector *w = &t->wall[i];
    const double before = room_beyond(f, w, 0, reach, beyond);
    const double after = room_beyond(f, w, 1, reach, beyond);
    const double far = 1.001 * (reach + fmax(before, after)); /* more than rounding could add */
    w->from = -before / f->length;
    w->to = 1 + after / f->length;
    for (int d = 0; d < 2; d++) {
      t->beside[i].min[d] = fmin(f->a[d], f->b[d]) - far;
      t->beside[i].max[d] = fmax(f->a[d], f->b[d]) + far;
    }
  }
}

/* ---- the periods ---- */

enum status images_set_periods(struct images *t, const struct tank *tank, double reach) {
  int most[2] = {0, 0};
  for (int axis = 0; axis < 2; axis++)
    if (tank->periodic[axis]) most[axis] = (int)ceil(reach / tank_size(tank, axis));
  const size_t n = (size_t)(2 * most[0] + 1) * (size_t)(2 * most[1] + 1) - 1;
  TRY(array_grow(&t->shift, &t->shift_room, n, "periods of the tank"));
  TRY(array_grow(&t->found, &t->found_room, n, "images by periods"));
  t->n_shifts = 0;
  for (int a = -most[0]; a <= most[0]; a++)
    for (int b = -most[1]; b <= most[1]; b++)
      if (a || b)
        t->shift[t->n_shifts++] = rigid_shift(a * tank_size(tank, 0), b * tank_size(tank, 1));
  t->around = (struct geo_box){{-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
  for (int axis = 0; axis < 2; axis++)
    if (tank->periodic[axis]) {
      t->around.min[axis] = tank->box.min[axis] - reach;
      t->around.max[axis] = tank->box.max[axis] + reach;
    }
  return OK;
}

void images_destroy(struct images *t) {
  faces_destroy(&t->faces);
  free(t->wall);
  free(t->beside);
  free(t->here);
  free(t->shift);
  free(t->found);
  *t = (struct images){0};
}

/* ---- the images ---- */

static bool find_foot(const struct face *f, const struct reflector *w, double reach, double x,
                      double y, double foot[2]) {
  double d, t = geo_line_foot(f->a, f->b, x, y, &d);
  for (int k = 0; k < 2; k++) foot[k] = f->a[k] + t * (f->b[k] - f->a[k]);
  return t >= w->from && t < w->to && fabs(d) < reach;
}

/* Whether the image of a point in a face is on its side of the bisectors. */
static bool is_on_its_side(const struct images *t, size_t i, double x, double y) {
  const struct face *f = &t->faces.face[i];
  const struct reflector *w = &t->wall[i];
  double to[2];
  for (int end = 0; end < 2; end++) {
    const double *n = w->across[end], *at = end ? f->b : f->a;
    if (n[0] == 0 && n[1] == 0) continue;
    rigid_turn(&w->motion[0], x, y, &to[0], &to[1]);
    for (int axis = 0; axis < 2; axis++) to[axis] += w->motion[0].at[axis] - at[axis];
    if (n[0] * to[0] + n[1] * to[1] > 0) return false;
  }
  return true;
}

/* Both motions turn a point half round, about its foot or about a vertex. */
static struct image image_about(const double centre[2], size_t motion, double x, double y) {
  return (struct image){(uint32_t)motion, 2 * centre[0] - x, 2 * centre[1] - y};
}

size_t images_of(struct images *t, double x, double y) {
  size_t n = 0;
  bool any = false;
  double foot[2];
  for (size_t i = 0; i < t->n; i++) {
    t->here[i] = geo_box_contains(&t->beside[i], x, y) &&
                 find_foot(&t->faces.face[i], &t->wall[i], t->reach, x, y, foot);
    any |= t->here[i];
  }
  for (size_t i = 0; any && i < t->n; i++) {
    const struct face *f = &t->faces.face[i];
    if (!t->here[i]) continue;
    find_foot(f, &t->wall[i], t->reach, x, y, foot);
    t->found[n] = image_about(foot, 2 * i, x, y);
    n += is_on_its_side(t, i, x, y);
    if (f->end[0] == FACE_END_CORNER && t->here[f->before])
      t->found[n++] = image_about(f->a, 2 * i + 1, x, y);
  }
  return n;
}

size_t images_beyond(struct images *t, double x, double y) {
  size_t n = 0;
  for (size_t k = 0; k < t->n_shifts; k++) {
    const double *by = t->shift[k].at;
    t->found[n] = (struct image){(uint32_t)(2 * t->n + k), x + by[0], y + by[1]};
    n += geo_box_contains(&t->around, t->found[n].x, t->found[n].y);
  }
  return n;
}

static bool is_on(const struct images *t, size_t i, double x, double y) {
  const struct face *f = &t->faces.face[i];
  const struct reflector *w = &t->wall[i];
  double ex = f->b[0] - f->a[0], ey = f->b[1] - f->a[1];
  bool past_a = (x - f->a[0]) * ex + (y - f->a[1]) * ey >= 0;
  bool past_b = (x - f->b[0]) * ex + (y - f->b[1]) * ey >= 0;
  return (past_a || w->sharp[0]) && (!past_b || w->sharp[1]);
}

bool images_counts(const struct images *t, uint32_t motion, double x, double y) {
  const size_t i = motion / 2;
  if (motion % 2 == 0) return is_on(t, i, x, y) && is_on_its_side(t, i, x, y);
  return is_on(t, i, x, y) && is_on(t, t->faces.face[i].before, x, y);
}

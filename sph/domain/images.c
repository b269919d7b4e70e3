#include "sph/domain/images.h"

#include <math.h>
#include <stdlib.h>

#include "common/base/array.h"

static const double right_angle = 1e-6; /* cosine; walls are known no better (case_near) */

struct sph_motion sph_motion_mirror(const double a[2], const double b[2]) {
  double ex = b[0] - a[0], ey = b[1] - a[1], l2 = ex * ex + ey * ey;
  double even = (ex * ex - ey * ey) / l2, odd = 2 * ex * ey / l2;
  return (struct sph_motion){{a[0] - even * a[0] - odd * a[1], a[1] - odd * a[0] + even * a[1]},
                             {{even, odd}, {odd, -even}}};
}

struct sph_motion sph_motion_half_turn(const double about[2]) {
  return (struct sph_motion){{2 * about[0], 2 * about[1]}, {{-1, 0}, {0, -1}}};
}

struct sph_motion sph_motion_shift(double x, double y) {
  return (struct sph_motion){{x, y}, {{1, 0}, {0, 1}}};
}

/* ---- the walls ---- */

static enum status make_room(struct sph_images *t, size_t n) {
  TRY(array_grow(&t->found, &t->found_room, 2 * n, "images in walls"));
  if (n <= t->room) return OK;
  TRY(array_resize(&t->wall, n, "walls with images"));
  TRY(array_resize(&t->beside, n, "walls with images"));
  t->room = n;
  return OK;
}

static void add_piece(struct sph_images *t, const struct geo_lines *walls, size_t piece) {
  const size_t first = t->n, m = geo_piece_segments(walls, piece);
  const bool closed = walls->closed[piece];
  for (size_t i = 0; i < m; i++) {
    const double *a = walls->p[walls->first[piece] + i], *b = geo_segment_end(walls, piece, i);
    size_t before = i > 0 ? t->n - 1 : closed ? first + m - 1 : first;
    t->wall[t->n++] = (struct sph_reflector){
        .a = {a[0], a[1]},
        .b = {b[0], b[1]},
        .starts = i == 0,
        .closes = closed && i > 1 && i + 1 == m,
        .first = (uint32_t)first,
        .before = (uint32_t)before,
        .motion = {sph_motion_mirror(a, b), sph_motion_half_turn(a)},
    };
  }
}

static bool is_sharp(const struct sph_reflector *u, const struct sph_reflector *v) {
  double ux = u->b[0] - u->a[0], uy = u->b[1] - u->a[1];
  double vx = v->b[0] - v->a[0], vy = v->b[1] - v->a[1];
  return ux * vx + uy * vy <= right_angle * hypot(ux, uy) * hypot(vx, vy) && ux * vy - uy * vx > 0;
}

enum status sph_images_set_walls(struct sph_images *t, const struct geo_lines *walls) {
  TRY(make_room(t, walls->points));
  t->n = 0;
  for (size_t k = 0; k < walls->pieces; k++) add_piece(t, walls, k);
  for (size_t i = 0; i < t->n; i++) {
    struct sph_reflector *w = &t->wall[i], *before = &t->wall[w->before];
    w->sharp[0] = before->sharp[1] = is_sharp(before, w);
  }
  return OK;
}

void sph_images_set_reach(struct sph_images *t, double reach, double beyond) {
  const double far = 1.001 * (reach + beyond); /* more than rounding could add */
  t->reach = reach;
  for (size_t i = 0; i < t->n; i++) {
    struct sph_reflector *w = &t->wall[i];
    double longer = beyond / hypot(w->b[0] - w->a[0], w->b[1] - w->a[1]);
    w->from = -longer;
    w->to = 1 + longer;
    for (int d = 0; d < 2; d++) {
      t->beside[i].min[d] = fmin(w->a[d], w->b[d]) - far;
      t->beside[i].max[d] = fmax(w->a[d], w->b[d]) + far;
    }
  }
}

/* ---- the periods ---- */

enum status sph_images_set_periods(struct sph_images *t, const struct tank *tank, double reach) {
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
        t->shift[t->n_shifts++] = sph_motion_shift(a * tank_size(tank, 0), b * tank_size(tank, 1));
  t->around = (struct geo_box){{-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
  for (int axis = 0; axis < 2; axis++)
    if (tank->periodic[axis]) {
      t->around.min[axis] = tank->box.min[axis] - reach;
      t->around.max[axis] = tank->box.max[axis] + reach;
    }
  return OK;
}

void sph_images_destroy(struct sph_images *t) {
  free(t->wall);
  free(t->beside);
  free(t->shift);
  free(t->found);
  *t = (struct sph_images){0};
}

/* ---- the images ---- */

static bool find_foot(const struct sph_reflector *w, double reach, double x, double y,
                      double foot[2]) {
  double d, t = geo_line_foot(w->a, w->b, x, y, &d);
  for (int k = 0; k < 2; k++) foot[k] = w->a[k] + t * (w->b[k] - w->a[k]);
  return t >= w->from && t < w->to && fabs(d) < reach;
}

/* Both motions turn a point half round, about its foot or about a vertex. */
static struct sph_image image_about(const double centre[2], size_t motion, double x, double y) {
  return (struct sph_image){(uint32_t)motion, 2 * centre[0] - x, 2 * centre[1] - y};
}

size_t sph_images_of(struct sph_images *t, double x, double y) {
  size_t n = 0;
  bool before = false, on_first = false;
  for (size_t i = 0; i < t->n; i++) {
    const struct sph_reflector *w = &t->wall[i];
    double foot[2];
    bool here = geo_box_contains(&t->beside[i], x, y) && find_foot(w, t->reach, x, y, foot);
    if (w->starts) {
      before = false;
      on_first = here;
    }
    if (here) {
      t->found[n++] = image_about(foot, 2 * i, x, y);
      if (before) t->found[n++] = image_about(w->a, 2 * i + 1, x, y);
      if (w->closes && on_first) t->found[n++] = image_about(w->b, 2 * w->first + 1, x, y);
    }
    before = here;
  }
  return n;
}

size_t sph_images_beyond(struct sph_images *t, double x, double y) {
  size_t n = 0;
  for (size_t k = 0; k < t->n_shifts; k++) {
    const double *by = t->shift[k].at;
    t->found[n] = (struct sph_image){(uint32_t)(2 * t->n + k), x + by[0], y + by[1]};
    n += geo_box_contains(&t->around, t->found[n].x, t->found[n].y);
  }
  return n;
}

static bool is_on(const struct sph_reflector *w, double x, double y) {
  double ex = w->b[0] - w->a[0], ey = w->b[1] - w->a[1];
  bool past_a = (x - w->a[0]) * ex + (y - w->a[1]) * ey >= 0;
  bool past_b = (x - w->b[0]) * ex + (y - w->b[1]) * ey >= 0;
  return (past_a || w->sharp[0]) && (!past_b || w->sharp[1]);
}

bool sph_images_counts(const struct sph_images *t, uint32_t motion, double x, double y) {
  const struct sph_reflector *w = &t->wall[motion / 2];
  return is_on(w, x, y) && (motion % 2 == 0 || is_on(&t->wall[w->before], x, y));
}

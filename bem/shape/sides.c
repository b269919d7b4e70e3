#include "bem/shape/sides.h"

#include <complex.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "common/base/array.h"

/* So many times as far along the surface as straight on is another side: half round a tip is less
 * than 1.6 times, and a notch of more than 40 degrees never. */
static const double AROUND = 3;
static const double FACING = 0.3;  /* cosine between the normal and the way over */
static const double FAR = 1e3;     /* H: walls go on for ever */
static const double BLUNT = -0.17; /* cosine: 100 degrees, up to which velocities hardly grow */

enum status bem_sides_reserve(struct bem_sides *w, const struct bem_surface *s) {
  const size_t stretches = bem_stretches_count(s);
  if (stretches > w->stretch_room) {
    TRY(array_resize(&w->stretch, stretches, "stretches of a surface"));
    w->stretch_room = stretches;
  }
  if (s->n <= w->room) return OK;
  TRY(array_resize(&w->arc, s->n, "lengths along a surface"));
  w->room = s->n;
  return OK;
}

void bem_sides_destroy(struct bem_sides *w) {
  free(w->arc);
  free(w->stretch);
  *w = (struct bem_sides){0};
}

void bem_sides_set(const struct bem_sides *w, const struct bem_surface *s, const double *state) {
  const double *x = state, *y = x + s->n;
  w->arc[0] = 0;
  for (size_t k = 1; k < s->n; k++)
    w->arc[k] = w->arc[k - 1] + hypot(x[k] - x[k - 1], y[k] - y[k - 1]);
  bem_stretches_set(s, state, w->stretch);
}

/* ---- walls ---- */

size_t bem_sides_walls(const struct bem_surface *s) {
  if (bem_surface_is_closed(s)) return s->period.bed > 0 ? 1 : 0;
  if (s->walls) return s->walls->n + 1;
  return s->right == BEM_END_BED ? 2 : 3;
}

size_t bem_sides_held(const struct bem_surface *s, bool right) {
  if (bem_surface_is_closed(s)) return SIZE_MAX;
  if (s->walls) return s->side[right];
  return right ? bem_sides_walls(s) - 1 : 0;
}

void bem_sides_wall(const struct bem_surface *s, size_t wall, double complex *a,
                    double complex *b) {
  if (s->walls) {
    const double complex along = bem_conformal_along(s->walls, wall);
    *a = s->walls->point[wall];
    *b = s->walls->point[wall + 1];
    if (wall == 0) *a = *b - FAR * along;
    if (wall == s->walls->n) *b = *a + FAR * along;
    return;
  }
  if (bem_surface_is_closed(s)) {
    *a = -FAR;
    *b = FAR;
    return;
  }
  const double end = s->right == BEM_END_BED ? FAR : s->tank;
  const double complex corner[] = {CMPLX(s->left, FAR), s->left, end, CMPLX(end, FAR)};
  *a = corner[wall];
  *b = corner[wall + 1];
}

bool bem_sides_is_blunt(const struct bem_surface *s, bool right) {
  const double *x = s->state, *y = x + s->n;
  const size_t edge = right ? s->n - 1 : 0, inner = right ? edge - 1 : 1;
  double complex a, b;
  bem_sides_wall(s, bem_sides_held(s, right), &a, &b);
  const double complex below = right ? a - b : b - a,
                       way = CMPLX(x[inner] - x[edge], y[inner] - y[edge]);
  return creal(way * conj(below)) < BLUNT * cabs(way) * cabs(below);
}

/* ---- distances ---- */

static double complex node(const struct bem_surface *s, const double *state, ptrdiff_t k) {
  return CMPLX(bem_period_value(state, s->n, k), bem_period_value(state + s->n, s->n, k));
}

static double length_to(const struct bem_sides *w, const struct bem_surface *s, ptrdiff_t k) {
  return bem_period_value(w->arc, s->n, k);
}

static double cross(double complex a, double complex b) {
  return cimag(conj(a) * b);
}

/* Distance of z from the way from a to b; *part: where on it. */
static double distance_to(double complex z, double complex a, double complex b, double *part) {
  const double complex way = b - a;
  const double u = creal((z - a) * conj(way)) / creal(way * conj(way));
  *part = u > 0 ? (u < 1 ? u : 1) : 0;
  const double complex off = z - a - *part * way;
  return sqrt(creal(off) * creal(off) + cimag(off) * cimag(off)); /* no length here overflows */
}

/* Out of the water, at a node that is not an end of the surface. */
static double complex outward(const struct bem_surface *s, const double *state, ptrdiff_t k) {
  const double complex way = node(s, state, k + 1) - node(s, state, k - 1);
  return I * way / cabs(way);
}

static bool faces(double complex normal, enum bem_between between, double complex over) {
  const double out = creal(over * conj(normal));
  return (between == BEM_AIR ? out : -out) >= FACING * cabs(over);
}

/* The same of the panels from j to `to`; *near: only what is nearer than that. */
static bool panels_across(const struct bem_sides *w, const struct bem_surface *s,
                          const double *state, size_t k, enum bem_between between, ptrdiff_t j,
                          ptrdiff_t to, double *reach, struct bem_near *near) {
  const ptrdiff_t own = (ptrdiff_t)k;
  const double complex z = node(s, state, own), normal = outward(s, state, own);
  bool found = false;
  for (; j < to; j++) {
    const double complex a = node(s, state, j), b = node(s, state, j + 1);
    double part, d = distance_to(z, a, b, &part);
    if (d >= *reach || j == own || j + 1 == own) continue;
    const double before = length_to(w, s, j), behind = length_to(w, s, j + 1);
    const double along = fabs(before + part * (behind - before) - w->arc[k]);
    const double complex foot = a + part * (b - a);
    if (along < AROUND * d || !faces(normal, between, foot - z)) continue;
    *near =
        (struct bem_near){d, along, k, bem_period_node(s->n, j), false, creal(foot), cimag(foot)};
    *reach = d;
    found = true;
  }
  return found;
}

bool bem_sides_across(const struct bem_sides *w, const struct bem_surface *s, const double *state,
                      size_t k, enum bem_between between, double reach, struct bem_near *near) {
  const size_t last = s->n - 2, own = bem_stretches_of(s, (ptrdiff_t)(k < last ? k : last));
  const struct bem_stretch *mine = w->stretch + own;
  const double at[2] = {state[k], state[s->n + k]};
  bool found = false;
  if (reach <= mine->clear) return false;
  for (size_t i = 0, count = bem_stretches_count(s); i < count; i++) {
    if (i == mine->from && mine->to > i) {
      i = mine->to - 1;
      continue;
    }
    if (bem_stretches_apart(at, at, w->stretch + i) >= reach * reach) continue;
    found |= panels_across(w, s, state, k, between, bem_stretches_from(s, i),
                           bem_stretches_to(s, i), &reach, near);
  }
  return found;
}

bool bem_sides_wall_across(const struct bem_sides *w, const struct bem_surface *s,
                           const double *state, size_t k, enum bem_between between, double reach,
                           struct bem_near *near) {
  const double complex z = node(s, state, (ptrdiff_t)k), normal = outward(s, state, (ptrdiff_t)k);
  const double way[2] = {w->arc[k], w->arc[s->n - 1] - w->arc[k]};
  bool found = false;
  for (size_t i = 0; i < bem_sides_walls(s); i++) {
    double complex a, b;
    double part, around = HUGE_VAL;
    bem_sides_wall(s, i, &a, &b);
    const double d = distance_to(z, a, b, &part);
    for (int end = 0; end < 2; end++) /* the way to the image in the wall is twice as far */
      if (bem_sides_held(s, end) == i) around = fmin(around, way[end]);
    const double complex foot = a + part * (b - a);
    if (d >= reach || around < AROUND * d || !faces(normal, between, foot - z)) continue;
    *near = (struct bem_near){d, around, k, i, true, creal(foot), cimag(foot)};
    reach = d;
    found = true;
  }
  return found;
}

bool bem_sides_outside(const struct bem_surface *s, const double *state, size_t k,
                       enum bem_between between, struct bem_near *near) {
  const double complex z = node(s, state, (ptrdiff_t)k);
  double complex nearest_way = 1;
  double part, at = 0;
  near->distance = HUGE_VAL;
  for (size_t i = 0; i < bem_sides_walls(s); i++) {
    double complex a, b;
    bem_sides_wall(s, i, &a, &b);
    const double d = distance_to(z, a, b, &part);
    if (d >= near->distance) continue;
    const double complex foot = a + part * (b - a);
    *near = (struct bem_near){d, HUGE_VAL, k, i, true, creal(foot), cimag(foot)};
    nearest_way = foot - z;
    at = part > 0 && part < 1 ? cross(b - a, z - a) : 1; /* beside an edge it is inside */
  }
  if (!(at < 0) || near->distance == 0) return false;
  near->distance = -near->distance;
  return faces(outward(s, state, (ptrdiff_t)k), between, -nearest_way);
}

bool bem_sides_narrowest(const struct bem_sides *w, const struct bem_surface *s,
                         const double *state, enum bem_between between, double reach,
                         struct bem_near *near) {
  bool found = false;
  near->distance = reach;
  for (size_t k = 1; k + 1 < s->n; k++) {
    found |= bem_sides_across(w, s, state, k, between, near->distance, near);
    found |= bem_sides_wall_across(w, s, state, k, between, near->distance, near);
  }
  return found;
}

/* ---- crossings ---- */

/* Whether the ways from a to b and from c to d cross; *part: where on the first. */
static bool ways_cross(double complex a, double complex b, double complex c, double complex d,
                       double *part) {
  const double over = cross(b - a, d - c);
  if (over == 0) return false;
  const double other = cross(c - a, b - a) / over;
  *part = cross(c - a, d - c) / over;
  return *part >= 0 && *part < 1 && other >= 0 && other < 1;
}

/* Water is on the right of the surface: a loop that it runs round clockwise holds water. */
static double loop_area(const struct bem_surface *s, const double *state, ptrdiff_t first,
                        ptrdiff_t last, double complex at) {
  double twice = 0;
  for (ptrdiff_t k = first + 1; k < last; k++)
    twice += cross(node(s, state, k) - at, node(s, state, k + 1) - at);
  return -0.5 * twice;
}

/* Panel i with those from j to `to`. */
static bool cross_panels(const struct bem_surface *s, const double *state, ptrdiff_t i, ptrdiff_t j,
                         ptrdiff_t to, struct bem_crossing *c) {
  const double complex a = node(s, state, i), b = node(s, state, i + 1);
  for (; j < to; j++) {
    double part;
    if (!ways_cross(a, b, node(s, state, j), node(s, state, j + 1), &part)) continue;
    const double complex at = a + part * (b - a);
    *c = (struct bem_crossing){(size_t)i, (size_t)j, creal(at), cimag(at),
                               loop_area(s, state, i, j, at)};
    return true;
  }
  return false;
}

static ptrdiff_t later(ptrdiff_t a, ptrdiff_t b) {
  return a > b ? a : b;
}

static ptrdiff_t sooner(ptrdiff_t a, ptrdiff_t b) {
  return a < b ? a : b;
}

/* Panel i of a stretch with those behind it. */
static bool cross_panel(const struct bem_sides *w, const struct bem_surface *s, const double *state,
                        ptrdiff_t i, struct bem_crossing *c) {
  const struct bem_stretch *mine = w->stretch + bem_stretches_of(s, i);
  const ptrdiff_t behind =
      bem_surface_is_closed(s) ? i + (ptrdiff_t)s->n - 2 : bem_stretches_behind(s);
  for (size_t k = mine->to, count = bem_stretches_count(s); k < count; k++)
    if (bem_stretches_apart(mine->low, mine->high, w->stretch + k) == 0 &&
        cross_panels(s, state, i, later(i + 2, bem_stretches_from(s, k)),
                     sooner(behind, bem_stretches_to(s, k)), c))
      return true;
  return false;
}

bool bem_sides_cross(const struct bem_sides *w, const struct bem_surface *s, const double *state,
                     size_t from, struct bem_crossing *c) {
  for (size_t i = from; i + 1 < s->n; i++)
    if (w->stretch[bem_stretches_of(s, (ptrdiff_t)i)].clear == 0 &&
        cross_panel(w, s, state, (ptrdiff_t)i, c))
      return true;
  return false;
}

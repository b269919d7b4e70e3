#include "bem/breaking/breaker.h"

#include <math.h>

/* A film on a wall is thinner than that, of the mean depth and of its length. It bulges here and
 * there without ever becoming a breaker. */
static const double THIN = 0.2, SLENDER = 0.5;

static const double UPRIGHT = 0.02; /* rad */
static const double CAVITY = 100;   /* so much longer is the way round one than across */
static const double LEVEL = 0.5;    /* cosine: less than 60 degrees from it faces up */

static double tangent(const struct bem_surface *s, const double *state, size_t at) {
  double d[2];
  const ptrdiff_t k = (ptrdiff_t)at;
  for (size_t axis = 0; axis < 2; axis++) {
    const double *f = state + axis * s->n;
    d[axis] = bem_period_value(f, s->n, k - 2) - 8 * bem_period_value(f, s->n, k - 1) +
              8 * bem_period_value(f, s->n, k + 1) - bem_period_value(f, s->n, k + 2);
  }
  return d[0] / hypot(d[0], d[1]);
}

/* Least value of the parabola through three neighbouring values, `least` the middle one; *offset,
 * in nodes from the middle, is where. The middle one itself unless it is below both. */
static double refine(double before, double least, double after, double *offset) {
  *offset = 0;
  if (!(before > least && after > least)) return least;
  double bend = before - 2 * least + after, slope = 0.5 * (after - before);
  *offset = -slope / bend;
  return least - 0.5 * slope * slope / bend;
}

/* Whether node k is in the film on the wall that an end of the surface is on. Water on a side that
 * is flatter than 45 degrees rests there and is none. */
static bool in_film(const struct bem_surface *s, const double *state, size_t k, bool right) {
  const size_t end = right ? s->n - 1 : 0;
  double complex a, b;
  if (bem_surface_is_closed(s)) return false;
  bem_sides_wall(s, bem_sides_held(s, right), &a, &b);
  if (fabs(creal(b - a)) > fabs(cimag(b - a))) return false;
  const double complex over =
      CMPLX(state[k] - state[end], state[s->n + k] - state[s->n + end]) * conj(b - a) / cabs(b - a);
  return fabs(cimag(over)) < fmin(THIN * s->depth, SLENDER * fabs(creal(over)));
}

static bool counts(const struct bem_surface *s, const double *state, size_t k) {
  if (s->corner && k + 2 > s->corner && k < s->corner + 2) return false;
  return !in_film(s, state, k, false) && !in_film(s, state, k, true);
}

double bem_breaker_tangent(const struct bem_surface *s, const double *state, enum bem_face face,
                           double *where) {
  const double *y = state + s->n;
  double least = 1, offset, before = 1;
  size_t at = 0;
  enum bem_face here = BEM_RISING;
  *where = 0;
  for (size_t k = 3; k + 3 < s->n; k++) {
    double t = tangent(s, state, k);
    if (!(t < 0 && before < 0)) here = y[k + 1] > y[k - 1] ? BEM_RISING : BEM_FALLING;
    before = t;
    if (t >= least || here != face || !counts(s, state, k)) continue;
    least = t;
    at = k;
  }
  if (!at) return least;
  least = refine(tangent(s, state, at - 1), least, tangent(s, state, at + 1), &offset);
  *where = (double)at + offset;
  return least;
}

/* Within UPRIGHT of the vertical: the steepest point itself wanders along a face that is nearly
 * upright over a third of H. */
double bem_breaker_upright(const struct bem_surface *s, const double *state, double where) {
  size_t low = (size_t)(where + 0.5), high = low;
  double below = 0, above = 0;
  while (low > 3 && (below = tangent(s, state, low)) < UPRIGHT) low--;
  while (high + 3 < s->n && (above = tangent(s, state, high)) < UPRIGHT) high++;
  double from = (double)low, to = (double)high, next;
  if ((next = tangent(s, state, low + 1)) < UPRIGHT) from += (below - UPRIGHT) / (below - next);
  if ((next = tangent(s, state, high - 1)) < UPRIGHT) to -= (above - UPRIGHT) / (above - next);
  return 0.5 * (from + to);
}

/* Where the surface has closed round air, which is more than a bubble that the panels do not
 * resolve.
 */
static bool find_closed(const struct bem_sides *w, const struct bem_surface *s, const double *state,
                        struct bem_near *near) {
  struct bem_crossing c;
  for (size_t from = 0; bem_sides_cross(w, s, state, from, &c); from = c.first + 1) {
    if (c.area > 0 || c.last - c.first <= BEM_BUBBLE) continue;
    *near = (struct bem_near){-0.5 * (w->arc[c.first + 1] - w->arc[c.first]),
                              HUGE_VAL,
                              bem_period_node(s->n, (ptrdiff_t)c.last),
                              c.first,
                              false,
                              c.x,
                              c.y};
    return true;
  }
  return false;
}

/* Where the surface has gone farthest through a wall with air before it. */
static bool find_struck(const struct bem_surface *s, const double *state, struct bem_near *near) {
  struct bem_near here;
  near->distance = 0;
  for (size_t k = BEM_BUBBLE / 2; k + BEM_BUBBLE / 2 < s->n; k++)
    if (bem_sides_outside(s, state, k, BEM_AIR, &here) && here.distance < near->distance)
      *near = here;
  return near->distance < 0;
}

double bem_breaker_gap(const struct bem_sides *w, const struct bem_surface *s, const double *state,
                       double reach, struct bem_near *near) {
  bem_sides_set(w, s, state);
  if (!find_closed(w, s, state, near) && !find_struck(s, state, near))
    bem_sides_narrowest(w, s, state, BEM_AIR, reach, near);
  return near->distance;
}

/* Between the sides of a notch it is never so narrow. */
bool bem_breaker_touches(const struct bem_sides *w, const struct bem_surface *s,
                         const double *state, double little) {
  struct bem_near near;
  bem_breaker_gap(w, s, state, little, &near);
  return near.distance < little && near.around > CAVITY * near.distance;
}

static bool faces_up(const struct bem_surface *s, const double *state, size_t before,
                     size_t after) {
  const double dx = state[after] - state[before], dy = state[s->n + after] - state[s->n + before];
  return dx > LEVEL * hypot(dx, dy);
}

bool bem_breaker_falls(const struct bem_surface *s, const double *state,
                       const struct bem_near *near) {
  const ptrdiff_t node = (ptrdiff_t)near->node, panel = (ptrdiff_t)near->panel;
  return !near->wall &&
         (faces_up(s, state, node - 1, node + 1) || faces_up(s, state, panel, panel + 1));
}

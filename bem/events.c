#include "bem/events.h"

#include <math.h>

#include "bem/contact.h"

/* Water so near the right wall is film and no breaker. */
static const double ASIDE = 0.08; /* H */

static const double UPRIGHT = 0.02; /* rad */

static double tangent(const struct bem_surface *s, const double *state, size_t k) {
  const double *x = state + k, *y = x + s->n;
  double dx = x[-2] - 8 * x[-1] + 8 * x[1] - x[2], dy = y[-2] - 8 * y[-1] + 8 * y[1] - y[2];
  return dx / hypot(dx, dy);
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

/* Smallest horizontal component of the unit tangent (surface walked from left to right) where the
 * breaker rises, and where: in nodes, with fractions; 0 when nothing rises. */
static double least_tangent(const struct bem_surface *s, const double *state, double *where) {
  const double *x = state, *y = state + s->n;
  double least = 1, offset;
  size_t at = 0;
  *where = 0;
  for (size_t k = 3; k + 3 < s->n; k++) {
    if (y[k + 1] <= y[k - 1] || s->tank - x[k] < ASIDE || y[k] > BEM_FILM_HIGH) continue;
    double t = tangent(s, state, k);
    if (t >= least) continue;
    least = t;
    at = k;
  }
  if (!at) return least;
  least = refine(tangent(s, state, at - 1), least, tangent(s, state, at + 1), &offset);
  *where = (double)at + offset;
  return least;
}

/* The middle of the stretch around node `at` that is within UPRIGHT of the vertical, in nodes: the
 * steepest point itself wanders along a face that is nearly upright over a third of H. */
static double upright_middle(const struct bem_surface *s, const double *state, double at) {
  size_t low = (size_t)(at + 0.5), high = low;
  double below = 0, above = 0;
  while (low > 3 && (below = tangent(s, state, low)) < UPRIGHT) low--;
  while (high + 3 < s->n && (above = tangent(s, state, high)) < UPRIGHT) high++;
  double from = (double)low, to = (double)high, next;
  if ((next = tangent(s, state, low + 1)) < UPRIGHT) from += (below - UPRIGHT) / (below - next);
  if ((next = tangent(s, state, high - 1)) < UPRIGHT) to -= (above - UPRIGHT) / (above - next);
  return 0.5 * (from + to);
}

/* Vertical distance of node k from the surface left of the node `cavity`; *below is where the last
 * search ended. */
static double height_over(const struct bem_surface *s, const double *state, size_t cavity, size_t k,
                          size_t *below) {
  const double *x = state, *y = state + s->n;
  while (*below > 0 && x[*below] > x[k]) --*below;
  while (*below + 1 < cavity && x[*below + 1] < x[k]) ++*below;
  double a = (x[k] - x[*below]) / (x[*below + 1] - x[*below]);
  return y[k] - y[*below] - a * (y[*below + 1] - y[*below]);
}

/* Vertical distance of the jet from the surface below it, least over the jet's far half: the
 * cavity's deepest point is the first node from the left where x turns back, and from there the
 * distance first grows from zero. 1 while nothing hangs over. *where in nodes, with fractions. */
static double least_gap(const struct bem_surface *s, const double *state, double *where) {
  const double *x = state;
  size_t cavity = 1, at = 0;
  *where = 0;
  while (cavity + 2 < s->n && x[cavity + 1] > x[cavity]) cavity++;
  if (cavity + 2 >= s->n || s->tank - x[cavity] < ASIDE) return 1;
  double most = 0, least = 1, offset;
  size_t below = cavity;
  for (size_t k = cavity + 1; k < s->n && x[k] < x[cavity]; k++) {
    double gap = height_over(s, state, cavity, k, &below);
    if (gap > most && least == 1) {
      most = gap;
    } else if (gap < least) {
      least = gap;
      at = k;
    }
  }
  *where = (double)at;
  if (!at || at + 1 >= s->n || x[at + 1] >= x[cavity]) return least;
  double before = height_over(s, state, cavity, at - 1, &below);
  least = refine(before, least, height_over(s, state, cavity, at + 1, &below), &offset);
  *where += offset;
  return least;
}

/* The value at a fractional node, by the parabola through the three nearest nodes. */
static double value_at(const double *a, size_t n, double where) {
  size_t k = (size_t)(where + 0.5);
  if (k < 1 || k + 1 >= n) return a[k];
  double t = where - (double)k;
  return a[k] + 0.5 * t * (a[k + 1] - a[k - 1] + t * (a[k + 1] - 2 * a[k] + a[k - 1]));
}

double bem_events_gap(const struct bem_events *e, const double *state) {
  double where;
  return e->overturned ? least_gap(e->surface, state, &where) : 1;
}

void bem_events_roots(void *data, double time, const double *state, double root[BEM_ROOTS]) {
  (void)time;
  const struct bem_events *e = data;
  const struct bem_surface *s = e->surface;
  bool dry = s->right == BEM_END_BED;
  double where;
  root[BEM_EVENT_IMPACT] = dry ? s->tank - state[s->n - 1] : 1;
  root[BEM_EVENT_WALL] = dry ? e->thickness - bem_contact_height(s, state) : 1;
  root[BEM_EVENT_OVERTURN] = s->tip > 0 && !dry ? least_tangent(s, state, &where) : 1;
  root[BEM_EVENT_TOUCHDOWN] = bem_events_gap(e, state);
  root[BEM_EVENT_OVER_LEFT] = e->top[0] - state[s->n];
  root[BEM_EVENT_OVER_RIGHT] = dry ? 1 : e->top[1] - state[2 * s->n - 1];
}

void bem_events_place(const struct bem_events *e, enum bem_event event, const double *state,
                      double *x, double *y) {
  const struct bem_surface *s = e->surface;
  double where = event == BEM_EVENT_OVER_LEFT ? 0 : (double)(s->n - 1);
  if (event == BEM_EVENT_OVERTURN) {
    least_tangent(s, state, &where);
    where = upright_middle(s, state, where);
  }
  if (event == BEM_EVENT_TOUCHDOWN) least_gap(s, state, &where);
  *x = value_at(state, s->n, where);
  *y = value_at(state + s->n, s->n, where);
}

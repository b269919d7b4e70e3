#include "bem/events.h"

#include <math.h>

#include "bem/contact.h"

/* The film on the right wall, of which thin spikes come loose, is no breaker. */
static const double FILM = 0.08, HIGH = 1.3; /* H: from the wall, above the bed */

static double tangent(const struct bem_surface *s, const double *state, size_t k) {
  const double *x = state + k, *y = x + s->n;
  double dx = x[-2] - 8 * x[-1] + 8 * x[1] - x[2], dy = y[-2] - 8 * y[-1] + 8 * y[1] - y[2];
  return dx / hypot(dx, dy);
}

/* Smallest horizontal component of the unit tangent (surface walked from left to right) where the
 * breaker rises, refined by a parabola through the three nodes around the least. */
static double least_tangent(const struct bem_surface *s, const double *state, size_t *where) {
  const double *x = state, *y = state + s->n;
  double least = 1;
  *where = 0;
  for (size_t k = 3; k + 3 < s->n; k++) {
    if (y[k + 1] <= y[k - 1] || s->tank - x[k] < FILM || y[k] > HIGH) continue;
    double t = tangent(s, state, k);
    if (t >= least) continue;
    least = t;
    *where = k;
  }
  if (!*where) return least;
  double before = tangent(s, state, *where - 1), after = tangent(s, state, *where + 1);
  double bend = before - 2 * least + after, slope = 0.5 * (after - before);
  return before > least && after > least ? least - 0.5 * slope * slope / bend : least;
}

/* Vertical distance of the jet from the surface below it, least over the jet's far half: the
 * cavity's deepest point is the first node from the left where x turns back, and from there the
 * distance first grows from zero. 1 while nothing hangs over. */
static double least_gap(const struct bem_surface *s, const double *state, size_t *where) {
  const double *x = state, *y = state + s->n;
  size_t cavity = 1;
  *where = 0;
  while (cavity + 2 < s->n && x[cavity + 1] > x[cavity]) cavity++;
  if (cavity + 2 >= s->n || s->tank - x[cavity] < FILM) return 1;
  double most = 0, least = 1;
  size_t below = cavity;
  for (size_t k = cavity + 1; k < s->n && x[k] < x[cavity]; k++) {
    while (below > 0 && x[below] > x[k]) below--;
    while (below + 1 < cavity && x[below + 1] < x[k]) below++;
    double a = (x[k] - x[below]) / (x[below + 1] - x[below]);
    double gap = y[k] - y[below] - a * (y[below + 1] - y[below]);
    if (gap > most && least == 1) {
      most = gap;
    } else if (gap < least) {
      least = gap;
      *where = k;
    }
  }
  return least;
}

double bem_events_gap(const struct bem_events *e, const double *state) {
  size_t where;
  return e->overturned ? least_gap(e->surface, state, &where) : 1;
}

void bem_events_roots(void *data, double time, const double *state, double root[BEM_ROOTS]) {
  (void)time;
  const struct bem_events *e = data;
  const struct bem_surface *s = e->surface;
  bool dry = s->right == BEM_END_BED;
  size_t where;
  root[BEM_EVENT_IMPACT] = dry ? s->tank - state[s->n - 1] : 1;
  root[BEM_EVENT_WALL] = dry ? e->thickness - bem_contact_height(s, state) : 1;
  root[BEM_EVENT_OVERTURN] = s->tip > 0 && !dry ? least_tangent(s, state, &where) : 1;
  root[BEM_EVENT_TOUCHDOWN] = bem_events_gap(e, state);
}

void bem_events_place(const struct bem_events *e, enum bem_event event, const double *state,
                      double *x, double *y) {
  const struct bem_surface *s = e->surface;
  size_t where = s->n - 1;
  if (event == BEM_EVENT_OVERTURN) least_tangent(s, state, &where);
  if (event == BEM_EVENT_TOUCHDOWN) least_gap(s, state, &where);
  *x = state[where];
  *y = state[s->n + where];
}

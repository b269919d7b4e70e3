#include "bem/breaker.h"

#include <math.h>

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

double bem_breaker_tangent(const struct bem_surface *s, const double *state, double *where) {
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

/* The cavity's deepest point is the first node from the left where x turns back, and from there the
 * distance first grows from zero. */
double bem_breaker_gap(const struct bem_surface *s, const double *state, double *where) {
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

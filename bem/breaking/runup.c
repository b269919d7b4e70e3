#include "bem/breaking/runup.h"

#include <string.h>

static const double RISE = 1e-3; /* H: less is no run-up */

enum { TIME, X, Y };

/* A value at a time between the three, by the polynomial through them. */
static double value_at(const struct bem_runup *u, int of, double time) {
  double value = 0;
  for (int i = 0; i < 3; i++) {
    double term = u->at[i][of];
    for (int j = 0; j < 3; j++)
      if (j != i) term *= (time - u->at[j][TIME]) / (u->at[i][TIME] - u->at[j][TIME]);
    value += term;
  }
  return value;
}

/* Where the parabola through the three heights is level. */
static double level_time(const struct bem_runup *u) {
  const double *a = u->at[0], *b = u->at[1], *c = u->at[2];
  const double first = (b[Y] - a[Y]) / (b[TIME] - a[TIME]),
               last = (c[Y] - b[Y]) / (c[TIME] - b[TIME]);
  const double bend = (last - first) / (c[TIME] - a[TIME]);
  return 0.5 * (a[TIME] + b[TIME] - first / bend);
}

void bem_runup_add(struct bem_runup *u, double time, double x, double y) {
  memmove(u->at[0], u->at[1], sizeof u->at[0]);
  memmove(u->at[1], u->at[2], sizeof u->at[0]);
  u->at[2][TIME] = time;
  u->at[2][X] = x;
  u->at[2][Y] = y;
  if (++u->n < 3 || !(u->at[1][Y] > u->at[0][Y] && u->at[1][Y] >= u->at[2][Y])) return;
  const double when = level_time(u), height = value_at(u, Y, when);
  if (height <= u->top[Y]) return;
  u->top[TIME] = when;
  u->top[X] = value_at(u, X, when);
  u->top[Y] = height;
}

void bem_runup_moved(struct bem_runup *u) {
  u->n = 0;
}

bool bem_runup_found(const struct bem_runup *u, double start) {
  return u->top[Y] > start + RISE;
}

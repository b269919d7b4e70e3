#include "bem/shape/stretches.h"

#include <math.h>

/* Directions are counted by dy/(|dx| + |dy|), -1 to 1 to the right and on from there to the left:
 * four to a whole turn, and STRAIGHT of them are at most 134 degrees. Every panel is then within 67
 * degrees of the middle one, and the way along them at most 1/cos 67 = 2.6 times the way straight
 * on, which is no other side (see sides.c). */
static const double TURN = 4, STRAIGHT = 1.4;

static double direction(double dx, double dy) {
  const double whole = fabs(dx) + fabs(dy);
  if (!(whole > 0)) return 0;
  return dx >= 0 ? dy / whole : dy >= 0 ? 2 - dy / whole : -2 - dy / whole;
}

/* The same direction, within half a turn of another. */
static double unwind(double direction, double near) {
  return direction - TURN * nearbyint((direction - near) / TURN);
}

static void widen(double range[2], double by) {
  range[0] = fmin(range[0], by);
  range[1] = fmax(range[1], by);
}

static void set_boxes(const struct bem_surface *s, const double *state, struct bem_stretch *all) {
  const size_t count = bem_stretches_count(s);
  double x = bem_period_value(state, s->n, bem_stretches_first(s));
  double y = bem_period_value(state + s->n, s->n, bem_stretches_first(s)), last = 0;
  for (size_t i = 0; i < count; i++) {
    struct bem_stretch *a = all + i;
    *a = (struct bem_stretch){
        .low = {x, y}, .high = {x, y}, .turn = {HUGE_VAL, -HUGE_VAL}, .from = i, .to = i};
    for (ptrdiff_t j = bem_stretches_from(s, i), to = bem_stretches_to(s, i); j < to; j++) {
      const double px = bem_period_value(state, s->n, j + 1);
      const double py = bem_period_value(state + s->n, s->n, j + 1);
      last = unwind(direction(px - x, py - y), last);
      widen(a->turn, last);
      x = px, y = py;
      a->low[0] = x < a->low[0] ? x : a->low[0], a->high[0] = x > a->high[0] ? x : a->high[0];
      a->low[1] = y < a->low[1] ? y : a->low[1], a->high[1] = y > a->high[1] ? y : a->high[1];
    }
  }
}

/* How many stretches on, in steps of `way`, the surface turns little. */
static size_t straight_on(const struct bem_stretch *all, size_t i, size_t most, ptrdiff_t way) {
  double turn[2] = {all[i].turn[0], all[i].turn[1]};
  size_t on = 0;
  for (const struct bem_stretch *a = all + i; on < most; on++) {
    a += way;
    widen(turn, a->turn[0]);
    widen(turn, a->turn[1]);
    if (!(turn[1] - turn[0] < STRAIGHT)) break;
  }
  return on;
}

static double clear_of(const struct bem_stretch *all, size_t count, const struct bem_stretch *a) {
  double least = HUGE_VAL;
  for (size_t i = 0; i < count && least > 0; i++)
    if (i < a->from || i >= a->to)
      least = fmin(least, bem_stretches_apart(a->low, a->high, all + i));
  return sqrt(least);
}

void bem_stretches_set(const struct bem_surface *s, const double *state, struct bem_stretch *all) {
  const size_t count = bem_stretches_count(s);
  set_boxes(s, state, all);
  for (size_t i = 0; i < count; i++) {
    struct bem_stretch *a = all + i;
    if (!(a->turn[1] - a->turn[0] < STRAIGHT)) continue;
    a->from = i - straight_on(all, i, i, -1);
    a->to = i + 1 + straight_on(all, i, count - 1 - i, 1);
    a->clear = clear_of(all, count, a);
  }
}

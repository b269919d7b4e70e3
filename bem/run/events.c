#include "bem/run/events.h"

#include <math.h>
#include <stdio.h>

#include "bem/breaking/breaker.h"
#include "bem/breaking/contact.h"
#include "bem/options.h"

/* What passes the top of the right wall is cut there and counted while it is a film thinner than
 * SPILL and little: a thicker jet is not free of pressure, and the film is qualitative anyway; more
 * than that ends the run. */
static const double SPILL = 0.05;     /* H */
static const double SPILLABLE = 0.01; /* of the volume of the water */

static const double WIDE = 0.05; /* H: gaps that are no matter yet */

static const double LEANING = 0.05; /* rad from the vertical */

static bool always(const struct bem_run *r) {
  (void)r;
  return true;
}

/* The water has not come to the right wall. */
static bool before_wall(const struct bem_run *r) {
  return r->flow.surface.right == BEM_END_BED;
}

static bool between_walls(const struct bem_run *r) {
  return !bem_surface_is_closed(&r->flow.surface);
}

static bool at_wall(const struct bem_run *r) {
  return !before_wall(r) && between_walls(r);
}

/* A face that was upright at the start, as that of a released column is, has leaned forward since.
 */
static bool rising_leaned(const struct bem_run *r) {
  return r->breaker[BEM_RISING].leaned;
}

static bool falling_leaned(const struct bem_run *r) {
  return r->breaker[BEM_FALLING].leaned;
}

static void place(const struct bem_surface *s, size_t k, double at[2]) {
  at[0] = s->state[k];
  at[1] = s->state[s->n + k];
}

static void at_first(const struct bem_run *r, double at[2]) {
  place(&r->flow.surface, 0, at);
}

static void at_last(const struct bem_run *r, double at[2]) {
  place(&r->flow.surface, r->flow.surface.n - 1, at);
}

/* The value at a fractional node, by the parabola through the three nearest nodes. */
static double value_at(const double *a, size_t n, double where) {
  size_t k = (size_t)(where + 0.5);
  if (k < 1 || k + 1 >= n) return a[k];
  double t = where - (double)k;
  return a[k] + 0.5 * t * (a[k + 1] - a[k - 1] + t * (a[k + 1] - 2 * a[k] + a[k - 1]));
}

/* The thin tip reaches the right wall. */
static double impact_value(const struct bem_run *r, const double *state) {
  return r->flow.surface.tank - state[r->flow.surface.n - 1];
}

static enum status record(struct bem_run *r, const struct bem_event *e, double x, double y) {
  return bem_output_event(&r->output, e->name, r->time, x, y);
}

/* A vertical tangent of a face. */
static double overturn_value(const struct bem_run *r, const double *state, enum bem_face face) {
  double where;
  return bem_breaker_tangent(&r->flow.surface, state, face, &where);
}

static double rising_value(const struct bem_run *r, const double *state) {
  return overturn_value(r, state, BEM_RISING);
}

static double falling_value(const struct bem_run *r, const double *state) {
  return overturn_value(r, state, BEM_FALLING);
}

static void overturn_place(const struct bem_run *r, enum bem_face face, double at[2]) {
  const struct bem_surface *s = &r->flow.surface;
  double where;
  bem_breaker_tangent(s, s->state, face, &where);
  where = bem_breaker_upright(s, s->state, where);
  for (int axis = 0; axis < 2; axis++)
    at[axis] = value_at(s->state + (size_t)axis * s->n, s->n, where);
}

static void rising_place(const struct bem_run *r, double at[2]) {
  overturn_place(r, BEM_RISING, at);
}

static void falling_place(const struct bem_run *r, double at[2]) {
  overturn_place(r, BEM_FALLING, at);
}

static enum status remember(struct bem_run *r, enum bem_face face, double x, double y) {
  r->breaker[face].overturned = true;
  r->breaker[face].time = r->time;
  r->breaker[face].x = x;
  r->breaker[face].y = y;
  return OK;
}

static enum status rising_act(struct bem_run *r, const struct bem_event *e, double x, double y) {
  (void)e;
  return remember(r, BEM_RISING, x, y);
}

static enum status falling_act(struct bem_run *r, const struct bem_event *e, double x, double y) {
  (void)e;
  return remember(r, BEM_FALLING, x, y);
}

/* The surface meets itself or a wall. */
static double contact_value(const struct bem_run *r, const double *state) {
  struct bem_near near;
  return bem_breaker_gap(&r->sides, &r->flow.surface, state, WIDE, &near);
}

static void contact_place(const struct bem_run *r, double at[2]) {
  const struct bem_surface *s = &r->flow.surface;
  struct bem_near near;
  bem_breaker_gap(&r->sides, s, s->state, WIDE, &near);
  at[0] = near.x;
  at[1] = near.y;
}

static enum status contact_act(struct bem_run *r, const struct bem_event *e, double x, double y) {
  const struct bem_surface *s = &r->flow.surface;
  struct bem_near near;
  bem_breaker_gap(&r->sides, s, s->state, WIDE, &near);
  const bool falls = bem_breaker_falls(s, s->state, &near);
  TRY(bem_output_event(&r->output, falls ? "touchdown" : e->name, r->time, x, y));
  return bem_run_end(r, x, y,
                     falls       ? "the jet touched down"
                     : near.wall ? "water struck a wall with air before it"
                                 : "the surface met itself",
                     "potential flow ends here");
}

static double over_value(const struct bem_run *r, const double *state, bool right) {
  const struct bem_surface *s = &r->flow.surface;
  const size_t k = right ? s->n - 1 : 0;
  if (!r->shore) return r->top[right] - state[s->n + k];
  if (!bem_shore_at_top(r->shore, right)) return 1;
  return bem_shore_way(r->shore, right, true, CMPLX(state[k], state[s->n + k]));
}

/* The surface on a wall passes its top. */
static double over_left_value(const struct bem_run *r, const double *state) {
  return over_value(r, state, false);
}

static double over_right_value(const struct bem_run *r, const double *state) {
  return over_value(r, state, true);
}

static enum status record_first(struct bem_run *r, const struct bem_event *e, double x, double y) {
  if (!r->overflowed) TRY(record(r, e, x, y));
  r->overflowed = true;
  return OK;
}

static const char RAISE[] =
    "the boundary solver has no water outside the tank: raise the wall, or take sph from there on";

static enum status end_over(struct bem_run *r, double x, double y, bool right) {
  char what[80];
  snprintf(what, sizeof what, "water passed the top of the %s wall",
           bem_output_side(&r->output, right));
  return bem_run_end(r, x, y, what, RAISE);
}

static enum status over_left_act(struct bem_run *r, const struct bem_event *e, double x, double y) {
  TRY(record_first(r, e, x, y));
  return end_over(r, x, y, false);
}

static enum status over_right_act(struct bem_run *r, const struct bem_event *e, double x,
                                  double y) {
  const struct bem_surface *s = &r->flow.surface;
  TRY(record_first(r, e, x, y));
  if (s->tip > 0 && !s->walls && bem_contact_thickness(s, r->top[1]) < SPILL &&
      r->output.spilled_volume < SPILLABLE * r->flow.level * s->tank)
    return bem_run_cut(r, &(struct bem_cut){.kind = BEM_CUT_TOP});
  return end_over(r, x, y, true);
}

/* The film beyond the right wall is thick enough: the surface is cut there. */
static double cut_value(const struct bem_run *r, const double *state) {
  return BEM_IMPACT - bem_contact_height(&r->flow.surface, state);
}

static enum status cut_act(struct bem_run *r, const struct bem_event *e, double x, double y) {
  (void)e, (void)x, (void)y;
  return bem_run_cut(r, &(struct bem_cut){.kind = BEM_CUT_AT_WALL});
}

static const struct bem_event all[] = {
    {"wall_impact", before_wall, impact_value, at_last, record},
    {"overturning", rising_leaned, rising_value, rising_place, rising_act},
    {"overturning", falling_leaned, falling_value, falling_place, falling_act},
    {"self_contact", always, contact_value, contact_place, contact_act},
    {"overflow", between_walls, over_left_value, at_first, over_left_act},
    {"overflow", at_wall, over_right_value, at_last, over_right_act},
    {"cut at the wall", before_wall, cut_value, at_last, cut_act},
};
enum { N = sizeof all / sizeof *all };

static void find_roots(void *run, double time, const double *state, double *root) {
  (void)time;
  const struct bem_run *r = run;
  for (int i = 0; i < N; i++) root[i] = all[i].armed(r) ? all[i].value(r, state) : 1;
}

const struct bem_roots bem_events_roots = {.n = N, .find = find_roots};

enum status bem_events_act(struct bem_run *r, const int *found) {
  for (int i = 0; i < N && !r->ended; i++) {
    if (!found[i]) continue;
    double at[2];
    all[i].where(r, at);
    TRY(all[i].act(r, &all[i], at[0], at[1]));
  }
  for (enum bem_face face = 0; face < BEM_FACES; face++)
    if (!r->breaker[face].leaned)
      r->breaker[face].leaned = overturn_value(r, r->flow.surface.state, face) > LEANING;
  return OK;
}

static enum status conclude_breaker(struct bem_run *r, enum bem_face face) {
  if (!r->breaker[face].overturned) return OK;
  return bem_output_event(&r->output, "overturning", r->breaker[face].time, r->breaker[face].x,
                          r->breaker[face].y);
}

static enum status conclude_runup(struct bem_run *r, bool right) {
  const struct bem_runup *u = &r->runup[right];
  if (!r->beach[right] || !bem_runup_found(u, r->start[right])) return OK;
  return bem_output_event(&r->output, "run_up", u->top[0], u->top[1], u->top[2]);
}

enum status bem_events_conclude(struct bem_run *r) {
  for (int right = 0; right < 2; right++) TRY(conclude_runup(r, right));
  const bool falling_first = r->breaker[BEM_FALLING].overturned &&
                             r->breaker[BEM_FALLING].time < r->breaker[BEM_RISING].time;
  TRY(conclude_breaker(r, falling_first ? BEM_FALLING : BEM_RISING));
  return conclude_breaker(r, falling_first ? BEM_RISING : BEM_FALLING);
}

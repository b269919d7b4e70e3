#include "bem/run/ending.h"

#include <math.h>
#include <stdio.h>

#include "bem/start/start.h"

static const double PANELS = 4; /* what is wider than so many panels is no trouble */

static void name_wall(const struct bem_run *r, size_t wall, char name[20]) {
  const struct bem_surface *s = &r->flow.surface;
  const bool right = wall + 1 == bem_sides_walls(s);
  double complex a, b;
  bem_sides_wall(s, wall, &a, &b);
  if (fabs(creal(b - a)) > fabs(cimag(b - a)))
    snprintf(name, 20, "the bed");
  else if (wall == 0 || right)
    snprintf(name, 20, "the %s wall", bem_output_side(&r->output, right));
  else
    snprintf(name, 20, "a wall");
}

/* The narrowest place in panels, across water or air. */
static bool narrowest(const struct bem_run *r, enum bem_between between, struct bem_near *least,
                      double *panels) {
  const struct bem_surface *s = &r->flow.surface;
  struct bem_near near;
  bool found = false;
  for (size_t k = 1; k + 1 < s->n; k++) {
    const double panel = 0.5 * (r->sides.arc[k + 1] - r->sides.arc[k - 1]);
    near.distance = HUGE_VAL;
    const double reach = *panels * panel;
    if (!(bem_sides_across(&r->sides, s, s->state, k, between, reach, &near) |
          bem_sides_wall_across(&r->sides, s, s->state, k, between, fmin(near.distance, reach),
                                &near)))
      continue;
    *panels = near.distance / panel;
    *least = near;
    found = true;
  }
  return found;
}

/* An edge of the water that has come to a bend towards it and cannot get round: where water shoots
 * over a brink its pressure would have to fall below that of the air, which gets behind it. */
static bool leaves_wall(const struct bem_surface *s, double *x, double *y) {
  const size_t last = s->n - 1;
  for (int right = 0; s->walls && right < 2; right++) {
    const size_t edge = right ? last : 0, inner = right ? last - 1 : 1;
    const double complex z = CMPLX(s->state[edge], s->state[s->n + edge]);
    const double panel = cabs(CMPLX(s->state[inner], s->state[s->n + inner]) - z);
    for (size_t k = 0; k < s->walls->n; k++) {
      const double complex bend = s->walls->point[k + 1];
      if (!(s->walls->power[k] > 0) || cabs(z - bend) > PANELS * panel) continue;
      *x = creal(bend);
      *y = cimag(bend);
      return true;
    }
  }
  return false;
}

/* H at the place, m or mm as it suits. */
static void describe(const struct bem_run *r, char what[200], double *x, double *y) {
  const struct bem_surface *s = &r->flow.surface;
  const double millimetre = 1000 * r->c->H;
  char wall[20] = "";
  struct bem_near near;
  double panels = PANELS;
  if (leaves_wall(s, x, y)) {
    snprintf(what, 200,
             "the water leaves the wall at a bend, with air behind it, and can no longer "
             "be followed");
    return;
  }
  bem_sides_set(&r->sides, s, s->state);
  bool water = narrowest(r, BEM_WATER, &near, &panels), air = narrowest(r, BEM_AIR, &near, &panels);
  if (!water && !air) {
    const struct bem_piece p = bem_cuts_find_wrinkle(&r->flow);
    snprintf(what, 200, "the surface has become rough and can no longer be followed");
    *x = p.x;
    *y = p.y;
    return;
  }
  *x = near.x;
  *y = near.y;
  if (near.wall) name_wall(r, near.panel, wall);
  snprintf(what, 200, "%s%s is %.2g mm %s and can no longer be followed",
           air         ? "the air between the surface and "
           : near.wall ? "the film on "
                       : "a sheet of water",
           near.wall ? wall
           : air     ? "itself"
                     : "",
           millimetre * near.distance, air ? "wide" : "thin");
}

enum status bem_ending_write(struct bem_run *r) {
  char what[200];
  double x, y;
  r->lost = true;
  describe(r, what, &x, &y);
  return bem_run_end(r, x, y, what,
                     bem_start_is_rounded(r->c)
                         ? "what was written before is valid: end the case there, or try another "
                           "resolution, film or rounding"
                         : "what was written before is valid: end the case there, or try another "
                           "resolution or film");
}

enum status bem_ending_spent(struct bem_run *r) {
  char why[300];
  r->ended = r->lost = true;
  snprintf(why, sizeof why,
           "the end of the case is still %.5g s away after %zu steps, at t = %.5g s (%.4f "
           "sqrt(H/g)); what was written before is valid: end the case there, or lower the "
           "resolution",
           r->c->end - r->time * r->output.time_scale, r->pace.steps,
           r->time * r->output.time_scale, r->time);
  return result_ended(r->output.file, why);
}

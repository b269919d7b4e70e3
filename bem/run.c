#include "bem/run.h"

#include <stdio.h>

#include "bem/contact.h"

enum status bem_run_restart(struct bem_run *r) {
  bem_pace_restarted(&r->pace);
  TRY(bem_sides_reserve(&r->sides, r->flow.surface.n));
  return bem_stepper_restart(r->stepper, r->time);
}

static enum status change_shape(struct bem_run *r, enum bem_cut cut) {
  switch (cut) {
  case BEM_CUT_AT_WALL:
    return bem_contact_meet_wall(&r->flow);
  case BEM_CUT_THIN_FILM:
    return bem_contact_cut_film(&r->flow, r->flow.surface.film);
  case BEM_CUT_TOP:
    return bem_contact_cut_top(&r->flow, r->top[1]);
  }
  return OK;
}

enum status bem_run_cut(struct bem_run *r, enum bem_cut cut) {
  struct bem_flow *f = &r->flow;
  TRY(bem_flow_solve(f, f->surface.state, 0));
  struct bem_totals before = bem_surface_totals(&f->surface, f->psi);
  TRY(change_shape(r, cut));
  TRY(bem_run_restart(r));
  TRY(bem_flow_solve(f, f->surface.state, 0));
  struct bem_totals after = bem_surface_totals(&f->surface, f->psi);
  r->output.removed_volume += before.volume - after.volume;
  r->output.removed_energy += before.kinetic + before.potential - after.kinetic - after.potential;
  if (cut == BEM_CUT_TOP) r->output.spilled_volume += before.volume - after.volume;
  return OK;
}

enum status bem_run_trim_film(struct bem_run *r) {
  const struct bem_surface *s = &r->flow.surface;
  if (s->tip == 0 || s->right == BEM_END_BED) return OK;
  if (bem_contact_crosses_wall(s)) return bem_run_cut(r, BEM_CUT_AT_WALL);
  return bem_contact_film_is_thin(s, r->flow.surface.film) ? bem_run_cut(r, BEM_CUT_THIN_FILM) : OK;
}

enum status bem_run_end(struct bem_run *r, double x, double y, const char *what, const char *then) {
  const struct case_file *c = r->c;
  char why[300];
  r->ended = true;
  snprintf(why, sizeof why, "%s at t = %.5g s (%.4f sqrt(H/g)), x = %.4g m, y = %.4g m; %s", what,
           r->time * r->output.time_scale, r->time, c->tank.min[0] + c->H * x,
           c->tank.min[1] + c->H * y, then);
  return result_ended(r->output.file, why);
}

#include "bem/run/run.h"

#include <math.h>
#include <stdio.h>

#include "bem/breaking/contact.h"
#include "bem/run/ending.h"

static const double FREE = 0.05;  /* sqrt(H/g): a run that went on so long got on */
static const double THICKEST = 4; /* of a film that is cut for a rescue, in usual ones */
enum {
  MOST_CUTS = 20, /* at once */
  MOST_RESCUES = 12
};

enum status bem_run_restart(struct bem_run *r) {
  struct bem_surface *s = &r->flow.surface;
  bem_pace_restarted(&r->pace);
  for (int right = 0; s->walls && right < 2; right++)
    s->blunt[right] = bem_sides_is_blunt(s, right);
  TRY(bem_sides_reserve(&r->sides, s));
  return bem_stepper_restart(r->stepper, r->time);
}

static enum status change_shape(struct bem_run *r, const struct bem_cut *cut) {
  switch (cut->kind) {
  case BEM_CUT_AT_WALL:
    return bem_contact_meet_wall(&r->flow);
  case BEM_CUT_THIN_FILM:
    return bem_contact_cut_film(&r->flow, cut->right, cut->coarse);
  case BEM_CUT_TONGUE:
    return bem_contact_cut_tongue(&r->flow, cut->right);
  case BEM_CUT_TOP:
    return bem_contact_cut_top(&r->flow, r->top[1]);
  case BEM_CUT_SHEET:
    return bem_cuts_sheet(&r->flow, &cut->piece);
  case BEM_CUT_LOOP:
    return bem_cuts_loop(&r->flow, &cut->piece);
  case BEM_CUT_WRINKLE:
    return bem_cuts_wrinkle(&r->flow, &cut->piece);
  }
  return OK;
}

/* Where it is: of a film, where its new end meets the wall. */
static enum status record_cut(struct bem_run *r, const struct bem_cut *cut) {
  const struct bem_surface *s = &r->flow.surface;
  const bool film = cut->kind <= BEM_CUT_TOP;
  const bool left = (cut->kind == BEM_CUT_THIN_FILM || cut->kind == BEM_CUT_TONGUE) && !cut->right;
  const size_t end = left ? 0 : s->n - 1;
  return bem_output_event(&r->output, cut->kind == BEM_CUT_WRINKLE ? "smoothed" : "cut", r->time,
                          film ? s->state[end] : cut->piece.x,
                          film ? s->state[s->n + end] : cut->piece.y);
}

/* Before and after the shape of the water is changed. */
static enum status measure(struct bem_flow *f, struct bem_totals *t) {
  TRY(bem_flow_solve(f, f->surface.state, 0));
  *t = bem_surface_totals(&f->surface, f->psi);
  return OK;
}

/* Where the flow cannot be solved for before the cut, since its nodes are beyond the wall, the
 * little water that goes is taken to have no kinetic energy. */
static enum status measure_before(struct bem_flow *f, const struct bem_cut *cut,
                                  struct bem_totals *t) {
  const enum status status = measure(f, t);
  if (status != ERR_SOLVER || cut->kind != BEM_CUT_TONGUE) return status;
  *t = bem_surface_totals(&f->surface, f->psi);
  t->kinetic = NAN;
  return OK;
}

/* Starts afresh and books what has gone since; *volume: of that, H^2. */
static enum status book(struct bem_run *r, const struct bem_totals *before, double *volume) {
  struct bem_totals after;
  TRY(bem_run_restart(r));
  for (int right = 0; right < 2; right++) bem_runup_moved(&r->runup[right]);
  TRY(measure(&r->flow, &after));
  *volume = before->volume - after.volume;
  const double kinetic = isnan(before->kinetic) ? after.kinetic : before->kinetic;
  bem_budget_cut(&r->output.budget, *volume,
                 kinetic + before->potential - after.kinetic - after.potential);
  return OK;
}

enum status bem_run_cut(struct bem_run *r, const struct bem_cut *cut) {
  struct bem_totals before;
  double volume;
  TRY(measure_before(&r->flow, cut, &before));
  r->flow.surface.smooth = false;
  TRY(change_shape(r, cut));
  TRY(book(r, &before, &volume));
  if (cut->kind == BEM_CUT_TOP) r->output.spilled_volume += volume;
  return record_cut(r, cut);
}

/* Of a dam break, which met the wall as a sheet. */
static bool sheet_on_wall(const struct bem_surface *s) {
  return s->tip > 0 && !s->walls && s->right == BEM_END_WALL;
}

static bool find_film(const struct bem_surface *s, double coarse, struct bem_cut *cut) {
  cut->kind = BEM_CUT_THIN_FILM;
  cut->coarse = coarse = fmin(coarse, THICKEST);
  for (int right = 1; right >= 0; right--) {
    cut->right = right;
    if (right && s->right == BEM_END_BED) continue;
    if (bem_contact_film_is_thin(s, right, coarse)) return true;
  }
  return false;
}

/* Only where the run does not get on: a tongue is mostly taken in again. */
static bool find_tongue(const struct bem_surface *s, struct bem_cut *cut) {
  cut->kind = BEM_CUT_TONGUE;
  for (int right = 1; right >= 0; right--) {
    cut->right = right;
    if (bem_contact_tongue(s, right)) return true;
  }
  return false;
}

/* coarse: see bem_cuts_find_sheet. */
static bool find_cut(const struct bem_run *r, double coarse, struct bem_cut *cut) {
  const struct bem_surface *s = &r->flow.surface;
  if (sheet_on_wall(s) && bem_contact_crosses_wall(s)) {
    cut->kind = BEM_CUT_AT_WALL;
    return true;
  }
  if (coarse > 1 && find_tongue(s, cut)) return true;
  if (find_film(s, coarse, cut)) return true;
  bem_sides_set(&r->sides, s, s->state);
  cut->kind = BEM_CUT_LOOP;
  if (bem_cuts_find_loop(&r->sides, s, &cut->piece)) return true;
  cut->kind = BEM_CUT_SHEET;
  return bem_cuts_find_sheet(&r->sides, s, coarse, &cut->piece);
}

static enum status trim(struct bem_run *r, double coarse, int *cuts) {
  struct bem_cut cut;
  for (*cuts = 0; *cuts < MOST_CUTS && find_cut(r, coarse, &cut); ++*cuts)
    TRY(bem_run_cut(r, &cut));
  return OK;
}

enum status bem_run_trim(struct bem_run *r) {
  int cuts;
  return trim(r, 1, &cuts);
}

enum status bem_run_rescue(struct bem_run *r) {
  int cuts;
  if (r->time > r->rescued + FREE) r->rescues = 0;
  r->rescued = r->time;
  TRY(bem_run_restart(r)); /* the surface may be another one since */
  if (r->rescues++ == MOST_RESCUES) return bem_ending_write(r);
  TRY(trim(r, pow(2, r->rescues), &cuts));
  if (cuts) return OK;
  TRY(bem_flow_solve(&r->flow, r->flow.surface.state, 0));
  const struct bem_cut wrinkle = {.kind = BEM_CUT_WRINKLE,
                                  .piece = bem_cuts_find_wrinkle(&r->flow)};
  return bem_run_cut(r, &wrinkle);
}

static enum status pass(struct bem_run *r, bool right, int way) {
  const struct bem_surface *s = &r->flow.surface;
  struct bem_totals before;
  double volume;
  TRY(measure(&r->flow, &before));
  TRY(bem_shore_pass(r->shore, &r->flow, right, way));
  TRY(book(r, &before, &volume));
  const size_t edge = right ? s->n - 1 : 0;
  return bem_output_event(&r->output, "bend", r->time, s->state[edge], s->state[s->n + edge]);
}

enum status bem_run_pass_bends(struct bem_run *r) {
  for (int right = 0; r->shore && right < 2; right++) {
    const int way = bem_shore_arrives(r->shore, &r->flow.surface, right);
    if (way != 0) TRY(pass(r, right, way));
  }
  return OK;
}

enum status bem_run_end(struct bem_run *r, double x, double y, const char *what, const char *then) {
  double at[2];
  char why[300];
  r->ended = true;
  bem_output_place(&r->output, x, y, at);
  snprintf(why, sizeof why, "%s at t = %.5g s (%.4f sqrt(H/g)), x = %.4g m, y = %.4g m; %s", what,
           r->time * r->output.time_scale, r->time, at[0], at[1], then);
  return result_ended(r->output.file, why);
}

/* The run: step, write what is due, act on what CVODE's root finding reports, and start afresh when
 * the mesh or the shape of the water has changed. Lengths are in H, times in sqrt(H/g), rho = 1. */
#include "bem/solver.h"

#include <math.h>
#include <stddef.h>

#include "bem/contact.h"
#include "bem/estimate.h"
#include "bem/events.h"
#include "bem/options.h"
#include "bem/output.h"
#include "bem/pace.h"
#include "bem/start.h"

#define KEY(member) .offset = offsetof(struct bem_options, member)
static const struct param params[] = {
    {.key = "tolerance",
     .type = PARAM_REAL,
     .quantity = QTY_NUMBER,
     KEY(tolerance),
     .min = 1e-12,
     .max = 1e-3,
     .value = "1e-6",
     .help =
         "absolute tolerance of CVODE relative to H; for a wave, to a thousandth of its amplitude"},
    {.key = "gmres",
     .type = PARAM_REAL,
     .quantity = QTY_NUMBER,
     KEY(gmres),
     .min = 1e-14,
     .max = 1e-4,
     .value = "1e-8",
     .help = "residual at which GMRES stops, relative to the right-hand side"},
    {.key = "dense",
     .type = PARAM_INT,
     KEY(dense),
     .min = 0,
     .max = 2000,
     .value = "128",
     .help = "surfaces of up to so many nodes are solved by dense factorisation (LAPACK) instead"},
    {.key = "film",
     .type = PARAM_REAL,
     .quantity = QTY_LENGTH,
     KEY(film),
     .min = 0,
     .max = HUGE_VAL,
     .value = "0.005 H",
     .help = "the film on the wall is cut where it is thinner than this"},
    {.key = "filter",
     .type = PARAM_REAL,
     .quantity = QTY_NUMBER,
     KEY(filter),
     .min = 0,
     .max = 100,
     .value = "30",
     .help = "rate, in 1/sqrt(H/g), of the sixth-difference filter against the sawtooth of two "
             "spacings; a thirtieth of it for waves, which have no thin sheet"},
    {.key = "smoothing",
     .type = PARAM_REAL,
     .quantity = QTY_NUMBER,
     KEY(smoothing),
     .min = 0,
     .max = 200,
     .value = "30",
     .help =
         "rate, in 1/sqrt(H/g), of the five-point formula at a thin tip (Longuet-Higgins & Cokelet "
         "1976)"},
};

/* What passes the top of the right wall is cut there and counted while it is a film thinner than
 * SPILL and little: a thicker jet is not free of pressure, and the film is qualitative anyway; more
 * than that ends the run. */
static const double SPILL = 0.05;     /* H */
static const double SPILLABLE = 0.01; /* of the volume of the water */
static const double GENTLE = 1. / 30; /* of the filter's rate is enough where no thin sheet is */
static const double SHOWN = 1e-6;     /* residual that is enough for outputs */
enum { MOST_STEPS = 1000000 };

enum cut { CUT_AT_WALL, CUT_THIN_FILM, CUT_TOP };

struct run {
  struct bem_flow flow;
  struct bem_output output;
  struct bem_events events;
  struct bem_stepper *stepper;
  struct bem_pace pace;
  const struct case_file *c;
  double film; /* H */
  double time, dt;
  struct {
    double time, x, y;
  } overturn; /* the latest tangent that became vertical: the breaker's if it overturns */
  bool overflowed, ended;
};

static enum status restart(struct run *r) {
  bem_pace_restarted(&r->pace);
  return bem_stepper_restart(r->stepper, r->time);
}

static enum status change_shape(struct run *r, enum cut cut) {
  switch (cut) {
  case CUT_AT_WALL:
    return bem_contact_meet_wall(&r->flow);
  case CUT_THIN_FILM:
    return bem_contact_cut_film(&r->flow, r->film);
  case CUT_TOP:
    return bem_contact_cut_top(&r->flow, r->events.top[1]);
  }
  return OK;
}

/* Takes water away and books it. */
static enum status cut(struct run *r, enum cut cut) {
  struct bem_flow *f = &r->flow;
  TRY(bem_flow_solve(f, f->surface.state, 0));
  struct bem_totals before = bem_surface_totals(&f->surface, f->psi);
  TRY(change_shape(r, cut));
  TRY(restart(r));
  TRY(bem_flow_solve(f, f->surface.state, 0));
  struct bem_totals after = bem_surface_totals(&f->surface, f->psi);
  r->output.removed_volume += before.volume - after.volume;
  r->output.removed_energy += before.kinetic + before.potential - after.kinetic - after.potential;
  if (cut == CUT_TOP) r->output.spilled_volume += before.volume - after.volume;
  return OK;
}

/* The run goes no further than this event at (x, y), H. */
static enum status end_here(struct run *r, double x, double y, const char *what, const char *then) {
  const struct case_file *c = r->c;
  char why[300];
  r->ended = true;
  snprintf(why, sizeof why, "%s at t = %.5g s (%.4f sqrt(H/g)), x = %.4g m, y = %.4g m; %s", what,
           r->time * r->output.time_scale, r->time, c->tank.min[0] + c->H * x,
           c->tank.min[1] + c->H * y, then);
  return result_ended(r->output.file, why);
}

static enum status overflow(struct run *r, enum bem_event event) {
  const struct bem_surface *s = &r->flow.surface;
  const bool right = event == BEM_EVENT_OVER_RIGHT;
  double x, y;
  bem_events_place(&r->events, event, s->state, &x, &y);
  if (!r->overflowed) TRY(bem_output_event(&r->output, "overflow", r->time, x, y));
  r->overflowed = true;
  if (right && s->tip > 0 && bem_contact_thickness(s, r->events.top[1]) < SPILL &&
      r->output.spilled_volume < SPILLABLE * r->flow.level * s->tank)
    return cut(r, CUT_TOP);
  return end_here(r, x, y,
                  right ? "water passed the top of the right wall"
                        : "water passed the top of the left wall",
                  "the boundary solver has no water outside the tank: raise the wall, or take sph "
                  "from there on");
}

/* Events that end the run. */
static enum status act_on_end(struct run *r, const int found[BEM_ROOTS]) {
  double x, y;
  for (enum bem_event e = BEM_EVENT_OVER_LEFT; e <= BEM_EVENT_OVER_RIGHT; e++)
    if (found[e]) return overflow(r, e);
  if (!found[BEM_EVENT_TOUCHDOWN]) return OK;
  bem_events_place(&r->events, BEM_EVENT_TOUCHDOWN, r->flow.surface.state, &x, &y);
  TRY(bem_output_event(&r->output, "touchdown", r->time, x, y));
  return end_here(r, x, y, "the jet touched down", "potential flow ends here");
}

static enum status act(struct run *r, const int found[BEM_ROOTS]) {
  struct bem_flow *f = &r->flow;
  struct bem_surface *s = &f->surface;
  double x, y;
  if (found[BEM_EVENT_IMPACT]) {
    bem_events_place(&r->events, BEM_EVENT_IMPACT, s->state, &x, &y);
    TRY(bem_output_event(&r->output, "wall_impact", r->time, x, y));
  }
  if (found[BEM_EVENT_OVERTURN]) {
    bem_events_place(&r->events, BEM_EVENT_OVERTURN, s->state, &r->overturn.x, &r->overturn.y);
    r->overturn.time = r->time;
    r->events.overturned = true;
  }
  TRY(act_on_end(r, found));
  if (r->ended) return OK;
  bool on_wall = s->tip > 0 && s->right == BEM_END_WALL;
  if (found[BEM_EVENT_WALL] || (on_wall && bem_contact_crosses_wall(s))) return cut(r, CUT_AT_WALL);
  if (on_wall && bem_contact_film_is_thin(s, r->film)) return cut(r, CUT_THIN_FILM);
  if (bem_mesh_is_poor(&f->mesh, s)) {
    TRY(bem_mesh_regrid(&f->mesh, s));
    return restart(r);
  }
  return OK;
}

static enum status advance(struct run *r, struct progress *progress) {
  double end = r->c->end / r->output.time_scale, work = 0;
  int found[BEM_ROOTS];
  for (size_t step = 1; r->time < end && !r->ended; step++) {
    TRY(bem_stepper_step(r->stepper, &r->time, &r->dt, found));
    TRY(bem_pace_add(&r->pace, r->time, r->dt));
    bem_output_damped(&r->output, &r->flow, r->time, r->dt);
    TRY(bem_output_due(&r->output, &r->flow, r->stepper, &r->events, r->time, r->dt));
    work += (double)r->flow.surface.n;
    progress_step(progress, step, r->time * r->output.time_scale, r->dt * r->output.time_scale,
                  work, "node", r->output.drift);
    if (progress_stop_requested()) return status_raise(INTERRUPTED, "stopped");
    if (r->time > end) break; /* what the last step found lies beyond the case */
    TRY(act(r, found));
    CHECK(!bem_pace_is_lost(&r->pace, r->time) && step < MOST_STEPS, ERR_SOLVER,
          "the surface has become too rough to be followed (the time step has fallen to %.2g s); "
          "what was written before is valid: end the case there, or try another resolution or film",
          r->dt * r->output.time_scale);
  }
  return OK;
}

/* Says when and where a run failed: where two nodes are closest, the step is shortest. */
static enum status locate(const struct run *r, enum status status) {
  const struct case_file *c = r->c;
  const struct bem_surface *s = &r->flow.surface;
  const double *x = s->state, *y = x + s->n;
  size_t at = 0;
  double least = HUGE_VAL;
  for (size_t k = 0; s->state && k + 1 < s->n; k++) {
    double l = hypot(x[k + 1] - x[k], y[k + 1] - y[k]);
    if (l < least) least = l, at = k;
  }
  if (least == HUGE_VAL || status == INTERRUPTED || status == ERR_IO)
    return status_context(
        status, "at t = %.6g s (%.5g sqrt(H/g)): ", r->time * r->output.time_scale, r->time);
  return status_context(
      status, "at t = %.6g s (%.5g sqrt(H/g)), on the %s near (%.4g, %.4g) m, nodes %.2g m apart: ",
      r->time * r->output.time_scale, r->time,
      bem_surface_importance(s, x[at], y[at]) < 0.5 ? "film up the right wall" : "surface",
      c->tank.min[0] + c->H * x[at], c->tank.min[1] + c->H * y[at], c->H * least);
}

/* What is known at the end, however the run ended; returns its status and keeps its message. */
static enum status conclude(struct run *r, enum status status) {
  char why[1024];
  snprintf(why, sizeof why, "%s", status_message());
  enum status written = OK;
  if (r->events.overturned && (status == OK || status == INTERRUPTED))
    written =
        bem_output_event(&r->output, "overturning", r->overturn.time, r->overturn.x, r->overturn.y);
  if (written == OK)
    written = bem_output_statistics(&r->output, &r->flow, r->stepper, bem_pace_cut(&r->pace));
  return status == OK ? written : status_raise(status, "%s", why);
}

/* Heights of the tops of the walls above the bed, H. */
static void find_tops(const struct case_file *c, double top[2]) {
  top[0] = (c->walls.p[0][1] - c->tank.min[1]) / c->H;
  top[1] = (c->walls.p[c->walls.points - 1][1] - c->tank.min[1]) / c->H;
}

static enum status begin(struct run *r, const struct case_run *cr) {
  const struct case_file *c = r->c;
  const struct bem_options *o = cr->options;
  const bool wave = c->wave.kind != CASE_WAVE_NONE;
  struct bem_solve_options solve = {.tolerance = o->gmres, .dense_up_to = (size_t)o->dense};
  double tolerance = o->tolerance * (wave ? 1e-3 * fabs(c->wave.amplitude) / c->H : 1);
  if (!(tolerance > 1e-14)) tolerance = 1e-14; /* rounding; still water has amplitude 0 */
  TRY(bem_solve_create(&solve, &r->flow.solve));
  solve.tolerance = fmax(solve.tolerance, SHOWN);
  TRY(bem_output_create(&r->output, &solve));
  TRY(bem_start_surface(c, cr, &r->flow));
  r->flow.filter = o->filter * (r->flow.surface.tip > 0 ? 1 : GENTLE);
  r->flow.smoothing = o->smoothing;
  TRY(bem_stepper_create(&r->flow, tolerance, bem_events_roots, &r->events, &r->stepper));
  TRY(restart(r));
  return bem_output_due(&r->output, &r->flow, NULL, &r->events, 0, 0);
}

static enum status run(const struct case_file *c, const struct case_run *cr, struct result *out,
                       struct progress *progress) {
  const struct bem_options *o = cr->options;
  struct run r = {.c = c,
                  .film = o->film / c->H,
                  .output = {.c = c,
                             .file = out,
                             .start = progress_wall_clock(),
                             .time_scale = sqrt(c->H / c->gravity)}};
  r.events = (struct bem_events){.surface = &r.flow.surface, .thickness = BEM_IMPACT};
  find_tops(c, r.events.top);
  enum status status = begin(&r, cr);
  if (status == OK) {
    status = advance(&r, progress);
    if (status != OK) status = locate(&r, status);
    status = conclude(&r, status);
  }
  bem_output_destroy(&r.output);
  bem_pace_destroy(&r.pace);
  bem_stepper_destroy(r.stepper);
  bem_flow_destroy(&r.flow);
  return status;
}

const struct solver bem_solver = {
    .name = "bem",
    .help = "fully nonlinear potential flow by boundary elements, to the touchdown of the breaker",
    .params = params,
    .n_params = sizeof params / sizeof *params,
    .options_size = sizeof(struct bem_options),
    .check = bem_start_check,
    .estimate = bem_estimate,
    .run = run,
};

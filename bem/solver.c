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
#include "bem/start.h"

#define KEY(member) .offset = offsetof(struct bem_options, member)
static const struct param params[] = {
    {.key = "tolerance",
     .type = PARAM_REAL,
     .quantity = QTY_NUMBER,
     KEY(tolerance),
     .min = 1e-12,
     .max = 1e-3,
     .value = "1e-5",
     .help =
         "absolute tolerance of CVODE relative to H; for a wave, to a thousandth of its amplitude"},
    {.key = "gmres",
     .type = PARAM_REAL,
     .quantity = QTY_NUMBER,
     KEY(gmres),
     .min = 1e-14,
     .max = 1e-4,
     .value = "1e-9",
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
             "spacings; "
             "waves that span the tank go without it"},
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

static const double IMPACT = 0.01;   /* H, thickness of the film when it is cut at the wall */
static const double SHORTEST = 1e-9; /* sqrt(H/g), steps that lead nowhere */
enum { PATIENCE = 50, MOST_STEPS = 1000000 };

struct run {
  struct bem_flow flow;
  struct bem_output output;
  struct bem_events events;
  struct bem_stepper *stepper;
  double film; /* H */
  double time, dt;
  struct {
    double time, x, y;
  } overturn; /* the latest tangent that became vertical: the breaker's if it overturns */
  bool touched;
};

/* Changes the shape of the water by `cut` and books what that took away. */
static enum status cut(struct run *r, bool at_wall) {
  struct bem_flow *f = &r->flow;
  TRY(bem_flow_solve(f, f->surface.state, 0));
  struct bem_totals before = bem_surface_totals(&f->surface, f->psi);
  TRY(at_wall ? bem_contact_meet_wall(f) : bem_contact_cut_film(f, r->film));
  TRY(bem_stepper_restart(r->stepper, r->time));
  TRY(bem_flow_solve(f, f->surface.state, 0));
  struct bem_totals after = bem_surface_totals(&f->surface, f->psi);
  r->output.removed_volume += before.volume - after.volume;
  r->output.removed_energy += before.kinetic + before.potential - after.kinetic - after.potential;
  return OK;
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
  if (found[BEM_EVENT_TOUCHDOWN]) {
    bem_events_place(&r->events, BEM_EVENT_TOUCHDOWN, s->state, &x, &y);
    TRY(bem_output_event(&r->output, "touchdown", r->time, x, y));
    r->touched = true;
    return OK;
  }
  bool on_wall = s->tip > 0 && s->right == BEM_END_WALL;
  if (found[BEM_EVENT_WALL] || (on_wall && bem_contact_crosses_wall(s))) return cut(r, true);
  if (on_wall && bem_contact_film_is_thin(s, r->film)) return cut(r, false);
  if (bem_mesh_is_poor(&f->mesh, s)) {
    TRY(bem_mesh_regrid(&f->mesh, s));
    return bem_stepper_restart(r->stepper, r->time);
  }
  return OK;
}

static enum status advance(struct run *r, const struct case_file *c, struct progress *progress) {
  double end = c->end / r->output.time_scale, work = 0;
  int found[BEM_ROOTS], short_steps = 0;
  for (size_t step = 1; r->time < end && !r->touched; step++) {
    TRY(bem_stepper_step(r->stepper, &r->time, &r->dt, found));
    short_steps = r->dt < SHORTEST ? short_steps + 1 : 0;
    CHECK(short_steps < PATIENCE && step < MOST_STEPS, ERR_SOLVER,
          "the time step has fallen to %.2g sqrt(H/g)", r->dt);
    TRY(bem_output_due(&r->output, &r->flow, r->stepper, &r->events, r->time, r->dt));
    work += (double)r->flow.surface.n;
    progress_step(progress, step, r->time * r->output.time_scale, r->dt * r->output.time_scale,
                  work, "node", r->output.drift);
    if (progress_stop_requested()) return status_raise(INTERRUPTED, "stopped");
    TRY(act(r, found));
  }
  return OK;
}

static enum status run(const struct case_file *c, const struct case_run *cr, struct result *out,
                       struct progress *progress) {
  const struct bem_options *o = cr->options;
  enum status status = OK;
  struct run r = {.film = o->film / c->H,
                  .output = {.c = c,
                             .file = out,
                             .start = progress_wall_clock(),
                             .time_scale = sqrt(c->H / c->gravity)}};
  struct bem_solve_options solve = {.tolerance = o->gmres, .dense_up_to = (size_t)o->dense};
  double tolerance = o->tolerance;
  if (c->wave.kind != CASE_WAVE_NONE) tolerance *= 1e-3 * fabs(c->wave.amplitude) / c->H;
  if (!(tolerance > 1e-14)) tolerance = 1e-14; /* rounding; still water has amplitude 0 */
  r.events = (struct bem_events){.surface = &r.flow.surface, .thickness = IMPACT};
  ATTEMPT(bem_solve_create(&solve, &r.flow.solve));
  ATTEMPT(bem_output_create(&r.output, &solve));
  ATTEMPT(bem_start_surface(c, cr, &r.flow));
  if (r.flow.surface.tip > 0) {
    r.flow.filter = o->filter;
    r.flow.smoothing = o->smoothing;
  }
  ATTEMPT(bem_stepper_create(&r.flow, tolerance, bem_events_roots, &r.events, &r.stepper));
  ATTEMPT(bem_stepper_restart(r.stepper, 0));
  ATTEMPT(bem_output_due(&r.output, &r.flow, NULL, &r.events, 0, 0));
  status = advance(&r, c, progress);
  if (status != OK)
    status_context(status, "at t = %.6g s (%.5g sqrt(H/g)): ", r.time * r.output.time_scale,
                   r.time);
  if (r.events.overturned && (status == OK || status == INTERRUPTED)) {
    enum status written =
        bem_output_event(&r.output, "overturning", r.overturn.time, r.overturn.x, r.overturn.y);
    if (status == OK) status = written;
  }
  if (status == OK) status = bem_output_statistics(&r.output, &r.flow, r.stepper);
done:
  bem_output_destroy(&r.output);
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

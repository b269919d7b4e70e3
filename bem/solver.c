/* The run: step, write what is due, act on what CVODE's root finding reports, and start afresh when
 * the mesh or the shape of the water has changed. Lengths are in H, times in sqrt(H/g), rho = 1. */
#include "bem/solver.h"

#include <math.h>
#include <stddef.h>

#include "bem/accuracy.h"
#include "bem/estimate.h"
#include "bem/options.h"
#include "bem/run/ending.h"
#include "bem/run/events.h"
#include "bem/run/run.h"
#include "bem/shape/smooth.h"
#include "bem/start/basin.h"
#include "bem/start/mirror.h"
#include "bem/start/start.h"
#include "bem/water/forces.h"
#include "common/flow/flow.h"
#include "common/tank/tank.h"

#define KEY(member) .offset = offsetof(struct bem_options, member)
static const struct param params[] = {
    {.key = "accuracy",
     .type = PARAM_REAL,
     .quantity = QTY_NUMBER,
     KEY(accuracy),
     .min = 1e-6,
     .max = 1e-2,
     .value = "",
     .help = "mean error of the surface that is aimed at, of H or, for a wave, of its amplitude; "
             "sets resolution, tolerance and gmres where they are not given, and what filter and "
             "smoothing take falls with the spacing"},
    {.key = "error_bars",
     .type = PARAM_BOOL,
     KEY(error_bars),
     .value = "false",
     .help = "run a coarser run first (spacings 1.5 times as wide, tolerances, film and filters "
             "coarser too), from which events, surfaces, energies and series get standard errors"},
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
    {.key = "rounding",
     .type = PARAM_REAL,
     .quantity = QTY_LENGTH,
     KEY(rounding),
     .min = PARAM_ABOVE_0,
     .max = HUGE_VAL,
     .value = "0.02 H",
     .help =
         "radius of the arcs that kinks of the water's outline at t = 0 become, but for the top "
         "of a column; smaller where the sides beside one are short"},
    {.key = "filter",
     .type = PARAM_REAL,
     .quantity = QTY_NUMBER,
     KEY(filter),
     .min = 0,
     .max = 100,
     .value = "30",
     .help = "rate, in 1/sqrt(H/g), of the sixth-difference filter against the sawtooth of two "
             "spacings (of sixteenth differences where the surface is smooth), which every flow "
             "has; of waves a thirtieth of it, in units of their own "
             "angular frequency by linear theory"},
    {.key = "velocity_lattice",
     .type = PARAM_REAL,
     .quantity = QTY_LENGTH,
     KEY(lattice),
     .min = 0,
     .max = HUGE_VAL,
     .value = "0",
     .help = "spacing of a lattice of points inside the water at which velocity, potential and "
             "pressure are written at each output; 0: none"},
    {.key = "forces",
     .type = PARAM_BOOL,
     KEY(forces),
     .value = "false",
     .help = "write the forces on the walls, their moment, and the water's momentum as "
             "/series/diagnostics"},
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

/* Of the filter's rate is enough where no thin sheet is: standing waves with ka = 0.01 to 0.1 live
 * on for a hundred periods with one per radian (tests/bem/verify_standing_waves.c). */
static const double GENTLE = 1. / 30;
static const double SHOWN = 1e-6;   /* residual that is enough for outputs */
static const double UPRIGHT = 1e-6; /* cosine of a wall's slope: less is rounding */

/* For the rest of the run: what has broken is not smooth again. */
static enum status leave_smooth(struct bem_run *r) {
  r->flow.surface.smooth = false;
  return bem_run_restart(r);
}

/* After a step: events, then what is too thin, then the spacing of the nodes. */
static enum status act(struct bem_run *r, const int *found) {
  TRY(bem_events_act(r, found));
  if (r->ended) return OK;
  TRY(bem_run_trim(r));
  TRY(bem_run_pass_bends(r));
  if (r->flow.surface.smooth && !bem_smooth_is(&r->flow.surface)) return leave_smooth(r);
  if (!bem_mesh_is_poor(&r->flow.mesh, &r->flow.surface)) return OK;
  TRY(bem_mesh_regrid(&r->flow.mesh, &r->flow.surface));
  return bem_run_restart(r);
}

/* After a step or a cut failed. Only trouble of the flow can be helped; where help fails, it is
 * asked for again until the run ends in a sentence. */
static enum status rescue(struct bem_run *r, enum status status) {
  while (status == ERR_SOLVER || status == ERR_DIVERGED) status = bem_run_rescue(r);
  return status;
}

/* What the energy of a step says. At an event psi is not of the state, which lies within the step;
 * near a contact it is wrong. The budget leaves out some of what moves with a tank or its sides. */
enum verdict { SOUND, AWAY, LOST };
static enum verdict judge(struct bem_run *r, const int *found) {
  const struct bem_budget *b = &r->output.budget;
  const struct bem_motion *m = &r->flow.motion;
  for (int i = 0; i < bem_events_roots.n; i++)
    if (found[i]) return SOUND;
  const double whole = bem_budget_whole(b, &r->flow, r->time);
  const bool away = bem_pace_runs_away(&r->pace, r->time, whole, b->first_energy),
             lost = !m->frame && !m->sides && bem_budget_is_lost(b, whole);
  if ((!away && !lost) || bem_output_touches(&r->sides, &r->flow.surface)) return SOUND;
  return lost ? LOST : AWAY;
}

/* Steps shrink with the gap before a contact, which is near then. */
static bool is_lost(struct bem_run *r) {
  return bem_pace_is_lost(&r->pace, r->time) &&
         (bem_pace_leads_nowhere(&r->pace) || !bem_output_touches(&r->sides, &r->flow.surface));
}

static bool on_slope(const struct bem_surface *s, bool right) {
  double complex a, b;
  bem_sides_wall(s, bem_sides_held(s, right), &a, &b);
  return fabs(creal(b - a)) > UPRIGHT * cabs(b - a);
}

/* Of sides that are beaches: what comes to one that is upright is a matter of gauges. */
static void follow_edges(struct bem_run *r) {
  const struct bem_surface *s = &r->flow.surface;
  for (int right = 0; r->shore && right < 2; right++) {
    const size_t k = right ? s->n - 1 : 0;
    r->beach[right] |= on_slope(s, right);
    bem_runup_add(&r->runup[right], r->time, s->state[k], s->state[s->n + k]);
  }
}

/* What is due in the step that was made. */
static enum status put_out(struct bem_run *r, struct progress *progress, size_t step, double work) {
  TRY(bem_pace_add(&r->pace, r->time, r->dt));
  follow_edges(r);
  bem_budget_damped(&r->output.budget, &r->flow, r->time, r->dt);
  TRY(bem_output_given(&r->output, &r->flow, r->stepper, r->time, r->dt));
  TRY(bem_output_due(&r->output, &r->flow, r->stepper, r->time, r->dt));
  progress_step(progress, step, r->time * r->output.time_scale, r->dt * r->output.time_scale, work,
                "node", r->output.budget.drift);
  return progress_stop_requested() ? status_raise(INTERRUPTED, "stopped") : OK;
}

/* What the last step found beyond the end of the case is none of its business. */
static enum status step_on(struct bem_run *r, struct progress *progress, size_t step, double end,
                           double *work) {
  const int *found;
  TRY(bem_stepper_step(r->stepper, &r->time, &r->dt, &found));
  *work += (double)r->flow.surface.n;
  TRY(put_out(r, progress, step, *work));
  if (r->time > end) return OK;
  const enum verdict verdict = judge(r, found);
  if (verdict == LOST) return bem_ending_write(r);
  TRY(act(r, found));
  const bool helped = r->pace.since == 0;
  if (!r->ended && (is_lost(r) || (verdict == AWAY && !helped))) TRY(bem_run_rescue(r));
  return OK;
}

static enum status advance(struct bem_run *r, struct progress *progress) {
  double end = r->c->end / r->output.time_scale, work = 0;
  for (size_t step = 1; r->time < end && !r->ended; step++) {
    TRY(rescue(r, step_on(r, progress, step, end, &work)));
    if (!r->ended && bem_pace_is_spent(&r->pace)) TRY(bem_ending_spent(r));
  }
  return OK;
}

/* Says when a run failed; what the flow is to blame for, its sentence says. */
static enum status date(const struct bem_run *r, enum status status) {
  return status_context(status, "at t = %.6g s (%.5g sqrt(H/g)): ", r->time * r->output.time_scale,
                        r->time);
}

/* What is known at the end, however the run ended; returns its status and keeps its message. */
static enum status conclude(struct bem_run *r, enum status status) {
  char why[1024];
  snprintf(why, sizeof why, "%s", status_message());
  enum status written = status == OK || status == INTERRUPTED ? bem_events_conclude(r) : OK;
  if (written == OK)
    written = bem_output_statistics(&r->output, &r->flow, r->stepper, bem_pace_cut(&r->pace));
  if (written == OK && (r->lost || (status != OK && status != INTERRUPTED)))
    written = result_statistic(r->output.file, "last_good_time", r->time * r->output.time_scale,
                               "s", "of the last step that succeeded, before the run broke off");
  return status == OK ? written : status_raise(status, "%s", why);
}

/* Heights of the tops of the walls above the bed, H. */
static void find_tops(const struct case_file *c, double top[2]) {
  struct tank tank = tank_of(&c->walls, c->periodic);
  for (int side = 0; side < 2; side++) top[side] = (tank.top[side] - c->tank.min[1]) / c->H;
}

/* Angular frequency of the case's wave by linear theory, sqrt(g/H); 1 of water without one. */
static double wave_frequency(const struct case_file *c) {
  if (!flow_is_wave(c->flow)) return 1;
  const struct flow_scale s = c->flow->scale(c);
  const double k = 2 * M_PI / s.length, omega = sqrt(c->H * k * tanh(k * s.depth));
  return s.length > 0 && omega > 0 && isfinite(omega) ? omega : 1;
}

static enum status begin(struct bem_run *r, const struct case_run *cr) {
  const struct case_file *c = r->c;
  const struct bem_options *o = cr->options;
  struct bem_solve_options solve = {.tolerance = o->gmres, .dense_up_to = (size_t)o->dense};
  bool wave = flow_is_wave(c->flow);
  const double amplitude = wave ? c->flow->scale(c).amplitude : 0;
  double tolerance = o->tolerance * (amplitude > 0 ? 1e-3 * amplitude / c->H : 1);
  if (!(tolerance > 1e-14)) tolerance = 1e-14; /* rounding */
  TRY(bem_solve_create(&solve, &r->flow.solve));
  solve.tolerance = fmax(solve.tolerance, SHOWN);
  TRY(bem_output_create(&r->output, &solve));
  r->flow.surface.film = o->film / c->H;
  if (bem_basin_is_mapped(c)) TRY(bem_basin_shore(c, &r->shore));
  TRY(bem_start_surface(c, cr, r->shore, &r->flow));
  r->flow.surface.depth = r->flow.level;
  r->flow.surface.smooth =
      !r->flow.motion.frame && !r->flow.motion.sides && bem_smooth_is(&r->flow.surface);
  const struct bem_surface *s = &r->flow.surface;
  r->start[0] = s->state[s->n];
  r->start[1] = s->state[2 * s->n - 1];
  r->flow.filter = o->filter * (r->flow.surface.tip > 0 ? 1 : GENTLE * wave_frequency(c));
  r->flow.smoothing = o->smoothing;
  TRY(bem_stepper_create(&r->flow, tolerance, &bem_events_roots, r, &r->stepper));
  TRY(bem_run_restart(r));
  r->flow.surface.volume = bem_surface_totals(&r->flow.surface, r->flow.psi).volume;
  return bem_output_due(&r->output, &r->flow, NULL, 0, 0);
}

static enum status run_seen(const struct bem_mirror *seen, const struct case_run *cr,
                            struct result *out, struct progress *progress) {
  const struct bem_options *o = cr->options;
  const struct case_file *c = &seen->c;
  struct bem_run r = {.c = c,
                      .output = {.c = c,
                                 .name = cr->name,
                                 .progress = progress,
                                 .mirrored = seen->turned,
                                 .file = out,
                                 .forces = o->forces,
                                 .spacing = o->lattice / c->H,
                                 .start = progress_wall_clock(),
                                 .time_scale = sqrt(c->H / c->gravity)}};
  find_tops(c, r.top);
  enum status status = begin(&r, cr);
  if (status == OK) {
    status = advance(&r, progress);
    if (status != OK) status = date(&r, status);
    status = conclude(&r, status);
  }
  bem_output_destroy(&r.output);
  bem_pace_destroy(&r.pace);
  bem_stepper_destroy(r.stepper);
  bem_sides_destroy(&r.sides);
  bem_flow_destroy(&r.flow);
  bem_shore_destroy(r.shore);
  return status;
}

static enum status run_once(const struct case_file *c, const struct case_run *cr,
                            struct result *out, struct progress *progress) {
  struct bem_mirror seen;
  enum status status = bem_mirror_create(c, &seen);
  if (status == OK) status = run_seen(&seen, cr, out, progress);
  bem_mirror_destroy(&seen);
  return status;
}

/* A coarser run that cannot go on leaves no error bars from there on. */
static enum status run_with_errors(const struct case_file *c, const struct case_run *cr,
                                   struct result *out, struct progress *progress) {
  const struct result_coarser how = {BEM_COARSER, BEM_ORDER};
  struct bem_options options;
  struct case_run coarser;
  struct result *twin = NULL;
  bem_accuracy_coarsen(c, cr, &options, &coarser);
  enum status status = OK;
  ATTEMPT(result_create_coarser(c, &coarser, &twin));
  status = run_once(c, &coarser, twin, progress);
  if (status == ERR_SOLVER || status == ERR_DIVERGED) {
    progress_say(progress, "%s: no error bars beyond the end of the coarser run: %s", cr->name,
                 status_message());
    status = OK;
  }
  ATTEMPT(status);
  ATTEMPT(result_hold_against(out, twin, &how));
  ATTEMPT(run_once(c, cr, out, progress));
done:
  result_destroy(twin);
  return status;
}

static void say_warnings(const struct case_file *c, const struct case_run *cr,
                         struct progress *progress) {
  struct problems warnings = {0};
  bem_start_warn(c, cr, &warnings);
  for (size_t k = 0; k < warnings.n; k++)
    progress_say(progress, "%s: %s", cr->name, warnings.text[k]);
  problems_destroy(&warnings);
}

static enum status run(const struct case_file *c, const struct case_run *cr, struct result *out,
                       struct progress *progress) {
  const struct bem_options *o = cr->options;
  say_warnings(c, cr, progress);
  return (o->error_bars ? run_with_errors : run_once)(c, cr, out, progress);
}

static const struct solver_term terms[] = {
    {"filter", "energy taken out so far by filter and smoothing, heights from the level at rest",
     false},
    {"frame", "energy given so far to a tank that moves, by the force on water in its frame", true},
    {"sides", "energy given so far to sides that move, by the pressure on them", true}};

const struct solver bem_solver = {
    .name = "bem",
    .help = "fully nonlinear potential flow by boundary elements, to the touchdown of the breaker",
    .params = params,
    .n_params = sizeof params / sizeof *params,
    .options_size = sizeof(struct bem_options),
    .terms = terms,
    .n_terms = sizeof terms / sizeof *terms,
    .settle = bem_accuracy_settle,
    .check = bem_start_check,
    .warn = bem_start_warn,
    .estimate = bem_estimate,
    .run = run,
};

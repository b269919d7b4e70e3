/* Weakly compressible SPH with numerical diffusion: P eqs. (1) to (11) in space, (25) to (29) in
 * time. */
#include "sph/solver.h"

#include <math.h>

#include "common/base/geometry_check.h"
#include "common/base/progress.h"
#include "common/case/case.h"
#include "common/flow/flow.h"
#include "common/result/result.h"
#include "sph/domain/fitted.h"
#include "sph/domain/wall.h"
#include "sph/estimate.h"
#include "sph/fluid/energy.h"
#include "sph/observe/diagnose.h"
#include "sph/observe/output.h"
#include "sph/observe/watch.h"
#include "sph/owners.h"
#include "sph/pair/derivative.h"
#include "sph/pair/diffusion.h"
#include "sph/pair/forms.h"
#include "sph/pair/kernel.h"
#include "sph/pair/rates.h"
#include "sph/presets.h"
#include "sph/sph.h"
#include "sph/theory/stability.h"
#include "sph/time/integrator.h"
#include "sph/time/timestep.h"
#include "sph/tips.h"
#include "sph/treat/treat.h"

static enum status march(const struct case_file *c, struct sph *s, struct sph_output *output,
                         struct progress *progress) {
  TRY(sph_watch_state(s));
  sph_enter(s, SPH_PHASE_output);
  TRY(sph_output_step(output, s, 0));
  sph_enter(s, SPH_PHASE_other);
  double work = 0;
  while (s->t < c->end) {
    if (progress_stop_requested()) return status_raise(INTERRUPTED, "stopped at t = %g s", s->t);
    TRY(sph_remove_outside(s));
    sph_enter(s, SPH_PHASE_treat);
    TRY(sph_treat(s));
    TRY(sph_rates(s, 0, true, true));
    sph_enter(s, SPH_PHASE_output);
    TRY(sph_output_rates(output, s));
    sph_enter(s, SPH_PHASE_check);
    double next = sph_output_next(output), dt = sph_timestep(s, next);
    TRY(sph_watch_step(s, dt, next - s->t));
    sph_enter(s, SPH_PHASE_step);
    TRY(sph_step(s, dt));
    if (next - s->t < 1e-9 * dt) s->t = next;
    sph_enter(s, SPH_PHASE_check);
    TRY(sph_watch_state(s));
    sph_enter(s, SPH_PHASE_output);
    TRY(sph_output_step(output, s, dt));
    sph_enter(s, SPH_PHASE_other);
    work += (double)s->f.n;
    progress_step(progress, s->steps, s->t, dt, work, "particles", sph_output_drift(output));
  }
  return sph_output_finish(output, s);
}

/* On the outline at t = 0, where bodies move fastest, m/s. */
static double outline_speed(const struct case_file *c) {
  struct flow_water w;
  double u[2], most = 0;
  if (flow_open(c, (struct flow_use){0}, &w) == OK)
    for (size_t i = 0; i < c->water.points; i++) {
      flow_velocity(&w, c->water.p[i][0], c->water.p[i][1], 0, u);
      most = fmax(most, hypot(u[0], u[1]));
    }
  flow_close(&w);
  return most;
}

/* About what the water can reach, m/s: the tip of a dam break on a dry bed. */
static double reachable_speed(const struct case_file *c) {
  if (!c->water.pieces) return 0;
  if (flow_is_body(c->flow)) return M_SQRT2 * outline_speed(c); /* all of it along one axis */
  struct geo_box w = geo_lines_box(&c->water);
  return 2 * sqrt(c->gravity * (w.max[1] - c->tank.min[1])) + hypot(c->velocity[0], c->velocity[1]);
}

static void warn(const struct case_file *c, const struct case_run *r, struct problems *warnings) {
  const struct sph_scheme *o = r->options;
  const double mach = reachable_speed(c) / o->c0;
  const char *of_forms = sph_forms_warning(o, c->gravity);
  if (mach > 0.3)
    problems_add(warnings, case_run_line(r, "c0"),
                 "c0 = %.4g m/s: the water may reach a Mach number of %.2f, where about 0.1 is "
                 "wanted; %.4g m/s would do",
                 o->c0, mach, 10 * reachable_speed(c));
  if (of_forms) problems_add(warnings, case_run_line(r, "solver"), "%s", of_forms);
}

static void say_warnings(const struct case_file *c, const struct case_run *r,
                         struct progress *progress) {
  struct problems warnings = {0};
  warn(c, r, &warnings);
  for (size_t k = 0; k < warnings.n; k++) progress_say(progress, "%s", warnings.text[k]);
  problems_destroy(&warnings);
}

static enum status run(const struct case_file *c, const struct case_run *r, struct result *result,
                       struct progress *progress) {
  struct sph *s = NULL;
  struct sph_output *output = NULL;
  enum status status;
  say_warnings(c, r, progress);
  ATTEMPT(sph_create(c, r->resolution, r->options, &s));
  ATTEMPT(sph_output_create(c, s, result, &output));
  status = march(c, s, output, progress);
  if (status != OK && status != INTERRUPTED && status != ERR_DIVERGED) goto done;
  enum status why = status; /* the message of the first failure stays unless this one fails too */
  ATTEMPT(sph_watch_write(s, result));
  if (why != OK) ATTEMPT(sph_output_last(output, s));
  status = why;
done:
  sph_output_destroy(output);
  sph_destroy(s);
  return status;
}

/* The water as a whole has room for four particles, every part of it for two. */
static void check_thickness(const struct case_file *c, const struct case_run *r,
                            struct problems *problems) {
  double dx = c->H / r->resolution, area = 0, thickness = 0, at[2] = {0};
  struct geo_box w = geo_lines_box(&c->water);
  double thin = fmin(w.max[0] - w.min[0], w.max[1] - w.min[1]);
  if (thin < 4 * dx)
    problems_add(problems, case_run_line(r, "resolution"),
                 "runs.%s.resolution: found '%g', where four particle spacings (%g m) exceed the "
                 "water's thickness (%g m); allowed: at least %g; raise it",
                 r->name, r->resolution, 4 * dx, thin, ceil(r->resolution * 4 * dx / thin));
  else if (geo_lines_thin(&c->water, 2 * (1 - 1e-6) * dx, 4 * dx * dx, &area, &thickness, at) != OK)
    problems->out_of_memory = true;
  else if (area > 0)
    problems_add(problems, case_run_line(r, "resolution"),
                 "runs.%s.resolution: found '%g', where two particle spacings (%g m) exceed the "
                 "thickness of a part of the water (%.3g m at (%.4g, %.4g) m); allowed: at least "
                 "%g; raise it or leave that part out",
                 r->name, r->resolution, 2 * dx, thickness, at[0], at[1],
                 ceil(2 * c->H / thickness * (1 - 1e-6)));
}

/* The largest c0 dt/h that waves on a lattice stand: none grows by more than a factor e in the time
 * of the run, nor in what is left of it when damping has ended. */
static enum status stable_courant(const struct case_file *c, const struct sph_scheme *o,
                                  double unit, double *courant) {
  struct sph_scheme scaled = *o;
  double later;
  scaled.damping *= unit;
  TRY(sph_stable_courant(&scaled, unit / c->end, courant));
  if (o->damping == 0 || o->damping_end == 0 || o->damping_end >= c->end) return OK;
  scaled.damping = 0;
  TRY(sph_stable_courant(&scaled, unit / (c->end - o->damping_end), &later));
  *courant = fmin(*courant, later);
  return OK;
}

/* Steps of water at rest against what its waves stand. */
static void check_step(const struct case_file *c, const struct case_run *r,
                       struct problems *problems) {
  const struct sph_scheme *o = r->options;
  struct sph_bounds b;
  const double h = o->h_over_dx * c->H / r->resolution, unit = h / o->c0;
  const double courant = o->dt > 0 ? o->dt / unit : sph_courant_at_rest(o, &b);
  double stable;
  if (stable_courant(c, o, unit, &stable) != OK) {
    problems->out_of_memory = true;
    return;
  }
  if (courant <= stable) return;
  if (o->dt > 0) {
    problems_add(
        problems, case_run_line(r, "dt"),
        "runs.%s.dt: found '%g s', which is %.3g h/c0, where waves on a lattice grow beyond "
        "%.3g in the time of the run (%s); allowed: at most %.3g s; lower it",
        r->name, o->dt, courant, stable, sph_integrator_names[sph_integrator_chosen(o)],
        0.999 * stable * unit);
    return;
  }
  const bool viscous = b.viscous <= courant, acoustic = b.acoustic <= courant;
  const char *key = acoustic ? "cfl_acoustic" : viscous ? "cfl_viscous" : "cfl_diffusive";
  const double factor = acoustic ? o->cfl_acoustic : viscous ? o->cfl_viscous : o->cfl_diffusive;
  problems_add(
      problems, case_run_line(r, key),
      "runs.%s.%s: found '%g', with which steps in water at rest are %.3g h/c0, where waves "
      "on a lattice grow beyond %.3g (kernel %s, h/dx = %.4g, %s, diffusion %s with delta = "
      "%.3g, alpha = %g); allowed: at most %.3g; lower it",
      r->name, key, factor, courant, stable, sph_scheme_name(o, "kernel"), o->h_over_dx,
      sph_integrator_names[sph_integrator_chosen(o)], sph_scheme_name(o, "diffusion"),
      sph_scheme_delta(o), o->alpha, 0.999 * factor * stable / courant);
}

/* Sound that grows in every step has no bound that a step could be taken from. */
static void check_integrator(const struct case_run *r, struct problems *problems) {
  const struct sph_scheme *o = r->options;
  const struct sph_integrator *method = sph_integrators[sph_integrator_chosen(o)];
  const char *name = sph_integrator_names[sph_integrator_chosen(o)];
  if (method->acoustic == 0 && o->dt == 0)
    problems_add(problems, case_run_line(r, "integrator"),
                 "runs.%s.integrator: found '%s', which by itself lets sound grow in a step of any "
                 "size (thesis, eqs. 2.246 to 2.268), so that no bound gives one; allowed: with "
                 "dt; give it or "
                 "take another",
                 r->name, name);
  if (o->damping > 0 && !method->damps)
    problems_add(
        problems, case_run_line(r, "damping"),
        "runs.%s.damping: found '%g' with the integrator %s, which does not damp; allowed: "
        "damped-pc; take that or write damping: 0",
        r->name, o->damping, name);
}

/* What walls do, as the pair loops know it. */
static void check_forces(const struct case_run *r, struct problems *problems) {
  const struct sph_scheme *o = r->options;
  if (!o->forces) return;
  if (derivative_is_fit((enum sph_derivative)o->derivative))
    problems_add(
        problems, case_run_line(r, "forces"),
        "runs.%s.forces: found with derivative: %s, which does not tell what walls do from "
        "what the water does; allowed: with derivative: kernel; leave the line out",
        r->name, sph_scheme_name(o, "derivative"));
  if (eos_drives_by_excess((enum sph_eos)o->eos))
    problems_add(problems, case_run_line(r, "forces"),
                 "runs.%s.forces: found with eos: %s, which presses on walls by what is above the "
                 "hydrostatic pressure alone; allowed: with any other eos; leave the line out",
                 r->name, sph_scheme_name(o, "eos"));
}

static void check_walls(const struct case_file *c, const struct case_run *r,
                        struct problems *problems) {
  static const char *const keys[] = {"walls", "slip"};
  for (int k = 0; k < 2; k++)
    if (c->periodic[0] && c->periodic[1] && case_run_gives(r, keys[k]))
      problems_add(problems, case_run_line(r, keys[k]),
                   "runs.%s.%s: found in a tank that is periodic both ways, where it does nothing; "
                   "allowed: with walls; leave the line out",
                   r->name, keys[k]);
}

/* What counts heights along y. */
static void check_gravity(const struct case_file *c, const struct case_run *r,
                          struct problems *problems) {
  const struct sph_scheme *o = r->options;
  if (c->gravity == 0 && !c->periodic[1] && sph_walls[o->walls] == &sph_wall_mirror_exponential)
    problems_add(
        problems, case_run_line(r, "walls"),
        "runs.%s.walls: found 'mirror-exponential' without gravity, whose pressure it goes "
        "on with below the bed; allowed: with gravity; write walls: mirror-plain",
        r->name);
  if (!case_is_turned(c)) return;
  if (sph_walls[o->walls] == &sph_wall_mirror_exponential)
    problems_add(problems, case_run_line(r, "walls"),
                 "runs.%s.walls: found 'mirror-exponential' under gravity along (%g, %g), where it "
                 "knows no pressure below; allowed: with gravity downwards; write walls: mirror",
                 r->name, c->down[0], c->down[1]);
  if (!eos_is_plain((enum sph_eos)o->eos))
    problems_add(problems, case_run_line(r, "eos"),
                 "runs.%s.eos: found '%s' under gravity along (%g, %g), which it takes to be "
                 "downwards; allowed: linear, tait; take one of them",
                 r->name, sph_scheme_name(o, "eos"), c->down[0], c->down[1]);
}

/* The first motion of a side, or NULL. */
static const struct tank_motion *motion_of_side(const struct case_file *c) {
  for (size_t k = 0; k < c->n_motions; k++)
    if (tank_motion_is_of_side(&c->motions[k])) return &c->motions[k];
  return NULL;
}

static bool has_flap(const struct case_file *c) {
  for (size_t k = 0; k < c->n_motions; k++)
    if (c->motions[k].kind == TANK_MOTION_flap) return true;
  return false;
}

/* Ghosts in sharper corners than that have no water at their mirror points. */
static void check_flaps(const struct case_file *c, const struct case_run *r,
                        struct problems *problems) {
  double angle = M_PI;
  if (sph_sides_sharpest(c, &angle) != OK) problems->out_of_memory = true;
  if (angle >= M_PI / 4 * (1 - 1e-9)) return;
  problems_add(problems, case_run_line(r, "solver"),
               "runs.%s.solver: found 'sph' with a flap that folds its wall to a corner of %.3g "
               "degrees; allowed: at least 45 degrees; make its stroke smaller",
               r->name, angle * 180 / M_PI);
}

/* The work of a side is that of its own pairs, which a fit has not. */
static void check_work(const struct tank_motion *side, const struct case_run *r,
                       struct problems *problems) {
  const struct sph_scheme *o = r->options;
  if (!derivative_is_fit((enum sph_derivative)o->derivative)) return;
  problems_add(problems, case_run_line(r, "derivative"),
               "runs.%s.derivative: found '%s' with a %s, whose work it does not tell from that of "
               "the water; allowed: kernel; write derivative: kernel",
               r->name, sph_scheme_name(o, "derivative"), tank_motion_name(side));
}

/* Which walls know what a tank and sides that move do. */
static void check_motions(const struct case_file *c, const struct case_run *r,
                          struct problems *problems) {
  const int walls = ((const struct sph_scheme *)r->options)->walls;
  const struct tank_motion *side = motion_of_side(c);
  if (c->n_motions && sph_walls[walls] == &sph_wall_mirror_exponential)
    problems_add(problems, case_run_line(r, "walls"),
                 "runs.%s.walls: found 'mirror-exponential' in a tank that moves, beside whose "
                 "walls it knows no pressure; allowed: in a tank at rest; write walls: mirror",
                 r->name);
  else if (side && !sph_walls[walls]->move)
    problems_add(problems, case_run_line(r, "walls"),
                 "runs.%s.walls: found '%s' with a %s, which it cannot follow; allowed: ghost, "
                 "mirror, mirror-plain; write walls: ghost",
                 r->name, sph_wall_names[walls], tank_motion_name(side));
  else if (has_flap(c) && sph_walls[walls]->moving)
    problems_add(problems, case_run_line(r, "walls"),
                 "runs.%s.walls: found '%s' with a flap, whose corners images do not fill once; "
                 "allowed: ghost; write walls: ghost",
                 r->name, sph_wall_names[walls]);
  if (has_flap(c)) check_flaps(c, r, problems);
  if (side) check_work(side, r, problems);
}

/* Images fill no corner of the water that is sharper than a right angle, and jump from face to face
 * at corners of the solid: still water of H/13 shakes there at half sqrt(gH). */
static void check_corners(const struct case_file *c, const struct case_run *r,
                          struct problems *problems) {
  struct faces faces = {0};
  if (faces_set(&faces, &c->walls, 0, NULL) != OK) problems->out_of_memory = true;
  const uint32_t k = faces_unfilled(&faces);
  if (k != FACE_NONE) {
    const struct face *f = &faces.face[k];
    problems_add(
        problems, case_run_line(r, "walls"),
        "runs.%s.walls: found '%s' beside a corner of %.3g degrees at (%.6g, %.6g) m, which "
        "images do not fill once; allowed: ghost, or corners of 90 to 180 degrees; write walls: "
        "ghost",
        r->name, sph_wall_names[((const struct sph_scheme *)r->options)->walls],
        180 - f->turn * 180 / M_PI, f->b[0], f->b[1]);
  }
  faces_destroy(&faces);
}

static void check_tank(const struct case_file *c, const struct case_run *r,
                       struct problems *problems) {
  const struct sph_scheme *o = r->options;
  if (c->rectangular) return;
  if (c->flow->on_surface_alone && c->flow->on_surface_alone(c))
    problems_add(problems, case_run_line(r, "solver"),
                 "runs.%s.solver: found 'sph' with the motion of a surface from a file in a tank "
                 "that is not rectangular, where nothing tells the velocities below it; allowed: "
                 "lines 'x, eta' of water at rest; take solver: bem, or kind: curve",
                 r->name);
  if (sph_walls[o->walls]->moving) check_corners(c, r, problems);
  sph_tips_check(c, r, problems);
  if (sph_walls[o->walls] == &sph_wall_dynamic)
    problems_add(
        problems, case_run_line(r, "walls"),
        "runs.%s.walls: found 'dynamic' in a tank that is not rectangular; allowed: ghost, "
        "a mirror, or one wall, open at the top, down the left side, along a flat bed, up "
        "the right side; write walls: ghost",
        r->name);
}

static void check(const struct case_file *c, const struct case_run *r, struct problems *problems) {
  const struct sph_scheme *o = r->options;
  const bool diffuses = o->diffusion != SPH_DIFFUSION_none && o->delta != 0;
  double dx = c->H / r->resolution;
  double support = kernel_support((enum sph_kernel)o->kernel) * o->h_over_dx * dx;
  double width = c->tank.max[0] - c->tank.min[0], height = c->tank.max[1] - c->tank.min[1];
  if (o->integrator != SPH_INTEGRATOR_AUTO && !diffuses &&
      (sph_integrators[o->integrator]->frozen || sph_integrators[o->integrator]->split))
    problems_add(problems, case_run_line(r, "integrator"),
                 "runs.%s.integrator: found '%s', which %s a diffusion that there is none of; "
                 "allowed: any other; write integrator: rk4, which it is then",
                 r->name, sph_integrator_names[o->integrator],
                 sph_integrators[o->integrator]->frozen ? "freezes" : "splits off");
  sph_forms_check(r, problems);
  sph_owners_check(r, problems);
  check_integrator(r, problems);
  if (o->free_surface != SPH_FREE_SURFACE_natural &&
      !(flow_is_wave(c->flow) && !c->flow->line && c->rectangular))
    problems_add(problems, case_run_line(r, "free_surface"),
                 "runs.%s.free_surface: found '%s' with regions of water, a curve, or in a tank "
                 "that is not rectangular, whose outline no row of "
                 "particles follows; allowed: with water.wave in a rectangular tank; write "
                 "free_surface: natural",
                 r->name, o->free_surface == SPH_FREE_SURFACE_fitted ? "fitted" : "level");
  check_forces(r, problems);
  check_walls(c, r, problems);
  check_gravity(c, r, problems);
  check_motions(c, r, problems);
  check_tank(c, r, problems);
  if (width < 2 * support || height < 2 * support)
    problems_add(problems, case_run_line(r, "resolution"),
                 "runs.%s.resolution: found '%g', where two kernel supports (%g m) exceed the tank "
                 "(%g m x %g m); allowed: at least %g; raise it",
                 r->name, r->resolution, 2 * support, width, height,
                 ceil(r->resolution * 2 * support / fmin(width, height)));
  if (c->water.pieces > 0) check_thickness(c, r, problems);
  check_step(c, r, problems);
  sph_treat_check(c, r, problems);
}

const struct solver sph_solver = {
    .name = "sph",
    .help = "weakly compressible smoothed particle hydrodynamics with density diffusion",
    .params = sph_params,
    .n_params = SPH_N_PARAMS,
    .presets = sph_presets,
    .n_presets = SPH_N_PRESETS,
    .terms = sph_terms,
    .n_terms = SPH_TERM_COUNT,
    .options_size = sizeof(struct sph_scheme),
    .check = check,
    .warn = warn,
    .estimate = sph_estimate,
    .run = run,
};

#include "sph/observe/watch.h"

#include <math.h>

#include "sph/domain/wall.h"
#include "sph/hot.h"
#include "sph/pair/derivative.h"
#include "sph/pair/diffusion.h"
#include "sph/pair/forms.h"
#include "sph/time/timestep.h"

/* X(term, what to do where it drives the water, or NULL for what always may help). */
#define REMEDIES(X)                                                                                \
  X(pairs,                                                                                         \
    o->derivative == SPH_DERIVATIVE_kernel                                                         \
        ? "take forms of momentum and continuity that are adjoint, or treat the water more "       \
          "often"                                                                                  \
        : "write derivative: kernel, or treat the water more often")                               \
  X(walls, sph_walls[o->walls] == &sph_wall_ghost ? remedy_of_ghosts(s) : NULL)                    \
  X(diffusion, o->diffusion == SPH_DIFFUSION_antuono ? "lower delta"                               \
                                                     : "write diffusion: antuono, or lower delta") \
  X(smoothing, "smooth less often")

enum { CAUSE = SPH_ADVICE + 100 };

/* Mirrors can stand in for ghosts where images fill what is behind the walls. */
static const char *remedy_of_ghosts(const struct sph *s) {
  bool folds = false;
  for (size_t k = 0; k < s->force.n; k++) folds |= s->force.motion[k].kind == TANK_MOTION_flap;
  return folds || faces_unfilled(&s->faces) != FACE_NONE
             ? "raise c0 or alpha"
             : "write walls: mirror, or raise c0 or alpha";
}

/* What follows "at t = 1 s": the term of the budget that has given most, and at least half, of the
 * motion before it broke off, if one has (what moves by gravity has it from none), and what to do.
 */
static void write_cause(const struct sph *s, char text[CAUSE]) {
  const struct sph_scheme *o = &s->scheme;
  const struct sph_seen *seen = &s->seen;
  const char *term = NULL, *todo = NULL;
  double given = 0.5 * seen->kinetic;
  char advice[SPH_ADVICE];
#define X(name, remedy)                                                                            \
  if (-seen->budget.name > given) {                                                                \
    given = -seen->budget.name;                                                                    \
    term = #name;                                                                                  \
    todo = remedy;                                                                                 \
  }
  REMEDIES(X)
#undef X
  sph_forms_advise(s, advice);
  if (term)
    snprintf(text, CAUSE, ", %s in the budget of energy having given %.2g J/m: %s", term, given,
             todo ? todo : advice);
  else
    snprintf(text, CAUSE, ": %s", advice);
}

/* How bad a particle is: infinitely where it has no value, else how fast, or, if densities are what
 * went wrong, how light. */
static double badness(const struct sph *s, size_t i, bool by_density) {
  const struct sph_state *w = &s->f.w;
  if (!isfinite(w->x[i] + w->y[i] + w->u[i] + w->v[i] + w->rho[i])) return INFINITY;
  return by_density ? -eos_density(&s->eos, w->rho[i], w->y[i]) : hypot(w->u[i], w->v[i]);
}

static enum status name_culprit(const struct sph *s, bool by_density) {
  const struct sph_state *w = &s->f.w;
  char cause[CAUSE];
  size_t worst = 0;
  for (size_t i = 1; i < s->f.n; i++)
    if (badness(s, i, by_density) > badness(s, worst, by_density)) worst = i;
  write_cause(s, cause);
  const bool fast = hypot(w->u[worst], w->v[worst]) > s->c0;
  return status_raise(ERR_DIVERGED,
                      "particle %u at (%g, %g) m has velocity (%g, %g) m/s%s and density %g kg/m^3 "
                      "at t = %g s%s",
                      s->f.id[worst], w->x[worst], w->y[worst], w->u[worst], w->v[worst],
                      fast ? ", faster than its sound," : "",
                      eos_density(&s->eos, w->rho[worst], w->y[worst]), s->t, cause);
}

enum status sph_watch_state(struct sph *s) {
  const struct sph_state *w = &s->f.w;
  double sum = 0; /* not finite as soon as one term is not */
  double lightest = s->seen.lightest, heaviest = s->seen.heaviest, speed2 = 0, kinetic = 0;
#pragma omp parallel for simd schedule(static) reduction(+ : sum, kinetic)                         \
    reduction(min : lightest) reduction(max : heaviest, speed2)
  for (size_t i = 0; i < s->f.n; i++) {
    sum += 0 * (w->x[i] + w->y[i] + w->u[i] + w->v[i] + w->rho[i]);
    double rho = eos_density(&s->eos, w->rho[i], w->y[i]),
           square = w->u[i] * w->u[i] + w->v[i] * w->v[i];
    lightest = rho < lightest ? rho : lightest; /* fmin would be a call */
    heaviest = rho > heaviest ? rho : heaviest;
    speed2 = square > speed2 ? square : speed2;
    kinetic += s->f.m[i] * square / 2;
  }
  s->seen.lightest = lightest;
  s->seen.heaviest = heaviest;
  s->seen.speed = fmax(s->seen.speed, sqrt(speed2));
  if (sum != 0 || lightest <= 0 || speed2 > s->c0 * s->c0)
    return name_culprit(s, sum == 0 && lightest <= 0);
  s->seen.kinetic = kinetic;
  s->seen.budget = s->budget;
  return OK;
}

/* Steps are cut for the particle that is accelerated most, or for the fastest pair. */
static enum status name_hurried(const struct sph *s, double dt) {
  const struct sph_state *w = &s->f.w, *k = &s->f.k[0];
  char cause[CAUSE];
  size_t most = 0;
  for (size_t i = 1; i < s->f.n; i++)
    if (hypot(k->u[i], k->v[i]) > hypot(k->u[most], k->v[most])) most = i;
  write_cause(s, cause);
  return status_raise(
      ERR_DIVERGED,
      "the time step fell to %.2g s, with pairs as fast as %.3g m/s and particle %u "
      "at (%g, %g) m accelerated by %.3g m/s^2, at t = %g s%s",
      dt, s->totals.speed, s->f.id[most], w->x[most], w->y[most], hypot(k->u[most], k->v[most]),
      s->t, cause);
}

enum status sph_watch_step(struct sph *s, double dt, double left) {
  const double smallest = 1e-6 * s->h / s->c0;
  if (s->scheme.dt == 0 && dt < smallest && dt < left) return name_hurried(s, dt);
  s->seen.cut += sph_timestep_is_cut(s);
  return OK;
}

/* How often treatments were applied, of those that the run has. */
static enum status write_applied(const struct sph *s, struct result *result) {
  static const char *const name[] = {
#define X(name, ...) "applied_" #name,
      SPH_TREATMENTS(X)
#undef X
  };
  for (int k = 0; k < SPH_TREATMENT_COUNT; k++)
    if (s->scheme.every[k] != 0)
      TRY(result_statistic(result, name[k], (double)s->applied[k], "1",
                           "times this treatment was applied"));
  return OK;
}

enum status sph_watch_write(const struct sph *s, struct result *result) {
  const struct {
    const char *name;
    double value;
    const char *units, *help;
  } row[] = {
      {"steps", (double)s->steps, "1", "time steps"},
      {"evaluations", (double)s->evaluations, "1", "evaluations of the right-hand side"},
      {"rebuilds", (double)s->rebuilds, "1", "times the neighbour lists were built"},
      {"wall_rebuilds", (double)s->wall_rebuilds, "1", "times those of the walls were built"},
      {"reflections", (double)s->reflections, "1",
       "times a particle that had crossed a wall was reflected"},
      {"particles", (double)s->f.n, "1", "particles of water at the end"},
      {"largest_mach", s->seen.speed / s->c0, "1",
       "largest speed of a particle over c0, at any step"},
      {"lowest_density", s->seen.lightest / s->rho0, "1", "lowest density over rho0, at any step"},
      {"highest_density", s->seen.heaviest / s->rho0, "1",
       "highest density over rho0, at any step"},
      {"steps_cut", (double)s->seen.cut, "1",
       "time steps that speed or acceleration cut to less than a tenth of what water at rest "
       "allows"},
#define X(phase, what)                                                                             \
  {"wall_time_" #phase, s->clock.seconds[SPH_PHASE_##phase], "s", "clock on the wall: " what},
      SPH_PHASES(X)
#undef X
          {"spilled_volume", s->budget.spilled_volume, "m^2",
           "water that left over the top of a wall"},
      {"lost_volume", s->budget.removed_volume - s->budget.spilled_volume, "m^2",
       "water that left through a wall or the bed"},
  };
  for (size_t k = 0; k < sizeof row / sizeof *row; k++)
    TRY(result_statistic(result, row[k].name, row[k].value, row[k].units, row[k].help));
  return write_applied(s, result);
}

#include "sph/observe/watch.h"

#include <math.h>

#include "sph/hot.h"
#include "sph/time/timestep.h"

/* X(term, what to do where it drives the water). */
#define REMEDIES(X)                                                                                \
  X(pairs,                                                                                         \
    "take forms of momentum and continuity that are adjoint, or treat the water more often")       \
  X(walls, "write walls: mirror, or raise c0 or alpha")                                            \
  X(diffusion, "write diffusion: antuono, or lower delta")                                         \
  X(smoothing, "smooth less often")

enum { CAUSE = 300 };

/* What follows "at t = 1 s": the term of the budget that has given at least half of the motion
 * before it broke off, if one has (what moves by gravity has it from none), and what to do. */
static void write_cause(const struct sph_seen *seen, char text[CAUSE]) {
#define X(name, remedy)                                                                            \
  if (-seen->budget.name > 0.5 * seen->kinetic) {                                                  \
    snprintf(text, CAUSE, ", %s in the budget of energy having given %.2g J/m: %s", #name,         \
             -seen->budget.name, remedy);                                                          \
    return;                                                                                        \
  }
  REMEDIES(X)
#undef X
  snprintf(text, CAUSE, ": raise c0, alpha or delta, or lower cfl_acoustic");
}

static enum status find_culprit(const struct sph *s) {
  const struct sph_state *w = &s->f.w;
  char cause[CAUSE];
  write_cause(&s->seen, cause);
  for (size_t i = 0; i < s->f.n; i++)
    if (!isfinite(w->x[i] + w->y[i] + w->u[i] + w->v[i] + w->rho[i]) || w->rho[i] <= 0)
      return status_raise(ERR_DIVERGED,
                          "particle %u at (%g, %g) m has velocity (%g, %g) m/s and density %g "
                          "kg/m^3 at t = %g s%s",
                          s->f.id[i], w->x[i], w->y[i], w->u[i], w->v[i], w->rho[i], s->t, cause);
  return OK;
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
  if (sum != 0 || lightest <= 0) return find_culprit(s);
  s->seen.kinetic = kinetic;
  s->seen.budget = s->budget;
  return OK;
}

enum status sph_watch_step(struct sph *s, double dt, double left) {
  const double smallest = 1e-6 * s->h / s->c0;
  CHECK(dt >= smallest || dt >= left, ERR_DIVERGED,
        "the time step fell to %.2g s at t = %g s (speed up to %.3g m/s, acceleration up to %.3g "
        "m/s^2): raise c0, alpha or delta",
        dt, s->t, s->totals.speed, sqrt(s->totals.acceleration2));
  s->seen.cut += sph_timestep_is_cut(s);
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
  return OK;
}

/* The bounds of the time step (P, eqs 26-29), as c0 dt/h:
 *     diffusion     cfl_diffusive/delta                                                   (27)
 *     viscosity     0.125 h^2/nu, nu = alpha h c0/(2 n + 4) in n dimensions               (28)
 *     acceleration  0.25 sqrt(h/|a|)                                                      (28)
 *     sound         cfl_acoustic h/(c0 + |u| + h max |pi|), pi = u_ij.r_ij/r^2            (29)
 * (29) prints max pi: with P's sign of pi approaching particles would lengthen the step. */
#include <math.h>

#include "theory/theory.h"

struct timestep {
  double alpha, mach, approach, load, cfl_diffusive, cfl_acoustic, from, to;
  int dimensions, points;
};

static const struct param params[] = {
    THEORY_REAL(timestep, alpha, 0, 100, "0.01", "artificial viscosity"),
    THEORY_REAL(timestep, mach, 0, 1000, "0", "|u|/c0 of the fastest particle"),
    THEORY_REAL(timestep, approach, 0, 1000, "0", "h max |pi|/c0"),
    THEORY_REAL(timestep, load, 0, 1000, "0.0025", "h max |a|/c0^2, e.g. (h/H) g H/c0^2"),
    THEORY_REAL(timestep, cfl_diffusive, PARAM_ABOVE_0, 10, "0.44",
                "P's number for the Gaussian with frozen diffusion"),
    THEORY_REAL(timestep, cfl_acoustic, PARAM_ABOVE_0, 10, "2.2",
                "P's number for the Gaussian and RK4"),
    THEORY_INT(timestep, dimensions, 1, 3, "2", "n of the viscosity"),
    THEORY_REAL(timestep, from, PARAM_ABOVE_0, 100, "0.02", "least delta"),
    THEORY_REAL(timestep, to, PARAM_ABOVE_0, 100, "1", "largest delta"),
    THEORY_POINTS(timestep),
};
static const struct theory_column columns[] = {
    {.key = "delta", .unit = "1", .label = "δ", .help = "coefficient of the diffusion"},
    {.key = "diffusion",
     .unit = "h/c0",
     .label = "diffusion (27)",
     .axis = "c_0 Δt/h",
     .help = "bound of (27)",
     .log = true},
    {.key = "viscosity", .unit = "h/c0", .label = "viscosity (28)", .help = "bound of (28)"},
    {.key = "acceleration",
     .unit = "h/c0",
     .label = "acceleration (28)",
     .help = "the other of (28)"},
    {.key = "sound", .unit = "h/c0", .label = "sound (29)", .help = "bound of (29)"},
    {.key = "least",
     .unit = "h/c0",
     .label = "time step",
     .help = "the least of them",
     .undrawn = true},
};
enum { MEETING };
static const struct theory_value values[] = {
    [MEETING] = {"delta_meet", "1", "delta beyond which diffusion shortens the step"},
};

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct timestep *p = with;
  CHECK(p->from < p->to, ERR_USAGE, "from: found %g; allowed: less than to = %g", p->from, p->to);
  double viscosity = p->alpha > 0 ? 0.125 * (2 * p->dimensions + 4) / p->alpha : INFINITY;
  double acceleration = p->load > 0 ? 0.25 / sqrt(p->load) : INFINITY;
  double sound = p->cfl_acoustic / (1 + p->mach + p->approach);
  double others = fmin(fmin(viscosity, acceleration), sound);
  for (int i = 0; i < p->points; i++) {
    double delta = theory_between(p->from, p->to, i, p->points);
    double diffusion = p->cfl_diffusive / delta;
    TRY(THEORY_ROW(curve, delta, diffusion, isfinite(viscosity) ? viscosity : NAN,
                   isfinite(acceleration) ? acceleration : NAN, sound, fmin(diffusion, others)));
  }
  curve->value[MEETING] = p->cfl_diffusive / others;
  return OK;
}

const struct theory_topic theory_timestep = {
    .name = "timestep",
    .help = "bounds of the time step against delta (P, eqs 26-29)",
    .params_size = sizeof(struct timestep),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};

#include "sph/estimate.h"

#include <math.h>

#include "common/flow/flow.h"
#include "sph/pair/kernel.h"
#include "sph/scheme.h"
#include "sph/time/integrator.h"
#include "sph/time/timestep.h"

/* Measured on dam breaks of H/dx = 50 to 800, all diffusions alike: 28 MB and 650 bytes a particle
 * at rest, up to 1000 when it moves (lists and pages of output grow); with 12 MB to spare. Of a
 * whole run an evaluation takes a particle 0.19 to 0.33 microseconds of one processor, of which the
 * upper end is taken; more on a busy machine; twice that in double precision. */
static const double BYTES_ALONE = 40e6, BYTES_OF_PARTICLE = 1000, BYTES_OF_CELL = 4;
static const double SECONDS_OF_EVALUATION = 300e-9;
/* Threads that share an evaluation start and wait for each other a few dozen times: 5,000 particles
 * took 11 s on two threads and 16 s on one, 20,000 particles 0.55 times as long on two. */
static const double SECONDS_OF_JOINING = 0.3e-3;

static double length_of(const struct geo_lines *l) {
  double length = 0;
  for (size_t k = 0; k < l->pieces; k++) length += geo_piece_length(l, k);
  return length;
}

void sph_estimate(const struct case_file *c, const struct case_run *r, struct solver_estimate *e) {
  const struct sph_scheme *o = r->options;
  double dx = c->H / r->resolution, h = o->h_over_dx * dx;
  double wall = length_of(&c->walls) * kernel_support((enum sph_kernel)o->kernel) * h / (dx * dx);
  double cells = (c->tank.max[0] - c->tank.min[0]) * (c->tank.max[1] - c->tank.min[1]) / (dx * dx);
  struct sph_bounds bounds;
  double steps = c->end / (o->dt > 0 ? o->dt : sph_courant_at_rest(o, &bounds) * h / o->c0);
  double evaluations = steps * sph_integrators[sph_integrator_chosen(o)]->evaluations;
  e->points = case_water_area(c) / (dx * dx);
  e->unit = "particles";
  e->bytes = BYTES_ALONE + BYTES_OF_PARTICLE * (e->points + wall) + BYTES_OF_CELL * cells;
  e->seconds = evaluations * e->points * SECONDS_OF_EVALUATION;
  e->joining = evaluations * SECONDS_OF_JOINING;
  if (o->precision == SPH_PRECISION_double) e->seconds *= 2;
  const double start = c->flow->seconds ? c->flow->seconds(c, dx) : 0;
  e->shared = e->seconds / (e->seconds + start);
  e->seconds += start;
}

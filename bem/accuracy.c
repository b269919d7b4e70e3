#include "bem/accuracy.h"

#include <math.h>

#include "bem/start/basin.h"
#include "bem/start/start.h"
#include "common/flow/flow.h"

/* Calibrated (docs/accuracy.md). Columns: by the dam break, column 2 H by H, tank 5.366 H: mean
 * distance of its surface below the film from that of 140 nodes per H, at t = 6 sqrt(H/g), over H.
 * Waves: by the surface of standing waves of half a wavelength's depth and ka = 0.2 after ten
 * periods, over their amplitude; where they are shallow, eight depths count for a wavelength. Below
 * SMOOTH_NODES, where the crests of these are not smooth at their spacing any more (smooth.h), ten
 * times the error comes at once; where that is grows with the steepness. */
static const double COLUMN_NODES = 36, COLUMN_AT = 1e-4;    /* per H; the accuracy that they give */
static const double COLUMN_FINE = 2.6, COLUMN_COARSE = 3.6; /* order of more and of fewer nodes */
static const double WAVE_NODES = 52, WAVE_AT = 1e-4, WAVE_ORDER = 4.5; /* per wavelength */
static const double SMOOTH_NODES = 32, SMOOTH_AT = 1e-5, SMOOTH_ORDER = 6;
static const double STEEP = 0.2, STEEPER = 1.5; /* ka; power of what is beyond */
static const double FEWEST = 14;                /* panels of a smooth surface, and one to spare */
static const double DEPTHS = 8;
static const double STEPS = 0.03;  /* tolerance of CVODE over the accuracy */
static const double SOLVES = 1e-3; /* residual of GMRES over the accuracy */

static double wave_nodes(double accuracy) {
  return WAVE_NODES * pow(WAVE_AT / accuracy, 1 / WAVE_ORDER);
}

/* ka: of the wave. */
static double smooth_nodes(double accuracy, double ka) {
  return SMOOTH_NODES * pow(fmax(1, SMOOTH_AT / accuracy), 1 / SMOOTH_ORDER) *
         pow(fmax(1, ka / STEEP), STEEPER);
}

/* Nodes per H. */
static double resolution_for(const struct case_file *c, double accuracy) {
  if (!flow_is_wave(c->flow)) {
    const double order = accuracy < COLUMN_AT ? COLUMN_FINE : COLUMN_COARSE;
    return ceil(fmax(COLUMN_NODES * pow(COLUMN_AT / accuracy, 1 / order), bem_start_shallowest(c)));
  }
  const struct flow_scale s = c->flow->scale(c);
  const double length = fmin(s.length, DEPTHS * s.depth), ka = 2 * M_PI * s.amplitude / s.length;
  if (bem_basin_is_mapped(c) || c->n_motions > 0) return ceil(wave_nodes(accuracy) * c->H / length);
  const double fewest = FEWEST / (c->tank.max[0] - c->tank.min[0]);
  return ceil(fmax(smooth_nodes(accuracy, ka) / length, fewest) * c->H);
}

void bem_accuracy_settle(const struct case_file *c, struct case_run *r) {
  struct bem_options *o = r->options;
  if (!case_run_gives(r, "accuracy")) return;
  if (!case_run_gives(r, "resolution")) r->resolution = resolution_for(c, o->accuracy);
  if (!case_run_gives(r, "tolerance")) o->tolerance = STEPS * o->accuracy;
  if (!case_run_gives(r, "gmres")) o->gmres = SOLVES * o->accuracy;
}

void bem_accuracy_coarsen(const struct case_file *c, const struct case_run *r,
                          struct bem_options *o, struct case_run *coarser) {
  *o = *(const struct bem_options *)r->options;
  *coarser = *r;
  coarser->options = o;
  coarser->resolution = r->resolution / BEM_COARSER;
  const double error = pow(BEM_COARSER, BEM_ORDER);
  o->tolerance *= error;
  o->gmres *= error;
  o->film = fmin(BEM_COARSER * o->film, fmax(o->film, 0.99 * BEM_IMPACT * c->H));
  o->rounding *= BEM_COARSER;
  o->filter *= BEM_COARSER;
  o->smoothing *= BEM_COARSER;
}

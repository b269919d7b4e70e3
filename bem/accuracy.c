#include "bem/accuracy.h"

#include <math.h>

#include "common/flow/flow.h"

/* Calibrated (docs/accuracy.md). Columns: by the dam break, column 2 H by H, tank 5.366 H: mean
 * distance of its surface below the film from that of 140 nodes per H, at t = 6 sqrt(H/g), over H.
 * Waves: by the surface of gentle standing waves of half a wavelength's depth after ten periods,
 * over their amplitude; where they are shallow, eight depths count for a wavelength. */
static const double COLUMN_NODES = 36, COLUMN_AT = 1e-4;    /* per H; the accuracy that they give */
static const double COLUMN_FINE = 2.6, COLUMN_COARSE = 3.6; /* order of more and of fewer nodes */
static const double WAVE_NODES = 40, WAVE_AT = 1e-4, WAVE_ORDER = 4; /* per wavelength */
static const double DEPTHS = 8;
static const double STEPS = 0.03;  /* tolerance of CVODE over the accuracy */
static const double SOLVES = 1e-3; /* residual of GMRES over the accuracy */

/* Nodes per H. */
static double resolution_for(const struct case_file *c, double accuracy) {
  if (!flow_is_wave(c->flow)) {
    const double order = accuracy < COLUMN_AT ? COLUMN_FINE : COLUMN_COARSE;
    return ceil(COLUMN_NODES * pow(COLUMN_AT / accuracy, 1 / order));
  }
  const struct flow_scale s = c->flow->scale(c);
  const double length = fmin(s.length, DEPTHS * s.depth);
  return ceil(WAVE_NODES * pow(WAVE_AT / accuracy, 1 / WAVE_ORDER) * c->H / length);
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

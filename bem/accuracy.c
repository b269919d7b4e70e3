#include "bem/accuracy.h"

#include <math.h>

#include "common/flow/flow.h"

/* Calibrated (docs/accuracy.md): bodies by the mean distance of the dam break's surface from the
 * finest run's at t = 6 sqrt(H/g), relative to H; waves by the frequency and the energy of standing
 * waves and the shape of steep ones. */
static const double COLUMN_NODES = 34, COLUMN_AT = 1e-4; /* per H; the accuracy that they give */
static const double WAVE_NODES = 30, WAVE_AT = 1e-4;     /* per wavelength */
static const double WAVE_ORDER = 4;
static const double STEPS = 0.01;     /* tolerance of CVODE over the accuracy */
static const double SOLVES = 1e-3;    /* residual of GMRES over the accuracy */
static const double FILTER_AT = 3e-5; /* accuracy that the usual rates of filters are good for */

/* Nodes per H. */
static double resolution_for(const struct case_file *c, double accuracy) {
  if (!flow_is_wave(c->flow)) return ceil(COLUMN_NODES * pow(COLUMN_AT / accuracy, 1 / BEM_ORDER));
  const struct flow_scale s = c->flow->scale(c);
  return ceil(WAVE_NODES * pow(WAVE_AT / accuracy, 1 / WAVE_ORDER) * c->H / s.length);
}

void bem_accuracy_settle(const struct case_file *c, struct case_run *r) {
  struct bem_options *o = r->options;
  if (!case_run_gives(r, "accuracy")) return;
  if (!case_run_gives(r, "resolution")) r->resolution = resolution_for(c, o->accuracy);
  if (!case_run_gives(r, "tolerance")) o->tolerance = STEPS * o->accuracy;
  if (!case_run_gives(r, "gmres")) o->gmres = SOLVES * o->accuracy;
  const double calm = fmin(1, sqrt(o->accuracy / FILTER_AT));
  if (!case_run_gives(r, "filter")) o->filter *= calm;
  if (!case_run_gives(r, "smoothing")) o->smoothing *= calm;
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
  o->filter *= BEM_COARSER;
  o->smoothing *= BEM_COARSER;
}

/* Water at rest, at t = 0, under a pressure more than its weight,
 *     rho g q cos(k x) exp(Y/l),
 * Y the height above the surface: not what any surface bears. It does not grow everywhere and for
 * ever, as a wave of this form would by itself, at the rate w with
 *     w^2 = c^2 (1/l^2 - k^2) - g/l
 * (thesis, eq. (2.176)), but what is large at the surface travels down: that is over when sound
 * has come from there. */
#include <math.h>
#include <stdlib.h>

#include "common/flow/round.h"

struct form {
  double strength, wavelength, depth, decay; /* m */
};

static const struct param rows[] = {
    FLOW_LENGTH(struct form, strength, PARAM_ABOVE_0,
                "q, of the pressure at the surface over rho g"),
    FLOW_LENGTH(struct form, wavelength, PARAM_ABOVE_0, "wavelength along the surface"),
    FLOW_LENGTH(struct form, depth, PARAM_ABOVE_0, "depth of the water at rest"),
    FLOW_LENGTH(struct form, decay, PARAM_ABOVE_0, "depth in which it falls by a factor e"),
};

static struct flow_scale scale(const struct case_file *c) {
  const struct form *f = c->form;
  return (struct flow_scale){f->depth, f->depth, 0, f->wavelength};
}

static void check(const struct case_file *c, struct case_draft *d) {
  const struct form *f = c->form;
  wave_round_check(c, d, f->wavelength);
}

static double elevation(const struct flow_water *w, double x, double t) {
  const struct form *f = w->c->form;
  (void)x, (void)t;
  return w->c->tank.min[1] + f->depth;
}

static double potential(const struct flow_water *w, double x, double y, double t) {
  (void)w, (void)x, (void)y, (void)t;
  return 0;
}

static void velocity(const struct flow_water *w, double x, double y, double t, double out[2]) {
  (void)w, (void)x, (void)y, (void)t;
  out[0] = out[1] = 0;
}

static void start(const struct flow_water *w, double X, double Y, struct flow_start *out) {
  const struct form *f = w->c->form;
  const double depth = elevation(w, X, 0) - Y;
  const double more = f->strength * cos(2 * M_PI / f->wavelength * (X - w->c->tank.min[0])) *
                      exp(-depth / f->decay);
  const double rest = wave_round_head(w, depth, 0);
  *out = (struct flow_start){.x = X, .y = Y, .head = rest + more, .rest = rest};
}

const struct flow flow_pressed = {
    .params = rows,
    .n_params = sizeof rows / sizeof *rows,
    .params_size = sizeof(struct form),
    .example = "wave: {kind: pressed, strength: 0.001, wavelength: 4, depth: 1, decay: 0.2}",
    .check = check,
    .scale = scale,
    .round = true,
    .sounds = true,
    .at_rest = true,
    .elevation = elevation,
    .potential = potential,
    .velocity = velocity,
    .start = start,
};

/* Acoustic modes of water between its surface and the bed (modes.h), which run to the right. */
#include <stdlib.h>

#include "common/flow/round.h"

struct form {
  double amplitude, wavelength, depth; /* m */
  int number;
};

static const struct param rows[] = {
    FLOW_LENGTH(struct form, amplitude, PARAM_ABOVE_0,
                "height of the crest above the water at rest"),
    FLOW_LENGTH(struct form, wavelength, PARAM_ABOVE_0, "wavelength along the surface"),
    FLOW_LENGTH(struct form, depth, PARAM_ABOVE_0, "depth of the water at rest"),
    {.key = "number",
     .type = PARAM_INT,
     .offset = offsetof(struct form, number),
     .min = 0,
     .max = 1000,
     .value = "0",
     .help = "of the mode: about 2 number + 1 quarter waves between surface and bed"},
};

static struct flow_scale scale(const struct case_file *c) {
  const struct form *f = c->form;
  return (struct flow_scale){f->depth, f->depth, f->amplitude, f->wavelength};
}

static void check(const struct case_file *c, struct case_draft *d) {
  const struct form *f = c->form;
  wave_round_check(c, d, f->wavelength);
}

static enum status create(struct flow_water *w) {
  const struct form *f = w->c->form;
  struct wave_mode *m = w->own = malloc(sizeof *m);
  CHECK(m, ERR_MEMORY, "no memory for an acoustic mode");
  const struct wave_column in = {.gravity = w->c->gravity,
                                 .sound = w->use.sound > 0 ? w->use.sound : 1, /* see `sounds` */
                                 .depth = f->depth,
                                 .wavenumber = 2 * M_PI / f->wavelength};
  *m = wave_mode_acoustic(&in, f->number);
  return OK;
}

static void destroy(struct flow_water *w) {
  free(w->own);
}

static struct wave_motion motion(const struct flow_water *w, double x, double y, double t) {
  const struct form *f = w->c->form;
  return wave_round_motion(w, w->own, f->amplitude, x, y, t);
}

static double elevation(const struct flow_water *w, double x, double t) {
  const struct form *f = w->c->form;
  const double level = w->c->tank.min[1] + f->depth;
  return level + motion(w, x, level, t).zeta;
}

static double potential(const struct flow_water *w, double x, double y, double t) {
  return motion(w, x, y, t).potential;
}

static void velocity(const struct flow_water *w, double x, double y, double t, double out[2]) {
  const struct wave_motion m = motion(w, x, y, t);
  out[0] = m.u;
  out[1] = m.v;
}

static void start(const struct flow_water *w, double X, double Y, struct flow_start *out) {
  const struct form *f = w->c->form;
  wave_round_start(w, w->own, f->amplitude, X, Y, out);
}

const struct flow flow_acoustic = {
    .params = rows,
    .n_params = sizeof rows / sizeof *rows,
    .params_size = sizeof(struct form),
    .example = "wave: {kind: acoustic, amplitude: 0.0001, wavelength: 4, depth: 1, number: 2}",
    .check = check,
    .create = create,
    .destroy = destroy,
    .scale = scale,
    .round = true,
    .sounds = true,
    .elevation = elevation,
    .potential = potential,
    .velocity = velocity,
    .start = start,
};

/* Standing waves at rest at their highest, as theory (waves.h) has them. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "common/case/case.h"
#include "common/flow/flow.h"
#include "common/flow/waves.h"

struct form {
  double amplitude, wavelength, depth; /* m */
  int order;
};

static const struct param rows[] = {
    FLOW_LENGTH(struct form, amplitude, PARAM_ABOVE_0,
                "of the cosine: height of the crest above the water at rest, at order 1"),
    FLOW_LENGTH(struct form, wavelength, PARAM_ABOVE_0, "wavelength"),
    FLOW_LENGTH(struct form, depth, PARAM_ABOVE_0, "depth of the water at rest"),
    {.key = "order",
     .type = PARAM_INT,
     .offset = offsetof(struct form, order),
     .min = 1,
     .max = 2,
     .value = "1",
     .help = "of its shape: 1 a cosine, which sets free waves of half its length going; 2 with the "
             "second harmonic of a wave that repeats itself"},
};

/* As a run of `exact` asks, or of its own shape's. */
static struct wave_standing theory_of(const struct case_file *c, int order) {
  const struct form *f = c->form;
  struct wave_standing w =
      wave_standing_create(f->amplitude, f->wavelength, f->depth, c->gravity > 0 ? c->gravity : 1,
                           c->tank.min[0], c->tank.min[1], f->order > order ? f->order : order);
  if (f->order > 1) wave_standing_bind(&w);
  return w;
}

static struct flow_scale scale(const struct case_file *c) {
  const struct form *f = c->form;
  const struct wave_standing w = theory_of(c, 0);
  return (struct flow_scale){f->depth, f->depth, f->amplitude + w.bound_mean + w.bound,
                             f->wavelength};
}

/* Mercer & Roberts (Phys. Fluids A 4, 1992): the steepest standing wave in deep water is 0.2
 * wavelengths high, trough to crest. */
static void check(const struct case_file *c, struct case_draft *d) {
  const struct form *w = c->form;
  double steepest = fmin(0.1 * w->wavelength, 0.5 * w->depth);
  double halves = 2 * (c->tank.max[0] - c->tank.min[0]) / w->wavelength;
  char found[96], allowed[128];
  if (w->amplitude > steepest) {
    snprintf(found, sizeof found, "an amplitude of %.6g m", w->amplitude);
    snprintf(allowed, sizeof allowed,
             "up to a tenth of the wavelength and half the depth, here %.6g m", steepest);
    case_flow_problem(d, "amplitude", found, allowed, "a steeper standing wave breaks at once");
  }
  if (!c->rectangular) return;
  double least = c->periodic[0] ? 2 : 1, parts = halves / least;
  if (fabs(parts - round(parts)) > 1e-6 * parts || parts < 0.5) {
    snprintf(found, sizeof found, "%.6g %swavelengths between the %s", parts,
             c->periodic[0] ? "" : "half ", c->periodic[0] ? "periodic sides" : "walls");
    case_flow_problem(d, "wavelength", found, "a whole number of them",
                      "change the wavelength or the tank's length");
  }
}

/* ---- the wave, at any time ---- */

struct wave {
  struct wave_standing theory;
  double width; /* of the tank, m */
};

static enum status create(struct flow_water *w) {
  const struct geo_box *tank = &w->c->tank;
  struct wave *wave = w->own = malloc(sizeof *wave);
  CHECK(wave, ERR_MEMORY, "no memory for a standing wave");
  wave->theory = theory_of(w->c, w->use.order);
  wave->width = tank->max[0] - tank->min[0];
  return OK;
}

static void destroy(struct flow_water *w) {
  free(w->own);
}

static const struct wave_standing *theory(const struct flow_water *w) {
  const struct wave *wave = w->own;
  return &wave->theory;
}

static double elevation(const struct flow_water *w, double x, double t) {
  return wave_standing_elevation(theory(w), x, t);
}

static double potential(const struct flow_water *w, double x, double y, double t) {
  return wave_standing_potential(theory(w), x, y, t);
}

static void velocity(const struct flow_water *w, double x, double y, double t, double out[2]) {
  wave_standing_velocity(theory(w), x, y, t, out);
}

static double pressure(const struct flow_water *w, double x, double y, double t) {
  return wave_standing_pressure(theory(w), x, y, t);
}

/* cosh kY/cosh kd. */
static double decay(double k, double d, double Y) {
  return exp(k * (Y - d)) * (1 + exp(-2 * k * Y)) / (1 + exp(-2 * k * d));
}

/* That of linear waves, stretched with the column so that it vanishes on the surface:
 * depth - eta (1 - cosh(k Y)/cosh(k d)), Y the height above the bed in still water. */
static enum status head(const struct flow_water *w, const struct flow_point *p, double *out) {
  const struct wave_standing *s = theory(w);
  double k = s->k, d = s->depth, Y = p->rest - s->bed;
  double eta = s->amplitude * cos(k * (p->x - s->left));
  *out = d + eta - (p->y - s->bed) - eta * (1 - decay(k, d, Y));
  if (s->bound_alone) {
    double second = (s->bound_mean + s->bound) * cos(2 * k * (p->x - s->left));
    *out += second * decay(2 * k, d, Y);
  }
  return OK;
}

static double kinetic(const struct flow_water *w, double t) {
  const struct wave *wave = w->own;
  return wave_standing_kinetic(&wave->theory, wave->width, t);
}

static double potential_energy(const struct flow_water *w, double t) {
  const struct wave *wave = w->own;
  return wave_standing_potential_energy(&wave->theory, wave->width, t);
}

static double error(const struct flow_water *w, double end) {
  return wave_standing_error(theory(w), end);
}

const struct flow flow_standing = {
    .params = rows,
    .n_params = sizeof rows / sizeof *rows,
    .params_size = sizeof(struct form),
    .example = "wave: {kind: standing, amplitude: 0.05, wavelength: 4, depth: 1}",
    .check = check,
    .create = create,
    .destroy = destroy,
    .scale = scale,
    .elevation = elevation,
    .at_rest = true,
    .potential = potential,
    .velocity = velocity,
    .head = head,
    .pressure = pressure,
    .kinetic = kinetic,
    .potential_energy = potential_energy,
    .error = error,
};

/* Standing waves at rest at their highest, as theory (waves.h) has them. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "common/case/case.h"
#include "common/flow/flow.h"
#include "common/flow/waves.h"

struct form {
  double amplitude, wavelength, depth; /* m */
};

#define LENGTH(member, text)                                                                       \
  {                                                                                                \
    .key = #member, .type = PARAM_REAL, .quantity = QTY_LENGTH,                                    \
    .offset = offsetof(struct form, member), .min = PARAM_ABOVE_0, .max = 1e6, .help = text        \
  }
static const struct param rows[] = {
    LENGTH(amplitude, "height of the crest above the water at rest"),
    LENGTH(wavelength, "wavelength"),
    LENGTH(depth, "depth of the water at rest"),
};

static struct flow_scale scale(const struct case_file *c) {
  const struct form *w = c->form;
  return (struct flow_scale){w->depth, w->depth, w->amplitude, w->wavelength};
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
  if (fabs(halves - round(halves)) > 1e-6 * halves || halves < 0.5) {
    snprintf(found, sizeof found, "%.6g half wavelengths between the walls", halves);
    case_flow_problem(d, "wavelength", found, "a whole number of them",
                      "change the wavelength or the tank's length");
  }
}

static double wavenumber(const struct form *w) {
  return 2 * M_PI / w->wavelength;
}

/* Above the water at rest, m. */
static double rise(const struct case_file *c, double x) {
  const struct form *w = c->form;
  return w->amplitude * cos(wavenumber(w) * (x - c->tank.min[0]));
}

static double elevation(const struct case_file *c, double x) {
  const struct form *w = c->form;
  return c->tank.min[1] + w->depth + rise(c, x);
}

/* That of the linear wave, stretched with the column so that it vanishes on the surface:
 * depth - eta (1 - cosh(k Y)/cosh(k d)), Y the height above the bed in still water. */
static enum status head(const struct case_file *c, void *prepared, const struct flow_point *p,
                        double *out) {
  const struct form *w = c->form;
  double bed = c->tank.min[1], k = wavenumber(w), d = w->depth, Y = p->rest - bed;
  double eta = rise(c, p->x);
  double decay = exp(k * (Y - d)) * (1 + exp(-2 * k * Y)) / (1 + exp(-2 * k * d));
  (void)prepared;
  *out = d + eta - (p->y - bed) - eta * (1 - decay);
  return OK;
}

/* ---- what follows ---- */

struct theory {
  struct wave_standing wave;
  double width; /* of the tank, m */
};

static void *theory_create(const struct case_file *c, int order) {
  const struct form *w = c->form;
  struct theory *t = malloc(sizeof *t);
  if (!t) return NULL;
  t->wave = wave_standing_create(w->amplitude, w->wavelength, w->depth, c->gravity, c->tank.min[0],
                                 c->tank.min[1], order);
  t->width = c->tank.max[0] - c->tank.min[0];
  return t;
}

static double theory_elevation(const void *theory, double x, double t) {
  return wave_standing_elevation(theory, x, t);
}

static double theory_potential(const void *theory, double x, double y, double t) {
  return wave_standing_potential(theory, x, y, t);
}

static void theory_velocity(const void *theory, double x, double y, double t, double velocity[2]) {
  wave_standing_velocity(theory, x, y, t, velocity);
}

static double theory_pressure(const void *theory, double x, double y, double t) {
  return wave_standing_pressure(theory, x, y, t);
}

static double theory_kinetic(const void *theory, double t) {
  const struct theory *w = theory;
  return wave_standing_kinetic(&w->wave, w->width, t);
}

static double theory_potential_energy(const void *theory, double t) {
  const struct theory *w = theory;
  return wave_standing_potential_energy(&w->wave, w->width, t);
}

static double theory_error(const void *theory, double end) {
  return wave_standing_error(theory, end);
}

static const struct flow_theory theory = {
    .create = theory_create,
    .elevation = theory_elevation,
    .potential = theory_potential,
    .velocity = theory_velocity,
    .pressure = theory_pressure,
    .kinetic = theory_kinetic,
    .potential_energy = theory_potential_energy,
    .error = theory_error,
};

const struct flow flow_standing = {
    .params = rows,
    .n_params = sizeof rows / sizeof *rows,
    .params_size = sizeof(struct form),
    .example = "wave: {kind: standing, amplitude: 0.05, wavelength: 4, depth: 1}",
    .check = check,
    .scale = scale,
    .elevation = elevation,
    .head = head,
    .theory = &theory,
};

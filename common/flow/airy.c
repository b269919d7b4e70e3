/* Small gravity waves that run to the right: linear theory of incompressible water (Airy 1841),
 *     phi = (a omega/k) P(Y) sin theta, eta = a cos theta, theta = k x - omega t,
 * with P = cosh k(Y + d)/sinh kd on a bed at Y = -d, exp kY in deep water, omega^2 = g k tanh kd or
 * g k. The deep water's profile may be asked for in a tank, too: its flow goes through the bed by
 * a omega exp(-kd), from which water on a bed then starts with a shock (thesis, 2.4.3). */
#include <math.h>
#include <stdlib.h>

#include "common/flow/round.h"

struct form {
  double amplitude, wavelength, depth; /* m */
  int profile;
};

enum { PROFILE_FINITE, PROFILE_DEEP };
static const char *const profile_names[] = {"finite", "deep", NULL};
static const char *const profile_helps[] = {
    "cosh k(Y + d)/sinh kd, Y the height above the water at rest and d the depth",
    "exp kY, that of water without a bed, which flows through it"};

static const struct param rows[] = {
    FLOW_LENGTH(struct form, amplitude, PARAM_ABOVE_0,
                "height of the crest above the water at rest"),
    FLOW_LENGTH(struct form, wavelength, PARAM_ABOVE_0, "wavelength"),
    FLOW_LENGTH(struct form, depth, PARAM_ABOVE_0, "depth of the water at rest"),
    {.key = "profile",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct form, profile),
     .choices = profile_names,
     .value = "finite",
     .help = "how its velocities fall with the depth",
     .helps = profile_helps},
};

static struct flow_scale scale(const struct case_file *c) {
  const struct form *f = c->form;
  return (struct flow_scale){f->depth, f->depth, f->amplitude, f->wavelength};
}

/* Steeper than this a wave of permanent form breaks: 0.142 wavelengths high in deep water (Michell
 * 1893), 0.83 of the depth in shallow. */
static void check(const struct case_file *c, struct case_draft *d) {
  const struct form *f = c->form;
  const double steepest = fmin(0.07 * f->wavelength, 0.4 * f->depth);
  char found[96], allowed[128];
  wave_round_check(c, d, f->wavelength);
  if (f->amplitude <= steepest) return;
  snprintf(found, sizeof found, "an amplitude of %.6g m", f->amplitude);
  snprintf(allowed, sizeof allowed, "up to 0.07 wavelengths and 0.4 depths, here %.6g m", steepest);
  case_flow_problem(d, "amplitude", found, allowed, "a steeper wave breaks");
}

/* ---- the wave, at any time ---- */

struct wave {
  double k, omega, top; /* rad/m, rad/s; y of the water at rest, m */
};

static enum status create(struct flow_water *w) {
  const struct form *f = w->c->form;
  struct wave *wave = w->own = malloc(sizeof *wave);
  CHECK(wave, ERR_MEMORY, "no memory for an Airy wave");
  const double k = 2 * M_PI / f->wavelength,
               slope = f->profile == PROFILE_DEEP ? 1 : tanh(k * f->depth);
  *wave = (struct wave){k, sqrt(w->c->gravity * k * slope), w->c->tank.min[1] + f->depth};
  return OK;
}

static void destroy(struct flow_water *w) {
  free(w->own);
}

static double phase(const struct flow_water *w, double x, double t) {
  const struct wave *wave = w->own;
  return wave->k * (x - w->c->tank.min[0]) - wave->omega * t;
}

/* The profile of the velocity along the surface, and that across, which is 1 at Y = 0. */
static void profile(const struct flow_water *w, double y, double *along, double *across) {
  const struct wave *wave = w->own;
  const struct form *f = w->c->form;
  const double Y = y - wave->top, up = exp(wave->k * Y);
  *along = *across = up;
  if (f->profile == PROFILE_DEEP) return;
  const double down = exp(-wave->k * (Y + 2 * f->depth)),
               scale = -1 / expm1(-2 * wave->k * f->depth);
  *along = (up + down) * scale;
  *across = (up - down) * scale;
}

static double elevation(const struct flow_water *w, double x, double t) {
  const struct wave *wave = w->own;
  const struct form *f = w->c->form;
  return wave->top + f->amplitude * cos(phase(w, x, t));
}

static double potential(const struct flow_water *w, double x, double y, double t) {
  const struct wave *wave = w->own;
  const struct form *f = w->c->form;
  double along, across;
  profile(w, y, &along, &across);
  return f->amplitude * wave->omega / wave->k * along * sin(phase(w, x, t));
}

static void velocity(const struct flow_water *w, double x, double y, double t, double out[2]) {
  const struct wave *wave = w->own;
  const struct form *f = w->c->form;
  double along, across;
  profile(w, y, &along, &across);
  out[0] = f->amplitude * wave->omega * along * cos(phase(w, x, t));
  out[1] = f->amplitude * wave->omega * across * sin(phase(w, x, t));
}

/* Over density, less the weight of the water at rest. */
static double push(const struct flow_water *w, double x, double y, double t) {
  const struct wave *wave = w->own;
  const struct form *f = w->c->form;
  double along, across;
  profile(w, y, &along, &across);
  return f->amplitude * wave->omega * wave->omega / wave->k * along * cos(phase(w, x, t));
}

static double pressure(const struct flow_water *w, double x, double y, double t) {
  const struct wave *wave = w->own;
  if (y > elevation(w, x, t)) return 0;
  return push(w, x, y, t) + w->c->gravity * (wave->top - y);
}

/* The pressure of a column that is stretched with the surface: that of linear theory, which on the
 * surface is zero. */
static enum status head(const struct flow_water *w, const struct flow_point *p, double *out) {
  const struct wave *wave = w->own;
  const double eta = elevation(w, p->x, 0) - wave->top;
  const double surface = push(w, p->x, wave->top, 0), here = push(w, p->x, p->rest, 0);
  *out = wave->top + eta - p->y - eta * (1 - here / (surface != 0 ? surface : 1));
  return OK;
}

static void start(const struct flow_water *w, double X, double Y, struct flow_start *out) {
  const struct wave *wave = w->own;
  const struct form *f = w->c->form;
  const double theta = phase(w, X, 0);
  double along, across, u[2];
  profile(w, Y, &along, &across);
  velocity(w, X, Y, 0, u);
  const double zeta = f->amplitude * across * cos(theta);
  *out = (struct flow_start){.x = X - f->amplitude * along * sin(theta),
                             .y = Y + zeta,
                             .u = u[0],
                             .v = u[1],
                             .head = wave_round_head(w, wave->top - Y - zeta, push(w, X, Y, 0)),
                             .rest = wave_round_head(w, wave->top - Y, 0)};
}

/* Linear waves have as much of both: g a^2/4 for each metre. */
static double kinetic(const struct flow_water *w, double t) {
  (void)t;
  const struct form *f = w->c->form;
  return w->c->gravity * f->amplitude * f->amplitude / 4 * (w->c->tank.max[0] - w->c->tank.min[0]);
}

static double potential_energy(const struct flow_water *w, double t) {
  const struct wave *wave = w->own;
  const double bed = w->c->tank.min[1], width = w->c->tank.max[0] - w->c->tank.min[0];
  return kinetic(w, t) + w->c->gravity * width / 2 * (wave->top * wave->top - bed * bed);
}

/* The second harmonic over the first: Stokes' k a (3 - T^2)/(4 T^3), T = tanh kd; and what the deep
 * profile does to a bed. */
static double error(const struct flow_water *w, double end) {
  (void)end;
  const struct wave *wave = w->own;
  const struct form *f = w->c->form;
  const double T = tanh(wave->k * f->depth);
  const double through = f->profile == PROFILE_DEEP ? exp(-wave->k * f->depth) : 0;
  return fmax(wave->k * f->amplitude * (3 - T * T) / (4 * T * T * T), through);
}

const struct flow flow_airy = {
    .params = rows,
    .n_params = sizeof rows / sizeof *rows,
    .params_size = sizeof(struct form),
    .example = "wave: {kind: airy, amplitude: 0.02, wavelength: 4, depth: 1}",
    .check = check,
    .create = create,
    .destroy = destroy,
    .scale = scale,
    .round = true,
    .elevation = elevation,
    .potential = potential,
    .velocity = velocity,
    .head = head,
    .start = start,
    .pressure = pressure,
    .kinetic = kinetic,
    .potential_energy = potential_energy,
    .error = error,
};
